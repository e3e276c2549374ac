//! The estimator as boxes: each of N samples is a box of width 1/N and of the integrand's height there; their area is F_N.
//!
//! The boxes stand in the order of the samples' places, so that the tops follow the curve as N grows; the area does not depend
//! on the order.

use serde::{Deserialize, Serialize};

use super::estimation::undefined;
use super::steps::{Place, check_count};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{Counts, parameters};
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::moments;

/// The kind `estimator-steps`.
pub static ESTIMATOR_STEPS: EstimatorStepsKind = EstimatorStepsKind;

/// The kind of experiment `estimator-steps`.
pub struct EstimatorStepsKind;

static ABOUT: About = About {
    key: "estimator-steps",
    title: "The estimator as boxes",
    summary: "The Monte Carlo estimator as the area of N boxes of equal width, as high as the integrand at the samples, for more and more N.",
    file: "kinds/estimator_steps.rs",
    source: include_str!("estimator_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through the boxes of the estimator can choose.
    pub struct EstimatorSteps {
        /// The integrand, of one variable.
        integrand: Function,
        /// The sampler, with an optional scramble.
        sampler: Method = "independent",
        /// The counts, one step each.
        n: Counts [in 1..=256] = "2^0..2^5",
    }
}

/// The samples and the curve.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// The curve, at equal distances from 0 to 1.
    curve: Vec<f64>,
    /// Of each count the samples with their heights, in the order of their places, and the estimate.
    steps: Vec<(Vec<Place>, f64)>,
    exact: Option<f64>,
}

/// Into how many pieces the curve is cut.
const PIECES: usize = 64;

