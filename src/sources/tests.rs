//! Tests of the digests over small tables of sources.

use std::collections::BTreeMap;

use super::analysis::not_computing;
use super::*;

const LOCK: &str = "version = 4\n\n[[package]]\nname = \"rand\"\nversion = \"0.10.0\"\nsource = \"registry\"\nchecksum = \"ab\"\n\n\
                    [[package]]\nname = \"workbook\"\nversion = \"0.1.0\"\ndependencies = [\n \"rand\",\n]\n";

const SAMPLERS: &str = "//! Samplers.\nmod halton;\nmod sobol;\npub mod method;\n\
                        pub static SAMPLERS: &[&dyn Sampler] = &[&halton::HALTON, &sobol::SOBOL];\n";

const KINDS: &str = "mod table;\nmod points;\npub static KINDS: &[&dyn AnyKind] = &[&table::TABLE, &points::POINTS];\n";

const POINTS: &str = "use super::Kind;\nfn run() {}\n\nmod drawing {\n    fn draw() { '}'; }\n}\n\n\
                      #[cfg(test)]\nmod tests {\n    fn t() {}\n}\n";

fn table() -> BTreeMap<String, String> {
    [
        ("catalogue.rs", "pub trait Entry {}"),
        ("diag.rs", "pub struct Diagnostic;"),
        ("points.rs", "pub struct Points;"),
        ("samplers/mod.rs", SAMPLERS),
        ("samplers/halton.rs", "pub fn radical_inverse() {}"),
        ("samplers/method.rs", "pub struct Method;"),
        ("samplers/sobol.rs", "use crate::points::Points;"),
        ("samplers/sobol/directions.txt", "1 0 0"),
        ("kinds/mod.rs", KINDS),
        ("kinds/table.rs", "use crate::samplers::halton::radical_inverse;\nuse crate::points::Points;"),
        ("kinds/points.rs", POINTS),
        ("render/mod.rs", "pub fn render() {}"),
        ("stats/moments.rs", "pub fn mean() {}"),
    ]
    .map(|(file, text)| (file.to_owned(), text.to_owned()))
    .into()
}

/// Everything that a key can see of a table: the engine, and each entry's code.
fn seen(table: &BTreeMap<String, String>) -> BTreeMap<&'static str, String> {
    let sources = Sources::new(table.iter().map(|(file, text)| (file.as_str(), text.as_bytes())), LOCK).table();
    let mut seen = BTreeMap::from([("engine", sources.engine.to_string())]);
    for file in ["samplers/halton.rs", "samplers/sobol.rs", "kinds/table.rs", "kinds/points.rs"] {
        seen.insert(file, format!("{:?}", sources.code([file])));
    }
    seen
}

/// What a key sees differently after `change`.
fn changed(change: impl FnOnce(&mut BTreeMap<String, String>)) -> Vec<&'static str> {
    let before = seen(&table());
    let mut after = table();
    change(&mut after);
    let after = seen(&after);
    before.iter().filter(|(part, digest)| after.get(*part) != Some(digest)).map(|(part, _)| *part).collect()
}

fn edit(file: &'static str, from: &'static str, to: &'static str) -> impl FnOnce(&mut BTreeMap<String, String>) {
    move |table| {
        let text = table.get_mut(file).unwrap();
        assert!(text.contains(from), "{from}");
        *text = text.replacen(from, to, 1);
    }
}

#[test]
fn an_entry_changes_what_uses_it_and_nothing_else() {
    assert_eq!(changed(edit("samplers/halton.rs", "{}", "{ 1 }")), ["kinds/table.rs", "samplers/halton.rs"]);
    assert_eq!(changed(edit("samplers/sobol.rs", "Points", "Rows")), ["samplers/sobol.rs"]);
    assert_eq!(changed(edit("samplers/sobol/directions.txt", "1", "2")), ["samplers/sobol.rs"]);
    assert_eq!(changed(edit("kinds/points.rs", "fn run() {}", "fn run() { 1 }")), ["kinds/points.rs"]);
}

