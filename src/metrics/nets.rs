//! Nets: the quality t of a set of b^m points, and how many elementary intervals it violates.
//!
//! **Formula.** An elementary interval in base b has on axis j a length b^-k_j and begins at a
//! multiple of it. A set of b^m points is a (t, m, d)-net if every elementary interval of volume
//! b^(t-m) holds b^t points; the quality is the smallest such t, and 0 is best.
//!
//! **Cost.** n times the number of shapes, binom(m - t + d - 1, d - 1), for each t tried.
//!
//! **Paper.** H. Niederreiter, Point Sets and Sequences with Small Discrepancy, Monatsh. Math. 104
//! (1987), doi 10.1007/BF01294651.
//!
//! ```
//! use workbook::{metrics::nets::{quality, violations}, samplers::{Sampler, sobol::Sobol}, seed::Seed};
//! let points = Sobol.points(16, 2, Seed::new(1))?;
//! assert_eq!((quality(&points, 2), violations(&points, 2, 0)), (Some(0), Some(0)));
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Known, Measured, Metric, Unmeasured};
use crate::catalogue::{About, Entry, Paper};
use crate::points::{Points, slab};
use crate::samplers::digits::logarithm;

/// The measure `t-value`, in base 2.
pub struct Quality;

static ABOUT: About = About {
    key: "t-value",
    title: "Quality t of a net",
    summary: "The smallest t for which 2^m points are a (t, m, d)-net in base 2.",
    file: "metrics/nets.rs",
    source: include_str!("nets.rs"),
    papers: &[Paper {
        authors: "H. Niederreiter",
        year: 1987,
        title: "Point Sets and Sequences with Small Discrepancy",
        venue: "Monatshefte für Mathematik 104, 273-337",
        doi: Some("10.1007/BF01294651"),
    }],
};
impl Entry for Quality {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Metric for Quality {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        let t = quality(points, 2)
            .ok_or(Unmeasured::Kind("the quality t needs n = 2^m points, and at most 2^32 counts"))?;
        Ok(Measured::exact(f64::from(t)))
    }

    fn known(&self) -> &'static [Known] {
        &[
            Known { method: "hammersley", n: 64, d: 2, value: "0", source: "Niederreiter (1987)" },
            Known { method: "sobol", n: 64, d: 2, value: "0", source: "Sobol' (1967)" },
            Known {
                method: "sobol",
                n: 1024,
                d: 3,
                value: "1",
                source: "Sobol' (1967): the degrees of the polynomials less one, added up",
            },
        ]
    }
}

/// Cell counts that one question may take.
const MOST_COUNTS: f64 = 4_294_967_296.0;

/// The quality t of `points` as a net in base `base`; `None` unless n is a power of it, or where
/// the intervals are too many to look at.
pub fn quality(points: &Points, base: u32) -> Option<u32> {
    let m = logarithm(points.len() as u64, base)?;
    // A net for t is one for t + 1 as well: the first t without a violation is the smallest.
    for t in 0..m {
        if violated(points, base, t, true)? == 0 {
            return Some(t);
        }
    }
    Some(m)
}

/// How many elementary intervals of volume b^(t-m) do not hold b^t points; `None` as for
/// [`quality`].
pub fn violations(points: &Points, base: u32, t: u32) -> Option<u64> {
    violated(points, base, t, false)
}

/// Violations, all of them or, if `first`, 1 as soon as there is one.
fn violated(points: &Points, base: u32, t: u32, first: bool) -> Option<u64> {
    let (n, d) = (points.len(), points.dimensions());
    let m = logarithm(n as u64, base)?;
    let levels = m.checked_sub(t)?;
    let shapes = (1..d).fold(1.0, |shapes, k| shapes * (f64::from(levels) + k as f64) / k as f64);
    if shapes * n as f64 > MOST_COUNTS {
        return None;
    }
    let due = u64::from(base).pow(t) as u32;
    let mut counts = vec![0_u32; (u64::from(base).pow(levels)) as usize];
    let mut shape = vec![0; d];
    shape[d - 1] = levels;
    let mut bad = 0;
    loop {
        counts.fill(0);
        let cuts: Vec<usize> = shape.iter().map(|&k| (base as usize).pow(k)).collect();
        for row in points.rows() {
            counts[row.iter().zip(&cuts).fold(0, |cell, (&x, &cut)| cell * cut + slab(x, cut))] += 1;
        }
        bad += counts.iter().filter(|&&count| count != due).count() as u64;
        if (first && bad > 0) || !next(&mut shape) {
            return Some(bad);
        }
    }
}

/// The next composition of the same total, in lexicographic order; `false` after the last.
fn next(shape: &mut [u32]) -> bool {
    // What stands behind the place that grows goes, less one, to the end.
    let Some(last) = shape.iter().rposition(|&k| k > 0).filter(|&last| last > 0) else { return false };
    let moved = shape[last] - 1;
    shape[last] = 0;
    shape[last - 1] += 1;
    let end = shape.len() - 1;
    shape[end] = moved;
    true
}