impl Kind for EstimatorStepsKind {
    type Parameters = EstimatorSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &EstimatorSteps, problems: &mut Problems<'_, '_>) {
        problems.admit("sampler", &[p.sampler], p.n.as_slice(), 1);
        check_count(p.n.as_slice().len(), "n", problems);
        if let Some(d) = p.integrand.dimensions().filter(|d| *d > 1) {
            let message = format!("`{}` has {d} variables; its boxes need one", p.integrand.text());
            problems.at("integrand", Code::Combination, message, None);
        }
    }

    fn weight(&self, p: &EstimatorSteps) -> u64 {
        p.n.total()
    }

    fn run(&self, p: &EstimatorSteps, seed: Seed) -> Result<Data, Failure> {
        let f = |x: f64| Some(p.integrand.evaluate(&[x])).filter(|y| y.is_finite());
        let f = |x: f64| f(x).ok_or_else(|| undefined(&p.integrand, &[x]));
        let curve = (0..=PIECES).map(|piece| f(piece as f64 / PIECES as f64)).collect::<Result<_, Failure>>()?;
        let stream = seed.named(ABOUT.key).named(&p.sampler.name());
        let step = |n: usize| {
            let points =
                p.sampler.points(n, 1, stream).map_err(|refused| Failure::of("sampler", refused.to_string()))?;
            let mut samples = points.axis(0).map(|x| Ok((x, f(x)?))).collect::<Result<Vec<Place>, Failure>>()?;
            samples.sort_by(|a, b| a.0.total_cmp(&b.0));
            let heights: Vec<f64> = samples.iter().map(|sample| sample.1).collect();
            Ok((samples, moments::mean(&heights)))
        };
        let steps = p.n.iter().map(step).collect::<Result<_, Failure>>()?;
        Ok(Data { curve, steps, exact: p.integrand.integral(1).map(|reference| reference.value) })
    }

    fn values(&self, _: &EstimatorSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact.unwrap_or(f64::NAN));
        for (samples, estimate) in &data.steps {
            values.number(format!("estimate.{}", samples.len()), *estimate);
        }
        values
    }

    fn tables(&self, _: &EstimatorSteps, data: &Data) -> Vec<Frame> {
        let frame = Frame::new("estimates")
            .counts("n", data.steps.iter().map(|step| step.0.len()))
            .numbers("estimate", data.steps.iter().map(|step| step.1));
        vec![frame]
    }

    fn draw(&self, p: &EstimatorSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &EstimatorSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

mod drawing {
    //! The boxes, and their words.

    use super::{Data, EstimatorSteps, PIECES, Place};
    use crate::chart::number::{fixed, significant};
    use crate::chart::{
        Area, Axis, Boxes, Chart, ChartError, Drawing, Key, Layer, Line, Panel, Rule, Segments, Sheet, Steps, Style,
    };

    pub(super) fn draw(_: &EstimatorSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let count = data.steps.len();
        let mut steps = Steps::new().small(290.0).key_steps([count / 3 + 1, 2 * count / 3 + 1]);
        for (samples, estimate) in &data.steps {
            steps.push(Chart::new(panel(data, samples, *estimate)).key(Key::Above), caption(data, samples, *estimate));
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(data: &Data, samples: &[Place], estimate: f64) -> Panel {
        let heights =
            || data.curve.iter().copied().chain(data.steps.iter().flat_map(|step| step.0.iter().map(|s| s.1)));
        let (low, high) = (heights().fold(0.0, f64::min), heights().fold(0.0, f64::max));
        let pad = if high > low { 0.06 * (high - low) } else { 1.0 };
        let y = Axis::linear("").range(if low < 0.0 { low - pad } else { 0.0 }, high + pad);
        let mut panel = Panel::new(Axis::linear("*x*").range(0.0, 1.0), y);
        let n = samples.len() as f64;
        let edge = |index: usize| index as f64 / n;
        let tops = samples.iter().map(|sample| sample.1).enumerate();
        let boxes: Layer = if samples.len() <= 16 {
            let boxes = tops.map(|(index, top)| [(edge(index), 0.0), (edge(index + 1), top)]).collect();
            Boxes::new(boxes).style(Style::FILL).opacity(0.4).label("*N* boxes").into()
        } else {
            let last = samples.last().map(|sample| (1.0, sample.1));
            let stairs = tops.map(|(index, top)| (edge(index), top)).chain(last).collect();
            Area::new(stairs).stepped().style(Style::FILL).label("*N* boxes").into()
        };
        let curve = data.curve.iter().enumerate().map(|(piece, &height)| (piece as f64 / PIECES as f64, height));
        panel = panel.with(boxes).with(Line::new(curve.collect()).label("*f*(*x*)"));
        panel = panel.with_all(data.exact.map(|exact| Rule::horizontal(exact).style(Style::EXACT).label("exact")));
        panel = panel.with(Rule::horizontal(estimate).style(Style::ACCENT).label("mean"));
        // As many as can be told apart; more of them are smaller.
        if samples.len() <= 128 {
            let width = if samples.len() <= 32 { 5.0 } else { 3.5 };
            let feet = samples.iter().map(|&(x, y)| [(x, y), (x, y)]).collect();
            panel = panel.with(Segments::new(feet).width(width).style(Style::ACCENT));
        }
        panel
    }

    fn caption(data: &Data, samples: &[Place], estimate: f64) -> String {
        let n = samples.len();
        let boxes = if n == 1 { "one box".to_owned() } else { format!("{n} boxes of width 1/{n}") };
        let exact = data.exact.map_or(String::new(), |exact| format!("; exact {}", fixed(exact, 4)));
        format!("$N = {n}$: {boxes}, mean height {}{exact}.", fixed(estimate, 4))
    }

    pub(super) fn alt(p: &EstimatorSteps, data: &Data) -> String {
        let (Some(first), Some(last)) = (data.steps.first(), data.steps.last()) else { return String::new() };
        let exact =
            data.exact.map_or(String::new(), |exact| format!(" The exact integral is {}.", significant(exact, 5)));
        format!(
            "{} steps: the curve of {} over [0, 1] with N boxes of equal width, as high as the curve at the samples of {}. \
             The mean height goes from {} at N = {} to {} at N = {}.{exact}",
            data.steps.len(),
            p.integrand.text(),
            p.sampler.title(),
            significant(first.1, 4),
            first.0.len(),
            significant(last.1, 4),
            last.0.len()
        )
    }
}
