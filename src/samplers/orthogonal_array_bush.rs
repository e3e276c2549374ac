//! Orthogonal arrays of strength 3 or another, after Bush, as Latin hypercubes.
//!
//! **What.** n = p^t runs over p symbols for p prime: the runs are the polynomials of degree below
//! t over the integers modulo p, the columns their values. Any t columns show each t-tuple of
//! symbols once. The strength t is 3 unless it is set. Symbols and thin slabs are shuffled as in
//! the array of Bose.
//!
//! **Formula.** Run (a, b, c) has on axis j the symbol a + b j + c j^2 modulo p.
//!
//! **Guarantees.** One point in each cell of the grid of p slabs an axis of every t axes, hence
//! p^(t-2) in each cell of every pair; one in each of the n slabs of every axis; unbiased.
//!
//! **Cost.** A few random numbers and t products for each coordinate.
//!
//! **Limits.** n = p^t for a prime p, d <= p.
//!
//! **Paper.** K. A. Bush, Orthogonal Arrays of Index Unity, Ann. Math. Statist. 23(3) (1952), doi
//! 10.1214/aoms/1177729387; the hypercube: B. Tang (1993), doi 10.1080/01621459.1993.10476423.
//!
//! ```
//! use workbook::samplers::orthogonal_array_bush::symbol;
//! let (a, b, c) = (1, 2, 1);
//! assert_eq!(symbol(9 * a + 3 * b + c, 2, 3, 3), (a + b * 2 + c * 4) % 3);
//! ```

use super::digits::root;
use super::orthogonal_array::hypercube;
use super::{Guarantee, Preset, Refused, Sampler, Setting, Values, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `orthogonal-array-bush`, of some strength.
pub struct OrthogonalArrayBush {
    strength: u32,
}

/// The sampler without settings.
pub const PLAIN: OrthogonalArrayBush = OrthogonalArrayBush { strength: STRENGTH };

/// The strength that is not set.
const STRENGTH: u32 = 3;

static SETTINGS: [Setting; 1] = [Setting {
    name: "strength",
    meaning: "how many axes t are stratified together, of n = p^t points",
    least: 2,
    most: 5,
    is_prime: false,
    default: Preset::Number(STRENGTH),
}];

static ABOUT: About = About {
    key: "orthogonal-array-bush",
    title: "Orthogonal array (Bush)",
    summary: "A Latin hypercube on an orthogonal array of strength 3: n = p^3, every three axes jittered p x p x p.",
    file: "samplers/orthogonal_array_bush.rs",
    source: include_str!("orthogonal_array_bush.rs"),
    papers: &[
        Paper {
            authors: "K. A. Bush",
            year: 1952,
            title: "Orthogonal Arrays of Index Unity",
            venue: "The Annals of Mathematical Statistics 23(3), 426-434",
            doi: Some("10.1214/aoms/1177729387"),
        },
        Paper {
            authors: "B. Tang",
            year: 1993,
            title: "Orthogonal Array-Based Latin Hypercubes",
            venue: "Journal of the American Statistical Association 88(424), 1392-1397",
            doi: Some("10.1080/01621459.1993.10476423"),
        },
    ],
};

impl Entry for OrthogonalArrayBush {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for OrthogonalArrayBush {
    fn guarantees(&self) -> &'static [Guarantee] {
        match self.strength {
            2 => &[Guarantee::Strength { t: 2 }, Guarantee::Latin, Guarantee::Unbiased],
            3 => &[Guarantee::Strength { t: 3 }, Guarantee::Latin, Guarantee::Unbiased],
            4 => &[Guarantee::Strength { t: 4 }, Guarantee::Latin, Guarantee::Unbiased],
            _ => &[Guarantee::Strength { t: 5 }, Guarantee::Latin, Guarantee::Unbiased],
        }
    }

    fn settings(&self) -> &'static [Setting] {
        &SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { strength: values.at(0).unwrap_or(STRENGTH) }))
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, usize::MAX)?;
        let rule = match self.strength {
            2 => "p^2 for a prime p >= d",
            3 => "p^3 for a prime p >= d",
            4 => "p^4 for a prime p >= d",
            _ => "p^5 for a prime p >= d",
        };
        refused::prime_power(n, self.strength, d, rule)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let s = root(n as u64, self.strength) as usize;
        hypercube(n, d, s, seed, |run, axis, s| symbol(run, axis, s, self.strength))
    }
}

/// The symbol of run `run` on the axis `axis < s`, for a prime number s of symbols and strength t:
/// the value at `axis` of the polynomial whose t coefficients are the digits of `run` in base s,
/// the constant one first.
pub fn symbol(run: usize, axis: usize, s: usize, t: u32) -> usize {
    let (mut rest, mut value) = (run, 0);
    // Horner's rule, from the coefficient of the highest power, which is the last digit.
    for _ in 0..t {
        value = (value * axis + rest % s) % s;
        rest /= s;
    }
    value
}
