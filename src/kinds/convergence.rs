//! Convergence: the root mean square error of an estimate over the number of points, on logarithmic axes.
//!
//! Every sampler estimates the same integral R times with N points. Over the counts N, the errors of a sampler fall along a
//! line whose slope is its rate; the slope is fitted by least squares to log2 of the error over log2 of N. A sequence that no
//! seed changes has one error for each N, and its absolute value stands for the root mean square.
//!
//! An error that is zero, or not larger than the error of the reference itself, says nothing of the rate and has no place on
//! a logarithmic axis: it is left out of the fit and the drawing, and counted in the value `unresolved`.

use serde::{Deserialize, Serialize};

use super::estimation::{Study, check_dimensions, dimensions, mean_with_error, reference};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::integrands::Function;
use crate::parameters::{Counts, parameters};
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::{portable, regression};

/// The kind `convergence`.
pub static CONVERGENCE: ConvergenceKind = ConvergenceKind;

/// The kind of experiment that measures rates of convergence.
pub struct ConvergenceKind;

static ABOUT: About = About {
    key: "convergence",
    title: "Convergence",
    summary: "The root mean square error over N of one integrand for several samplers, with fitted slopes.",
    file: "kinds/convergence.rs",
    source: include_str!("convergence.rs"),
    papers: &[],
};

parameters! {
    /// What a study of convergence can choose.
    pub struct Convergence {
        /// The samplers to compare, each with an optional scramble.
        samplers: Vec<Method> [or sampler],
        /// What is integrated over the unit cube.
        integrand: Function,
        /// The counts N at which the error is measured.
        n: Counts [in 1..=16_777_216] = "2^4..2^14",
        /// Over how many independent estimates each error is measured.
        replicates: usize [in 2..=1_000_000] = 64,
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=64],
        /// The slopes of the reference lines beside the data.
        @drawn slopes: Vec<f64> [in -10.0..=0.0] = [-0.5],
    }
}

/// The errors of every sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    /// The variance of the integrand, where it is known.
    variance: Option<f64>,
    curves: Vec<Curve>,
}

/// The errors of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Curve {
    method: String,
    title: String,
    replicates: u32,
    marks: Vec<Mark>,
    /// Slope, its standard error and the intercept of log2 of the error over log2 of N.
    fit: Option<(f64, Option<f64>, f64)>,
}

/// The error at one count.
#[derive(Debug, Serialize, Deserialize)]
struct Mark {
    n: u64,
    rmse: f64,
    rmse_error: Option<f64>,
    mean: f64,
    mean_error: Option<f64>,
    /// Whether the error is large enough to be told from the error of the reference.
    resolved: bool,
}

