//! Poisson disks by Bridson's algorithm, on the torus.
//!
//! **What.** From a first random point the set grows: around a point of the front up to 30
//! candidates (`tries`) are thrown in the shell between one and two radii, and the first that is
//! far enough from all others joins the front; a point with no success leaves it.
//!
//! **Formula.** Each candidate lies uniformly in the shell r <= distance < 2r.
//!
//! **Guarantees.** No two points are nearer on the torus than 0.60 of the largest possible
//! distance, except with fewer than 30 tries, where the front may die early; unbiased.
//!
//! **Cost.** Linear in n for each run; the radius is corrected over up to nine runs until one ends
//! with exactly n points, and then shrunk in up to 64 steps, each linear in n as well.
//!
//! **Limits.** One to four dimensions. It is not the distribution of dart throwing: points crowd
//! just beyond the radius of their parent. The count of a run cannot be foreseen. If no run hits n,
//! the nearest with fewer points grows on from all of them while the radius shrinks, by less than a
//! per cent or two, until there are n: no point is ever removed, and at the end every point has
//! failed `tries` times at the final radius.
//!
//! **Paper.** R. Bridson, Fast Poisson Disk Sampling in Arbitrary Dimensions, SIGGRAPH sketches
//! 2007, doi 10.1145/1278780.1278807.
//!
//! ```
//! use workbook::{samplers::{Sampler, bridson}, seed::Seed};
//! assert_eq!(bridson::PLAIN.points(100, 2, Seed::new(1))?.len(), 100);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::poisson::{self, Buckets, Place, exactly, in_dimensions, uniform};
use super::{Guarantee, Preset, Refused, Sampler, Setting, Values, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `bridson`, with so many tries.
pub struct Bridson {
    tries: u32,
}

/// The sampler without settings.
pub const PLAIN: Bridson = Bridson { tries: TRIES };

/// Candidates around a point before it leaves the front, where they are not set.
const TRIES: u32 = 30;

static SETTINGS: [Setting; 1] = [Setting {
    name: "tries",
    meaning: "how many candidates a point throws around it before it leaves the front",
    least: 10,
    most: 1000,
    is_prime: false,
    default: Preset::Number(TRIES),
}];

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
        if self.tries < TRIES {
            &[Guarantee::Unbiased]
        } else {
            &[Guarantee::Separated { percent: 60 }, Guarantee::Unbiased]
        }
    }

    fn settings(&self) -> &'static [Setting] {
        &SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { tries: values.at(0).unwrap_or(TRIES) }))
    }

    fn searches(&self) -> bool {
        true
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        poisson::check(n, d)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        refused::points(d, in_dimensions!(d, set(n, self.tries, seed))?)
    }
}

/// Exactly `n` points.
fn set<const D: usize>(n: usize, tries: u32, seed: Seed) -> Result<Vec<Place<D>>, Refused> {
    exactly(n, seed, 0.72, |start, radius, random| grow_on(start, radius, tries, random))
}

/// A set of the plane that has grown until its front is empty.
pub fn grow(radius: f64, random: &mut Random) -> Vec<Place<2>> {
    grow_on(&[], radius, TRIES, random)
}

/// A set that has grown from the points of `start`, or a random one, until its front is empty.
fn grow_on<const D: usize>(start: &[Place<D>], radius: f64, tries: u32, random: &mut Random) -> Vec<Place<D>> {
    let mut buckets = Buckets::holding((1.0 / radius) as usize, start);
    if start.is_empty() {
        buckets.add(uniform(random));
    }
    let mut front: Vec<usize> = (0..buckets.places().len()).collect();
    while !front.is_empty() {
        let chosen = random.below(front.len() as u64) as usize;
        let parent = buckets.places()[front[chosen]];
        let candidates = (0..tries).map(|_| beside(parent, radius, random));
        if let Some(child) = { candidates }.find(|&child| !buckets.any_within(child, radius)) {
            front.push(buckets.places().len());
            buckets.add(child);
        } else {
            front.swap_remove(chosen);
        }
    }
    buckets.into_places()
}

/// A uniform point of the shell from one to two radii around `centre`, on the torus.
fn beside<const D: usize>(centre: Place<D>, radius: f64, random: &mut Random) -> Place<D> {
    loop {
        let offset: Place<D> = uniform(random).map(|u| 4.0 * u - 2.0);
        let length = offset.iter().fold(0.0, |sum, x| sum + x * x);
        if (1.0..4.0).contains(&length) {
            return std::array::from_fn(|axis| wrap(centre[axis] + radius * offset[axis]));
        }
    }
}

/// `x` modulo 1, in [0, 1).
fn wrap(x: f64) -> f64 {
    let turned = x - x.floor();
    // A tiny negative number rounds up to 1.
    if turned < 1.0 { turned } else { 0.0 }
}
