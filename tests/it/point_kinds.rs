//! The kinds about point sets and their measures: against exact and published values, and against other ways to compute them.

use crate::asked::{error, holds, number, outcome};
use crate::parameters::plan;
use workbook::chart::{Drawing, Sheet};
use workbook::seed::Seed;
use workbook::stats::portable;

pub fn drawn(fence: &str) -> (Drawing, String) {
    let experiment = plan(fence).unwrap_or_else(|complaints| panic!("{fence}: {complaints:#?}"));
    let outcome = experiment.run(Seed::new(1)).unwrap_or_else(|failure| panic!("{fence}: {failure:?}"));
    assert_eq!(experiment.revive(outcome.bytes.clone()).as_ref(), Some(&outcome), "{fence}");
    let frames = experiment.tables(&outcome);
    let whole = |frame: &workbook::kinds::Frame| frame.columns.iter().all(|(_, e)| e.len() == frame.rows());
    assert!(!frames.is_empty() && frames.iter().all(|frame| frame.rows() > 0 && whole(frame)), "{fence}");
    let drawing = experiment.draw(&outcome, &Sheet::new("fig-a", "A title", "A description"));
    let alt = experiment.alt(&outcome).unwrap_or_default();
    assert!(alt.ends_with('.') && !alt.contains("NaN") && !alt.contains("inf"), "{fence}: {alt}");
    (drawing.unwrap_or_else(|failure| panic!("{fence}: {failure:?}")), alt)
}

fn svg(fence: &str) -> String {
    match drawn(fence).0 {
        Drawing::Figure(figure) => figure.svg,
        _ => panic!("{fence} is no figure"),
    }
}

fn rows(fence: &str) -> Vec<Vec<String>> {
    match drawn(fence).0 {
        Drawing::Table(table) => {
            table.rows.iter().map(|row| row.iter().map(workbook::chart::Cell::printed).collect()).collect()
        }
        _ => panic!("{fence} is no table"),
    }
}

/// Hammersley's set of 16 points: 11/64 (Halton and Zaremba 1969).
#[test]
fn the_worst_box_attains_the_discrepancy() {
    let sets = outcome("kind = \"points\"\nsamplers = [\"hammersley\", \"independent\"]\nn = 16\nworst = true");
    assert_eq!(number(&sets, "dstar.hammersley"), 11.0 / 64.0);
    for name in ["hammersley", "independent"] {
        let (count, volume) =
            (number(&sets, &format!("box.count.{name}")), number(&sets, &format!("box.volume.{name}")));
        let gap = (count / 16.0 - volume).abs();
        assert!((gap - number(&sets, &format!("dstar.{name}"))).abs() < 1e-15, "{name}");
    }
}

#[test]
fn elementary_intervals_are_counted() {
    let fence =
        |shape: &str| format!("kind = \"points\"\nsamplers = [\"sobol\", \"halton\"]\nn = 16\nelementary = {shape}");
    for shape in ["[4, 0]", "[3, 1]", "[2, 2]", "[1, 3]", "[0, 4]"] {
        let sets = outcome(&fence(shape));
        assert!(holds(&sets, "one-per-interval.sobol"), "{shape}");
        assert_eq!(holds(&sets, "one-per-interval.halton"), shape == "[4, 0]", "{shape}");
    }
    let base = outcome("kind = \"points\"\nsamplers = \"faure\"\nn = 9\nelementary = [1, 1]\nbase = 3\ndimensions = 2");
    assert!(number(&base, "intervals.max.faure") >= 1.0);
}

#[test]
fn several_counts_are_named_by_their_count() {
    let sets = outcome("kind = \"points\"\nsamplers = [\"jittered\", \"sobol\"]\nn = [16, 64]");
    assert!(holds(&sets, "one-per-cell.jittered.16") && holds(&sets, "one-per-cell.sobol.64"));
    assert_eq!(sets.values.get("one-per-cell.jittered"), None);
    let alone = outcome("kind = \"points\"\nsamplers = \"jittered\"\nn = 64");
    assert_eq!(number(&alone, "distance.jittered"), number(&sets, "distance.jittered.64"));
}

