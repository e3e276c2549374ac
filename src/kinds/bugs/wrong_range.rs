//! The range is wrong: the integral goes from 0 to 2, but the samples from 0 to 1.

use super::{Bug, Numbers, Run, Source, Test};
use crate::stats::portable;

/// The integral of x exp(-x) from 0 to 2, which is 1 - 3 exp(-2).
pub static BUG: Bug = Bug {
    key: "wrong-range",
    title: "wrong range",
    dimensions: 1,
    exact: 0.593_994_150_290_161_9,
    right,
    planted,
    caught_by: (Test::ChiSquare, Numbers::Random),
};

fn f(x: f64) -> f64 {
    x * portable::exp(-x)
}

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        let x = 2.0 * point[0];
        // The density is 1/2 from 0 to 2, and the distribution function x / 2.
        run.add(&[x / 2.0], f(x) / 0.5);
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        let x = point[0];
        run.add(&[x / 2.0], f(x) / 0.5);
    }
    run
}
