//! The book is replaced whole or not at all: by builds that fail, that are killed, that run at once, and where it cannot be.

use std::io::{BufRead, BufReader};
use std::process::Stdio;
use std::thread;
use std::time::Duration;

use crate::course::{Course, Said, accepted, small, tree};

/// An experiment that takes minutes.
const SLOW: &str = r#"
```experiment
id = "fig-slow"
kind = "convergence"
samplers = ["independent"]
integrand = "exp-sin"
n = [1048576, 4194304]
replicates = 100000
caption = "Slow."
```
"#;

#[test]
fn a_folder_that_cannot_be_written_ends_with_3() {
    let course = small();
    course.write("file", "no folder");
    for out in ["file/book", "file/deep/book"] {
        let said = course.say(&["build", "--quiet", "--out", out]);
        assert_eq!(said.exit, 3, "{}", said.err);
        assert!(said.err.contains("W0009"), "{}", said.err);
    }
    assert_eq!(course.read("file"), "no folder");
    course.write("book", "a file where the lock's folder would be");
    assert_eq!(course.say(&["accept", "--quiet"]).exit, 3);
}

#[test]
fn a_folder_that_is_no_book_is_not_replaced() {
    let course = small();
    course.write("precious/thesis.txt", "the only copy");
    for out in ["precious", "chapters", "."] {
        let before = tree(course.root());
        let said = course.say(&["build", "--quiet", "--out", out, "--no-cache"]);
        assert_eq!(said.exit, 2, "{out}: {}", said.err);
        assert!(said.err.contains("W0010"), "{}", said.err);
        assert!(tree(course.root()) == before, "{out}");
    }
}

#[test]
fn a_failing_build_leaves_the_last_good_book() {
    let course = accepted();
    let good = course.book();
    for mistake in ["@fig-nowhere", "`=fig-points.nothing`", "[a place](#nowhere)", "$\\fraq$"] {
        course.edit("chapters/01-one.md", "Some prose.", mistake);
        assert_eq!(course.say(&["build", "--quiet"]).exit, 1, "{mistake}");
        assert!(course.book() == good, "{mistake}");
        course.edit("chapters/01-one.md", mistake, "Some prose.");
    }
}

#[test]
fn a_build_that_is_killed_while_it_runs_leaves_the_last_good_book() {
    let course = accepted();
    let good = course.book();
    course.write("chapters/02-slow.md", format!("+++\ntitle = \"Slow\"\nsummary = \"Slow.\"\n+++\n{SLOW}"));
    course.edit("chapters/01-one.md", "n = 16\n", "n = 36\n");
    let mut build = course.command(&["build", "--jobs", "2"]).stderr(Stdio::piped()).spawn().unwrap();
    let mut line = String::new();
    BufReader::new(build.stderr.take().unwrap()).read_line(&mut line).unwrap();
    assert!(line.starts_with("ran fig-points"), "{line}");
    build.kill().unwrap();
    assert!(!build.wait().unwrap().success());
    assert!(course.book() == good);
    std::fs::remove_file(course.path("chapters/02-slow.md")).unwrap();
    let said = course.fine(&["build"]);
    assert!(said.err.contains("0 of 2 experiments ran"), "what was done was kept: {}", said.err);
}

#[test]
fn a_build_that_is_killed_at_any_time_leaves_a_whole_book() {
    let course = Course::case("everything");
    let mut books = Vec::new();
    for words in ["Other words", "Plain text"] {
        let now = if words == "Plain text" { "Other words" } else { "Plain text" };
        course.edit("chapters/02-prose.md", now, words);
        course.fine(&["build", "--quiet"]);
        books.push(course.book());
    }
    for delay in 0..16 {
        let (old, new) = if delay % 2 == 0 { ("Plain text", "Other words") } else { ("Other words", "Plain text") };
        course.edit("chapters/02-prose.md", old, new);
        let mut build = course.command(&["build", "--quiet"]).spawn().unwrap();
        thread::sleep(Duration::from_millis(4 * delay));
        build.kill().unwrap();
        build.wait().unwrap();
        assert!(books.contains(&course.book()), "killed after {} ms", 4 * delay);
    }
    course.edit("chapters/02-prose.md", "Plain text", "New words");
    course.fine(&["build", "--quiet"]);
    let mut beside: Vec<_> =
        std::fs::read_dir(course.root()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    beside.sort();
    assert_eq!(beside, [".workbook", "book", "chapters"], "what killed builds left is gone");
}

#[test]
fn builds_at_once_do_not_harm_each_other() {
    let expected = {
        let course = small();
        course.fine(&["build", "--quiet"]);
        course.book()
    };
    for round in 0..4 {
        let course = small();
        let builds: Vec<_> = (0..4)
            .map(|_| {
                course.command(&["build", "--quiet"]).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
            })
            .collect();
        for build in builds {
            let said = Said::from(build.wait_with_output().unwrap());
            assert_eq!((said.exit, said.err.as_str()), (0, ""), "round {round}");
        }
        assert!(course.book() == expected, "round {round}");
    }
}
