//! Convergence: the root mean square error of an estimate over the number of points, on logarithmic axes.
//!
//! Every sampler estimates the same integral R times with N points. Over the counts N, the errors of a sampler fall along a line whose
//! slope is its rate; it is fitted by least squares to log2 of the error over log2 of N. A sequence that no seed changes has one error for
//! each N, and its absolute value stands for the root mean square. Several integrands are a panel each.
//!
//! An error that is zero, or not larger than that of the reference itself, says nothing of the rate and has no place on a logarithmic
//! axis: it is left out of the fit and the drawing, and counted. Nets are whole only at the powers of their base: on demand the powers
//! alone are fitted and marked, and the counts between them are a thin line with a slope of its own.

use serde::{Deserialize, Serialize};

use super::estimation::{check_dimensions, dimensions, estimates_of_all, mean_with_error, reference};
use super::{Failure, Frame, Kind, Problems, Rest, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{Counts, parameters};
use crate::samplers::Method;
use crate::samplers::digits::logarithm;
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
        /// What is integrated over the unit cube, one panel each.
        integrands: Vec<Function> [or integrand],
        /// The counts N at which the error is measured.
        n: Counts [in 1..=16_777_216] = "2^4..2^14",
        /// Over how many independent estimates each error is measured.
        replicates: usize [in 2..=1_000_000] = 64,
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=64],
        /// The base whose powers are fitted and marked, apart from the other counts.
        powers: Option<usize> [in 2..=64],
        /// The slopes of the reference lines beside the data.
        @drawn slopes: Vec<f64> [in -10.0..=0.0] = [-0.5],
    }
}

/// The errors for every integrand.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    first: Errors,
    more: Rest<Errors>,
}

