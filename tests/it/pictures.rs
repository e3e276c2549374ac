//! The rendered pictures: what their errors are, that they are the same on any number of threads, and what is refused.

use crate::asked::{measured, number, outcome};
use crate::parameters::plan;
use workbook::chart::{Drawing, Sheet};
use workbook::seed::Seed;

const SMALL: &str = "kind = \"render\"\nwidth = 64\nheight = 48\nreference = 512\n";

#[test]
fn threads_never_show_in_a_picture() {
    let averaged = "kind = \"averaging\"\nsampler = \"sobol+owen-hash\"\nscene = \"soft-shadows\"\nruns = \"2^0..2^2\"\nn = 4\nreference = 16";
    for fence in [
        format!("{SMALL}show = [\"reference\", \"pictures\", \"differences\", \"spectra\"]\nn = 4"),
        averaged.to_owned(),
    ] {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| outcome(&fence))
        };
        assert!(on(1) == on(3), "{fence}");
    }
}

#[test]
fn the_reference_heeds_neither_samplers_nor_seeds() {
    let fence = |rest: &str| plan(&format!("{SMALL}scene = \"motion-blur\"\n{rest}")).expect("a plan");
    let one = fence("sampler = \"independent\"\nn = 1").run(Seed::new(1)).expect("it");
    let two = fence("samplers = [\"jittered\", \"sobol+owen\"]\nn = 4\npadded = true").run(Seed::new(2)).expect("it");
    for name in ["mean", "reference.error"] {
        assert_eq!(measured(&one, name), measured(&two, name));
    }
    assert!(number(&one, "reference.error") < 0.05 * number(&one, "rmse.independent"));
}

/// Stratified samples beat random ones by many standard errors, scrambled nets beat both, and nothing is biased.
#[test]
fn better_samplers_make_better_pictures() {
    for (scene, least) in [("soft-shadows", 1.4), ("depth-of-field", 1.2), ("motion-blur", 1.4)] {
        let samplers =
            "samplers = [\"independent\", \"padded-jittered\", \"larcher-pillichshammer+xor\", \"sobol+owen\"]";
        let size = "width = 128\nheight = 96";
        let outcome = outcome(&format!("kind = \"render\"\nscene = \"{scene}\"\n{size}\n{samplers}"));
        for sampler in ["padded-jittered", "larcher-pillichshammer+xor", "sobol+owen"] {
            let gain = measured(&outcome, &format!("gain.{sampler}"));
            let (value, error) = (gain.number().expect("it"), gain.standard_error.expect("an error"));
            assert!(value - 1.0 > 5.0 * error && value > least, "{scene} {sampler}: {value} {error}");
            let bias = measured(&outcome, &format!("bias.{sampler}"));
            assert!(
                bias.number().expect("it").abs() < 4.5 * bias.standard_error.expect("an error"),
                "{scene} {sampler}"
            );
        }
    }
}

/// Four times the samples halve the error of random samples.
#[test]
fn random_errors_halve_with_four_times_the_samples() {
    let outcome = outcome(&format!("{SMALL}sampler = \"independent\"\nn = [4, 16, 64]"));
    for (few, many) in [(4, 16), (16, 64)] {
        let gain = number(&outcome, &format!("rmse.independent.{few}"))
            / number(&outcome, &format!("rmse.independent.{many}"));
        assert!((gain - 2.0).abs() < 0.25, "{few}: {gain}");
    }
}

/// In the error of the same samples in every pixel neighbours are alike and low frequencies loud; independent pixels are flat.
#[test]
fn wrong_randomisations_make_patterns() {
    let outcome = outcome(
        "kind = \"render\"\nsampler = \"sobol\"\nrandomisation = [\"shift\", \"same\", \"tiled\"]\nwidth = 96\nheight = 72",
    );
    let value = |quantity: &str, randomisation: &str| measured(&outcome, &format!("{quantity}.sobol.{randomisation}"));
    let right = value("low", "shift");
    assert!((right.number().expect("it") - 1.0).abs() < 4.5 * right.standard_error.expect("an error"), "{right:?}");
    let alike = value("neighbours", "shift");
    assert!(alike.number().expect("it").abs() < 0.12, "{alike:?}");
    let (low, same) = (number(&outcome, "low.sobol.same"), number(&outcome, "neighbours.sobol.same"));
    assert!(low > 5.0 && same > 0.3, "{low} {same}");
    let (peak, tiled) = (number(&outcome, "peak.sobol.shift"), number(&outcome, "peak.sobol.tiled"));
    assert!(peak < 30.0 && tiled > 40.0, "{peak} {tiled}");
    assert_eq!(value("rmse", "same").standard_error, None, "pixels that are not independent give no standard error");
}

/// One image sample with sixteen light samples is worse at edges than sixteen of one each; random ones lose nothing in the penumbra.
#[test]
fn splitting_samples_the_lamp_and_not_the_image() {
    let outcome = outcome(&format!("{SMALL}sampler = \"jittered\"\nlight = [1, 4, 16]"));
    let error = |name: &str| number(&outcome, &format!("rmse.jittered.{name}"));
    assert!(error("1x16") > 1.3 * error("16x1"), "{} {}", error("1x16"), error("16x1"));
    assert!(error("4x4") < error("1x16"));
}

