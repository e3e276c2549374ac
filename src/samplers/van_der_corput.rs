//! The van der Corput sequence: the digits of the index, reversed behind the point.
//!
//! **What.** In base 2, point i is the number whose binary digits after the point are those of i
//! from the last to the first: 0, 1/2, 1/4, 3/4, 1/8, ...
//!
//! **Formula.** i = sum a_k 2^k gives Phi_2(i) = sum a_k 2^(-k-1).
//!
//! **Guarantees.** The first m of n points are the m points; every aligned block of 2^m points is a
//! (0, m, 1)-net: one point in each dyadic interval. The star discrepancy is at most (log2(n) /
//! 3 + 1) / n. Deterministic.
//!
//! **Cost.** One bit reversal and one multiplication.
//!
//! **Limits.** One dimension. Two axes need two bases ([Halton](super::halton)) or another matrix
//! ([Sobol'](super::sobol)). Bits of the index from the 54th on are dropped: a `f64` has no room
//! for them.
//!
//! **Paper.** J. G. van der Corput, Verteilungsfunktionen, Proc. Kon. Ned. Akad. v. Wetensch. 38
//! (1935), 813-821.
//!
//! ```
//! use workbook::samplers::van_der_corput::bit_reversal;
//! let first: Vec<f64> = (0..5).map(bit_reversal).collect();
//! assert_eq!(first, [0.0, 0.5, 0.25, 0.75, 0.125]);
//! ```

use super::digits::GRAIN;
use super::{Digital, Digits, Feature, Guarantee, Net, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};

/// The sampler `van-der-corput`, and its digits.
pub struct VanDerCorput;

static ABOUT: About = About {
    key: "van-der-corput",
    title: "van der Corput",
    summary: "The binary digits of the index reversed behind the point; one dimension.",
    file: "samplers/van_der_corput.rs",
    source: include_str!("van_der_corput.rs"),
    papers: &[Paper {
        authors: "J. G. van der Corput",
        year: 1935,
        title: "Verteilungsfunktionen",
        venue: "Proceedings of the Koninklijke Nederlandse Akademie van Wetenschappen 38, 813-821",
        doi: None,
    }],
};

impl Entry for VanDerCorput {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for VanDerCorput {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Net, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, 1)
    }

    fn net(&self, _d: usize) -> Option<Net> {
        Some(Net { base: 2, t: 0 })
    }

    fn digits(&self) -> Digits {
        Digits::Binary
    }

    fn digital(&self, _n: usize, _d: usize) -> Option<Box<dyn Digital>> {
        Some(Box::new(VanDerCorput))
    }
}

impl Digital for VanDerCorput {
    fn numerator(&self, index: u64, _axis: usize) -> u64 {
        reversed_bits(index)
    }
}

/// The van der Corput number of `index`, in [0, 1): its bits reversed behind the binary point.
#[inline]
pub fn bit_reversal(index: u64) -> f64 {
    reversed_bits(index) as f64 * GRAIN
}

/// The 53 lowest bits of `index` reversed, as a whole number below 2^53.
///
/// Reversing 64 bits swaps neighbours, pairs, nibbles, bytes, ...; the shift
/// drops the 11 bits for which a `f64` has no room, where rounding would
/// reach 1.
#[inline]
pub fn reversed_bits(index: u64) -> u64 {
    index.reverse_bits() >> 11
}
