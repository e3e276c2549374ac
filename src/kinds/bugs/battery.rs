//! The battery: the tests that every program of the gallery is put to, on random and on quasi-random numbers.
//!
//! Each program runs in [`RUNS`] pixels, each with its own randomisation, for N = 2^4, 2^5, ..., 2^10. Every test by chance has a
//! threshold that a right program passes but once in a million times: a probability of 10^-6, or six and more standard errors of a slope. Of
//! the others (strata, repeats, range) a right program fails none at all. The slope of 64 errors at 7 counts has a standard error of
//! 0.024: each logarithm of a root mean square of R errors has one of 1 / (sqrt(2 R) ln 2), and the slope divides it by the root of
//! the sum of squares of the distances to the middle count, sqrt(28).

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{Bug, Run, Source, points};
use crate::kinds::estimation::{Rate, mean_with_error, rate, root_mean_square};
use crate::kinds::{Failure, piece};
use crate::metrics::correlation::pearson;
use crate::points::{Points, slab};
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::inference;

/// In how many pixels each program runs.
pub const RUNS: usize = 64;

/// The probability below which chance is no excuse.
const PROBABILITY: f64 = 1e-6;

/// How far the slope of random numbers may be from -1/2: six standard errors.
const RANDOM_SLOPE: f64 = 0.15;

/// The slope that a scrambled net must reach with a smooth integrand: eight standard errors below -1, the best that is left after a
/// point is lost, and above -3/2, its own, which it nears only as N grows.
const NET_SLOPE: f64 = -1.2;

/// Into how many bins the chi-square test sorts samples.
const BINS: usize = 32;

/// The counts N.
pub fn counts() -> impl Iterator<Item = usize> {
    (4..=10).map(|power| 1 << power)
}

/// A question to a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Test {
    /// Whether the mean over the pixels is the exact value.
    Z,
    /// Whether the samples fall evenly into bins.
    ChiSquare,
    /// Whether they follow their distribution function.
    Kolmogorov,
    /// Whether two coordinates of the samples vary together.
    Correlation,
    /// Whether the error falls as fast as it should.
    Rate,
    /// Whether random and quasi-random numbers give the same mean.
    Comparison,
    /// Whether N samples fall into N slabs, as the points promise.
    Strata,
    /// Whether a sample or an estimate comes twice.
    Repeats,
    /// Whether samples stay in range for the least and the largest numbers.
    Range,
}

impl Test {
    /// Every test, in the order of display.
    pub const ALL: [Self; 9] = [
        Self::Z,
        Self::ChiSquare,
        Self::Kolmogorov,
        Self::Correlation,
        Self::Rate,
        Self::Comparison,
        Self::Strata,
        Self::Repeats,
        Self::Range,
    ];

    /// Its name, as in the values `caught.BUG.TEST`.
    pub fn key(self) -> &'static str {
        match self {
            Self::Z => "z",
            Self::ChiSquare => "chi-square",
            Self::Kolmogorov => "ks",
            Self::Correlation => "correlation",
            Self::Rate => "rate",
            Self::Comparison => "comparison",
            Self::Strata => "strata",
            Self::Repeats => "repeats",
            Self::Range => "range",
        }
    }
}

/// On what numbers a program runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Numbers {
    /// Random ones.
    Random,
    /// Quasi-random ones, randomised.
    Quasi,
}

/// Which form of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Form {
    /// The right one.
    Right,
    /// The one with the bug.
    Planted,
}

/// What one test says of one program on one kind of numbers; a test that does not apply says nothing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// The test.
    pub test: Test,
    /// The form of the program.
    pub form: Form,
    /// The numbers.
    pub numbers: Numbers,
    /// Whether it fails the test.
    pub caught: bool,
}

/// The error at one count: of N samples, with its standard error.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Mark {
    /// The number of samples asked for.
    pub n: u64,
    /// The root mean square error over the pixels.
    pub rmse: f64,
    /// Its standard error.
    pub error: Option<f64>,
}

/// All that is found out about one bug.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Battery {
    /// The findings.
    pub findings: Vec<Finding>,
    /// The errors over N, by form and numbers.
    pub errors: Vec<(Form, Numbers, Vec<Mark>)>,
    /// The mean over the pixels at the largest count with its standard error, by form and numbers.
    pub means: Vec<(Form, Numbers, f64, f64)>,
}

impl Battery {
    /// Whether a test catches a form of the program on some numbers.
    pub fn catches(&self, test: Test, form: Form, numbers: Numbers) -> bool {
        self.findings.iter().any(|one| one.test == test && one.form == form && one.numbers == numbers && one.caught)
    }

    /// Whether the right program passes all tests.
    pub fn right_passes(&self) -> bool {
        self.findings.iter().all(|finding| finding.form == Form::Planted || !finding.caught)
    }

    /// Whether the named test catches the bug.
    pub fn caught(&self, bug: &Bug) -> bool {
        self.catches(bug.caught_by.0, Form::Planted, bug.caught_by.1)
    }
}

