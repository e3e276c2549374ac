//! Functions, expressions and statistics against exact values.

use workbook::integrands::{Calculation, Function, INTEGRANDS};
use workbook::samplers::Method;
use workbook::seed::Seed;
use workbook::stats::moments::Moments;
use workbook::stats::portable::power;
use workbook::stats::quadrature::integrate;

/// Every catalogued smooth integrand agrees with quadrature, in mean and variance.
#[test]
fn catalogued_integrals_agree_with_quadrature() {
    let mut smooth = 0;
    for integrand in INTEGRANDS {
        for d in integrand.dimensions().map_or(vec![1, 2, 3], |d| vec![d]) {
            let (Some(mean), Some(variance)) = (integrand.integral(d), integrand.variance(d)) else { continue };
            let Some(numeric) = integrate(d, |x| integrand.evaluate(x)) else { continue };
            let key = integrand.about().key;
            assert!((numeric.value - mean).abs() <= numeric.error + 1e-13, "{key}: {numeric:?}, stated {mean}");
            let Some(square) = integrate(d, |x| power(integrand.evaluate(x) - mean, 2)) else { continue };
            assert!(
                (square.value - variance).abs() <= square.error + 1e-13,
                "{key}, d = {d}: variance {square:?}, stated {variance}"
            );
            smooth += 1;
        }
    }
    assert!(smooth >= 18, "only {smooth} integrands were smooth enough to check");
}

/// Genz's families against closed forms in 40 digits.
#[test]
fn genz_families_have_their_integrals() {
    let mut rows = 0;
    for line in include_str!("../data/genz.csv").lines().filter(|line| !line.starts_with(['#', 'f'])) {
        let cells: Vec<&str> = line.split(',').collect();
        let key = if cells[0] == "c0" { "continuous".to_owned() } else { cells[0].replace('_', "-") };
        let function = Function::parse(&format!("genz-{key}")).expect("catalogued");
        let (d, exact): (usize, f64) = (cells[1].parse().expect("d"), cells[4].parse().expect("a value"));
        let stated = function.integral(d).expect("known").value;
        assert!((stated - exact).abs() <= 4e-15 * exact.abs(), "{line}: {stated}");
        rows += 1;
    }
    assert_eq!(rows, 18);
}

/// What has a kink or a jump, against a scrambled net of 2^14 points, within 5 standard errors, in
/// mean and variance.
#[test]
fn every_integrand_agrees_with_scrambled_nets() {
    let method = Method::parse("sobol+owen-hash").expect("known");
    for integrand in INTEGRANDS {
        for d in integrand.dimensions().map_or(vec![1, 2, 5], |d| vec![d]) {
            let (Some(mean), Some(variance)) = (integrand.integral(d), integrand.variance(d)) else { continue };
            let (mut means, mut squares) = (Moments::default(), Moments::default());
            for seed in 0..12 {
                let points = method.points(1 << 10, d, Seed::new(seed)).expect("admitted");
                means.push(points.rows().map(|x| integrand.evaluate(x)).collect::<Moments>().mean());
                squares.push(points.rows().map(|x| power(integrand.evaluate(x) - mean, 2)).collect::<Moments>().mean());
            }
            let key = integrand.about().key;
            assert!(
                (means.mean() - mean).abs() <= 6.0 * means.standard_error() + 1e-14,
                "{key}, d = {d}: {means:?} against {mean}"
            );
            let off = (squares.mean() - variance).abs();
            // In many dimensions the square of a peak is too rare an event for so few points.
            assert!(
                d > 2 || off <= 6.0 * squares.standard_error() + 1e-14,
                "{key}, d = {d}: variance {squares:?} against {variance}"
            );
        }
    }
}

/// Integrands with jumps, on a fine grid of midpoints: the error is at most the share of cells that
/// the jump crosses.
#[test]
fn discontinuous_integrals_agree_with_a_fine_grid() {
    for (key, crossed) in [("disk", 2.0), ("edge", 2.0), ("step", 1.0)] {
        let function = Function::parse(key).expect("catalogued");
        let k = 1000_u32;
        let middle = |i: u32| (f64::from(i) + 0.5) / f64::from(k);
        let total: f64 = (0..k * k).map(|i| function.evaluate(&[middle(i % k), middle(i / k)])).sum();
        let (mean, stated) = (total / f64::from(k * k), function.integral(2).expect("known").value);
        assert!((mean - stated).abs() <= crossed / f64::from(k), "{key}: {mean} against {stated}");
        let variance = function.variance(2).expect("known");
        assert!((variance - stated * (1.0 - stated)).abs() < 1e-15, "{key}: variance {variance}");
    }
}