#[test]
fn the_engine_is_all_else_that_computes() {
    for file in ["points.rs", "samplers/method.rs", "stats/moments.rs", "catalogue.rs"] {
        assert_eq!(changed(edit(file, "pub", "pub(crate)")), ["engine"], "{file}");
    }
    assert_eq!(changed(edit("samplers/mod.rs", "pub mod method;", "mod method;")), ["engine"]);
    assert_eq!(changed(|table| drop(table.insert("fields/mod.rs".into(), "fn new() {}".into()))), ["engine"]);
    assert!(changed(edit("render/mod.rs", "{}", "{ 1 }")).is_empty());
    assert!(changed(edit("diag.rs", ";", "(u8);")).is_empty());
}

#[test]
fn an_entry_that_the_engine_uses_is_part_of_it() {
    let mut table = table();
    edit("stats/moments.rs", "{}", "{ crate::samplers::halton::radical_inverse() }")(&mut table);
    let before = seen(&table);
    edit("samplers/halton.rs", "{}", "{ 1 }")(&mut table);
    assert_ne!(before["engine"], seen(&table)["engine"]);
}

#[test]
fn a_module_that_uses_entries_counts_where_it_is_used() {
    let mut table = table();
    table.insert("samplers/link.rs".into(), "use super::halton; pub fn link() {}".into());
    edit("samplers/mod.rs", "pub mod method;", "pub mod method;\npub mod link;")(&mut table);
    let differ =
        |change: &dyn Fn(&mut BTreeMap<String, String>), table: &BTreeMap<String, String>| -> Vec<&'static str> {
            let (before, mut after) = (seen(table), table.clone());
            change(&mut after);
            let after = seen(&after);
            before.into_iter().filter(|(part, digest)| after.get(part) != Some(digest)).map(|(part, _)| part).collect()
        };
    let halton = |table: &mut BTreeMap<String, String>| edit("samplers/halton.rs", "{}", "{ 1 }")(table);
    let link = |table: &mut BTreeMap<String, String>| edit("samplers/link.rs", "{}", "{ 1 }")(table);
    assert_eq!(differ(&halton, &table), ["kinds/table.rs", "samplers/halton.rs"]);
    assert_eq!(differ(&link, &table), Vec::<&str>::new(), "nothing uses it");
    edit("kinds/points.rs", "fn run() {}", "fn run() { crate::samplers::link::link() }")(&mut table);
    assert_eq!(differ(&link, &table), ["kinds/points.rs"]);
    assert_eq!(differ(&halton, &table), ["kinds/points.rs", "kinds/table.rs", "samplers/halton.rs"]);
    // Through another module of this sort it counts there too, and still not for all.
    table.insert("samplers/chain.rs".into(), "use super::link; pub fn chain() {}".into());
    edit("samplers/mod.rs", "pub mod link;", "pub mod link;\npub mod chain;")(&mut table);
    edit("kinds/table.rs", "use", "use crate::samplers::chain;\nuse")(&mut table);
    assert_eq!(differ(&link, &table), ["kinds/points.rs", "kinds/table.rs"]);
    edit("stats/moments.rs", "{}", "{ crate::samplers::link::link() }")(&mut table);
    assert!(differ(&link, &table).contains(&"engine"));
    assert!(differ(&halton, &table).contains(&"engine"));
}

#[test]
fn drawing_and_tests_change_nothing() {
    assert!(changed(edit("kinds/points.rs", "fn draw() { '}'; }", "fn draw() { 2 }")).is_empty());
    assert!(changed(edit("kinds/points.rs", "fn t() {}", "fn t() { 1 }")).is_empty());
    assert!(changed(edit("samplers/halton.rs", "() {}", "() {}\r\n")).contains(&"samplers/halton.rs"));
    // What follows the drawing computes again, and a sampler has no drawing.
    assert_eq!(changed(edit("kinds/points.rs", "}\n\n#[cfg", "}\nfn more() {}\n#[cfg")), ["kinds/points.rs"]);
    assert!(!changed(edit("samplers/sobol.rs", "use", "mod drawing {}\nuse")).is_empty());
}

