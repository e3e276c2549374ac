//! Independent uniform points: plain Monte Carlo.
//!
//! **What.** Every coordinate of every point is drawn on its own, uniformly on [0, 1). It is what
//! every other sampler is measured against.
//!
//! **Guarantees.** The first m of n points are the m points; unbiased, with Var\[mean\] = Var\[f\]
//! / n for every square-integrable f, whatever its smoothness and whatever d.
//!
//! **Cost.** One xoshiro256++ word for each coordinate.
//!
//! **Limits.** Points clump and leave holes: the error falls like n^(-1/2) and no faster.
//!
//! **Paper.** N. Metropolis and S. Ulam, The Monte Carlo Method, J. Am. Stat. Assoc. 44 (1949), doi
//! 10.1080/01621459.1949.10483310.
//!
//! ```
//! use workbook::{samplers::{Sampler, independent::Independent}, seed::Seed};
//! let points = Independent.points(100, 3, Seed::new(7))?;
//! assert!(points.coordinates().iter().all(|x| (0.0..1.0).contains(x)));
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Feature, Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `independent`.
pub struct Independent;

static ABOUT: About = About {
    key: "independent",
    title: "Independent",
    summary: "Every coordinate uniform and independent of all others: plain Monte Carlo.",
    file: "samplers/independent.rs",
    source: include_str!("independent.rs"),
    papers: &[Paper {
        authors: "N. Metropolis and S. Ulam",
        year: 1949,
        title: "The Monte Carlo Method",
        venue: "Journal of the American Statistical Association 44(247), 335-341",
        doi: Some("10.1080/01621459.1949.10483310"),
    }],
};

impl Entry for Independent {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Independent {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Unbiased]
    }

    fn rate(&self, _feature: Feature, _d: usize) -> Option<f64> {
        Some(-0.5)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, usize::MAX)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        fill(&mut coordinates, &mut seed.generator());
        refused::points(d, coordinates)
    }
}

/// Fills `coordinates` with independent numbers, uniform on [0, 1).
pub fn fill(coordinates: &mut [f64], random: &mut Random) {
    for x in coordinates {
        *x = random.uniform();
    }
}
