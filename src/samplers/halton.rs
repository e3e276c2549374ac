//! The Halton sequence: radical inverses in a different prime base on each axis.
//!
//! **What.** Axis j reverses the digits of the index in base b_j, the j-th prime: (Phi_2(i),
//! Phi_3(i), Phi_5(i), ...).
//!
//! **Formula.** i = sum a_k b^k gives Phi_b(i) = sum a_k b^(-k-1).
//!
//! **Guarantees.** The first m of n points are the m points; of any b1^k1 ... bd^kd consecutive
//! points one falls in each of the equal boxes that cut axis j into bj^kj, because the bases are
//! pairwise coprime. Deterministic; star discrepancy O(log^d(n) / n).
//!
//! **Cost.** One integer division for each digit; the batch counts digits up instead.
//!
//! **Limits.** Axes with large bases are correlated until n is well over the product of their
//! bases: the first 131 points of axes 32 and 33 lie on one line. Random permutations of the digits
//! cure that. At most 256 dimensions. Digits that a `f64` cannot hold are dropped: indices below
//! 2^42 lose nothing on any axis.
//!
//! **Paper.** J. H. Halton, On the Efficiency of Certain Quasi-Random Sequences of Points in
//! Evaluating Multi-Dimensional Integrals, Numer. Math. 2 (1960), doi 10.1007/BF01386213.
//!
//! ```
//! use workbook::samplers::halton::radical_inverse;
//! assert_eq!(radical_inverse(5, 3), 7.0 / 9.0); // 5 is 12 in base 3; reversed, 0.21 = 7/9
//! ```

use super::{Digital, Digits, Feature, Guarantee, Radix, Refused, Sampler, digits, refused};
use crate::catalogue::{About, Entry, Paper};

/// The most dimensions.
pub const MOST_DIMENSIONS: usize = 256;

/// The first 256 primes: axis j has base `PRIMES[j]`.
pub const PRIMES: [u32; MOST_DIMENSIONS] = digits::primes();

/// The base of each axis with its digits.
static RADICES: [Radix; MOST_DIMENSIONS] = {
    let mut radices = [Radix::new(2); MOST_DIMENSIONS];
    let mut axis = 0;
    while axis < MOST_DIMENSIONS {
        radices[axis] = Radix::new(PRIMES[axis]);
        axis += 1;
    }
    radices
};

/// The sampler `halton`, and its digits.
pub struct Halton;

static ABOUT: About = About {
    key: "halton",
    title: "Halton",
    summary: "Radical inverses of the index in the first d primes.",
    file: "samplers/halton.rs",
    source: include_str!("halton.rs"),
    papers: &[Paper {
        authors: "J. H. Halton",
        year: 1960,
        title: "On the Efficiency of Certain Quasi-Random Sequences of Points in Evaluating Multi-Dimensional Integrals",
        venue: "Numerische Mathematik 2, 84-90",
        doi: Some("10.1007/BF01386213"),
    }],
};

impl Entry for Halton {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Halton {
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

    fn digits(&self) -> Digits {
        Digits::Mixed
    }

    fn digital(&self, _n: usize, _d: usize) -> Option<Box<dyn Digital>> {
        Some(Box::new(Halton))
    }
}

impl Digital for Halton {
    fn radix(&self, axis: usize) -> Radix {
        RADICES[axis]
    }

    fn numerator(&self, index: u64, axis: usize) -> u64 {
        self.radix(axis).reversed(index)
    }

    fn is_radical(&self, _axis: usize) -> bool {
        true
    }
}

/// The radical inverse of `index` in base `base`, in [0, 1): the digits
/// reversed as a whole number, then one division.
///
/// Summing a_k b^(-k-1) in floating point instead rounds at every term, and
/// reaches 1 at last. A base below 2 counts as 2.
pub fn radical_inverse(index: u64, base: u32) -> f64 {
    let base = u64::from(base.max(2));
    let (mut rest, mut reversed, mut scale) = (index, 0, 1);
    // Stop at the last digit that a f64 can hold exactly.
    while rest > 0 && scale <= (1 << 53) / base {
        reversed = reversed * base + rest % base;
        scale *= base;
        rest /= base;
    }
    reversed as f64 / scale as f64
}
