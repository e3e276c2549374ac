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

use super::digits::root;
use super::{Guarantee, Refused, Sampler, refused};
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

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::power(n, d)
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        let k = root(n as u64, d as u32);
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            let mut rest = i as u64;
            for x in point {
                *x = ((rest % k) as f64 + 0.5) / k as f64;
                rest /= k;
            }
        }
        refused::points(d, coordinates)
    }

    fn at(&self, n: usize, d: usize, _seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        let k = root(n as u64, d as u32);
        Some(Box::new(move |index, axis| {
            let rest = (0..axis).fold(index, |rest, _| rest / k);
            ((rest % k) as f64 + 0.5) / k as f64
        }))
    }
}
