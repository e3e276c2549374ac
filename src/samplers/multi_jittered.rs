//! Multi-jittered sampling: a jittered grid whose points are also n rooks.
//!
//! **What.** The square has columns × rows cells with one point each; every column of cells is cut
//! into as many thin slabs as it has cells, and its points take one slab each, in random order; the
//! same for the rows.
//!
//! **Formula.** With m columns and k rows, n = m k: x = (i + (p_i(j) + u) / k) / m and y = (j +
//! (q_j(i) + v) / m) / k, with random permutations p_i of 0..k for each column i and q_j of 0..m
//! for each row j.
//!
//! **Guarantees.** One point in each cell, and one in each of the n slabs of both axes; unbiased.
//!
//! **Cost.** Four random numbers for each point.
//!
//! **Limits.** Two dimensions (or one, where it is jittered sampling); n = columns × rows with rows
//! <= columns <= 2 rows, or any rows and columns that are set. Beware of whole-number division: i / m as integers crowds every x into the
//! first column.
//!
//! **Paper.** K. Chiu, P. Shirley and C. Wang, Multi-Jittered Sampling, Graphics Gems IV (1994),
//! 370-374, doi 10.1016/B978-0-12-336156-1.50045-8.
//!
//! ```
//! use workbook::{points::slab, samplers::{Sampler, multi_jittered}, seed::Seed};
//! let points = multi_jittered::PLAIN.points(16, 2, Seed::new(1))?;
//! let mut columns: Vec<usize> = points.axis(0).map(|x| slab(x, 16)).collect();
//! columns.sort_unstable();
//! assert_eq!(columns, (0..16).collect::<Vec<_>>());
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::axes::by_axis;
use super::digits::within;
use super::sides::{self, Sides};
use super::{Feature, Guarantee, Refused, Sampler, Setting, Values};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `multi-jittered`, on the grid that it is told.
pub struct MultiJittered {
    sides: Sides,
}

/// The sampler without settings.
pub const PLAIN: MultiJittered = MultiJittered { sides: Sides::FREE };

static ABOUT: About = About {
    key: "multi-jittered",
    title: "Multi-jittered",
    summary: "Jittered and Latin at once: one point in each cell and in each of the n slabs of both axes.",
    file: "samplers/multi_jittered.rs",
    source: include_str!("multi_jittered.rs"),
    papers: &[Paper {
        authors: "K. Chiu, P. Shirley and C. Wang",
        year: 1994,
        title: "Multi-Jittered Sampling",
        venue: "Graphics Gems IV, Academic Press, 370-374",
        doi: Some("10.1016/B978-0-12-336156-1.50045-8"),
    }],
};

impl Entry for MultiJittered {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for MultiJittered {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Strata, Guarantee::Latin, Guarantee::Unbiased]
    }

    fn settings(&self) -> &'static [Setting] {
        sides::SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { sides: Sides::told(values) }))
    }

    fn rate(&self, feature: Feature, d: usize) -> Option<f64> {
        match feature {
            Feature::Additive => Some(-1.5),
            Feature::Edge => Some(-0.5 - 0.5 / d as f64),
            Feature::Smooth | Feature::Kink => Some(-0.5 - 1.0 / d as f64),
        }
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        self.sides.check(n, d)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let cuts = self.strata(n, d);
        by_axis(n, d, seed, |axis, random, out| {
            let (own, across) = (cuts[axis], n / cuts[axis]);
            let mut slabs: Vec<usize> = Vec::with_capacity(across);
            for stratum in 0..own {
                slabs.clear();
                slabs.extend(0..across);
                random.shuffle(&mut slabs);
                for (k, &slab) in slabs.iter().enumerate() {
                    // The cell in column i and row j is number i + columns j,
                    // whichever axis is walked along.
                    let along_rows = k + across * stratum;
                    let cell = if axis == 0 { stratum + own * k } else { along_rows };
                    let slab = (stratum * across + slab) as u64;
                    out[cell * d] = within(slab, n as u64, random.uniform());
                }
            }
        })
    }

    fn strata(&self, n: usize, d: usize) -> Vec<usize> {
        self.sides.cuts(n, d)
    }
}
