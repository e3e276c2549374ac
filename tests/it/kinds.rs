//! The kinds: what they compute, that it is the same on any number of threads, and that nothing makes them panic.

use crate::asked::{holds, number, outcome};
use crate::parameters::plan;
use workbook::chart::{Drawing, Sheet};
use workbook::kinds::Outcome;

use workbook::seed::Seed;

const CONVERGENCE: &str = "kind = \"convergence\"\nintegrand = \"exp-sin\"\nn = \"2^4..2^8\"\nreplicates = 16\n";

#[test]
fn slopes_are_those_of_the_theory() {
    let fence = |samplers: &str, integrand: &str, n: &str| {
        format!("kind = \"convergence\"\nsamplers = {samplers}\nintegrand = \"{integrand}\"\nn = \"{n}\"\n")
    };
    let line = outcome(&fence("[\"independent\", \"jittered\"]", "exp-sin", "2^4..2^10"));
    assert!((number(&line, "slope.independent") + 0.5).abs() < 0.08);
    assert!((number(&line, "slope.jittered") + 1.5).abs() < 0.08);
    assert!((number(&line, "exact") - 1.776_099_045_242_843_7).abs() < 1e-15);
    assert!((number(&line, "sigma") - 0.600_214_543_929_141).abs() < 1e-12);
    let square = outcome(&fence("[\"independent\", \"jittered\", \"latin-hypercube\"]", "xy", "4^2..4^5"));
    assert!((number(&square, "slope.independent") + 0.5).abs() < 0.12);
    assert!((number(&square, "slope.jittered") + 1.0).abs() < 0.12);
    assert!((number(&square, "slope.latin-hypercube") + 0.5).abs() < 0.12);
}

#[test]
fn known_variances_are_met() {
    // The variances of the mean at N = 16: independent 7/2304, jittered 127/589824 for f = xy.
    let fence = "kind = \"convergence\"\nsamplers = [\"independent\", \"jittered\"]\nintegrand = \"xy\"\nn = 16\nreplicates = 4000";
    let outcome = outcome(fence);
    for (name, variance) in [("independent", 7.0 / 2304.0), ("jittered", 127.0 / 589_824.0)] {
        let ratio = number(&outcome, &format!("rmse.{name}.16")) / f64::sqrt(variance);
        assert!((ratio - 1.0).abs() < 0.06, "{name}: {ratio}");
    }
}

#[test]
fn the_number_of_threads_never_shows() {
    let fences = [
        format!("{CONVERGENCE}samplers = [\"independent\", \"sobol+xor\", \"halton\"]"),
        "kind = \"histogram\"\nintegrand = \"exp-sin\"\nreplicates = 200".to_owned(),
        "kind = \"running-mean\"\nintegrand = \"exp-sin\"\nruns = 7".to_owned(),
        "kind = \"estimate-table\"\nintegrand = \"exp-sin\"".to_owned(),
        "kind = \"points\"\nsamplers = [\"independent\", \"sobol+xor\"]".to_owned(),
    ];
    for fence in fences {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| outcome(&fence)).bytes
        };
        assert!(on(1) == on(4), "{fence}");
    }
}

#[test]
fn another_sampler_or_count_shifts_no_numbers() {
    let one = outcome(&format!("{CONVERGENCE}samplers = [\"independent\"]"));
    let two = outcome(&format!("{CONVERGENCE}samplers = [\"jittered\", \"independent\"]"));
    let more = outcome(&format!("{CONVERGENCE}samplers = [\"independent\"]").replace("2^8", "2^9"));
    for (name, measured) in one.values.iter().filter(|(name, _)| name.starts_with("rmse")) {
        assert_eq!(two.values.get(name), Some(measured), "{name}");
        assert_eq!(more.values.get(name), Some(measured), "{name}");
    }
    let few = outcome("kind = \"running-mean\"\nintegrand = \"exp-sin\"\nruns = 2");
    let many = outcome("kind = \"running-mean\"\nintegrand = \"exp-sin\"\nruns = 5");
    assert_eq!(few.values.get("end.independent.2"), many.values.get("end.independent.2"));
}

#[test]
fn outcomes_survive_a_round_trip_and_nothing_else_does() {
    let fence = format!("{CONVERGENCE}samplers = [\"independent\"]");
    let experiment = plan(&fence).expect("right");
    let outcome = experiment.run(Seed::new(1)).expect("it runs");
    assert_eq!(experiment.revive(outcome.bytes.clone()).as_ref(), Some(&outcome));
    for end in 0..outcome.bytes.len() {
        assert_eq!(experiment.revive(outcome.bytes[..end].to_vec()), None, "cut at {end}");
    }
    let mut long = outcome.bytes.clone();
    long.push(0);
    assert_eq!(experiment.revive(long), None);
    let sheet = Sheet::new("fig-a", "A", "B");
    let broken = Outcome { bytes: vec![1, 2, 3], values: outcome.values };
    assert!(experiment.draw(&broken, &sheet).is_err());
    assert_eq!(experiment.alt(&broken), None);
    assert!(experiment.tables(&broken).is_empty());
}

