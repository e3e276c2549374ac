//! Bias: a right estimator, biased but consistent ones, and plainly wrong ones, over N.
//!
//! All estimate the integral of f over [0, 1] from samples X of a density p, with weights w = f / p. Their limits: all that are
//! consistent tend to the integral; without the division by p the mean tends to the integral of f p, clamped weights to a smaller
//! number. Each runs over the same samples, so that what differs is the formula alone.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Density, Rate, check_density, mean_with_error, rate, root_mean_square};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::integrands::Function;
use crate::parameters::{Counts, choices, parameters};
use crate::seed::Seed;
use crate::stats::moments::Sum;
use crate::stats::quadrature;

/// The kind `bias`.
pub static BIAS: BiasKind = BiasKind;

/// The kind of experiment that compares estimators.
pub struct BiasKind;

static ABOUT: About = About {
    key: "bias",
    title: "Bias",
    summary: "Estimators of one integral from the same samples over N: the mean with its error, the bias and the RMSE of each.",
    file: "kinds/bias.rs",
    source: include_str!("bias.rs"),
    papers: &[Paper {
        authors: "A. B. Owen",
        year: 2013,
        title: "Monte Carlo Theory, Methods and Examples",
        venue: "https://artowen.su.domains/mc/",
        doi: None,
    }],
};

choices! {
    /// A formula for the integral of f from samples of p.
    pub enum Estimator {
        /// The mean of f / p: unbiased and consistent.
        Unbiased = "unbiased",
        /// The sum of f / p over the sum of 1 / p: biased as 1 / N, consistent.
        Ratio = "ratio",
        /// The sum of f / p over N + 1: biased as 1 / N, consistent.
        Shrunk = "shrunk",
        /// The weight of the first sample alone: unbiased, not consistent.
        First = "first",
        /// The mean of f / p, with weights above `clamp` times the integral cut off: biased for every N.
        Clamped = "clamped",
        /// The mean of f, the division by p forgotten: wrong for every N.
        NoDensity = "no-density",
    }
}

parameters! {
    /// What a comparison of estimators can choose.
    pub struct Bias {
        /// What is integrated over [0, 1], of one variable.
        integrand: Function,
        /// The density of the samples on [0, 1], as an expression in x up to its factor.
        density: Function = "0.25 + x",
        /// The estimators.
        estimators: Vec<Estimator> [or estimator] = ["unbiased", "ratio", "no-density"],
        /// The numbers of samples N.
        n: Counts [in 1..=65_536] = "2^0..2^10",
        /// Over how many runs bias and error are measured.
        replicates: usize [in 10..=1_000_000] = 2000,
        /// At how many times the integral weights are clamped.
        clamp: f64 [in 0.01..=1000.0] = 1.5,
    }
}

/// The biases and errors.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    curves: Vec<Curve>,
}

/// One estimator.
#[derive(Debug, Serialize, Deserialize)]
struct Curve {
    name: String,
    /// What it tends to.
    limit: f64,
    marks: Vec<Mark>,
    rate: Option<Rate>,
}

/// One estimator at one N.
#[derive(Debug, Serialize, Deserialize)]
struct Mark {
    n: u64,
    mean: f64,
    mean_error: f64,
    rmse: f64,
    rmse_error: f64,
}

