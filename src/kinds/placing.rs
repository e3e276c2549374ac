//! Placing: the point sets of an experiment by method, count and replicate, measured in parallel and told in order.

use rayon::prelude::*;

use super::estimation::replicates_of;
use super::experiment::{Failure, piece};
use crate::metrics::Unmeasured;
use crate::points::Points;
use crate::samplers::Method;
use crate::seed::Seed;

/// The point sets of one experiment.
pub struct Placing {
    /// The key of the kind that asks, so that two kinds never share random numbers.
    pub kind: &'static str,
    /// The dimensions of the unit cube.
    pub d: usize,
    /// The experiment's seed.
    pub seed: Seed,
}

impl Placing {
    /// The points of one replicate. They depend on nothing else that is asked for in the same experiment.
    pub fn points(&self, method: &Method, n: usize, replicate: usize) -> Result<Points, Failure> {
        let stream = self.seed.named(self.kind).named(&method.name()).at(n as u64).at(replicate as u64);
        method.points(n, self.d, stream).map_err(|refused| Failure::of("samplers", refused.to_string()))
    }

    /// What `measure` gives for every set: `[method][count][replicate]`. A method that no seed changes has one replicate.
    pub fn measured<T: Send>(
        &self,
        methods: &[Method],
        counts: &[usize],
        replicates: usize,
        measure: impl Fn(&Method, &Points) -> Result<T, Failure> + Sync,
    ) -> Result<Vec<Vec<Vec<T>>>, Failure> {
        let mut tasks = Vec::new();
        for (i, method) in methods.iter().enumerate() {
            for (j, &n) in counts.iter().enumerate() {
                tasks.extend((0..replicates_of(method, replicates)).map(|replicate| (i, j, method, n, replicate)));
            }
        }
        let run = |&(_, _, method, n, replicate): &(usize, usize, &Method, usize, usize)| {
            measure(method, &self.points(method, n, replicate)?)
        };
        let results: Vec<Result<T, Failure>> = tasks.par_iter().map(piece(run)).collect();
        let mut all: Vec<Vec<Vec<T>>> = methods.iter().map(|_| counts.iter().map(|_| Vec::new()).collect()).collect();
        for ((i, j, ..), result) in tasks.into_iter().zip(results) {
            let value = result?;
            if let Some(slot) = all.get_mut(i).and_then(|counts| counts.get_mut(j)) {
                slot.push(value);
            }
        }
        Ok(all)
    }
}

/// The failure of points that cannot be measured.
pub fn unmeasured(method: &Method, error: &Unmeasured) -> Failure {
    Failure::of("samplers", format!("`{}`: {error}", method.name())).help("take fewer points, or drop the measure")
}
