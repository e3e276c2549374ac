//! A set that grows: the points of a sampler for more and more N, coloured by their order.
//!
//! Of a sequence points are only added. A method that is no sequence has other points for each N, and all of them move: what
//! that costs is seen. The star discrepancy of every step is exact.

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::metrics::star::star_discrepancy;
use crate::parameters::{Counts, parameters};
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `growth-steps`.
pub static GROWTH_STEPS: GrowthStepsKind = GrowthStepsKind;

/// The kind of experiment `growth-steps`.
pub struct GrowthStepsKind;

static ABOUT: About = About {
    key: "growth-steps",
    title: "A set that grows",
    summary: "The points of a sampler for more and more N, coloured by their order, with the exact star discrepancy of each step.",
    file: "kinds/growth_steps.rs",
    source: include_str!("growth_steps.rs"),
    papers: &[],
};

parameters! {
    /// What a set that grows can choose.
    pub struct GrowthSteps {
        /// The sampler, with an optional scramble.
        sampler: Method = "halton",
        /// The counts, one step each.
        n: Counts [in 1..=256] = "1..16",
    }
}

/// The sets.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    steps: Vec<Step>,
    /// Whether each set begins with the one before.
    grows: bool,
}

/// One set.
#[derive(Debug, Serialize, Deserialize)]
struct Step {
    places: Vec<Place>,
    star: f64,
}

impl Kind for GrowthStepsKind {
    type Parameters = GrowthSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &GrowthSteps, problems: &mut Problems<'_, '_>) {
        problems.admit("sampler", &[p.sampler], p.n.as_slice(), 2);
        steps::check_count(p.n.as_slice().len(), "n", problems);
    }

    fn weight(&self, p: &GrowthSteps) -> u64 {
        p.n.iter().map(|n| (n * n) as u64).sum()
    }

    fn run(&self, p: &GrowthSteps, seed: Seed) -> Result<Data, Failure> {
        let stream = seed.named(ABOUT.key).named(&p.sampler.name());
        let step = |n: usize| {
            let points =
                p.sampler.points(n, 2, stream).map_err(|refused| Failure::of("sampler", refused.to_string()))?;
            let star = star_discrepancy(&points).map_or(f64::NAN, |measured| measured.value);
            Ok(Step { places: steps::places(&points), star })
        };
        let steps: Vec<Step> = p.n.iter().map(step).collect::<Result<_, Failure>>()?;
        let grows = steps.windows(2).all(|two| two[1].places.starts_with(&two[0].places));
        Ok(Data { steps, grows })
    }

    fn values(&self, p: &GrowthSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("steps", data.steps.len() as i64);
        values.boolean(format!("grows.{}", p.sampler.name()), data.grows);
        for step in &data.steps {
            values.number(format!("star.{}.{}", p.sampler.name(), step.places.len()), step.star);
        }
        values
    }

    fn tables(&self, _: &GrowthSteps, data: &Data) -> Vec<Frame> {
        let stars = Frame::new("discrepancy")
            .counts("n", data.steps.iter().map(|step| step.places.len()))
            .numbers("star discrepancy", data.steps.iter().map(|step| step.star));
        vec![steps::table(data.steps.iter().map(|step| step.places.as_slice())), stars]
    }

    fn draw(&self, p: &GrowthSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &GrowthSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

mod drawing {
    //! The sets, and their words.

    use super::{Data, GrowthSteps, Place, Step};
    use crate::chart::number::{fixed, significant};
    use crate::chart::{
        Chart, ChartError, Drawing, Key, Marker, Marks, Panel, Role, Segments, Sheet, Steps, Strata, Style,
    };

    /// The colours of the quarters of the points, in their order.
    const QUARTERS: [Role; 4] = [Role::Blue, Role::Green, Role::Ochre, Role::Vermilion];

    pub(super) fn draw(p: &GrowthSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new();
        for (index, step) in data.steps.iter().enumerate() {
            let before = index.checked_sub(1).and_then(|before| data.steps.get(before));
            steps.push(Chart::new(panel(data, &data.steps[..=index])).key(Key::Above), caption(p, data, before, step));
        }
        Ok(steps.draw(sheet)?.into())
    }

    /// The panel of the last of `steps`.
    fn panel(data: &Data, steps: &[Step]) -> Panel {
        let most = data.steps.iter().map(|step| step.places.len()).max().unwrap_or(1);
        let quarter = most.div_ceil(4);
        let style = |index: usize| Style::new(QUARTERS[(index / quarter).min(3)]).marker(Marker::Disc);
        let size = if most > 64 { 6.0 } else { 8.0 };
        let mut panel = Panel::unit_square().keeping(Strata::slabs(most as u32));
        // The key is the same in all steps; it names the indices, which begin at 0.
        for first in (0..most).step_by(quarter) {
            let last = (first + quarter).min(most) - 1;
            let label = if last == first { format!("*i* = {last}") } else { format!("*i* = {first}–{last}") };
            panel = panel.with(Marks::new(Vec::new()).style(style(first)).label(label));
        }
        let Some(step) = steps.last() else { return panel };
        let before = steps.len().checked_sub(2).and_then(|before| steps.get(before)).map_or(0, |s| s.places.len());
        let new = step.places.get(before..).filter(|new| data.grows && steps.len() > 1 && new.len() <= 16);
        panel = panel.with_all(new.map(|new| Segments::spots(new.iter().copied()).tracked("new")));
        let batches = |ends: Vec<usize>, mut panel: Panel| {
            let mut from = 0;
            for end in ends {
                for run in cut(from, end, quarter) {
                    let places: Vec<Place> = step.places.get(run.clone()).unwrap_or_default().to_vec();
                    panel = panel.with(Marks::new(places).style(style(run.start)).size(size));
                }
                from = end;
            }
            panel
        };
        // Of a sequence each batch is drawn once, in the step that brings it.
        let ends = if data.grows { steps.iter().map(|s| s.places.len()).collect() } else { vec![step.places.len()] };
        batches(ends, panel)
    }

    /// A range, cut where a quarter ends.
    fn cut(from: usize, to: usize, quarter: usize) -> Vec<std::ops::Range<usize>> {
        let mut runs = Vec::new();
        let mut start = from;
        while start < to {
            let end = ((start / quarter + 1) * quarter).min(to);
            runs.push(start..end);
            start = end;
        }
        runs
    }

    fn caption(p: &GrowthSteps, data: &Data, before: Option<&Step>, step: &Step) -> String {
        let n = step.places.len();
        let added = before.map_or(n, |before| n.saturating_sub(before.places.len()));
        let what = match (data.grows, added, before) {
            (true, 1, Some(_)) => String::new(),
            (true, more, Some(_)) => format!(" {more} more points."),
            (false, _, Some(_)) => " All points are new.".to_owned(),
            (_, _, None) => format!(" The points are those of {}.", p.sampler.title()),
        };
        format!("$N = {n}$: star discrepancy {}.{what}", fixed(step.star, 4))
    }

    pub(super) fn alt(p: &GrowthSteps, data: &Data) -> String {
        let (Some(first), Some(last)) = (data.steps.first(), data.steps.last()) else { return String::new() };
        let grows =
            if data.grows { "Each step keeps the points before." } else { "The points differ from step to step." };
        format!(
            "{} steps: the points of {} in the unit square, coloured by their order, for N from {} to {}. {grows} The star \
             discrepancy goes from {} to {}.",
            data.steps.len(),
            p.sampler.title(),
            first.places.len(),
            last.places.len(),
            significant(first.star, 3),
            significant(last.star, 3)
        )
    }
}