#[test]
fn the_deck_table_is_within_four_standard_errors() {
    let table = outcome("kind = \"estimate-table\"\nintegrand = \"exp-sin\"");
    assert_eq!(number(&table, "exact"), 1.776_099_045_242_843_7);
    assert!((number(&table, "variance") - 0.360_257_498_744_067).abs() < 1e-14);
    assert!(number(&table, "largest.z") < 4.0);
    let error = table.values.get("estimate.100").and_then(|measured| measured.standard_error).expect("an error");
    assert!((error - 0.060_021_454_392_914_1).abs() < 1e-12);
    let sequence = outcome("kind = \"estimate-table\"\nintegrand = \"exp-sin\"\nsampler = \"van-der-corput\"");
    assert!((number(&sequence, "estimate.100") - 1.773_676_336_328_305_7).abs() < 1e-12);
    assert_eq!(sequence.values.get("z.100"), None);
}

#[test]
fn the_function_knows_its_integral_and_extremes() {
    let curve = outcome("kind = \"function\"\nintegrand = \"exp-sin\"");
    assert!((number(&curve, "integral") - 1.776_099_045_242_843_7).abs() < 1e-12);
    assert!((number(&curve, "maximum") - std::f64::consts::E).abs() < 1e-12);
    assert!((number(&curve, "maximum.at") - (std::f64::consts::PI / 6.0).sqrt()).abs() < 1e-6);
    let parabola = outcome("kind = \"function\"\nintegrand = \"x^2\"\nfrom = -1\nto = 2");
    assert!((number(&parabola, "integral") - 3.0).abs() < 1e-12);
    assert!((number(&parabola, "variance") - 1.2).abs() < 1e-10, "(32 + 1)/5/3 - 1");
    assert!(number(&parabola, "minimum").abs() < 1e-12);
}

#[test]
fn histograms_meet_the_prediction() {
    let outcome = outcome("kind = \"histogram\"\nintegrand = \"exp-sin\"\nn = [1, 100]\nreplicates = 4000");
    let ratio = number(&outcome, "deviation.100") / number(&outcome, "predicted.100");
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
    assert!((number(&outcome, "within.100") - 0.9545).abs() < 0.015);
}

#[test]
fn strata_are_counted() {
    let fence = "kind = \"points\"\nsamplers = [\"independent\", \"jittered\", \"latin-hypercube\", \"sobol\"]\nn = 64";
    let sets = outcome(fence);
    assert!(holds(&sets, "one-per-cell.jittered") && !holds(&sets, "one-per-cell.independent"));
    assert!(holds(&sets, "one-per-slab.latin-hypercube") && !holds(&sets, "one-per-slab.jittered"));
    assert!(holds(&sets, "one-per-cell.sobol") && holds(&sets, "one-per-slab.sobol"));
    assert_eq!(number(&sets, "cells.empty.sobol"), 0.0);
    assert!(number(&sets, "distance.jittered") > 0.0);
    let line = outcome("kind = \"points\"\nsampler = \"van-der-corput\"\nn = 8\ndimensions = 1");
    assert_eq!(number(&line, "distance.van-der-corput"), 0.125);
}

#[test]
fn the_van_der_corput_table_is_exact() {
    let table = outcome("kind = \"van-der-corput-table\"");
    for (n, phi) in [(1, 0.5), (2, 0.25), (3, 0.75), (6, 0.375), (16, 0.03125)] {
        assert_eq!(number(&table, &format!("phi.{n}")), phi);
    }
    for base in [2, 3, 5, 10, 36] {
        assert!(
            holds(&outcome(&format!("kind = \"van-der-corput-table\"\nn = 1024\nbase = {base}")), "agrees"),
            "{base}"
        );
    }
}

