//! Steppers: what each kind of them computes, that every step is there and small, and that strata hold in every frame as written.

use crate::asked::{holds, number, outcome};
use crate::course::Course;
use crate::parameters::plan;
use workbook::chart::{Drawing, Sheet, Stepper};
use workbook::kinds::KINDS;
use workbook::seed::Seed;

/// A fence of each kind of stepper as a course would ask for it, with the number of its steps.
const FENCES: &[(&str, usize)] = &[
    ("kind = \"shuffle-steps\"\nn = 16", 31),
    ("kind = \"shuffle-steps\"\nsampler = \"multi-jittered\"\nn = 16", 9),
    ("kind = \"growth-steps\"\nn = \"1..32\"", 32),
    ("kind = \"growth-steps\"\nsampler = \"hammersley\"", 16),
    ("kind = \"interval-steps\"\nsampler = \"sobol\"", 5),
    ("kind = \"interval-steps\"\nsampler = \"faure\"\nn = 27\nbase = 3", 4),
    ("kind = \"box-steps\"", 12),
    ("kind = \"randomisation-steps\"", 9),
    ("kind = \"dart-steps\"", 16),
    ("kind = \"candidate-steps\"", 10),
    ("kind = \"line-steps\"", 16),
    ("kind = \"estimator-steps\"\nintegrand = \"exp-sin\"", 6),
    ("kind = \"pi-steps\"", 9),
    ("kind = \"digit-steps\"", 5),
    ("kind = \"xor-steps\"", 4),
    ("kind = \"owen-steps\"", 8),
    ("kind = \"padding-steps\"", 12),
];

fn stepper(fence: &str) -> Stepper {
    let experiment = plan(fence).unwrap_or_else(|complaints| panic!("{fence}: {complaints:#?}"));
    let sheet = Sheet::new("fig-a", "A title", "A description");
    match experiment.draw(&outcome(fence), &sheet) {
        Ok(Drawing::Stepper(stepper)) => stepper,
        other => panic!("{fence}: {other:?}"),
    }
}

/// The steps that a group of elements names.
fn steps(text: &str) -> Vec<usize> {
    let range = |range: &str| {
        let (from, to) = range.split_once('-').unwrap_or((range, range));
        from.parse::<usize>().unwrap()..=to.parse().unwrap()
    };
    text.split(',').flat_map(range).collect()
}

#[test]
fn every_kind_of_stepper_is_tried() {
    for kind in KINDS.iter().map(|kind| kind.about().key).filter(|key| key.ends_with("-steps")) {
        assert!(FENCES.iter().any(|(fence, _)| fence.contains(&format!("\"{kind}\""))), "{kind}");
    }
}

#[test]
fn every_step_is_there_and_differs_from_its_neighbours() {
    for &(fence, count) in FENCES {
        let stepper = stepper(fence);
        assert_eq!(stepper.captions.len(), count, "{fence}");
        assert!(stepper.captions.iter().all(|caption| caption.ends_with('.') && !caption.contains("NaN")), "{fence}");
        // At each step after the first something appears, vanishes or moves.
        let mut changes = vec![false; count + 2];
        for part in stepper.figure.svg.split(" data-steps=\"").skip(1) {
            let shown = steps(part.split_once('"').unwrap().0);
            assert!(shown.iter().all(|step| (1..=count).contains(step)), "{fence}");
            assert_eq!(
                part.split_once('>').unwrap().0.contains("display=\"none\""),
                !shown.contains(&count),
                "{fence}"
            );
            for (step, change) in changes.iter_mut().enumerate().take(count + 1).skip(2) {
                *change |= shown.contains(&step) != shown.contains(&(step - 1));
            }
        }
        for part in stepper.figure.svg.split(" data-at=\"").skip(1) {
            for place in part.split_once('"').unwrap().0.split(',') {
                changes[place.split_once(' ').unwrap().0.parse::<usize>().unwrap()] = true;
            }
        }
        // Nodes and bits that stay change the caption alone.
        let told = |step: usize| stepper.captions[step - 1] != stepper.captions[step - 2];
        assert!((2..=count).all(|step| changes[step] || told(step)), "{fence}: {changes:?}");
        assert!(stepper.strip.iter().all(|key| key.step < count), "{fence}");
        assert!(!stepper.strip.is_empty() && stepper.text().len() > stepper.figure.svg.len(), "{fence}");
    }
}

