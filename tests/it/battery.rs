//! The battery: every sampler, alone and with every scramble, is held to what it declares over many
//! n, d and seeds.
//!
//! The checks themselves are in `checks.rs`.

use crate::checks::{
    fills_boxes, has_strength, in_range, is_block_net, is_latin, is_net, is_stratified, relative_radius, worst_moment,
};
use crate::settings::TOLD;
use workbook::points::Points;
use workbook::samplers::digits::logarithm;
use workbook::samplers::{Guarantee, Method};
use workbook::seed::Seed;

/// The counts tried: powers of 2, 3, 5 and of small cubes, and what lies between.
const COUNTS: &[usize] = &[1, 2, 3, 4, 5, 7, 8, 9, 16, 25, 27, 31, 49, 64, 81, 100, 121, 125, 128, 243, 256];

/// The dimensions tried.
const DIMENSIONS: &[usize] = &[1, 2, 3, 5, 8];

/// Every method: all without settings, and those of [`TOLD`].
fn methods() -> impl Iterator<Item = Method> {
    Method::all().chain(TOLD.iter().flat_map(|name| Method::parse(name).expect(name).family()))
}

/// Every method with every admitted n and d.
fn cases() -> impl Iterator<Item = (Method, usize, usize)> {
    methods().flat_map(|method| pairs(method, COUNTS, DIMENSIONS))
}

/// Whether it is one of the samplers of the torus that keep points apart.
fn keeps_distances(method: &Method) -> bool {
    ["dart-throwing", "bridson", "maximal-poisson", "best-candidate"].contains(&method.sampler().about().key)
}

/// The method with each of `counts` and `dimensions` that it admits.
fn pairs<'c>(
    method: Method,
    counts: &'c [usize],
    dimensions: &'c [usize],
) -> impl Iterator<Item = (Method, usize, usize)> + 'c {
    // These search long in three dimensions: few counts are enough there.
    let slow = keeps_distances(&method);
    let pairs = dimensions.iter().flat_map(move |&d| counts.iter().map(move |&n| (n, d)));
    let pairs = pairs.filter(move |&(n, d)| !slow || n <= [128, 300, 16][(d - 1).min(2)]);
    pairs.filter(move |&(n, d)| method.admits(n, d).is_ok()).map(move |(n, d)| (method, n, d))
}

fn points(method: Method, n: usize, d: usize, seed: u64) -> Points {
    method.points(n, d, Seed::new(seed)).unwrap_or_else(|error| panic!("{method}: {error}"))
}

#[test]
fn shape_and_range() {
    for (method, n, d) in cases() {
        for seed in 0..3 {
            let points = points(method, n, d, seed);
            assert_eq!((points.len(), points.dimensions()), (n, d), "{method}");
            assert!(in_range(&points), "{method}: n = {n}, d = {d}, seed {seed}");
        }
    }
}

#[test]
fn same_call_same_bits_and_only_random_methods_heed_the_seed() {
    for (method, n, d) in cases().filter(|&(_, n, _)| n >= 8) {
        let first = points(method, n, d, 1);
        assert_eq!(first, points(method, n, d, 1), "{method}");
        assert_eq!(first != points(method, n, d, 2), method.is_random(), "{method}: n = {n}, d = {d}");
    }
}

#[test]
fn prefixes_are_the_shorter_sets() {
    for method in methods().filter(|method| method.guarantees().contains(&Guarantee::Prefix)) {
        for (_, most, d) in pairs(method, &[16, 300], DIMENSIONS) {
            let longest = points(method, most, d, 5);
            for &n in COUNTS.iter().filter(|&&n| n < most) {
                let prefix = Points::from_rows(d, longest.coordinates()[..n * d].to_vec()).expect("whole rows");
                assert_eq!(prefix, points(method, n, d, 5), "{method}: n = {n}, d = {d}");
            }
        }
    }
}