/// The fitted rate of errors.
pub fn rate_of(marks: &[Mark]) -> Option<Rate> {
    rate(marks.iter().map(|mark| (mark.n as f64, mark.rmse)))
}

/// What the runs of one form on one kind of numbers left behind.
struct Runs {
    form: Form,
    numbers: Numbers,
    /// For each count, the estimates of the pixels.
    estimates: Vec<Vec<f64>>,
    /// The runs of all pixels at the largest count.
    last: Vec<Run>,
    /// Whether the points themselves have one in each slab.
    stratified: bool,
}

/// Puts both forms of a bug's program to all tests, with random numbers and with those of `method`.
pub fn battery(bug: &Bug, method: &Method, seed: Seed) -> Result<Battery, Failure> {
    let random = Method::parse("independent").map_err(|error| Failure::of("sampler", error.to_string()))?;
    let mut all = Vec::new();
    for (numbers, method) in [(Numbers::Random, &random), (Numbers::Quasi, method)] {
        all.extend(runs(bug, numbers, method, seed.named(bug.key).named(&method.name()))?);
    }
    let mut findings = Vec::new();
    for runs in &all {
        let other = all.iter().find(|other| other.form == runs.form && other.numbers != runs.numbers);
        for test in Test::ALL {
            if let Some(caught) = finding(test, bug, runs, other) {
                findings.push(Finding { test, form: runs.form, numbers: runs.numbers, caught });
            }
        }
    }
    let errors = all.iter().map(|runs| (runs.form, runs.numbers, marks(bug, runs))).collect();
    let means = all.iter().map(|runs| {
        let (mean, error) = mean_with_error(runs.estimates.last().map_or(&[][..], Vec::as_slice));
        (runs.form, runs.numbers, mean, error.unwrap_or(f64::NAN))
    });
    Ok(Battery { findings, errors, means: means.collect() })
}

/// Runs both forms in every pixel for every count.
fn runs(bug: &Bug, numbers: Numbers, method: &Method, seed: Seed) -> Result<[Runs; 2], Failure> {
    let empty = |form| Runs { form, numbers, estimates: Vec::new(), last: Vec::new(), stratified: false };
    let mut both = [empty(Form::Right), empty(Form::Planted)];
    for n in counts() {
        let points = |pixel: usize| points(method, n, bug.dimensions, seed.at(n as u64), pixel);
        let first = points(0)?;
        let run = |pixel: usize| {
            let source = Source::new(points(pixel)?, &first, n, numbers == Numbers::Random);
            let latin = is_latin(source.points().take(n), bug.dimensions, n);
            Ok(([(bug.right)(&source), (bug.planted)(&source)], latin))
        };
        let pixels: Vec<Result<([Run; 2], bool), Failure>> = (0..RUNS).into_par_iter().map(piece(run)).collect();
        let pixels = pixels.into_iter().collect::<Result<Vec<_>, _>>()?;
        let stratified = pixels.iter().all(|(_, latin)| *latin);
        let (right, planted): (Vec<Run>, Vec<Run>) =
            pixels.into_iter().map(|([right, planted], _)| (right, planted)).unzip();
        for (runs, last) in both.iter_mut().zip([right, planted]) {
            runs.estimates.push(last.iter().map(Run::estimate).collect());
            runs.last = last;
            runs.stratified = stratified;
        }
    }
    Ok(both)
}

/// The errors over N.
fn marks(bug: &Bug, runs: &Runs) -> Vec<Mark> {
    let mark = |(n, estimates): (usize, &Vec<f64>)| {
        let errors: Vec<f64> = estimates.iter().map(|estimate| estimate - bug.exact).collect();
        let (rmse, error) = root_mean_square(&errors);
        Mark { n: n as u64, rmse, error }
    };
    counts().zip(&runs.estimates).map(mark).collect()
}

/// Whether `test` catches the runs; `None` if it does not apply to them.
fn finding(test: Test, bug: &Bug, runs: &Runs, other: Option<&Runs>) -> Option<bool> {
    let estimates = runs.estimates.last()?;
    match test {
        Test::Z => Some(!fits(estimates, bug.exact)),
        Test::ChiSquare => any_axis(runs, chi_square),
        Test::Kolmogorov => any_axis(runs, inference::kolmogorov_smirnov),
        Test::Correlation => correlated(runs),
        Test::Rate => {
            let slope = rate_of(&marks(bug, runs)).map(|rate| rate.slope);
            Some(slope.is_none_or(|slope| match runs.numbers {
                Numbers::Random => (slope + 0.5).abs() > RANDOM_SLOPE,
                Numbers::Quasi => slope > NET_SLOPE,
            }))
        }
        // It is one comparison of both, told with the quasi-random numbers, which are the suspects.
        Test::Comparison if runs.numbers == Numbers::Random => None,
        Test::Comparison => Some(differ(estimates, other?.estimates.last()?)),
        Test::Strata if !runs.stratified => None,
        Test::Strata => {
            let whole = |run: &Run| is_latin(run.samples(), run.axes, run.values.len());
            Some(!runs.last.iter().all(whole))
        }
        Test::Repeats => Some(repeats(runs, estimates)),
        Test::Range => Some(!in_range(bug, runs.form)),
    }
}

