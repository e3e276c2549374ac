//! The lint `typed-number` as an author meets it: by the course's setting, in each format, and what the course says it is.

use serde_json::Value;

use crate::course::Course;

const CHAPTER: &str = "+++\ntitle = \"One\"\nsummary = \"The only chapter.\"\n\n[given]\n\"2.5\" = \"why\"\n\"3.5\" = \"why\"\n+++\n\nÄ number, 2.5, and 0.0034.\n";

fn course(setting: &str) -> Course {
    let configuration = format!("title = \"A course\"\nauthors = [\"A. Author\"]\n{setting}");
    Course::new(&[("chapters/workbook.toml", &configuration), ("chapters/01-one.md", CHAPTER)])
}

#[test]
fn a_typed_number_is_a_warning_an_error_or_nothing() {
    for (setting, exit, level) in
        [("", 0, "warning"), ("typed_numbers = \"warning\"", 0, "warning"), ("typed_numbers = \"error\"", 1, "error")]
    {
        for command in ["build", "check"] {
            let course = course(setting);
            let said = course.say(&[command, "--quiet"]);
            assert_eq!(said.exit, exit, "{setting}: {}", said.err);
            assert!(said.err.contains(&format!("{level}[W0121]: typed-number: `0.0034`")), "{}", said.err);
            assert!(said.err.contains(&format!("{level}[W0122]: typed-number: nothing in this chapter is `3.5`")));
            assert!(!said.err.contains("`2.5`"), "{}", said.err);
            assert_eq!(course.path("book/index.html").exists(), command == "build" && exit == 0);
        }
    }
    let said = course("typed_numbers = \"allowed\"").say(&["build", "--quiet"]);
    assert_eq!((said.exit, said.err.as_str()), (0, ""));
    let said = course("typed_numbers = \"ignored\"").say(&["check", "--quiet"]);
    assert_eq!(said.exit, 1);
    assert!(said.err.contains("`warning`, `error` and `allowed`"), "{}", said.err);
}

#[test]
fn a_typed_number_has_its_exact_place_in_every_format() {
    let said = course("").say(&["check", "--format", "json", "--quiet"]);
    let lines: Vec<Value> = said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let places: Vec<(&str, u64, u64, u64)> = lines
        .iter()
        .map(|line| {
            let of = |key: &str| line["place"][key].as_u64().unwrap();
            (line["code"].as_str().unwrap(), of("line"), of("column"), of("end_column"))
        })
        .collect();
    assert_eq!(places, [("W0122", 7, 1, 6), ("W0121", 10, 20, 26)]);
    assert!(lines.iter().all(|line| line["severity"] == "warning"));
    let bytes = &lines[1]["place"]["bytes"];
    let (start, end) = (bytes[0].as_u64().unwrap() as usize, bytes[1].as_u64().unwrap() as usize);
    assert_eq!(&CHAPTER[start..end], "0.0034");
    let said = course("").say(&["check", "--format", "github", "--quiet"]);
    assert!(
        said.out.contains("::warning file=chapters/01-one.md,line=10,col=20,endColumn=26,title=W0121::"),
        "{}",
        said.out
    );
}