#[test]
fn every_point_is_drawn_however_they_are_marked() {
    let fence = "kind = \"points\"\nsampler = \"latin-hypercube\"\nn = 16\n";
    let plain = svg(fence);
    assert!(!plain.contains("s-step1"));
    let ordered = svg(&format!("{fence}order = true\nlabels = true"));
    assert!((1..=6).all(|step| ordered.contains(&format!("-step{step}"))), "{ordered}");
    assert!((0..16).all(|index| ordered.contains(&format!(">{index}<"))));
    let disks = svg(&format!("{fence}disks = true"));
    assert!(disks.len() > plain.len() + 500);
    // Two ticks for every point, each a line of its own, on 16 equal slabs: no two in one slab.
    let rug = svg(&format!("{fence}projections = true"));
    assert!(rug.len() > plain.len() + 16 * 10);
}

#[test]
fn a_million_points_are_a_small_picture() {
    let svg = svg("kind = \"points\"\nsampler = \"sobol\"\nn = 1048576");
    assert!(svg.contains("<path") && svg.len() < 200_000, "{}", svg.len());
    let complaints = plan("kind = \"points\"\nsampler = \"sobol\"\nn = 1048576\nlabels = true").err().expect("refused");
    assert!(complaints.iter().any(|complaint| complaint.message.contains("labels")));
}

/// Axes 32 and 33 of Halton's sequence are equal for the first 131 points; 0.849 at 256.
#[test]
fn late_halton_axes_are_correlated_until_permuted() {
    let fence = |n: usize| {
        format!(
            "kind = \"projections\"\nsamplers = [\"halton\", \"halton+permutation\"]\nn = {n}\npairs = [[1, 2], [32, 33]]"
        )
    };
    let short = outcome(&fence(131));
    assert!((number(&short, "correlation.halton.32-33") - 1.0).abs() < 1e-12);
    let long = outcome(&fence(256));
    assert!((number(&long, "correlation.halton.32-33") - 0.849).abs() < 5e-4);
    assert!(number(&long, "correlation.halton+permutation.32-33").abs() < 0.3);
    assert!(number(&long, "correlation.halton.1-2").abs() < 0.05);
    assert!(svg(&fence(64)).matches("font-weight=\"600\"").count() >= 4, "a title for each of the four panels");
    let net = outcome("kind = \"projections\"\nsampler = \"sobol\"\nn = 64\npairs = [[2, 1]]");
    assert_eq!(number(&net, "violations.sobol.2-1"), 0.0);
}

#[test]
fn counts_of_strata_are_exact() {
    let table = outcome("kind = \"strata-count\"\nper_axis = [2, 10, 1000]\ndimensions = [1, 10, 63]");
    assert_eq!(number(&table, "strata.2.10"), 1024.0);
    assert_eq!(number(&table, "strata.10.10"), 1e10);
    assert_eq!(number(&table, "strata.2.63"), portable::power(2.0, 63));
    assert!((number(&table, "strata.1000.63") / 1e189 - 1.0).abs() < 1e-14);
    assert!(holds(&table, "within-reach.2.10") && !holds(&table, "within-reach.10.10"));
    let rows = rows("kind = \"strata-count\"\nper_axis = [3]\ndimensions = [20, 40]");
    assert_eq!(rows[0][1], "(3\u{202f}486\u{202f}784\u{202f}401)");
    assert_eq!(rows[1][1], "(1.22 \\times 10^{19})");
    // 7^50 by repeated doubling in another way: digits summed by nines.
    let long = rows_of_digits("kind = \"strata-count\"\nper_axis = [7]\ndimensions = [50]");
    assert_eq!(long, "1798465042647412146620280340569649349251249");
}

/// The digits of the only count, as its data give them.
fn rows_of_digits(fence: &str) -> String {
    let experiment = plan(fence).expect("right");
    let outcome = experiment.run(Seed::new(1)).expect("it runs");
    match &experiment.tables(&outcome)[0].columns[2].1 {
        workbook::kinds::Entries::Text(words) => words[0].clone(),
        other => panic!("{other:?}"),
    }
}

