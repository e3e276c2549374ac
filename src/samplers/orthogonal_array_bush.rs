//! Orthogonal arrays of strength 3, after Bush, as Latin hypercubes.
//!
//! **What.** n = p^3 runs over p symbols for p prime: the runs are the polynomials of degree at
//! most 2 over the integers modulo p, the columns their values. Any three columns show each triple
//! of symbols once. Symbols and thin slabs are shuffled as in the array of Bose.
//!
//! **Formula.** Run (a, b, c) has on axis j the symbol a + b j + c j^2 modulo p.
//!
//! **Guarantees.** One point in each cell of the p x p x p grid of every three axes, hence p in
//! each cell of every pair; one in each of the n slabs of every axis; unbiased.
//!
//! **Cost.** A few random numbers for each coordinate.
//!
//! **Limits.** n = p^3 for a prime p, d <= p.
//!
//! **Paper.** K. A. Bush, Orthogonal Arrays of Index Unity, Ann. Math. Statist. 23(3) (1952), doi
//! 10.1214/aoms/1177729387; the hypercube: B. Tang (1993), doi 10.1080/01621459.1993.10476423.
//!
//! ```
//! use workbook::samplers::orthogonal_array_bush::symbol;
//! assert_eq!(symbol(9 + 2 * 3 + 1, 2, 3), (1 + 2 * 2 + 1 * 4) % 3); // a = 1, b = 2, c = 1
//! ```

use super::digits::root;
use super::orthogonal_array::deal;
use super::{Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `orthogonal-array-bush`.
pub struct OrthogonalArrayBush;

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
        &[Guarantee::Strength { t: 3 }, Guarantee::Latin, Guarantee::Unbiased]
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, usize::MAX)?;
        refused::prime_power(n, 3, d, "p^3 for a prime p >= d")
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        let s = root(n as u64, 3) as usize;
        for axis in 0..d {
            let symbols: Vec<usize> = (0..n).map(|run| symbol(run, axis, s)).collect();
            let column = deal(&symbols, s, &mut seed.at(axis as u64).generator());
            for (point, x) in coordinates.chunks_exact_mut(d).zip(column) {
                point[axis] = x;
            }
        }
        refused::points(d, coordinates)
    }
}

/// The symbol of run `run = a s^2 + b s + c` on the axis `axis < s`, for a prime number s of
/// symbols.
pub fn symbol(run: usize, axis: usize, s: usize) -> usize {
    let (a, b, c) = (run / s / s, run / s % s, run % s);
    (a + (b + c * axis % s) * axis) % s
}
