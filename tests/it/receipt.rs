//! A build that would change nothing recognises that, and is never wrong about it.

use crate::course::{Course, accepted, small};

/// Builds, and whether the receipt of the last build was enough.
fn by_receipt(course: &Course, arguments: &[&str]) -> bool {
    let arguments: Vec<&str> = ["build", "--timings"].iter().chain(arguments).copied().collect();
    let said = course.fine(&arguments);
    assert!(said.err.contains("ms  in all"), "{}", said.err);
    !said.err.contains("ms  render")
}

#[test]
fn the_second_build_of_the_same_does_no_work_and_says_the_same() {
    let course = small();
    assert!(!by_receipt(&course, &[]));
    let book = course.book();
    assert!(by_receipt(&course, &[]));
    assert_eq!(course.book(), book);
    // Without a lock nothing is said of drift; with one of another course it is, each time.
    course.fine(&["accept", "--quiet"]);
    course.edit("chapters/01-one.md", "n = 16\n", "n = 64\n");
    let first = course.fine(&["build", "--format", "json"]);
    assert!(first.out.contains("W0203"), "{}", first.out);
    assert_eq!(course.fine(&["build", "--format", "json"]).out, first.out);
    let told = course.fine(&["build"]).err;
    assert!(told.contains("nothing changed in") && told.contains("01-one.md:8:1"), "{told}");
}

#[test]
fn whatever_changes_is_seen() {
    let course = accepted();
    assert!(!by_receipt(&course, &[]) && by_receipt(&course, &[]), "accepting changed the lock");
    let changes: [(&str, &dyn Fn()); 7] = [
        ("prose", &|| course.edit("chapters/01-one.md", "Some prose.", "Other prose.")),
        ("a template", &|| course.write("templates/listing.html", "")),
        ("a file beside the chapters", &|| course.write("chapters/data.bin", [0, 1])),
        ("the lock", &|| course.write("book/workbook.lock", course.read("book/workbook.lock") + "\n")),
        ("a page", &|| course.write("book/index.html", "")),
        ("a file of the book that is gone", &|| std::fs::remove_file(course.path("book/kinds.html")).unwrap()),
        ("a file that is not the book's", &|| course.write("book/own.html", "")),
    ];
    for (what, change) in changes {
        let last = course.path("book");
        change();
        assert!(last.is_dir() && !by_receipt(&course, &[]), "{what}");
        assert!(by_receipt(&course, &[]), "after {what}");
    }
    assert!(!course.path("book/own.html").exists() && course.path("book/data.bin").exists());
}

#[test]
fn a_receipt_that_is_damaged_or_not_wanted_counts_for_nothing() {
    let course = accepted();
    course.fine(&["build"]);
    assert!(by_receipt(&course, &[]) && !by_receipt(&course, &["--no-cache"]));
    let receipt = course.read(".workbook/receipt");
    let wrong = receipt.replace("\"chapters\":1", "\"chapters\":2");
    assert_ne!(wrong, receipt);
    for damaged in [wrong.as_str(), "", "\n", &receipt[..receipt.len() / 2]] {
        course.write(".workbook/receipt", damaged);
        assert!(!by_receipt(&course, &[]), "{damaged}");
        assert!(by_receipt(&course, &[]));
    }
    course.fine(&["clean", "--quiet"]);
    assert!(!by_receipt(&course, &[]));
    assert!(!by_receipt(&course, &["--out", "elsewhere"]) && by_receipt(&course, &["--out", "elsewhere"]));
}

#[test]
fn a_course_that_is_wrong_leaves_no_receipt() {
    let course = accepted();
    course.fine(&["build"]);
    course.edit("chapters/01-one.md", "equals = 1", "equals = 2");
    for _ in 0..2 {
        let said = course.say(&["build", "--timings"]);
        assert!(said.exit == 1 && said.err.contains("W0202"), "{}", said.err);
    }
    course.edit("chapters/01-one.md", "equals = 2", "equals = 1");
    assert!(by_receipt(&course, &[]), "the book is as it was");
}
