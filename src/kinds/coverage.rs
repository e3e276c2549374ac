//! Coverage: how often a confidence interval from independent randomisations holds the true value.
//!
//! R independent randomisations of a sampler give R estimates; their mean and their standard deviation give Student's interval. It is
//! right where the estimates follow the normal law, and nearly so where R is not small. The whole is repeated many times, and the share
//! of intervals that hold the integral is held against the nominal one.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Study, check_dimensions, dimensions, reference};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::inference;
use crate::stats::moments::{self, Moments};

/// The kind `coverage`.
pub static COVERAGE: CoverageKind = CoverageKind;

/// The kind of experiment that tries confidence intervals.
pub struct CoverageKind;

static ABOUT: About = About {
    key: "coverage",
    title: "Coverage of confidence intervals",
    summary: "Confidence intervals from R independent randomisations, repeated many times: how often they hold the integral.",
    file: "kinds/coverage.rs",
    source: include_str!("coverage.rs"),
    papers: &[Paper {
        authors: "P. L'Ecuyer and C. Lemieux",
        year: 2002,
        title: "Recent Advances in Randomized Quasi-Monte Carlo Methods",
        venue: "Modeling Uncertainty, Springer, 419-474",
        doi: Some("10.1007/0-306-48102-2_20"),
    }],
};

parameters! {
    /// What a trial of confidence intervals can choose.
    pub struct Coverage {
        /// The samplers, each with an optional scramble; each must be random.
        samplers: Vec<Method> [or sampler],
        /// What is integrated over the unit cube.
        integrand: Function,
        /// How many points each randomisation has.
        n: usize [in 1..=1_000_000] = 64,
        /// How many independent randomisations make one interval.
        randomisations: usize [in 2..=1000] = 10,
        /// How many intervals are tried.
        repetitions: usize [in 10..=100_000] = 2000,
        /// The probability with which an interval should hold the integral.
        confidence: f64 [in 0.5..=0.9999] = 0.95,
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=64],
        /// How many of the intervals are drawn.
        shown: usize [in 10..=100] = 50,
    }
}

/// The intervals of every sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    rows: Vec<Row>,
}

/// The intervals of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Row {
    method: String,
    title: String,
    covered: u64,
    /// The mean half width of the intervals.
    half: f64,
    /// The mean of the estimated variances of the mean, and the variance of the means.
    variances: (f64, f64),
    /// The first intervals: low, high.
    shown: Vec<(f64, f64)>,
}

impl Row {
    fn rate(&self, p: &Coverage) -> f64 {
        self.covered as f64 / p.repetitions as f64
    }
}

/// The standard error of a share, if the intervals hold the integral with their nominal probability.
fn error(p: &Coverage) -> f64 {
    (p.confidence * (1.0 - p.confidence) / p.repetitions as f64).sqrt()
}

