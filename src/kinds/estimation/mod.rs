//! Estimation: many estimates of one integral, in parallel and in an order that no thread can change.

mod law;
mod rate;

use std::ops::Range;

use rayon::prelude::*;

use crate::diag::Code;
use crate::integrands::{Function, Reference};
use crate::kinds::experiment::{Failure, Problems, piece};
use crate::points::Points;
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::moments::{self, Sum};

pub use law::{Density, Law, Named, check_density, check_ends};
pub use rate::{Rate, rate, root_mean_square};

/// How many evaluations one task of the thread pool makes, about.
const TASK: usize = 1 << 15;

/// The estimates of one integral by several samplers.
pub struct Study<'a> {
    /// The key of the kind that asks, so that two kinds never share random numbers.
    pub kind: &'static str,
    /// The integrand.
    pub integrand: &'a Function,
    /// The dimensions of the unit cube.
    pub d: usize,
    /// The experiment's seed.
    pub seed: Seed,
}

impl Study<'_> {
    /// The stream of one replicate. It depends on nothing else that is asked for in the same experiment, so that another
    /// sampler, count or replicate never shifts the numbers of this one.
    pub fn stream(&self, method: &Method, n: usize, replicate: usize) -> Seed {
        self.seed.named(self.kind).named(&method.name()).at(n as u64).at(replicate as u64)
    }

    /// The estimates of every method, for every count, over the replicates: `[method][count][replicate]`. A method that
    /// no seed changes has one replicate.
    pub fn estimates(
        &self,
        methods: &[Method],
        counts: &[usize],
        replicates: usize,
    ) -> Result<Vec<Vec<Vec<f64>>>, Failure> {
        let all = self.estimates_of(&[self.integrand], methods, counts, replicates)?;
        Ok(all.into_iter().next().unwrap_or_default())
    }

    /// The same for several integrands, all from the same points: `[integrand][method][count][replicate]`.
    pub fn estimates_of(
        &self,
        integrands: &[&Function],
        methods: &[Method],
        counts: &[usize],
        replicates: usize,
    ) -> Result<Vec<Vec<Vec<Vec<f64>>>>, Failure> {
        let mut tasks = Vec::new();
        for (i, method) in methods.iter().enumerate() {
            let replicates = replicates_of(method, replicates);
            for (j, &n) in counts.iter().enumerate() {
                let batch = (TASK / n.max(1)).max(1);
                let batches = (0..replicates).step_by(batch);
                tasks.extend(batches.map(|first| (i, j, method, n, first..(first + batch).min(replicates))));
            }
        }
        let batch = |method: &Method, n: usize, replicates: &Range<usize>| -> Result<Vec<Vec<f64>>, Failure> {
            let one = |replicate| {
                let points = self.points(method, n, self.stream(method, n, replicate))?;
                integrands.iter().map(|integrand| mean(integrand, &points)).collect()
            };
            replicates.clone().map(one).collect()
        };
        let run = |task: &(_, _, &Method, usize, Range<usize>)| batch(task.2, task.3, &task.4);
        let results: Vec<_> = tasks.par_iter().map(piece(run)).collect();
        let mut all = vec![vec![vec![Vec::new(); counts.len()]; methods.len()]; integrands.len()];
        for ((i, j, ..), result) in tasks.into_iter().zip(results) {
            for run in result? {
                for (of, estimate) in all.iter_mut().zip(run) {
                    of[i][j].push(estimate);
                }
            }
        }
        Ok(all)
    }

    /// One estimate: the mean of the integrand over n points.
    pub fn estimate(
        &self,
        method: &Method,
        n: usize, // points
        stream: Seed,
    ) -> Result<f64, Failure> {
        mean(self.integrand, &self.points(method, n, stream)?)
    }

    /// The points of one replicate.
    pub fn points(&self, method: &Method, n: usize, stream: Seed) -> Result<Points, Failure> {
        method.points(n, self.d, stream).map_err(|refused| Failure::of("samplers", refused.to_string()))
    }

    /// The failure of an integrand that is not finite at one of `points`.
    pub fn undefined(&self, points: &Points) -> Failure {
        undefined_at(self.integrand, points)
    }
}

