//! Proof that the battery bites: samplers broken in typical ways, each with the check that catches
//! it.

use crate::checks::{
    fills_boxes, has_strength, in_range, is_block_net, is_latin, is_net, is_stratified, relative_radius, worst_moment,
};
use workbook::points::{Points, slab};
use workbook::samplers::{Method, larcher_pillichshammer, van_der_corput};
use workbook::scrambles::owen_hash::{carry_up, scramble};
use workbook::seed::{Random, Seed};

fn set(d: usize, coordinates: Vec<f64>) -> Points {
    Points::from_rows(d, coordinates).expect("whole rows")
}

fn whole(name: &str, n: usize, d: usize, seed: u64) -> Points {
    Method::parse(name).expect(name).points(n, d, Seed::new(seed)).expect(name)
}

fn random(seed: u64) -> Random {
    Seed::new(seed).generator()
}

/// Digits summed in single precision reach 1: the range check.
#[test]
fn single_precision_radical_inverses_leave_the_range() {
    let sum = |index: u32, base: u32| {
        let (mut rest, mut inverse, mut weight) = (index, 0.0_f32, 1.0 / base as f32);
        while rest > 0 {
            inverse += (rest % base) as f32 * weight;
            weight /= base as f32;
            rest /= base;
        }
        f64::from(inverse)
    };
    for (index, base) in [(33_554_431, 2), (62_748_516, 13)] {
        assert!(!in_range(&set(1, vec![sum(index, base)])), "base {base}");
    }
}

/// Permuting only the digits that an index has, with p(0) not 0: the box check.
#[test]
fn permutations_without_trailing_zeros_leave_strata_empty() {
    let permuted = |index: u64| {
        let (mut rest, mut inverse, mut weight) = (index, 0.0, 1.0 / 3.0);
        while rest > 0 {
            inverse += [1.0, 0.0, 2.0][(rest % 3) as usize] * weight;
            weight /= 3.0;
            rest /= 3;
        }
        inverse
    };
    let points = set(1, (0..9).map(permuted).collect());
    assert!(!fills_boxes(&points, &[3]));
    let mut hit: Vec<usize> = points.axis(0).map(|x| slab(x, 9)).collect();
    hit.sort_unstable();
    hit.dedup();
    assert_eq!(hit.len(), 6, "the deck's example hits 6 of 9 strata");
}

/// The multi-jitter listing that divides whole numbers: strata and Latin checks, and the mean.
#[test]
fn whole_number_division_crowds_multi_jitter() {
    let broken = |seed| {
        let mut random = random(seed);
        let cell = |k: usize| [(k % 4 / 4) as f64, (k / 4 / 4) as f64];
        set(2, (0..16).flat_map(|k| cell(k).map(|corner| corner + random.uniform() / 4.0)).collect())
    };
    assert!(!is_stratified(&broken(1), &[4, 4]) && !is_latin(&broken(1)));
    assert!(worst_moment(broken) > 50.0);
}

/// Latin hypercubes whose cells are drawn independently (a library's first version) or not jittered
/// or cyclically permuted.
#[test]
fn broken_latin_hypercubes_are_caught() {
    let independent = |seed| {
        let mut random = random(seed);
        set(2, (0..32).map(|_| (random.below(16) as f64 + random.uniform()) / 16.0).collect())
    };
    assert!(!is_latin(&independent(1)));
    let corners = |seed| {
        let mut random = random(seed);
        let (x, y) = (random.permutation(16), random.permutation(16));
        set(2, x.into_iter().zip(y).flat_map(|(x, y)| [x as f64 / 16.0, y as f64 / 16.0]).collect())
    };
    assert!(is_latin(&corners(1)) && worst_moment(corners) > 5.2);
    // The same permutation on both axes: Latin, uniform on each axis, and all on the diagonal.
    let diagonal = |seed| {
        let mut random = random(seed);
        set(
            2,
            random
                .permutation(16)
                .into_iter()
                .flat_map(|k| [k, k])
                .map(|k| (k as f64 + random.uniform()) / 16.0)
                .collect(),
        )
    };
    assert!(is_latin(&diagonal(1)) && worst_moment(diagonal) > 50.0);
}

