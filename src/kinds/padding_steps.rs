//! Padding, step by step: strata of few dimensions, each set shuffled by itself, are combined to samples of many.
//!
//! Full stratification of five dimensions with k strata an axis would need k^5 samples; padding needs k^2, and stratifies each
//! pair and the single axis alone (Cook, Porter and Carpenter 1984, doi 10.1145/800031.808590).

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::points::slab;
use crate::samplers::digits::within;
use crate::seed::Seed;

/// The kind `padding-steps`.
pub static PADDING_STEPS: PaddingStepsKind = PaddingStepsKind;

/// The kind of experiment `padding-steps`.
pub struct PaddingStepsKind;

static ABOUT: About = About {
    key: "padding-steps",
    title: "Padding, step by step",
    summary: "Stratified points of (x, y), t and (u, v), each set shuffled by itself, and then combined to samples of five dimensions.",
    file: "kinds/padding_steps.rs",
    source: include_str!("padding_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through padding can choose.
    pub struct PaddingSteps {
        /// How many strata an axis of a square has: there are as many samples as its square.
        side: usize [in 2..=5] = 3,
    }
}

/// The parts of each sample.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// The three steps before samples are combined: in order, t shuffled, (u, v) shuffled.
    steps: Vec<Vec<Sample>>,
    /// Whether in each of them each cell and each slab holds one sample.
    stratified: bool,
    /// The correlation of the numbers of the cells of (x, y) and (u, v), before and after.
    correlation: (f64, f64),
}

/// A sample of five dimensions.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Sample {
    xy: Place,
    t: f64,
    uv: Place,
}

