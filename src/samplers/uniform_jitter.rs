//! Uniform jitter: one random offset for all cells of a grid.
//!
//! **What.** The square is cut into columns × rows equal cells, as they are set or as nearly square
//! as n allows, and all of them get the same random place inside; in more than two dimensions the
//! grid has n = k^d cells.
//!
//! **Formula.** x_j = (c_j + u_j) / k_j with one u_j for each axis.
//!
//! **Guarantees.** One point in each cell; unbiased.
//!
//! **Cost.** d random numbers in all.
//!
//! **Limits.** The points move together, so that errors do not cancel as with independent jitter:
//! along an edge that lies on an axis the variance is that of a single row.
//!
//! **Papers.** R. Ramamoorthi, J. Anderson, M. Meyer and D. Nowrouzezahrai, A Theory of Monte Carlo
//! Visibility Sampling, ACM Trans. Graph. 31(5) (2012), doi 10.1145/2231816.2231819; the offset is
//! that of Cranley and Patterson (1976), doi 10.1137/0713071.
//!
//! ```
//! use workbook::{samplers::{Sampler, uniform_jitter}, seed::Seed};
//! let points = uniform_jitter::PLAIN.points(6, 2, Seed::new(1))?; // 3 columns, 2 rows
//! let row = points.coordinates();
//! assert!((row[2] - row[0] - 1.0 / 3.0).abs() < 1e-15 && row[3] == row[1]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::digits::{self, within};
use super::sides::{self, Sides};
use super::{Feature, Guarantee, Refused, Sampler, Setting, Values, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `uniform-jitter`, on the grid that it is told.
pub struct UniformJitter {
    sides: Sides,
}

/// The sampler without settings.
pub const PLAIN: UniformJitter = UniformJitter { sides: Sides::FREE };

static ABOUT: About = About {
    key: "uniform-jitter",
    title: "Uniform jitter",
    summary: "A grid of columns x rows cells with one random offset, the same in every cell.",
    file: "samplers/uniform_jitter.rs",
    source: include_str!("uniform_jitter.rs"),
    papers: &[Paper {
        authors: "R. Ramamoorthi, J. Anderson, M. Meyer and D. Nowrouzezahrai",
        year: 2012,
        title: "A Theory of Monte Carlo Visibility Sampling",
        venue: "ACM Transactions on Graphics 31(5), 121",
        doi: Some("10.1145/2231816.2231819"),
    }],
};

impl Entry for UniformJitter {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for UniformJitter {
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
        // All cells lean to the same side by the same part of a cell.
        (feature != Feature::Edge).then_some(-1.0 / d as f64)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        if d > 2 && self.sides.is_free() { refused::power(n, d) } else { self.sides.check(n, d) }
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        let cuts = self.strata(n, d);
        let mut random = seed.generator();
        let offsets: Vec<f64> = cuts.iter().map(|_| random.uniform()).collect();
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            let mut rest = i;
            for ((x, &k), &offset) in point.iter_mut().zip(&cuts).zip(&offsets) {
                *x = within((rest % k) as u64, k as u64, offset);
                rest /= k;
            }
        }
        refused::points(d, coordinates)
    }

    fn strata(&self, n: usize, d: usize) -> Vec<usize> {
        if d > 2 { vec![digits::root(n as u64, d as u32) as usize; d] } else { self.sides.cuts(n, d) }
    }
}
