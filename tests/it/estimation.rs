//! The kinds about estimation, history and testing: held against exact and published values.

use crate::asked::{holds, number, outcome, seeded, z};
use crate::parameters::plan;
use workbook::chart::{Drawing, Sheet};
use workbook::kinds::Outcome;
use workbook::seed::Seed;
use workbook::stats::portable;

fn near(outcome: &Outcome, name: &str, expected: f64, within: f64) {
    let value = number(outcome, name);
    assert!((value - expected).abs() <= within, "{name}: {value}, not {expected}");
}

#[test]
fn probabilities_are_those_of_the_tables() {
    // Abramowitz and Stegun, table 26.1: P(1) - P(-1) of the normal law.
    let normal = outcome("kind = \"distribution\"\nlaw = \"normal\"\na = -1\nb = 1");
    near(&normal, "probability", 0.682_689_492_137_086, 1e-14);
    assert!(z(&normal, "measured", 0.682_689_492_137_086).abs() < 4.5 && number(&normal, "chi-square.p") > 1e-6);
    let triangle = outcome("kind = \"distribution\"\nlaw = \"triangular\"\nfrom = 0\nto = 4\na = 1\nb = 3");
    near(&triangle, "probability", 0.75, 1e-15);
    let exponential = outcome("kind = \"distribution\"\nlaw = \"exponential\"\na = 1\nb = 2");
    near(&exponential, "probability", portable::exp(-1.0) - portable::exp(-2.0), 1e-15);
    // The density 12 x (1 - x)^2 has F(x) = 6x^2 - 8x^3 + 3x^4 and the mass 1/12 before it is made 1.
    let written = outcome("kind = \"distribution\"\ndensity = \"x*(1-x)^2\"\na = 0.25\nb = 0.5\nn = 100000");
    near(&written, "mass", 1.0 / 12.0, 1e-14);
    near(&written, "distribution.a", 0.261_718_75, 1e-11);
    near(&written, "distribution.b", 0.6875, 1e-11);
    assert!(number(&written, "chi-square.p") > 1e-6);
    // Another density than that of the samples is told apart: stratified samples of it are too even instead.
    let even = outcome("kind = \"distribution\"\ndensity = \"x*(1-x)^2\"\nsampler = \"jittered\"");
    assert!(number(&even, "chi-square.p") > 0.999);
}

#[test]
fn identities_hold_and_ignored_dependence_shows() {
    let table = outcome("kind = \"identities\"\ny1 = \"x\"\ny2 = \"x^2\"\na = 2");
    for (name, exact) in [
        ("predicted.scaled-mean", 1.0),
        ("predicted.mean-of-sum", 0.5 + 1.0 / 3.0),
        ("predicted.scaled-variance", 4.0 / 12.0),
        ("predicted.variance", 1.0 / 12.0),
        ("predicted.independent-sum", 1.0 / 12.0 + 4.0 / 45.0),
        // The covariance of x and x^2 is 1/4 - 1/6.
        ("predicted.dependent-sum", 1.0 / 12.0 + 4.0 / 45.0 + 2.0 / 12.0),
    ] {
        near(&table, name, exact, 1e-13);
    }
    assert!(number(&table, "largest.z") < 5.0 && number(&table, "z.ignored-dependence") > 50.0);
}

#[test]
fn importance_sampling_has_the_variance_of_the_integral() {
    let fence = "kind = \"importance\"\nintegrand = \"x^2\"\ndensities = [\"1\", \"x\", \"x^2\", \"1.01 - x\"]\nnames = [\"uniform\", \"line\", \"perfect\", \"bad\"]\nn = 100000";
    let table = outcome(fence);
    near(&table, "exact", 1.0 / 3.0, 1e-14);
    near(&table, "variance.exact.uniform", 4.0 / 45.0, 1e-13);
    // x^4 / 2x integrates to 1/8; less 1/9.
    near(&table, "variance.exact.line", 1.0 / 72.0, 1e-11);
    near(&table, "variance.exact.perfect", 0.0, 1e-13);
    near(&table, "ratio.line", 45.0 / 288.0, 1e-9);
    near(&table, "estimate.perfect", 1.0 / 3.0, 1e-9);
    assert!(z(&table, "variance.uniform", 4.0 / 45.0).abs() < 5.0 && z(&table, "estimate.line", 1.0 / 3.0).abs() < 4.5);
    assert!(number(&table, "ratio.bad") > 5.0);
}

