//! What a reader can tell apart in a drawing or a table: lines, marks, counts, indices, and what a cell means.

use crate::asked::{number, outcome};
use crate::parameters::plan;
use workbook::chart::{Drawing, Sheet};

fn drawing(fence: &str) -> Drawing {
    let experiment = plan(fence).unwrap_or_else(|complaints| panic!("{fence}: {complaints:#?}"));
    experiment.draw(&outcome(fence), &Sheet::new("fig-a", "A title", "A description")).unwrap()
}

/// The SVG of a drawing, all steps of it, and the captions of its steps.
fn drawn(fence: &str) -> (String, Vec<String>) {
    match drawing(fence) {
        Drawing::Figure(figure) => (figure.svg, Vec::new()),
        Drawing::Stepper(stepper) => (stepper.figure.svg.clone(), stepper.captions.clone()),
        other => panic!("{fence}: {other:?}"),
    }
}

fn table(fence: &str) -> String {
    match drawing(fence) {
        Drawing::Table(table) => table.text(),
        other => panic!("{fence}: {other:?}"),
    }
}

#[test]
fn reference_slopes_and_slopes_of_panels_are_all_there() {
    let fence = "kind = \"convergence\"\nsamplers = [\"independent\", \"jittered\", \"sobol+owen\"]\nn = \"2^4..2^8\"\n\
                 replicates = 8\nslopes = [-0.5, -1.0, -1.5]\ndimensions = 2\nintegrands = [\"xy\", \"x1 + x2\"]";
    let (svg, _) = drawn(&fence.replace("2^4..2^8", "4^2..4^5"));
    for slope in ["-0.5", "-1", "-1.5"] {
        assert!(svg.contains(&format!("slope {}", slope.replace('-', "\u{2212}"))), "{slope}");
    }
    let dashes = |svg: &str| {
        let theory = svg.lines().filter(|line| line.contains("s-theory"));
        let mut dashes: Vec<&str> =
            theory.filter_map(|line| line.split_once("dasharray=\"")?.1.split_once('"')).map(|dash| dash.0).collect();
        dashes.sort_unstable();
        dashes.dedup();
        dashes.len()
    };
    assert_eq!(dashes(&svg), 3);
    // Each of three samplers has its slope in each of two panels, to two decimals.
    let decimals = svg.lines().filter(|line| {
        let words = line.strip_suffix("</text>").and_then(|line| line.rsplit_once('>'));
        words.is_some_and(|(_, words)| {
            words.starts_with('\u{2212}') && words.split_once('.').is_some_and(|two| two.1.len() == 2)
        })
    });
    assert_eq!(decimals.count(), 6);
}

#[test]
fn captions_count_points_as_n_and_name_indices_i() {
    let captions = |fence: &str| drawn(fence).1;
    assert!(captions("kind = \"shuffle-steps\"\nn = 16")[0].contains("point $i$ lies in slab $i$"));
    assert!(captions("kind = \"shuffle-steps\"\nn = 16")[0].ends_with("$N = 16$."));
    assert!(captions("kind = \"xor-steps\"")[0].contains("point $i$ at the reversed bits of $i$"));
    assert!(captions("kind = \"digit-steps\"")[1].starts_with("$a_{1} = "));
    let (svg, growth) = drawn("kind = \"growth-steps\"\nn = \"1..32\"");
    assert!(growth[0].contains(" The points are those of "), "{}", growth[0]);
    assert!(svg.contains("= 0–7<") || svg.contains("= 0–7"), "the key begins with the index 0");
}

#[test]
fn every_step_of_the_estimator_marks_its_samples() {
    let count = |n: &str| {
        let (svg, _) = drawn(&format!("kind = \"estimator-steps\"\nintegrand = \"exp-sin\"\nn = {n}"));
        svg.lines().filter(|line| line.contains("s-accent") && line.contains("stroke-width=\"3.5\"")).count()
    };
    assert_eq!((count("16"), count("64")), (0, 1));
}

#[test]
fn what_a_tree_has_decided_stays_to_be_seen() {
    let (svg, _) = drawn("kind = \"owen-steps\"");
    assert!(svg.lines().any(|line| line.contains("stroke-width=\"2.4\"")));
    assert!(
        svg.lines().filter(|line| line.contains("stroke-width=\"1.5\"") && !line.contains("s-strata")).count() >= 6
    );
}

#[test]
fn the_cells_of_an_orthogonal_array_are_drawn() {
    let fence =
        |n: usize| format!("kind = \"projections\"\nsampler = \"independent\"\nn = {n}\nbase = 3\npairs = [[1, 2]]");
    assert!(drawn(&fence(9)).0.contains("s-strata"));
    assert!(!drawn(&fence(10)).0.contains("s-strata"));
}

#[test]
fn tables_say_what_their_cells_mean_and_have_no_empty_column() {
    let kept = table("kind = \"guarantees\"\nsamplers = [\"jittered\"]\nproperties = [\"cells\"]\nseeds = 5");
    assert!(kept.ends_with("as declared"), "{kept}");
    let measured =
        "kind = \"measures\"\nsamplers = [\"independent\", \"sobol\"]\nmeasures = [\"l2-star\"]\nstrata = true\nn = ";
    assert!(table(&format!("{measured}16")).contains("Cells"));
    assert!(!table(&format!("{measured}8")).contains("Cells"));
}

#[test]
fn anisotropies_are_values() {
    let outcome = outcome("kind = \"spectrum\"\nsampler = \"independent\"\nn = 64\nreplicates = 10\nreach = 8");
    assert!((number(&outcome, "isotropic.independent") + 10.0).abs() < 1e-12);
    let (most, ring) = (number(&outcome, "anisotropy.independent"), number(&outcome, "anisotropy.ring.independent"));
    assert_eq!(most, number(&outcome, &format!("anisotropy.independent.{ring}")));
}

#[test]
fn a_number_is_an_integrand() {
    let text = |written: &str| {
        let fence = format!("kind = \"convergence\"\nsampler = \"independent\"\nintegrand = {written}\ndimensions = 1");
        plan(&fence).map(|experiment| experiment.parameters()["integrands"].clone()).ok()
    };
    assert_eq!(text("1"), text("\"1\""));
    assert_eq!(text("0.5"), text("\"0.5\""));
    assert!(text("1").is_some() && text("true").is_none());
}