/// Two zones that share the picture between them err on average as much as the picture, and what a lone zone tells is its own.
#[test]
fn zones_share_the_error_of_the_picture() {
    let fence = |zones: &str| outcome(&format!("{SMALL}sampler = \"jittered\"\nzone = [32, 48]\nzones = {zones}"));
    let both = fence("[[0, 0], [32, 0]]");
    let square = |name: &str| number(&both, name) * number(&both, name);
    let (left, right) = (square("zone.1.jittered"), square("zone.2.jittered"));
    assert!((0.5 * (left + right) - square("rmse.jittered")).abs() < 1e-12, "{left} {right}");
    assert!((left / right - 1.0).abs() > 0.05, "the halves differ: {left} {right}");
    assert_eq!(number(&fence("[[32, 0]]"), "zone.1.jittered"), number(&both, "zone.2.jittered"));
}

#[test]
fn identical_runs_gain_nothing_and_randomised_ones_the_root() {
    let samplers = "samplers = [\"sobol+owen\", \"halton+cranley-patterson\"]";
    for what in ["integrand = \"exp(x*y)\"\nreplicates = 200", "scene = \"soft-shadows\"\nreference = 4096\nn = 4"] {
        let outcome = outcome(&format!("kind = \"averaging\"\n{samplers}\n{what}\nruns = \"2^0..2^5\""));
        for sampler in ["sobol+owen", "halton+cranley-patterson"] {
            assert_eq!(number(&outcome, &format!("slope.identical.{sampler}")), 0.0, "{what}");
            let slope = number(&outcome, &format!("slope.randomised.{sampler}"));
            assert!((slope + 0.5).abs() < 0.07, "{what} {sampler}: {slope}");
        }
    }
    let plain = outcome("kind = \"averaging\"\nsampler = \"sobol\"\nintegrand = \"exp(x*y)\"\nruns = [1, 8]");
    assert_eq!(number(&plain, "slope.randomised.sobol"), 0.0, "a sequence is the same every time");
    assert_eq!(number(&plain, "gain.sobol"), 1.0);
}

#[test]
fn what_is_shown_is_drawn() {
    let all = "show = [\"reference\", \"pictures\", \"differences\", \"spectra\"]\nn = 4\nwidth = 17\nheight = 9";
    for randomisation in ["pixel", "shift", "sequence", "same", "tiled", "diagonal"] {
        for scene in ["checkerboard", "soft-shadows", "depth-of-field", "motion-blur"] {
            let fence = format!(
                "kind = \"render\"\nscene = \"{scene}\"\nsamplers = [\"halton\", \"sobol\"]\nrandomisation = \"{randomisation}\"\nreference = 4\n{all}"
            );
            let experiment = plan(&fence).unwrap_or_else(|complaints| panic!("{complaints:#?}"));
            let outcome = experiment.run(Seed::new(1)).expect("it runs");
            assert!(experiment.revive(outcome.bytes.clone()).as_ref() == Some(&outcome));
            let drawn = experiment.draw(&outcome, &Sheet::new("fig-a", "A", "B")).expect("it draws");
            let Drawing::Pictures(pictures) = drawn else { panic!("{drawn:?}") };
            assert_eq!(pictures.items.len(), 7);
            assert!(pictures.items.iter().all(|item| (item.png.width, item.png.height) == (17, 9)));
            assert!(pictures.chart.is_some() && experiment.alt(&outcome).is_some());
        }
    }
}

#[test]
fn what_cannot_be_rendered_is_refused_with_its_place() {
    for (fence, words) in [
        ("kind = \"render\"\nscene = \"soft-shadow\"", "unknown scene"),
        ("kind = \"render\"\nlight = 3", "no multiple"),
        ("kind = \"render\"\nzones = [[0, 0], [180, 0]]", "not within the picture"),
        ("kind = \"render\"\nscene = \"checkerboard\"\nlight = 4", "no lamp"),
        ("kind = \"render\"\nsampler = \"jittered\"\nn = 15", "jittered"),
        ("kind = \"render\"\nsampler = \"sobol+xor\"\nrandomisation = \"sequence\"", "one sequence"),
        ("kind = \"render\"\nwidth = 1024\nheight = 1024\nn = 65536\nsampler = \"independent\"", "too many"),
        ("kind = \"averaging\"\nsampler = \"sobol\"", "either an integrand or a scene"),
        (
            "kind = \"averaging\"\nsampler = \"sobol\"\nintegrand = \"x\"\nscene = \"soft-shadows\"",
            "either an integrand or a scene",
        ),
        ("kind = \"averaging\"\nsampler = \"jittered\"\nscene = \"soft-shadows\"\nn = 3", "jittered"),
    ] {
        let complaints = plan(fence).err().unwrap_or_else(|| panic!("{fence} is taken"));
        assert!(complaints.iter().any(|complaint| complaint.message.contains(words)), "{fence}: {complaints:#?}");
    }
}
