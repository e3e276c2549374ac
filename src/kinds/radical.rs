//! Radical inverses by hand: the digits of an index, reflected at the point, and the exact fraction that they make.
//!
//! Only whole numbers are used, apart from the samplers, so that a comparison with theirs proves something.

use serde::{Deserialize, Serialize};

use crate::samplers::{halton, van_der_corput};

/// One index and its radical inverse.
#[derive(Debug, Serialize, Deserialize)]
pub struct Row {
    /// The index.
    pub index: u64,
    /// Its digits, the highest first; `0` of the index 0.
    pub digits: String,
    /// A point, and the digits in reverse.
    pub reflected: String,
    /// The exact radical inverse, in lowest terms.
    pub numerator: u64,
    /// Its denominator.
    pub denominator: u64,
    /// The radical inverse as the sampler computes it.
    pub phi: f64,
}

impl Row {
    /// The row of `index` in `base`, from 2 to 36; the power of the base above the index must be below 2^64.
    pub fn new(index: u64, base: u64) -> Self {
        let mut digits = Vec::new();
        let (mut rest, mut numerator, mut denominator) = (index, 0, 1);
        while rest > 0 {
            let digit = rest % base;
            digits.push(char::from_digit(digit as u32, base as u32).unwrap_or('?'));
            numerator = numerator * base + digit;
            denominator *= base;
            rest /= base;
        }
        if digits.is_empty() {
            digits.push('0');
        }
        let reflected = format!(".{}", digits.iter().collect::<String>());
        let digits = digits.iter().rev().collect();
        let common = common_divisor(numerator, denominator);
        let (numerator, denominator) = (numerator / common, denominator / common);
        Self { index, digits, reflected, numerator, denominator, phi: phi(index, base) }
    }

    /// Whether the sampler's number is the one nearest to the exact fraction.
    pub fn agrees(&self) -> bool {
        self.phi == self.numerator as f64 / self.denominator as f64
    }

    /// The exact radical inverse as LaTeX or text: `3/8`.
    pub fn fraction(&self) -> String {
        if self.numerator == 0 { "0".to_owned() } else { format!("{}/{}", self.numerator, self.denominator) }
    }
}

/// The name of the sampler whose first axis the radical inverses in `base` are.
pub fn sampler(base: usize) -> &'static str {
    if base == 2 { "van-der-corput" } else { "halton" }
}

/// The radical inverse as the samplers compute it.
fn phi(index: u64, base: u64) -> f64 {
    if base == 2 { van_der_corput::bit_reversal(index) } else { halton::radical_inverse(index, base as u32) }
}

/// The greatest common divisor (Euclid); at least 1.
fn common_divisor(a: u64, b: u64) -> u64 {
    let (mut a, mut b) = (a, b);
    while b > 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}
