//! Exact and published values: sequences against tables, variances and rates against theory.

use workbook::integrands::Function;
use workbook::samplers::halton::radical_inverse;
use workbook::samplers::sobol::sobol;
use workbook::samplers::van_der_corput::bit_reversal;
use workbook::samplers::{Method, Sampler, halton::Halton, sobol::Sobol};
use workbook::seed::Seed;
use workbook::stats::moments::Moments;
use workbook::stats::{portable, regression::least_squares};

/// The rows of a table of numerators, without the index.
fn numerators(text: &str) -> Vec<Vec<u32>> {
    let rows = text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
    rows.map(|line| line.split(',').skip(1).map(|cell| cell.parse().expect("a number")).collect()).collect()
}

#[test]
fn sobol_is_the_joe_kuo_table_in_natural_order() {
    let table = numerators(include_str!("../data/sobol_joekuo_d40_n256.csv"));
    assert_eq!((table.len(), table[0].len()), (256, 40));
    let points = Sobol.points(256, 40, Seed::new(1)).expect("admitted");
    for (i, (row, point)) in table.iter().zip(points.rows()).enumerate() {
        for (axis, (&numerator, &x)) in row.iter().zip(point).enumerate() {
            assert_eq!(x, f64::from(numerator) / 1024.0, "point {i}, axis {axis}");
            assert_eq!(x, sobol(i as u64, axis));
        }
    }
}

#[test]
fn halton_is_the_exact_table() {
    let text = include_str!("../data/halton_d33_n256.csv");
    let header = text.lines().find(|line| line.starts_with("i,")).expect("a header");
    let scales: Vec<f64> = header
        .split(',')
        .skip(1)
        .map(|name| {
            let (base, exponent) = name.trim_start_matches("num_over_").split_once('^').expect("a power");
            portable::power(base.parse().expect("a base"), exponent.parse().expect("an exponent"))
        })
        .collect();
    let points = Halton.points(256, 33, Seed::new(1)).expect("admitted");
    for (i, (row, point)) in numerators(text).iter().zip(points.rows()).enumerate() {
        for axis in 0..33 {
            assert_eq!(point[axis], f64::from(row[axis]) / scales[axis], "point {i}, axis {axis}");
        }
    }
}

#[test]
fn faure_is_the_exact_table() {
    let base3 = (numerators(include_str!("../data/faure_b3_n243.csv")), 3, 243.0);
    let base5 = (numerators(include_str!("../data/faure_b5_n125.csv")), 5, 125.0);
    for (table, d, scale) in [base3, base5] {
        let points = Method::parse("faure").expect("known").points(table.len(), d, Seed::new(1)).expect("admitted");
        for (i, (row, point)) in table.iter().zip(points.rows()).enumerate() {
            let expected: Vec<f64> = row.iter().map(|&numerator| f64::from(numerator) / scale).collect();
            assert_eq!(point, expected, "base {d}, point {i}");
        }
    }
}

#[test]
fn folded_inverses_are_the_exact_fractions() {
    let exact = [1.0 / 3.0, 5.0 / 6.0, 1.0 / 12.0, 7.0 / 12.0, 11.0 / 24.0, 23.0 / 24.0, 5.0 / 24.0, 17.0 / 24.0];
    for (i, x) in exact.into_iter().enumerate() {
        let folded = workbook::samplers::folded::folded_inverse(i as u64, 2);
        assert!((folded - x).abs() <= 1.2e-16, "{i}: {folded} against {x}");
    }
}

/// Trap 3: where digits summed in single precision reach 1, the integer form stays below, in `f64`
/// and rounded to `f32` towards 0.
#[test]
fn radical_inverses_stay_below_one_where_the_lecture_reaches_it() {
    let traps =
        [(33_554_431, 2), (43_046_720, 3), (29_296_874, 5), (28_824_004, 7), (17_715_609, 11), (62_748_516, 13)];
    for (index, base) in traps {
        let x = radical_inverse(index, base);
        let mut exact = (0_u128, 1_u128);
        let mut rest = u128::from(index);
        while rest > 0 {
            exact = (exact.0 * u128::from(base) + rest % u128::from(base), exact.1 * u128::from(base));
            rest /= u128::from(base);
        }
        assert_eq!(x, exact.0 as f64 / exact.1 as f64);
        assert!(x < 1.0 && x > 0.999_999);
    }
    assert_eq!(bit_reversal(33_554_431), 1.0 - 1.0 / 33_554_432.0);
    for index in [u64::from(u32::MAX), u64::MAX, 1 << 53, (1 << 53) - 1] {
        assert!(bit_reversal(index) < 1.0);
        for base in 2..300 {
            assert!(radical_inverse(index, base) < 1.0, "index {index}, base {base}");
        }
    }
}

