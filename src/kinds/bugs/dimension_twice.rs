//! One dimension is used twice: both coordinates of the sample are made from the same number.

use super::{Bug, Numbers, Run, Source, Test};

/// The integral of xy over the unit square, which is 1/4.
pub static BUG: Bug = Bug {
    key: "dimension-twice",
    title: "dimension used twice",
    dimensions: 2,
    exact: 0.25,
    right,
    planted,
    caught_by: (Test::Correlation, Numbers::Random),
};

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        let (x, y) = (point[0], point[1]);
        run.add(&[x, y], x * y);
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        let (x, y) = (point[0], point[0]);
        run.add(&[x, y], x * y);
    }
    run
}
