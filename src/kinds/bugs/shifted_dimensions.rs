//! Dimensions are allotted by a counter that a branch shifts: one branch takes three numbers, the other two, and from the first
//! short one on every number has another meaning than its dimension.

use super::{Bug, Numbers, Run, Source, Test};

/// The integral of x^2 from 0 to 1 and that of xy over the unit square, together 7/12, one of them chosen for each sample.
pub static BUG: Bug = Bug {
    key: "shifted-dimensions",
    title: "shifted dimensions",
    dimensions: 3,
    exact: 7.0 / 12.0,
    right,
    planted,
    caught_by: (Test::Rate, Numbers::Quasi),
};

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        let (choice, x, y) = (point[0], point[1], point[2]);
        // Each branch is taken with probability 1/2.
        let value = if choice < 0.5 { x * x / 0.5 } else { x * y / 0.5 };
        run.add(&[choice, x], value);
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    let mut numbers = source.numbers();
    let mut next = || numbers.next().unwrap_or_default();
    for _ in 0..source.len() {
        let (choice, x) = (next(), next());
        let y = if choice < 0.5 { x } else { next() };
        let value = x * y / 0.5;
        run.add(&[choice, x], value);
    }
    run
}
