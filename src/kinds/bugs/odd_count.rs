//! The number of points is no power of two: a quarter of them is saved, and with it the rate.

use super::{Bug, Numbers, Run, Source, Test};
use crate::stats::portable;

/// The integral of exp(x) from 0 to 1, which is e - 1.
pub static BUG: Bug = Bug {
    key: "odd-count",
    title: "N not a power of two",
    dimensions: 1,
    exact: std::f64::consts::E - 1.0,
    right,
    planted,
    caught_by: (Test::Strata, Numbers::Quasi),
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
    for point in source.points().take(3 * source.len() / 4) {
        run.add(&[point[0]], portable::exp(point[0]));
    }
    run
}
