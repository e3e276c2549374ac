//! The program as it is called: its words, its exit codes, and what it says to whom.

use crate::course::{Course, accepted, small, tree};

#[test]
fn a_sound_course_ends_with_0_and_a_wrong_one_with_1() {
    let course = small();
    let said = course.fine(&["build"]);
    assert_eq!(said.out, "");
    assert!(said.err.contains("wrote") && said.err.contains("2 of 2 experiments ran"), "{}", said.err);
    assert!(course.fine(&["build"]).err.contains("nothing changed in"));
    course.edit("chapters/01-one.md", "{ equals = 1 }", "{ equals = 2 }");
    let said = course.say(&["build"]);
    assert_eq!(said.exit, 1);
    assert!(said.err.contains("--> chapters/01-one.md:16:1"), "{}", said.err);
    assert_eq!(course.say(&["check"]).exit, 0, "a claim is verified only by running");
    course.edit("chapters/01-one.md", "n = 16\n", "n = 17\n");
    for command in ["build", "check", "verify", "accept"] {
        assert_eq!(course.say(&[command]).exit, 1, "{command}");
    }
}

#[test]
fn a_wrong_call_ends_with_2() {
    let course = small();
    let calls: [&[&str]; 11] = [
        &[],
        &["biuld"],
        &["build", "--fromat", "json"],
        &["build", "--format", "yaml"],
        &["build", "--jobs", "0"],
        &["build", "--root", "nowhere"],
        &["run", "fig-nowhere"],
        &["why", "fig-nowhere"],
        &["accept", "fig-nowhere"],
        &["list", "catalogues"],
        &["list", "kinds", "nonsense"],
    ];
    for call in calls {
        let said = course.say(call);
        assert_eq!(said.exit, 2, "{call:?}: {}", said.err);
        assert!(!said.err.is_empty(), "{call:?}");
    }
    for word in ["--help", "--version"] {
        assert_eq!(course.say(&[word]).exit, 0, "{word}");
    }
}

#[test]
fn quiet_says_nothing_on_success() {
    let course = small();
    for command in ["check", "build", "build", "accept", "verify", "clean"] {
        course.fine(&[command, "--quiet"]).silent();
    }
    course.edit("chapters/01-one.md", "Some prose.", "@fig-nowhere");
    assert!(course.say(&["check", "--quiet"]).err.contains("W0112"), "mistakes are told even so");
}

#[test]
fn json_is_one_object_a_line_with_places() {
    let course = Course::case("wrong-many");
    let said = course.say(&["build", "--format", "json", "--quiet"]);
    assert_eq!((said.exit, said.err.as_str()), (1, ""));
    let lines: Vec<serde_json::Value> = said.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert!(lines.len() > 12, "{}", said.out);
    for line in &lines {
        assert!(line["code"].as_str().is_some_and(|code| code.starts_with('W') && code.len() == 5), "{line}");
        assert_eq!(line["severity"], "error");
        assert!(line["message"].as_str().is_some_and(|message| !message.is_empty()), "{line}");
        assert!(line["help"].is_array(), "{line}");
        // The text of a file that is not UTF-8 is not known: its place is in the message.
        if line["code"] == "W0002" {
            assert!(line["message"].as_str().unwrap().starts_with("chapters/03-three.md:5:1: "));
            continue;
        }
        let place = &line["place"];
        let text = course.read(place["file"].as_str().unwrap());
        let (row, column) = (place["line"].as_u64().unwrap() as usize, place["column"].as_u64().unwrap() as usize);
        let row = text.lines().nth(row - 1).unwrap();
        assert!((1..=row.chars().count() + 1).contains(&column), "{line}");
        assert!(place["end_column"].as_u64().unwrap() as usize >= column, "{line}");
    }
    let marked = |code: &str| {
        let line = lines.iter().find(|line| line["code"] == code).unwrap();
        (line["place"]["line"].as_u64().unwrap(), line["place"]["column"].as_u64().unwrap())
    };
    assert_eq!((marked("W0106"), marked("W0109"), marked("W0114")), ((9, 13), (10, 14), (25, 31)));
}

