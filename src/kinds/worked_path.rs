//! The worked path: an estimator with random numbers, tested; then each swap of its numbers in turn, tested again.
//!
//! Each stage runs the same estimator in R independent randomisations. The z-test holds the mean over them against the exact value;
//! the chi-square test sorts the first coordinate of all samples into bins; the slope of the error over N tells what the swap gains.
//! A stage that fails is not to be built upon: what comes after it is still shown, but the path ends there.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{
    Rate, Study, check_dimensions, dimensions, mean_with_error, rate, reference, root_mean_square,
};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{Counts, parameters};
use crate::points::slab;
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::inference;

/// The kind `worked-path`.
pub static WORKED_PATH: WorkedPathKind = WorkedPathKind;

/// The kind of experiment that swaps the numbers under an estimator.
pub struct WorkedPathKind;

static ABOUT: About = About {
    key: "worked-path",
    title: "A worked path",
    summary: "An estimator with random numbers, then with each of several samplers, tested at every stage: z, chi-square, slope.",
    file: "kinds/worked_path.rs",
    source: include_str!("worked_path.rs"),
    papers: &[],
};

/// The probability below which chance is no excuse.
const PROBABILITY: f64 = 1e-6;

parameters! {
    /// What a worked path can choose.
    pub struct WorkedPath {
        /// The stages: random numbers first, then what replaces them, each with an optional scramble.
        samplers: Vec<Method> [or sampler] = ["independent", "jittered", "halton+owen", "sobol+owen"],
        /// What is integrated over the unit cube.
        integrand: Function,
        /// The counts N over which the error is followed; the tests are made at the largest.
        n: Counts [in 1..=65_536] = "4^2..4^5",
        /// In how many independent randomisations each stage runs.
        replicates: usize [in 10..=10_000] = 64,
        /// Into how many bins the chi-square test sorts the samples.
        bins: usize [in 2..=200] = 32,
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=64],
    }
}

/// The stages and what the tests say of them.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    stages: Vec<Stage>,
}

/// One stage.
#[derive(Debug, Serialize, Deserialize)]
struct Stage {
    method: String,
    title: String,
    mean: f64,
    error: Option<f64>,
    /// The probabilities of the z-test and of the chi-square test by chance.
    z: Option<f64>,
    z_probability: f64,
    chi_square: f64,
    rmse: f64,
    rate: Option<Rate>,
}

impl Stage {
    fn passes(&self) -> bool {
        self.z_probability >= PROBABILITY && self.chi_square >= PROBABILITY
    }
}