#[test]
fn steppers_are_small() {
    for &(fence, _) in FENCES {
        let stepper = stepper(fence);
        let captions: usize = stepper.captions.iter().map(String::len).sum();
        let strip: usize = stepper.strip.iter().map(|key| key.figure.svg.len()).sum();
        let size = stepper.figure.svg.len() + captions + strip;
        assert!(size <= 20_000, "{fence}: {} + {captions} + {strip} = {size}", stepper.figure.svg.len());
    }
}

/// The places, in hundredths, of the elements that move, at each of `count` steps.
fn moving(svg: &str, count: usize) -> Vec<Vec<(i64, i64)>> {
    let hundredths = |text: &str| (text.parse::<f64>().unwrap() * 100.0).round() as i64;
    let pair = |text: &str| text.split_once(' ').map(|(x, y)| (hundredths(x), hundredths(y))).unwrap();
    let mut frames = vec![Vec::new(); count];
    for line in svg.lines().filter(|line| line.contains("transform=\"translate(")) {
        let still = line.split_once("translate(").unwrap().1.split_once(')').unwrap().0;
        let places = line
            .split_once(" data-at=\"")
            .map_or(format!("1 {still}"), |(_, rest)| rest.split_once('"').unwrap().0.to_owned());
        for (index, frame) in frames.iter_mut().enumerate() {
            let mut place = places.split(',').map(|place| place.split_once(' ').unwrap());
            let place = place.rfind(|(from, _)| from.parse::<usize>().unwrap() <= index + 1).unwrap();
            frame.push(pair(place.1));
        }
    }
    frames
}

#[test]
fn slabs_and_cells_hold_one_point_in_every_frame_as_written() {
    for (fence, n, side) in [
        ("kind = \"shuffle-steps\"\nn = 16", 16, None),
        ("kind = \"shuffle-steps\"\nn = 36", 36, None),
        ("kind = \"shuffle-steps\"\nsampler = \"multi-jittered\"\nn = 25", 25, Some(5)),
    ] {
        let stepper = stepper(fence);
        // The frame of the unit square, the last closed path: from its corner across and down.
        let frame =
            stepper.figure.svg.lines().rfind(|line| line.contains("s-axis") && line.ends_with("z\"/>")).unwrap();
        let data = frame.split_once(" d=\"M").unwrap().1;
        let (corner, rest) = data.split_once('h').unwrap();
        let hundredths = |text: &str| (text.parse::<f64>().unwrap() * 100.0).round() as i64;
        let (left, top) = corner.split_once(' ').map(|(x, y)| (hundredths(x), hundredths(y))).unwrap();
        let length = hundredths(rest.split_once('v').unwrap().0);
        for (step, places) in moving(&stepper.figure.svg, stepper.captions.len()).into_iter().enumerate() {
            assert_eq!(places.len(), n, "{fence}");
            let stratum = |at: i64, count: usize| {
                let at = at * count as i64;
                assert_ne!(at % length, 0, "{fence}, step {}: on a border", step + 1);
                usize::try_from(at.div_euclid(length)).unwrap()
            };
            let distinct = |mut strata: Vec<usize>| {
                strata.sort_unstable();
                assert_eq!(strata, (0..n).collect::<Vec<_>>(), "{fence}, step {}", step + 1);
            };
            distinct(places.iter().map(|place| stratum(place.0 - left, n)).collect());
            distinct(places.iter().map(|place| stratum(place.1 - top, n)).collect());
            if let Some(side) = side {
                let cell = |place: &(i64, i64)| stratum(place.0 - left, side) + side * stratum(place.1 - top, side);
                distinct(places.iter().map(cell).collect());
            }
        }
    }
}

#[test]
fn the_steps_lead_to_what_the_samplers_give() {
    for &(fence, _) in FENCES {
        let outcome = outcome(fence);
        let flags = ["agrees", "one-per-slab.every-step", "one-per-cell.every-step", "stratified.every-step"];
        for flag in flags.into_iter().filter(|flag| outcome.values.get(flag).is_some()) {
            assert!(holds(&outcome, flag), "{fence}: {flag}");
        }
    }
    for kind in ["shuffle-steps", "dart-steps", "candidate-steps", "digit-steps", "xor-steps", "owen-steps"] {
        assert!(outcome(&format!("kind = \"{kind}\"")).values.get("agrees").is_some(), "{kind}");
    }
    for levels in 1..=5 {
        assert!(holds(&outcome(&format!("kind = \"owen-steps\"\nlevels = {levels}")), "agrees"));
        assert!(holds(&outcome(&format!("kind = \"xor-steps\"\nbits = {levels}")), "agrees"));
    }
}

