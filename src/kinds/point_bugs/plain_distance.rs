//! Best candidates by the plain distance: beyond the border there seems to be nobody, and points crowd along it.

use super::{Asked, Bug, Count, Facts, Found, Side, mean_of};
use crate::kinds::Failure;
use crate::seed::{Random, Seed};

/// Best-candidate sets, and the points within a frame along the border.
pub static BUG: Bug = Bug {
    key: "plain-distance",
    title: "a distance that stops at the border",
    n: Some(Count::new(128, 16, 256)),
    replicates: Some(Count::new(32, 8, 256)),
    uses: &["best-candidate"],
    weight: |asked| (2 * asked.replicates * asked.n * asked.n) as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// The squared distance in the plane.
fn wrong(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = ((a[0] - b[0]).abs(), (a[1] - b[1]).abs());
    dx * dx + dy * dy
}

/// The squared distance on the torus, where opposite borders meet.
fn right(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = ((a[0] - b[0]).abs(), (a[1] - b[1]).abs());
    let (dx, dy) = (dx.min(1.0 - dx), dy.min(1.0 - dy));
    dx * dx + dy * dy
}

/// Each point is the farthest of as many random candidates as there are points so far, itself counted.
fn best_candidates(n: usize, distance: fn([f64; 2], [f64; 2]) -> f64, random: &mut Random) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(n);
    for _ in 0..n {
        let (mut best, mut farthest) = ([0.0; 2], f64::NEG_INFINITY);
        for _ in 0..=points.len() {
            let candidate = [random.uniform(), random.uniform()];
            // Most candidates are given up at the first point that is too near.
            if points.iter().all(|&point| distance(point, candidate) > farthest) {
                best = candidate;
                farthest = points.iter().map(|&point| distance(point, candidate)).fold(f64::INFINITY, f64::min);
            }
        }
        points.push(best);
    }
    points
}

/// How wide the frame is.
const WIDTH: f64 = 1.0 / 16.0;

/// The frame's share of the square.
const AREA: f64 = 1.0 - (1.0 - 2.0 * WIDTH) * (1.0 - 2.0 * WIDTH);

fn run(asked: &Asked, seed: Seed) -> Result<Found, Failure> {
    let facts = Facts::default().number("area", AREA).number("width", WIDTH);
    Ok(Found { wrong: measure(asked, wrong, seed), right: measure(asked, right, seed), facts })
}

/// The test: over the replicates the share of points in the frame is, within five standard errors, the frame's area.
///
/// On the torus no place is different from another, so that its mean is exactly the area.
fn measure(asked: &Asked, distance: fn([f64; 2], [f64; 2]) -> f64, seed: Seed) -> Side {
    let stream = seed.named("best-candidates");
    let set = |replicate: usize| best_candidates(asked.n, distance, &mut stream.at(replicate as u64).generator());
    let is_near = |x: f64| !(WIDTH..1.0 - WIDTH).contains(&x);
    let share = |points: Vec<[f64; 2]>| {
        points.iter().filter(|point| point.iter().any(|&x| is_near(x))).count() as f64 / points.len() as f64
    };
    let shares = mean_of((0..asked.replicates).map(|replicate| share(set(replicate))));
    let z = (shares.mean() - AREA) / shares.standard_error();
    let facts = Facts::default().estimate("frame", &shares).number("ratio", shares.mean() / AREA).number("z", z);
    Side::new(z.abs() <= 5.0, facts).points(&set(0)).boxes(vec![
        [0.0, 0.0, 1.0, WIDTH],
        [0.0, 1.0 - WIDTH, 1.0, 1.0],
        [0.0, WIDTH, WIDTH, 1.0 - WIDTH],
        [1.0 - WIDTH, WIDTH, 1.0, 1.0 - WIDTH],
    ])
}

mod drawing {
    //! The points of both with the frame, and their words.

    use super::super::drawing::{RIGHT, WRONG, pair, square};
    use super::{Asked, Found, Side};
    use crate::chart::number::{fixed, integer};
    use crate::chart::{ChartError, Drawing, Sheet};

    pub(super) fn draw(_: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let wrong = square(&found.wrong, WRONG, "Wrong: plain distance", &[]);
        let right = square(&found.right, RIGHT, "Right: distance on the torus", &[]);
        Ok(pair(wrong, right).draw(sheet)?.into())
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let told = |side: &Side| format!("{} % of the points", fixed(100.0 * side.facts.get("frame"), 1));
        format!(
            "Two unit squares with {} best-candidate points and a shaded frame of the width {} along the border, {} % of the area. Over {} \
             sets the frame holds, by the plain distance, {}; by the distance on the torus, {}.",
            integer(asked.n as i64),
            fixed(found.facts.get("width"), 4),
            fixed(100.0 * found.facts.get("area"), 1),
            asked.replicates,
            told(&found.wrong),
            told(&found.right)
        )
    }
}
