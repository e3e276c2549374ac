//! The measures against values in rational arithmetic, closed forms and brute force.

use crate::checks::relative_radius;
use workbook::integrands::Function;
use workbook::metrics::{METRICS, correlation, dispersion, l2, measure, nets, occupancy, spectrum, star};
use workbook::points::Points;
use workbook::samplers::larcher_pillichshammer::ones;
use workbook::samplers::van_der_corput::{bit_reversal, reversed_bits};
use workbook::samplers::{Method, Radix};
use workbook::seed::Seed;
use workbook::stats::moments::Moments;
use workbook::stats::portable::{self, power};

fn points(name: &str, n: usize, d: usize, seed: u64) -> Points {
    Method::parse(name).expect(name).points(n, d, Seed::new(seed)).expect(name)
}

/// The set of trap 7: (Phi_2, LP) as if it were a sequence.
fn larcher_as_sequence(n: usize) -> Points {
    let radix = Radix::new(2);
    let rows = (0..n as u64).flat_map(|i| [radix.coordinate(reversed_bits(i)), radix.coordinate(ones(i))]);
    Points::from_rows(2, rows.collect()).expect("pairs")
}

/// Every row of the table: exact star and L2 star discrepancies, and the squared forms of
/// Hickernell.
#[test]
fn discrepancies_are_those_of_the_table() {
    let table = include_str!("../data/discrepancy.csv");
    let mut rows = 0;
    for line in
        table.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_lowercase()) && !line.starts_with("set,"))
    {
        let cells: Vec<&str> = line.split(',').collect();
        let (d, n): (usize, usize) = (cells[1].parse().expect("d"), cells[2].parse().expect("N"));
        let points = match cells[0] {
            "lp_net" => points("larcher-pillichshammer", n, d, 1),
            "vdc_lp_as_sequence_BAD" => larcher_as_sequence(n),
            "centred_grid" => points("centred-grid", n, d, 1),
            name => points(name, n, d, 1),
        };
        let close = |measured: f64, cell: &str, what: &str| {
            let expected: f64 = cell.parse().expect("a number");
            assert!((measured - expected).abs() < 1e-13, "{line}: {what} is {measured}");
        };
        let star = star::star_discrepancy(&points).expect("valid");
        if !cells[4].is_empty() {
            close(star.value, cells[4], "D*");
            assert!(!star.is_bound);
        }
        assert!(
            (l2::star(&points) - cells[6].parse::<f64>().expect("L2*")).abs() < 1e-12,
            "{line}: {}",
            l2::star(&points)
        );
        close(power(l2::centred(&points), 2), cells[7], "centred, squared");
        close(power(l2::wrap_around(&points), 2), cells[8], "wrap-around, squared");
        rows += 1;
    }
    assert!(rows > 35, "only {rows} rows were read");
}

/// The value of `points` at the extremal box, counted by hand, open or closed, is the discrepancy.
pub fn attained(points: &Points, corner: &[f64], value: f64) -> bool {
    let (n, volume) = (points.len() as f64, corner.iter().product::<f64>());
    let share = |inside: &dyn Fn(f64, f64) -> bool| {
        points.rows().filter(|x| x.iter().zip(corner).all(|(&x, &q)| inside(x, q))).count() as f64 / n
    };
    let (open, closed) = (volume - share(&|x, q| x < q), share(&|x, q| x <= q) - volume);
    (open.max(closed) - value).abs() < 1e-12
}

/// All boxes of the grid, one by one.
pub fn star_by_force(points: &Points) -> f64 {
    let d = points.dimensions();
    let grid: Vec<Vec<f64>> = (0..d).map(|axis| points.axis(axis).chain([1.0]).collect()).collect();
    let mut best = 0.0_f64;
    for box_number in 0..grid[0].len().pow(d as u32) {
        let mut rest = box_number;
        let corner: Vec<f64> = grid
            .iter()
            .map(|values| {
                let value = values[rest % values.len()];
                rest /= values.len();
                value
            })
            .collect();
        let volume: f64 = corner.iter().product();
        let count = |inside: &dyn Fn(&f64, &f64) -> bool| {
            points.rows().filter(|x| x.iter().zip(&corner).all(|(x, q)| inside(x, q))).count() as f64
                / points.len() as f64
        };
        best = best.max(volume - count(&|x, q| x < q)).max(count(&|x, q| x <= q) - volume);
    }
    best
}

