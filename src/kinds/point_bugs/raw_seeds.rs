//! Hash-based Owen scrambling with consecutive seeds for the two axes: their first digits are always flipped oppositely.
//!
//! A hash whose carries run upward leaves its lowest bit as the seed's lowest bit has it, and of two consecutive seeds one is even. With
//! one point a pixel, x and y never lie in the same half: the mean of `xy` is near 3/16. Hashing the seed first mends it.

use super::{Asked, Bug, Count, Facts, Found, Rule, Side, empty_boxes, mean_of};
use crate::kinds::Failure;
use crate::samplers::Method;
use crate::scrambles::owen_hash::{GRAIN, scramble};
use crate::seed::Seed;
use crate::stats::moments::Moments;

/// The first points of Sobol's sequence, scrambled anew for each replicate.
pub static BUG: Bug = Bug {
    key: "raw-seeds",
    title: "consecutive seeds that are not hashed",
    n: Some(Count::new(1, 1, 64).being(Rule::PowerOf(2))),
    replicates: Some(Count::new(4096, 1024, 65_536)),
    uses: &["sobol+owen-hash"],
    weight: |asked| 4 * (asked.n * asked.replicates) as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// The digits of both axes scrambled, with the seed and the next.
fn wrong(digits: [u32; 2], seed: u32) -> [f64; 2] {
    let seeds = [seed, seed.wrapping_add(1)];
    [0, 1].map(|axis| f64::from(scramble(digits[axis], seeds[axis])) * GRAIN)
}

/// The digits of both axes scrambled, with a hash of the seed and of the next.
fn right(digits: [u32; 2], seed: u32) -> [f64; 2] {
    let seeds = [seed, seed.wrapping_add(1)].map(hashed);
    [0, 1].map(|axis| f64::from(scramble(digits[axis], seeds[axis])) * GRAIN)
}

/// A hash of the seed in which every bit depends on all.
fn hashed(seed: u32) -> u32 {
    (Seed::new(u64::from(seed)).word() >> 32) as u32
}

/// The first points of how many replicates are shown.
const SHOWN: usize = 1024;

fn run(asked: &Asked, seed: Seed) -> Result<Found, Failure> {
    let refused = |why: String| Failure::of("n", why).help("choose another n");
    let sobol = Method::parse("sobol").map_err(|_| refused("there is no `sobol`".to_owned()))?;
    let points = sobol.points(asked.n, 2, seed).map_err(|why| refused(why.to_string()))?;
    let digits: Vec<[u32; 2]> = points.rows().map(|row| [0, 1].map(|axis| (row[axis] / GRAIN) as u32)).collect();
    let facts = Facts::default().number("exact", 0.25);
    Ok(Found { wrong: measure(asked, &digits, wrong, seed), right: measure(asked, &digits, right, seed), facts })
}

/// The test: the mean of xy over the replicates is 1/4 within five standard errors.
fn measure(asked: &Asked, digits: &[[u32; 2]], scrambled: fn([u32; 2], u32) -> [f64; 2], seed: Seed) -> Side {
    let stream = seed.named("pixels");
    let mut opposite = Moments::default();
    let (mut products, mut firsts) = (Moments::default(), Vec::new());
    for replicate in 0..asked.replicates {
        let word = (stream.at(replicate as u64).word() >> 32) as u32;
        let points: Vec<[f64; 2]> = digits.iter().map(|&digits| scrambled(digits, word)).collect();
        products.push(mean_of(points.iter().map(|[x, y]| x * y)).mean());
        let Some(&first) = points.first() else { continue };
        opposite.push(f64::from(u8::from((first[0] < 0.5) != (first[1] < 0.5))));
        firsts.push(first);
    }
    firsts.truncate(SHOWN);
    let z = (products.mean() - 0.25) / products.standard_error();
    let empty = empty_boxes(&firsts, [2, 2]);
    let facts = Facts::default()
        .estimate("mean-xy", &products)
        .number("z", z)
        .estimate("opposite", &opposite)
        .integer("empty-quarters", empty.len() as i64);
    Side::new(z.abs() <= 5.0, facts).points(&firsts).boxes(empty)
}

mod drawing {
    //! The first points of many replicates, and their words.

    use super::super::drawing::{RIGHT, WRONG, counted, pair, square};
    use super::{Asked, Found, SHOWN, Side};
    use crate::chart::number::{fixed, integer};
    use crate::chart::{ChartError, Drawing, Sheet, Strata};

    pub(super) fn draw(_: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let wrong = square(&found.wrong, WRONG, "Wrong: seeds *s* and *s* + 1", &[Strata::cells(2)]);
        let right = square(&found.right, RIGHT, "Right: both seeds hashed", &[Strata::cells(2)]);
        Ok(pair(wrong, right).draw(sheet)?.into())
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let told = |side: &Side| {
            let empty = counted(side.facts.count("empty-quarters"), "quarter");
            let (mean, z) = (fixed(side.facts.get("mean-xy"), 4), fixed(side.facts.get("z"), 1));
            format!("{empty} empty, mean of xy {mean}, {z} standard errors from 1/4")
        };
        format!(
            "Two unit squares cut into quarters, with the first scrambled points of {SHOWN} replicates. The mean of xy is that of {} \
             replicates of {}. Consecutive seeds: {}. Hashed seeds: {}.",
            integer(asked.replicates as i64),
            counted(asked.n as i64, "point"),
            told(&found.wrong),
            told(&found.right)
        )
    }
}
