//! Running means: the mean of the first k samples as k grows, in several runs, with the band c / sqrt(k) that they shrink into.
//!
//! The band is two standard deviations of a mean of k independent samples to either side of the integral. The running mean of
//! a set that is only good as a whole, such as a Latin hypercube, says nothing; samplers without prefixes are refused.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Study, check_dimensions, dimensions, reference, replicates_of};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::parameters;
use crate::samplers::{Guarantee, Method};
use crate::seed::Seed;
use crate::stats::moments::{self, Sum};

/// The kind `running-mean`.
pub static RUNNING_MEAN: RunningMeanKind = RunningMeanKind;

/// The kind of experiment that follows means.
pub struct RunningMeanKind;

static ABOUT: About = About {
    key: "running-mean",
    title: "Running means",
    summary: "The mean of the first k samples over k, in several runs, with the band that shrinks as c / sqrt(k).",
    file: "kinds/running_mean.rs",
    source: include_str!("running_mean.rs"),
    papers: &[],
};

/// Half the width of the band, in standard deviations.
const BAND: f64 = 2.0;

/// Of how many means a run's line is made, at most.
const MARKS: usize = 400;

parameters! {
    /// What a drawing of running means can choose.
    pub struct RunningMean {
        /// The samplers, each with an optional scramble; each must be a sequence.
        samplers: Vec<Method> [or sampler] = ["independent"],
        /// What is integrated over the unit cube.
        integrand: Function,
        /// How many samples the longest mean is of.
        n: usize [in 2..=1_000_000] = 1000,
        /// How many runs of each sampler; sequences that no seed changes have one.
        runs: usize [in 1..=1000] = 10,
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=64],
    }
}

/// The means of every run.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    sigma: Option<f64>,
    /// The k at which the means are kept, ascending.
    marks: Vec<u64>,
    methods: Vec<Runs>,
}

/// The runs of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Runs {
    method: String,
    title: String,
    /// For each run, its mean at each mark.
    means: Vec<Vec<f64>>,
}

impl Runs {
    fn ends(&self) -> impl Iterator<Item = f64> + '_ {
        self.means.iter().filter_map(|means| means.last().copied())
    }

    /// Which part of the runs ends outside of the band of half width `half`.
    fn outside(&self, exact: f64, half: f64) -> f64 {
        let outside = self.ends().filter(|end| (end - exact).abs() > half).count();
        outside as f64 / self.means.len().max(1) as f64
    }
}

