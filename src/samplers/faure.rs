//! The Faure sequence: powers of the Pascal matrix in a prime base.
//!
//! **What.** All d axes share a prime p >= d as base, the smallest unless it is set; axis j multiplies the digits of
//! the index by the j-th power of Pascal's triangle modulo p.
//!
//! **Formula.** The matrix of axis j has the entries C\[r\]\[c\] = binom(c, r) j^(c-r) mod p for r
//! <= c; with index digits a_c, digit r of the coordinate is the sum of C\[r\]\[c\] a_c mod p.
//!
//! **Guarantees.** The first m of n points are the m points; every aligned block of p^m points is a
//! (0, m, d)-net in base p: t = 0 in every dimension, which no binary sequence has beyond two.
//! Deterministic.
//!
//! **Cost.** The square of the number of digits for each coordinate at random; one vector addition
//! in a batch.
//!
//! **Limits.** Good only at n = p^m, which is coarse for large d, and early points lie near the
//! diagonal; at most 256 dimensions.
//!
//! **Paper.** H. Faure, Discrépance de suites associées à un système de numération (en dimension
//! s), Acta Arith. 41 (1982), doi 10.4064/aa-41-4-337-351.
//!
//! ```
//! use workbook::{samplers::{Sampler, faure}, seed::Seed};
//! let points = faure::PLAIN.points(4, 3, Seed::new(1))?;
//! let third: Vec<f64> = points.axis(2).map(|x| x * 9.0).collect();
//! assert_eq!(third, [0.0, 3.0, 6.0, 7.0]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{
    Digital, Digits, Feature, Guarantee, Net, Preset, Radix, Refused, Sampler, Setting, Values, digits, refused,
};
use crate::catalogue::{About, Entry, Paper};

/// The most dimensions.
const MOST_DIMENSIONS: usize = 256;

/// The primes up to 257.
const PRIMES: [u32; 55] = digits::primes();

/// The sampler `faure`, in the base that it is told.
pub struct Faure {
    base: Option<u32>,
}

/// The sampler without settings.
pub const PLAIN: Faure = Faure { base: None };

static SETTINGS: [Setting; 1] = [Setting {
    name: "base",
    meaning: "the prime base p of all axes, at least d",
    least: 2,
    most: 257,
    is_prime: true,
    default: Preset::Rule("the smallest prime not below d"),
}];

static ABOUT: About = About {
    key: "faure",
    title: "Faure",
    summary: "The digital sequence of powers of the Pascal matrix in the smallest prime base not below d.",
    file: "samplers/faure.rs",
    source: include_str!("faure.rs"),
    papers: &[Paper {
        authors: "H. Faure",
        year: 1982,
        title: "Discrépance de suites associées à un système de numération (en dimension s)",
        venue: "Acta Arithmetica 41(4), 337-351",
        doi: Some("10.4064/aa-41-4-337-351"),
    }],
};

impl Entry for Faure {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Faure {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Net, Guarantee::Deterministic]
    }

    fn settings(&self) -> &'static [Setting] {
        &SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { base: values.at(0) }))
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, self.base.map_or(MOST_DIMENSIONS, |base| MOST_DIMENSIONS.min(base as usize)))
    }

    fn net(&self, d: usize) -> Option<Net> {
        Some(Net { base: self.base(d), t: 0 })
    }

    fn digits(&self) -> Digits {
        if self.base == Some(2) { Digits::Binary } else { Digits::Mixed }
    }

    fn digital(&self, _n: usize, d: usize) -> Option<Box<dyn Digital>> {
        let radix = Radix::new(self.base(d));
        Some(Box::new(Sequence { radix, matrices: (0..d as u64).map(|axis| matrix(radix, axis)).collect() }))
    }
}

impl Faure {
    fn base(&self, d: usize) -> u32 {
        self.base.unwrap_or_else(|| base(d))
    }
}

/// The smallest prime not below `d <= 256`.
pub fn base(d: usize) -> u32 {
    PRIMES.into_iter().find(|&prime| prime as usize >= d).unwrap_or(257)
}

/// The columns of the matrix of axis `axis`: entry `[c][r]` is binom(c, r) axis^(c-r) mod p, for r
/// <= c.
fn matrix(radix: Radix, axis: u64) -> Vec<Vec<u64>> {
    let p = u64::from(radix.base);
    let mut columns: Vec<Vec<u64>> = vec![vec![1]];
    for c in 1..radix.digits as usize {
        // Pascal's rule with weights: the column of (axis + z)^c is that of (axis + z)^(c-1) times
        // axis, plus itself one row down.
        let before = &columns[c - 1];
        let entry = |r: usize| {
            let stay = before.get(r).map_or(0, |entry| entry * axis);
            let down = if r > 0 { before[r - 1] } else { 0 };
            (stay + down) % p
        };
        let column = (0..=c).map(entry).collect();
        columns.push(column);
    }
    columns
}

/// The matrices of all axes.
struct Sequence {
    radix: Radix,
    matrices: Vec<Vec<Vec<u64>>>,
}

impl Digital for Sequence {
    fn radix(&self, _axis: usize) -> Radix {
        self.radix
    }

    fn numerator(&self, index: u64, axis: usize) -> u64 {
        let p = u64::from(self.radix.base);
        let mut sums = [0; 53];
        let (mut rest, mut used) = (index, 0);
        for column in &self.matrices[axis] {
            if rest == 0 {
                break;
            }
            for (sum, entry) in sums.iter_mut().zip(column) {
                *sum += entry * (rest % p);
            }
            rest /= p;
            used += 1;
        }
        let numerator = sums[..used].iter().fold(0, |numerator, sum| numerator * p + sum % p);
        // The digits behind are 0: an upper triangular matrix makes no more digits than the index
        // has.
        (used..self.radix.digits as usize).fold(numerator, |numerator, _| numerator * p)
    }
}