#[test]
fn a_domain_has_its_own_integral_and_variance() {
    let table = outcome("kind = \"estimate-table\"\nintegrand = \"x*exp(-x)\"\ndomain = [0, 2]\nn = \"10^0..10^5\"");
    near(&table, "exact", 1.0 - 3.0 * portable::exp(-2.0), 1e-13);
    // E[(2f)^2] is twice the integral of x^2 exp(-2x) from 0 to 2, (1 - 13 exp(-4)) / 4.
    let mean = 1.0 - 3.0 * portable::exp(-2.0);
    near(&table, "variance", 0.5 * (1.0 - 13.0 * portable::exp(-4.0)) - mean * mean, 1e-12);
    assert!(number(&table, "largest.z") < 4.5);
    let unit = "kind = \"estimate-table\"\nintegrand = \"exp-sin\"\nn = 100";
    assert_eq!(outcome(unit).bytes, outcome(&format!("{unit}\ndomain = [0, 1]\nshow = \"figure\"")).bytes);
}

#[test]
fn biases_are_where_theory_puts_them() {
    let fence = "kind = \"bias\"\nintegrand = \"x^2\"\ndensity = \"0.5 + x\"\nestimators = [\"unbiased\", \"ratio\", \"shrunk\", \"first\", \"no-density\", \"clamped\"]\nn = \"2^0..2^8\"\nclamp = 2.0";
    let bias = outcome(fence);
    // Without 1/p the mean tends to the integral of x^2 (1/2 + x).
    near(&bias, "limit.no-density", 1.0 / 6.0 + 0.25, 1e-12);
    for n in [1, 16, 256] {
        assert!(z(&bias, &format!("bias.unbiased.{n}"), 0.0).abs() < 4.5, "{n}");
        assert!(z(&bias, &format!("bias.first.{n}"), 0.0).abs() < 4.5, "{n}");
        assert!(z(&bias, &format!("bias.no-density.{n}"), 1.0 / 12.0).abs() < 4.5, "{n}");
        let shrunk = -1.0 / 3.0 / f64::from(n + 1);
        assert!(z(&bias, &format!("bias.shrunk.{n}"), shrunk).abs() < 4.5, "{n}");
    }
    // With one sample the ratio is f(X) itself.
    assert!(z(&bias, "bias.ratio.1", 1.0 / 12.0).abs() < 4.5);
    assert!(z(&bias, "bias.ratio.1", 0.0) > 10.0);
    near(&bias, "slope.unbiased", -0.5, 0.03);
    assert!(number(&bias, "slope.no-density") > -0.3);
    // The unbiased estimator's error is sigma / sqrt(n): the integral of x^4 / (1/2 + x), less 1/9.
    let sigma = (0.25 - 1.0 / 6.0 + 0.125 - 0.125 + portable::ln(3.0) / 16.0 - 1.0 / 9.0_f64).sqrt();
    assert!(z(&bias, "rmse.unbiased.16", sigma / 4.0).abs() < 4.5);
}

#[test]
fn quadrature_loses_its_rate_with_the_dimension() {
    // Of the sum of squares the rule with m points an axis errs by d / (12 m^2) exactly.
    let fence = "kind = \"quadrature\"\nintegrand = \"x1^2 + x2^2\"\ndimensions = [2, 4]\nmost = 4096";
    let rule = outcome(fence);
    near(&rule, "error.midpoint.d2.16", 2.0 / (12.0 * 16.0), 1e-14);
    near(&rule, "slope.midpoint.d2", -1.0, 1e-9);
    near(&rule, "slope.midpoint.d4", -0.5, 1e-9);
    for d in [2, 4] {
        near(&rule, &format!("slope.independent.d{d}"), -0.5, 0.12);
    }
}

