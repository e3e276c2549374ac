//! What an author starts from: the course that `init` writes, and the chapters that `new` adds.

use std::path::Path;

use crate::course::{Course, small, tree};

/// A folder with the course of `init` in it.
fn started() -> Course {
    let course = Course::empty();
    course.fine(&["init", ".", "--quiet"]).silent();
    course
}

#[test]
fn the_new_course_builds_at_once_and_verifies() {
    let course = Course::empty();
    let said = course.fine(&["init", "points", "--title", "Points", "--author", "A. Author"]);
    assert!(said.err.contains("next: cd points && workbook build") && said.err.contains("accept"), "{}", said.err);
    for path in [".gitignore", ".github/workflows/book.yml", "README.md", "chapters/workbook.toml"] {
        assert!(course.path("points").join(path).is_file(), "{path}");
    }
    for audience in ["instructor", "student"] {
        let said = course.fine(&["check", "--root", "points", "--audience", audience]);
        assert!(!said.err.contains("warning"), "{}", said.err);
    }
    let said = course.fine(&["build", "--root", "points"]);
    assert!(said.err.contains("2 chapters, 5 exhibits (5 of 5 experiments ran), 5 claims verified"), "{}", said.err);
    let said = course.say(&["verify", "--root", "points"]);
    assert!(said.exit == 1 && said.err.contains("`workbook accept` writes it"), "{}", said.err);
    course.fine(&["accept", "--root", "points", "--quiet"]);
    course.fine(&["verify", "--root", "points", "--quiet"]).silent();
    let landing = course.read("points/book/index.html");
    assert!(landing.contains("Points") && landing.contains("A. Author"));
}

#[test]
fn init_replaces_nothing() {
    let course = Course::new(&[("README.md", "mine")]);
    let before = tree(course.root());
    let said = course.say(&["init", "."]);
    assert!(said.exit == 2 && said.err.contains("error[W0012]: `README.md` is in `.` already"), "{}", said.err);
    assert!(tree(course.root()) == before, "nothing else was written either");
    // A file where a folder should be.
    let said = course.say(&["init", "README.md/course"]);
    assert!(said.exit == 3 && said.err.contains("cannot be written"), "{}", said.err);
    assert!(tree(course.root()) == before);
    let again = started();
    assert!(again.say(&["init", "."]).err.contains("`chapters/workbook.toml`"));
}

#[test]
fn a_new_chapter_stands_at_the_end_and_builds() {
    let course = started();
    let said = course.fine(&["new", "Points on a \"line\""]);
    let path = "chapters/03-points-on-a-line.md";
    assert!(said.err.contains(&format!("wrote {path}")), "{}", said.err);
    let order: toml::Table = course.read("chapters/workbook.toml").parse().unwrap();
    let order: Vec<&str> = order["order"].as_array().unwrap().iter().filter_map(toml::Value::as_str).collect();
    assert_eq!(order, ["01-estimate", "02-cells", "03-points-on-a-line"]);
    assert!(course.read("chapters/workbook.toml").contains("# Each chapter by its file's name"), "comments stay");
    let said = course.fine(&["build"]);
    assert!(said.err.contains("3 chapters, 6 exhibits") && !said.err.contains("warning"), "{}", said.err);
    assert!(course.read("book/points-on-a-line.html").contains("Points on a &quot;line&quot;"));
    for part in ["[!GOALS]", "[!REMEMBER]", "[!EXERCISE]", "## A section"] {
        assert!(course.read(path).contains(part), "{part}");
    }
}

#[test]
fn a_new_chapter_replaces_nothing() {
    let course = started();
    let before = tree(course.root());
    let told = |title: &str, words: &str| {
        let said = course.say(&["new", title]);
        assert!(said.exit == 2 && said.err.contains(words), "{title}: {}", said.err);
        assert!(tree(course.root()) == before, "{title}: nothing was written");
    };
    told("Cells", "which is that of `chapters/02-cells.md`");
    told("Exhibits", "which is that of the book itself");
    told("积分", "gives a page no name");
    assert_eq!(course.say(&["new", "Lost", "--root", "nowhere"]).exit, 2);
    course.edit("chapters/workbook.toml", "order = [", "order = [[");
    let broken = tree(course.root());
    let said = course.say(&["new", "Third"]);
    assert!(said.exit == 1 && said.err.contains("W0101"), "{}", said.err);
    assert!(tree(course.root()) == broken, "a configuration that cannot be read is not edited");
}

#[test]
fn ids_of_a_new_chapter_are_its_own() {
    let course = small();
    let configuration = course.read("chapters/workbook.toml");
    course.fine(&["new", "Points", "--quiet"]).silent();
    assert_eq!(course.read("chapters/workbook.toml"), configuration, "it lists no chapters");
    assert!(course.read("chapters/02-points.md").contains("id = \"fig-points-2\""));
    course.fine(&["build", "--quiet"]).silent();
    assert!(Path::new(&course.path("book/points.html")).is_file());
}
