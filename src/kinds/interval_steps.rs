//! Elementary intervals, shape by shape: b^k by b^(m - k) boxes over b^m points, and those marked that do not hold one point.
//!
//! A (0, m, 2)-net has one point in every box of every shape (Niederreiter 1987, doi 10.1007/BF01294651).

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::samplers::digits::logarithm;
use crate::seed::Seed;

/// The kind `interval-steps`.
pub static INTERVAL_STEPS: IntervalStepsKind = IntervalStepsKind;

/// The kind of experiment `interval-steps`.
pub struct IntervalStepsKind;

static ABOUT: About = About {
    key: "interval-steps",
    title: "Elementary intervals, shape by shape",
    summary: "Every shape of elementary interval over sets of b^m points: the intervals that do not hold exactly one point are marked.",
    file: "kinds/interval_steps.rs",
    source: include_str!("interval_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through the elementary intervals can choose.
    pub struct IntervalSteps {
        /// The samplers, each with an optional scramble, one panel each.
        samplers: Vec<Method> [or sampler] = "sobol",
        /// How many points: a power of the base.
        n: usize [in 2..=256] = 16,
        /// The base of the intervals.
        base: usize [in 2..=16] = 2,
    }
}

/// The sets.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    sets: Vec<Set>,
    /// Boxes along x and along y, a shape each.
    shapes: Vec<(u32, u32)>,
}

/// The points of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Set {
    method: String,
    title: String,
    places: Vec<Place>,
    /// Of each shape the boxes that do not hold one point: column, row, how many points.
    violated: Vec<Vec<(u32, u32, u32)>>,
}

impl Kind for IntervalStepsKind {
    type Parameters = IntervalSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &IntervalSteps, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, &[p.n], 2);
        if logarithm(p.n as u64, p.base as u32).is_none() {
            let message = format!("{} is no power of the base {}", p.n, p.base);
            let powers = std::iter::successors(Some(p.base), |power| Some(power * p.base));
            let power = powers.take_while(|&power| power <= p.n).last().unwrap_or(p.base);
            let help = format!("the nearest powers are {power} and {}", power * p.base);
            problems.at("n", Code::Count, message, Some(help));
        }
        steps::check_panels(p.samplers.len(), "samplers", problems);
    }

    fn weight(&self, p: &IntervalSteps) -> u64 {
        (p.n * p.samplers.len()) as u64
    }

    fn run(&self, p: &IntervalSteps, seed: Seed) -> Result<Data, Failure> {
        let m = logarithm(p.n as u64, p.base as u32).unwrap_or(0);
        let shapes = steps::shapes(p.base, m);
        let set = |method: &Method| {
            let stream = seed.named(ABOUT.key).named(&method.name()).at(p.n as u64);
            let points =
                method.points(p.n, 2, stream).map_err(|refused| Failure::of("samplers", refused.to_string()))?;
            let places = steps::places(&points);
            let violated = shapes.iter().map(|&shape| steps::not_one(&places, shape)).collect();
            Ok(Set { method: method.name(), title: method.title(), places, violated })
        };
        let sets = p.samplers.iter().map(set).collect::<Result<_, Failure>>()?;
        Ok(Data { sets, shapes: shapes.iter().map(|&(columns, rows)| (columns as u32, rows as u32)).collect() })
    }

    fn values(&self, _: &IntervalSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("shapes", data.shapes.len() as i64);
        for set in &data.sets {
            values.integer(format!("violations.{}", set.method), set.violations() as i64);
            for (violated, (columns, rows)) in set.violated.iter().zip(&data.shapes) {
                values.integer(format!("violations.{}.{columns}x{rows}", set.method), violated.len() as i64);
            }
        }
        values
    }

    fn tables(&self, _: &IntervalSteps, data: &Data) -> Vec<Frame> {
        let rows = || data.sets.iter().flat_map(|set| set.violated.iter().zip(&data.shapes).map(move |row| (set, row)));
        let frame = Frame::new("intervals")
            .text("sampler", rows().map(|(set, _)| set.method.clone()))
            .counts("boxes along x", rows().map(|(_, (_, shape))| shape.0 as usize))
            .counts("boxes along y", rows().map(|(_, (_, shape))| shape.1 as usize))
            .counts("violated", rows().map(|(_, (violated, _))| violated.len()));
        vec![frame]
    }

    fn draw(&self, p: &IntervalSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &IntervalSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Set {
    fn violations(&self) -> usize {
        self.violated.iter().map(Vec::len).sum()
    }
}

mod drawing {
    //! The shapes, and their words.

    use super::{Data, IntervalSteps, Set};
    use crate::chart::{Chart, ChartError, Drawing, Key, Marker, Marks, Panel, Sheet, Steps, Strata, Style};
    use crate::kinds::steps;
    use std::fmt::Write as _;

    pub(super) fn draw(p: &IntervalSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = match data.sets.len() {
            1 => Steps::new(),
            _ => Steps::new().small(290.0).key_steps([1, data.shapes.len() / 2 + 1]),
        };
        for (index, &(columns, rows)) in data.shapes.iter().enumerate() {
            let panels = data.sets.iter().map(|set| panel(data, set, index)).collect();
            let count = |set: &Set| set.violated.get(index).map_or(0, Vec::len);
            let mut caption = format!("${columns} \\times {rows}$ elementary intervals of volume 1/{}", p.n);
            if let [set] = data.sets.as_slice() {
                match count(set) {
                    0 => caption.push_str(": one point in each."),
                    1 => caption.push_str(": one does not hold exactly one point."),
                    many => {
                        let _ = write!(caption, ": {many} do not hold exactly one point.");
                    }
                }
            } else {
                let counts: Vec<String> = data.sets.iter().map(|s| format!("{} {}", s.title, count(s))).collect();
                let _ = write!(caption, ", violated: {}.", counts.join(", "));
            }
            steps.push(Chart::grid(panels).key(Key::Hidden), caption);
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(data: &Data, set: &Set, index: usize) -> Panel {
        let shape = data.shapes.get(index).copied().unwrap_or((1, 1));
        let mut panel = Panel::unit_square().strata(Strata::boxes(shape.0, shape.1));
        // The points stay where they are: inside their boxes of all shapes.
        panel = data.shapes.iter().fold(panel, |panel, &(x, y)| panel.keeping(Strata::boxes(x, y)));
        if data.sets.len() > 1 {
            panel = panel.title(set.title.as_str());
        }
        let odd = set.violated.get(index).map(Vec::as_slice).unwrap_or_default();
        panel = panel.with_all(steps::marked(odd, shape));
        panel.with(Marks::new(set.places.clone()).style(Style::of(&set.method).marker(Marker::Disc)).size(8.0))
    }

    pub(super) fn alt(p: &IntervalSteps, data: &Data) -> String {
        let mut text = format!(
            "{} steps: {} points in the unit square under every shape of elementary interval in base {}, from {} boxes \
             along y to {} along x.",
            data.shapes.len(),
            p.n,
            p.base,
            p.n,
            p.n
        );
        for set in &data.sets {
            let total = set.violated.len() * p.n;
            let _ = match set.violations() {
                0 => write!(text, " {}: each of the {total} intervals holds one point.", set.title),
                many => write!(text, " {}: {many} of the {total} intervals do not hold one point.", set.title),
            };
        }
        text
    }
}
