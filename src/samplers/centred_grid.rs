//! The centred grid: the centre of each of n = k^d equal cells, the product of midpoint rules.
//!
//! **What.** As the regular grid, half a cell further in.
//!
//! **Formula.** x_j = (c_j + 1/2) / k, c_j in 0..k.
//!
//! **Guarantees.** One point in each cell; deterministic. The error falls like n^(-2/d) for smooth
//! f. In two dimensions the star discrepancy is 1/k - 1/(4 k^2).
//!
//! **Cost.** One division for each coordinate.
//!
//! **Limits.** n = k^d. Every axis sees only n^(1/d) different coordinates; edges alias.
//!
//! **Source.** P. J. Davis and P. Rabinowitz, Methods of Numerical Integration (1984), doi
//! 10.1016/C2013-0-10566-1.
//!
//! ```
//! use workbook::{samplers::{Sampler, centred_grid::CentredGrid}, seed::Seed};
//! assert_eq!(CentredGrid.points(2, 1, Seed::new(1))?.coordinates(), [0.25, 0.75]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Feature, Guarantee, Refused, Sampler, refused, regular};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `centred-grid`.
pub struct CentredGrid;

static ABOUT: About = About {
    key: "centred-grid",
    title: "Centred grid",
    summary: "The centres of a regular grid of n = k^d cells.",
    file: "samplers/centred_grid.rs",
    source: include_str!("centred_grid.rs"),
    papers: &[Paper {
        authors: "P. J. Davis and P. Rabinowitz",
        year: 1984,
        title: "Methods of Numerical Integration",
        venue: "Academic Press, 2nd ed., section 5.6",
        doi: Some("10.1016/C2013-0-10566-1"),
    }],
};

impl Entry for CentredGrid {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for CentredGrid {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Strata, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, d: usize) -> Option<f64> {
        // The midpoint rule.
        (feature == Feature::Smooth).then_some(-2.0 / d as f64)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::power(n, d)
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        regular::points(n, d, 0.5)
    }

    fn at(&self, n: usize, d: usize, _seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        Some(regular::at(n, d, 0.5))
    }
}