#[test]
fn star_discrepancy_agrees_with_brute_force() {
    for (n, d) in [(1, 1), (7, 1), (1, 2), (2, 2), (13, 2), (40, 2), (1, 3), (9, 3), (14, 3), (7, 4)] {
        for seed in 0..4 {
            for name in ["independent", "latin-hypercube", "halton+owen"] {
                let points = points(name, n, d, seed);
                let star = star::star_discrepancy(&points).expect("valid");
                assert!(
                    (star.value - star_by_force(&points)).abs() < 1e-12,
                    "{name}: n = {n}, d = {d}, seed {seed}: {star:?}"
                );
                assert!(attained(&points, &star.extremal, star.value), "{name}: {star:?}");
            }
        }
    }
    // Repeated coordinates, and points on the upper border.
    let ties = Points::from_rows(2, vec![0.5, 0.5, 0.5, 0.5, 1.0, 0.25, 0.25, 1.0, 1.0, 1.0]).expect("pairs");
    let star = star::star_discrepancy(&ties).expect("valid");
    assert!((star.value - star_by_force(&ties)).abs() < 1e-15 && attained(&ties, &star.extremal, star.value));
}

/// Sets with many equal coordinates, repeated points and points on both borders, against all boxes
/// counted one by one; the box that is told has the value.
#[test]
fn star_discrepancy_is_exact_with_ties_and_borders() {
    let mut random = Seed::new(5).generator();
    for round in 0..600 {
        let d = 2 + round % 2;
        let n = 1 + random.below(if d == 2 { 30 } else { 11 }) as usize;
        let levels = 1 + random.below(6);
        let coordinates = (0..n * d).map(|_| random.below(levels + 1) as f64 / levels as f64).collect();
        let points = Points::from_rows(d, coordinates).expect("rows");
        let star = star::star_discrepancy(&points).expect("valid");
        assert!((star.value - star_by_force(&points)).abs() < 1e-14, "{points:?}: {star:?}");
        assert!(attained(&points, &star.extremal, star.value), "{points:?}: {star:?}");
    }
}

/// Sets large enough for many blocks and skipped heights, against one count of every box: in the
/// plane by the definition, in space slice by slice.
#[test]
fn star_discrepancy_of_larger_sets_is_exact() {
    for name in ["sobol", "independent", "halton+owen", "latin-hypercube"] {
        for n in [257, 1000] {
            let points = points(name, n, 2, 3);
            let star = star::star_discrepancy(&points).expect("valid");
            let plane = [points.axis(0).collect::<Vec<_>>(), points.axis(1).collect::<Vec<_>>()];
            let slow = in_slices(&[(plane, 1.0, 1.0)], n);
            assert!((star.value - slow).abs() < 1e-14, "{name}, n = {n}: {} for {slow}", star.value);
            assert!(attained(&points, &star.extremal, star.value), "{name}: {star:?}");
        }
        let points = points(name, 120, 3, 3);
        let star = star::star_discrepancy(&points).expect("valid");
        let mut rows: Vec<&[f64]> = points.rows().collect();
        rows.sort_by(|a, b| a[2].total_cmp(&b[2]));
        let slice = |count: usize| {
            let plane = [0, 1].map(|axis| rows[..count].iter().map(|row| row[axis]).collect::<Vec<_>>());
            let last = count.checked_sub(1).map_or(0.0, |last| rows[last][2]);
            (plane, last, rows.get(count).map_or(1.0, |row| row[2]))
        };
        let slow = in_slices(&(0..=120).map(slice).collect::<Vec<_>>(), 120);
        assert!((star.value - slow).abs() < 1e-14, "{name}: {} for {slow}", star.value);
        assert!(attained(&points, &star.extremal, star.value), "{name}: {star:?}");
    }
}

