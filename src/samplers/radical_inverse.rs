//! The radical inverse of the index in any base: van der Corput's sequence and its kin.
//!
//! **What.** Point i is the number whose digits in base b behind the point are those of i from the
//! last to the first. Base 2, unless another is set, gives [`van_der_corput`](super::van_der_corput).
//!
//! **Formula.** i = sum a_k b^k gives Phi_b(i) = sum a_k b^(-k-1).
//!
//! **Guarantees.** The first m of n points are the m points; every aligned block of b^m points is a
//! (0, m, 1)-net in base b: one point in each interval of length b^-m. Deterministic; star
//! discrepancy O(log(n) / n), with a constant that grows with b.
//!
//! **Cost.** One division for each digit; the batch counts digits up instead.
//!
//! **Limits.** One dimension; bases from 2 to 65,536, prime or not. Several axes with pairwise
//! coprime bases are [Halton's](super::halton). Digits of the index that a `f64` cannot hold are
//! dropped.
//!
//! **Paper.** J. H. Halton, On the Efficiency of Certain Quasi-Random Sequences of Points in
//! Evaluating Multi-Dimensional Integrals, Numer. Math. 2 (1960), doi 10.1007/BF01386213.
//!
//! ```
//! use workbook::{samplers::Method, seed::Seed};
//! let points = Method::parse("radical-inverse(base=3)")?.points(5, 1, Seed::new(1))?;
//! assert_eq!(points.coordinates(), [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0 / 9.0, 4.0 / 9.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::digits::is_prime;
use super::{Digital, Digits, Feature, Guarantee, Net, Preset, Radix, Refused, Sampler, Setting, Values, refused};
use crate::catalogue::{About, Entry, Paper};

/// The sampler `radical-inverse` in some base, and its digits.
#[derive(Clone, Copy)]
pub struct RadicalInverse {
    radix: Radix,
}

/// The sampler without settings.
pub const PLAIN: RadicalInverse = RadicalInverse { radix: Radix::new(BASE) };

/// The base that is not set.
const BASE: u32 = 2;

static SETTINGS: [Setting; 1] = [Setting {
    name: "base",
    meaning: "the base b in which the digits are reversed",
    least: 2,
    most: 65_536,
    is_prime: false,
    default: Preset::Number(BASE),
}];

static ABOUT: About = About {
    key: "radical-inverse",
    title: "Radical inverse",
    summary: "The digits of the index in a base that can be set, reversed behind the point; one dimension.",
    file: "samplers/radical_inverse.rs",
    source: include_str!("radical_inverse.rs"),
    papers: &[Paper {
        authors: "J. H. Halton",
        year: 1960,
        title: "On the Efficiency of Certain Quasi-Random Sequences of Points in Evaluating Multi-Dimensional Integrals",
        venue: "Numerische Mathematik 2, 84-90",
        doi: Some("10.1007/BF01386213"),
    }],
};

impl Entry for RadicalInverse {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for RadicalInverse {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Net, Guarantee::Deterministic]
    }

    fn settings(&self) -> &'static [Setting] {
        &SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { radix: Radix::new(values.at(0).unwrap_or(BASE)) }))
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, 1)
    }

    fn net(&self, _d: usize) -> Option<Net> {
        Some(Net { base: self.radix.base, t: 0 })
    }

    fn digits(&self) -> Digits {
        if self.radix.base == 2 { Digits::Binary } else { Digits::Mixed }
    }

    fn has_prime_bases(&self) -> bool {
        is_prime(u64::from(self.radix.base))
    }

    fn digital(&self, _n: usize, _d: usize) -> Option<Box<dyn Digital>> {
        Some(Box::new(*self))
    }
}

impl Digital for RadicalInverse {
    fn radix(&self, _axis: usize) -> Radix {
        self.radix
    }

    fn numerator(&self, index: u64, _axis: usize) -> u64 {
        self.radix.reversed(index)
    }

    fn is_radical(&self, _axis: usize) -> bool {
        true
    }
}
