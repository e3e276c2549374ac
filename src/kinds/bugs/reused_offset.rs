//! The randomisation of the first pixel is used in every pixel: each pixel's error is the same, and no average removes it.

use super::{Bug, Numbers, Run, Source, Test};
use crate::stats::portable;

/// The integral of exp(x) from 0 to 1, which is e - 1, in every pixel.
pub static BUG: Bug = Bug {
    key: "reused-offset",
    title: "offset reused",
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
    for point in source.points_of_first_pixel().take(source.len()) {
        run.add(&[point[0]], portable::exp(point[0]));
    }
    run
}