#[test]
fn intervals_cover_at_their_nominal_rate() {
    let fence = "kind = \"coverage\"\nintegrand = \"exp-sin\"\nsamplers = [\"independent\", \"jittered\", \"sobol+owen\"]\nn = 64\nrepetitions = 2000";
    let coverage = outcome(fence);
    for method in ["independent", "jittered", "sobol+owen"] {
        assert!(z(&coverage, &format!("coverage.{method}"), 0.95).abs() < 4.5, "{method}");
        assert!(z(&coverage, &format!("ratio.{method}"), 1.0).abs() < 6.0, "{method}");
    }
    // The variance of the mean of ten means of 64: sigma^2 / 640, within six standard errors of a variance.
    let ratio = number(&coverage, "variance.independent") / (0.360_257_498_744_067 / 640.0);
    assert!((ratio - 1.0).abs() < 6.0 * f64::sqrt(2.0 / 2000.0), "{ratio}");
    assert!(number(&coverage, "width.sobol+owen") < 0.1 * number(&coverage, "width.independent"));
}

#[test]
fn quicksort_compares_as_often_as_it_should() {
    let sorts = outcome("kind = \"quicksort\"\nlength = 100\nruns = 4000\nn = 64");
    assert!(holds(&sorts, "sorted"));
    // 2 * 101 * H_100 - 400 with H_100 = 5.18737751763962.
    near(&sorts, "expected", 2.0 * 101.0 * 5.187_377_517_639_62 - 400.0, 1e-9);
    assert!(z(&sorts, "mean", number(&sorts, "expected")).abs() < 4.5);
    // Knuth's variance of quicksort (The Art of Computer Programming 3, 5.2.2), with H_100^(2) = 1.63498390018489.
    let variance: f64 =
        7.0e4 - 4.0 * 101.0 * 101.0 * 1.634_983_900_184_89 - 2.0 * 101.0 * 5.187_377_517_639_62 + 1300.0;
    near(&sorts, "expected.deviation", variance.sqrt(), 1e-8);
    near(&sorts, "deviation", variance.sqrt(), 0.06 * variance.sqrt());
    // Two keys are compared once, three keys two or three times, 8/3 on average.
    let three = outcome("kind = \"quicksort\"\nlength = 3\nruns = 3000\nn = 4");
    near(&three, "expected", 8.0 / 3.0, 1e-12);
    near(&three, "expected.deviation", f64::sqrt(2.0 / 9.0), 1e-7);
    assert_eq!((number(&three, "least"), number(&three, "most")), (2.0, 3.0));
    assert!(z(&three, "mean", 8.0 / 3.0).abs() < 4.5);
}

#[test]
fn needles_find_pi_and_lazzarini_was_lucky() {
    let fence = "kind = \"buffon\"\nlength = 0.75\nn = \"10^1..10^6\"\nlooks = 1\ntrials = 20000";
    let buffon = outcome(fence);
    assert!(number(&buffon, "largest.z") < 4.5);
    assert!(z(&buffon, "pi.1000000", std::f64::consts::PI).abs() < 4.5);
    // After one look: the binomial probability of 113 of 213 with p = 5 / (3 pi), here by recurrence from k = 0.
    let p = 5.0 / (3.0 * std::f64::consts::PI);
    let mut probability = portable::power(1.0 - p, 213);
    for k in 0..113_i32 {
        probability *= f64::from(213 - k) / f64::from(k + 1) * p / (1.0 - p);
    }
    near(&buffon, "lucky.expected", probability, 1e-12);
    assert!(z(&buffon, "lucky", probability).abs() < 4.5);
    let sixteen = outcome("kind = \"buffon\"\nn = 10\ntrials = 4000");
    assert!(z(&sixteen, "lucky", number(&sixteen, "lucky.expected")).abs() < 4.5);
    // Badger (1994): about a third of those who would stop so succeed within Lazzarini's 3408 needles.
    near(&sixteen, "lucky.expected", 0.33, 0.05);
}

