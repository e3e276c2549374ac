//! The number is rounded to single precision, where the largest numbers below 1 become 1: once in 2^25 samples, the table has no such entry.

use super::{Bug, Numbers, Run, Source, Test};

/// The mean of a table with straight lines between its entries, which is 9/16 by the trapezoid rule.
pub static BUG: Bug = Bug {
    key: "rounded-to-one",
    title: "rounded to 1.0 in f32",
    dimensions: 1,
    exact: 0.5625,
    right,
    planted,
    caught_by: (Test::Range, Numbers::Random),
};

/// The heights at 0, 1/4, 1/2, 3/4 and 1.
const TABLE: [f64; 5] = [0.25, 0.5, 1.0, 0.5, 0.25];

/// The table's value at u in [0, 1); not a number beyond.
fn look_up(u: f64) -> f64 {
    let cell = (4.0 * u) as usize;
    match (TABLE.get(cell), TABLE.get(cell + 1)) {
        (Some(left), Some(right)) => left + (right - left) * (4.0 * u - cell as f64),
        _ => f64::NAN,
    }
}

fn right(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        run.add(&[point[0]], look_up(point[0]));
    }
    run
}

fn planted(source: &Source<'_>) -> Run {
    let mut run = Run::default();
    for point in source.points().take(source.len()) {
        let u = f64::from(point[0] as f32);
        run.add(&[u], look_up(u));
    }
    run
}
