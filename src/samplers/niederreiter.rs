//! Niederreiter's sequence in base 2.
//!
//! **What.** Each axis has an irreducible polynomial over the field of two elements: x, x + 1, x^2 +
//! x + 1, ... in the order of their degrees. The rows of its generator matrix are the first digits
//! of the Laurent series of quotients by powers of that polynomial. All of it is computed; there is
//! no table. The first two axes are those of Sobol's sequence.
//!
//! **Formula.** For the polynomial p of degree e, row r = q e + u, u < e, has the entries a_0, a_1,
//! ... of x^u / p(x)^(q+1) = sum of a_c x^(-c-1); point i is the sum without carries (XOR) of the
//! columns at the set bits of i.
//!
//! **Guarantees.** The first m of n points are the m points; every aligned block of 2^m points is a
//! (t, m, d)-net in base 2 with t the sum of (e - 1) over the axes: 0 in one and two dimensions, 1
//! in three, 3 in four, 5 in five. Deterministic.
//!
//! **Cost.** One XOR for each coordinate of a batch, one for each set bit of the index at random;
//! some 5 microseconds an axis to make the matrix.
//!
//! **Limits.** At most 256 dimensions. Its t grows faster with d than that of the best
//! constructions (Niederreiter and Xing), and even a single axis has the quality e - 1, where
//! every axis of [Sobol's](super::sobol) has 0: for many dimensions that is the better choice.
//!
//! **Papers.** H. Niederreiter, Low-Discrepancy and Low-Dispersion Sequences, J. Number Theory 30
//! (1988), doi 10.1016/0022-314X(88)90025-X; P. Bratley, B. L. Fox and H. Niederreiter,
//! Implementation and Tests of Low-Discrepancy Sequences (1992), doi 10.1145/146382.146385.
//!
//! ```
//! use workbook::{samplers::{Sampler, niederreiter::Niederreiter}, seed::Seed};
//! let points = Niederreiter.points(5, 3, Seed::new(1))?;
//! // 1 / (x^2 + x + 1) = x^-2 + x^-3 + x^-5 + ..., and x times that: columns 01, 11, 1001.
//! assert_eq!(points.axis(2).collect::<Vec<_>>(), [0.0, 0.25, 0.75, 0.5, 0.5625]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Digital, Digits, Feature, Guarantee, Net, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};

/// The most dimensions.
pub const MOST_DIMENSIONS: usize = 256;

/// The binary digits of a coordinate.
const DIGITS: usize = 53;

/// The sampler `niederreiter`.
pub struct Niederreiter;

static ABOUT: About = About {
    key: "niederreiter",
    title: "Niederreiter",
    summary: "The digital sequence in base 2 of the irreducible polynomials in the order of their degrees.",
    file: "samplers/niederreiter.rs",
    source: include_str!("niederreiter.rs"),
    papers: &[
        Paper {
            authors: "H. Niederreiter",
            year: 1988,
            title: "Low-Discrepancy and Low-Dispersion Sequences",
            venue: "Journal of Number Theory 30(1), 51-70",
            doi: Some("10.1016/0022-314X(88)90025-X"),
        },
        Paper {
            authors: "P. Bratley, B. L. Fox and H. Niederreiter",
            year: 1992,
            title: "Implementation and Tests of Low-Discrepancy Sequences",
            venue: "ACM Transactions on Modeling and Computer Simulation 2(3), 195-213",
            doi: Some("10.1145/146382.146385"),
        },
    ],
};

impl Entry for Niederreiter {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Niederreiter {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Net, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, MOST_DIMENSIONS)
    }

    fn net(&self, d: usize) -> Option<Net> {
        let t = irreducible(d).iter().map(|polynomial| polynomial.ilog2() - 1).sum();
        Some(Net { base: 2, t })
    }

    fn digits(&self) -> Digits {
        Digits::Binary
    }

    fn digital(&self, _n: usize, d: usize) -> Option<Box<dyn Digital>> {
        Some(Box::new(Sequence { columns: irreducible(d).into_iter().map(columns).collect() }))
    }
}

