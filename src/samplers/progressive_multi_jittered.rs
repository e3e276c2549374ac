//! Progressive multi-jittered (0,2) sequences.
//!
//! **What.** A random sequence of the plane of which every aligned block of 2^m points is
//! stratified in all dyadic boxes. Building it point by point with random choices and making an
//! Owen scrambling of the (0,2)-sequence give the same distribution; this is the second way, which
//! needs no search.
//!
//! **Formula.** Point i is the (0,2)-point of index i with both coordinates under nested uniform
//! scrambling.
//!
//! **Guarantees.** The first m of n points are the m points; every aligned block of 2^m points is a
//! (0, m, 2)-net in base 2; unbiased.
//!
//! **Cost.** 32 hashes for each coordinate.
//!
//! **Limits.** One or two dimensions. Candidates are not picked for distance, as the
//! "best-candidate" variants of the paper do.
//!
//! **Papers.** P. Christensen, A. Kensler and C. Kilpatrick, Progressive Multi-Jittered Sample
//! Sequences (2018), doi 10.1111/cgf.13472; as scrambled sequences: M. Pharr, Efficient Generation
//! of Points that Satisfy Two-Dimensional Elementary Intervals (2019); A. Helmer, P. Christensen
//! and A. Kensler, Stochastic Generation of (t, s) Sample Sequences (2021), doi
//! 10.2312/sr.20211287.
//!
//! ```
//! use workbook::{samplers::{Sampler, progressive_multi_jittered::ProgressiveMultiJittered}, seed::Seed};
//! let points = ProgressiveMultiJittered.points(4, 2, Seed::new(1))?;
//! assert_eq!(points.rows().filter(|x| x[0] < 0.5 && x[1] < 0.5).count(), 1);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::digits::GRAIN;
use super::van_der_corput::reversed_bits;
use super::zero_two::pascal;
use super::{Feature, Guarantee, Net, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::scrambles::owen::nested_flips;
use crate::seed::Seed;

/// The sampler `pmj02`.
pub struct ProgressiveMultiJittered;

static ABOUT: About = About {
    key: "pmj02",
    title: "Progressive multi-jittered (0,2)",
    summary: "A random (0,2)-sequence of the plane: every prefix of 2^m points is stratified in all elementary intervals.",
    file: "samplers/progressive_multi_jittered.rs",
    source: include_str!("progressive_multi_jittered.rs"),
    papers: &[
        Paper {
            authors: "P. Christensen, A. Kensler and C. Kilpatrick",
            year: 2018,
            title: "Progressive Multi-Jittered Sample Sequences",
            venue: "Computer Graphics Forum 37(4), 21-33",
            doi: Some("10.1111/cgf.13472"),
        },
        Paper {
            authors: "M. Pharr",
            year: 2019,
            title: "Efficient Generation of Points that Satisfy Two-Dimensional Elementary Intervals",
            venue: "Journal of Computer Graphics Techniques 8(1), 56-68",
            doi: None,
        },
        Paper {
            authors: "A. Helmer, P. Christensen and A. Kensler",
            year: 2021,
            title: "Stochastic Generation of (t, s) Sample Sequences",
            venue: "Eurographics Symposium on Rendering 2021",
            doi: Some("10.2312/sr.20211287"),
        },
    ],
};

impl Entry for ProgressiveMultiJittered {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for ProgressiveMultiJittered {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Net, Guarantee::Unbiased]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // As scrambled nets, at n = 2^m.
        match feature {
            Feature::Smooth | Feature::Additive => Some(-1.5),
            Feature::Edge => Some(-0.75),
            Feature::Kink => None,
        }
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, 2)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        let keys = keys(seed);
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            for (axis, x) in point.iter_mut().enumerate() {
                *x = coordinate(i as u64, axis, keys);
            }
        }
        refused::points(d, coordinates)
    }

    fn net(&self, _d: usize) -> Option<Net> {
        Some(Net { base: 2, t: 0 })
    }

    fn at(&self, _n: usize, _d: usize, seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        let keys = keys(seed);
        Some(Box::new(move |index, axis| coordinate(index, axis, keys)))
    }
}

/// The keys of the two axes' trees.
fn keys(seed: Seed) -> [u64; 2] {
    [0, 1].map(|axis| seed.at(axis).word())
}

/// Coordinate `axis < 2` of point `index`.
fn coordinate(index: u64, axis: usize, keys: [u64; 2]) -> f64 {
    let digits = if axis == 0 { reversed_bits(index) } else { pascal(index) };
    nested_flips(digits, keys[axis]) as f64 * GRAIN
}
