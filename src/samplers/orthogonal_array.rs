//! Orthogonal arrays of strength 2, after Bose, as Latin hypercubes.
//!
//! **What.** n = p^2 runs over p symbols for p prime, such that any two columns show each pair of
//! symbols once. The symbols of each axis are shuffled; the p points of one symbol take the p thin
//! slabs inside it, one each, in random order.
//!
//! **Formula.** Run (a, b) has the symbols a, b, a + b, a + 2b, ..., a + (p - 1) b modulo p.
//!
//! **Guarantees.** One point in each cell of the p × p grid of every pair of axes; one in each of
//! the n slabs of every axis; unbiased. The variance loses all one- and two-dimensional parts of f.
//!
//! **Cost.** A few random numbers for each coordinate.
//!
//! **Limits.** n = p^2 for a prime p, d <= p + 1. No prefix has the property.
//!
//! **Papers.** R. C. Bose, On the Application of the Properties of Galois Fields to the Problem of
//! Construction of Hyper-Graeco-Latin Squares, Sankhya 3 (1938); B. Tang, Orthogonal Array-Based
//! Latin Hypercubes (1993), doi 10.1080/01621459.1993.10476423; in graphics: W. Jarosz et al.
//! (2019), doi 10.1111/cgf.13777.
//!
//! ```
//! use workbook::samplers::orthogonal_array::symbol;
//! let row: Vec<usize> = (0..4).map(|axis| symbol(5, axis, 3)).collect(); // a = 1, b = 2
//! assert_eq!(row, [1, 2, 0, 2]);
//! ```

use super::axes::by_axis;
use super::digits::{root, within};
use super::{Feature, Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `orthogonal-array`.
pub struct OrthogonalArray;

static ABOUT: About = About {
    key: "orthogonal-array",
    title: "Orthogonal array (Bose)",
    summary: "A Latin hypercube on an orthogonal array of strength 2: n = p^2, every pair of axes jittered p x p.",
    file: "samplers/orthogonal_array.rs",
    source: include_str!("orthogonal_array.rs"),
    papers: &[
        Paper {
            authors: "R. C. Bose",
            year: 1938,
            title: "On the Application of the Properties of Galois Fields to the Problem of Construction of Hyper-Graeco-Latin Squares",
            venue: "Sankhya 3, 323-338",
            doi: None,
        },
        Paper {
            authors: "B. Tang",
            year: 1993,
            title: "Orthogonal Array-Based Latin Hypercubes",
            venue: "Journal of the American Statistical Association 88(424), 1392-1397",
            doi: Some("10.1080/01621459.1993.10476423"),
        },
        Paper {
            authors: "W. Jarosz, A. Enayet, A. Kensler, C. Kilpatrick and P. Christensen",
            year: 2019,
            title: "Orthogonal Array Sampling for Monte Carlo Rendering",
            venue: "Computer Graphics Forum 38(4), 135-147",
            doi: Some("10.1111/cgf.13777"),
        },
    ],
};

impl Entry for OrthogonalArray {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for OrthogonalArray {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Strength { t: 2 }, Guarantee::Latin, Guarantee::Unbiased]
    }

    fn rate(&self, feature: Feature, d: usize) -> Option<f64> {
        if d != 2 {
            return None;
        }
        match feature {
            Feature::Additive => Some(-1.5),
            Feature::Edge => Some(-0.5 - 0.5 / d as f64),
            Feature::Smooth | Feature::Kink => Some(-0.5 - 1.0 / d as f64),
        }
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, usize::MAX)?;
        refused::prime_power(n, 2, d.saturating_sub(1), "p^2 for a prime p >= d - 1")
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        hypercube(n, d, root(n as u64, 2) as usize, seed, symbol)
    }
}

/// The symbol of run `run = a s + b` on the axis `axis <= s`, for a prime
/// number s of symbols.
pub fn symbol(run: usize, axis: usize, s: usize) -> usize {
    let (a, b) = (run / s, run % s);
    match axis {
        0 => a,
        1 => b,
        _ => (a + (axis - 1) * b) % s,
    }
}

/// The Latin hypercube on the array of n runs whose symbols, below `s`, are `symbol(run, axis, s)`.
///
/// On each axis the symbols, renamed at random, become slabs, and the runs of one symbol share its
/// thin slabs out among them.
pub(super) fn hypercube(
    n: usize,
    d: usize,
    s: usize,
    seed: Seed,
    symbol: impl Fn(usize, usize, usize) -> usize,
) -> Result<Points, Refused> {
    by_axis(n, d, seed, |axis, random, out| {
        let names = random.permutation(s);
        let mut thin: Vec<Vec<usize>> = (0..s).map(|_| random.permutation(n / s)).collect();
        for (run, x) in out.iter_mut().step_by(d).enumerate() {
            let symbol = symbol(run, axis, s);
            let slab = names[symbol] * (n / s) + thin[symbol].pop().unwrap_or(0);
            *x = within(slab as u64, n as u64, random.uniform());
        }
    })
}