/// Each expression at a point, against arithmetic by hand.
#[test]
fn expressions_mean_what_print_means() {
    let cases: &[(&str, &[f64], f64)] = &[
        ("-x^2", &[3.0], -9.0),
        ("2^3^2", &[], 512.0),
        ("2^-2", &[], 0.25),
        ("-2^2 + x1", &[1.0], -3.0),
        ("1 - 2 - 3", &[], -4.0),
        ("8/4/2", &[], 1.0),
        ("x*y + z", &[2.0, 3.0, 4.0], 10.0),
        ("x < 0.3", &[0.2], 1.0),
        ("x1 >= x2", &[0.2, 0.3], 0.0),
        ("x^2 + y^2 < 2/pi", &[0.5, 0.5], 1.0),
        ("max(x, 1 - x)", &[0.2], 0.8),
        ("pow(x, 3) + 1e-3 + .5 + 2.", &[2.0], 10.501),
        ("sqrt(abs(-4))", &[], 2.0),
        ("+x - -x", &[1.5], 3.0),
        ("2 ** 3 * x", &[2.0], 16.0),
        ("x^0.5", &[4.0], 2.0),
        ("-(1 + x)", &[1.0], -2.0),
        ("e^x - exp(x)", &[1.0], 0.0),
        ("x12", &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 7.0], 7.0),
    ];
    for (text, x, value) in cases {
        let function = Function::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert!((function.evaluate(x) - value).abs() < 1e-15, "{text}: {}", function.evaluate(x));
    }
}

/// Functions that chapters use to compute with, against tables (Abramowitz and Stegun 7.1, 26.1) and by hand.
#[test]
fn calculations_have_the_functions_of_statistics() {
    let cases: &[(&str, f64)] = &[
        ("normal_cdf(1)", 0.841_344_746_068_542_9),
        ("normal_quantile(0.975)", 1.959_963_984_540_054),
        ("erf(1) + erfc(1)", 1.0),
        ("factorial(0) + factorial(5)", 121.0),
        ("factorial(20)", 2_432_902_008_176_640_000.0),
        ("round(2.5) + floor(-0.5) + ceil(0.5)", 3.0),
        ("log2(1024) + log10(1000) + ln(e)", 14.0),
    ];
    for (text, value) in cases {
        let found = Calculation::parse(text).unwrap_or_else(|error| panic!("{text}: {error}")).evaluate(&[]);
        assert!((found - value).abs() <= 1e-15 * value.abs(), "{text}: {found}");
    }
    for text in ["factorial(1.5)", "factorial(-1)", "factorial(171)", "factorial(1e300)"] {
        assert!(!Calculation::parse(text).expect(text).evaluate(&[]).is_finite(), "{text}");
    }
}

/// Names in brackets are variables in the order of the text, whatever they look like; coordinates are none.
#[test]
fn calculations_name_values_in_brackets() {
    let text = "[ fig-a.x-1 ]/[b] - 2*[fig-a.x-1]^[c.4]";
    let calculation = Calculation::parse(text).expect("valid");
    let names: Vec<(&str, usize)> = calculation.names().map(|(name, range)| (name, range.start)).collect();
    assert_eq!(names, [("fig-a.x-1", 2), ("b", 15), ("fig-a.x-1", 23), ("c.4", 35)]);
    assert_eq!(calculation.evaluate(&[8.0, 4.0, 3.0, 2.0]), -16.0);
    let cases: &[(&str, std::ops::Range<usize>, &str, Option<&str>)] = &[
        ("1 + x", 4..5, "no `x`", None),
        ("x1", 0..2, "no `x1`", None),
        ("1 + [a", 4..5, "not closed", None),
        ("1 + []", 4..6, "no name", None),
        ("[[a]]", 0..4, "no name", None),
        ("[a]]", 3..4, "no place", None),
        ("[a][b]", 3..6, "operator is missing", None),
        ("sqrrt([a])", 0..5, "no `sqrrt`", Some("sqrt")),
        ("log(2)", 0..3, "no `log`", Some("ln")),
    ];
    for (text, range, message, suggestion) in cases {
        let error = Calculation::parse(text).expect_err(text);
        assert_eq!(&error.range, range, "{text}: {error}");
        assert!(error.message.contains(message), "{text}: {error}");
        assert_eq!(error.suggestion.as_deref(), *suggestion, "{text}: {error}");
    }
    assert!(Function::parse("[a]").is_err(), "an integrand has coordinates, no names");
}

