//! Properties over random cases, which shrink when they fail: samplers and scrambles against what they promise, measures against
//! their definitions.

use proptest::prelude::*;
use proptest::sample::select;
use workbook::metrics::{l2, nets, spectrum, star};
use workbook::points::{Points, slab};
use workbook::samplers::{Guarantee, Method, Refused};
use workbook::scrambles::SCRAMBLES;
use workbook::seed::Seed;
use workbook::stats::portable::power;

use crate::checks::{compositions, is_block_net};
use crate::measures::{attained, power_by_force, star_by_force};
use crate::settings::TOLD;

/// Any method: a sampler, perhaps with settings, alone or with a scramble.
fn method() -> impl Strategy<Value = Method> {
    let told = TOLD.iter().flat_map(|name| Method::parse(name).expect(name).family());
    select(Method::all().chain(told).collect::<Vec<_>>())
}

/// Any sequence.
fn sequence() -> impl Strategy<Value = Method> {
    method().prop_filter("a sequence", |method| method.guarantees().contains(&Guarantee::Prefix))
}

/// A count near `n` that the method gives in `d` dimensions, if there is one.
fn admitted(method: Method, n: usize, d: usize) -> Option<usize> {
    match method.admits(n, d) {
        Ok(()) => Some(n),
        Err(Refused::Count { below, above, .. }) => below.or(above).filter(|&n| n <= 400),
        Err(_) => None,
    }
}

/// Points with ties and on the borders: every coordinate a multiple of 1/8, or anything.
fn set(most: usize, d: impl Strategy<Value = usize>) -> impl Strategy<Value = Points> {
    let coordinate = prop_oneof![(0_u32..=8).prop_map(|k| f64::from(k) / 8.0), 0.0..1.0];
    (d, 1..=most).prop_flat_map(move |(d, n)| {
        prop::collection::vec(coordinate.clone(), n * d)
            .prop_map(move |coordinates| Points::from_rows(d, coordinates).expect("whole rows"))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// The same call gives the same bits, in [0, 1), and random access gives those of the batch.
    #[test]
    fn a_method_is_a_function_of_its_arguments(method in method(), n in 1_usize..130, d in 1_usize..4, seed in any::<u64>()) {
        let Some(n) = admitted(method, n, d) else { return Ok(()) };
        let points = method.points(n, d, Seed::new(seed)).expect("admitted");
        prop_assert_eq!((points.len(), points.dimensions()), (n, d));
        prop_assert!(points.coordinates().iter().all(|x| (0.0..1.0).contains(x)));
        prop_assert_eq!(&points, &Method::parse(&method.name()).expect("its name").points(n, d, Seed::new(seed)).expect("admitted"));
        if let Some(sample) = method.sample(n, d, Seed::new(seed)) {
            let one_by_one: Vec<f64> = (0..n * d).map(|at| sample((at / d) as u64, at % d)).collect();
            prop_assert_eq!(points.coordinates(), &one_by_one[..]);
        }
    }

    /// A sequence's first points are its first points, however many more there are.
    #[test]
    fn a_prefix_is_the_shorter_set(method in sequence(), n in 1_usize..60, more in 0_usize..600, d in 1_usize..5, seed in any::<u64>()) {
        let more = if method.guarantees().contains(&Guarantee::Deterministic) { more } else { more % 100 };
        prop_assume!(method.admits(n + more, d).is_ok());
        let seed = Seed::new(seed);
        let longer = method.points(n + more, d, seed).expect("admitted");
        let shorter = method.points(n, d, seed).expect("admitted");
        prop_assert_eq!(&longer.coordinates()[..n * d], shorter.coordinates());
    }

    /// Every scramble that keeps nets maps the b^m intervals of an aligned block of b^m radical inverses one to one, in every
    /// base and wherever the block begins.
    #[test]
    fn scrambles_permute_the_intervals_of_a_block(
        base in 2_u32..40, scramble in 0..SCRAMBLES.len(), seed in any::<u64>(), exponent in 0_u32..9, block in 0_u64..1000,
    ) {
        let scramble = SCRAMBLES[scramble];
        let name = format!("radical-inverse(base={base})+{}", scramble.about().key);
        let Ok(method) = Method::parse(&name) else { return Ok(()) };
        prop_assume!(scramble.keeps(Guarantee::Net));
        let Some(size) = u64::from(base).checked_pow(exponent).filter(|&size| size <= 1024) else { return Ok(()) };
        let sample = method.sample(1, 1, Seed::new(seed)).expect("a sequence");
        let mut hit = vec![false; size as usize];
        for index in block * size..(block + 1) * size {
            let x = sample(index, 0);
            prop_assert!((0.0..1.0).contains(&x));
            hit[slab(x, size as usize)] = true;
        }
        prop_assert!(hit.iter().all(|&hit| hit), "{name}: block {block} of {size}");
    }

    /// The star discrepancy is that of all boxes one by one, and its box has it.
    #[test]
    fn star_discrepancies_are_those_of_all_boxes(points in set(9, 1_usize..=3)) {
        let star = star::star_discrepancy(&points).expect("valid");
        prop_assert!((star.value - star_by_force(&points)).abs() < 1e-12, "{star:?}");
        prop_assert!(attained(&points, &star.extremal, star.value), "{star:?}");
    }

    /// The L2 star discrepancy is the integral of the squared difference, cell by cell.
    #[test]
    fn l2_star_is_its_integral(points in set(8, 1_usize..=3)) {
        let integral = squared_integral(&points).max(0.0);
        prop_assert!((power(l2::star(&points), 2) - integral).abs() < 1e-12, "{} against {integral}", l2::star(&points));
    }

    /// The centred and the wrap-around L2 discrepancies are Hickernell's double sums.
    #[test]
    fn hickernell_s_discrepancies_are_their_sums(points in set(12, 1_usize..=4)) {
        let (n, d) = (points.len() as f64, points.dimensions() as i32);
        let rows: Vec<&[f64]> = points.rows().collect();
        let double = |factor: &dyn Fn(f64, f64) -> f64| -> f64 {
            let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(&x, &y)| factor(x, y)).product::<f64>();
            rows.iter().map(|a| rows.iter().map(|b| product(a, b)).sum::<f64>()).sum::<f64>() / (n * n)
        };
        let off = |x: f64| (x - 0.5).abs();
        let single = |a: &&[f64]| a.iter().map(|&x| 1.0 + 0.5 * off(x) - 0.5 * off(x) * off(x)).product::<f64>();
        let centred = power(13.0 / 12.0, d) - 2.0 / n * rows.iter().map(single).sum::<f64>()
            + double(&|x, y| 1.0 + 0.5 * off(x) + 0.5 * off(y) - 0.5 * (x - y).abs());
        let wrapped = double(&|x, y| 1.5 - (x - y).abs() * (1.0 - (x - y).abs())) - power(4.0 / 3.0, d);
        prop_assert!((power(l2::centred(&points), 2) - centred).abs() < 1e-11, "{centred}");
        prop_assert!((power(l2::wrap_around(&points), 2) - wrapped).abs() < 1e-11, "{wrapped}");
    }

    /// The quality t is the smallest for which the set is a net by definition, and the violations are counted one by one.
    #[test]
    fn qualities_are_those_of_the_definition(m in 0_u32..6, d in 1_usize..4, seed in any::<u64>()) {
        let points = Method::parse("latin-hypercube").expect("known").points(1 << m, d, Seed::new(seed)).expect("admitted");
        let smallest = (0..=m).find(|&t| is_block_net(&points, 2, t));
        prop_assert_eq!(nets::quality(&points, 2), smallest);
        let violated = |shape: Vec<u32>| {
            let cell = |row: &[f64]| -> Vec<usize> { row.iter().zip(&shape).map(|(&x, &k)| slab(x, 1 << k)).collect() };
            let mut cells: Vec<_> = points.rows().map(cell).collect();
            cells.sort();
            let once = cells.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).count();
            (1_u64 << m) - once as u64
        };
        prop_assert_eq!(nets::violations(&points, 2, 0), Some(compositions(m, d).into_iter().map(violated).sum()));
    }

    /// The power spectrum is the sum of its definition at every frequency.
    #[test]
    fn spectra_are_the_sums_of_the_definition(points in set(40, Just(2_usize)), frequency in 1_i32..9) {
        let spectrum = spectrum::power(&points, frequency as usize).expect("valid");
        for v in -frequency..=frequency {
            for u in -frequency..=frequency {
                let force = power_by_force(&points, u, v);
                prop_assert!((spectrum.at(u, v) - force).abs() < 1e-9, "({u}, {v}): {} against {force}", spectrum.at(u, v));
            }
        }
    }
}