/// The star discrepancy of n points from slices: the points below a height as abscissas and
/// ordinates, that height and the next. For each abscissa all ordinates are counted through.
fn in_slices(slices: &[([Vec<f64>; 2], f64, f64)], n: usize) -> f64 {
    let n = n as f64;
    let mut best = 0.0_f64;
    for ([xs, ys], low, high) in slices {
        let mut by_y: Vec<usize> = (0..ys.len()).collect();
        by_y.sort_by(|&a, &b| ys[a].total_cmp(&ys[b]));
        for &x in xs.iter().chain([&1.0]) {
            let (mut open, mut closed) = (0.0, 0.0);
            for &k in &by_y {
                // Without ties but at 1, the open box that ends at a point lacks this one only.
                best = best.max(x * ys[k] * high - open / n);
                open += f64::from(u8::from(xs[k] < x));
                closed += f64::from(u8::from(xs[k] <= x));
                best = best.max(closed / n - x * ys[k] * low);
            }
            best = best.max(x * high - open / n).max(closed / n - x * low);
        }
    }
    best
}

/// Hammersley's set in base 2 has a closed form for the star and the L2 star discrepancy.
#[test]
fn hammersley_has_its_closed_forms() {
    for m in 2..=12 {
        let points = points("hammersley", 1 << m, 2, 1);
        let (n, k) = (f64::from(1 << m), f64::from(m));
        let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
        let expected = (k / 3.0 + 13.0 / 9.0 - sign * 4.0 / (9.0 * n)) / n;
        let star = star::star_discrepancy(&points).expect("valid").value;
        assert!((star - expected).abs() < 1e-13, "m = {m}: {star} against {expected}");
        let square =
            k * k / 64.0 + 29.0 * k / 192.0 + 3.0 / 8.0 - k / (16.0 * n) + 1.0 / (4.0 * n) - 1.0 / (72.0 * n * n);
        let l2 = l2::star(&points);
        assert!((l2 * l2 * n * n - square).abs() < 1e-6 * square, "m = {m}: {l2}");
    }
}

/// Grids, and the bound of the van der Corput sequence.
#[test]
fn grids_and_van_der_corput_keep_their_values() {
    for k in 1..=30_usize {
        let star = star::star_discrepancy(&points("centred-grid", k * k, 2, 1)).expect("valid").value;
        let side = k as f64;
        assert!((star - (1.0 / side - 0.25 / (side * side))).abs() < 1e-14, "k = {k}");
    }
    for n in 1..=300 {
        let star = star::star_discrepancy(&points("van-der-corput", n, 1, 1)).expect("valid").value;
        assert!(n as f64 * star <= portable::log2(n as f64) / 3.0 + 1.0 + 1e-12, "n = {n}: {star}");
    }
}

/// Trap 7: as a sequence the pair has t = m - 2 and a discrepancy that stalls near 1/8; as a net
/// t = 0.
#[test]
fn the_larcher_net_is_no_sequence() {
    for m in 4..=10 {
        assert_eq!(nets::quality(&points("larcher-pillichshammer", 1 << m, 2, 1), 2), Some(0));
        assert_eq!(nets::quality(&larcher_as_sequence(1 << m), 2), Some(m - 2));
    }
    let stalled = star::star_discrepancy(&larcher_as_sequence(4096)).expect("valid").value;
    assert!((stalled - 0.125).abs() < 0.005, "{stalled}");
    let lower = |name| star::star_discrepancy(&points(name, 256, 2, 1)).expect("valid").value;
    assert!(lower("larcher-pillichshammer") < lower("hammersley"));
}

