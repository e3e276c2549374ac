//! The same inputs give the same bytes: whatever the threads, the folder, the locale, the time zone and what was built before.

use std::collections::BTreeMap;
use std::fs;

use crate::course::{Course, tree};

type Tree = BTreeMap<String, Vec<u8>>;

/// A course that uses every construct and every kind.
fn course() -> Course {
    Course::case("everything")
}

/// Fails with the names of the files that differ, not with their bytes.
fn same(left: &Tree, right: &Tree) {
    let names = |tree: &Tree| tree.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(left), names(right));
    let differ: Vec<_> = left.iter().filter(|(path, bytes)| right[*path] != **bytes).map(|(path, _)| path).collect();
    assert!(differ.is_empty(), "these differ: {differ:?}");
}

fn built(arguments: &[&str]) -> (Course, Tree) {
    let course = course();
    course.fine(&[&["build", "--quiet"], arguments].concat());
    let book = course.book();
    assert!(book.contains_key("index.html") && book.len() > 10);
    (course, book)
}

#[test]
fn the_number_of_threads_does_not_show() {
    let (_, one) = built(&["--jobs", "1"]);
    for jobs in ["2", "4", "16"] {
        same(&one, &built(&["--jobs", jobs]).1);
    }
}

#[test]
fn the_folder_the_locale_and_the_time_zone_do_not_show() {
    let (_, here) = built(&[]);
    let course = course();
    let far = course.path("a folder/with spaces & ünïcode");
    for (path, bytes) in tree(&course.path("chapters")) {
        course.write(&format!("a folder/with spaces & ünïcode/chapters/{path}"), bytes);
    }
    let environment = [
        ("LANG", "tr_TR.UTF-8"),
        ("LC_ALL", "de_DE.UTF-8"),
        ("LC_NUMERIC", "de_DE.UTF-8"),
        ("TZ", "Pacific/Kiritimati"),
        ("HOME", "/nowhere"),
        ("SOURCE_DATE_EPOCH", "1"),
        ("COLUMNS", "20"),
    ];
    let mut command = course.command(&["build", "--quiet", "--root"]);
    let output = command.arg(&far).envs(environment).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    same(&here, &tree(&far.join("book")));
}

#[test]
fn a_root_given_in_other_words_does_not_show() {
    let (course, here) = built(&[]);
    fs::remove_dir_all(course.path("book")).unwrap();
    course.fine(&["build", "--quiet", "--root", "chapters/.."]);
    same(&here, &course.book());
    course.fine(&["build", "--quiet", "--no-cache", "--out", "elsewhere/deep"]);
    same(&here, &tree(&course.path("elsewhere/deep")));
}

#[test]
fn no_path_of_this_machine_is_in_the_book() {
    let (course, book) = built(&[]);
    let folders = [course.root().to_str().unwrap().to_owned(), std::env::temp_dir().to_str().unwrap().to_owned()];
    let home = std::env::var("HOME").unwrap_or_default();
    for (path, bytes) in &book {
        let holds = |text: &str| bytes.windows(text.len()).any(|window| window == text.as_bytes());
        for folder in &folders {
            assert!(!holds(folder), "{path} holds {folder}");
        }
        assert!(!holds(crate::course::PACKAGE), "{path} holds the package's folder");
        assert!(home.len() < 4 || !holds(&home), "{path} holds the home folder");
    }
}

#[test]
fn edits_made_and_undone_leave_no_trace() {
    let (course, cold) = built(&[]);
    let prose = course.read("chapters/02-prose.md");
    let experiments = course.read("chapters/01-experiments.md");
    // A new chapter, another order, a template, a picture, another seed, a removed section.
    course.write(
        "chapters/04-new.md",
        "+++\ntitle = \"New\"\nsummary = \"New.\"\n+++\n\n![Words](new.png) and @fig-curve.\n",
    );
    course.write("chapters/new.png", b"\x89PNG");
    course.edit("chapters/workbook.toml", "[\"02-prose\", ", "[\"04-new\", \"02-prose\", ");
    course.write("templates/assets/extra.css", "b {}\n");
    course.fine(&["build", "--quiet"]);
    let changed = course.book();
    assert!(changed.contains_key("new.html") && changed.contains_key("new.png"));
    assert!(changed.contains_key("assets/extra.css"));
    course.edit("chapters/01-experiments.md", "n = 32\nruns = 3", "n = 16\nruns = 2");
    course.edit("chapters/workbook.toml", "seed = 7", "seed = 8");
    course.edit("chapters/02-prose.md", "Plain text with", "Text with");
    course.fine(&["build", "--quiet"]);
    // All of it undone.
    course.write("chapters/02-prose.md", prose);
    course.write("chapters/01-experiments.md", experiments);
    course.edit("chapters/workbook.toml", "[\"04-new\", ", "[");
    course.edit("chapters/workbook.toml", "seed = 8", "seed = 7");
    for file in ["chapters/04-new.md", "chapters/new.png", "templates/assets/extra.css"] {
        fs::remove_file(course.path(file)).unwrap();
    }
    course.fine(&["build", "--quiet"]);
    same(&cold, &course.book());
    let beside: Vec<_> = fs::read_dir(course.root()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert!(beside.iter().all(|name| !name.to_string_lossy().contains("staging")), "{beside:?}");
}

#[test]
fn a_removed_chapter_leaves_no_page() {
    let course = course();
    course.write("chapters/04-last.md", "+++\ntitle = \"Last\"\nsummary = \"Last.\"\n+++\n\nText.\n");
    course.edit("chapters/workbook.toml", "\"03-claims\"]", "\"03-claims\", \"04-last\"]");
    course.fine(&["build", "--quiet"]);
    assert!(course.book().contains_key("last.html"));
    fs::remove_file(course.path("chapters/04-last.md")).unwrap();
    course.edit("chapters/workbook.toml", "\"03-claims\", \"04-last\"]", "\"03-claims\"]");
    course.fine(&["build", "--quiet"]);
    same(&built(&[]).1, &course.book());
}

#[test]
fn the_lock_is_the_same_on_any_number_of_threads() {
    let lock = |jobs: &str| {
        let course = course();
        course.fine(&["accept", "--quiet", "--jobs", jobs]);
        course.read("book/workbook.lock")
    };
    assert_eq!(lock("1"), lock("4"));
}