/// Trap 1 and the table of the lecture: the mean of the first n van der Corput points, in the
/// digits known.
#[test]
fn the_deck_by_van_der_corput() {
    let function = Function::parse("exp-sin").expect("catalogued");
    for (n, estimate) in
        [(1_u64, 1.0), (10, 1.732_755_503_189_878_7), (16, 1.769_131_563_134_057_2), (100, 1.773_676_336_328_305_7)]
    {
        let moments: Moments = (0..n).map(|i| function.evaluate(&[bit_reversal(i)])).collect();
        assert!((moments.mean() - estimate).abs() < 1e-14, "n = {n}: {}", moments.mean());
    }
    let top = function.evaluate(&[(std::f64::consts::PI / 6.0).sqrt()]);
    assert!(top <= std::f64::consts::E && std::f64::consts::E - top < 1e-9);
}

/// First 131 points of axes 32 and 33 lie on one line; 256 points are still correlated at 0.849.
#[test]
fn halton_axes_32_and_33_are_correlated() {
    for (n, correlation) in [(131, 1.0), (256, 0.849)] {
        let points = Halton.points(n, 33, Seed::new(1)).expect("admitted");
        let (x, y): (Vec<f64>, Vec<f64>) = points.rows().map(|row| (row[31], row[32])).unzip();
        let (slope, inverse) =
            (least_squares(&x, &y).expect("a line").slope, least_squares(&y, &x).expect("a line").slope);
        let measured = slope.signum() * (slope * inverse).sqrt();
        assert!((measured - correlation).abs() < 5e-4, "n = {n}: {measured}");
    }
}

/// With random digit permutations that correlation is gone.
#[test]
fn permutations_break_the_correlation_of_halton() {
    for seed in 0..10 {
        let points =
            Method::parse("halton+permutation").expect("known").points(256, 33, Seed::new(seed)).expect("admitted");
        let (x, y): (Vec<f64>, Vec<f64>) = points.rows().map(|row| (row[31], row[32])).unzip();
        let (slope, inverse) =
            (least_squares(&x, &y).expect("a line").slope, least_squares(&y, &x).expect("a line").slope);
        assert!(slope * inverse < 0.09, "seed {seed}: r^2 = {}", slope * inverse);
    }
}

/// Trap 8 of hash-based scrambling: raw consecutive seeds bias E[xy]; ours are hashed, and the mean
/// over consecutive seeds is 1/4.
#[test]
fn consecutive_seeds_do_not_bias_the_product() {
    let method = Method::parse("sobol+owen-hash").expect("known");
    let mean_of =
        |seed| method.points(1, 2, Seed::new(seed)).expect("admitted").rows().map(|x| x[0] * x[1]).sum::<f64>();
    let moments: Moments = (0..4000).map(mean_of).collect();
    assert!((moments.mean() - 0.25).abs() < 5.0 * moments.standard_error(), "{moments:?}");
}

/// A Cranley-Patterson shift of 16 points keeps every dyadic interval filled with probability 2.3
/// %; XOR and Owen always do.
#[test]
fn shifts_rarely_keep_the_net() {
    let kept = |name: &str| {
        let method = Method::parse(name).expect("known");
        let nets = (0..2000)
            .filter(|&seed| crate::checks::is_net(&method.points(16, 2, Seed::new(seed)).expect("admitted"), 2, 0));
        nets.count() as f64 / 2000.0
    };
    let share = kept("sobol+cranley-patterson");
    assert!((share - 0.023).abs() < 5.0 * (0.023_f64 * 0.977 / 2000.0).sqrt(), "{share}");
    assert_eq!((kept("sobol+xor"), kept("sobol+owen"), kept("sobol+owen-hash")), (1.0, 1.0, 1.0));
}