/// The expected square of the L2 star discrepancy of independent points.
#[test]
fn independent_points_have_their_expected_l2() {
    for (n, d) in [(8, 1), (16, 2), (10, 3)] {
        let squares: Moments = (0..2000).map(|seed| power(l2::star(&points("independent", n, d, seed)), 2)).collect();
        let expected = (power(2.0, -(d as i32)) - power(3.0, -(d as i32))) / n as f64;
        assert!(
            (squares.mean() - expected).abs() < 5.0 * squares.standard_error(),
            "n = {n}, d = {d}: {squares:?}, {expected}"
        );
    }
}

/// Koksma-Hlawka for the deck's function and for (1 - x)(1 - y), whose Hardy-Krause variation is 1.
#[test]
fn koksma_and_hlawka_hold() {
    let deck = Function::parse("exp-sin").expect("known");
    let variation = 2.0 * std::f64::consts::E - 1.0 - deck.evaluate(&[1.0]);
    assert!((variation - 3.285_000_820_403_55).abs() < 1e-13);
    let line = points("van-der-corput", 256, 1, 1);
    let error = line.rows().map(|x| deck.evaluate(x)).sum::<f64>() / 256.0 - deck.integral(1).expect("known").value;
    assert!((error.abs() - 3.047e-4).abs() < 1e-7, "{error}");
    let bound = variation * star::star_discrepancy(&line).expect("valid").value;
    assert!((bound - 1.2832e-2).abs() < 1e-6, "{bound}");
    let plane = points("hammersley", 256, 2, 1);
    let error = plane.rows().map(|x| (1.0 - x[0]) * (1.0 - x[1])).sum::<f64>() / 256.0 - 0.25;
    assert!((error.abs() - 5.8632e-3).abs() < 1e-7, "{error}");
    assert!((star::star_discrepancy(&plane).expect("valid").value - 1.6052e-2).abs() < 1e-6);
}

/// The periodogram by definition.
pub fn power_by_force(points: &Points, u: i32, v: i32) -> f64 {
    let (mut re, mut im) = (0.0, 0.0);
    for x in points.rows() {
        let angle = std::f64::consts::TAU * (f64::from(u) * x[0] + f64::from(v) * x[1]);
        re += portable::cos(angle);
        im += portable::sin(angle);
    }
    (re * re + im * im) / points.len() as f64
}

#[test]
fn the_spectrum_is_the_periodogram() {
    let points = points("latin-hypercube", 50, 2, 3);
    let spectrum = spectrum::power(&points, 40).expect("valid");
    for v in -40..=40 {
        for u in -40..=40 {
            assert!((spectrum.at(u, v) - power_by_force(&points, u, v)).abs() < 1e-9, "({u}, {v})");
        }
    }
    assert_eq!(spectrum.at(0, 0), 50.0);
    assert!(spectrum.at(41, 0).is_nan());
    let rings = spectrum.radial();
    let total: usize = rings.iter().map(|ring| ring.count).sum();
    let inside = (-40..=40).flat_map(|u: i32| (-40..=40).map(move |v: i32| f64::from(u * u + v * v).sqrt()));
    assert_eq!(total, inside.filter(|&length| (0.5..40.5).contains(&length)).count());
}

/// Expected spectra: 1 for independent points, 1 - prod sinc^2 for jittered, and the two forms of
/// Latin hypercubes.
/// Rows computed apart are those of the whole, to the bit, wherever the rows are cut.
#[test]
fn rows_of_the_spectrum_can_be_shared() {
    for (n, reach, cuts) in [(1, 0, [0, 0]), (13, 9, [1, 4]), (64, 40, [17, 33])] {
        let points = points("independent", n, 2, 6);
        let whole = spectrum::power(&points, reach).expect("points of the plane");
        let parts = [0..cuts[0], cuts[0]..cuts[1], cuts[1]..reach + 1];
        let rows = parts.map(|rows| spectrum::power_rows(&points, reach, rows).expect("rows")).concat();
        assert_eq!(spectrum::Spectrum::from_rows(reach, rows), Some(whole), "{n} points up to {reach}");
    }
    assert_eq!(spectrum::Spectrum::from_rows(2, vec![0.0; 14]), None);
}

