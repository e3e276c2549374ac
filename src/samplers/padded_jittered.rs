//! Padding: stratified in each pair of axes, shuffled between the pairs.
//!
//! **What.** The axes are taken two by two. Each pair gets a jittered set of n = k^2 points in an
//! order of its own, shuffled at random; an odd last axis gets one point in each of n slabs.
//!
//! **Formula.** Pair p of point i is the jittered point number s_p(i), with s_p random permutations
//! of 0..n.
//!
//! **Guarantees.** Unbiased; every pair (2p, 2p + 1) has one point in each cell of the k × k grid.
//!
//! **Cost.** A random number for each coordinate and one for each pair.
//!
//! **Limits.** n = k^2. Between pairs there is no stratification at all: what depends on axes of
//! two pairs keeps the rate of independent points. It is how renderers sample lens, time and light.
//!
//! **Paper.** R. L. Cook, T. Porter and L. Carpenter, Distributed Ray Tracing, SIGGRAPH 1984, doi
//! 10.1145/800031.808590.
//!
//! ```
//! use workbook::{samplers::{Sampler, padded_jittered::PaddedJittered}, seed::Seed};
//! let points = PaddedJittered.points(4, 4, Seed::new(1))?;
//! assert_eq!(points.rows().filter(|x| x[2] < 0.5 && x[3] < 0.5).count(), 1);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::digits::root;
use super::jittered::jitter;
use super::{Feature, Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `padded-jittered`.
pub struct PaddedJittered;

static ABOUT: About = About {
    key: "padded-jittered",
    title: "Padded jittered",
    summary: "Jittered squares for each pair of axes, each pair in a random order of its own.",
    file: "samplers/padded_jittered.rs",
    source: include_str!("padded_jittered.rs"),
    papers: &[Paper {
        authors: "R. L. Cook, T. Porter and L. Carpenter",
        year: 1984,
        title: "Distributed Ray Tracing",
        venue: "SIGGRAPH 1984, 137-145",
        doi: Some("10.1145/800031.808590"),
    }],
};

impl Entry for PaddedJittered {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for PaddedJittered {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Pairs, Guarantee::Unbiased]
    }

    fn rate(&self, feature: Feature, d: usize) -> Option<f64> {
        if d > 2 {
            return None;
        }
        // What is left varies within cells of side n^(-1/d): all of them, or those that the edge crosses.
        Some(-0.5 - if feature == Feature::Edge { 0.5 } else { 1.0 } / d as f64)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, usize::MAX)?;
        refused::power(n, d.min(2))
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        for first in (0..d).step_by(2) {
            let width = (d - first).min(2);
            let mut random = seed.at(first as u64).generator();
            let cuts = vec![root(n as u64, width as u32) as usize; width];
            let order = random.permutation(n);
            for (point, cell) in coordinates.chunks_exact_mut(d).zip(order) {
                jitter(cell, &cuts, &mut point[first..first + width], &mut random);
            }
        }
        refused::points(d, coordinates)
    }
}
