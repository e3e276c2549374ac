//! The first point is dropped, because it is at the origin: the rest is no net.
//!
//! Along the first axis of Sobol' points nothing is lost, since point N comes into the slab of point 0. Along the second it does not.

use super::{Bug, Numbers, Run, Source, Test};
use crate::stats::portable;

/// The integral of exp(x + y) over the unit square, which is (e - 1)^2.
pub static BUG: Bug = Bug {
    key: "dropped-point",
    title: "first point dropped",
    dimensions: 2,
    exact: 2.952_492_442_012_56,
    right,
    planted,
    caught_by: (Test::Strata, Numbers::Quasi),
};

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        run.add(point, portable::exp(point[0] + point[1]));
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().skip(1).take(source.len()) {
        run.add(point, portable::exp(point[0] + point[1]));
    }
    run
}