#[test]
fn middle_squares_collapse_as_published() {
    let four = outcome("kind = \"middle-square\"");
    // Counted apart by another program; the longest run of four digits, 111 from 6239, is well known.
    for (name, value) in [
        ("longest", 111.0),
        ("longest.seed", 6239.0),
        ("longest.tail", 107.0),
        ("cycles", 8.0),
        ("longest.cycle", 4.0),
        ("collapsed", 1968.0),
    ] {
        near(&four, name, value, 0.0);
    }
    near(&four, "mean", 43.7054, 1e-9);
    let two = outcome("kind = \"middle-square\"\ndigits = 2");
    near(&two, "collapsed", 62.0, 0.0);
    near(&two, "longest", 15.0, 0.0);
    let six = outcome("kind = \"middle-square\"\ndigits = 6");
    near(&six, "longest", 943.0, 0.0);
    near(&six, "collapsed", 186_619.0, 0.0);
    assert!(number(&six, "ks.modern") > 1e-6);
    // 540, 2916, 5030, 3009 and again: a seed in a cycle is not uniform.
    let cycling = outcome("kind = \"middle-square\"\nstart = 540");
    assert!(number(&cycling, "ks.middle-square") < 1e-12);
}

#[test]
fn every_bug_is_caught_and_the_right_programs_pass() {
    for seed in 1..=3 {
        let matrix = seeded("kind = \"bug-matrix\"", seed);
        assert!(holds(&matrix, "correct.passes"), "{seed}: {:#?}", matrix.values);
        assert_eq!(number(&matrix, "caught"), number(&matrix, "bugs"), "{seed}: {:#?}", matrix.values);
        // What random numbers forgive.
        for bug in ["same-sequence", "shifted-dimensions", "rejection", "dropped-point"] {
            for test in ["z", "chi-square", "ks", "correlation", "rate", "repeats", "range"] {
                assert!(!holds(&matrix, &format!("caught.{bug}.{test}.random")), "{seed}: {bug} {test}");
            }
        }
    }
}

#[test]
fn a_bug_shows_the_numbers_of_the_matrix() {
    let matrix = outcome("kind = \"bug-matrix\"");
    let bug = outcome("kind = \"bug\"\nbug = \"wrong-range\"");
    for test in ["z", "chi-square", "rate"] {
        for numbers in ["random", "qmc"] {
            let (one, all) = (format!("caught.{test}.{numbers}"), format!("caught.wrong-range.{test}.{numbers}"));
            assert_eq!(holds(&bug, &one), holds(&matrix, &all), "{one}");
        }
    }
    // From 0 to 1 the mean of 2f is 2 (1 - 2 / e).
    assert!(z(&bug, "mean.planted.random", 2.0 * (1.0 - 2.0 * portable::exp(-1.0))).abs() < 4.5);
    near(&bug, "slope.right.qmc", -1.5, 0.1);
    near(&bug, "slope.right.random", -0.5, 0.15);
}

#[test]
fn each_stage_of_the_path_is_tested() {
    let path = outcome("kind = \"worked-path\"\nintegrand = \"xy\"");
    assert!(holds(&path, "passes"));
    near(&path, "exact", 0.25, 0.0);
    near(&path, "slope.independent", -0.5, 0.15);
    near(&path, "slope.jittered", -1.0, 0.15);
    assert!(number(&path, "gain.sobol+owen") > 20.0);
}