/// The deck's function as text is, bit for bit, the catalogued one.
#[test]
fn the_deck_as_text_gives_the_same_bits() {
    let (text, catalogued) =
        (Function::parse("exp(sin(3*x^2))").expect("valid"), Function::parse("exp-sin").expect("known"));
    let same = (0..1000).all(|i| {
        let x = [f64::from(i) / 1000.0];
        // 3 * (x * x) against 3 * x * x: the two may differ in the last bit of the argument.
        (text.evaluate(&x) - catalogued.evaluate(&x)).abs() <= 4e-15
    });
    assert!(same);
    assert_eq!(text.dimensions(), Some(1));
}

/// Each mistake is told with its bytes.
#[test]
fn mistakes_are_told_with_their_place() {
    let cases: &[(&str, std::ops::Range<usize>, &str, Option<&str>)] = &[
        ("", 0..0, "empty", None),
        ("  ", 0..2, "empty", None),
        ("exp(sine(x))", 4..8, "no `sine`", Some("sin")),
        ("lug10(x)", 0..5, "no `lug10`", Some("log10")),
        ("3 * x $ 2", 6..7, "`$` has no place", None),
        ("3 * \u{3b1}", 4..6, "has no place", None),
        ("(x + 1", 0..1, "not closed", None),
        ("sin(x", 3..4, "not closed", None),
        ("x + 1)", 5..6, "closes nothing", None),
        ("x + ", 3..3, "operand is missing", None),
        ("x + * y", 4..5, "operand is missing", None),
        ("()", 1..2, "operand is missing", None),
        ("3 x", 2..3, "operator is missing", None),
        ("3x^2", 1..2, "operator is missing", None),
        ("(x)(y)", 3..4, "operator is missing", None),
        ("sin x", 4..5, "in parentheses", None),
        ("max(x)", 5..6, "two arguments", None),
        ("sin(x, y)", 5..6, "one argument too many", None),
        ("1, 2", 1..2, "comma", None),
        ("1.2.3", 3..5, "operator is missing", None),
        ("x0", 0..2, "no `x0`", Some("x")),
        ("x == 1", 2..3, "compares", None),
        ("gausian", 0..7, "no `gausian`", Some("gaussian")),
    ];
    for (text, range, message, suggestion) in cases {
        let error = Function::parse(text).expect_err(text);
        assert_eq!(&error.range, range, "{text}: {error}");
        assert!(error.message.contains(message), "{text}: {error}");
        assert_eq!(error.suggestion.as_deref(), *suggestion, "{text}: {error}");
    }
}

/// Deep or long expressions are refused, not a crash.
#[test]
fn deep_and_long_expressions_are_refused() {
    for text in ["(".repeat(100_000), "-".repeat(100_000), format!("x{}", "+x".repeat(100_000)), "sin(".repeat(200)] {
        assert!(Function::parse(&text).is_err());
    }
    let sum = Function::parse(&format!("x{}", "+x".repeat(400))).expect("a long sum");
    assert_eq!(sum.evaluate(&[1.0]), 401.0);
}

/// LaTeX groups as the tree does.
#[test]
fn formulas_are_latex() {
    let cases = [
        ("exp(sin(3*x^2))", r"\exp\left(\sin\left(3 x^{2}\right)\right)"),
        ("(x + y)*x1/2", r"\frac{\left(x + y\right) \, x_{1}}{2}"),
        ("x - (y - 1)", r"x - \left(y - 1\right)"),
        ("(-x)^2", r"\left(-x\right)^{2}"),
        ("x < 0.3", r"\left[x < 0.3\right]"),
        ("sqrt(x)*2", r"\sqrt{x} \cdot 2"),
    ];
    for (text, latex) in cases {
        assert_eq!(Function::parse(text).expect(text).formula(), latex, "{text}");
    }
}

/// An expression's integral: by quadrature with a bound, or not at all.
#[test]
fn integrals_of_expressions() {
    let integral = |text: &str, d| Function::parse(text).expect(text).integral(d);
    let smooth = integral("x*y", 2).expect("smooth");
    assert!((smooth.value - 0.25).abs() <= smooth.error);
    assert!((integral("x", 3).expect("any d above its own").value - 0.5).abs() < 1e-15);
    assert!((integral("3", 2).expect("a constant").value - 3.0).abs() < 1e-14);
    assert_eq!(integral("x < 0.3", 1), None);
    assert_eq!(integral("1/x", 1), None);
    assert_eq!(integral("x*y", 1), None);
    let variance = Function::parse("x + 1000").expect("valid").variance(1).expect("smooth");
    assert!((variance - 1.0 / 12.0).abs() < 1e-12);
}