/// Every fence gives a drawing or a failure with words, and never a panic.
#[test]
fn degenerate_questions_are_answered_or_refused_in_words() {
    let fences = [
        (true, "kind = \"convergence\"\nsamplers = \"independent\"\nintegrand = \"exp-sin\"\nn = 1\nreplicates = 2"),
        (
            true,
            "kind = \"convergence\"\nsamplers = [\"halton\", \"sobol\"]\nintegrand = \"xy\"\nn = [1, 2]\nreplicates = 2",
        ),
        (false, "kind = \"convergence\"\nsamplers = \"independent\"\nintegrand = \"2\""),
        (false, "kind = \"convergence\"\nsamplers = \"independent\"\nintegrand = \"ln(x-2)\""),
        (false, "kind = \"convergence\"\nsamplers = \"independent\"\nintegrand = \"1/x\""),
        (true, "kind = \"estimate-table\"\nintegrand = \"2\""),
        (true, "kind = \"estimate-table\"\nintegrand = \"exp-sin\"\nn = 1"),
        (false, "kind = \"estimate-table\"\nintegrand = \"sqrt(x-0.5)\""),
        (true, "kind = \"function\"\nintegrand = \"0\""),
        (true, "kind = \"function\"\nintegrand = \"x < 0.3\""),
        (true, "kind = \"function\"\nintegrand = \"1e300*x\""),
        (false, "kind = \"function\"\nintegrand = \"ln(x-2)\""),
        (false, "kind = \"function\"\nintegrand = \"1/(x-0.5)\""),
        (true, "kind = \"running-mean\"\nintegrand = \"2\"\nn = 2\nruns = 1"),
        (true, "kind = \"running-mean\"\nintegrand = \"xy\"\nsamplers = [\"halton\", \"independent\"]\nn = 3"),
        (false, "kind = \"running-mean\"\nintegrand = \"ln(x-2)\""),
        (false, "kind = \"histogram\"\nintegrand = \"2\""),
        (true, "kind = \"histogram\"\nintegrand = \"step\"\nn = [1, 2]\nreplicates = 10\nbins = 2"),
        (false, "kind = \"histogram\"\nintegrand = \"ln(x-2)\"\nreplicates = 10"),
        (true, "kind = \"points\"\nsamplers = \"independent\"\nn = 1\nstrata = \"cells\"\nlabels = true"),
        (true, "kind = \"points\"\nsamplers = \"independent\"\nn = 4096\nstrata = \"slabs\""),
        (true, "kind = \"points\"\nsamplers = \"jittered\"\nn = 7\ndimensions = 1\nstrata = \"slabs\""),
        (true, "kind = \"van-der-corput-table\"\nn = 1\nbase = 36"),
    ];
    for (good, fence) in fences {
        let experiment = plan(fence).unwrap_or_else(|complaints| panic!("{fence}: {complaints:#?}"));
        let sheet = Sheet::new("fig-a", "A title", "A description");
        match experiment.run(Seed::new(1)) {
            Ok(outcome) => {
                assert!(good, "{fence}: {:?}", outcome.values);
                let drawn = experiment.draw(&outcome, &sheet).unwrap_or_else(|failure| panic!("{fence}: {failure:?}"));
                match drawn {
                    Drawing::Figure(figure) => assert!(figure.svg.contains("<svg"), "{fence}"),
                    Drawing::Table(table) => assert!(!table.rows.is_empty(), "{fence}"),
                    Drawing::Pictures(pictures) => assert!(!pictures.items.is_empty(), "{fence}"),
                    Drawing::Stepper(stepper) => assert!(!stepper.captions.is_empty(), "{fence}"),
                }
                let alt = experiment.alt(&outcome).unwrap_or_default();
                assert!(alt.ends_with('.') && !alt.contains("NaN") && !alt.contains("inf"), "{fence}: {alt}");
                let frames = experiment.tables(&outcome);
                assert!(
                    frames.iter().all(|frame| frame.columns.iter().all(|(_, e)| e.len() == frame.rows())),
                    "{fence}"
                );
            }
            Err(failure) => {
                assert!(!good && failure.message.len() > 20 && failure.help.is_some(), "{fence}: {failure:?}");
                assert_eq!(failure.parameter, Some("integrand"), "{fence}");
            }
        }
    }
}

#[test]
fn keys_name_the_sources_that_a_run_uses() {
    let files =
        |fence: &str| -> Vec<&str> { plan(fence).expect("right").abouts().iter().map(|about| about.file).collect() };
    let files_of = files(&format!("{CONVERGENCE}samplers = [\"sobol+xor\", \"sobol\", \"halton\"]"));
    let expected =
        ["integrands/deck.rs", "kinds/convergence.rs", "samplers/halton.rs", "samplers/sobol.rs", "scrambles/xor.rs"];
    assert_eq!(files_of, expected);
    assert!(files("kind = \"van-der-corput-table\"").contains(&"samplers/van_der_corput.rs"));
    assert!(files("kind = \"van-der-corput-table\"\nbase = 3").contains(&"samplers/halton.rs"));
}