/// The integral of (count / n - volume)^2 over all boxes at the origin, cell by cell of the grid of all coordinates, in each of
/// which the count is constant.
fn squared_integral(points: &Points) -> f64 {
    let (n, d) = (points.len() as f64, points.dimensions());
    let borders = |axis: usize| {
        let mut borders: Vec<f64> = points.axis(axis).chain([0.0, 1.0]).collect();
        borders.sort_by(f64::total_cmp);
        borders
    };
    let borders: Vec<Vec<f64>> = (0..d).map(borders).collect();
    let cells: usize = borders.iter().map(|borders| borders.len() - 1).product();
    let cell = |number: usize| {
        let mut rest = number;
        let sides: Vec<(f64, f64)> = borders
            .iter()
            .map(|borders| {
                let at = rest % (borders.len() - 1);
                rest /= borders.len() - 1;
                (borders[at], borders[at + 1])
            })
            .collect();
        // Boxes that end inside this cell hold the points not above its lower corner.
        let count = points.rows().filter(|row| row.iter().zip(&sides).all(|(x, side)| *x <= side.0)).count() as f64 / n;
        let moment = |k: i32| {
            sides.iter().map(|&(a, b)| (power(b, k + 1) - power(a, k + 1)) / f64::from(k + 1)).product::<f64>()
        };
        count * count * moment(0) - 2.0 * count * moment(1) + moment(2)
    };
    (0..cells).map(cell).sum()
}