#[test]
fn what_is_told_of_a_call_is_a_diagnostic_too() {
    let course = small();
    let calls: [&[&str]; 5] = [
        &["run", "fig-piont"],
        &["why", "fig-piont"],
        &["accept", "fig-piont"],
        &["list", "kinds", "ponts"],
        &["explain", "W01O7"],
    ];
    for call in calls {
        let said = course.say(&[call, &["--format", "json", "--quiet"]].concat());
        assert_eq!(said.exit, 2, "{call:?}");
        let line: serde_json::Value =
            serde_json::from_str(&said.out).unwrap_or_else(|_| panic!("{call:?}: {}", said.out));
        assert!(line["code"].is_string() && !line["help"].as_array().unwrap().is_empty(), "{line}");
    }
}

#[test]
fn times_are_told_to_people_and_to_programs() {
    let course = small();
    let said = course.fine(&["build", "--timings"]);
    assert!(said.err.contains(" ms  render\n") && said.err.contains("fig-points (ran)"), "{}", said.err);
    let said = course.fine(&["build", "--timings", "--format", "json", "--quiet", "--no-cache"]);
    let line: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    let stages: Vec<&str> =
        line["timings"]["stages"].as_array().unwrap().iter().map(|stage| stage["stage"].as_str().unwrap()).collect();
    assert!(stages.starts_with(&["read"]) && stages.ends_with(&["in all"]), "{stages:?}");
    assert_eq!(line["timings"]["experiments"].as_array().unwrap().len(), 2);
    assert_eq!(said.err, "");
}

#[test]
fn nothing_is_coloured_where_nobody_looks() {
    let course = Course::case("wrong-many");
    for call in [&["build"][..], &["check"], &["--help"], &["list", "kinds"], &["explain", "W0107"], &["status"]] {
        let said = course.say(call);
        assert!(!said.out.contains('\u{1b}') && !said.err.contains('\u{1b}'), "{call:?}");
    }
}

#[test]
fn annotations_of_a_forge_have_places() {
    let said = Course::case("wrong-sampler").say(&["check", "--format", "github"]);
    assert_eq!(said.exit, 1);
    let first = said.out.lines().next().unwrap();
    let start = "::error file=chapters/01-one.md,line=9,col=28,endColumn=35,title=W0106::unknown sampler `haltn`%0A";
    assert!(first.starts_with(start), "{first}");
    assert!(said.out.lines().all(|line| line.starts_with("::error ")), "{}", said.out);
}

#[test]
fn the_book_goes_where_it_is_told() {
    let course = accepted();
    let lock = course.read("book/workbook.lock");
    let book = course.book();
    course.fine(&["build", "--quiet", "--out", "deep/site"]);
    let mut elsewhere = tree(&course.path("deep/site"));
    elsewhere.insert("workbook.lock".to_owned(), lock.clone().into_bytes());
    assert!(elsewhere == book, "the lock alone stays with the course");
    course.fine(&["verify", "--quiet", "--out", "deep/site"]);
    assert_eq!(course.read("book/workbook.lock"), lock);
}

#[test]
fn why_tells_fresh_from_stale() {
    let course = small();
    assert!(course.fine(&["why", "fig-points"]).out.starts_with("fig-points is stale: it has not run yet"));
    course.fine(&["build", "--quiet"]);
    let said = course.fine(&["why", "fig-points"]);
    assert!(said.out.starts_with("fig-points is fresh"), "{}", said.out);
    assert!(said.out.contains("\"samplers/jittered.rs\": \""), "{}", said.out);
    course.edit("chapters/01-one.md", "n = 16\n", "n = 25\nseed = 4\n");
    let said = course.fine(&["why", "fig-points"]);
    assert!(said.out.starts_with("fig-points is stale: its key changed: parameters.n: [16] -> [25]"), "{}", said.out);
    assert!(said.out.ends_with("  parameters.n: [16] -> [25]\n  seed: 1 -> 4\n"), "{}", said.out);
    let near = course.say(&["why", "fig-piont"]);
    assert!(near.err.contains("did you mean `fig-points`?"), "{}", near.err);
}

