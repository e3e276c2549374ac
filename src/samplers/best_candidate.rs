//! Mitchell's best candidate, on the torus.
//!
//! **What.** Each new point is the one of several uniform candidates that is farthest from all
//! points before; the number of candidates grows with the number of points, so that the quality
//! stays the same.
//!
//! **Formula.** Point i, from 0, is the best of i + 1 candidates.
//!
//! **Guarantees.** The first m of n points are the m points; unbiased.
//!
//! **Cost.** About n^2 / 2 searches for a nearest neighbour, each of constant time with buckets.
//!
//! **Limits.** Two dimensions and at most 65,536 points. Distances must be toroidal, or points
//! crowd along the border.
//!
//! **Paper.** D. P. Mitchell, Spectrally Optimal Sampling for Distribution Ray Tracing, SIGGRAPH
//! 1991, doi 10.1145/122718.122736.
//!
//! ```
//! use workbook::{samplers::{Sampler, best_candidate::BestCandidate}, seed::Seed};
//! assert_eq!(BestCandidate.points(100, 2, Seed::new(1))?.len(), 100);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::poisson::{Buckets, Place, uniform};
use super::{Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `best-candidate`.
pub struct BestCandidate;

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

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::plane(n, d)?;
        if n > MOST {
            return Err(Refused::Count { n, below: Some(MOST), above: None, rule: "at most 65536" });
        }
        Ok(())
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut random = seed.generator();
        let mut buckets = Buckets::new(1);
        for i in 0..n {
            // Coarse buckets at first, finer ones each time the count has quadrupled.
            if i.is_power_of_two() && i.ilog2().is_multiple_of(2) {
                buckets = refill(&buckets, 1 << (i.ilog2() / 2));
            }
            let best = best_of(i + 1, &buckets, &mut random);
            buckets.add(best);
        }
        refused::points(d, buckets.places().to_vec().into_flattened())
    }
}

/// The most points: the cost grows with their square.
const MOST: usize = 1 << 16;

/// The same points in `side` x `side` buckets.
fn refill(buckets: &Buckets, side: usize) -> Buckets {
    let mut finer = Buckets::new(side);
    for &place in buckets.places() {
        finer.add(place);
    }
    finer
}

/// Of `count` uniform candidates the one farthest from all points so far, the first of equals.
pub fn best_of(count: usize, buckets: &Buckets, random: &mut Random) -> Place {
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
