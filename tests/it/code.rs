//! The code that keys see: every entry of every catalogue, each by itself.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use rayon::prelude::*;
use workbook::catalogue::About;
use workbook::integrands::INTEGRANDS;
use workbook::kinds::KINDS;
use workbook::metrics::METRICS;
use workbook::plan::Exhibit;
use workbook::samplers::SAMPLERS;
use workbook::scenes::SCENES;
use workbook::scrambles::SCRAMBLES;
use workbook::sources as code;

use crate::course::{Course, PACKAGE, tree};

fn abouts() -> Vec<&'static About> {
    let samplers = SAMPLERS.iter().map(|entry| entry.about());
    let scrambles = SCRAMBLES.iter().map(|entry| entry.about());
    let integrands = INTEGRANDS.iter().map(|entry| entry.about());
    let metrics = METRICS.iter().map(|entry| entry.about());
    let scenes = SCENES.iter().map(|entry| entry.about());
    let kinds = KINDS.iter().map(|kind| kind.about());
    samplers.chain(scrambles).chain(integrands).chain(metrics).chain(scenes).chain(kinds).collect()
}

#[test]
fn the_entries_that_the_sources_show_are_those_of_the_catalogues() {
    let listed: BTreeSet<&str> = abouts().iter().map(|about| about.file).collect();
    assert_eq!(code::sources().entries().collect::<BTreeSet<_>>(), listed);
}

#[test]
fn an_entry_states_the_text_that_was_compiled() {
    for about in abouts() {
        assert_eq!(code::text(about.file), Some(about.source), "{}", about.file);
        assert!(code::sources().code([about.file]).contains_key(about.file), "{}", about.file);
    }
}

#[test]
fn a_kind_computes_above_its_drawing() {
    for kind in KINDS {
        let about = kind.about();
        let drawing = about.source.split_once("\nmod drawing {\n").map(|(_, drawing)| drawing);
        assert!(drawing.is_some_and(|drawing| !drawing.contains("fn run(")), "{}", about.file);
    }
}

/// The exhibits of a course whose key differs once `from` is `to` in a file of the library.
fn run_anew(file: &str, from: &str, to: &str) -> Vec<String> {
    let course = Course::case("everything");
    let plan = course.compose(1).plan;
    let before = tree(&Path::new(PACKAGE).join("src"));
    let mut after = before.clone();
    let text = String::from_utf8(before[file].clone()).unwrap();
    assert!(text.contains(from), "`{from}` in {file}");
    after.insert(file.to_owned(), text.replacen(from, to, 1).into_bytes());
    let of = |files| -> Vec<_> {
        let files: &BTreeMap<String, Vec<u8>> = files;
        let files = files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice()));
        let sources = code::Sources::new(files, "").table();
        let seen = |exhibit: &Exhibit| {
            let files = exhibit.experiment.abouts().into_iter().map(|about| about.file);
            (sources.engine, sources.code(files))
        };
        plan.exhibits.iter().map(seen).collect()
    };
    let differ = of(&before).into_iter().zip(of(&after)).map(|(before, after)| before != after);
    plan.exhibits.iter().zip(differ).filter(|(_, differs)| *differs).map(|(exhibit, _)| exhibit.id.clone()).collect()
}

#[test]
fn a_changed_sampler_runs_what_uses_it_and_nothing_else() {
    let halton = run_anew("samplers/halton.rs", "fn numerator(&self, index: u64", "fn numerator(&self, index: u32");
    assert_eq!(halton, ["fig-errors", "fig-points", "tbl-inverses"]);
    let jittered = run_anew("samplers/jittered.rs", "fn points(", "fn points2(");
    assert_eq!(jittered, ["fig-errors", "fig-points", "fig-claimed", "fig-best"]);
}

#[test]
fn no_entry_is_part_of_the_engine() {
    let files = tree(&Path::new(PACKAGE).join("src"));
    let sources = |files: &BTreeMap<String, Vec<u8>>| {
        code::Sources::new(files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice())), "").table().engine
    };
    let engine = sources(&files);
    let entries: Vec<&str> = abouts().iter().map(|about| about.file).collect::<BTreeSet<_>>().into_iter().collect();
    let within = entries.par_iter().filter(|file| {
        let mut files = files.clone();
        files.get_mut(**file).unwrap().splice(0..0, b"// More.\n".iter().copied());
        sources(&files) != engine
    });
    // The fast paths that all digital samplers share hash as Owen's scrambling by a hash does.
    let known = ["scrambles/owen_hash.rs"];
    let within: Vec<&str> = within.copied().filter(|file| !known.contains(file)).collect();
    assert!(within.is_empty(), "a change of these would run every experiment: {within:?}");
}

#[test]
fn what_only_draws_or_tells_runs_nothing() {
    for (file, from) in [
        ("chart/palette.rs", "fn css"),
        ("render/pages.rs", "fn neighbour"),
        ("verify/site.rs", "fn check"),
        ("cli/build.rs", "fn run"),
    ] {
        assert_eq!(run_anew(file, from, "fn other"), Vec::<String>::new(), "{file}");
    }
    let kind = run_anew("kinds/points.rs", "\nmod drawing {\n", "\nmod drawing {\nconst MORE: u8 = 1;\n");
    assert_eq!(kind, Vec::<String>::new());
}

#[test]
fn what_all_experiments_share_runs_everything() {
    assert_eq!(run_anew("stats/moments.rs", "pub fn mean", "pub fn mean2").len(), 12);
    assert_eq!(run_anew("seed.rs", "pub fn uniform", "pub fn uniform2").len(), 12);
}