#[test]
fn wrong_questions_are_told_and_odd_ones_drawn() {
    for wrong in [
        "kind = \"distribution\"",
        "kind = \"distribution\"\nlaw = \"normal\"\ndensity = \"x\"",
        "kind = \"distribution\"\nlaw = \"normal\"\na = 2\nb = 1",
        "kind = \"importance\"\nintegrand = \"x\"\ndensities = [\"1\", \"x\"]\nnames = [\"one\"]",
        "kind = \"estimate-table\"\nintegrand = \"xy\"\ndomain = [0, 2]",
        "kind = \"coverage\"\nintegrand = \"x\"\nsamplers = [\"sobol\"]",
        "kind = \"middle-square\"\ndigits = 3",
        "kind = \"bug\"\nbug = \"rejecton\"",
        "kind = \"bug-matrix\"\nsampler = \"halton\"",
        "kind = \"quadrature\"\ndimensions = [16]",
    ] {
        assert!(plan(wrong).is_err(), "{wrong}");
    }
    for failing in [
        "kind = \"distribution\"\ndensity = \"x - 0.5\"",
        "kind = \"distribution\"\ndensity = \"0*x\"",
        "kind = \"distribution\"\ndensity = \"1/(x-0.3)^2\"",
        "kind = \"importance\"\nintegrand = \"1/x\"\ndensities = [\"1\"]",
        "kind = \"quadrature\"\nintegrand = \"2 + 0*x\"\ndimensions = [1]",
    ] {
        let failure = plan(failing).unwrap_or_else(|told| panic!("{failing}: {told:?}")).run(Seed::new(1));
        let failure = failure.expect_err(failing);
        assert!(failure.message.len() > 20 && failure.help.is_some(), "{failure:?}");
    }
    let sheet = Sheet::new("fig-a", "A", "B");
    for odd in [
        "kind = \"buffon\"\nneedles = 1\nn = 1\nshow = \"table\"",
        "kind = \"quicksort\"\nlength = 3\nbins = 200\nruns = 100\nn = 1",
        "kind = \"middle-square\"\ndigits = 2\nbins = 200",
        "kind = \"bias\"\nintegrand = \"x\"\nn = 1\nreplicates = 10",
        "kind = \"estimate-table\"\nintegrand = \"x\"\nn = 1\nshow = \"figure\"",
        "kind = \"estimate-table\"\nintegrand = \"x\"\nsampler = \"sobol\"\nshow = \"figure\"",
        "kind = \"coverage\"\nintegrand = \"x\"\nsamplers = [\"independent\"]\nn = 1\nrandomisations = 2\nrepetitions = 10\nshown = 10",
        "kind = \"distribution\"\ndensity = \"1e9\"\nshow = \"inversion\"\narrows = 1",
        "kind = \"distribution\"\nlaw = \"exponential\"\nfrom = -2\nto = 40",
        "kind = \"importance\"\nintegrand = \"0.5 - x\"\ndensities = [\"1\"]",
    ] {
        let experiment = plan(odd).unwrap_or_else(|told| panic!("{odd}: {told:#?}"));
        let outcome = experiment.run(Seed::new(1)).unwrap_or_else(|failure| panic!("{odd}: {failure:?}"));
        match experiment.draw(&outcome, &sheet).unwrap_or_else(|failure| panic!("{odd}: {failure:?}")) {
            Drawing::Figure(figure) => assert!(figure.svg.contains("<svg"), "{odd}"),
            Drawing::Table(table) => assert!(!table.rows.is_empty(), "{odd}"),
            other => panic!("{odd}: {other:?}"),
        }
        let alt = experiment.alt(&outcome).unwrap_or_default();
        assert!(alt.ends_with('.') && !alt.contains("NaN") && !alt.contains("inf"), "{odd}: {alt}");
        let whole = experiment
            .tables(&outcome)
            .iter()
            .all(|frame| frame.columns.iter().all(|(_, entries)| entries.len() == frame.rows()));
        assert!(whole, "{odd}");
    }
}

#[test]
fn the_number_of_threads_never_shows() {
    for fence in [
        "kind = \"importance\"\nintegrand = \"x\"\ndensities = [\"1\", \"1 + x\"]",
        "kind = \"bias\"\nintegrand = \"x\"\nreplicates = 50",
        "kind = \"coverage\"\nintegrand = \"x\"\nsamplers = [\"independent\", \"sobol+owen\"]\nrepetitions = 50",
        "kind = \"quadrature\"\nmost = 7000\nreplicates = 4",
        "kind = \"quicksort\"\nlength = 50\nruns = 50\nn = 10",
        "kind = \"buffon\"\nn = 200000\ntrials = 100",
        "kind = \"bug\"\nbug = \"rejection\"",
        "kind = \"worked-path\"\nintegrand = \"xy\"",
    ] {
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| outcome(fence)).bytes
        };
        assert!(on(1) == on(4), "{fence}");
    }
}
