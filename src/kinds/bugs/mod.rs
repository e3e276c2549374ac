//! The gallery of bugs: small programs, each right and with one bug planted, that run on random numbers and on quasi-random ones.
//!
//! To add a bug, write its file and add its two lines here: its module and its place in [`BUGS`]. A program gets its numbers from a
//! [`Source`] and reports in its [`Run`] each contribution, with the sample carried back to [0, 1) by the distribution function that
//! it should follow. The tests of `battery` see nothing else, and know no bug by name.

mod battery;
mod dimension_twice;
mod dropped_point;
mod missing_density;
mod odd_count;
mod rejection;
mod repeated_point;
mod reused_offset;
mod rounded_to_one;
mod same_sequence;
mod shifted_dimensions;
mod wrong_range;

use crate::diag::Code;
use crate::kinds::{Failure, Problems};
use crate::points::Points;
use crate::samplers::{Guarantee, Method};
use crate::seed::Seed;
use crate::stats::moments;

pub use battery::{Battery, Form, Mark, Numbers, Test, battery, rate_of};
use battery::{RUNS, counts};

/// Every bug, in the order of display.
pub static BUGS: &[&Bug] = &[
    &missing_density::BUG,
    &wrong_range::BUG,
    &dimension_twice::BUG,
    &same_sequence::BUG,
    &shifted_dimensions::BUG,
    &rejection::BUG,
    &dropped_point::BUG,
    &repeated_point::BUG,
    &odd_count::BUG,
    &reused_offset::BUG,
    &rounded_to_one::BUG,
];

/// A program in two forms, of which one has a bug.
pub struct Bug {
    /// Its name, as in the values `caught.NAME`.
    pub key: &'static str,
    /// What is wrong, in a few words.
    pub title: &'static str,
    /// How many numbers a sample of the right program takes.
    pub dimensions: usize,
    /// What the program should compute.
    pub exact: f64,
    /// The right program.
    pub right: fn(&Source<'_>) -> Run,
    /// The program with the bug.
    pub planted: fn(&Source<'_>) -> Run,
    /// The test that catches it, and on which numbers.
    pub caught_by: (Test, Numbers),
}

/// The bug whose key is `key`.
pub fn find(key: &str) -> Option<&'static Bug> {
    BUGS.iter().copied().find(|bug| bug.key == key)
}

/// Complains of numbers on which the gallery cannot run.
pub fn check_sampler(sampler: &Method, problems: &mut Problems<'_, '_>) {
    let largest = counts().max().unwrap_or(1);
    problems.admit("sampler", std::slice::from_ref(sampler), &[largest], 3);
    if !sampler.is_random() || !sampler.guarantees().contains(&Guarantee::Prefix) {
        let message = format!("`{}` is no randomised sequence", sampler.name());
        let help = "choose a sequence with a random scramble, such as `sobol+owen`".to_owned();
        problems.at("sampler", Code::Combination, message, Some(help));
    }
}

/// How many evaluations a bug's battery makes, about.
pub fn weight() -> u64 {
    20 * RUNS as u64 * counts().sum::<usize>() as u64
}

/// Where a program gets its numbers: the points of one randomisation, that of one pixel.
pub struct Source<'a> {
    own: Points,
    first: &'a Points,
    n: usize,
    random: bool,
}

/// How many points there are for each sample: rejection takes more than one.
const SPARE: usize = 2;

/// The points for `n` samples of `d` dimensions in pixel `pixel`, and some to spare.
fn points(method: &Method, n: usize, d: usize, seed: Seed, pixel: usize) -> Result<Points, Failure> {
    let points = method.points(SPARE * n, d, seed.at(pixel as u64));
    points.map_err(|refused| Failure::of("sampler", refused.to_string()).help("choose another sampler"))
}

impl<'a> Source<'a> {
    /// The numbers for `n` samples: the `own` points of the pixel, and those of the `first` pixel.
    pub fn new(own: Points, first: &'a Points, n: usize, random: bool) -> Self {
        Self { own, first, n, random }
    }

    /// How many samples are to be taken.
    pub fn len(&self) -> usize {
        self.n
    }

    /// The points from the first on: more than there are samples to be taken.
    pub fn points(&self) -> impl Iterator<Item = &[f64]> {
        self.own.rows()
    }

    /// The points of the first pixel's randomisation.
    pub fn points_of_first_pixel(&self) -> impl Iterator<Item = &[f64]> {
        self.first.rows()
    }

    /// All numbers in a row: the coordinates of the first point, then of the second, ...
    pub fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        self.own.coordinates().iter().copied()
    }

    /// A generator of single numbers, newly made. Random ones are seeded apart; a quasi-random one starts its sequence again.
    pub fn generator(&self, which: usize) -> impl Iterator<Item = f64> + '_ {
        self.own.axis(if self.random { which } else { 0 })
    }
}

/// What a program did: its samples, and their contributions.
#[derive(Debug, Default, PartialEq)]
pub struct Run {
    /// How many coordinates a sample has.
    axes: usize,
    /// The coordinates of the samples, carried back to [0, 1), one sample after the other.
    coordinates: Vec<f64>,
    /// The contribution of each sample.
    values: Vec<f64>,
}

impl Run {
    /// Adds a sample and its contribution; every sample has as many coordinates.
    pub fn add(&mut self, sample: &[f64], value: f64) {
        self.axes = sample.len();
        self.coordinates.extend_from_slice(sample);
        self.values.push(value);
    }

    /// The samples.
    pub fn samples(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.coordinates.chunks_exact(self.axes.max(1))
    }

    /// The estimate: the mean of the contributions; NaN of none.
    pub fn estimate(&self) -> f64 {
        moments::mean(&self.values)
    }
}