#[test]
fn latin_sets_have_one_point_a_slab() {
    for (method, n, d) in cases().filter(|(method, ..)| method.guarantees().contains(&Guarantee::Latin)) {
        for seed in 0..5 {
            assert!(is_latin(&points(method, n, d, seed)), "{method}: n = {n}, d = {d}, seed {seed}");
        }
    }
}

#[test]
fn strata_have_one_point_a_cell() {
    for (method, n, d) in cases().filter(|(method, ..)| method.guarantees().contains(&Guarantee::Strata)) {
        for seed in 0..5 {
            assert!(
                is_stratified(&points(method, n, d, seed), &method.sampler().strata(n, d)),
                "{method}: n = {n}, d = {d}, seed {seed}"
            );
        }
    }
}

#[test]
fn arrays_have_their_strength() {
    for (method, n, d) in cases() {
        for guarantee in method.guarantees() {
            for seed in 0..4 {
                let points = || points(method, n, d, seed);
                match guarantee {
                    Guarantee::Strength { t } => {
                        assert!(has_strength(&points(), t as usize), "{method}: n = {n}, d = {d}");
                    }
                    Guarantee::Pairs => {
                        let points = points();
                        for first in (0..d).step_by(2) {
                            let width = (d - first).min(2);
                            let pair = points.rows().flat_map(|row| row[first..first + width].to_vec()).collect();
                            let pair = Points::from_rows(width, pair).expect("whole rows");
                            let k = if width == 1 { n } else { (1..=n).find(|k| k * k >= n).unwrap_or(1) };
                            assert!(
                                is_stratified(&pair, &vec![k; width]),
                                "{method}: n = {n}, d = {d}, axes from {first}"
                            );
                        }
                    }
                    Guarantee::Separated { percent } if n > 1 => {
                        let radius = relative_radius(&points());
                        assert!(radius >= f64::from(percent) / 100.0, "{method}: n = {n}: relative radius {radius}");
                    }
                    _ => {}
                }
            }
        }
    }
}

#[test]
fn nets_fill_every_elementary_interval_of_every_block() {
    let mut checked = 0;
    for (method, n, d) in cases().filter(|&(_, n, _)| n >= 64) {
        let Some(net) = method.net(d) else { continue };
        for seed in 0..2 {
            assert!(
                is_net(&points(method, n, d, seed), net.base, net.t),
                "{method}: n = {n}, d = {d}, seed {seed}, {net:?}"
            );
        }
        checked += 1;
    }
    assert!(checked > 20, "only {checked} nets were checked");
}

#[test]
fn whole_sets_are_nets() {
    let mut checked = 0;
    for (method, n, d) in cases() {
        let Some(net) = method.whole_net(n, d) else { continue };
        for seed in 0..3 {
            let points = points(method, n, d, seed);
            assert!(
                logarithm(n as u64, net.base).is_some() && is_block_net(&points, net.base, net.t),
                "{method}: n = {n}, d = {d}, seed {seed}"
            );
        }
        checked += 1;
    }
    assert!(checked > 20, "only {checked} nets were checked");
}

#[test]
fn random_access_gives_the_bits_of_the_batch() {
    let mut checked = 0;
    for (method, n, d) in cases().filter(|&(_, n, d)| [9, 16, 25, 27, 49].contains(&n) && d < 8) {
        let seed = Seed::new(11);
        let Some(sample) = method.sample(n, d, seed) else { continue };
        let points = method.points(n, d, seed).expect("admitted");
        for (i, row) in points.rows().enumerate() {
            for (axis, &x) in row.iter().enumerate() {
                assert_eq!(sample(i as u64, axis), x, "{method}: n = {n}, point {i}, axis {axis}");
            }
        }
        checked += 1;
    }
    assert!(checked > 100, "only {checked} methods have random access");
}

