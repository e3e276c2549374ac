//! Poisson disks by Bridson's algorithm, on the torus.
//!
//! **What.** From a first random point the set grows: around a point of the front up to 30
//! candidates are thrown in the ring between one and two radii, and the first that is far enough
//! from all others joins the front; a point with no success leaves it.
//!
//! **Formula.** Each candidate lies uniformly in the ring r <= distance < 2r.
//!
//! **Guarantees.** No two points are nearer on the torus than 0.65 of the largest possible
//! distance; unbiased.
//!
//! **Cost.** Linear in n for each run; the radius is corrected over several runs until a run ends
//! with exactly n points.
//!
//! **Limits.** Two dimensions. It is not the distribution of dart throwing: points crowd just
//! beyond the radius of their parent. The count of a run cannot be foreseen; if eight runs miss n,
//! the nearest larger one loses its surplus at random.
//!
//! **Paper.** R. Bridson, Fast Poisson Disk Sampling in Arbitrary Dimensions, SIGGRAPH sketches
//! 2007, doi 10.1145/1278780.1278807.
//!
//! ```
//! use workbook::{samplers::{Sampler, bridson::Bridson}, seed::Seed};
//! assert_eq!(Bridson.points(100, 2, Seed::new(1))?.len(), 100);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::poisson::{Buckets, Place, exactly, uniform};
use super::{Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `bridson`.
pub struct Bridson;

static ABOUT: About = About {
    key: "bridson",
    title: "Bridson",
    summary: "Poisson disks grown from a random point: candidates in the ring around each, until no more fit.",
    file: "samplers/bridson.rs",
    source: include_str!("bridson.rs"),
    papers: &[Paper {
        authors: "R. Bridson",
        year: 2007,
        title: "Fast Poisson Disk Sampling in Arbitrary Dimensions",
        venue: "ACM SIGGRAPH 2007 Sketches, 22",
        doi: Some("10.1145/1278780.1278807"),
    }],
};

impl Entry for Bridson {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Bridson {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Separated { percent: 65 }, Guarantee::Unbiased]
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::plane(n, d)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let places = exactly(n, seed, 0.72, grow);
        refused::points(d, places.into_flattened())
    }
}

/// Candidates around a point before it leaves the front.
const CANDIDATES: usize = 30;

/// A set that has grown until its front is empty.
pub fn grow(radius: f64, random: &mut Random) -> Vec<Place> {
    let mut buckets = Buckets::new((1.0 / radius) as usize);
    buckets.add(uniform(random));
    let mut front = vec![0];
    while !front.is_empty() {
        let chosen = random.below(front.len() as u64) as usize;
        let parent = buckets.places()[front[chosen]];
        let candidates = (0..CANDIDATES).map(|_| beside(parent, radius, random));
        if let Some(child) = { candidates }.find(|&child| !buckets.any_within(child, radius)) {
            front.push(buckets.places().len());
            buckets.add(child);
        } else {
            front.swap_remove(chosen);
        }
    }
    buckets.places().to_vec()
}

/// A uniform point of the ring from one to two radii around `centre`, on the torus.
fn beside(centre: Place, radius: f64, random: &mut Random) -> Place {
    loop {
        let offset = uniform(random).map(|u| 4.0 * u - 2.0);
        let length = offset[0] * offset[0] + offset[1] * offset[1];
        if (1.0..4.0).contains(&length) {
            return [0, 1].map(|axis| wrap(centre[axis] + radius * offset[axis]));
        }
    }
}

/// `x` modulo 1, in [0, 1).
fn wrap(x: f64) -> f64 {
    let turned = x - x.floor();
    // A tiny negative number rounds up to 1.
    if turned < 1.0 { turned } else { 0.0 }
}