/// The errors of every sampler for one integrand.
#[derive(Debug, Serialize, Deserialize)]
struct Errors {
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
        if let [integrand] = &p.integrands[..] {
            p.dimensions = Some(dimensions(integrand, p.dimensions));
        }
    }

    fn check(&self, p: &Convergence, problems: &mut Problems<'_, '_>) {
        for integrand in &p.integrands {
            check_dimensions(integrand, p.dimensions, problems);
        }
        let mut all: Vec<usize> = p.integrands.iter().map(|integrand| dimensions(integrand, p.dimensions)).collect();
        all.sort_unstable();
        all.dedup();
        for d in all {
            problems.admit("samplers", &p.samplers, p.n.as_slice(), d);
        }
        if p.integrands.len() > 6 {
            let message =
                format!("{} integrands are more than the 6 panels that a figure can hold", p.integrands.len());
            problems.at("integrands", Code::OutOfRange, message, None);
        }
        if p.powers.is_some_and(|base| p.n.iter().filter(|&n| is_power(n, base)).count() < 2) {
            let message = "fewer than two of the counts are powers of the base, so that they have no slope";
            problems.at("powers", Code::Combination, message, Some("take more counts, or drop the line".to_owned()));
        }
    }

    fn weight(&self, p: &Convergence) -> u64 {
        let studies = (p.samplers.len() * p.integrands.len()) as u64;
        p.n.total().saturating_mul(p.replicates as u64).saturating_mul(studies)
    }

    fn run(&self, p: &Convergence, seed: Seed) -> Result<Data, Failure> {
        let asked = (&p.integrands[..], p.dimensions);
        let all = estimates_of_all(ABOUT.key, asked, &p.samplers, p.n.as_slice(), p.replicates, seed)?;
        let all = p.integrands.iter().zip(all).map(|(integrand, all)| errors(p, integrand, all));
        let mut all = all.collect::<Result<Vec<_>, _>>()?;
        if !all.iter().any(Errors::any) {
            let failure = Failure::of("integrand", "every estimate is exact: there is no error to follow");
            return Err(failure.help("choose an integrand that varies"));
        }
        let rest = all.split_off(1.min(all.len()));
        let first = all.pop().ok_or_else(|| Failure::of("integrands", "there is no integrand"))?;
        Ok(Data { first, more: Rest(rest) })
    }

    fn values(&self, p: &Convergence, data: &Data) -> Values {
        let mut values = Values::new();
        for (index, errors) in data.all().enumerate() {
            let end = panel(p, index);
            name_errors(p, errors, &end, &mut values);
            if let Some((first, others)) = errors.curves.split_first()
                && let Some(from) = first.end()
            {
                others.iter().filter_map(|curve| Some((curve, curve.end()?))).for_each(|(curve, to)| {
                    values.number(format!("gain.{}{end}", curve.method), from / to);
                });
            }
            if let Some([best, worst]) = extremes(errors) {
                values.text(format!("best{end}"), best.0);
                values.number(format!("gain{end}"), worst.1 / best.1);
            }
        }
        values
    }

    fn tables(&self, p: &Convergence, data: &Data) -> Vec<Frame> {
        let several = p.integrands.len() > 1;
        let panels = || p.integrands.iter().zip(data.all());
        let curves = || panels().flat_map(|(f, errors)| errors.curves.iter().map(move |curve| (f, curve)));
        let rows = || curves().flat_map(|(_, curve)| curve.marks.iter().map(move |mark| (curve, mark)));
        let named = |frame: Frame, names: Vec<String>| if several { frame.text("integrand", names) } else { frame };
        let texts = curves().flat_map(|(f, curve)| std::iter::repeat_n(f.text().to_owned(), curve.marks.len()));
        let errors = named(Frame::new("rmse"), texts.collect())
            .text("sampler", rows().map(|(curve, _)| curve.method.clone()))
            .counts("n", rows().map(|(_, mark)| mark.n as usize))
            .numbers("rmse", rows().map(|(_, mark)| mark.rmse))
            .numbers("rmse standard error", rows().map(|(_, mark)| mark.rmse_error.unwrap_or(f64::NAN)))
            .numbers("mean", rows().map(|(_, mark)| mark.mean))
            .numbers("mean standard error", rows().map(|(_, mark)| mark.mean_error.unwrap_or(f64::NAN)));
        let fitted = || curves().filter_map(|(f, curve)| curve.fit.map(|fit| (f, curve, fit)));
        let slopes = named(Frame::new("slopes"), fitted().map(|(f, ..)| f.text().to_owned()).collect())
            .text("sampler", fitted().map(|(_, curve, _)| curve.method.clone()))
            .numbers("slope", fitted().map(|(.., fit)| fit.0))
            .numbers("slope standard error", fitted().map(|(.., fit)| fit.1.unwrap_or(f64::NAN)));
        vec![errors, slopes]
    }

    fn draw(&self, p: &Convergence, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Convergence, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

impl Data {
    /// The errors for every integrand, in the order asked.
    fn all(&self) -> impl Iterator<Item = &Errors> {
        std::iter::once(&self.first).chain(&self.more.0)
    }
}

impl Curve {
    /// How many errors have no place on a logarithmic axis.
    fn left_out(&self) -> usize {
        self.marks.iter().filter(|mark| !mark.resolved).count()
    }

    /// The error at the largest count, if it is resolved.
    fn end(&self) -> Option<f64> {
        self.marks.last().filter(|mark| mark.resolved).map(|mark| mark.rmse)
    }
}

/// Whether `n` is a power of `base`.
fn is_power(n: usize, base: usize) -> bool {
    logarithm(n as u64, base as u32).is_some()
}

/// What ends the names of values of the integrand `index`: nothing if it is the only one.
fn panel(p: &Convergence, index: usize) -> String {
    let Some(integrand) = p.integrands.get(index).filter(|_| p.integrands.len() > 1) else { return String::new() };
    integrand.abouts().first().map_or(format!(".f{}", index + 1), |about| format!(".{}", about.key))
}

/// The errors of every sampler for one integrand.
fn errors(p: &Convergence, integrand: &Function, all: Vec<Vec<Vec<f64>>>) -> Result<Errors, Failure> {
    let d = dimensions(integrand, p.dimensions);
    let exact = reference(integrand, d)?;
    let floor = exact.error.max(exact.value.abs() * 1e-15);
    let curve = |(method, estimates): (&Method, Vec<Vec<f64>>)| {
        let replicates = estimates.first().map_or(0, Vec::len) as u32;
        let marks: Vec<Mark> =
            p.n.iter().zip(&estimates).map(|(n, estimates)| mark(n, estimates, exact.value, floor)).collect();
        let fit = fit(&marks, |n| p.powers.is_none_or(|base| is_power(n, base)));
        Curve { method: method.name(), title: method.title(), replicates, fit, marks }
    };
    let curves: Vec<Curve> = p.samplers.iter().zip(all).map(curve).collect();
    Ok(Errors { exact: exact.value, variance: integrand.variance(d), curves })
}

impl Errors {
    /// Whether there is any error to follow.
    fn any(&self) -> bool {
        self.curves.iter().flat_map(|curve| &curve.marks).any(|mark| mark.resolved)
    }
}

/// Names the errors of one integrand, with `end` behind every name.
fn name_errors(p: &Convergence, errors: &Errors, end: &str, values: &mut Values) {
    values.number(format!("exact{end}"), errors.exact);
    if let Some(variance) = errors.variance {
        values.number(format!("sigma{end}"), variance.max(0.0).sqrt());
    }
    for curve in &errors.curves {
        let name = &curve.method;
        for mark in &curve.marks {
            let n = mark.n;
            values.estimate(format!("rmse.{name}.{n}{end}"), mark.rmse, mark.rmse_error.unwrap_or(f64::NAN));
            values.estimate(format!("mean.{name}.{n}{end}"), mark.mean, mark.mean_error.unwrap_or(f64::NAN));
        }
        if let Some((slope, error, _)) = curve.fit {
            let error = error.unwrap_or(f64::NAN);
            values.estimate(format!("slope.{name}{end}"), slope, error);
            // What four times the points divide the error by, along the fitted line.
            let fourfold = portable::pow(4.0, -slope);
            values.estimate(format!("fourfold.{name}{end}"), fourfold, fourfold * portable::ln(4.0) * error);
        }
        if let Some(base) = p.powers
            && let Some((slope, error, _)) = fit(&curve.marks, |n| !is_power(n, base))
        {
            values.estimate(format!("slope.between.{name}{end}"), slope, error.unwrap_or(f64::NAN));
        }
        values.integer(format!("unresolved.{name}{end}"), curve.left_out() as i64);
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

/// The line through the resolved errors of the counts that are `chosen`, on logarithmic axes.
fn fit(marks: &[Mark], chosen: impl Fn(usize) -> bool) -> Option<(f64, Option<f64>, f64)> {
    let resolved = || marks.iter().filter(|mark| mark.resolved && chosen(mark.n as usize));
    let x: Vec<f64> = resolved().map(|mark| portable::log2(mark.n as f64)).collect();
    let y: Vec<f64> = resolved().map(|mark| portable::log2(mark.rmse)).collect();
    let line = regression::least_squares(&x, &y)?;
    let error = Some(line.slope_error).filter(|error| error.is_finite() && x.len() > 2);
    line.slope.is_finite().then_some((line.slope, error, line.intercept))
}

/// The sampler with the smallest error at the largest count, and the one with the largest, where both are resolved.
fn extremes(errors: &Errors) -> Option<[(&str, f64); 2]> {
    let ends = || errors.curves.iter().filter_map(|curve| Some((curve.method.as_str(), curve.end()?)));
    let [best, worst] = [ends().min_by(|a, b| a.1.total_cmp(&b.1))?, ends().max_by(|a, b| a.1.total_cmp(&b.1))?];
    (best.0 != worst.0).then_some([best, worst])
}

mod drawing {
    //! The drawing of errors over N, and its words.

    use std::fmt::Write as _;

    use super::{Convergence, Curve, Data, Errors, Mark, extremes, is_power};
    use crate::chart::number::{fixed, integer, shortest, significant};
    use crate::chart::{Axis, Chart, ChartError, Dash, Drawing, Layer, Line, Marks, Panel, Rich, Sheet, Style};
    use crate::integrands::Function;

    pub(super) fn draw(p: &Convergence, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let curves = || data.all().flat_map(|errors| &errors.curves);
        let title = if curves().all(|curve| curve.replicates == 1) { "absolute error" } else { "RMSE" };
        let several = p.integrands.len() > 1;
        let panel = |(index, errors): (usize, &Errors)| {
            let panel = Panel::new(Axis::log2("*N*"), Axis::log(title)).with_all(references(p, errors));
            let panel = panel.with_all(errors.curves.iter().flat_map(|curve| line(p, curve, several)));
            match p.integrands.get(index) {
                Some(integrand) if several => panel.title(name(integrand, errors)),
                _ => panel.ratio(0.62),
            }
        };
        Ok(Chart::grid(data.all().enumerate().map(panel).collect()).draw(sheet)?.into())
    }

    /// An integrand's title, or its formula as it was written, and whether there is no error to draw.
    fn name(integrand: &Function, errors: &Errors) -> Rich {
        let title = integrand.abouts().first().map_or(integrand.text(), |about| about.title);
        match errors.curves.iter().map(Curve::left_out).sum::<usize>() {
            0 => Rich::plain(title),
            _ if !errors.any() => Rich::plain(&format!("{title}: exact")),
            count => Rich::plain(&format!("{title}, {count} left out")),
        }
    }

    /// The errors of one sampler, without those that have no place on a logarithmic axis.
    fn line(p: &Convergence, curve: &Curve, several: bool) -> Vec<Layer> {
        let through = |chosen: &dyn Fn(&Mark) -> bool| -> Vec<(f64, f64)> {
            let shown = curve.marks.iter().filter(|mark| mark.resolved && chosen(mark));
            shown.map(|mark| (mark.n as f64, mark.rmse)).collect()
        };
        let slope = curve.fit.map(|(slope, ..)| fixed(slope, 2));
        let left_out = Some(curve.left_out()).filter(|count| *count > 0).map(|count| format!("{count} left out"));
        let notes = slope.iter().chain(&left_out).cloned().collect::<Vec<_>>().join(", ");
        let plain = several || notes.is_empty();
        let label = if plain { curve.title.clone() } else { format!("{} ({notes})", curve.title) };
        let style = Style::of(&curve.method);
        let line = Line::new(through(&|_| true)).style(style).label(label);
        let line = if let (true, Some(slope)) = (several, slope) { line.tail(slope) } else { line };
        match p.powers {
            None => vec![line.marked().into()],
            Some(base) => {
                let powers = through(&|mark| is_power(mark.n as usize, base));
                vec![line.width(0.8).into(), Marks::new(powers).style(style).size(7.0).into()]
            }
        }
    }

    /// The reference slopes: that of independent samples at its predicted height, the others through the first error.
    fn references(p: &Convergence, errors: &Errors) -> Vec<Line> {
        let (Some(first), Some(last)) = (p.n.iter().next(), p.n.iter().last()) else { return Vec::new() };
        let (x0, x1) = (first as f64, last as f64);
        let start = errors.curves.iter().filter_map(|curve| curve.marks.first()).filter(|mark| mark.resolved);
        let highest = start.map(|mark| mark.rmse).max_by(f64::total_cmp);
        let predicted = errors.variance.map(|variance| (variance / x0).sqrt()).filter(|height| *height > 0.0);
        let reference = |(&slope, dash): (&f64, Dash)| {
            let height = if slope == -0.5 { predicted.or(highest) } else { highest.or(predicted) };
            let line = |height| Line::power(x0, height, slope, x1).style(Style::THEORY.dash(dash));
            height.map(|height| line(height).label(format!("slope {}", shortest(slope))))
        };
        let broken = p.slopes.iter().zip(Dash::REFERENCES.into_iter().cycle());
        if first == last { Vec::new() } else { broken.filter_map(reference).collect() }
    }

    pub(super) fn alt(p: &Convergence, data: &Data) -> Option<String> {
        let (first, last) = (p.n.iter().next()?, p.n.iter().last()?);
        let mut text = String::new();
        for (integrand, errors) in p.integrands.iter().zip(data.all()) {
            let _ = write!(
                text,
                "{}The error of the estimate of the integral of {} over N, from {} to {} points, on logarithmic axes.",
                if text.is_empty() { "" } else { " " },
                integrand.text(),
                integer(first as i64),
                integer(last as i64),
            );
            told(errors, &mut text);
        }
        Some(text)
    }

    /// The errors of every sampler in words, and who is best.
    fn told(errors: &Errors, text: &mut String) {
        for curve in &errors.curves {
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
        if let Some([best, worst]) = extremes(errors) {
            let curve = |name: &str| errors.curves.iter().find(|curve| curve.method == name);
            let title = |name: &str| curve(name).map_or(name.to_owned(), |curve| curve.title.clone());
            let _ = write!(
                text,
                " At the largest N the smallest error is that of {}, {} times smaller than that of {}.",
                title(best.0),
                significant(worst.1 / best.1, 2),
                title(worst.0),
            );
        }
    }
}