/// The errors of `replicates` estimates of the mean of `function`.
fn errors(method: &str, function: &str, n: usize, replicates: u64) -> Vec<f64> {
    let (method, function) = (Method::parse(method).expect(method), Function::parse(function).expect(function));
    let d = function.dimensions().unwrap_or(2);
    let exact = function.integral(d).expect("known").value;
    let seed = Seed::new(20);
    let estimate =
        |points: workbook::points::Points| points.rows().map(|x| function.evaluate(x)).collect::<Moments>().mean();
    (0..replicates).map(|k| estimate(method.points(n, d, seed.at(k)).expect("admitted")) - exact).collect()
}

/// The variance of xy under one shared offset (u, v) in a 4 x 4 grid: the mean of (c + u)(r + v) /
/// 16 over the cells is (3/2 + u)(3/2 + v) / 16, of variance (E\[(3/2 + u)^2\]^2 - 16) / 256 with
/// E\[(3/2 + u)^2\] = 4 + 1/12.
const UNIFORM_JITTER_XY: f64 = ((49.0 / 12.0) * (49.0 / 12.0) - 16.0) / 256.0;

/// The variance of the 16-point estimate, where theory knows it: within 5 standard errors of the
/// sample variance.
#[test]
fn variances_at_16_points_are_the_exact_ones() {
    let cases = [
        ("independent", "xy", 7.0 / 2304.0),
        ("jittered", "xy", 127.0 / 589_824.0),
        ("latin-hypercube", "xy", 71407.0 / 150_994_944.0),
        ("independent", "x", 1.0 / 192.0),
        ("jittered", "x", 1.0 / 49152.0),
        ("latin-hypercube", "x", 1.0 / 49152.0),
        ("multi-jittered", "x", 1.0 / 49152.0),
        ("uniform-jitter", "xy", UNIFORM_JITTER_XY),
        ("pmj02", "xy", 7.0 / 147_456.0),
        ("van-der-corput+xor", "x", 1.0 / 3072.0),
        ("sobol+xor", "x", 1.0 / 3072.0),
        ("van-der-corput+cranley-patterson", "x", 1.0 / 3072.0),
        ("van-der-corput+owen", "x", 1.0 / 49152.0),
        ("van-der-corput+linear", "x", 1.0 / 49152.0),
        ("sobol+owen", "xy", 7.0 / 147_456.0),
        ("sobol+linear", "xy", 7.0 / 147_456.0),
        ("sobol+owen-hash", "xy", 7.0 / 147_456.0),
        ("sobol+owen-shuffled", "xy", 7.0 / 147_456.0),
    ];
    for (method, function, exact) in cases {
        let squares: Moments = errors(method, function, 16, 4000).iter().map(|error| error * error).collect();
        let z = (squares.mean() - exact) / squares.standard_error();
        assert!(z.abs() < 5.0, "{method} on {function}: {} against {exact}, z = {z}", squares.mean());
    }
}

/// Latin hypercubes and the sum of d coordinates: d / (12 n^3).
#[test]
fn latin_hypercubes_take_sums_apart() {
    let (method, sum) = (Method::parse("latin-hypercube").expect("known"), Function::parse("sum").expect("known"));
    for (n, d) in [(4, 3), (16, 5)] {
        let estimate = |seed| {
            method
                .points(n, d, Seed::new(seed))
                .expect("admitted")
                .rows()
                .map(|x| sum.evaluate(x))
                .collect::<Moments>()
                .mean()
        };
        let squares: Moments = (0..3000).map(|seed| portable::power(estimate(seed) - d as f64 / 2.0, 2)).collect();
        let exact = d as f64 / (12.0 * portable::power(n as f64, 3));
        assert!(
            (squares.mean() - exact).abs() < 5.0 * squares.standard_error(),
            "n = {n}, d = {d}: {squares:?} against {exact}"
        );
    }
}

/// Given to three digits: multi-jitter 7.86e-5, correlated multi-jitter 2.68e-4, which is worse
/// than plain jitter's 2.15e-4.
#[test]
fn correlated_multi_jitter_is_worse_on_the_product() {
    for (method, published) in [("multi-jittered", 7.86e-5), ("correlated-multi-jittered", 2.68e-4)] {
        let squares: Moments = errors(method, "xy", 16, 20_000).iter().map(|error| error * error).collect();
        let off = (squares.mean() - published).abs();
        assert!(off < 5.0 * squares.standard_error() + 0.005 * published, "{method}: {squares:?}");
    }
}

