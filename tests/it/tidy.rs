//! The rules of the house, as tests: what every file has, who may use whom, and what must be nowhere.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use workbook::catalogue::About;
use workbook::integrands::INTEGRANDS;
use workbook::kinds::KINDS;
use workbook::metrics::METRICS;
use workbook::samplers::SAMPLERS;
use workbook::scenes::SCENES;
use workbook::scrambles::SCRAMBLES;
use workbook::workspace::extension;

use crate::course::PACKAGE;

/// The parts of the library from the lowest to the highest: a part uses only what is below it. Those in one line may use each other.
const LAYERS: &[&[&str]] = &[
    &["catalogue", "vectors", "points", "seed", "stats", "samplers", "scrambles", "integrands", "metrics", "scenes"],
    &["diag"],
    &["explain"],
    &["raster", "sources", "workspace"],
    &["parameters"],
    &["chart"],
    &["kinds"],
    &["parse"],
    &["generate"],
    &["plan"],
    &["run"],
    &["exhibits"],
    &["render"],
    &["write"],
    &["receipt"],
    &["verify"],
    &["compare", "starter", "schema"],
    &["compose"],
    &["serve"],
    &["cli"],
];

/// Files in the folders of catalogues that are no entries: what entries share.
const SHARED: &[&str] = &[
    "samplers/axes.rs",
    "samplers/batch.rs",
    "samplers/digits.rs",
    "samplers/enumeration.rs",
    "samplers/method.rs",
    "samplers/poisson.rs",
    "samplers/refused.rs",
    "samplers/regular.rs",
    "samplers/settings.rs",
    "samplers/sides.rs",
    "samplers/sobol",
    "scrambles/fixed.rs",
    "scrambles/walk.rs",
    "integrands/expression",
    "integrands/function.rs",
    "integrands/genz.rs",
    "scenes/film",
    "scenes/tracer",
    "metrics/occupancy.rs",
    "metrics/spectrum.rs",
    "metrics/star_bound.rs",
    "metrics/star_space.rs",
    "metrics/star_sweep.rs",
    "kinds/bugs",
    "kinds/estimation",
    "kinds/experiment",
    "kinds/imaging",
    "kinds/point_bugs",
    "kinds/steps",
    "kinds/measuring.rs",
    "kinds/placing.rs",
    "kinds/radical.rs",
    "kinds/worst_box.rs",
];

/// Folders that are made, not written.
const MADE: &[&str] = &[
    ".git",
    "target",
    "book",
    "book-student",
    ".workbook",
    "guide/book",
    "guide/.workbook",
    "tests/browser/node_modules",
];

/// The most lines of a file that are not empty.
const LONGEST: usize = 400;

/// Every committed text by its path in the package; files that are no text are left out.
fn texts() -> BTreeMap<String, String> {
    let mut texts = BTreeMap::new();
    let mut folders = vec![Path::new(PACKAGE).to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(PACKAGE).unwrap().to_str().unwrap().replace('\\', "/");
            if MADE.contains(&name.as_str()) {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else if let Ok(text) = fs::read_to_string(&path) {
                texts.insert(name, text);
            }
        }
    }
    texts
}

/// The Rust files, by their paths.
fn rust() -> BTreeMap<String, String> {
    let rust: BTreeMap<_, _> = texts().into_iter().filter(|(path, _)| extension(path) == Some("rs")).collect();
    assert!(rust.len() > 100 && rust.contains_key("src/lib.rs") && rust.contains_key("tests/it/tidy.rs"));
    rust
}

/// The library's code by its path below `src/`, without comments and tests.
fn library() -> BTreeMap<String, String> {
    let files = rust().into_iter().filter_map(|(path, text)| {
        let path = path.strip_prefix("src/").filter(|path| !path.ends_with("tests.rs"))?;
        let text = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        let code: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        Some((path.to_owned(), code.join("\n")))
    });
    files.collect()
}

