//! The (0,2)-sequence: van der Corput beside the Pascal matrix modulo 2.
//!
//! **What.** Two axes in base 2: the identity matrix and the upper triangle of binomials modulo 2.
//! They are the first two axes of Sobol's sequence and of Faure's in base 2.
//!
//! **Formula.** C\[r\]\[c\] = binom(c, r) mod 2; column c is column c - 1 XOR itself one digit
//! down.
//!
//! **Guarantees.** The first m of n points are the m points; every aligned block of 2^m points is a
//! (0, m, 2)-net in base 2. Deterministic.
//!
//! **Cost.** One XOR for each coordinate.
//!
//! **Limits.** One or two dimensions.
//!
//! **Papers.** I. M. Sobol' (1967), doi 10.1016/0041-5553(67)90144-9; in graphics: T. Kollig and A.
//! Keller, Efficient Multidimensional Sampling (2002), doi 10.1111/1467-8659.00706.
//!
//! ```
//! use workbook::samplers::zero_two::pascal;
//! let first: Vec<f64> = (0..4).map(|i| pascal(i) as f64 / 2f64.powi(53)).collect();
//! assert_eq!(first, [0.0, 0.5, 0.75, 0.25]);
//! ```

use super::van_der_corput::reversed_bits;
use super::{Digital, Digits, Feature, Guarantee, Net, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};

/// The sampler `zero-two`.
pub struct ZeroTwo;

static ABOUT: About = About {
    key: "zero-two",
    title: "(0,2)-sequence",
    summary: "Van der Corput beside the Pascal matrix modulo 2: the first two axes of Sobol', t = 0.",
    file: "samplers/zero_two.rs",
    source: include_str!("zero_two.rs"),
    papers: &[
        Paper {
            authors: "T. Kollig and A. Keller",
            year: 2002,
            title: "Efficient Multidimensional Sampling",
            venue: "Computer Graphics Forum 21(3), 557-563",
            doi: Some("10.1111/1467-8659.00706"),
        },
        Paper {
            authors: "I. M. Sobol'",
            year: 1967,
            title: "On the Distribution of Points in a Cube and the Approximate Evaluation of Integrals",
            venue: "USSR Computational Mathematics and Mathematical Physics 7(4), 86-112",
            doi: Some("10.1016/0041-5553(67)90144-9"),
        },
    ],
};

impl Entry for ZeroTwo {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for ZeroTwo {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Net, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, 2)
    }

    fn net(&self, _d: usize) -> Option<Net> {
        Some(Net { base: 2, t: 0 })
    }

    fn digits(&self) -> Digits {
        Digits::Binary
    }

    fn digital(&self, _n: usize, _d: usize) -> Option<Box<dyn Digital>> {
        Some(Box::new(ZeroTwo))
    }
}

impl Digital for ZeroTwo {
    fn numerator(&self, index: u64, axis: usize) -> u64 {
        if axis == 0 { reversed_bits(index) } else { pascal(index) }
    }
}

/// The 53 digits, as a whole number, of the second coordinate of point `index`.
pub fn pascal(index: u64) -> u64 {
    let (mut rest, mut column, mut digits) = (index, 1 << 52, 0);
    while rest > 0 {
        if rest & 1 == 1 {
            digits ^= column;
        }
        column ^= column >> 1;
        rest >>= 1;
    }
    digits
}
