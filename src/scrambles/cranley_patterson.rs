//! The Cranley-Patterson rotation: a random shift modulo 1.
//!
//! **What.** Each axis gets one uniform shift, added to every coordinate; what leaves the cube at
//! one side comes in at the other.
//!
//! **Formula.** x becomes (x + s) mod 1.
//!
//! **Guarantees.** Each point is uniform, hence the mean is unbiased; prefixes stay prefixes.
//! Lattices stay lattices.
//!
//! **Cost.** One addition for each coordinate.
//!
//! **Limits.** Nets do not stay nets: of 16 points in two dimensions only about 2.3 % of the shifts
//! keep all dyadic intervals filled. Point sets that are random already are refused: they gain
//! nothing, and lose their strata.
//!
//! **Paper.** R. Cranley and T. N. L. Patterson, Randomization of Number Theoretic Methods for
//! Multiple Integration, SIAM J. Numer. Anal. 13(6) (1976), doi 10.1137/0713071.
//!
//! ```
//! use workbook::scrambles::cranley_patterson::rotate;
//! assert_eq!(rotate(0.75, 0.5), 0.25);
//! assert!(rotate(f64::EPSILON / 4.0, 1.0 - f64::EPSILON / 2.0) < 1.0);
//! ```

use super::{Action, Scramble};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::{Guarantee, Radix, Sampler};
use crate::seed::Seed;

/// The scramble `cranley-patterson`.
pub struct CranleyPatterson;

static ABOUT: About = About {
    key: "cranley-patterson",
    title: "Cranley-Patterson",
    summary: "A random shift of each axis modulo 1.",
    file: "scrambles/cranley_patterson.rs",
    source: include_str!("cranley_patterson.rs"),
    papers: &[Paper {
        authors: "R. Cranley and T. N. L. Patterson",
        year: 1976,
        title: "Randomization of Number Theoretic Methods for Multiple Integration",
        venue: "SIAM Journal on Numerical Analysis 13(6), 904-914",
        doi: Some("10.1137/0713071"),
    }],
};

impl Entry for CranleyPatterson {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for CranleyPatterson {
    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str> {
        let random = !sampler.guarantees().contains(&Guarantee::Deterministic);
        if random { Err("its points are random already, and a shift would only break their strata") } else { Ok(()) }
    }

    fn keeps(&self, guarantee: Guarantee) -> bool {
        guarantee == Guarantee::Prefix
    }

    fn action(&self, _radix: Radix, axis: usize, seed: Seed) -> Action {
        let shift = seed.at(axis as u64).generator().uniform();
        Action::Coordinate(Box::new(move |x| rotate(x, shift)))
    }
}

/// The sum of `x` and `shift`, both in [0, 1), modulo 1.
#[inline]
pub fn rotate(x: f64, shift: f64) -> f64 {
    let sum = x + shift;
    // A sum just below 1 may round up to 1, which is 0 on the circle.
    if sum < 1.0 { sum } else { sum - 1.0 }
}