/// The parts of the library that a file uses: `a` and `b` in `crate::a::x` and `crate::{a::x, b}`.
fn used(code: &str) -> BTreeSet<&str> {
    let mut parts = BTreeSet::new();
    for (at, _) in code.match_indices("crate::") {
        let rest = &code[at + "crate::".len()..];
        let mut depth = 0_usize;
        let mut first = true;
        for word in rest.split_inclusive(['{', '}', ',', ';', ':']) {
            let name = word.trim_end_matches(['{', '}', ',', ';', ':']).trim();
            let name = &name[..name.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(name.len())];
            if !name.is_empty() && first && depth <= 1 {
                parts.insert(name);
                first = false;
            }
            match word.chars().last() {
                Some('{') => depth += 1,
                Some('}') => depth = depth.saturating_sub(1),
                Some(',') if depth == 1 => first = true,
                _ => {}
            }
            if depth == 0 && (word.ends_with(['}', ';', ',']) || !first) {
                break;
            }
        }
    }
    parts
}

/// Whether `name` stands in `code` as a word of its own at its start.
fn holds(code: &str, name: &str) -> bool {
    code.match_indices(name).any(|(at, _)| !code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_'))
}

/// The files of the library that hold one of `names` without being below one of `allowed`.
fn strays(names: &[&str], allowed: &[&str]) -> Vec<String> {
    let library = library();
    assert!(allowed.iter().all(|allowed| library.keys().any(|path| path.starts_with(allowed))), "{allowed:?}");
    let stray = |(path, code): &(&String, &String)| {
        !allowed.iter().any(|allowed| path.starts_with(allowed)) && names.iter().any(|name| holds(code, name))
    };
    library.iter().filter(stray).map(|(path, _)| path.clone()).collect()
}

fn none(found: &[String], rule: &str) {
    assert!(found.is_empty(), "{rule}: {found:#?}");
}

#[test]
fn every_file_says_first_what_it_is() {
    let silent = |(path, text): (String, String)| {
        let comment: Vec<&str> = text.lines().map_while(|line| line.strip_prefix("//!")).collect();
        let paragraph = comment.split(|line| line.trim().is_empty()).next().unwrap_or_default().join(" ");
        let sentence = paragraph.trim();
        let sound = sentence.ends_with('.') && sentence.starts_with(|c: char| c.is_uppercase() || c == '`');
        (!sound).then_some(path)
    };
    none(&rust().into_iter().filter_map(silent).collect::<Vec<_>>(), "a file begins with `//!` and a full sentence");
}

#[test]
fn no_file_is_long() {
    let lines = |text: &str| text.lines().filter(|line| !line.trim().is_empty()).count();
    let long = rust().into_iter().filter(|(_, text)| lines(text) > LONGEST);
    none(&long.map(|(path, text)| format!("{path}: {}", lines(&text))).collect::<Vec<_>>(), "files are short");
}

#[test]
fn nothing_is_left_to_do() {
    let marks = ["TO", "FIX", "XX"].map(|mark| {
        format!(
            "{mark}{}",
            if mark == "TO" {
                "DO"
            } else if mark == "FIX" {
                "ME"
            } else {
                "X"
            }
        )
    });
    let calls = ["dbg", "todo", "unimplemented"].map(|call| format!("{call}!("));
    let marked = |(path, text): (String, String)| {
        let found = marks.iter().chain(&calls).any(|mark| holds(&text, mark));
        found.then_some(path)
    };
    none(&rust().into_iter().filter_map(marked).collect::<Vec<_>>(), "nothing is left to do");
}

#[test]
fn only_the_command_line_prints_and_exits() {
    let names =
        ["print!", "println!", "eprint!", "eprintln!", "stdout()", "stderr()", "process::exit", "process::abort"];
    none(&strays(&names, &["cli/"]), "only `cli` prints and exits");
}

#[test]
fn only_the_ends_and_the_cache_touch_the_disk() {
    let names = ["std::fs", "fs::", "File::open", "File::create", "OpenOptions"];
    let allowed = [
        "workspace.rs",
        "workspace/revision.rs",
        "workspace/watch.rs",
        "run/cache.rs",
        "receipt.rs",
        "write.rs",
        "write/",
        "verify/mod.rs",
    ];
    none(&strays(&names, &allowed), "only the workspace, the cache, the writer and the lock's reader touch the disk");
}

#[test]
fn only_the_workspace_runs_other_programs() {
    // The command line asks for a browser, if that is wanted.
    let allowed = ["workspace/", "cli/serve.rs"];
    none(&strays(&["process::Command", "Command::new"], &allowed), "only the workspace asks another program");
}

#[test]
fn crates_stay_in_their_parts() {
    none(&strays(&["plotters"], &["chart"]), "plotters is used only in `chart`");
    none(&strays(&["tera"], &["render/"]), "tera is used only in `render`");
    none(
        &strays(&["pulldown_cmark"], &["parse/", "plan/", "render/"]),
        "markdown is read in `parse`, `plan` and `render`",
    );
    none(&strays(&["clap", "indicatif", "annotate_snippets"], &["cli/"]), "only `cli` knows the command line");
    none(&strays(&["rayon"], &["run/", "kinds/"]), "only the run and the kinds use threads");
}

#[test]
fn nothing_ambient_is_used() {
    let names =
        ["SystemTime", "std::env::", "env::var", "HashMap", "HashSet", "thread_rng", "rand::rng()", "Instant::now"];
    let told = strays(&names, &["cli/", "compose.rs", "run/mod.rs"]);
    none(&told, "no clock, environment, ambient randomness or unordered map in what computes or renders");
}

#[test]
fn a_part_uses_only_what_is_below_it() {
    let rank = |part: &str| LAYERS.iter().position(|layer| layer.contains(&part));
    let mut upward = Vec::new();
    for (path, code) in library() {
        let part = path.split('/').next().unwrap_or_default().trim_end_matches(".rs");
        if ["lib", "main"].contains(&part) {
            continue;
        }
        let own = rank(part).unwrap_or_else(|| panic!("`{part}` has no place in the order of the parts"));
        for used in used(&code).into_iter().filter(|used| *used != part) {
            // Macros of the crate stand at its root.
            let Some(of) = rank(used) else { continue };
            if of > own || (of == own && own > 0) {
                upward.push(format!("{path} uses {used}"));
            }
        }
    }
    none(&upward, "a part uses only what is below it");
}

#[test]
fn uses_are_seen_in_every_form() {
    let code = "use crate::plan::{Exhibit, Plan};\nuse crate::{exhibits, render::{a, b}, run};\nlet x = crate::seed::Seed::new(1);\n\
                fn f(x: crate::points::Points, y: u8) {}\nuse crate::diag::any_error;\nuse crate::compose;";
    let found: Vec<&str> = used(code).into_iter().collect();
    assert_eq!(found, ["compose", "diag", "exhibits", "plan", "points", "render", "run", "seed"]);
}

/// Every catalogue: its folder, and what its entries say of themselves.
fn catalogues() -> [(&'static str, Vec<&'static About>); 6] {
    [
        ("samplers", SAMPLERS.iter().map(|entry| entry.about()).collect()),
        ("scrambles", SCRAMBLES.iter().map(|entry| entry.about()).collect()),
        ("integrands", INTEGRANDS.iter().map(|entry| entry.about()).collect()),
        ("metrics", METRICS.iter().map(|entry| entry.about()).collect()),
        ("scenes", SCENES.iter().map(|entry| entry.about()).collect()),
        ("kinds", KINDS.iter().map(|entry| entry.about()).collect()),
    ]
}

#[test]
fn every_file_of_a_catalogue_is_an_entry_or_is_shared() {
    for (folder, abouts) in catalogues() {
        let mut files: BTreeSet<String> = abouts.iter().map(|about| about.file.to_owned()).collect();
        files.extend(
            SHARED.iter().filter(|file| file.starts_with(&format!("{folder}/"))).map(|file| (*file).to_owned()),
        );
        files.insert(format!("{folder}/mod.rs"));
        let found = fs::read_dir(Path::new(PACKAGE).join("src").join(folder)).unwrap();
        let found: BTreeSet<String> =
            found.map(|entry| format!("{folder}/{}", entry.unwrap().file_name().to_str().unwrap())).collect();
        let unlisted: Vec<_> = found.difference(&files).collect();
        let absent: Vec<_> = files.difference(&found).collect();
        assert!(unlisted.is_empty() && absent.is_empty(), "{folder}: not listed {unlisted:?}, not there {absent:?}");
    }
}

#[test]
fn an_entry_adds_two_lines_and_nothing_else() {
    let library = library();
    for (folder, abouts) in catalogues() {
        let list = &library[&format!("{folder}/mod.rs")];
        for about in &abouts {
            let name =
                about.file.strip_prefix(&format!("{folder}/")).and_then(|file| file.strip_suffix(".rs")).unwrap();
            let lines: Vec<&str> =
                list.lines().map(str::trim).filter(|line| line.ends_with(&format!("mod {name};"))).collect();
            assert_eq!(lines.len(), 1, "the module of {}", about.file);
            let listed = list.matches(&format!("&{name}::")).count();
            let path = format!("{name}::");
            let named = list.match_indices(&path);
            let named =
                named.filter(|(at, _)| !list[..*at].ends_with(|c: char| c.is_alphanumeric() || c == '_')).count();
            // A file may hold a family of entries that are one formula with one thing changed.
            let family = abouts.iter().filter(|other| other.file == about.file).count();
            assert_eq!((listed, named), (family, family), "the line of {} in the catalogue", about.file);
        }
    }
}

#[test]
fn keys_are_unique_and_every_method_has_a_paper() {
    for (folder, abouts) in catalogues() {
        let keys: BTreeSet<&str> = abouts.iter().map(|about| about.key).collect();
        assert_eq!(keys.len(), abouts.len(), "two entries of {folder} have the same key");
        for about in abouts {
            let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
            assert!(!about.key.is_empty() && about.key.chars().all(plain), "{}", about.key);
            assert!(!about.title.is_empty() && about.summary.ends_with('.'), "{}: {}", about.key, about.summary);
            if ["samplers", "scrambles", "scenes"].contains(&folder) {
                assert!(!about.papers.is_empty(), "{} has no paper", about.key);
            }
            for paper in about.papers {
                assert!(!paper.authors.is_empty() && !paper.title.is_empty() && paper.year > 1600, "{}", about.key);
            }
        }
    }
}

#[test]
fn no_text_names_a_machine() {
    // Put together here, so that this file does not name them itself.
    let folders = ["work", "home", "root", "Users", "tmp", "build", "mnt"].map(|folder| format!("/{folder}/"));
    let texts = texts();
    assert!(texts.contains_key("Cargo.lock") && texts.contains_key("chapters/workbook.toml"));
    let named = |(path, text): (&String, &String)| {
        let absolute = |at: usize| !text[..at].ends_with(|c: char| c.is_alphanumeric() || "./_-}*)>".contains(c));
        let found = folders.iter().find(|folder| text.match_indices(folder.as_str()).any(|(at, _)| absolute(at)));
        found.map(|folder| format!("{path}: {folder}"))
    };
    none(&texts.iter().filter_map(named).collect::<Vec<_>>(), "no committed text names a folder of some machine");
    let sources: BTreeSet<&str> =
        texts["Cargo.lock"].lines().filter_map(|line| line.strip_prefix("source = ")).collect();
    let indexed = sources.iter().all(|source| source.starts_with("\"registry+https://"));
    assert!(sources.len() == 1 && indexed, "packages are locked to one public index: {sources:?}");
    let configured: Vec<_> = texts.keys().filter(|path| path.starts_with(".cargo/")).cloned().collect();
    none(&configured, "no machine's settings are committed");
}
