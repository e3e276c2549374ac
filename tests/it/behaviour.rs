//! What runs and what does not: the cache as an author meets it, by what was computed.

use std::fs::{self, File, FileTimes};
use std::time::{Duration, SystemTime};

use workbook::compose::Composed;
use workbook::diag::{Code, Severity, any_error};
use workbook::exhibits::Shown;
use workbook::run::{How, Why};

use crate::course::{Course, computed};

const CONFIGURATION: &str = "title = \"A course\"\nauthors = [\"A. Author\"]\n\n[defaults]\nseed = 1\n";

const ONE: &str = r#"+++
title = "One"
summary = "The first chapter."
+++

Some prose.

```experiment
id = "fig-halton"
kind = "points"
sampler = "halton"
n = 16
caption = "Halton's points."
```

```experiment
id = "fig-random"
kind = "points"
sampler = "independent"
n = 16
caption = "Random points."
```
"#;

const TWO: &str = r#"+++
title = "Two"
summary = "The second chapter."
+++

```experiment
id = "fig-again"
kind = "points"
samplers = ["halton"]
n = 16
strata = "none"
caption = "The points of @fig-halton, asked for in other words."
```

```experiment
id = "tbl-fixed"
kind = "estimate-table"
integrand = "x"
n = [4, 16]
seed = 5
caption = "Estimates with a seed of their own."
```
"#;

const ALL: [&str; 4] = ["fig-again", "fig-halton", "fig-random", "tbl-fixed"];

/// A course of two chapters and three experiments.
fn course() -> Course {
    Course::new(&[("chapters/workbook.toml", CONFIGURATION), ("chapters/01-one.md", ONE), ("chapters/02-two.md", TWO)])
}

/// A course that has been built, and is sound.
fn built() -> (Course, Composed) {
    let course = course();
    let first = sound(course.compose(2));
    assert_eq!(computed(&first), ALL);
    (course, first)
}

fn sound(composed: Composed) -> Composed {
    assert!(!any_error(&composed.diagnostics), "{:?}", composed.diagnostics);
    composed
}

fn drawing<'c>(composed: &'c Composed, id: &str) -> &'c Shown {
    let at = composed.plan.exhibits.iter().position(|exhibit| exhibit.id == id).unwrap();
    &composed.shown[at]
}

fn page<'c>(composed: &'c Composed, path: &str) -> &'c str {
    std::str::from_utf8(&composed.book.files[path]).unwrap()
}

#[test]
fn nothing_runs_twice() {
    let (course, first) = built();
    let second = sound(course.compose(2));
    assert!(computed(&second).is_empty());
    assert!(second.book == first.book);
}

#[test]
fn a_file_time_runs_nothing() {
    let (course, first) = built();
    let old = FileTimes::new().set_modified(SystemTime::UNIX_EPOCH + Duration::from_secs(1));
    let new = FileTimes::new().set_modified(SystemTime::now() + Duration::from_secs(1_000_000));
    for times in [old, new] {
        for file in ["chapters/workbook.toml", "chapters/01-one.md", "chapters/02-two.md"] {
            File::options().write(true).open(course.path(file)).unwrap().set_times(times).unwrap();
        }
        let again = sound(course.compose(2));
        assert!(computed(&again).is_empty());
        assert!(again.book == first.book);
    }
}

#[test]
fn prose_runs_nothing() {
    let (course, first) = built();
    course.edit("chapters/01-one.md", "Some prose.", "Other prose.\n\n## A section\n\nAnd more.");
    let again = sound(course.compose(2));
    assert!(computed(&again).is_empty());
    assert!(page(&again, "one.html").contains("Other prose."));
    assert_eq!(page(&again, "bibliography.html"), page(&first, "bibliography.html"));
}

#[test]
fn a_caption_an_alternative_text_and_a_claim_run_nothing_and_show() {
    let (course, first) = built();
    course.edit("chapters/01-one.md", "Halton's points.\"", "Better words.\"\nalt = \"Sixteen points.\"");
    course.edit(
        "chapters/01-one.md",
        "\"Random points.\"\n",
        "\"Random points.\"\n[claims]\n\"distance.*\" = { above = 0.0 }\n",
    );
    let again = sound(course.compose(2));
    assert!(computed(&again).is_empty());
    let one = page(&again, "one.html");
    assert!(one.contains("Better words.") && one.contains("Sixteen points.") && !one.contains("Halton's points."));
    assert_eq!(drawing(&again, "fig-random").verdicts.len(), 1);
    assert_ne!(one, page(&first, "one.html"));
}

#[test]
fn a_template_and_a_style_sheet_run_nothing_and_show() {
    let (course, first) = built();
    course.write("templates/page.html", "<main id=\"main\">{{ body | safe }}</main>");
    course.write("templates/assets/style.css", "body { color: rebeccapurple; }\n");
    let again = sound(course.compose(2));
    assert!(computed(&again).is_empty());
    assert!(page(&again, "one.html").starts_with("<main id=\"main\">"));
    assert!(page(&again, "assets/style.css").starts_with("body { color: rebeccapurple; }"));
    assert_ne!(page(&first, "assets/style.css"), page(&again, "assets/style.css"));
}