impl Kind for WorkedPathKind {
    type Parameters = WorkedPath;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut WorkedPath) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions));
    }

    fn check(&self, p: &WorkedPath, problems: &mut Problems<'_, '_>) {
        check_dimensions(&p.integrand, p.dimensions, problems);
        problems.admit("samplers", &p.samplers, p.n.as_slice(), dimensions(&p.integrand, p.dimensions));
        for (index, method) in p.samplers.iter().enumerate().filter(|(_, method)| !method.is_random()) {
            let message = format!("`{}` gives one estimate for every seed: it has no z-score", method.name());
            let help = "scramble it, as in `sobol+owen`".to_owned();
            problems.element("samplers", index, Code::Combination, message, Some(help));
        }
    }

    fn weight(&self, p: &WorkedPath) -> u64 {
        p.n.total().saturating_mul(2 * p.replicates as u64).saturating_mul(p.samplers.len() as u64)
    }

    fn run(&self, p: &WorkedPath, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let exact = reference(&p.integrand, d)?.value;
        let all = study.estimates(&p.samplers, p.n.as_slice(), p.replicates)?;
        let stages = p.samplers.iter().zip(&all).map(|(method, estimates)| {
            let errors = |estimates: &[f64]| estimates.iter().map(|estimate| estimate - exact).collect::<Vec<_>>();
            let marks: Vec<(f64, f64)> =
                p.n.iter().zip(estimates).map(|(n, one)| (n as f64, root_mean_square(&errors(one)).0)).collect();
            let (mean, error) = mean_with_error(estimates.last().map_or(&[][..], Vec::as_slice));
            let z = error.filter(|error| *error > 0.0).map(|error| (mean - exact) / error);
            Ok(Stage {
                method: method.name(),
                title: method.title(),
                mean,
                error,
                z,
                z_probability: z.map_or(f64::from(mean == exact), |z| tail(z, p.replicates)),
                chi_square: chi_square(p, &study, method)?,
                rmse: marks.last().map_or(f64::NAN, |mark| mark.1),
                rate: rate(marks),
            })
        });
        Ok(Data { exact, stages: stages.collect::<Result<_, Failure>>()? })
    }

    fn values(&self, _: &WorkedPath, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        let first = data.stages.first().map_or(f64::NAN, |stage| stage.rmse);
        for stage in &data.stages {
            let name = &stage.method;
            values.estimate(format!("mean.{name}"), stage.mean, stage.error.unwrap_or(f64::NAN));
            values.number(format!("z.{name}"), stage.z.unwrap_or(f64::NAN));
            values.number(format!("p.{name}"), stage.z_probability);
            values.number(format!("chi-square.{name}"), stage.chi_square);
            values.number(format!("rmse.{name}"), stage.rmse);
            values.number(format!("gain.{name}"), first / stage.rmse);
            if let Some(rate) = stage.rate {
                values.estimate(format!("slope.{name}"), rate.slope, rate.error.unwrap_or(f64::NAN));
            }
            values.boolean(format!("passes.{name}"), stage.passes());
        }
        values.boolean("passes", data.stages.iter().all(Stage::passes));
        values
    }

    fn tables(&self, _: &WorkedPath, data: &Data) -> Vec<Frame> {
        let stages = || data.stages.iter();
        let frame = Frame::new("stages")
            .text("sampler", stages().map(|stage| stage.method.clone()))
            .numbers("mean", stages().map(|stage| stage.mean))
            .numbers("standard error", stages().map(|stage| stage.error.unwrap_or(f64::NAN)))
            .numbers("z", stages().map(|stage| stage.z.unwrap_or(f64::NAN)))
            .numbers("chi-square probability", stages().map(|stage| stage.chi_square))
            .numbers("rmse", stages().map(|stage| stage.rmse))
            .numbers("slope", stages().map(|stage| stage.rate.map_or(f64::NAN, |rate| rate.slope)));
        vec![frame]
    }

    fn draw(&self, _: &WorkedPath, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(data))
    }

    fn alt(&self, p: &WorkedPath, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The probability of a z-score at least as far off, by Student's t of so many estimates.
fn tail(z: f64, replicates: usize) -> f64 {
    2.0 * inference::t_distribution(-z.abs(), replicates.saturating_sub(1).max(1) as f64)
}

/// The probability of the chi-square test of the first coordinates of all samples at the largest count.
fn chi_square(p: &WorkedPath, study: &Study<'_>, method: &Method) -> Result<f64, Failure> {
    let n = p.n.largest();
    let count = |replicate: usize| -> Result<Vec<u64>, Failure> {
        let mut counts = vec![0; p.bins];
        study.points(method, n, study.stream(method, n, replicate))?.axis(0).for_each(|u| counts[slab(u, p.bins)] += 1);
        Ok(counts)
    };
    let counts: Vec<Result<Vec<u64>, Failure>> = (0..p.replicates).into_par_iter().map(piece(count)).collect();
    let mut total = vec![0; p.bins];
    for counts in counts {
        total.iter_mut().zip(counts?).for_each(|(total, count)| *total += count);
    }
    Ok(inference::chi_square(&total).map_or(f64::NAN, |verdict| verdict.probability))
}

mod drawing {
    //! The table of stages, and its words.

    use std::fmt::Write as _;

    use super::{Data, WorkedPath};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Cell, Column, Drawing, Table};

    pub(super) fn draw(data: &Data) -> Drawing {
        let mut table = Table::new(vec![
            Column::left("Numbers"),
            Column::left("Mean"),
            Column::right("$z$"),
            Column::right("$\\chi^2$: $p$"),
            Column::right("Slope"),
            Column::left("Verdict"),
        ]);
        for stage in &data.stages {
            table.push([
                Cell::text(&stage.title),
                Cell::estimate(stage.mean, stage.error.unwrap_or(f64::NAN)),
                stage.z.map_or(Cell::Empty, |z| Cell::fixed(z, 2)),
                Cell::fixed(stage.chi_square, 3),
                stage.rate.map_or(Cell::Empty, |rate| Cell::fixed(rate.slope, 2)),
                Cell::text(if stage.passes() { "passes" } else { "fails" }),
            ]);
        }
        table.push([Cell::text("exact"), Cell::significant(data.exact, 8)]);
        table.footers = 1;
        Drawing::Table(table)
    }

    pub(super) fn alt(p: &WorkedPath, data: &Data) -> String {
        let mut text = format!(
            "One estimator of the integral of {}, exactly {}, with the numbers swapped under it, tested at N = {} in {} randomisations.",
            p.integrand.text(),
            significant(data.exact, 6),
            integer(p.n.largest() as i64),
            p.replicates,
        );
        for stage in &data.stages {
            let _ = write!(text, " {}: ", stage.title);
            if let Some(z) = stage.z {
                let _ = write!(text, "z {}, ", fixed(z, 2));
            }
            let _ = write!(
                text,
                "chi-square probability {}, RMSE {}",
                significant(stage.chi_square, 2),
                significant(stage.rmse, 2)
            );
            if let Some(rate) = stage.rate {
                let _ = write!(text, ", slope {}", fixed(rate.slope, 2));
            }
            let _ = write!(text, "; it {}.", if stage.passes() { "passes" } else { "fails" });
        }
        text
    }
}
