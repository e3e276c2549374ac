//! The folded radical inverse, or Halton-Zaremba sequence.
//!
//! **What.** As the Halton sequence, but digit k of each radical inverse, counted from 0, is raised
//! by k modulo the base, for all infinitely many k.
//!
//! **Formula.** i = sum a_k b^k gives sum ((a_k + k) mod b) b^(-k-1).
//!
//! **Guarantees.** The first m of n points are the m points; boxes keep their counts as in the
//! Halton sequence. Deterministic; in base 2, n = 0, 1, 2, ... gives 1/3, 5/6, 1/12, 7/12, ...
//!
//! **Cost.** One division for each digit that a `f64` holds.
//!
//! **Limits.** Digits of the index that a `f64` cannot hold are dropped; at most 256 dimensions;
//! correlated late axes, as Halton's.
//!
//! **Paper.** J. H. Halton and S. K. Zaremba, The Extreme and L2 Discrepancies of Some Plane Sets,
//! Monatsh. Math. 73 (1969), doi 10.1007/BF01298982.
//!
//! ```
//! use workbook::samplers::folded::folded_inverse;
//! assert!((folded_inverse(0, 2) - 1.0 / 3.0).abs() < 1e-16);
//! assert!((folded_inverse(1, 2) - 5.0 / 6.0).abs() < 1e-15);
//! ```

use super::halton::{MOST_DIMENSIONS, PRIMES};
use super::{Feature, Guarantee, Radix, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `folded`.
pub struct Folded;

static ABOUT: About = About {
    key: "folded",
    title: "Folded radical inverse",
    summary: "The Halton-Zaremba sequence: digit k of the radical inverse is raised by k modulo the base.",
    file: "samplers/folded.rs",
    source: include_str!("folded.rs"),
    papers: &[Paper {
        authors: "J. H. Halton and S. K. Zaremba",
        year: 1969,
        title: "The Extreme and L2 Discrepancies of Some Plane Sets",
        venue: "Monatshefte für Mathematik 73, 316-328",
        doi: Some("10.1007/BF01298982"),
    }],
};

impl Entry for Folded {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Folded {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Boxes, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, MOST_DIMENSIONS)
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            for (x, prime) in point.iter_mut().zip(PRIMES) {
                *x = folded_inverse(i as u64, prime);
            }
        }
        refused::points(d, coordinates)
    }

    fn at(&self, _n: usize, d: usize, _seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        (d <= MOST_DIMENSIONS).then(|| Box::new(|index, axis| folded_inverse(index, PRIMES[axis])) as Box<_>)
    }
}

/// The folded radical inverse of `index` in base `base >= 2`, in [0, 1).
pub fn folded_inverse(index: u64, base: u32) -> f64 {
    let radix = Radix::new(base);
    let base = u64::from(radix.base);
    let (mut rest, mut numerator) = (index, 0);
    for k in 0..u64::from(radix.digits) {
        numerator = numerator * base + (rest + k) % base;
        rest /= base;
    }
    // Behind the last digit of the index, 0 + k mod b goes on for ever; its sum is known to the
    // last bit after 60 terms.
    let tail = (0..60).rev().fold(0.0, |sum, k| (sum + ((u64::from(radix.digits) + k) % base) as f64) / base as f64);
    radix.coordinate_with(numerator, tail)
}