#[test]
fn a_changed_parameter_runs_one_experiment() {
    let (course, first) = built();
    course.edit("chapters/02-two.md", "n = [4, 16]", "n = [4, 32]");
    let again = sound(course.compose(2));
    assert_eq!(computed(&again), ["tbl-fixed"]);
    let ran = again.ran.iter().find(|ran| ran.how != How::Cached).unwrap();
    let How::Computed(Why::Changed(difference)) = &ran.how else { panic!("{:?}", ran.how) };
    assert_eq!(difference.to_string(), "parameters.n: [4,16] -> [4,32]");
    assert_ne!(drawing(&again, "tbl-fixed").key, drawing(&first, "tbl-fixed").key);
    course.edit("chapters/02-two.md", "n = [4, 32]", "n = [4, 16]");
    let back = sound(course.compose(2));
    assert!(computed(&back).is_empty(), "what was asked before is still known");
    assert!(back.book == first.book);
}

#[test]
fn two_chapters_that_ask_the_same_share_one_run() {
    let (_, first) = built();
    assert_eq!(first.ran.len(), 3);
    let shared: Vec<_> = first.ran.iter().filter(|ran| ran.ids.len() == 2).collect();
    assert_eq!(shared.len(), 1);
    assert_eq!(shared[0].ids, ["fig-again", "fig-halton"]);
    assert_eq!(drawing(&first, "fig-again").key, drawing(&first, "fig-halton").key);
}

#[test]
fn a_changed_seed_runs_what_uses_it() {
    let (course, first) = built();
    course.edit("chapters/workbook.toml", "seed = 1", "seed = 2");
    let again = sound(course.compose(2));
    assert_eq!(computed(&again), ["fig-again", "fig-halton", "fig-random"]);
    assert_eq!(drawing(&again, "fig-halton").outcome.bytes, drawing(&first, "fig-halton").outcome.bytes);
    assert_ne!(drawing(&again, "fig-random").outcome.bytes, drawing(&first, "fig-random").outcome.bytes);
    course.edit("chapters/02-two.md", "seed = 5", "seed = 6");
    assert_eq!(computed(&sound(course.compose(2))), ["tbl-fixed"]);
}

#[test]
fn what_is_wrong_elsewhere_keeps_no_experiment_from_running() {
    let course = course();
    course.edit("chapters/01-one.md", "Some prose.", "See @fig-nowhere.");
    let wrong = course.compose(2);
    assert!(any_error(&wrong.diagnostics) && wrong.book.files.is_empty());
    assert_eq!(computed(&wrong), ALL);
    course.edit("chapters/01-one.md", "See @fig-nowhere.", "See @fig-again.");
    assert!(computed(&sound(course.compose(2))).is_empty(), "the results were kept");
}

/// What is done to the bytes of a result that was kept.
type Damage = fn(&[u8]) -> Vec<u8>;

#[test]
fn a_damaged_cache_is_computed_again_and_mended() {
    let (course, first) = built();
    let damages: [Damage; 5] = [
        |_| Vec::new(),
        |bytes| bytes[..bytes.len() / 2].to_vec(),
        |bytes| bytes[..bytes.len() - 1].to_vec(),
        |bytes| {
            bytes.iter().enumerate().map(|(at, byte)| if at == bytes.len() - 4 { byte ^ 4 } else { *byte }).collect()
        },
        |bytes| b"nonsense".iter().chain(bytes).copied().collect(),
    ];
    for (at, damage) in damages.into_iter().enumerate() {
        for entry in fs::read_dir(course.path(".workbook/cache/results")).unwrap() {
            let path = entry.unwrap().path();
            fs::write(&path, damage(&fs::read(&path).unwrap())).unwrap();
        }
        let again = sound(course.compose(2));
        assert_eq!(computed(&again), ALL, "damage {at}");
        assert!(again.ran.iter().all(|ran| ran.how == How::Computed(Why::Damaged)), "damage {at}");
        assert!(again.book == first.book, "damage {at}");
        assert!(computed(&sound(course.compose(2))).is_empty(), "damage {at} is mended");
    }
}

#[test]
fn an_entry_in_the_place_of_another_is_not_trusted() {
    let (course, first) = built();
    let mut entries: Vec<_> =
        fs::read_dir(course.path(".workbook/cache/results")).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    fs::copy(&entries[0], &entries[1]).unwrap();
    let again = sound(course.compose(2));
    assert_eq!(again.ran.iter().filter(|ran| ran.how != How::Cached).count(), 1);
    assert!(again.book == first.book);
}

#[test]
fn a_cache_that_was_removed_is_made_again() {
    let (course, first) = built();
    fs::remove_dir_all(course.path(".workbook")).unwrap();
    let again = sound(course.compose(2));
    assert_eq!(computed(&again), ALL);
    assert!(again.book == first.book);
}

#[test]
fn a_cache_that_cannot_be_written_is_a_warning() {
    let reference = sound(course().compose(2));
    let course = course();
    // Nobody, not even root, can make a folder below a file.
    course.write(".workbook", "a file where the folder of the cache would be");
    let composed = sound(course.compose(2));
    let warnings: Vec<_> = composed.diagnostics.iter().map(|told| (told.severity, told.code)).collect();
    assert_eq!(warnings, [(Severity::Warning, Code::Unreadable)]);
    assert_eq!(computed(&composed), ALL);
    assert!(composed.book == reference.book);
    assert_eq!(course.read(".workbook"), "a file where the folder of the cache would be");
    let said = course.say(&["build", "--quiet"]);
    assert_eq!(said.exit, 0, "{}", said.err);
    assert!(said.err.contains("results could not be kept in the cache"), "{}", said.err);
}