/// The same over many blocks and tables of the fast paths, which a small set does not reach.
#[test]
fn long_batches_give_the_bits_of_random_access() {
    let names = [
        "sobol",
        "sobol+xor",
        "sobol+owen-hash",
        "zero-two+xor",
        "halton",
        "halton+permutation",
        "halton+xor",
        "hammersley",
    ];
    for method in names.map(|name| Method::parse(name).expect(name)) {
        for (n, d) in [(5000, 1), (5000, 2), (3001, 7), (700, 100)] {
            let seed = Seed::new(3);
            let (Ok(points), Some(sample)) = (method.points(n, d, seed), method.sample(n, d, seed)) else { continue };
            for (i, row) in points.rows().enumerate() {
                let same = row.iter().enumerate().all(|(axis, &x)| sample(i as u64, axis) == x);
                assert!(same, "{method}: n = {n}, d = {d}, point {i}");
            }
        }
    }
}

/// Every sequence stays in [0, 1) at the last indices of 32 bits and at those of the traps, in
/// `f64` and as `f32` rounded towards 0.
#[test]
fn far_indices_stay_below_one() {
    let indices =
        [33_554_431, 43_046_720, 29_296_874, 28_824_004, 17_715_609, 62_748_516, (1 << 32) - 1, (1 << 32) - 2];
    for method in methods().filter(|method| method.guarantees().contains(&Guarantee::Prefix)) {
        let d = if method.admits(1, 256).is_ok() { 256 } else { 1 };
        let Some(sample) = method.sample(1, d, Seed::new(4)) else { continue };
        for index in indices {
            for axis in [0, 1, 2, 3, 4, 5, 31, 255].into_iter().filter(|&axis| axis < d) {
                let x = sample(index, axis);
                assert!(
                    (0.0..1.0).contains(&x) && workbook::points::single(x) < 1.0,
                    "{method}: index {index}, axis {axis}: {x}"
                );
            }
        }
    }
}

/// Every single axis of a net in base 2, to the last one, has one point in each dyadic interval; in
/// Niederreiter's sequence only where its polynomial has degree 1.
#[test]
fn every_axis_alone_is_a_net() {
    let d = 256;
    let methods = Method::all().filter(|method| method.sampler().about().key != "niederreiter");
    for method in methods.filter(|method| method.net(d).is_some_and(|net| net.base == 2) && method.admits(1, d).is_ok())
    {
        let points = points(method, 256, d, 3);
        for axis in 0..d {
            let column = Points::from_rows(1, points.axis(axis).collect()).expect("one column");
            assert!(is_net(&column, 2, 0), "{method}: axis {axis}");
        }
    }
}

#[test]
fn consecutive_points_fill_boxes() {
    let primes = workbook::samplers::halton::PRIMES.map(|prime| prime as usize);
    for method in Method::all().filter(|method| method.guarantees().contains(&Guarantee::Boxes)) {
        for d in 1..=4 {
            for seed in 0..2 {
                assert!(fills_boxes(&points(method, 240, d, seed), &primes), "{method}: d = {d}, seed {seed}");
            }
        }
    }
}

/// Over seeds the points together are uniform (mean and second moment on every axis, no correlation
/// of neighbouring axes): within 5 standard errors, which are measured over the seeds.
#[test]
fn points_are_uniform_over_seeds() {
    let told: Vec<Method> = TOLD.iter().map(|name| Method::parse(name).expect(name)).collect();
    // Of the settings those without a scramble: the scrambles are tried on the plain ones.
    let cases = Method::all().chain(told).flat_map(|method| pairs(method, &[1, 8, 9, 16], &[1, 2, 3]));
    // The law of those that keep distances is the same wherever the torus is shifted: few counts
    // tell.
    let few = |method: &Method, n, d| d == 2 || n == 8 || !keeps_distances(method);
    for (method, n, d) in cases.filter(|(method, n, d)| few(method, *n, *d)) {
        if method.guarantees().contains(&Guarantee::Unbiased) {
            let worst = worst_moment(|seed| points(method, n, d, seed));
            assert!(worst < 5.2, "{method}: n = {n}, d = {d}: a moment is off by {worst} standard errors");
        }
    }
}