impl Kind for ConvergenceKind {
    type Parameters = Convergence;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Convergence) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions));
    }

    fn check(&self, p: &Convergence, problems: &mut Problems<'_, '_>) {
        check_dimensions(&p.integrand, p.dimensions, problems);
        problems.admit("samplers", &p.samplers, p.n.as_slice(), dimensions(&p.integrand, p.dimensions));
    }

    fn weight(&self, p: &Convergence) -> u64 {
        p.n.total().saturating_mul(p.replicates as u64).saturating_mul(p.samplers.len() as u64)
    }

    fn run(&self, p: &Convergence, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let exact = reference(&p.integrand, d)?;
        let floor = exact.error.max(exact.value.abs() * 1e-15);
        let all = study.estimates(&p.samplers, p.n.as_slice(), p.replicates)?;
        let curve = |(method, estimates): (&Method, Vec<Vec<f64>>)| {
            let replicates = estimates.first().map_or(0, Vec::len) as u32;
            let marks: Vec<Mark> =
                p.n.iter().zip(&estimates).map(|(n, estimates)| mark(n, estimates, exact.value, floor)).collect();
            Curve { method: method.name(), title: method.title(), replicates, fit: fit(&marks), marks }
        };
        let curves: Vec<Curve> = p.samplers.iter().zip(all).map(curve).collect();
        if !curves.iter().flat_map(|curve| &curve.marks).any(|mark| mark.resolved) {
            let message = format!("every estimate of `{}` is exact: there is no error to follow", p.integrand.text());
            return Err(Failure::of("integrand", message).help("choose an integrand that varies"));
        }
        Ok(Data { exact: exact.value, variance: p.integrand.variance(d), curves })
    }

    fn values(&self, _: &Convergence, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        if let Some(variance) = data.variance {
            values.number("sigma", variance.max(0.0).sqrt());
        }
        for curve in &data.curves {
            let name = &curve.method;
            for mark in &curve.marks {
                let n = mark.n;
                values.estimate(format!("rmse.{name}.{n}"), mark.rmse, mark.rmse_error.unwrap_or(f64::NAN));
                values.estimate(format!("mean.{name}.{n}"), mark.mean, mark.mean_error.unwrap_or(f64::NAN));
            }
            if let Some((slope, error, _)) = curve.fit {
                let error = error.unwrap_or(f64::NAN);
                values.estimate(format!("slope.{name}"), slope, error);
                // What four times the points divide the error by, along the fitted line.
                let fourfold = portable::pow(4.0, -slope);
                values.estimate(format!("fourfold.{name}"), fourfold, fourfold * portable::ln(4.0) * error);
            }
            let unresolved = curve.marks.iter().filter(|mark| !mark.resolved).count();
            values.integer(format!("unresolved.{name}"), unresolved as i64);
        }
        if let Some((first, others)) = data.curves.split_first()
            && let Some(from) = first.end()
        {
            others.iter().filter_map(|curve| Some((curve, curve.end()?))).for_each(|(curve, to)| {
                values.number(format!("gain.{}", curve.method), from / to);
            });
        }
        if let Some((best, worst)) = extremes(data) {
            values.text("best", best.0);
            values.number("gain", worst.1 / best.1);
        }
        values
    }

    fn tables(&self, _: &Convergence, data: &Data) -> Vec<Frame> {
        let rows = || data.curves.iter().flat_map(|curve| curve.marks.iter().map(move |mark| (curve, mark)));
        let errors = Frame::new("rmse")
            .text("sampler", rows().map(|(curve, _)| curve.method.clone()))
            .counts("n", rows().map(|(_, mark)| mark.n as usize))
            .numbers("rmse", rows().map(|(_, mark)| mark.rmse))
            .numbers("rmse standard error", rows().map(|(_, mark)| mark.rmse_error.unwrap_or(f64::NAN)))
            .numbers("mean", rows().map(|(_, mark)| mark.mean))
            .numbers("mean standard error", rows().map(|(_, mark)| mark.mean_error.unwrap_or(f64::NAN)));
        let fitted = || data.curves.iter().filter_map(|curve| curve.fit.map(|fit| (curve, fit)));
        let slopes = Frame::new("slopes")
            .text("sampler", fitted().map(|(curve, _)| curve.method.clone()))
            .numbers("slope", fitted().map(|(_, fit)| fit.0))
            .numbers("slope standard error", fitted().map(|(_, fit)| fit.1.unwrap_or(f64::NAN)));
        vec![errors, slopes]
    }

    fn draw(&self, p: &Convergence, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Convergence, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

impl Curve {
    /// The error at the largest count, if it is resolved.
    fn end(&self) -> Option<f64> {
        self.marks.last().filter(|mark| mark.resolved).map(|mark| mark.rmse)
    }
}

/// The error of `estimates` with n points each.
fn mark(n: usize, estimates: &[f64], exact: f64, floor: f64) -> Mark {
    let (mean, mean_error) = mean_with_error(estimates);
    let squares: Vec<f64> = estimates.iter().map(|estimate| (estimate - exact) * (estimate - exact)).collect();
    let (square, square_error) = mean_with_error(&squares);
    let rmse = square.sqrt();
    let resolved = rmse > floor;
    // The derivative of the root carries the error of the mean square over to the root.
    let rmse_error = square_error.filter(|_| resolved).map(|error| error / (2.0 * rmse));
    Mark { n: n as u64, rmse, rmse_error, mean, mean_error, resolved }
}

/// The line through the resolved errors on logarithmic axes.
fn fit(marks: &[Mark]) -> Option<(f64, Option<f64>, f64)> {
    let resolved = || marks.iter().filter(|mark| mark.resolved);
    let x: Vec<f64> = resolved().map(|mark| portable::log2(mark.n as f64)).collect();
    let y: Vec<f64> = resolved().map(|mark| portable::log2(mark.rmse)).collect();
    let line = regression::least_squares(&x, &y)?;
    let error = Some(line.slope_error).filter(|error| error.is_finite() && x.len() > 2);
    line.slope.is_finite().then_some((line.slope, error, line.intercept))
}

/// A sampler and its error.
type Rank<'a> = (&'a str, f64);

