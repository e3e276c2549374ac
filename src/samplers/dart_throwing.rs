//! Poisson disks by dart throwing, on the torus.
//!
//! **What.** Uniform points come one by one, and each is refused if it lies nearer to one before
//! than the radius.
//!
//! **Formula.** The radius is 0.7 of the largest distance that n points can keep, in the plane r =
//! 0.7 sqrt(2 / (sqrt(3) n)); there the disks of radius r/2 cover 0.44 of the torus, where throwing
//! jams at 0.547.
//!
//! **Guarantees.** No two points are nearer on the torus than 0.7 of the largest possible distance;
//! unbiased.
//!
//! **Cost.** Linear in n with buckets: about 40 darts for each point.
//!
//! **Limits.** One to four dimensions. Holes remain, larger than in a [maximal](super::maximal_poisson)
//! set. A throw that jams starts again.
//!
//! **Paper.** R. L. Cook, Stochastic Sampling in Computer Graphics (1986), doi 10.1145/7529.8927;
//! the jamming limit: E. L. Hinrichsen, J. Feder and T. Jøssang, J. Stat. Phys. 44 (1986), doi
//! 10.1007/BF01011908.
//!
//! ```
//! use workbook::{samplers::{Sampler, dart_throwing::DartThrowing}, seed::Seed};
//! assert_eq!(DartThrowing.points(100, 2, Seed::new(1))?.len(), 100);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::poisson::{self, Buckets, Place, densest, in_dimensions, uniform};
use super::{Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `dart-throwing`.
pub struct DartThrowing;

static ABOUT: About = About {
    key: "dart-throwing",
    title: "Dart throwing",
    summary: "Random points of the torus, each refused if it falls too near to one before.",
    file: "samplers/dart_throwing.rs",
    source: include_str!("dart_throwing.rs"),
    papers: &[
        Paper {
            authors: "R. L. Cook",
            year: 1986,
            title: "Stochastic Sampling in Computer Graphics",
            venue: "ACM Transactions on Graphics 5(1), 51-72",
            doi: Some("10.1145/7529.8927"),
        },
        Paper {
            authors: "E. L. Hinrichsen, J. Feder and T. Jøssang",
            year: 1986,
            title: "Geometry of Random Sequential Adsorption",
            venue: "Journal of Statistical Physics 44, 793-827",
            doi: Some("10.1007/BF01011908"),
        },
    ],
};

impl Entry for DartThrowing {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for DartThrowing {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Separated { percent: 70 }, Guarantee::Unbiased]
    }

    fn searches(&self) -> bool {
        true
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        poisson::check(n, d)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        refused::points(d, in_dimensions!(d, set(n, seed))?)
    }
}

/// Exactly `n` points: throws that jam start again.
fn set<const D: usize>(n: usize, seed: Seed) -> Result<Vec<Place<D>>, Refused> {
    let radius = SHARE * densest(n, D).unwrap_or(1.0);
    let places = (0..ATTEMPTS).find_map(|attempt| throw(n, radius, &mut seed.at(attempt).generator()));
    places.ok_or(Refused::Count { n, below: None, above: None, rule: "a count that throwing reaches" })
}

/// Throws before it is given up: one in some hundreds jams.
const ATTEMPTS: u64 = 10_000;

/// The radius as a share of the largest distance.
const SHARE: f64 = 0.7;

/// Darts that may miss in a row before the throw counts as jammed.
const PATIENCE: usize = 20_000;

/// `n` points no two of which are nearer than `radius`; `None` if the throw
/// jams before.
pub fn throw<const D: usize>(
    n: usize,
    radius: f64, // the least distance of two points
    random: &mut Random,
) -> Option<Vec<Place<D>>> {
    let mut buckets = Buckets::new((1.0 / radius) as usize);
    while buckets.places().len() < n {
        let mut darts = (0..PATIENCE).map(|_| uniform(random));
        buckets.add(darts.find(|&dart| !buckets.any_within(dart, radius))?);
    }
    Some(buckets.into_places())
}