impl Kind for CoverageKind {
    type Parameters = Coverage;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Coverage) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions));
    }

    fn check(&self, p: &Coverage, problems: &mut Problems<'_, '_>) {
        check_dimensions(&p.integrand, p.dimensions, problems);
        problems.admit("samplers", &p.samplers, &[p.n], dimensions(&p.integrand, p.dimensions));
        for (index, method) in p.samplers.iter().enumerate().filter(|(_, method)| !method.is_random()) {
            let message = format!("`{}` gives the same estimate for every seed: there is no error bar", method.name());
            let help = "choose a random sampler, or a scramble such as `sobol+owen`".to_owned();
            problems.element("samplers", index, Code::Combination, message, Some(help));
        }
        if p.shown > p.repetitions {
            let message = format!("{} intervals cannot be shown of {}", p.shown, p.repetitions);
            problems.at("shown", Code::OutOfRange, message, None);
        }
    }

    fn weight(&self, p: &Coverage) -> u64 {
        let estimates = (p.randomisations as u64) * (p.repetitions as u64) * p.samplers.len() as u64;
        estimates.saturating_mul(p.n as u64)
    }

    fn run(&self, p: &Coverage, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let exact = reference(&p.integrand, d)?.value;
        let rows = p.samplers.iter().map(|method| row(p, &study, method, exact)).collect::<Result<Vec<_>, _>>()?;
        Ok(Data { exact, rows })
    }

    fn values(&self, p: &Coverage, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        values.number("nominal", p.confidence);
        for row in &data.rows {
            let name = &row.method;
            values.estimate(format!("coverage.{name}"), row.rate(p), error(p));
            values.number(format!("width.{name}"), row.half);
            values.number(format!("variance.{name}"), row.variances.1);
            // The mean of the estimated variances over the true one: 1 where the error bars tell the truth.
            let ratio = row.variances.0 / row.variances.1;
            let error = (2.0 / (p.repetitions as f64 - 1.0)).sqrt() * ratio;
            values.estimate(format!("ratio.{name}"), ratio, error);
        }
        values
    }

    fn tables(&self, p: &Coverage, data: &Data) -> Vec<Frame> {
        let rows = || data.rows.iter();
        let coverage = Frame::new("coverage")
            .text("sampler", rows().map(|row| row.method.clone()))
            .numbers("coverage", rows().map(|row| row.rate(p)))
            .numbers("standard error", rows().map(|_| error(p)))
            .numbers("half width", rows().map(|row| row.half))
            .numbers("variance of the mean", rows().map(|row| row.variances.1))
            .numbers("mean of its estimates", rows().map(|row| row.variances.0));
        let intervals = || rows().flat_map(|row| row.shown.iter().map(move |interval| (row, interval)));
        let shown = Frame::new("intervals")
            .text("sampler", intervals().map(|(row, _)| row.method.clone()))
            .numbers("low", intervals().map(|(_, interval)| interval.0))
            .numbers("high", intervals().map(|(_, interval)| interval.1));
        vec![coverage, shown]
    }

    fn draw(&self, p: &Coverage, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Coverage, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The intervals of one sampler.
fn row(p: &Coverage, study: &Study<'_>, method: &Method, exact: f64) -> Result<Row, Failure> {
    let trial = |trial: usize| -> Result<(f64, f64, f64), Failure> {
        let first = trial * p.randomisations;
        let estimate = |index: usize| study.estimate(method, p.n, study.stream(method, p.n, first + index));
        let moments = (0..p.randomisations).map(estimate).collect::<Result<Moments, Failure>>()?;
        let none =
            || Failure::of("randomisations", "one randomisation has no standard error").help("choose at least 2");
        let interval = inference::t_interval(&moments, p.confidence).ok_or_else(none)?;
        Ok((interval.low, interval.high, moments.variance() / p.randomisations as f64))
    };
    let trials: Vec<Result<_, Failure>> = (0..p.repetitions).into_par_iter().map(piece(trial)).collect();
    let trials = trials.into_iter().collect::<Result<Vec<_>, _>>()?;
    let means: Vec<f64> = trials.iter().map(|trial| f64::midpoint(trial.0, trial.1)).collect();
    let variance = moments::variance(&means);
    if variance.is_nan() || variance <= 0.0 {
        let message = format!("every estimate of `{}` with `{}` is the same", study.integrand.text(), method.name());
        return Err(Failure::of("integrand", message).help("choose an integrand that varies"));
    }
    Ok(Row {
        method: method.name(),
        title: method.title(),
        covered: trials.iter().filter(|trial| (trial.0..=trial.1).contains(&exact)).count() as u64,
        half: moments::mean(&trials.iter().map(|trial| 0.5 * (trial.1 - trial.0)).collect::<Vec<_>>()),
        variances: (moments::mean(&trials.iter().map(|trial| trial.2).collect::<Vec<_>>()), variance),
        shown: trials.iter().take(p.shown).map(|trial| (trial.0, trial.1)).collect(),
    })
}

mod drawing {
    //! The drawing of intervals, the misses marked, and its words.

    use std::fmt::Write as _;

    use super::{Coverage, Data, Row, error};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{
        Axis, Chart, ChartError, Drawing, ErrorBars, Key, Line, Marker, Marks, Panel, Role, Sheet, Style,
    };

    pub(super) fn draw(p: &Coverage, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let panels: Vec<Panel> = data.rows.iter().map(|row| panel(p, data, row)).collect();
        let columns = if panels.len() > 1 { 2 } else { 1 };
        Ok(Chart::grid(panels).columns(columns).key(Key::Above).draw(sheet)?.into())
    }

    /// The intervals of one sampler about the integral.
    fn panel(p: &Coverage, data: &Data, row: &Row) -> Panel {
        let numbered = || row.shown.iter().enumerate().map(|(index, &(low, high))| ((index + 1) as f64, low, high));
        let holds = |interval: &(f64, f64, f64)| (interval.1..=interval.2).contains(&data.exact);
        let (held, missed): (Vec<_>, Vec<_>) = numbered().partition(holds);
        let centres: Vec<(f64, f64)> = missed.iter().map(|miss| (miss.0, f64::midpoint(miss.1, miss.2))).collect();
        let ends = vec![(0.0, data.exact), (row.shown.len() as f64 + 1.0, data.exact)];
        let rate = 100.0 * row.rate(p);
        let mut panel = Panel::new(Axis::linear("repetition"), Axis::linear("interval"))
            .title(format!("{}: {} %", escaped(&row.title), fixed(rate, 1)))
            .ratio(if data.rows.len() > 1 { 0.8 } else { 0.5 })
            .with(ErrorBars::new(held).style(Style::new(Role::Blue)).label("holds the integral"));
        if !missed.is_empty() {
            panel = panel
                .with(ErrorBars::new(missed).style(Style::ACCENT))
                .with(Marks::new(centres).style(Style::ACCENT.marker(Marker::Diamond)).size(8.0).label("misses it"));
        }
        panel.with(Line::new(ends).style(Style::EXACT).label("exact"))
    }

    /// A name whose letters are no markup.
    fn escaped(name: &str) -> String {
        name.replace('*', "\\*")
    }

    pub(super) fn alt(p: &Coverage, data: &Data) -> String {
        let mut text = format!(
            "{} confidence intervals of {} per cent for the integral of {}, exactly {}, each from {} randomisations of {} points.",
            integer(p.shown as i64),
            significant(100.0 * p.confidence, 3),
            p.integrand.text(),
            significant(data.exact, 5),
            p.randomisations,
            integer(p.n as i64),
        );
        for row in &data.rows {
            let missed = row.shown.iter().filter(|interval| !(interval.0..=interval.1).contains(&data.exact)).count();
            let _ = write!(
                text,
                " {}: {missed} of those shown miss it; of {} in all, {} ± {} per cent hold it, with a mean half width of {}.",
                row.title,
                integer(p.repetitions as i64),
                fixed(100.0 * row.rate(p), 1),
                fixed(100.0 * error(p), 1),
                significant(row.half, 2),
            );
        }
        text
    }
}
