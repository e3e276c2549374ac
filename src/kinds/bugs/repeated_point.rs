//! The first point is taken twice: an index that is not advanced before its second use.

use super::{Bug, Numbers, Run, Source, Test};
use crate::stats::portable;

/// The integral of exp(x) from 0 to 1, which is e - 1.
pub static BUG: Bug = Bug {
    key: "repeated-point",
    title: "first point repeated",
    dimensions: 1,
    exact: std::f64::consts::E - 1.0,
    right,
    planted,
    caught_by: (Test::Repeats, Numbers::Quasi),
};

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        run.add(&[point[0]], portable::exp(point[0]));
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    let again = source.points().take(1);
    for point in again.chain(source.points()).take(source.len()) {
        run.add(&[point[0]], portable::exp(point[0]));
    }
    run
}