/// What cannot be given is refused with the argument and its limits, before anything is allocated.
#[test]
fn bad_counts_and_dimensions_are_refused() {
    for method in methods() {
        for (n, d) in [(0, 1), (4, 0), (usize::MAX, 1), (usize::MAX, usize::MAX), (1 << 40, 1 << 40)] {
            let error = method.points(n, d, Seed::new(1)).expect_err("out of range");
            assert!(error.to_string().starts_with(if n == 4 { "d = " } else { "" }), "{method}: {error}");
        }
    }
    let refused =
        |name: &str, n, d| Method::parse(name).expect(name).points(n, d, Seed::new(1)).expect_err(name).to_string();
    assert_eq!(
        refused("jittered", 15, 2),
        "n = 15 is not possible: it must be k^d for a whole number k; the nearest are 9 and 16"
    );
    assert_eq!(refused("sobol", 4, 257), "d = 257 is not possible: d must be from 1 to 256");
    assert_eq!(refused("van-der-corput", 4, 2), "d = 2 is not possible: this method has 1 dimension");
    assert_eq!(refused("independent", 0, 1), "n = 0 is not possible: it must be at least 1; the nearest is 1");
    assert!(refused("independent", 1 << 40, 1).contains("at most 1073741824"));
}

#[test]
fn names_read_back_and_slips_are_answered() {
    for method in methods() {
        assert_eq!(Method::parse(&method.name()), Ok(method));
        assert!(!method.title().is_empty() && !method.abouts().is_empty());
    }
    let error = |name: &str| Method::parse(name).expect_err(name).to_string();
    assert_eq!(error("sobl"), "there is no sampler `sobl`; did you mean `sobol`?");
    assert_eq!(error("sobol+xorr"), "there is no scramble `xorr`; did you mean `xor`?");
    assert_eq!(
        error("independent+xor"),
        "`independent` cannot be combined with `xor`: its coordinates have no digits to shift"
    );
}

/// Catalogues: unique keys, sources that are the file named, at least one paper each, and every
/// file of the folder listed.
#[test]
fn catalogues_are_complete() {
    use workbook::catalogue::About;
    let samplers: Vec<&About> = workbook::samplers::SAMPLERS.iter().map(|entry| entry.about()).collect();
    let scrambles: Vec<&About> = workbook::scrambles::SCRAMBLES.iter().map(|entry| entry.about()).collect();
    let integrands: Vec<&About> = workbook::integrands::INTEGRANDS.iter().map(|entry| entry.about()).collect();
    let metrics: Vec<&About> = workbook::metrics::abouts().collect();
    let helpers = [
        (
            "samplers",
            vec![
                "mod",
                "axes",
                "batch",
                "digits",
                "enumeration",
                "method",
                "poisson",
                "refused",
                "regular",
                "settings",
                "sides",
            ],
            samplers,
        ),
        ("scrambles", vec!["mod", "fixed", "walk"], scrambles),
        ("integrands", vec!["mod", "function", "genz"], integrands),
        ("metrics", vec!["mod", "occupancy", "spectrum", "star_bound", "star_space"], metrics),
    ];
    for (folder, others, abouts) in helpers {
        let mut files: Vec<String> = others.iter().map(|name| format!("{folder}/{name}.rs")).collect();
        for about in &abouts {
            assert!(!about.papers.is_empty(), "{}", about.key);
            assert_eq!(abouts.iter().filter(|other| other.key == about.key).count(), 1, "{}", about.key);
            let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(about.file);
            assert_eq!(std::fs::read_to_string(file).expect("the file named"), about.source, "{}", about.key);
            files.push(about.file.to_owned());
        }
        let listing = std::fs::read_dir(format!("{}/src/{folder}", env!("CARGO_MANIFEST_DIR"))).expect("the folder");
        for path in listing.map(|entry| entry.expect("an entry").path()).filter(|path| path.extension().is_some()) {
            let name = format!("{folder}/{}", path.file_name().expect("a name").to_string_lossy());
            assert!(files.contains(&name), "{name} is in no catalogue");
        }
    }
}