#[test]
fn a_new_entry_changes_nothing() {
    let added = |table: &mut BTreeMap<String, String>| {
        table.insert("samplers/faure.rs".into(), "fn points() {}".into());
        edit("samplers/mod.rs", "mod halton;", "mod faure;\nmod halton;")(table);
        edit(
            "samplers/mod.rs",
            "&[&halton::HALTON, &sobol::SOBOL]",
            "&[\n &halton::HALTON,\n &faure::FAURE,\n &sobol::SOBOL,\n]",
        )(table);
    };
    assert_eq!(changed(added), Vec::<&str>::new());
    let mut table = table();
    added(&mut table);
    let sources = Sources::new(table.iter().map(|(file, text)| (file.as_str(), text.as_bytes())), LOCK);
    assert!(sources.table().entries().any(|file| file == "samplers/faure.rs"));
    // Listed but not declared, or declared but not listed: no entry, so that it counts for all.
    assert_eq!(changed(|table| drop(table.insert("samplers/loose.rs".into(), String::new()))), ["engine"]);
}

#[test]
fn line_ends_do_not_matter() {
    let before = seen(&table());
    let after = table().into_iter().map(|(file, text)| (file, text.replace('\n', "\r\n"))).collect();
    assert_eq!(before, seen(&after));
}

#[test]
fn dependencies_leave_this_package_out() {
    let of = |lock: &str| Sources::new([], lock).table().dependencies;
    assert_eq!(of(LOCK), of(&LOCK.replace("0.1.0", "0.2.0")));
    assert_eq!(of(LOCK), of(&LOCK.replace('\n', "\r\n")));
    for other in ["0.10.1", "0.10.00"] {
        assert_ne!(of(LOCK), of(&LOCK.replace("0.10.0", other)));
    }
    assert_ne!(of(LOCK), of(&LOCK.replace("\"ab\"", "\"cd\"")));
    assert_ne!(of(LOCK), of(""));
}

#[test]
fn the_compiled_sources_are_embedded() {
    assert!(text("sources/analysis.rs").is_some_and(|text| text.contains("fn not_computing")));
    assert_eq!(text("nothing.rs"), None);
    assert_ne!(sources().dependencies, Sources::new([], "").table().dependencies);
    assert!(embedded::FILES.is_sorted());
}

/// The build script's reading is that of the very bytes that were embedded.
#[test]
fn the_table_of_the_build_is_that_of_the_embedded_sources() {
    let locked = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.lock"));
    let read = Sources::new(embedded::FILES.iter().copied(), locked).table();
    assert!(read.units.len() > 100 && read.files.len() == embedded::FILES.len());
    assert_eq!(&read, sources());
}

#[test]
fn every_part_of_the_library_is_known_to_compute_or_not() {
    let computing = [
        "catalogue.rs",
        "points.rs",
        "seed.rs",
        "samplers",
        "scrambles",
        "integrands",
        "metrics",
        "scenes",
        "raster.rs",
        "vectors.rs",
        "stats",
        "parameters",
        "kinds",
    ];
    for (file, _) in embedded::FILES.iter().filter(|(file, _)| !not_computing(file)) {
        let part = file.split('/').next().unwrap_or(file);
        assert!(computing.contains(&part), "{file}: can it change a number? Then name it here; else in NOT_COMPUTING");
    }
}

#[test]
fn a_locked_version_is_that_of_its_package() {
    assert_eq!((version(LOCK, "rand"), version(LOCK, "workbook")), (Some("0.10.0"), Some("0.1.0")));
    assert_eq!((version(LOCK, "ran"), version("", "rand")), (None, None));
    let twice = LOCK.replace("workbook", "rand");
    assert_eq!(version(&twice, "rand"), Some("0.1.0"), "the last of them");
    for package in ["rand", "pxfm", "plotters"] {
        assert!(locked(package).is_some_and(|version| version.starts_with('0')), "{package}");
    }
}