/// The sampler with the smallest error at the largest count, and the one with the largest, where both are resolved.
fn extremes(data: &Data) -> Option<(Rank<'_>, Rank<'_>)> {
    let ends = || data.curves.iter().filter_map(|curve| Some((curve.method.as_str(), curve.end()?)));
    let best = ends().min_by(|a, b| a.1.total_cmp(&b.1))?;
    let worst = ends().max_by(|a, b| a.1.total_cmp(&b.1))?;
    (best.0 != worst.0).then_some((best, worst))
}

mod drawing {
    //! The drawing of errors over N, and its words.

    use std::fmt::Write as _;

    use super::{Convergence, Curve, Data, extremes};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Chart, ChartError, Drawing, Line, Panel, Sheet, Style};

    pub(super) fn draw(p: &Convergence, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let title = if data.curves.iter().all(|curve| curve.replicates == 1) { "absolute error" } else { "RMSE" };
        let panel = Panel::new(Axis::log2("*N*"), Axis::log(title)).ratio(0.62);
        let panel = panel.with_all(references(p, data)).with_all(data.curves.iter().map(line));
        Ok(Chart::new(panel).draw(sheet)?.into())
    }

    /// The errors of one sampler, without those that have no place on a logarithmic axis.
    fn line(curve: &Curve) -> Line {
        let points = curve.marks.iter().filter(|mark| mark.resolved).map(|mark| (mark.n as f64, mark.rmse)).collect();
        let label = match curve.fit {
            Some((slope, ..)) => format!("{} ({})", curve.title, fixed(slope, 2)),
            None => curve.title.clone(),
        };
        Line::new(points).style(Style::of(&curve.method)).marked().label(label)
    }

    /// The reference slopes: that of independent samples at its predicted height, the others through the first error.
    fn references(p: &Convergence, data: &Data) -> Vec<Line> {
        let (Some(first), Some(last)) = (p.n.iter().next(), p.n.iter().last()) else { return Vec::new() };
        let (x0, x1) = (first as f64, last as f64);
        let start = data.curves.iter().filter_map(|curve| curve.marks.first()).filter(|mark| mark.resolved);
        let highest = start.map(|mark| mark.rmse).max_by(f64::total_cmp);
        let predicted = data.variance.map(|variance| (variance / x0).sqrt()).filter(|height| *height > 0.0);
        let reference = |&slope: &f64| {
            let height = if slope == -0.5 { predicted.or(highest) } else { highest.or(predicted) };
            height.map(|height| Line::power(x0, height, slope, x1).label(format!("slope {}", shortest(slope))))
        };
        if first == last { Vec::new() } else { p.slopes.iter().filter_map(reference).collect() }
    }

    /// A slope with as many decimals as it needs, at most three.
    fn shortest(slope: f64) -> String {
        let exact = |places: &usize| format!("{slope:.places$}").parse() == Ok(slope);
        fixed(slope, (0..3).find(exact).unwrap_or(3))
    }

    pub(super) fn alt(p: &Convergence, data: &Data) -> Option<String> {
        let (first, last) = (p.n.iter().next()?, p.n.iter().last()?);
        let mut text = format!(
            "The error of the estimate of the integral of {} over N, from {} to {} points, on logarithmic axes.",
            p.integrand.text(),
            integer(first as i64),
            integer(last as i64),
        );
        for curve in &data.curves {
            let resolved = || curve.marks.iter().filter(|mark| mark.resolved);
            let (Some(from), Some(to)) = (resolved().next(), resolved().next_back()) else {
                let _ = write!(text, " {}: no error at all.", curve.title);
                continue;
            };
            let _ = write!(text, " {}: {} at N = {}", curve.title, significant(from.rmse, 2), integer(from.n as i64));
            if to.n > from.n {
                let _ = write!(text, ", {} at {}", significant(to.rmse, 2), integer(to.n as i64));
            }
            if let Some((slope, error, _)) = curve.fit {
                let _ = write!(text, "; slope {}", fixed(slope, 2));
                if let Some(error) = error {
                    let _ = write!(text, " ± {}", fixed(error, 2));
                }
            }
            text.push('.');
        }
        if let Some((best, worst)) = extremes(data) {
            let title = |name: &str| {
                data.curves
                    .iter()
                    .find(|curve| curve.method == name)
                    .map_or(name.to_owned(), |curve| curve.title.clone())
            };
            let _ = write!(
                text,
                " At the largest N the smallest error is that of {}, {} times smaller than that of {}.",
                title(best.0),
                significant(worst.1 / best.1, 2),
                title(worst.0),
            );
        }
        Some(text)
    }
}