/// At n = 16 = 4 x 4: 0.18943 at (1, 0), 0.34298 at (1, 1) for jittered points.
#[test]
fn spectra_meet_their_expectations() {
    let fence = "kind = \"spectrum\"\nsamplers = [\"independent\", \"jittered\", \"latin-hypercube\"]\nn = 256\n\
                 replicates = 200\nreach = 24\nlow = 4\n";
    let spectra = outcome(fence);
    for name in ["independent", "jittered", "latin-hypercube"] {
        assert!(number(&spectra, &format!("theory.z.{name}")) < 4.5, "{name}");
    }
    assert!((number(&spectra, "mean.independent") - 1.0).abs() < 4.0 * error(&spectra, "mean.independent"));
    assert!(number(&spectra, "flatness.z.independent") < 4.5);
    // 1 - sinc^2 sinc^2 rises with the square of the frequency.
    assert!((number(&spectra, "slope.jittered") - 2.0).abs() < 0.12, "{}", number(&spectra, "slope.jittered"));
    assert!(number(&spectra, "low.jittered") < 0.2 && number(&spectra, "low.independent") > 0.9);
    // The first ring holds four of (1, 0) and four of (1, 1).
    let four = outcome("kind = \"spectrum\"\nsampler = \"jittered\"\nn = 16\nreplicates = 2000\nreach = 4\nlow = 2");
    let experiment = plan("kind = \"spectrum\"\nsampler = \"jittered\"\nn = 16\nreplicates = 2000\nreach = 4\nlow = 2");
    let frames = experiment.expect("right").tables(&four);
    let column = |name: &str| match frames[0].columns.iter().find(|column| column.0 == name) {
        Some((_, workbook::kinds::Entries::Numbers(numbers))) => numbers[0],
        other => panic!("{other:?}"),
    };
    assert!((column("expected") - f64::midpoint(0.18943, 0.34298)).abs() < 1e-5);
    assert!((column("power") - column("expected")).abs() < 4.0 * column("standard error"));
    assert!((column("frequency") - 1.5_f64.sqrt()).abs() < 1e-15);
    for show in ["images", "radial", "logarithmic", "anisotropy"] {
        let svg = svg(&format!("{fence}show = \"{show}\""));
        assert_eq!(svg.contains("data:image/png;base64"), show == "images", "{show}");
    }
}

/// Published: Hammersley (m/3 + 13/9 - (-1)^m 4/(9 2^m)) / 2^m; van der Corput below (log2(N)/3 + 1) / N; centred grid 1/n - 1/(4 n^2).
#[test]
fn discrepancies_meet_their_formulas_and_bounds() {
    let plane =
        outcome("kind = \"discrepancy\"\nsamplers = [\"hammersley\", \"halton\", \"independent\"]\nn = \"2^2..2^8\"");
    for m in 2..=8_u32 {
        let n = 2_u32.pow(m);
        let (value, exact) =
            (number(&plane, &format!("dstar.hammersley.{n}")), number(&plane, &format!("expected.hammersley.{n}")));
        assert!((value - exact).abs() < 1e-14, "{n}: {value} {exact}");
    }
    assert_eq!(number(&plane, "expected.hammersley.16"), 11.0 / 64.0);
    assert!(holds(&plane, "bound.holds.halton") && holds(&plane, "bound.holds.hammersley"));
    assert!(number(&plane, "dstar.hammersley.256") < number(&plane, "dstar.halton.256"));
    assert!((number(&plane, "slope.independent") + 0.5).abs() < 0.08);
    let line = outcome("kind = \"discrepancy\"\nsamplers = \"van-der-corput\"\nn = \"1..512\"\ndimensions = 1");
    assert!(holds(&line, "bound.holds.van-der-corput"));
    // 1/n at the powers of 2.
    assert_eq!(number(&line, "dstar.van-der-corput.256"), 1.0 / 256.0);
    let grid = outcome("kind = \"discrepancy\"\nsamplers = \"centred-grid\"\nn = [16, 64]");
    assert!((number(&grid, "dstar.centred-grid.16") - (0.25 - 1.0 / 64.0)).abs() < 1e-15);
    assert_eq!(number(&grid, "expected.centred-grid.16"), 0.25 - 1.0 / 64.0);
    // E[L2*^2] = (1/4 - 1/9) / N: the mean of the root lies a little below the root of the mean.
    let l2 =
        outcome("kind = \"discrepancy\"\nsamplers = \"independent\"\nmeasure = \"l2-star\"\nn = 64\nreplicates = 400");
    let ratio = number(&l2, "l2star.independent.64") / number(&l2, "expected.independent.64");
    assert!(ratio > 0.85 && ratio < 1.0, "{ratio}");
}