/// The generator matrices of all axes, by columns, the first digit in bit 52.
struct Sequence {
    columns: Vec<[u64; DIGITS]>,
}

impl Digital for Sequence {
    fn numerator(&self, index: u64, axis: usize) -> u64 {
        let chosen = self.columns[axis].iter().enumerate().filter(|(bit, _)| index >> bit & 1 == 1);
        chosen.fold(0, |digits, (_, column)| digits ^ column)
    }
}

/// The first `count` irreducible polynomials over the field of two elements, x first; bit k is the
/// coefficient of x^k.
pub fn irreducible(count: usize) -> Vec<u64> {
    let mut found: Vec<u64> = Vec::new();
    let mut candidate = 2;
    while found.len() < count {
        let degree = u64::ilog2(candidate);
        let mut divisors = found.iter().take_while(|divisor| 2 * divisor.ilog2() <= degree);
        if divisors.all(|&divisor| remainder(candidate, divisor) != 0) {
            found.push(candidate);
        }
        candidate += 1;
    }
    found
}

/// What is left of the polynomial `dividend` modulo `divisor`.
fn remainder(mut dividend: u64, divisor: u64) -> u64 {
    let degree = divisor.ilog2();
    while let Some(excess) = dividend.checked_ilog2().and_then(|own| own.checked_sub(degree)) {
        dividend ^= divisor << excess;
    }
    dividend
}

/// The columns of the generator matrix of `polynomial`, of degree at most 11.
fn columns(polynomial: u64) -> [u64; DIGITS] {
    let degree = polynomial.ilog2() as usize;
    let mut columns = [0; DIGITS];
    let mut power = 1;
    for row in 0..DIGITS {
        let shift = row % degree;
        if shift == 0 {
            power = product(power, polynomial);
        }
        let series = series(shift, power);
        for (c, column) in columns.iter_mut().enumerate() {
            *column |= (series >> c & 1) << (DIGITS - 1 - row);
        }
    }
    columns
}

/// The product of two polynomials, of degree at most 63.
fn product(a: u64, b: u64) -> u64 {
    (0..u64::BITS).filter(|bit| b >> bit & 1 == 1).fold(0, |sum, bit| sum ^ a << bit)
}

/// The coefficients a_0 ... a_52 of x^shift / power = sum of a_c x^(-c-1), a_c in bit c.
fn series(shift: usize, power: u64) -> u64 {
    let degree = power.ilog2() as usize;
    let mut coefficients = 0;
    for c in 0..DIGITS {
        // The coefficient of x^(degree-1-c) on both sides of power times the series = x^shift.
        let mut sum = u64::from(c + shift + 1 == degree);
        for back in 1..=degree.min(c) {
            sum ^= power >> (degree - back) & coefficients >> (c - back) & 1;
        }
        coefficients |= sum << c;
    }
    coefficients
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samplers::sobol;

    /// Of degree 1, 2, 3, ... there are 2, 1, 2, 3, 6, 9, 18, 30 irreducible polynomials (Gauss'
    /// formula).
    #[test]
    fn irreducible_polynomials_are_as_many_as_gauss_counts() {
        let found = irreducible(256);
        let counts: Vec<usize> =
            (1..=8).map(|degree| found.iter().filter(|polynomial| polynomial.ilog2() == degree).count()).collect();
        assert_eq!(counts, [2, 1, 2, 3, 6, 9, 18, 30]);
        assert_eq!(found[..6], [0b10, 0b11, 0b111, 0b1011, 0b1101, 0b10011]);
        assert!(found.iter().all(|polynomial| polynomial.ilog2() <= 11));
    }

    #[test]
    fn the_first_two_axes_are_those_of_sobol() {
        for (axis, polynomial) in irreducible(2).into_iter().enumerate() {
            assert_eq!(&columns(polynomial), sobol::columns(axis));
        }
    }
}
