//! The Kronecker sequence of the generalised golden ratio, called R2 in two dimensions.
//!
//! **What.** Every axis adds a constant step modulo 1. The steps are the powers of 1/g, with g the
//! real root of g^(d+1) = g + 1: the golden ratio for d = 1, the plastic number for d = 2.
//!
//! **Formula.** x_ij = ((i + 1) g^(-j)) mod 1, j = 1 ... d; the first point in two dimensions is
//! (0.7548776662466927, 0.5698402909980532).
//!
//! **Guarantees.** The first m of n points are the m points. Deterministic. In one dimension D* =
//! O(log(n) / n); that it is low in more is seen, not proved.
//!
//! **Cost.** One multiplication of whole numbers for each coordinate: the steps are held as 64-bit
//! fractions, so that no index loses digits.
//!
//! **Limits.** No strata: n equal cells do not hold one point each. At most 64 dimensions, and poor
//! beyond a few, since g tends to 1.
//!
//! **Paper.** L. Kronecker's theorem; the choice of steps: M. Roberts, The Unreasonable
//! Effectiveness of Quasirandom Sequences (2018),
//! <https://extremelearning.com.au/unreasonable-effectiveness-of-quasirandom-sequences/>; for d =
//! 1: L. Kuipers and H. Niederreiter, Uniform Distribution of Sequences, Wiley 1974.
//!
//! ```
//! use workbook::{samplers::{Sampler, kronecker::Kronecker}, seed::Seed};
//! let points = Kronecker.points(1, 2, Seed::new(1))?;
//! assert_eq!(points.coordinates(), [0.7548776662466927, 0.5698402909980532]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Feature, Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The most dimensions.
const MOST_DIMENSIONS: usize = 64;

/// The sampler `kronecker`.
pub struct Kronecker;

static ABOUT: About = About {
    key: "kronecker",
    title: "Kronecker (R sequence)",
    summary: "Multiples of powers of the generalised golden ratio modulo 1; the plastic number in two dimensions.",
    file: "samplers/kronecker.rs",
    source: include_str!("kronecker.rs"),
    papers: &[
        Paper {
            authors: "M. Roberts",
            year: 2018,
            title: "The Unreasonable Effectiveness of Quasirandom Sequences",
            venue: "https://extremelearning.com.au/unreasonable-effectiveness-of-quasirandom-sequences/",
            doi: None,
        },
        Paper {
            authors: "L. Kuipers and H. Niederreiter",
            year: 1974,
            title: "Uniform Distribution of Sequences",
            venue: "Wiley",
            doi: None,
        },
    ],
};

impl Entry for Kronecker {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Kronecker {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Deterministic]
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
        let steps = steps(d);
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            for (x, &step) in point.iter_mut().zip(&steps) {
                *x = multiple(i as u64, step);
            }
        }
        refused::points(d, coordinates)
    }

    fn at(&self, _n: usize, d: usize, _seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        let steps = steps(d.min(MOST_DIMENSIONS));
        Some(Box::new(move |index, axis| multiple(index, steps[axis])))
    }
}

/// The coordinate of point `index` on an axis with the step `step` / 2^64.
fn multiple(index: u64, step: u64) -> f64 {
    // Unsigned arithmetic is modulo 2^64, which is modulo 1 here.
    let turned = index.wrapping_add(1).wrapping_mul(step);
    let rounded = turned.saturating_add(1 << 10) >> 11;
    rounded.min((1 << 53) - 1) as f64 * (1.0 / 9_007_199_254_740_992.0)
}

/// The steps g^-1 ... g^-d as fractions of 2^64.
pub fn steps(d: usize) -> Vec<u64> {
    // a = 1/g solves a + a^(d+1) ... = 1 in the form a^(d+1) + a^d = 1, whose left side grows with
    // a: bisect its 64 bits.
    let product = |x: u64, y: u64| ((u128::from(x) * u128::from(y)) >> 64) as u64;
    let mut step = 0_u64;
    for bit in (0..64).rev() {
        let tried = step | 1 << bit;
        let power = (1..d).fold(tried, |power, _| product(power, tried));
        if power.checked_add(product(power, tried)).is_some() {
            step = tried;
        }
    }
    std::iter::successors(Some(step), |&power| Some(product(power, step))).take(d).collect()
}
