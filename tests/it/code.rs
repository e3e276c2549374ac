//! The code that keys see: every entry of every catalogue, each by itself.

use std::collections::BTreeSet;

use workbook::catalogue::About;
use workbook::integrands::INTEGRANDS;
use workbook::kinds::KINDS;
use workbook::metrics::METRICS;
use workbook::samplers::SAMPLERS;
use workbook::scrambles::SCRAMBLES;
use workbook::sources as code;

fn abouts() -> Vec<&'static About> {
    let samplers = SAMPLERS.iter().map(|entry| entry.about());
    let scrambles = SCRAMBLES.iter().map(|entry| entry.about());
    let integrands = INTEGRANDS.iter().map(|entry| entry.about());
    let metrics = METRICS.iter().map(|entry| entry.about());
    samplers.chain(scrambles).chain(integrands).chain(metrics).chain(KINDS.iter().map(|kind| kind.about())).collect()
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