#[test]
fn tables_of_measures_are_those_of_the_metrics() {
    let fence = "kind = \"measures\"\nsamplers = [\"sobol\", \"hammersley\", \"independent\", \"jittered\"]\nn = 16";
    let table = outcome(fence);
    assert_eq!(number(&table, "t.sobol"), 0.0);
    assert_eq!(number(&table, "dstar.hammersley"), 11.0 / 64.0);
    // N^2 L2*^2 = m^2/64 + 29m/192 + 3/8 - m/(16 2^m) + 1/(4 2^m) - 1/(72 4^m), m = 4.
    let square = 0.25 + 29.0 * 4.0 / 192.0 + 0.375 - 4.0 / 256.0 + 1.0 / 64.0 - 1.0 / (72.0 * 256.0);
    assert!((number(&table, "l2star.hammersley") - f64::sqrt(square) / 16.0).abs() < 1e-14);
    assert!(holds(&table, "latin.sobol") && !holds(&table, "latin.jittered") && holds(&table, "one-per-cell.jittered"));
    assert_eq!(number(&table, "violations.sobol"), 0.0);
    assert!(number(&table, "violations.independent") > 0.0);
    assert_eq!(rows(fence)[0][0], "Sobol'");
}

/// f = (1 - x)(1 - y), V = 1, Hammersley, N = 256: 5.8632e-3 and 1.6052e-2; the curve of the course with van der Corput, V = 2e - 1 - f(1).
#[test]
fn the_inequality_of_koksma_and_hlawka_holds_in_every_row() {
    let fence = "kind = \"koksma-hlawka\"\nsamplers = [\"hammersley\", \"independent\"]\nintegrand = \"unit-variation\"\n\
                 dimensions = 2\nn = [16, 256]\n";
    let plane = outcome(fence);
    assert_eq!(number(&plane, "variation"), 1.0);
    assert!((number(&plane, "error.hammersley.256") - 5.8632e-3).abs() < 1e-7);
    assert!((number(&plane, "bound.hammersley.256") - 1.6052e-2).abs() < 1e-6);
    assert!(holds(&plane, "holds") && holds(&plane, "holds.independent.16") && holds(&plane, "discrepancies.exact"));
    let line = outcome("kind = \"koksma-hlawka\"\nsamplers = \"van-der-corput\"\nintegrand = \"exp-sin\"\nn = 256");
    assert!((number(&line, "error.van-der-corput.256") - 3.047e-4).abs() < 1e-7);
    assert!((number(&line, "bound.van-der-corput.256") - 1.2832e-2).abs() < 1e-6);
    assert_eq!(rows(fence).len(), 4);
    assert!(svg(&format!("{fence}form = \"figure\"")).contains("Hammersley"));
    let complaints =
        plan("kind = \"koksma-hlawka\"\nsamplers = \"halton\"\nintegrand = \"edge\"").err().expect("refused");
    assert!(complaints.iter().any(|complaint| complaint.message.contains("variation")), "{complaints:#?}");
}

#[test]
fn digits_are_those_of_the_textbook() {
    let fence = "kind = \"digits\"\nbases = [2, 3, 10]\nn = 124";
    let table = outcome(fence);
    assert_eq!(number(&table, "phi.2.6"), 0.375);
    assert_eq!(number(&table, "phi.3.5"), 7.0 / 9.0);
    assert_eq!(number(&table, "phi.10.123"), 0.321);
    assert!(holds(&table, "agrees") && holds(&table, "agrees.10"));
    let rows = rows(fence);
    assert_eq!(rows[5][1..5], ["101", ".101", "5/8", "0.6250"]);
    assert_eq!(rows[0][1..4], ["0", ".0", "0"]);
    assert_eq!(rows[123][9..12], ["123", ".321", "321/1000"]);
}

#[test]
fn bit_reversal_is_the_digit_loop() {
    let fence = "kind = \"bit-reversal\"\nindices = 65536";
    let both = outcome(fence);
    assert!(holds(&both, "equal"));
    assert_eq!((number(&both, "checked"), number(&both, "count")), (65536.0, 65536.0));
    assert_eq!(number(&both, "largest"), 65535.0 / 65536.0);
    assert_eq!(rows(fence).last().expect("a foot")[5], "65\u{202f}536 of 65\u{202f}536");
}

