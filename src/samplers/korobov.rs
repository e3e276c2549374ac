//! Korobov lattices: rank-1 lattices of the powers of one multiplier.
//!
//! **What.** All n points are multiples of one vector modulo 1, (1, a, a^2, ...) / n. The
//! multiplier a is set (`generator`), or the best of up to 64 by the worst-case error of periodic
//! functions.
//!
//! **Formula.** x_i = (i (1, a, ..., a^(d-1)) mod n) / n; the criterion is P_2 = -1 + (1/n) sum
//! over i, prod over j of (1 + 2 pi^2 B_2(x_ij)), with B_2(x) = x^2 - x + 1/6.
//!
//! **Guarantees.** One point in each slab of every axis, since a has no common divisor with n;
//! deterministic. Errors of smooth periodic functions fall like n^(-2) up to logarithms.
//!
//! **Cost.** The search evaluates P_2 in up to 4 dimensions for each candidate, over at most 4,096
//! points; then one multiplication for each coordinate.
//!
//! **Limits.** A set, not a sequence: n must be known. Only 64 multipliers, spread over 1 ... n,
//! are tried. Needs a random shift for an error estimate.
//!
//! **Paper.** N. M. Korobov, The Approximate Computation of Multiple Integrals, Dokl. Akad. Nauk
//! SSSR 124 (1959), 1207-1210; I. H. Sloan and S. Joe, Lattice Methods for Multiple Integration,
//! Oxford 1994.
//!
//! ```
//! use workbook::{samplers::{Sampler, korobov}, seed::Seed};
//! let points = korobov::PLAIN.points(7, 3, Seed::new(1))?;
//! assert_eq!(points.axis(0).nth(3), Some(3.0 / 7.0));
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::{Feature, Guarantee, Preset, Refused, Sampler, Setting, Values, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;
use crate::stats::moments::sum;
use std::f64::consts::PI;

/// Multipliers tried.
const CANDIDATES: u64 = 64;

/// Points over which the criterion is summed at most.
const SCORED: u64 = 4096;

/// The sampler `korobov`, with the multiplier that it is told.
pub struct Korobov {
    generator: Option<u32>,
}

/// The sampler without settings.
pub const PLAIN: Korobov = Korobov { generator: None };

static SETTINGS: [Setting; 1] = [Setting {
    name: "generator",
    meaning: "the multiplier a, which must have no common divisor with n",
    least: 1,
    most: 1 << 30,
    is_prime: false,
    default: Preset::Rule("the best of 64 that are tried for each n"),
}];

static ABOUT: About = About {
    key: "korobov",
    title: "Korobov lattice",
    summary: "The rank-1 lattice of powers of one multiplier, searched for each n.",
    file: "samplers/korobov.rs",
    source: include_str!("korobov.rs"),
    papers: &[
        Paper {
            authors: "N. M. Korobov",
            year: 1959,
            title: "The Approximate Computation of Multiple Integrals",
            venue: "Doklady Akademii Nauk SSSR 124, 1207-1210",
            doi: None,
        },
        Paper {
            authors: "I. H. Sloan and S. Joe",
            year: 1994,
            title: "Lattice Methods for Multiple Integration",
            venue: "Oxford University Press",
            doi: None,
        },
    ],
};

impl Entry for Korobov {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Korobov {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Latin, Guarantee::Deterministic]
    }

    fn settings(&self) -> &'static [Setting] {
        &SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { generator: values.at(0) }))
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, usize::MAX)?;
        let fits = |&n: &usize| self.generator.is_none_or(|a| coprime(u64::from(a), n as u64));
        if fits(&n) {
            return Ok(());
        }
        // A run of numbers that all have a divisor in common with a 32-bit number is far shorter than 2^10.
        let (below, above) = ((1..n).rev().find(fits), (n + 1..).take(1 << 10).find(fits));
        Err(Refused::Count { n, below, above, rule: "without a common divisor with the generator" })
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        let a = self.generator.map_or_else(|| multiplier(n as u64, d), u64::from);
        let steps = powers(a % n as u64, n as u64, d);
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            for (x, &step) in point.iter_mut().zip(&steps) {
                *x = fraction(i as u64, step, n as u64);
            }
        }
        refused::points(d, coordinates)
    }
}

/// The coordinate (i step mod n) / n; n is below 2^30, so that the product fits.
fn fraction(i: u64, step: u64, n: u64) -> f64 {
    (i * step % n) as f64 / n as f64
}

/// 1, a, a^2, ... modulo n.
fn powers(a: u64, n: u64, d: usize) -> Vec<u64> {
    std::iter::successors(Some(1 % n), |&power| Some(power * a % n)).take(d).collect()
}

/// The best multiplier tried for `n` points of `d` dimensions.
pub fn multiplier(n: u64, d: usize) -> u64 {
    let stride = (n / CANDIDATES).max(1);
    let spread = (0..=CANDIDATES).map(|k| 1 + k * stride).filter(|&a| a < n.max(2) && coprime(a, n));
    let scored = spread.map(|a| (worst_case(a, n, d.min(4)), a));
    scored.min_by(|x, y| x.0.total_cmp(&y.0)).map_or(1, |(_, a)| a)
}

/// The criterion P_2 of the multiplier `a`, over the first points only where n is large.
fn worst_case(a: u64, n: u64, d: usize) -> f64 {
    let steps = powers(a, n, d);
    let bernoulli = |x: f64| x * x - x + 1.0 / 6.0;
    let term = |i| steps.iter().map(|&step| 1.0 + 2.0 * PI * PI * bernoulli(fraction(i, step, n))).product::<f64>();
    sum((0..n.min(SCORED)).map(term)) / n as f64 - 1.0
}

fn coprime(mut a: u64, mut b: u64) -> bool {
    while b > 0 {
        (a, b) = (b, a % b);
    }
    a == 1
}
