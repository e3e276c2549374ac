//! The mistakes in placing points: each wrong program has the value that theory or a paper gives it, and the test tells it from the right one.

use crate::asked::{error, holds, number, outcome, z};
use crate::parameters::plan;
use crate::point_kinds::drawn;
use workbook::chart::Drawing;
use workbook::sources;
use workbook::stats::portable;

/// The names of all mistakes, from the complaint about one that is none.
fn names() -> Vec<String> {
    let complaints = plan("kind = \"point-bug\"\nbug = \"qqqqqqqqqqqqqqqqqqqqqqqqqqqq\"").err().expect("refused");
    let help = complaints[0].help[0].clone();
    let list = help.strip_prefix("the mistakes are ").expect("a list");
    list.split(", ").map(str::to_owned).collect()
}

fn fence(bug: &str, more: &str) -> String {
    format!("kind = \"point-bug\"\nbug = \"{bug}\"\n{more}")
}

#[test]
fn every_mistake_is_caught_drawn_and_in_the_gallery() {
    let gallery = include_str!("../books/gallery/chapters/07-traps.md");
    let names = names();
    assert!(names.len() >= 10, "{names:?}");
    for name in &names {
        assert!(gallery.contains(&format!("bug = \"{name}\"")), "{name} is not in the gallery");
        let (drawing, alt) = drawn(&fence(name, ""));
        match drawing {
            Drawing::Figure(figure) => assert!(figure.svg.contains("<svg"), "{name}"),
            Drawing::Table(table) => assert!(table.rows.len() > 1, "{name}"),
            other => panic!("{name}: {other:?}"),
        }
        assert!(alt.contains("The wrong program fails the test, the right one passes."), "{name}: {alt}");
        for seed in 1..=3 {
            let found = crate::asked::seeded(&fence(name, ""), seed);
            assert!(holds(&found, "right.passes") && !holds(&found, "wrong.passes"), "{name}, seed {seed}");
            assert!(holds(&found, "caught"), "{name}, seed {seed}");
        }
    }
}

#[test]
fn every_wrong_program_can_be_a_listing_and_is_short() {
    for name in names() {
        for form in ["wrong", "right"] {
            let path = format!("kinds::point_bugs::{}::{form}", name.replace('-', "_"));
            let item = sources::item(&path).unwrap_or_else(|| panic!("no {path}"));
            assert!(item.text.starts_with(&format!("fn {form}(")), "{path}: {}", item.text);
            assert!(item.text.lines().count() <= 16, "{path} is long");
        }
    }
}

#[test]
fn counts_that_a_mistake_cannot_have_are_refused() {
    for (bug, more, told) in [
        ("integer-division", "n = 15", "choose a square from 4 to 256"),
        ("integer-division", "replicates = 4", "drop `replicates`"),
        ("exclusive-shuffle", "n = 6", "choose from 2 to 5"),
        ("moves-zero", "n = 16", "choose a power of 3 from 9 to 81"),
        ("repeated-bas", "", "did you mean `repeated-base`?"),
    ] {
        let complaints = plan(&fence(bug, more)).err().expect("refused");
        assert!(
            complaints.iter().any(|complaint| complaint.help.iter().any(|help| help == told)),
            "{bug}: {complaints:?}"
        );
    }
}

/// x is in [0, 1/columns) with the mean 1/(2 columns): the mean of n stratified numbers is at most 1/(2n) off.
#[test]
fn whole_numbers_divided_crowd_in_the_first_cell() {
    for side in [2_u32, 4, 8] {
        let n = f64::from(side * side);
        let found = outcome(&fence("integer-division", &format!("n = {n}")));
        let width = 1.0 / f64::from(side);
        assert!((number(&found, "wrong.mean-x") - width / 2.0).abs() <= 0.5 / n, "{side}");
        assert!((number(&found, "right.mean-x") - 0.5).abs() <= 0.5 / n, "{side}");
        assert!(number(&found, "wrong.largest-x") < width);
        assert_eq!(number(&found, "wrong.empty-cells"), n - 1.0);
        assert_eq!(number(&found, "wrong.empty-slabs"), n - f64::from(side));
        assert_eq!((number(&found, "right.empty-cells"), number(&found, "right.empty-slabs")), (0.0, 0.0));
    }
}

