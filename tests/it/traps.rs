//! The mistakes in placing points: each wrong program has the value that theory or a paper gives it, and the test tells it from the right one.

use crate::asked::{error, holds, number, outcome, z};
use crate::parameters::plan;
use crate::point_kinds::drawn;
use workbook::chart::Drawing;
use workbook::sources;

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
    assert!(names.len() >= 3, "{names:?}");
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
