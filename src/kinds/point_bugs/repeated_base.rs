//! Halton's sequence in bases 2 and 4, which are not coprime: of 16 boxes 12 stay empty for ever.
//!
//! The first digit in base 4 is made of the first two digits in base 2, so that x decides the quarter of y.

use super::{Asked, Bug, Count, Facts, Found, Side, empty_boxes, mean_of, placed};
use crate::kinds::Failure;
use crate::metrics::correlation::pearson;
use crate::samplers::halton::radical_inverse;
use crate::seed::Seed;

/// The first points of a sequence in two bases.
pub static BUG: Bug = Bug {
    key: "repeated-base",
    title: "bases that are not coprime",
    n: Some(Count::new(144, 16, 4096)),
    replicates: None,
    uses: &["halton"],
    weight: |asked| 2 * asked.n as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// Points in bases 2 and 4: both prime powers, but powers of one prime.
fn wrong(n: usize) -> Vec<[f64; 2]> {
    (0..n as u64).map(|index| [radical_inverse(index, 2), radical_inverse(index, 4)]).collect()
}

/// Points in bases 2 and 3, which are coprime.
fn right(n: usize) -> Vec<[f64; 2]> {
    (0..n as u64).map(|index| [radical_inverse(index, 2), radical_inverse(index, 3)]).collect()
}

fn run(asked: &Asked, _: Seed) -> Result<Found, Failure> {
    let (wrong, right) = (measure(&wrong(asked.n), 4), measure(&right(asked.n), 3));
    Ok(Found { wrong, right, facts: Facts::default() })
}

/// The test: each of the boxes of sides 1/4 = 2^-2 and 1/`base` is hit.
///
/// For coprime bases a run of 4 `base` indices hits each of them once, by the Chinese remainder theorem.
fn measure(points: &[[f64; 2]], base: usize) -> Side {
    let empty = empty_boxes(points, [4, base]);
    let correlation = placed(points).and_then(|points| pearson(&points, 0, 1)).unwrap_or(f64::NAN);
    let facts = Facts::default()
        .integer("boxes", 4 * base as i64)
        .integer("empty-boxes", empty.len() as i64)
        .number("mean-xy", mean_of(points.iter().map(|[x, y]| x * y)).mean())
        .number("correlation", correlation);
    Side::new(empty.is_empty(), facts).points(points).boxes(empty)
}

mod drawing {
    //! The points of both pairs of bases in their boxes, and their words.

    use super::super::drawing::{RIGHT, WRONG, pair, square};
    use super::{Asked, Found, Side};
    use crate::chart::number::{integer, significant};
    use crate::chart::{ChartError, Drawing, Sheet, Strata};

    pub(super) fn draw(_: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let wrong = square(&found.wrong, WRONG, "Wrong: bases 2 and 4", &[Strata::boxes(4, 4)]);
        let right = square(&found.right, RIGHT, "Right: bases 2 and 3", &[Strata::boxes(4, 3)]);
        Ok(pair(wrong, right).draw(sheet)?.into())
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let told = |side: &Side, rows: usize| {
            let (empty, boxes) = (side.facts.count("empty-boxes"), side.facts.count("boxes"));
            let correlation = significant(side.facts.get("correlation"), 2);
            format!("of the {boxes} boxes (4 columns, {rows} rows) {empty} are empty, correlation {correlation}")
        };
        format!(
            "{} points of Halton's sequence in two unit squares, empty boxes shaded. Bases 2 and 4: {}. Bases 2 and 3: {}.",
            integer(asked.n as i64),
            told(&found.wrong, 4),
            told(&found.right, 3),
        )
    }
}