/// (n-1)! cyclic permutations; a point in a diagonal cell with probability 1/(n-1); no item stays, where one does on average.
#[test]
fn an_exclusive_shuffle_makes_cycles_only() {
    for n in 2..=5_u32 {
        let found = outcome(&fence("exclusive-shuffle", &format!("n = {n}")));
        let factorial = |n: u32| (1..=n).product::<u32>();
        assert_eq!(number(&found, "wrong.permutations"), f64::from(factorial(n - 1)));
        assert_eq!(number(&found, "right.permutations"), f64::from(factorial(n)));
        assert_eq!(number(&found, "wrong.fixed-items"), 0.0);
        assert!(z(&found, "right.fixed-items", 1.0).abs() < 4.5, "{n}");
        let due = 1.0 / f64::from(n - 1);
        let off = number(&found, "wrong.diagonal") - due;
        assert!(off.abs() <= 4.5 * error(&found, "wrong.diagonal"), "{n}: {off}");
        assert!(z(&found, "right.diagonal", 1.0 / f64::from(n)).abs() < 4.5, "{n}");
        assert!(z(&found, "right.mean-xy", 0.25).abs() < 4.5, "{n}");
    }
    // Two items always change places: both points lie on the diagonal, E[xy] = ((1/4)^2 + (3/4)^2) / 2.
    let two = outcome(&fence("exclusive-shuffle", "n = 2"));
    assert!(z(&two, "wrong.mean-xy", 5.0 / 16.0).abs() < 4.5);
}

/// The first digit in base 4 is the first two in base 2, swapped: 12 of 16 boxes stay empty, and the correlation tends to
/// 12 (1/16) / (1 - 1/16) = 4/5.
#[test]
fn bases_that_share_a_factor_leave_boxes_empty() {
    for n in [16, 144, 4096] {
        let found = outcome(&fence("repeated-base", &format!("n = {n}")));
        assert_eq!((number(&found, "wrong.empty-boxes"), number(&found, "wrong.boxes")), (12.0, 16.0));
        assert_eq!((number(&found, "right.empty-boxes"), number(&found, "right.boxes")), (0.0, 12.0));
    }
    // 4^6 points: a whole number of digits, so that the moments are those of the limit but for 4^-6.
    let whole = outcome(&fence("repeated-base", "n = 4096"));
    assert!((number(&whole, "wrong.correlation") - 0.8).abs() < 1e-3);
    assert!((number(&whole, "wrong.mean-xy") - 19.0 / 60.0).abs() < 1e-3);
    assert!(number(&whole, "right.correlation").abs() < 0.01);
}

/// Of the strings of m digits only those that end in a changed digit 0 or 2 are reached: 2/3 of the slabs; 0, 1, 4, 13, ... fall together.
#[test]
fn zeros_that_are_not_permuted_leave_a_third_of_the_slabs_empty() {
    for (n, hit, together) in [(9, 6.0, 3.0), (27, 18.0, 4.0), (81, 54.0, 5.0)] {
        let found = outcome(&fence("moves-zero", &format!("n = {n}")));
        assert_eq!((number(&found, "wrong.slabs-hit"), number(&found, "right.slabs-hit")), (hit, f64::from(n)));
        assert_eq!((number(&found, "wrong.most-together"), number(&found, "right.most-together")), (together, 1.0));
        // Each slab has one point, in its middle: the zeros become ones, and 0.111... in base 3 is 1/2.
        assert!((number(&found, "right.mean") - 0.5).abs() < 1e-12);
    }
    // (0 + 0 + 6 + 3 + 0 + 6 + 5 + 2 + 8) / 81, by hand.
    assert!((number(&outcome(&fence("moves-zero", "n = 9")), "wrong.mean") - 10.0 / 27.0).abs() < 1e-15);
}

/// As a sequence the quality is m - 2 and the discrepancy stays near 1/8; as a net it is 0, and the discrepancy falls.
#[test]
fn a_net_used_as_a_sequence_stalls() {
    let found = outcome(&fence("net-as-sequence", "n = 4096"));
    for m in 3..=12_u32 {
        let count = 1_u32 << m;
        assert_eq!(number(&found, &format!("wrong.t.{count}")), f64::from(m - 2));
        assert_eq!(number(&found, &format!("right.t.{count}")), 0.0);
        // A (0,m,2)-net in base 2 has D* at most (m/2 + 3/2) / N (Niederreiter 1987).
        let bound = (f64::from(m) / 2.0 + 1.5) / f64::from(count);
        assert!(number(&found, &format!("right.dstar.{count}")) <= bound, "{count}");
    }
    for count in [256, 1024, 4096] {
        assert!((number(&found, &format!("wrong.dstar.{count}")) - 0.125).abs() < 0.02, "{count}");
    }
}