#[test]
fn what_is_known_is_found() {
    let digits = outcome("kind = \"digit-steps\"\nindex = 11");
    assert_eq!(number(&digits, "phi"), 0.8125, "1011 reflected is .1101");
    assert_eq!(number(&outcome("kind = \"digit-steps\"\nindex = 5\nbase = 3"), "phi"), 7.0 / 9.0, "12 is .21");
    let line = outcome("kind = \"line-steps\"");
    assert!(holds(&line, "biggest.every-step.van-der-corput") && holds(&line, "halved.every-step.van-der-corput"));
    assert_eq!(number(&line, "gap.max.van-der-corput"), 0.0625);
    let random = outcome("kind = \"line-steps\"\nsampler = \"independent\"");
    assert!(!holds(&random, "biggest.every-step.independent"));
    let intervals = outcome("kind = \"interval-steps\"\nsamplers = [\"sobol\", \"halton\", \"independent\"]");
    assert_eq!(number(&intervals, "violations.sobol"), 0.0);
    assert!(number(&intervals, "violations.halton") > 0.0 && number(&intervals, "violations.independent") > 0.0);
    let shifts = outcome(
        "kind = \"randomisation-steps\"\nsamplers = [\"sobol+cranley-patterson\", \"sobol+owen\", \"sobol+xor\"]",
    );
    assert!(number(&shifts, "violations.max.sobol+cranley-patterson") > 0.0);
    assert_eq!(number(&shifts, "violations.unscrambled.sobol+cranley-patterson"), 0.0);
    assert_eq!(number(&shifts, "violations.max.sobol+owen") + number(&shifts, "violations.max.sobol+xor"), 0.0);
    let pi = outcome("kind = \"pi-steps\"\nn = \"4^0..4^5\"");
    let error = pi.values.get("estimate.independent.1024").and_then(|measured| measured.standard_error).unwrap();
    assert!((error - 0.051_317).abs() < 1e-5, "sqrt(pi (4 - pi) / 1024)");
    assert!((number(&pi, "estimate.independent.1024") - std::f64::consts::PI).abs() < 4.0 * error);
    let boxes = outcome("kind = \"estimator-steps\"\nintegrand = \"x\"\nsampler = \"van-der-corput\"\nn = 4");
    assert_eq!((number(&boxes, "estimate.4"), number(&boxes, "exact")), (0.375, 0.5), "(0 + 1/4 + 1/2 + 3/4) / 4");
    let one = outcome("kind = \"growth-steps\"\nn = 1");
    assert_eq!(number(&one, "star.halton.1"), 1.0, "a point at the origin");
    assert!(!holds(&outcome("kind = \"growth-steps\"\nsampler = \"hammersley\""), "grows.hammersley"));
    let worst = outcome("kind = \"box-steps\"\nboxes = 40");
    assert!(number(&worst, "largest.random") <= number(&worst, "star.independent"));
    assert_eq!(number(&worst, "difference.41"), number(&worst, "star.independent"), "the last box attains it");
    let padding = outcome("kind = \"padding-steps\"");
    assert_eq!((number(&padding, "full"), number(&padding, "samples")), (243.0, 9.0));
    assert_eq!(number(&padding, "correlation.unshuffled"), 1.0);
}

