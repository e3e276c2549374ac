//! Rejection under quasi-Monte Carlo: right with random numbers, and still unbiased with others, but which points are kept
//! depends on a border that cuts through the strata, and their rate is lost.

use super::{Bug, Numbers, Run, Source, Test};
use crate::stats::portable;
use std::f64::consts::PI;

/// The integral of xy over the quarter of the unit disk, which is 1/8.
pub static BUG: Bug = Bug {
    key: "rejection",
    title: "rejection",
    dimensions: 2,
    exact: 0.125,
    right,
    planted,
    caught_by: (Test::Rate, Numbers::Quasi),
};

/// The area of the quarter disk.
const AREA: f64 = PI / 4.0;

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        // The map of the square to the disk that keeps areas.
        let (radius, angle) = (point[0].sqrt(), 0.5 * PI * point[1]);
        let (x, y) = (radius * portable::cos(angle), radius * portable::sin(angle));
        run.add(&[radius * radius], AREA * x * y);
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    let inside = |point: &&[f64]| point[0] * point[0] + point[1] * point[1] < 1.0;
    for point in source.points().filter(inside).take(source.len()) {
        let (x, y) = (point[0], point[1]);
        run.add(&[x * x + y * y], AREA * x * y);
    }
    run
}