impl Kind for PaddingStepsKind {
    type Parameters = PaddingSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &PaddingSteps, _: &mut Problems<'_, '_>) {}

    fn weight(&self, p: &PaddingSteps) -> u64 {
        (p.side * p.side) as u64
    }

    fn run(&self, p: &PaddingSteps, seed: Seed) -> Result<Data, Failure> {
        let (side, n, stream) = (p.side as u64, p.side * p.side, seed.named(ABOUT.key));
        let mut random = ["xy", "t", "uv"].map(|name| stream.named(name).generator());
        let mut cells = |part: usize| -> Vec<Place> {
            let random = &mut random[part];
            let cell =
                |cell: u64| (within(cell % side, side, random.uniform()), within(cell / side, side, random.uniform()));
            (0..n as u64).map(cell).collect()
        };
        let (xy, mut uv) = (cells(0), cells(2));
        let mut t: Vec<f64> = (0..n as u64).map(|slab| within(slab, n as u64, random[1].uniform())).collect();
        let combined = |t: &[f64], uv: &[Place]| -> Vec<Sample> {
            xy.iter().zip(t).zip(uv).map(|((&xy, &t), &uv)| Sample { xy, t, uv }).collect()
        };
        let mut steps = vec![combined(&t, &uv)];
        random[1].shuffle(&mut t);
        steps.push(combined(&t, &uv));
        random[2].shuffle(&mut uv);
        steps.push(combined(&t, &uv));
        let stratified = steps.iter().all(|samples| is_stratified(samples, p.side));
        let correlation = steps.first().zip(steps.last());
        let correlation =
            correlation.map_or((0.0, 0.0), |(first, last)| (correlated(first, p.side), correlated(last, p.side)));
        Ok(Data { steps, stratified, correlation })
    }

    fn values(&self, p: &PaddingSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("samples", (p.side * p.side) as i64);
        values.integer("full", p.side.pow(5) as i64);
        values.boolean("stratified.every-step", data.stratified);
        values.number("correlation.unshuffled", data.correlation.0);
        values.number("correlation.shuffled", data.correlation.1);
        values
    }

    fn tables(&self, _: &PaddingSteps, data: &Data) -> Vec<Frame> {
        let last = || data.steps.iter().flat_map(|samples| samples.iter());
        let step = data.steps.iter().enumerate().flat_map(|(step, samples)| samples.iter().map(move |_| step + 1));
        let frame = Frame::new("samples")
            .counts("step", step)
            .numbers("x", last().map(|sample| sample.xy.0))
            .numbers("y", last().map(|sample| sample.xy.1))
            .numbers("t", last().map(|sample| sample.t))
            .numbers("u", last().map(|sample| sample.uv.0))
            .numbers("v", last().map(|sample| sample.uv.1));
        vec![frame]
    }

    fn draw(&self, p: &PaddingSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &PaddingSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// Whether each cell of both squares and each slab of t holds one sample.
fn is_stratified(samples: &[Sample], side: usize) -> bool {
    let places = |place: fn(&Sample) -> Place| samples.iter().map(place).collect::<Vec<Place>>();
    steps::one_per_cell(&places(|sample| sample.xy), side, side)
        && steps::one_per_cell(&places(|sample| sample.uv), side, side)
        && steps::one_per_cell(&places(|sample| (sample.t, 0.5)), samples.len(), 1)
}

/// The correlation of the numbers of the cells of (x, y) and of (u, v).
fn correlated(samples: &[Sample], side: usize) -> f64 {
    let number = |(x, y): Place| (slab(x, side) + side * slab(y, side)) as f64;
    let pairs: Vec<(f64, f64)> = samples.iter().map(|sample| (number(sample.xy), number(sample.uv))).collect();
    let middle = (samples.len() as f64 - 1.0) / 2.0;
    let mean =
        |product: fn(f64, f64) -> f64| -> f64 { pairs.iter().map(|(a, b)| product(a - middle, b - middle)).sum() };
    mean(|a, b| a * b) / mean(|a, _| a * a).max(f64::MIN_POSITIVE)
}

mod drawing {
    //! The three sets, and their words.

    use super::{Data, PaddingSteps, Place, Sample};
    use crate::chart::{
        Chart, ChartError, Corner, Drawing, Key, Marks, Note, Panel, Role, Segments, Sheet, Steps, Strata, Style,
    };

    pub(super) fn draw(p: &PaddingSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new().small(290.0).key_steps([1]);
        let words = [
            "Three stratified sets, numbered in the order of their strata: sample by sample they would all say the same.",
            "The order of $t$ is shuffled: the number of a slab tells nothing any more.",
            "The order of $(u, v)$ is shuffled, too. Each set is as stratified as before.",
        ];
        for (samples, words) in data.steps.iter().zip(words) {
            steps.push(Chart::grid(panels(p, samples, None)).columns(3).key(Key::Hidden), words);
        }
        let samples = data.steps.last().map(Vec::as_slice).unwrap_or_default();
        for index in 0..samples.len() {
            let chart = Chart::grid(panels(p, samples, Some(index))).columns(3).key(Key::Hidden);
            let number = index + 1;
            steps.push(chart, format!("Sample {number} takes what has the number {number} in each set."));
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panels(p: &PaddingSteps, samples: &[Sample], chosen: Option<usize>) -> Vec<Panel> {
        let side = p.side as u32;
        let places = |place: fn(&Sample) -> Place| samples.iter().map(place).collect::<Vec<Place>>();
        vec![
            panel("(*x*, *y*)", Strata::cells(side), &places(|sample| sample.xy), chosen),
            panel("*t*", Strata::boxes(side * side, 1), &places(|sample| (sample.t, 0.5)), chosen),
            panel("(*u*, *v*)", Strata::cells(side), &places(|sample| sample.uv), chosen),
        ]
    }

    fn panel(title: &str, strata: Strata, places: &[Place], chosen: Option<usize>) -> Panel {
        let line = strata.rows == 1;
        let mut panel = Panel::unit_square().title(title).strata(strata);
        panel = panel.with_all(chosen.and_then(|index| places.get(index)).map(|&at| Segments::spots([at])));
        panel = panel.with(Marks::new(places.to_vec()).style(Style::new(Role::Slate)).size(6.0).tracked("p"));
        panel.with_all(places.iter().enumerate().map(|(index, &(x, y))| {
            // On the line the numbers stand on stairs, lest they touch.
            let rank = places.iter().filter(|other| other.0 < x).count();
            let lift = if line { 0.03 + 0.1 * (rank % 3) as f64 } else { 0.0 };
            let corner = if line { Corner::Above } else { free(places, (x, y)) };
            Note::new((x, y + lift), (index + 1).to_string()).corner(corner).tracked(format!("n{index}"))
        }))
    }

    /// The first corner of a point of the square that no other point and no border takes.
    fn free(places: &[Place], (x, y): Place) -> Corner {
        let corners = [
            (Corner::AboveRight, 0.065, 0.075),
            (Corner::AboveLeft, -0.065, 0.075),
            (Corner::BelowRight, 0.065, -0.075),
            (Corner::BelowLeft, -0.065, -0.075),
        ];
        let is_free = |&&(_, dx, dy): &&(Corner, f64, f64)| {
            let at = (x + dx, y + dy);
            let inside = |v: f64| (0.03..=0.97).contains(&v);
            let near = |other: &&Place| (other.0 - at.0).abs() < 0.07 && (other.1 - at.1).abs() < 0.07;
            inside(at.0) && inside(at.1) && !places.iter().any(|other| near(&other))
        };
        corners.iter().find(is_free).map_or(Corner::AboveRight, |corner| corner.0)
    }

    pub(super) fn alt(p: &PaddingSteps, data: &Data) -> String {
        let n = p.side * p.side;
        let kept = if data.stratified { "In every step each cell and each slab holds one sample." } else { "" };
        format!(
            "{} steps: {n} points in {n} cells of (x, y), {n} in slabs of t and {n} in cells of (u, v), numbered in order; then \
             t and (u, v) are shuffled, and sample by sample the three sets are combined by their numbers. {kept}",
            data.steps.len() + n
        )
    }
}
