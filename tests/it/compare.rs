//! Two books next to each other: what differs is told, and nothing else.

use std::process::Command;

use serde_json::{Value as Json, json};

use crate::course::{Course, small, tree};

/// The comparison of two folders as JSON.
fn told(course: &Course, arguments: &[&str]) -> Json {
    let said = course.fine(&[&["compare"], arguments, &["--format", "json", "--quiet"]].concat());
    serde_json::from_str(&said.out).unwrap()
}

fn ids(list: &Json) -> Vec<&str> {
    list.as_array().unwrap().iter().map(|entry| entry["id"].as_str().unwrap()).collect()
}

/// The small course with the old book in `old` and, after a change, a new one in `new`.
fn two() -> Course {
    let course = small();
    course.fine(&["build", "--quiet", "--out", "old"]);
    course.edit("chapters/01-one.md", "n = 16\n", "n = 25\n");
    course.edit("chapters/01-one.md", "{ equals = 1 }", "{ below = 2 }");
    course.edit("chapters/01-one.md", "Some prose.", "Other prose.");
    course.fine(&["build", "--quiet", "--out", "new"]);
    course
}

#[test]
fn numbers_claims_parameters_and_drawings_that_differ_are_told() {
    let course = two();
    let json = told(&course, &["old", "new"]);
    assert_eq!(ids(&json["changed"]), ["fig-points"], "the table is the same, and prose is no exhibit");
    let changed = &json["changed"][0];
    let row =
        |list: &str, name: &str| changed[list].as_array().unwrap().iter().find(|row| row["name"] == name).cloned();
    let n = row("parameters", "n").unwrap();
    assert_eq!((&n["old"], &n["new"]), (&json!("[16]"), &json!("[25]")));
    assert!(row("values", "cells.max.jittered").is_none(), "it is 1 in both");
    let claims: Vec<&str> =
        changed["claims"].as_array().unwrap().iter().map(|claim| claim["claim"].as_str().unwrap()).collect();
    assert_eq!(claims, ["cells.max.jittered below 2", "cells.max.jittered equals 1"]);
    assert_eq!(changed["pictures"][0]["path"], "exhibits/fig-points.svg");
    assert!(changed["pictures"][0].get("old").is_none(), "drawings are files of the books");
    assert_eq!((&json["added"], &json["removed"], &json["moved"]), (&json!([]), &json!([]), &json!([])));
    let page = course.read("comparison.html");
    for part in ["id=\"fig-points\"", "data:image/svg+xml;base64,", "class=\"sheet over\"", "not claimed", "[25]"] {
        assert!(page.contains(part), "{part}");
    }
    for absent in ["tbl-estimates", "<script", "http://", "https://", "{{", "{%"] {
        assert!(!page.contains(absent), "{absent}");
    }
    let said = course.fine(&["compare", "old", "new", "--report", "else.html"]);
    assert!(said.out.starts_with("Exhibits of old and of new: 1 changed.\n\nChanged:\n\n- `fig-points` (Figure 1.1, "));
    assert!(said.err.contains("wrote else.html") && course.path("else.html").is_file(), "{}", said.err);
}

#[test]
fn exhibits_that_come_go_or_move_are_told() {
    let course = two();
    let text = course.read("chapters/01-one.md");
    let more = text.replacen(
        "```experiment",
        "```experiment\nid = \"fig-first\"\nkind = \"function\"\nintegrand = \"x\"\ncaption = \"A line.\"\n```\n\n```experiment",
        1,
    );
    course.write("chapters/01-one.md", more);
    course.fine(&["build", "--quiet", "--out", "more"]);
    let json = told(&course, &["new", "more"]);
    assert_eq!((ids(&json["added"]), ids(&json["removed"])), (vec!["fig-first"], vec![]));
    assert_eq!(ids(&json["moved"]), ["fig-points"], "the table has the number that it had");
    assert_eq!(
        (&json["moved"][0]["old"], &json["moved"][0]["new"]),
        (&json!("Figure 1.1 in one"), &json!("Figure 1.2 in one"))
    );
    assert_eq!(json["changed"], json!([]));
    assert_eq!(ids(&told(&course, &["more", "new"])["removed"]), ["fig-first"]);
    assert!(course.read("comparison.html").contains("<h2>Removed</h2>"));
}

#[test]
fn the_same_book_has_no_difference_and_the_exit_code_tells() {
    let course = two();
    let said = course.fine(&["compare", "new", "new", "--exit-code"]);
    assert_eq!(said.out, "The 2 exhibits of new are those of new.\n");
    assert_eq!(course.say(&["compare", "old", "new", "--exit-code"]).exit, 1);
    // A key that differs alone is no difference.
    let figures = course.read("new/figures.json");
    let key = figures.split("\"key\":\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
    course.write("new/figures.json", figures.replace(&key, &"0".repeat(64)));
    assert!(
        course.fine(&["compare", "new", "--exit-code"]).out.contains("are those of new"),
        "the course as it is now"
    );
    // A verdict is told before all else.
    let holds = course.read("new/figures.json").replacen("\"holds\":true", "\"holds\":false", 1);
    course.fine(&["build", "--quiet", "--out", "same"]);
    course.write("same/figures.json", holds);
    let json = told(&course, &["new", "same"]);
    assert_eq!(json["changed"][0]["what"], json!(["1 verdict"]));
    assert_eq!(json["changed"][0]["claims"][0]["verdict_changed"], true);
    assert!(course.read("comparison.html").contains("<span class=\"bad\">does not hold</span>"));
}

#[test]
fn revisions_are_built_apart_and_leave_no_trace() {
    let course = small();
    let git = |arguments: &[&str]| {
        let settings = ["-c", "user.name=A", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"];
        let done = Command::new("git").current_dir(course.root()).args(settings).args(arguments).output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        String::from_utf8(done.stdout).unwrap()
    };
    git(&["init", "--quiet"]);
    git(&["add", "."]);
    git(&["commit", "--quiet", "-m", "one"]);
    course.edit("chapters/01-one.md", "n = 16\n", "n = 25\n");
    git(&["commit", "--quiet", "-a", "-m", "two"]);
    course.edit("chapters/01-one.md", "n = 25\n", "n = 36\n");
    let before = (git(&["status", "--porcelain"]), tree(&course.path(".git")));
    let json = told(&course, &["HEAD~1", "HEAD"]);
    assert_eq!(ids(&json["changed"]), ["fig-points"]);
    let n = |json: &Json| {
        let rows = json["changed"][0]["parameters"].as_array().unwrap().iter().find(|row| row["name"] == "n").cloned();
        rows.map(|row| (row["old"].clone(), row["new"].clone())).unwrap()
    };
    assert_eq!(n(&json), (json!("[16]"), json!("[25]")));
    assert_eq!(n(&told(&course, &["HEAD"])), (json!("[25]"), json!("[36]")), "the course as it is now");
    course.path("comparison.html").exists().then(|| std::fs::remove_file(course.path("comparison.html")).unwrap());
    std::fs::remove_dir_all(course.path(".workbook")).unwrap();
    assert!((git(&["status", "--porcelain"]), tree(&course.path(".git"))) == before, "the repository is as it was");
    let said = course.say(&["compare", "no-such-revision"]);
    assert!(said.exit == 2 && said.err.contains("neither a folder with a book nor a revision"), "{}", said.err);
    let said = course.say(&["compare", "chapters"]);
    assert!(said.exit == 2 && said.err.contains("it has no `figures.json`"), "{}", said.err);
}
