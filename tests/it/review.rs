//! Reviewing: the lock, what `verify` says of it, and what `accept` does to it.

use crate::course::{Course, accepted, small};

/// The word at `key` in the block of an exhibit of the lock.
fn locked(course: &Course, exhibit: &str, key: &str) -> String {
    let lock = course.read("book/workbook.lock");
    let block = lock.split_once(&format!("[exhibit.{exhibit}]")).unwrap().1;
    let line = block.lines().find(|line| line.starts_with(&format!("{key} = "))).unwrap();
    line.split_once(" = ").unwrap().1.trim_matches('"').to_owned()
}

/// Replaces a word of the lock in the block of an exhibit.
fn tamper(course: &Course, exhibit: &str, old: &str, new: &str) {
    let lock = course.read("book/workbook.lock");
    let (before, block) = lock.split_at(lock.find(&format!("[exhibit.{exhibit}]")).unwrap());
    assert!(block.contains(old), "`{old}` in {block}");
    course.write("book/workbook.lock", format!("{before}{}", block.replacen(old, new, 1)));
}

#[test]
fn the_lock_survives_the_replacement_of_the_book() {
    let course = accepted();
    let lock = course.read("book/workbook.lock");
    course.edit("chapters/01-one.md", "Some prose.", "Other prose.");
    assert!(course.fine(&["build"]).err.contains("wrote"));
    assert_eq!(course.read("book/workbook.lock"), lock);
    assert!(course.read("book/one.html").contains("Other prose."));
    // The lock alone is what a fresh clone has.
    std::fs::remove_dir_all(course.path("book")).unwrap();
    course.write("book/workbook.lock", &lock);
    course.fine(&["build", "--quiet"]);
    assert_eq!(course.read("book/workbook.lock"), lock);
}

#[test]
fn verify_needs_a_lock_and_passes_after_accept() {
    let course = small();
    let said = course.say(&["verify"]);
    assert_eq!(said.exit, 1);
    assert!(said.err.contains("W0204"), "{}", said.err);
    course.fine(&["accept"]);
    let said = course.fine(&["verify"]);
    assert!(said.err.contains("as in the lock: 2 exhibits; verified: 1 claim"), "{}", said.err);
    course.write("book/workbook.lock", "format = 1\n[exhibit.fig-points\n");
    let said = course.say(&["verify", "--quiet"]);
    assert_eq!(said.exit, 1);
    assert!(said.err.contains("W0204"), "{}", said.err);
}

#[test]
fn verify_trusts_no_cache() {
    let course = accepted();
    assert!(course.fine(&["verify"]).err.contains("ran fig-points"));
    assert!(course.fine(&["build"]).err.contains("0 of 2 experiments ran"));
}

#[test]
fn data_drift_names_the_exhibit_its_place_and_both_values() {
    let course = accepted();
    let lock = course.read("book/workbook.lock");
    tamper(&course, "fig-points", "\"cells.max.jittered\" = 1", "\"cells.max.jittered\" = 3");
    let said = course.say(&["verify", "--quiet"]);
    assert_eq!(said.exit, 1);
    assert!(said.err.contains("the data of `fig-points` changed since the lock"), "{}", said.err);
    assert!(said.err.contains("--> chapters/01-one.md:8:1"), "{}", said.err);
    assert!(said.err.contains("cells.max.jittered: 3 -> 1"), "{}", said.err);
    assert!(!said.err.contains("tbl-estimates"), "{}", said.err);
    let said = course.fine(&["build", "--quiet"]);
    assert!(said.err.contains("warning[W0203]: the data of `fig-points`"), "{}", said.err);
    course.fine(&["accept", "--quiet"]);
    assert_eq!(course.read("book/workbook.lock"), lock);
}

#[test]
fn a_changed_question_is_data_drift_of_that_exhibit_alone() {
    let course = accepted();
    course.edit("chapters/01-one.md", "n = [4, 16]", "n = [4, 64]");
    let said = course.say(&["verify", "--quiet", "--format", "json"]);
    assert_eq!(said.exit, 1);
    let lines: Vec<serde_json::Value> = said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines.len(), 1, "{}", said.out);
    assert!(lines[0]["message"].as_str().unwrap().starts_with("the data of `tbl-estimates` changed"));
    assert_eq!(lines[0]["place"]["line"], 19);
    let told = lines[0]["help"].to_string();
    assert!(told.contains("estimate.16: ") && told.contains("estimate.64: absent -> "), "{told}");
}

#[test]
fn drawing_drift_is_told_apart_from_data_drift() {
    let course = accepted();
    let drawing = locked(&course, "fig-points", "drawing");
    tamper(&course, "fig-points", &drawing, &"0".repeat(drawing.len()));
    let said = course.say(&["verify", "--quiet"]);
    assert_eq!(said.exit, 1);
    let told = "the drawing of `fig-points` changed since the lock; its data did not";
    assert!(said.err.contains(told), "{}", said.err);
    assert!(!said.err.contains("the data of") && said.err.contains("1 error\n"), "{}", said.err);
}

#[test]
fn another_key_alone_is_no_drift() {
    let course = accepted();
    let key = locked(&course, "fig-points", "key");
    tamper(&course, "fig-points", &key, &"0".repeat(key.len()));
    course.fine(&["verify"]);
}

#[test]
fn new_and_left_over_exhibits_are_told_apart() {
    let course = accepted();
    course.edit("chapters/01-one.md", "id = \"fig-points\"", "id = \"fig-renamed\"");
    let said = course.say(&["verify", "--quiet"]);
    assert_eq!(said.exit, 1);
    assert!(said.err.contains("`fig-renamed` is in the book, but not in the lock"), "{}", said.err);
    let told = "`fig-points` is in the lock, but no longer in the book; `chapters/01-one.md` had it";
    assert!(said.err.contains(told), "{}", said.err);
    course.fine(&["accept", "fig-renamed", "--quiet"]);
    let said = course.say(&["verify", "--quiet"]);
    assert!(!said.err.contains("fig-renamed") && said.err.contains(told), "{}", said.err);
    course.fine(&["accept", "fig-points", "--quiet"]);
    course.fine(&["verify", "--quiet"]).silent();
}

#[test]
fn accepting_one_exhibit_touches_no_other() {
    let course = accepted();
    tamper(&course, "fig-points", "\"cells.max.jittered\" = 1", "\"cells.max.jittered\" = 3");
    tamper(&course, "tbl-estimates", "exact = 0.5", "exact = 0.25");
    let said = course.say(&["accept", "fig-points", "fig-nowhere"]);
    assert_eq!(said.exit, 2, "{}", said.err);
    assert!(course.read("book/workbook.lock").contains("\"cells.max.jittered\" = 3"), "nothing was accepted");
    course.fine(&["accept", "fig-points"]);
    let lock = course.read("book/workbook.lock");
    assert!(lock.contains("\"cells.max.jittered\" = 1") && lock.contains("exact = 0.25"));
    assert!(course.say(&["verify", "--quiet"]).err.contains("exact: 0.25 -> 0.5"));
}

#[test]
fn what_is_wrong_cannot_be_accepted() {
    let course = accepted();
    let lock = course.read("book/workbook.lock");
    course.edit("chapters/01-one.md", "n = 16\n", "n = 25\n");
    course.edit("chapters/01-one.md", "{ equals = 1 }", "{ equals = 2 }");
    assert_eq!(course.say(&["accept"]).exit, 1);
    assert_eq!(course.read("book/workbook.lock"), lock);
}