#[test]
fn run_prints_the_values_in_full() {
    let course = small();
    let said = course.fine(&["run", "fig-points", "--quiet"]);
    assert!(said.out.contains("cells.max.jittered     1\n") && said.err.is_empty(), "{}", said.out);
    let said = course.fine(&["run", "tbl-estimates", "--format", "json", "--quiet"]);
    let whole: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(whole["values"]["exact"], 0.5);
    assert_eq!(whole["parameters"]["n"], serde_json::json!([4, 16]));
    assert!(whole["standard_errors"]["estimate.16"].as_f64().is_some_and(|error| error > 0.0));
    assert!(course.fine(&["build"]).err.contains("0 of 2 experiments ran"), "what was run was kept");
}

#[test]
fn run_prints_the_files_of_the_book() {
    let course = small();
    course.fine(&["build"]);
    let file = |path: &str| course.read(&format!("book/exhibits/{path}"));
    let print = |id, format| course.fine(&["run", id, "--format", format, "--quiet"]).out;
    assert_eq!(print("fig-points", "csv"), file("fig-points.csv"));
    // The book's file leaves to the CSV beside it what stands there.
    let json = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    let (printed, kept) = (json(&print("fig-points", "json")), json(&file("fig-points.json")));
    assert!(["id", "kind", "parameters", "seed", "values"].iter().all(|part| printed[part] == kept[part]));
    assert_eq!(print("fig-points", "svg"), file("fig-points.svg"));
    assert!(print("tbl-estimates", "table").lines().all(|line| line.chars().count() < 100));
    let told = course.say(&["run", "tbl-estimates", "--format", "svg"]);
    assert!(told.err.contains("--format table"), "a table has no drawing: {}", told.err);
}

#[test]
fn run_changes_parameters_and_compares() {
    let course = small();
    course.fine(&["build", "--quiet"]);
    let book = course.book();
    let run = |arguments: &[&str]| course.fine(&[&["run", "--quiet"], arguments].concat()).out;
    // Both names of the parameter mean it, a word stands for itself, and what only one of the two has is alone.
    let said = run(&["fig-points", "-p", "samplers=halton", "-p", "n=25"]);
    let rows: Vec<Vec<&str>> =
        said.lines().map(|line| line.split("  ").filter(|cell| !cell.is_empty()).collect()).collect();
    assert_eq!(rows[0].iter().map(|cell| cell.trim()).collect::<Vec<_>>(), ["in the book", "changed"], "{said}");
    assert!(said.contains(".halton") && !said.contains(".jittered"), "{said}");
    let said = run(&["fig-points", "-p", "n=25"]);
    let row = said.lines().find(|line| line.starts_with("cells.max.jittered")).unwrap();
    assert_eq!(row.split_whitespace().collect::<Vec<_>>(), ["cells.max.jittered", "1", "1"], "{said}");
    let told = |arguments: &[&str]| {
        let json = run(&[&["tbl-estimates", "--format", "json"], arguments].concat());
        serde_json::from_str::<serde_json::Value>(&json).unwrap()
    };
    let (plain, changed) = (told(&[]), told(&["-p", "n=\"2^2..2^3\"", "-p", "seed=5", "-p", "integrand=x*x"]));
    assert_eq!(changed["parameters"]["n"], serde_json::json!([4, 8]));
    assert_eq!((&changed["seed"], &plain["seed"]), (&serde_json::json!(5), &serde_json::json!(1)));
    assert!((changed["values"]["exact"].as_f64().unwrap() - 1.0 / 3.0).abs() < 1e-9, "{changed}");
    assert_eq!(told(&["-p", "n=[4, 16]"])["values"], plain["values"], "the same question has the same answer");
    let table = run(&["tbl-estimates", "--format", "csv", "-p", "n=[4, 64]"]);
    assert!(table.lines().any(|line| line.starts_with("64,")), "{table}");
    // Nothing of this is left in the book, and the cache knows the exhibits as they are there.
    assert!(course.book() == book);
    assert!(course.fine(&["why", "fig-points"]).out.starts_with("fig-points is fresh"));
    assert!(course.fine(&["build"]).err.contains("nothing changed in"));
}