/// The ends of what can be asked for are drawn.
#[test]
fn extreme_questions_are_drawn() {
    for fence in [
        "kind = \"shuffle-steps\"\nn = 2",
        "kind = \"growth-steps\"\nn = 1",
        "kind = \"growth-steps\"\nn = \"1..128\"",
        "kind = \"interval-steps\"\nn = 2",
        "kind = \"interval-steps\"\nsampler = \"independent\"\nn = 256",
        "kind = \"box-steps\"\nn = 1\nboxes = 1",
        "kind = \"box-steps\"\nsampler = \"halton\"\nn = 1",
        "kind = \"randomisation-steps\"\nn = 2\nrandomisations = 1",
        "kind = \"dart-steps\"\ntries = 2\nradius = 0.7",
        "kind = \"dart-steps\"\ntries = 96\nradius = 0.02",
        "kind = \"candidate-steps\"\nn = 40",
        "kind = \"line-steps\"\nsampler = \"independent\"\nn = 64",
        "kind = \"estimator-steps\"\nintegrand = \"0\"\nn = 1",
        "kind = \"estimator-steps\"\nintegrand = \"-x\"\nn = [1, 256]",
        "kind = \"pi-steps\"\nn = 1",
        "kind = \"pi-steps\"\nsampler = \"hammersley\"\nn = [1, 1024]",
        "kind = \"digit-steps\"\nindex = 1\nbase = 16",
        "kind = \"digit-steps\"\nindex = 65535",
        "kind = \"xor-steps\"\nbits = 1",
        "kind = \"xor-steps\"\nbits = 5",
        "kind = \"owen-steps\"\nlevels = 1",
        "kind = \"owen-steps\"\nlevels = 5",
        "kind = \"padding-steps\"\nside = 2",
        "kind = \"padding-steps\"\nside = 5",
    ] {
        let stepper = stepper(fence);
        assert!(!stepper.captions.is_empty() && !stepper.figure.svg.contains("NaN"), "{fence}");
        let experiment = plan(fence).unwrap();
        let alt = experiment.alt(&outcome(fence)).unwrap_or_default();
        assert!(alt.trim_end().ends_with('.') && !alt.contains("NaN") && !alt.contains("inf "), "{fence}: {alt}");
    }
}

#[test]
fn what_cannot_be_stepped_through_is_refused_in_words() {
    for (fence, word) in [
        ("kind = \"shuffle-steps\"\nsampler = \"multi-jittered\"\nn = 7", "cells"),
        ("kind = \"growth-steps\"\nn = \"1..200\"", "128"),
        ("kind = \"interval-steps\"\nn = 15", "power"),
        ("kind = \"randomisation-steps\"\nsamplers = [\"sobol\"]", "scramble"),
        ("kind = \"randomisation-steps\"\nn = 12", "power of 2"),
        ("kind = \"estimator-steps\"\nintegrand = \"xy\"", "variables"),
        ("kind = \"digit-steps\"\nindex = 0", "1"),
    ] {
        let Err(complaints) = plan(fence) else { panic!("{fence} is taken") };
        assert!(complaints.iter().any(|complaint| complaint.message.contains(word)), "{fence}: {complaints:#?}");
    }
    let failure = plan("kind = \"estimator-steps\"\nintegrand = \"ln(x-2)\"").unwrap().run(Seed::new(1));
    assert!(failure.is_err_and(|failure| failure.help.is_some()));
}

/// A page with a stepper asks for its script; one without does not.
#[test]
fn pages_bring_controls_captions_and_key_steps() {
    let chapter = |fence: &str| {
        format!(
            "+++\ntitle = \"One\"\nsummary = \"S.\"\n+++\n\n```experiment\nid = \"fig-a\"\n{fence}\ncaption = 'C.'\n```\n"
        )
    };
    let page = |fence: &str| {
        let configuration = "title = \"T\"\nauthors = [\"A\"]\n";
        let course = Course::new(&[("chapters/workbook.toml", configuration), ("chapters/01-one.md", &chapter(fence))]);
        let composed = course.compose(1);
        assert!(composed.diagnostics.is_empty(), "{:?}", composed.diagnostics);
        String::from_utf8(composed.book.files["one.html"].clone()).unwrap()
    };
    let with = page("kind = \"line-steps\"\nn = 8");
    assert_eq!(with.matches("assets/stepper.js").count(), 1);
    assert_eq!(with.matches("<p hidden>").count(), 7, "all captions but the last wait");
    assert!(with.contains("class=\"step-final\"") && with.contains("Step 8.</span>"));
    assert_eq!(with.matches("<button type=\"button\" class=\"step-").count(), 4);
    assert!(
        with.contains("class=\"step-controls\" role=\"group\" aria-label=\"Steps\" hidden"),
        "no control without a script"
    );
    assert_eq!(with.split_once("step-strip").unwrap().1.matches("<svg").count(), 3);
    let without = page("kind = \"function\"\nintegrand = \"x\"");
    assert!(!without.contains("class=\"stepper\"") && !without.contains("stepper.js"));
}