/// The estimates of several integrands, `[integrand][method][count][replicate]`: those with as many dimensions that follow each other
/// are from the same points. `asked` are the dimensions, if they are told.
pub fn estimates_of_all(
    kind: &'static str,
    (integrands, asked): (&[Function], Option<usize>),
    methods: &[Method],
    counts: &[usize],
    replicates: usize,
    seed: Seed,
) -> Result<Vec<Vec<Vec<Vec<f64>>>>, Failure> {
    let mut all = Vec::new();
    for alike in integrands.chunk_by(|a, b| dimensions(a, asked) == dimensions(b, asked)) {
        let study = Study { kind, integrand: &alike[0], d: dimensions(&alike[0], asked), seed };
        all.extend(study.estimates_of(&alike.iter().collect::<Vec<_>>(), methods, counts, replicates)?);
    }
    Ok(all)
}

/// The mean of `integrand` over `points`.
fn mean(integrand: &Function, points: &Points) -> Result<f64, Failure> {
    let mut sum = Sum::default();
    for point in points.rows() {
        sum.add(integrand.evaluate(point));
    }
    let mean = sum.value() / points.len() as f64;
    if mean.is_finite() { Ok(mean) } else { Err(undefined_at(integrand, points)) }
}

/// The failure of an integrand that is not finite at one of `points`.
fn undefined_at(integrand: &Function, points: &Points) -> Failure {
    let at = points.rows().find(|point| !integrand.evaluate(point).is_finite());
    undefined(integrand, at.unwrap_or_default())
}

/// The failure of `integrand` at a point where it is not finite.
pub fn undefined(integrand: &Function, point: &[f64]) -> Failure {
    let place: Vec<String> = point.iter().map(|coordinate| format!("{coordinate:.4}")).collect();
    let place = if place.is_empty() { String::new() } else { format!(" at ({})", place.join(", ")) };
    let message = format!("`{}` is not a finite number{place}", integrand.text());
    Failure::of("integrand", message).help("choose an integrand that is finite on the whole of [0, 1)^d")
}

/// How many replicates of `method` differ, of those asked for.
pub fn replicates_of(method: &Method, asked: usize) -> usize {
    if method.is_random() { asked } else { 1 }
}

/// The integral of `integrand` over the unit cube of d dimensions, or the failure that it is not known.
pub fn reference(integrand: &Function, d: usize) -> Result<Reference, Failure> {
    let failure = || {
        let message = format!("the integral of `{}` in {d} dimensions is not known exactly enough", integrand.text());
        Failure::of("integrand", message).help("choose a catalogued integrand, or a smooth one of at most 3 dimensions")
    };
    integrand.integral(d).filter(|reference| reference.value.is_finite()).ok_or_else(failure)
}

/// The dimensions to integrate over: as asked, or as many as the integrand has, or one where it takes any number.
pub fn dimensions(integrand: &Function, asked: Option<usize>) -> usize {
    asked.or(integrand.dimensions()).unwrap_or(1)
}

/// Complains if the integrand has more variables than the `asked` dimensions.
pub fn check_dimensions(integrand: &Function, asked: Option<usize>, problems: &mut Problems<'_, '_>) {
    if let (Some(has), Some(asked)) = (integrand.dimensions(), asked)
        && asked < has
    {
        let message = format!("`{}` has {has} variables, more than {asked} dimensions", integrand.text());
        problems.at("dimensions", Code::Combination, message, Some(format!("write {has}, or drop the line")));
    }
}

/// The mean of `numbers` with its standard error, which a single number does not have.
pub fn mean_with_error(numbers: &[f64]) -> (f64, Option<f64>) {
    let n = numbers.len() as f64;
    let error = (numbers.len() > 1).then(|| (moments::variance(numbers) / n).sqrt());
    (moments::mean(numbers), error)
}