#[test]
fn a_wrong_change_is_told_by_its_parameter() {
    let course = small();
    let told = |change: &str| {
        let said = course.say(&["run", "fig-points", "-p", change]);
        assert_eq!((said.exit, said.out.as_str()), (2, ""), "{change}: {}", said.err);
        said.err
    };
    let count = told("n=17");
    assert!(count.contains("--> fig-points -p n=17:4:5") && count.contains("nearest counts are 16 and 25"), "{count}");
    assert!(told("samplers=haltn").contains("did you mean `halton`?"));
    let unknown = told("smaplers=halton");
    assert!(unknown.contains("unknown key `smaplers`") && unknown.contains("did you mean `samplers`?"), "{unknown}");
    assert!(told("n=[16").contains("`[16` is no TOML"));
    assert!(told("n").contains("name=value"));
    for fixed in ["id=fig-other", "kind=histogram", "caption=x", "claims={}"] {
        assert!(told(fixed).contains("is no parameter"), "{fixed}");
    }
}

#[test]
fn list_names_every_catalogue() {
    let course = small();
    let first: [(&str, &[&str]); 5] = [
        ("samplers", &["independent", "halton", "sobol"]),
        ("scrambles", &["xor"]),
        ("integrands", &["exp-sin", "disk"]),
        ("kinds", &["convergence", "points"]),
        ("exhibits", &["fig-points", "tbl-estimates"]),
    ];
    for (catalogue, names) in first {
        let said = course.fine(&["list", catalogue]);
        for name in names {
            assert!(said.out.lines().any(|line| line.split(' ').next() == Some(name)), "{name} in {}", said.out);
        }
        let json = course.fine(&["list", catalogue, "--format", "json"]);
        let list: serde_json::Value = serde_json::from_str(&json.out).unwrap();
        assert_eq!(list.as_array().unwrap().len(), said.out.lines().count());
    }
    let said = course.fine(&["list", "kinds", "convergence"]);
    assert!(said.out.contains("replicates") && said.out.contains("default 64"), "{}", said.out);
}

#[test]
fn clean_removes_what_the_course_no_longer_uses_or_all() {
    let course = small();
    course.fine(&["build", "--quiet"]);
    course.edit("chapters/01-one.md", "n = 16\n", "n = 25\n");
    course.fine(&["build", "--quiet"]);
    let results = || tree(&course.path(".workbook/cache/results")).len();
    assert_eq!(results(), 3);
    course.edit("chapters/01-one.md", "Some prose.", "@fig-nowhere");
    assert_eq!(course.say(&["clean", "--stale", "--quiet"]).exit, 1);
    assert_eq!(results(), 3, "while the course is wrong it is not known what it uses");
    course.edit("chapters/01-one.md", "@fig-nowhere", "Some prose.");
    course.fine(&["clean", "--stale", "--quiet"]);
    assert_eq!(results(), 2);
    assert!(course.fine(&["build"]).err.contains("0 of 2 experiments ran"));
    course.write(".workbook/notes.txt", "not of the cache");
    course.fine(&["clean", "--quiet"]);
    assert_eq!(tree(&course.path(".workbook")).keys().collect::<Vec<_>>(), ["notes.txt"]);
}