#[test]
fn nets_violate_nothing_in_any_block() {
    let fence = "kind = \"occupancy\"\nsamplers = [\"sobol\", \"sobol+owen\", \"halton\", \"independent\", \"larcher-pillichshammer\"]\n\
                 n = 16\nblocks = 32\nform = \"table\"";
    let counts = outcome(fence);
    assert_eq!(number(&counts, "intervals"), 5.0 * 16.0 * 32.0);
    for name in ["sobol", "sobol+owen", "larcher-pillichshammer"] {
        assert!(holds(&counts, &format!("perfect.{name}")), "{name}");
    }
    // Radical inverses in base 2 fill the columns, whatever the second axis does.
    assert_eq!(number(&counts, "violations.halton.16x1"), 0.0);
    assert!(number(&counts, "violations.halton.1x16") > 0.0);
    // Of independent points a cell holds one with probability (15/16)^15 = 0.3798.
    let share = number(&counts, "violations.independent") / number(&counts, "intervals");
    assert!((share - 0.6202).abs() < 0.04, "{share}");
    assert_eq!(rows(fence)[0][1..7], ["0"; 6]);
    let ternary = outcome("kind = \"occupancy\"\nsampler = \"faure\"\nn = 16\nform = \"figure\"");
    assert!(holds(&ternary, "perfect.faure"));
    assert!(plan("kind = \"occupancy\"\nsampler = \"sobol\"\nn = 12").is_err());
}

#[test]
fn guarantees_are_kept_and_no_more_is_declared() {
    let fence = "kind = \"guarantees\"\nsamplers = [\"independent\", \"jittered\", \"latin-hypercube\", \"multi-jittered\", \
                 \"sobol\", \"sobol+xor\", \"sobol+cranley-patterson\", \"best-candidate\"]\nseeds = 50\n\
                 properties = [\"latin\", \"cells\", \"both\", \"net\", \"prefix\", \"fixed\"]";
    let matrix = outcome(fence);
    assert!(holds(&matrix, "consistent"));
    for (name, kept) in
        [("independent", [false; 3]), ("jittered", [false, true, false]), ("latin-hypercube", [true, false, false])]
    {
        for (property, kept) in ["latin", "cells", "both"].into_iter().zip(kept) {
            assert_eq!(holds(&matrix, &format!("{property}.{name}")), kept, "{property}.{name}");
        }
    }
    assert!(holds(&matrix, "both.multi-jittered") && holds(&matrix, "net.sobol+xor"));
    assert!(!holds(&matrix, "net.sobol+cranley-patterson") && !holds(&matrix, "fixed.sobol+xor"));
    assert!(holds(&matrix, "fixed.sobol") && holds(&matrix, "prefix.independent"));
    assert_eq!((number(&matrix, "seeds.sobol"), number(&matrix, "seeds.sobol+xor")), (1.0, 50.0));
    assert!(rows(fence).iter().all(|row| row.len() == 7));
}

#[test]
fn pixels_find_their_samples() {
    for (name, pixels) in [("halton", 8.0 * 9.0), ("sobol", 8.0 * 4.0)] {
        let fence = format!("kind = \"enumeration\"\nsampler = \"{name}\"\ndigits = [3, 2]\nsamples = 4\nrows = 5");
        let found = outcome(&fence);
        assert!(holds(&found, "equal"), "{name}");
        assert_eq!(number(&found, "pixels"), pixels);
        assert_eq!(number(&found, "checked"), 4.0 * pixels);
        assert_eq!(number(&found, "count"), 4.0 * pixels);
        assert_eq!(rows(&fence).len(), 6);
    }
}

#[test]
fn several_integrands_are_panels_and_powers_are_told_apart() {
    let fence = "kind = \"convergence\"\nsamplers = [\"independent\", \"jittered\"]\nintegrands = [\"xy\", \"edge\"]\n\
                 n = [16, 64, 256, 1024]\nreplicates = 64\ndimensions = 2";
    let both = outcome(fence);
    assert!((number(&both, "slope.jittered.edge") + 0.75).abs() < 0.12);
    assert!((number(&both, "slope.jittered.xy") + 1.0).abs() < 0.12);
    let alone = outcome(&fence.replace("integrands = [\"xy\", \"edge\"]", "integrand = \"xy\""));
    assert_eq!(number(&alone, "rmse.jittered.64"), number(&both, "rmse.jittered.64.xy"));
    assert_eq!(svg(fence).matches("font-weight=\"600\"").count(), 2);
    // Owen's rate holds at the powers of the base and is lost between them.
    let fence = "kind = \"convergence\"\nsamplers = \"sobol+owen\"\nintegrand = \"exp(-x^2-y^2)\"\nn = \"1..160\"\n\
                 replicates = 64\npowers = 2";
    let net = outcome(fence);
    let (powers, between) = (number(&net, "slope.sobol+owen"), number(&net, "slope.between.sobol+owen"));
    assert!(powers < -1.25 && between > powers + 0.1, "{powers} {between}");
    assert!(svg(fence).contains("<path"));
}
