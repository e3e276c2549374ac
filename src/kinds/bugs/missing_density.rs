//! The density is forgotten: the samples are of p(x) = 2x, but the contributions are f instead of f / p.

use super::{Bug, Numbers, Run, Source, Test};
use crate::stats::portable;

/// The integral of x exp(x) from 0 to 1, which is 1.
pub static BUG: Bug = Bug {
    key: "missing-density",
    title: "1/p forgotten",
    dimensions: 1,
    exact: 1.0,
    right,
    planted,
    caught_by: (Test::Z, Numbers::Random),
};

fn f(x: f64) -> f64 {
    x * portable::exp(x)
}

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        // The distribution function of p(x) = 2x is x^2; its inverse is the root.
        let x = point[0].sqrt();
        let weight = if x > 0.0 { f(x) / (2.0 * x) } else { 0.5 };
        run.add(&[x * x], weight);
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        let x = point[0].sqrt();
        run.add(&[x * x], f(x));
    }
    run
}
