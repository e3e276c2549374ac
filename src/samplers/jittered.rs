//! Jittered sampling: one random point in each cell of a regular grid.
//!
//! **What.** The unit cube is cut into n = k^d equal cells, the square also into the rows and
//! columns that are set, and each cell gets one uniform point of its own. Cells are counted with
//! the first axis fastest.
//!
//! **Formula.** x_j = (c_j + u_j) / k_j, with c_j in 0..k_j and u_j uniform on [0, 1).
//!
//! **Guarantees.** One point in each cell; unbiased. The variance is never above that of
//! independent points (no more than the variance within the cells is left), and falls like
//! n^(-1-2/d) for smooth f, n^(-1-1/d) where f has an edge.
//!
//! **Cost.** One random number for each coordinate.
//!
//! **Limits.** n must be the d-th power of a whole number, any n for d = 1, unless rows or columns
//! are set, in two dimensions; n grows too fast with d
//! for more than a few dimensions.
//!
//! **Papers.** R. L. Cook, Stochastic Sampling in Computer Graphics, ACM Trans. Graph. 5(1) (1986),
//! doi 10.1145/7529.8927; the variance: S. Haber, Math. Comp. 20 (1966), doi
//! 10.1090/S0025-5718-1966-0210285-0.
//!
//! ```
//! use workbook::{samplers::{Sampler, jittered}, seed::Seed};
//! let points = jittered::PLAIN.points(4, 2, Seed::new(7))?;
//! let upper_right = points.rows().filter(|x| x[0] >= 0.5 && x[1] >= 0.5).count();
//! assert_eq!(upper_right, 1);
//! assert!(jittered::PLAIN.points(5, 2, Seed::new(7)).is_err());
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::digits::{root, within};
use super::sides::{self, Sides};
use super::{Feature, Guarantee, Refused, Sampler, Setting, Values, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `jittered`, on the grid that it is told.
pub struct Jittered {
    sides: Sides,
}

/// The sampler without settings.
pub const PLAIN: Jittered = Jittered { sides: Sides::FREE };

static ABOUT: About = About {
    key: "jittered",
    title: "Jittered",
    summary: "One uniform point in each cell of a regular grid of n = k^d cells.",
    file: "samplers/jittered.rs",
    source: include_str!("jittered.rs"),
    papers: &[
        Paper {
            authors: "R. L. Cook",
            year: 1986,
            title: "Stochastic Sampling in Computer Graphics",
            venue: "ACM Transactions on Graphics 5(1), 51-72",
            doi: Some("10.1145/7529.8927"),
        },
        Paper {
            authors: "S. Haber",
            year: 1966,
            title: "A Modified Monte-Carlo Quadrature",
            venue: "Mathematics of Computation 20(95), 361-368",
            doi: Some("10.1090/S0025-5718-1966-0210285-0"),
        },
    ],
};

impl Entry for Jittered {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Jittered {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Strata, Guarantee::Unbiased]
    }

    fn settings(&self) -> &'static [Setting] {
        sides::SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { sides: Sides::told(values) }))
    }

    fn rate(&self, feature: Feature, d: usize) -> Option<f64> {
        // What is left varies within cells of side n^(-1/d): all of them, or those that the edge crosses.
        Some(-0.5 - if feature == Feature::Edge { 0.5 } else { 1.0 } / d as f64)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        if self.sides.is_free() { refused::power(n, d) } else { self.sides.check(n, d) }
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        let cuts = self.strata(n, d);
        let mut random = seed.generator();
        // The cell on each axis, counted on from point to point: divisions would cost more than all else.
        let mut cell = vec![0; d];
        for point in coordinates.chunks_exact_mut(d) {
            for ((x, &own), &cut) in point.iter_mut().zip(&cell).zip(&cuts) {
                *x = within(own as u64, cut as u64, random.uniform());
            }
            for (own, &cut) in cell.iter_mut().zip(&cuts) {
                *own += 1;
                if *own < cut {
                    break;
                }
                *own = 0;
            }
        }
        refused::points(d, coordinates)
    }

    fn strata(&self, n: usize, d: usize) -> Vec<usize> {
        if self.sides.is_free() { vec![root(n as u64, d as u32) as usize; d] } else { self.sides.cuts(n, d) }
    }
}

/// A uniform point in cell `cell` of the grid of `cuts[j]` cells on axis j,
/// the first axis fastest.
pub fn jitter(
    cell: usize,
    cuts: &[usize], // of each axis
    point: &mut [f64],
    random: &mut Random,
) {
    let mut rest = cell;
    for (x, &cut) in point.iter_mut().zip(cuts) {
        *x = within((rest % cut) as u64, cut as u64, random.uniform());
        rest /= cut;
    }
}
