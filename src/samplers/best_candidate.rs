//! Mitchell's best candidate, on the torus.
//!
//! **What.** Each new point is the one of several uniform candidates that is farthest from all
//! points before; the number of candidates grows with the number of points, so that the quality
//! stays the same.
//!
//! **Formula.** Point i, from 0, is the best of k (i + 1) candidates; k is 1 unless it is set
//! (`candidates`).
//!
//! **Guarantees.** The first m of n points are the m points; unbiased.
//!
//! **Cost.** About k n^2 / 2 searches for a nearest neighbour, each of constant time with buckets.
//!
//! **Limits.** One to four dimensions and at most 65,536 points. Distances must be toroidal, or points
//! crowd along the border.
//!
//! **Paper.** D. P. Mitchell, Spectrally Optimal Sampling for Distribution Ray Tracing, SIGGRAPH
//! 1991, doi 10.1145/122718.122736.
//!
//! ```
//! use workbook::{samplers::{Sampler, best_candidate}, seed::Seed};
//! assert_eq!(best_candidate::PLAIN.points(100, 2, Seed::new(1))?.len(), 100);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::poisson::{self, Buckets, Place, in_dimensions, uniform};
use super::{Guarantee, Preset, Refused, Sampler, Setting, Values, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `best-candidate`, with so many candidates.
pub struct BestCandidate {
    candidates: u32,
}

/// The sampler without settings.
pub const PLAIN: BestCandidate = BestCandidate { candidates: CANDIDATES };

/// Candidates for each point so far, where they are not set.
const CANDIDATES: u32 = 1;

static SETTINGS: [Setting; 1] = [Setting {
    name: "candidates",
    meaning: "how many candidates a new point has for each point so far, itself counted",
    least: 1,
    most: 64,
    is_prime: false,
    default: Preset::Number(CANDIDATES),
}];

static ABOUT: About = About {
    key: "best-candidate",
    title: "Best candidate",
    summary: "Each point is the farthest of many random candidates from all points before, on the torus.",
    file: "samplers/best_candidate.rs",
    source: include_str!("best_candidate.rs"),
    papers: &[Paper {
        authors: "D. P. Mitchell",
        year: 1991,
        title: "Spectrally Optimal Sampling for Distribution Ray Tracing",
        venue: "SIGGRAPH 1991, 157-164",
        doi: Some("10.1145/122718.122736"),
    }],
};

impl Entry for BestCandidate {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for BestCandidate {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Prefix, Guarantee::Unbiased]
    }

    fn settings(&self) -> &'static [Setting] {
        &SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { candidates: values.at(0).unwrap_or(CANDIDATES) }))
    }

    fn searches(&self) -> bool {
        true
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        poisson::check(n, d)?;
        if n > MOST {
            return Err(Refused::Count { n, below: Some(MOST), above: None, rule: "at most 65536" });
        }
        Ok(())
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        refused::points(d, in_dimensions!(d, set(n, self.candidates, seed))?)
    }
}

/// The `n` points.
#[expect(clippy::unnecessary_wraps, reason = "as the sets that may fail")]
fn set<const D: usize>(n: usize, candidates: u32, seed: Seed) -> Result<Vec<Place<D>>, Refused> {
    let mut random = seed.generator();
    let mut buckets = Buckets::<D>::new(1);
    for i in 0..n {
        // Coarse buckets at first, finer ones each time there are as many points as buckets again.
        if i.is_power_of_two() && i.ilog2().is_multiple_of(D as u32) {
            buckets = Buckets::holding(1 << (i.ilog2() / D as u32), buckets.places());
        }
        let best = best_of((i + 1) * candidates as usize, &buckets, &mut random);
        buckets.add(best);
    }
    Ok(buckets.into_places())
}

/// The most points: the cost grows with their square.
const MOST: usize = 1 << 16;

/// Of `count` uniform candidates the one farthest from all points so far, the first of equals.
pub fn best_of<const D: usize>(count: usize, buckets: &Buckets<D>, random: &mut Random) -> Place<D> {
    let (mut best, mut distance) = (uniform(random), f64::NEG_INFINITY);
    for k in 0..count {
        let candidate = if k == 0 { best } else { uniform(random) };
        let own = buckets.nearest(candidate);
        if own > distance {
            (best, distance) = (candidate, own);
        }
    }
    best
}