impl Kind for BiasKind {
    type Parameters = Bias;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Bias, problems: &mut Problems<'_, '_>) {
        check_density(&p.integrand, "integrand", None, problems);
        check_density(&p.density, "density", None, problems);
    }

    fn weight(&self, p: &Bias) -> u64 {
        p.n.total().saturating_mul(20 * p.replicates as u64)
    }

    fn run(&self, p: &Bias, seed: Seed) -> Result<Data, Failure> {
        let law = Density::new(&p.density, 0.0, 1.0, "density")?;
        let unknown = || {
            Failure::of("integrand", format!("the integral of `{}` is not known exactly enough", p.integrand.text()))
                .help("choose a smooth function of one variable")
        };
        let exact = p.integrand.integral(1).filter(|exact| exact.value.is_finite()).ok_or_else(unknown)?.value;
        let cap = p.clamp * exact;
        let limits = p.estimators.iter().map(|&estimator| limit(estimator, p, &law, exact, cap));
        let limits = limits.collect::<Option<Vec<_>>>().ok_or_else(unknown)?;
        let runs: Vec<Vec<Vec<f64>>> =
            p.n.as_slice()
                .par_iter()
                .map(|&n| {
                    let run = |replicate| estimates(p, &law, n, cap, seed.named(ABOUT.key).at(n as u64).at(replicate));
                    (0..p.replicates as u64).into_par_iter().map(piece(run)).collect()
                })
                .collect();
        let curves = p.estimators.iter().zip(limits).enumerate().map(|(index, (estimator, limit))| {
            let marks: Vec<Mark> =
                p.n.iter().zip(&runs).map(|(n, runs)| mark(n, runs.iter().map(|run| run[index]), exact)).collect();
            let rate = rate(marks.iter().map(|mark| (mark.n as f64, mark.rmse)));
            Curve { name: estimator.word().to_owned(), limit, marks, rate }
        });
        let curves: Vec<Curve> = curves.collect();
        if curves.iter().flat_map(|curve| &curve.marks).any(|mark| !mark.mean.is_finite()) {
            let message = format!("f / p is not finite for `{}`", p.density.text());
            return Err(Failure::of("density", message).help("choose a density that is positive wherever f is not 0"));
        }
        Ok(Data { exact, curves })
    }

    fn values(&self, _: &Bias, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        // What a bias is held against: `agrees = "none"`.
        values.number("none", 0.0);
        for curve in &data.curves {
            let name = &curve.name;
            values.number(format!("limit.{name}"), curve.limit);
            values.number(format!("offset.{name}"), curve.limit - data.exact);
            for mark in &curve.marks {
                let n = mark.n;
                values.estimate(format!("bias.{name}.{n}"), mark.mean - data.exact, mark.mean_error);
                values.estimate(format!("mean.{name}.{n}"), mark.mean, mark.mean_error);
                values.estimate(format!("rmse.{name}.{n}"), mark.rmse, mark.rmse_error);
                values.number(format!("z.{name}.{n}"), (mark.mean - data.exact) / mark.mean_error);
            }
            if let Some(rate) = curve.rate {
                values.estimate(format!("slope.{name}"), rate.slope, rate.error.unwrap_or(f64::NAN));
            }
            // Only where a bias is told from chance does it say how it falls.
            let told = curve.marks.iter().map(|mark| (mark, (mark.mean - data.exact).abs()));
            let told = told.filter(|(mark, bias)| *bias > 6.0 * mark.mean_error);
            let told: Vec<(f64, f64)> = told.map(|(mark, bias)| (mark.n as f64, bias)).collect();
            if let Some(rate) = rate(told.iter().copied()).filter(|_| told.len() > 2) {
                values.estimate(format!("slope.bias.{name}"), rate.slope, rate.error.unwrap_or(f64::NAN));
            }
        }
        values
    }

    fn tables(&self, _: &Bias, data: &Data) -> Vec<Frame> {
        let rows = || data.curves.iter().flat_map(|curve| curve.marks.iter().map(move |mark| (curve, mark)));
        let frame = Frame::new("bias")
            .text("estimator", rows().map(|(curve, _)| curve.name.clone()))
            .counts("n", rows().map(|(_, mark)| mark.n as usize))
            .numbers("mean", rows().map(|(_, mark)| mark.mean))
            .numbers("bias", rows().map(|(_, mark)| mark.mean - data.exact))
            .numbers("bias standard error", rows().map(|(_, mark)| mark.mean_error))
            .numbers("rmse", rows().map(|(_, mark)| mark.rmse))
            .numbers("rmse standard error", rows().map(|(_, mark)| mark.rmse_error));
        vec![frame]
    }

    fn draw(&self, p: &Bias, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Bias, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

/// What an estimator tends to as N grows; of the first sample alone, which tends to nothing, its mean.
fn limit(estimator: Estimator, p: &Bias, law: &Density, exact: f64, cap: f64) -> Option<f64> {
    let of = |g: &dyn Fn(f64, f64) -> f64| {
        quadrature::integrate(1, |u| g(p.integrand.evaluate(u), law.height(u[0]))).map(|integral| integral.value)
    };
    match estimator {
        Estimator::NoDensity => of(&|f, height| f * height),
        // A kink is no jump: the quadrature settles, if slowly.
        Estimator::Clamped => of(&|f, height| f.min(cap * height)),
        Estimator::Unbiased | Estimator::Ratio | Estimator::Shrunk | Estimator::First => Some(exact),
    }
}

/// Each estimator's estimate from the same `n` samples, in the order of the parameter.
fn estimates(p: &Bias, law: &Density, n: usize, cap: f64, stream: Seed) -> Vec<f64> {
    let mut random = stream.generator();
    let (mut weights, mut heights, mut inverses, mut clamped) =
        (Sum::default(), Sum::default(), Sum::default(), Sum::default());
    let mut first = None;
    for _ in 0..n {
        let x = law.inverse(random.uniform());
        let (f, height) = (p.integrand.evaluate(&[x]), law.height(x));
        let weight = f / height;
        first.get_or_insert(weight);
        weights.add(weight);
        heights.add(f);
        inverses.add(1.0 / height);
        clamped.add(weight.min(cap));
    }
    let count = n as f64;
    let estimate = |estimator: &Estimator| match estimator {
        Estimator::Unbiased => weights.value() / count,
        Estimator::Ratio => weights.value() / inverses.value(),
        Estimator::Shrunk => weights.value() / (count + 1.0),
        Estimator::First => first.unwrap_or(f64::NAN),
        Estimator::Clamped => clamped.value() / count,
        Estimator::NoDensity => heights.value() / count,
    };
    p.estimators.iter().map(estimate).collect()
}

/// Mean and error of the estimates of one estimator with n samples each.
fn mark(n: usize, estimates: impl Iterator<Item = f64>, exact: f64) -> Mark {
    let estimates: Vec<f64> = estimates.collect();
    let errors: Vec<f64> = estimates.iter().map(|estimate| estimate - exact).collect();
    let (mean, mean_error) = mean_with_error(&estimates);
    let (rmse, rmse_error) = root_mean_square(&errors);
    let none = f64::NAN;
    Mark { n: n as u64, mean, mean_error: mean_error.unwrap_or(none), rmse, rmse_error: rmse_error.unwrap_or(none) }
}

mod drawing {
    //! The drawing of biases and errors over N, and its words.

    use std::fmt::Write as _;

    use super::{Bias, Curve, Data, Mark};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Chart, ChartError, Drawing, ErrorBars, Key, Line, Panel, Sheet, Style};

    pub(super) fn draw(p: &Bias, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let styled = || data.curves.iter().enumerate().map(|(index, curve)| (curve, Style::nth(index)));
        let ends = (p.n.iter().next().unwrap_or(1) as f64, p.n.largest() as f64);
        let mut means = Panel::new(Axis::log2("*N*"), Axis::linear("mean of the estimates"))
            .title("Mean: what bias looks like")
            .ratio(0.85)
            .with(Line::new(vec![(ends.0, data.exact), (ends.1, data.exact)]).style(Style::EXACT).label("exact"));
        for (curve, style) in styled() {
            let bar =
                |mark: &Mark| (mark.n as f64, mark.mean - 2.0 * mark.mean_error, mark.mean + 2.0 * mark.mean_error);
            means = means
                .with(ErrorBars::new(curve.marks.iter().map(bar).collect()).style(style))
                .with(line(curve, style, |mark| mark.mean).label(title(&curve.name)));
        }
        let errors = Panel::new(Axis::log2("*N*"), Axis::log("RMSE"))
            .title("Error: bias is where it stops falling")
            .ratio(0.85)
            .with_all(styled().map(|(curve, style)| line(curve, style, |mark| mark.rmse)));
        Ok(Chart::grid(vec![means, errors]).columns(2).key(Key::Above).draw(sheet)?.into())
    }

    fn line(curve: &Curve, style: Style, height: impl Fn(&Mark) -> f64) -> Line {
        Line::new(curve.marks.iter().map(|mark| (mark.n as f64, height(mark))).collect()).style(style).marked()
    }

    /// What an estimator is called in a key.
    fn title(name: &str) -> &'static str {
        match name {
            "unbiased" => "mean of *f*/*p*",
            "ratio" => "self-normalised",
            "shrunk" => "divided by *N* + 1",
            "first" => "first sample",
            "clamped" => "clamped",
            _ => "without 1/*p*",
        }
    }

    pub(super) fn alt(p: &Bias, data: &Data) -> Option<String> {
        let (first, last) = (p.n.iter().next()?, p.n.largest());
        let mut text = format!(
            "Mean and error over N, from {} to {}, of {} estimators of the integral of {}, exactly {}, each over {} runs.",
            integer(first as i64),
            integer(last as i64),
            data.curves.len(),
            p.integrand.text(),
            significant(data.exact, 5),
            integer(p.replicates as i64),
        );
        for curve in &data.curves {
            let (from, to) = (curve.marks.first()?, curve.marks.last()?);
            let _ = write!(
                text,
                " {}: bias {} at N = {}, {} ± {} at {}; RMSE {}",
                curve.name,
                significant(from.mean - data.exact, 2),
                integer(first as i64),
                significant(to.mean - data.exact, 2),
                significant(to.mean_error, 1),
                integer(last as i64),
                significant(to.rmse, 2),
            );
            if let Some(rate) = curve.rate {
                let _ = write!(text, ", slope {}", fixed(rate.slope, 2));
            }
            text.push('.');
        }
        Some(text)
    }
}