/// A shuffle that leaves out the item itself makes cyclic permutations only: on three items two of
/// six.
#[test]
fn exclusive_shuffles_are_cyclic() {
    let mut seen = std::collections::BTreeSet::new();
    for seed in 0..200 {
        let mut random = random(seed);
        let mut items = [0, 1, 2];
        for i in (1..3).rev() {
            items.swap(i, random.below(i as u64) as usize);
        }
        seen.insert(items);
        let fixed = items.iter().enumerate().filter(|(i, item)| i == *item).count();
        assert_eq!(fixed, 0);
    }
    assert_eq!(seen.len(), 2);
    let right: std::collections::BTreeSet<Vec<usize>> = (0..200).map(|seed| random(seed).permutation(3)).collect();
    assert_eq!(right.len(), 6);
}

/// Dropping point 0, a Gray-code order read as natural, a wrong direction number: the net check.
#[test]
fn broken_sobol_sequences_are_no_nets() {
    let longer = whole("sobol", 17, 2, 1);
    let dropped = set(2, longer.coordinates()[2..].to_vec());
    assert!(is_net(&whole("sobol", 16, 2, 1), 2, 0) && !is_net(&dropped, 2, 0));
    let gray = |i: u64| [van_der_corput::bit_reversal(i), van_der_corput::bit_reversal(i ^ (i >> 1))];
    assert!(!is_net(&set(2, (0..16).flat_map(gray).collect()), 2, 0));
    // In one dimension the order of a Gray code keeps every prefix of 2^m a net: only the known
    // first points tell.
    let ordered = set(1, (0..16).map(|i| van_der_corput::bit_reversal(i ^ (i >> 1))).collect());
    assert!(is_net(&ordered, 2, 0) && ordered != whole("sobol", 16, 1, 1));
}

/// The Larcher-Pillichshammer coordinate as a sequence, and a net shifted modulo 1: the net check.
#[test]
fn sequences_and_shifts_that_are_no_nets() {
    let larcher =
        |i: u64| [van_der_corput::bit_reversal(i), larcher_pillichshammer::ones(i) as f64 / 9_007_199_254_740_992.0];
    assert!(!is_block_net(&set(2, (0..64).flat_map(larcher).collect()), 2, 0));
    let shifted = whole("sobol+cranley-patterson", 16, 2, 1);
    assert!(!is_block_net(&shifted, 2, 0));
}

/// A hash whose carries run the wrong way, that is without reversing the digits: later digits
/// change earlier ones, and the net breaks in two axes.
#[test]
fn hashes_the_wrong_way_round_are_caught() {
    let points = |seed: u64, hash: &dyn Fn(u32, u32) -> u32| {
        let digits = |i, axis| (workbook::samplers::sobol::sobol_bits(i, axis) >> 21) as u32;
        let key = |axis| (Seed::new(seed).at(axis as u64).word() >> 32) as u32;
        let row = |i| [0, 1].map(|axis| f64::from(hash(digits(i, axis), key(axis))) / 4_294_967_296.0);
        set(2, (0..64).flat_map(row).collect())
    };
    assert!((0..20).all(|seed| is_net(&points(seed, &scramble), 2, 0)));
    assert!((0..20).all(|seed| !is_net(&points(seed, &carry_up), 2, 0)));
}

/// One shift for all axes, or raw seeds in a row: the correlation of axes over seeds.
#[test]
fn one_shift_for_all_axes_is_caught() {
    let same = |seed| {
        let shift = random(seed).uniform();
        set(2, whole("sobol", 16, 2, 1).coordinates().iter().map(|x| (x + shift) % 1.0).collect())
    };
    assert!(worst_moment(same) > 5.2);
    assert!(worst_moment(|seed| whole("sobol+cranley-patterson", 16, 2, seed)) < 5.2);
}

/// Halton with bases that are not coprime: the box check.
#[test]
fn bases_with_a_common_divisor_are_caught() {
    let points = |bases: [u32; 2]| {
        let row = |i| bases.map(|base| workbook::samplers::halton::radical_inverse(i, base));
        set(2, (0..144).flat_map(row).collect())
    };
    assert!(fills_boxes(&points([4, 3]), &[4, 3]) && !fills_boxes(&points([4, 6]), &[4, 6]));
}

/// Strength lost by two equal columns; distances that ignore the torus.
#[test]
fn arrays_and_distances_that_are_broken() {
    let array = whole("orthogonal-array", 25, 3, 1);
    let doubled = set(3, array.rows().flat_map(|x| [x[0], x[1], x[1]]).collect());
    assert!(has_strength(&array, 2) && !has_strength(&doubled, 2));
    // Points along two opposite borders are far apart in the square, but touch on the torus.
    let border = set(2, (0..5).flat_map(|k| [0.0, f64::from(k) / 5.0, 0.999, f64::from(k) / 5.0]).collect());
    assert!(relative_radius(&border) < 0.01);
}
