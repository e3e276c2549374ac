//! Points on a line, one by one: into which gap each falls, whether it is a biggest one, and whether it is halved.
//!
//! The ends of the interval are one: the gaps are those of a circle, which a sequence that begins at 0 cuts at 0.

use serde::{Deserialize, Serialize};

use super::steps;
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `line-steps`.
pub static LINE_STEPS: LineStepsKind = LineStepsKind;

/// The kind of experiment `line-steps`.
pub struct LineStepsKind;

static ABOUT: About = About {
    key: "line-steps",
    title: "Points on a line, one by one",
    summary: "The points of a one-dimensional sequence, one by one, each with the gap into which it falls.",
    file: "kinds/line_steps.rs",
    source: include_str!("line_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through points on a line can choose.
    pub struct LineSteps {
        /// The sampler, with an optional scramble: a sequence.
        sampler: Method = "van-der-corput",
        /// How many points, one step each.
        n: usize [in 2..=64] = 16,
    }
}

/// The points.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    points: Vec<f64>,
    /// The gap into which each point after the first falls: from, to, which may be above 1.
    gaps: Vec<(f64, f64)>,
    /// Whether it was a biggest gap, and whether the point halves it.
    biggest: Vec<bool>,
    halved: Vec<bool>,
}

impl Kind for LineStepsKind {
    type Parameters = LineSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &LineSteps, problems: &mut Problems<'_, '_>) {
        problems.admit("sampler", &[p.sampler], &[p.n], 1);
    }

    fn weight(&self, p: &LineSteps) -> u64 {
        (p.n * p.n) as u64
    }

    fn run(&self, p: &LineSteps, seed: Seed) -> Result<Data, Failure> {
        let points = p.sampler.points(p.n, 1, seed.named(ABOUT.key).named(&p.sampler.name()));
        let points: Vec<f64> = points.map_err(|refused| Failure::of("sampler", refused.to_string()))?.axis(0).collect();
        let mut data = Data { points, gaps: Vec::new(), biggest: Vec::new(), halved: Vec::new() };
        for count in 1..data.points.len() {
            let (before, x) = (&data.points[..count], data.points[count]);
            let gaps = gaps(before);
            let most = gaps.iter().map(|gap| gap.1 - gap.0).fold(0.0, f64::max);
            let holds = |gap: &(f64, f64)| (gap.0 <= x && x < gap.1) || (gap.0 <= x + 1.0 && x + 1.0 < gap.1);
            let Some(&(from, to)) = gaps.iter().find(|gap| holds(gap)) else { continue };
            let at = if x < from { x + 1.0 } else { x };
            data.gaps.push((from, to));
            data.biggest.push(to - from >= most * (1.0 - 1e-12));
            data.halved.push((at - f64::midpoint(from, to)).abs() <= 1e-12);
        }
        Ok(data)
    }

    fn values(&self, p: &LineSteps, data: &Data) -> Values {
        let mut values = Values::new();
        let (name, all) = (p.sampler.name(), |flags: &[bool]| flags.iter().all(|&flag| flag));
        values.integer("steps", data.points.len() as i64);
        values.boolean(format!("biggest.every-step.{name}"), all(&data.biggest));
        values.boolean(format!("halved.every-step.{name}"), all(&data.halved));
        values.integer(format!("biggest.{name}"), data.biggest.iter().filter(|&&flag| flag).count() as i64);
        let last = gaps(&data.points).into_iter().map(|gap| gap.1 - gap.0);
        values.number(format!("gap.max.{name}"), last.clone().fold(0.0, f64::max));
        values.number(format!("gap.min.{name}"), last.fold(1.0, f64::min));
        values
    }

    fn tables(&self, _: &LineSteps, data: &Data) -> Vec<Frame> {
        let gaps = || std::iter::once((f64::NAN, f64::NAN)).chain(data.gaps.iter().copied());
        let frame = Frame::new("points")
            .counts("index", 0..data.points.len())
            .numbers("x", data.points.iter().copied())
            .numbers("gap from", gaps().map(|gap| gap.0))
            .numbers("gap to", gaps().map(|gap| gap.1));
        vec![frame]
    }

    fn draw(&self, p: &LineSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &LineSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The gaps between neighbours on the circle, in order; the last reaches beyond 1.
fn gaps(points: &[f64]) -> Vec<(f64, f64)> {
    let mut sorted = points.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let around = sorted.first().map(|first| first + 1.0);
    let next: Vec<f64> = sorted.iter().skip(1).copied().chain(around).collect();
    sorted.into_iter().zip(next).collect()
}

mod drawing {
    //! The line, and its words.

    use super::{Data, LineSteps, steps};
    use crate::chart::number::significant;
    use crate::chart::{
        Axis, Boxes, Chart, ChartError, Corner, Drawing, Key, Marker, Marks, Note, Panel, Role, Segments, Sheet, Steps,
        Style,
    };

    pub(super) fn draw(p: &LineSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new();
        for index in 0..data.points.len() {
            steps.push(Chart::new(panel(p, data, index)).key(Key::Hidden), caption(data, index));
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(p: &LineSteps, data: &Data, index: usize) -> Panel {
        let ticks = [(0.0, "0"), (0.25, "1/4"), (0.5, "1/2"), (0.75, "3/4"), (1.0, "1")];
        let ticks = ticks.into_iter().map(|(at, label)| (at, label.into())).collect();
        let x = Axis::linear("").range(-0.02, 1.02).ticks_at(ticks);
        let y = Axis::linear("").range(-0.1, 1.1).hidden();
        let mut panel = Panel::new(x, y)
            .ratio(0.17)
            .with(Segments::new(vec![[(0.0, 0.3), (1.0, 0.3)]]).style(Style::new(Role::Axis)));
        if let Some(&(from, to)) = index.checked_sub(1).and_then(|gap| data.gaps.get(gap)) {
            // What reaches beyond 1 goes on at 0.
            let parts = [(from, to.min(1.0)), (0.0, to - 1.0)].into_iter().filter(|part| part.1 > part.0);
            panel = panel.with(Boxes::new(parts.map(|(from, to)| [(from, 0.12), (to, 0.48)]).collect()));
        }
        let style = Style::of(&p.sampler.name()).marker(Marker::Disc);
        for &x in data.points.iter().take(index) {
            panel = panel.with(Marks::new(vec![(x, 0.3)]).style(style).size(8.0));
        }
        let x = data.points.get(index).copied().unwrap_or(0.0);
        let name = Note::new((x, 0.5), steps::fraction(x)).corner(Corner::Above).role(Role::Accent);
        panel.with(Marks::new(vec![(x, 0.3)]).style(Style::ACCENT).size(10.0)).with(name)
    }

    fn caption(data: &Data, index: usize) -> String {
        let x = steps::fraction(data.points.get(index).copied().unwrap_or(0.0));
        let Some(gap) = index.checked_sub(1) else { return format!("Point 0 is at {x}.") };
        let (from, to) = data.gaps.get(gap).copied().unwrap_or_default();
        let flag = |flags: &[bool]| flags.get(gap).copied().unwrap_or(false);
        let how = if flag(&data.halved) { "into the middle of" } else { "into" };
        let which = if flag(&data.biggest) { "a biggest gap" } else { "a gap that is not the biggest" };
        let around = if to > 1.0 {
            format!("from {} around to {}", steps::fraction(from), steps::fraction(to - 1.0))
        } else {
            format!("from {} to {}", steps::fraction(from), steps::fraction(to))
        };
        format!("Point {index}, {x}, falls {how} {which}, {around}.")
    }

    pub(super) fn alt(p: &LineSteps, data: &Data) -> String {
        let biggest = data.biggest.iter().filter(|&&flag| flag).count();
        let halved = data.halved.iter().filter(|&&flag| flag).count();
        let count = data.gaps.len();
        let last = super::gaps(&data.points).into_iter().map(|gap| gap.1 - gap.0).fold(0.0, f64::max);
        format!(
            "{} steps: the points of {} on the unit interval, one by one, each with the gap into which it falls. {biggest} of \
             {count} fall into a biggest gap, {halved} of {count} halve their gap. At the end the largest gap is {}.",
            data.points.len(),
            p.sampler.title(),
            significant(last, 3)
        )
    }
}