/// The published first indices; that of base 13 at which the sum is beyond 1; and for one base every index before it.
#[test]
fn sums_in_single_precision_reach_one_where_they_are_known_to() {
    let found = outcome(&fence("rounded-radical-inverse", ""));
    for (base, first) in
        [("2", 33_554_431), ("3", 43_046_720), ("5", 29_296_874), ("7", 28_824_004), ("11", 17_715_609)]
    {
        assert_eq!(number(&found, &format!("first.{base}")), f64::from(first), "{base}");
    }
    assert_eq!(number(&found, "first-above.13"), 62_748_516.0);
    // 7 * 13^6 - 1, where the sum is 1: every index before was tried once.
    assert_eq!(number(&found, "first.13"), 33_787_662.0);
    assert_eq!(number(&found, "first.bits"), 33_554_431.0);
    assert_eq!((number(&found, "wrong.below-one"), number(&found, "right.below-one")), (0.0, 7.0));
    assert!(number(&found, "right.largest") < 1.0 && number(&found, "wrong.largest") >= 1.0);
    let sum = |index: u32| {
        let (mut rest, mut value, mut weight) = (index, 0.0_f32, 1.0 / 11.0_f32);
        while rest > 0 {
            value += (rest % 11) as f32 * weight;
            weight *= 1.0 / 11.0_f32;
            rest /= 11;
        }
        value
    };
    assert_eq!((0..=17_715_609).find(|&index| sum(index) >= 1.0), Some(17_715_609));
}

/// The 128 largest of 2^32 words round to 1: 2^-25 a sample.
#[test]
fn a_rounded_shift_gives_one_for_128_words() {
    let found = outcome(&fence("rounded-shift", "n = 33554432"));
    assert_eq!((number(&found, "wrong.words"), number(&found, "right.words")), (128.0, 0.0));
    assert_eq!(number(&found, "wrong.share"), 1.0 / 33_554_432.0);
    assert_eq!((number(&found, "wrong.largest"), number(&found, "right.largest")), (1.0, 1.0 - 1.0 / 16_777_216.0));
    // 1 - (1 - 1/N)^N for N = 2^25: 1 - 1/e.
    assert!((number(&found, "wrong.chance") - (1.0 - portable::exp(-1.0))).abs() < 1e-7);
    assert_eq!(number(&found, "right.chance"), 0.0);
    // All words, whatever the index: the last 128 and no other near them.
    for index in [0_u32, 1, 12_345, u32::MAX] {
        let ones = (u32::MAX - 4095..=u32::MAX).filter(|digits| {
            let word = digits ^ index.reverse_bits();
            (index.reverse_bits() ^ word) as f32 / 4_294_967_296.0 >= 1.0
        });
        assert_eq!(ones.count(), 128);
    }
}

/// In cell i from 2^j to 2^(j+1) the numbers are 2^(j-23) apart, so that 2^j of the u round up: (4^m - 1)/3 in 2^m cells.
#[test]
fn points_round_out_of_their_cells() {
    for (n, last, all) in [(2, 1.0, 1.0), (16, 8.0, 85.0), (64, 32.0, 1365.0)] {
        let found = outcome(&fence("rounded-cell", &format!("n = {n}")));
        assert_eq!((number(&found, "wrong.leaving-last"), number(&found, "wrong.leaving")), (last, all), "{n}");
        assert_eq!(number(&found, "right.leaving"), 0.0);
        assert_eq!(number(&found, "wrong.share-last"), last / 16_777_216.0);
        assert_eq!(number(&found, "wrong.largest"), 1.0);
        assert!(number(&found, "right.largest") < 1.0);
    }
    // Every u of the last of 16 cells.
    let leaving = (0..1_u32 << 24).filter(|&k| (15.0 + k as f32 / 16_777_216.0) / 16.0 >= 1.0);
    assert_eq!(leaving.count(), 8);
}

/// On the torus no place is special: the frame's share is its area, 1 - (7/8)^2.
#[test]
fn plain_distances_crowd_points_at_the_border() {
    let found = outcome(&fence("plain-distance", "n = 64\nreplicates = 64"));
    assert_eq!(number(&found, "area"), 1.0 - 49.0 / 64.0);
    assert!(z(&found, "right.frame", 15.0 / 64.0).abs() < 4.5);
    assert!(number(&found, "wrong.ratio") > 1.2 && number(&found, "wrong.z") > 10.0);
}

/// Of two consecutive seeds one is odd, and flips the first digit: x and y are in opposite halves, and E[xy] is 3/16, not 1/4.
#[test]
fn consecutive_seeds_flip_the_first_digits_oppositely() {
    let found = outcome(&fence("raw-seeds", ""));
    assert_eq!((number(&found, "wrong.opposite"), number(&found, "wrong.empty-quarters")), (1.0, 2.0));
    assert!(z(&found, "wrong.mean-xy", 3.0 / 16.0).abs() < 4.5);
    assert!(z(&found, "right.mean-xy", 0.25).abs() < 4.5 && z(&found, "right.opposite", 0.5).abs() < 4.5);
    assert!(number(&found, "wrong.z").abs() > 20.0);
    // A net of 16 points is biased as well, by less.
    let net = outcome(&fence("raw-seeds", "n = 16\nreplicates = 16384"));
    assert!(number(&net, "wrong.z").abs() > 6.0 && number(&net, "right.z").abs() < 4.5);
}
