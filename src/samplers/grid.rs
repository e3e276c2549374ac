//! The regular grid: the lower corner of each of n = k^d equal cells.
//!
//! **What.** Equal steps along every axis from 0; cell i has the coordinates of i written in base
//! k, the first axis fastest.
//!
//! **Formula.** x_j = c_j / k, c_j in 0..k.
//!
//! **Guarantees.** One point in each cell; deterministic.
//!
//! **Cost.** One division for each coordinate.
//!
//! **Limits.** n = k^d. Every axis sees only n^(1/d) different coordinates, and the set leans to
//! the origin: star discrepancy 1 - (1 - 1/k)^d. Aliasing is at its worst.
//!
//! **Source.** P. J. Davis and P. Rabinowitz, Methods of Numerical Integration (1984), doi
//! 10.1016/C2013-0-10566-1.
//!
//! ```
//! use workbook::{samplers::{Sampler, grid::Grid}, seed::Seed};
//! assert_eq!(Grid.points(4, 2, Seed::new(1))?.coordinates(), [0.0, 0.0, 0.5, 0.0, 0.0, 0.5, 0.5, 0.5]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Feature, Guarantee, Refused, Sampler, refused, regular};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `grid`.
pub struct Grid;

static ABOUT: About = About {
    key: "grid",
    title: "Regular grid",
    summary: "The corners of a regular grid of n = k^d cells.",
    file: "samplers/grid.rs",
    source: include_str!("grid.rs"),
    papers: &[Paper {
        authors: "P. J. Davis and P. Rabinowitz",
        year: 1984,
        title: "Methods of Numerical Integration",
        venue: "Academic Press, 2nd ed., section 5.6",
        doi: Some("10.1016/C2013-0-10566-1"),
    }],
};

impl Entry for Grid {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Grid {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Strata, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, d: usize) -> Option<f64> {
        // The corners lean to the origin by half a cell.
        (feature != Feature::Edge).then_some(-1.0 / d as f64)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::power(n, d)
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        regular::points(n, d, 0.0)
    }

    fn at(&self, n: usize, d: usize, _seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        Some(regular::at(n, d, 0.0))
    }
}