impl Kind for RunningMeanKind {
    type Parameters = RunningMean;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut RunningMean) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions));
    }

    fn check(&self, p: &RunningMean, problems: &mut Problems<'_, '_>) {
        check_dimensions(&p.integrand, p.dimensions, problems);
        problems.admit("samplers", &p.samplers, &[p.n], dimensions(&p.integrand, p.dimensions));
        for (index, method) in p.samplers.iter().enumerate() {
            if !method.guarantees().contains(&Guarantee::Prefix) {
                let message = format!("`{}` is a set, not a sequence: its first k points say nothing", method.name());
                let help = "choose a sampler whose first k points are the k points, such as `independent`".to_owned();
                problems.element("samplers", index, Code::Combination, message, Some(help));
            }
        }
    }

    fn weight(&self, p: &RunningMean) -> u64 {
        (p.n as u64).saturating_mul(p.runs as u64).saturating_mul(p.samplers.len() as u64)
    }

    fn run(&self, p: &RunningMean, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let exact = reference(&p.integrand, d)?.value;
        let marks = marks(p.n);
        let runs = |method: &Method| {
            let means: Vec<Result<Vec<f64>, Failure>> = (0..replicates_of(method, p.runs))
                .into_par_iter()
                .map(piece(|run| means(&study, method, p.n, run, &marks)))
                .collect();
            let means = means.into_iter().collect::<Result<_, _>>()?;
            Ok(Runs { method: method.name(), title: method.title(), means })
        };
        let methods = p.samplers.iter().map(runs).collect::<Result<_, Failure>>()?;
        let sigma = p.integrand.variance(d).map(|variance| variance.max(0.0).sqrt());
        Ok(Data { exact, sigma, marks: marks.iter().map(|&k| k as u64).collect(), methods })
    }

    fn values(&self, p: &RunningMean, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        let half = data.sigma.map(|sigma| BAND * sigma / (p.n as f64).sqrt());
        if let (Some(sigma), Some(half)) = (data.sigma, half) {
            values.number("sigma", sigma);
            values.number("band", half);
        }
        for runs in &data.methods {
            let name = &runs.method;
            if let Some(half) = half {
                values.number(format!("outside.{name}"), runs.outside(data.exact, half));
            }
            let errors: Vec<f64> = runs.ends().map(|end| end - data.exact).collect();
            values.number(format!("rmse.{name}"), moments::root_mean_square(&errors));
            for (run, end) in runs.ends().enumerate() {
                values.number(format!("end.{name}.{}", run + 1), end);
            }
        }
        values
    }

    fn tables(&self, _: &RunningMean, data: &Data) -> Vec<Frame> {
        let mut frame = Frame::new("means").counts("k", data.marks.iter().map(|&k| k as usize));
        for runs in &data.methods {
            for (run, means) in runs.means.iter().enumerate() {
                frame = frame.numbers(format!("{} {}", runs.method, run + 1), means.iter().copied());
            }
        }
        vec![frame]
    }

    fn draw(&self, p: &RunningMean, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &RunningMean, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The k at which means are kept: every one of the first hundred, then ever sparser, and the last.
fn marks(n: usize) -> Vec<usize> {
    let mut marks: Vec<usize> = (1..=n.min(100)).collect();
    while let Some(&last) = marks.last()
        && last < n
    {
        let step = (last / 64).max(n / MARKS).max(1);
        marks.push((last + step).min(n));
    }
    marks
}

/// The running means of one run at the marks.
fn means(study: &Study<'_>, method: &Method, n: usize, run: usize, marks: &[usize]) -> Result<Vec<f64>, Failure> {
    // One stream for all k: the running mean follows one sequence, whatever its length.
    let points = study.points(method, n, study.stream(method, 0, run))?;
    let mut sum = Sum::default();
    let mut means = Vec::with_capacity(marks.len());
    for (index, point) in points.rows().enumerate() {
        sum.add(study.integrand.evaluate(point));
        if marks.get(means.len()) == Some(&(index + 1)) {
            means.push(sum.value() / (index + 1) as f64);
        }
    }
    if means.iter().all(|mean| mean.is_finite()) { Ok(means) } else { Err(study.undefined(&points)) }
}

mod drawing {
    //! The drawing of running means, and its words.

    use std::fmt::Write as _;

    use super::{BAND, Data, RunningMean, Runs};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Band, Chart, ChartError, Dash, Drawing, Line, Panel, Rich, Sheet, Style};

    pub(super) fn draw(_: &RunningMean, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let several = data.methods.len() > 1;
        let panels: Vec<Panel> = data.methods.iter().map(|runs| panel(data, runs, several)).collect();
        Ok(Chart::grid(panels).shared().draw(sheet)?.into())
    }

    /// The runs of one sampler within the band.
    fn panel(data: &Data, runs: &Runs, titled: bool) -> Panel {
        let (low, high) = window(data);
        let mut panel =
            Panel::new(Axis::log("*N*"), Axis::linear("mean of the first *N* samples").range(low, high)).ratio(0.55);
        if titled {
            panel = panel.title(Rich::plain(&runs.title));
        }
        if let Some(sigma) = data.sigma {
            let edge = |k: f64| (k, data.exact - BAND * sigma / k.sqrt(), data.exact + BAND * sigma / k.sqrt());
            panel = panel.with(Band::new(data.marks.iter().map(|&k| edge(k as f64)).collect()).label("±2*σ*/√*N*"));
        }
        let ends = vec![(1.0, data.exact), (data.marks.last().map_or(2.0, |&k| k as f64), data.exact)];
        let exact = Line::new(ends).style(Style::EXACT).label("exact");
        // Many broken lines would be a fog: runs keep the sampler's colour, and are whole.
        let style = Style::of(&runs.method).dash(Dash::Solid);
        let line = |means: &Vec<f64>| {
            let points = data.marks.iter().zip(means).map(|(&k, &mean)| (k as f64, mean)).collect();
            let line = Line::new(points).style(style);
            if runs.means.len() > 3 { line.faint() } else { line }
        };
        panel.with_all(runs.means.iter().map(line)).with(exact)
    }

    /// The heights to show: all of the means and, from a few samples on, all of the band.
    fn window(data: &Data) -> (f64, f64) {
        let means = data.methods.iter().flat_map(|runs| runs.means.iter().flatten().copied());
        let (low, high) = means.fold((data.exact, data.exact), |(low, high), mean| (low.min(mean), high.max(mean)));
        let half = data.sigma.map_or(0.0, |sigma| BAND * sigma / 2.0);
        let (low, high) = (low.min(data.exact - half), high.max(data.exact + half));
        let margin = if high > low { 0.04 * (high - low) } else { 0.5 * data.exact.abs().max(1.0) };
        (low - margin, high + margin)
    }

    pub(super) fn alt(p: &RunningMean, data: &Data) -> String {
        let mut text = format!(
            "Running means of {} over N from 1 to {} on a logarithmic axis, around the exact {}.",
            p.integrand.text(),
            integer(p.n as i64),
            significant(data.exact, 5),
        );
        for runs in &data.methods {
            let (low, high) =
                runs.ends().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), end| (l.min(end), h.max(end)));
            let count = runs.means.len();
            let ends = match count {
                1 => format!("one run, which ends at {}", significant(low, 5)),
                _ => format!("{count} runs, which end between {} and {}", significant(low, 5), significant(high, 5)),
            };
            let _ = write!(text, " {}: {ends}", runs.title);
            if let Some(sigma) = data.sigma {
                let outside = runs.outside(data.exact, BAND * sigma / (p.n as f64).sqrt());
                let _ =
                    write!(text, ", {} per cent of them outside of two standard deviations", fixed(100.0 * outside, 0));
            }
            text.push('.');
        }
        text
    }
}