/// The saturation limits of random sequential adsorption on the torus: coverage 0.547, relative
/// radius 0.7767.
#[test]
fn maximal_poisson_sets_reach_saturation() {
    use workbook::samplers::maximal_poisson::saturate;
    let radius = 0.02;
    let counts: Moments = (0..10).map(|seed| saturate(radius, &mut Seed::new(seed).generator()).len() as f64).collect();
    let coverage = counts.mean() * std::f64::consts::PI * radius * radius / 4.0;
    assert!((coverage - 0.54707).abs() < 0.005, "coverage {coverage}");
    let relative = radius / workbook::samplers::poisson::hexagonal(counts.mean() as usize);
    assert!((relative - 0.7767).abs() < 0.004, "relative radius {relative}");
}

/// Saturated means saturated: no point of a fine grid is farther than the radius from all points.
#[test]
fn maximal_poisson_sets_have_no_hole() {
    use workbook::samplers::poisson::squared_distance;
    let radius = 0.08;
    let places = workbook::samplers::maximal_poisson::saturate(radius, &mut Seed::new(5).generator());
    let holes = (0..40_000).map(|k| [f64::from(k % 200) / 200.0, f64::from(k / 200) / 200.0]);
    let nearest = |hole| places.iter().map(|&place| squared_distance(place, hole)).fold(f64::INFINITY, f64::min);
    assert!(holes.map(nearest).all(|square| square < radius * radius));
}

/// The integrands of the table of slopes.
const RATED: [&str; 5] = ["disk", "edge", "step", "gaussian", "xy"];

/// For each of [`RATED`] the slope of log RMSE over log n for n = 2^4 .. 2^14, as far as the method gives them.
fn slopes(method: &str, replicates: u64) -> Vec<f64> {
    let method = Method::parse(method).expect(method);
    let functions = RATED.map(|name| Function::parse(name).expect(name));
    let exact = functions.each_ref().map(|function| function.integral(2).expect("known").value);
    let exponents: Vec<u32> = (4..=14).filter(|&exponent| method.admits(1 << exponent, 2).is_ok()).collect();
    let mut logarithms = vec![Vec::new(); RATED.len()];
    for &exponent in &exponents {
        let mut squares = [0.0; RATED.len()];
        for k in 0..replicates {
            let points = method.points(1 << exponent, 2, Seed::new(20).at(k)).expect("admitted");
            for ((square, function), exact) in squares.iter_mut().zip(&functions).zip(exact) {
                let mean = points.rows().map(|x| function.evaluate(x)).sum::<f64>() / points.len() as f64;
                *square += (mean - exact) * (mean - exact);
            }
        }
        for (logarithms, square) in logarithms.iter_mut().zip(squares) {
            logarithms.push(0.5 * portable::log2(square / replicates as f64));
        }
    }
    let x: Vec<f64> = exponents.into_iter().map(f64::from).collect();
    logarithms.iter().map(|y| least_squares(&x, y).expect("many points").slope).collect()
}

/// The published rates in two dimensions: within 0.05 at 128 replicates, whose slopes have standard
/// errors of about 0.01.
#[test]
fn slopes_of_the_error_are_the_published_ones() {
    let table = [
        ("independent", [-0.51, -0.50, -0.50, -0.51, -0.51]),
        ("jittered", [-0.76, -0.75, -0.73, -1.00, -0.99]),
        ("latin-hypercube", [-0.51, -0.51, -0.99, -0.51, -0.51]),
        ("multi-jittered", [-0.75, -0.74, -0.98, -1.04, -1.02]),
        ("halton+permutation", [-0.76, -0.75, -1.01, -0.94, -0.94]),
        ("sobol+cranley-patterson", [-0.80, -0.59, -0.99, -0.97, -0.92]),
        ("sobol+xor", [-0.77, -0.52, -1.02, -1.01, -1.01]),
        ("sobol+owen", [-0.76, -0.72, -0.99, -1.44, -1.41]),
        ("sobol+owen-hash", [-0.76, -0.72, -0.99, -1.44, -1.41]),
    ];
    let mut off = Vec::new();
    for (method, expected) in table {
        for ((function, expected), measured) in RATED.into_iter().zip(expected).zip(slopes(method, 128)) {
            if (measured - expected).abs() > 0.05 {
                off.push(format!("{method} on {function}: {measured} against {expected}"));
            }
        }
    }
    assert!(off.is_empty(), "{off:#?}");
}