#[test]
fn expected_spectra_are_met() {
    let sinc =
        |t: f64| if t == 0.0 { 1.0 } else { portable::sin(std::f64::consts::PI * t) / (std::f64::consts::PI * t) };
    let lhs = |k: f64| portable::power(sinc(k / 16.0), 2);
    let cases: [(&str, i32, i32, f64); 6] = [
        ("independent", 3, 2, 1.0),
        ("jittered", 1, 0, 0.18943),
        ("jittered", 1, 1, 0.34298),
        ("latin-hypercube", 3, 0, 1.0 - lhs(3.0)),
        ("latin-hypercube", 0, 7, 1.0 - lhs(7.0)),
        ("latin-hypercube", 2, 1, 1.0 + lhs(2.0) * lhs(1.0) / 15.0),
    ];
    for (name, u, v, expected) in cases {
        let powers: Moments =
            (0..4000).map(|seed| spectrum::power(&points(name, 16, 2, seed), 8).expect("valid").at(u, v)).collect();
        let off = (powers.mean() - expected).abs();
        assert!(off < 5.0 * powers.standard_error(), "{name} at ({u}, {v}): {powers:?} against {expected}");
    }
}

#[test]
fn occupancy_correlation_and_distance() {
    let halton = points("halton", 131, 33, 1);
    assert!((correlation::pearson(&halton, 31, 32).expect("varying") - 1.0).abs() < 1e-12);
    let more = points("halton", 256, 33, 1);
    assert!((correlation::pearson(&more, 31, 32).expect("varying") - 0.849).abs() < 5e-4);
    for seed in 0..5 {
        let points = points("bridson", 200, 2, seed);
        let distance = dispersion::minimum_distance(&points).expect("two points");
        let relative = distance / workbook::samplers::poisson::hexagonal(200);
        assert!((relative - relative_radius(&points)).abs() < 1e-12);
    }
    assert_eq!(occupancy::cells(&points("jittered", 16, 2, 1), &[4, 4]), Some(vec![1; 16]));
    assert_eq!(occupancy::cells(&points("jittered", 16, 2, 1), &[4, 0]), None);
    assert!(
        occupancy::is_latin(&points("multi-jittered", 16, 2, 1)) && !occupancy::is_latin(&points("halton", 16, 2, 1))
    );
    assert_eq!(nets::quality(&points("sobol", 64, 3, 1), 2), Some(1));
    assert_eq!(nets::quality(&points("sobol", 63, 3, 1), 2), None);
    assert_eq!(nets::violations(&points("faure", 81, 3, 1), 3, 0), Some(0));
    assert!(nets::violations(&points("jittered", 64, 2, 1), 2, 0).expect("a power of 2") > 0);
    assert!(bit_reversal(1) > 0.0);
}

/// What cannot be measured is refused with its place.
#[test]
fn bad_points_are_refused() {
    let set = |coordinates: Vec<f64>| Points::from_rows(2, coordinates).expect("pairs");
    for metric in METRICS {
        for (points, message) in [
            (set(vec![]), "there is no point"),
            (set(vec![0.5, 0.5, f64::NAN, 0.0]), "coordinate 0 of point 1 is NaN, not a number from 0 to 1"),
            (set(vec![0.5, 1.5]), "coordinate 1 of point 0 is 1.5, not a number from 0 to 1"),
            (set(vec![-0.0, -1e-300]), "coordinate 1 of point 0 is"),
        ] {
            let error = measure(*metric, &points).expect_err("invalid").to_string();
            assert!(error.starts_with(message), "{}: {error}", metric.about().key);
        }
        let valid = measure(*metric, &points("sobol", 64, 2, 1)).expect("valid").value;
        assert!(valid.is_finite(), "{}", metric.about().key);
    }
}