/// Whether the mean of the estimates is `exact`, by Student's t.
fn fits(estimates: &[f64], exact: f64) -> bool {
    let (mean, error) = mean_with_error(estimates);
    let error = error.unwrap_or(0.0);
    if !mean.is_finite() || error <= 0.0 {
        return mean == exact;
    }
    let quantile = inference::t_quantile(1.0 - 0.5 * PROBABILITY, estimates.len() as f64 - 1.0);
    ((mean - exact) / error).abs() <= quantile
}

/// Whether the means of two sets of estimates differ, by Welch's t with the smaller number of degrees of freedom.
fn differ(a: &[f64], b: &[f64]) -> bool {
    let ((mean_a, error_a), (mean_b, error_b)) = (mean_with_error(a), mean_with_error(b));
    let (error_a, error_b) = (error_a.unwrap_or(0.0), error_b.unwrap_or(0.0));
    let error = (error_a * error_a + error_b * error_b).sqrt();
    let quantile = inference::t_quantile(1.0 - 0.5 * PROBABILITY, a.len().min(b.len()) as f64 - 1.0);
    let within = (mean_a - mean_b).abs() <= quantile * error;
    !within
}

/// The samples of all pixels; `None` if there are none.
fn pooled(runs: &Runs) -> Option<Points> {
    let coordinates = runs.last.iter().flat_map(|run| &run.coordinates).copied().collect();
    Points::from_rows(runs.last.first()?.axes, coordinates)
}

/// Whether `test` rejects any axis of the samples.
fn any_axis(runs: &Runs, test: impl Fn(&[f64]) -> Option<inference::Verdict>) -> Option<bool> {
    let points = pooled(runs)?;
    Some((0..points.dimensions()).any(|axis| improbable(test(&points.axis(axis).collect::<Vec<_>>()))))
}

fn chi_square(axis: &[f64]) -> Option<inference::Verdict> {
    let mut counts = vec![0; BINS];
    for &u in axis {
        counts[slab(u, BINS)] += 1;
    }
    inference::chi_square(&counts)
}

fn improbable(verdict: Option<inference::Verdict>) -> bool {
    verdict.is_none_or(|verdict| verdict.probability < PROBABILITY)
}

/// Whether any two axes are correlated; `None` with one axis.
fn correlated(runs: &Runs) -> Option<bool> {
    let points = pooled(runs)?;
    let d = points.dimensions();
    let far = |(i, j): (usize, usize)| {
        // The root of n times the correlation of independent numbers is nearly standard normal.
        let z = pearson(&points, i, j).map(|r| r * (points.len() as f64).sqrt());
        z.is_none_or(|z| inference::two_sided(z) < PROBABILITY)
    };
    (0..d).flat_map(|j| (0..j).map(move |i| (i, j))).map(far).reduce(|a, b| a || b)
}

/// Whether `n` rows have one in each of n slabs of every axis.
fn is_latin<'a>(rows: impl Iterator<Item = &'a [f64]>, d: usize, n: usize) -> bool {
    let mut taken = vec![false; d * n];
    let mut count = 0;
    for row in rows {
        count += 1;
        row.iter().take(d).enumerate().for_each(|(axis, &u)| taken[axis * n + slab(u, n)] = true);
    }
    count == n && n.is_power_of_two() && taken.iter().all(|taken| *taken)
}

/// Whether a sample comes twice in a run, or an estimate in two pixels.
fn repeats(runs: &Runs, estimates: &[f64]) -> bool {
    let bits = |sample: &[f64]| sample.iter().map(|u| u.to_bits()).collect::<Vec<_>>();
    let twice = |mut all: Vec<Vec<u64>>| {
        all.sort_unstable();
        all.windows(2).any(|pair| pair[0] == pair[1])
    };
    runs.last.iter().any(|run| twice(run.samples().map(bits).collect()))
        || twice(estimates.iter().map(|estimate| vec![estimate.to_bits()]).collect())
}

/// Whether samples and contributions are in range at every corner of the cube: the least and the largest numbers of a generator.
fn in_range(bug: &Bug, form: Form) -> bool {
    let program = if form == Form::Right { bug.right } else { bug.planted };
    let largest = 1.0 - 0.5 * f64::EPSILON;
    let corner = |index: usize| (0..bug.dimensions).map(move |axis| if index >> axis & 1 == 1 { largest } else { 0.0 });
    // Each corner alone, so that a program that takes fewer points than there are meets it.
    (0..1_usize << bug.dimensions).all(|index| {
        let rows: Vec<f64> = (0..4).flat_map(|_| corner(index)).collect();
        let Some(points) = Points::from_rows(bug.dimensions, rows) else { return false };
        let run = program(&Source::new(points.clone(), &points, points.len(), true));
        run.coordinates.iter().all(|u| (0.0..1.0).contains(u)) && run.values.iter().all(|value| value.is_finite())
    })
}
