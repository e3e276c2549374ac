//! The Fibonacci lattice.
//!
//! **What.** n = F_k points in the plane, on a lattice whose second axis steps by the Fibonacci
//! number before n.
//!
//! **Formula.** x_i = (i/n, (i F_(k-1) mod n) / n), n = F_k.
//!
//! **Guarantees.** One point in each slab of both axes; deterministic; the best rank-1 lattice in
//! the plane, with star discrepancy O(log(n) / n).
//!
//! **Cost.** One whole multiplication and division for each point.
//!
//! **Limits.** n must be a Fibonacci number; one or two dimensions.
//!
//! **Paper.** S. K. Zaremba, Good Lattice Points, Discrepancy, and Numerical Integration, Ann. Mat.
//! Pura Appl. 73 (1966), doi 10.1007/BF02415091.
//!
//! ```
//! use workbook::{samplers::{Sampler, fibonacci::Fibonacci}, seed::Seed};
//! let points = Fibonacci.points(5, 2, Seed::new(1))?;
//! assert_eq!(points.axis(1).collect::<Vec<_>>(), [0.0, 0.6, 0.2, 0.8, 0.4]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Feature, Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `fibonacci`.
pub struct Fibonacci;

static ABOUT: About = About {
    key: "fibonacci",
    title: "Fibonacci lattice",
    summary: "The plane lattice of n = F_k points with the step F_(k-1).",
    file: "samplers/fibonacci.rs",
    source: include_str!("fibonacci.rs"),
    papers: &[Paper {
        authors: "S. K. Zaremba",
        year: 1966,
        title: "Good Lattice Points, Discrepancy, and Numerical Integration",
        venue: "Annali di Matematica Pura ed Applicata 73, 293-317",
        doi: Some("10.1007/BF02415091"),
    }],
};

impl Entry for Fibonacci {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Fibonacci {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Latin, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, 2)?;
        let (_, below, above) = neighbours(n);
        if below == n {
            Ok(())
        } else {
            Err(Refused::Count { n, below: Some(below), above: Some(above), rule: "a Fibonacci number" })
        }
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        let steps = [1, neighbours(n).0];
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            for (x, step) in point.iter_mut().zip(steps) {
                *x = (i * step % n) as f64 / n as f64;
            }
        }
        refused::points(d, coordinates)
    }
}

/// Three Fibonacci numbers in a row, the second the last not above `n >= 1`.
fn neighbours(n: usize) -> (usize, usize, usize) {
    let (mut a, mut b, mut c) = (1, 1, 2);
    while c <= n {
        (a, b, c) = (b, c, b + c);
    }
    (a, b, c)
}
