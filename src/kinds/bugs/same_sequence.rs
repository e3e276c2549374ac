//! The same sequence for two decisions: each has a generator of its own, which is right as long as the numbers are random.
//!
//! Two random generators are seeded apart. Two quasi-random ones are one sequence, and the decisions always agree.

use super::{Bug, Numbers, Run, Source, Test};

/// The integral of (x + y)^2 over the unit square, which is 7/6.
pub static BUG: Bug = Bug {
    key: "same-sequence",
    title: "same sequence twice",
    dimensions: 2,
    exact: 7.0 / 6.0,
    right,
    planted,
    caught_by: (Test::Correlation, Numbers::Quasi),
};

fn f(x: f64, y: f64) -> f64 {
    (x + y) * (x + y)
}

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        run.add(&[point[0], point[1]], f(point[0], point[1]));
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    let (light, lens) = (source.generator(0), source.generator(1));
    for (x, y) in light.zip(lens).take(source.len()) {
        run.add(&[x, y], f(x, y));
    }
    run
}
