//! Pi by darts: four times the share of points in the quarter disk estimates pi, for more and more N.
//!
//! A point is inside with probability pi/4, so that the standard error of the estimate is sqrt(pi (4 - pi) / N).

use serde::{Deserialize, Serialize};

use super::steps::{self, Place, check_count};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::{Counts, parameters};
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `pi-steps`.
pub static PI_STEPS: PiStepsKind = PiStepsKind;

/// The kind of experiment `pi-steps`.
pub struct PiStepsKind;

static ABOUT: About = About {
    key: "pi-steps",
    title: "Pi by darts, step by step",
    summary: "Points in the unit square inside and outside of the quarter disk, and the estimate of pi that they give, for more and more N.",
    file: "kinds/pi_steps.rs",
    source: include_str!("pi_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through darts for pi can choose.
    pub struct PiSteps {
        /// The sampler, with an optional scramble.
        sampler: Method = "independent",
        /// The counts, one step each.
        n: Counts [in 1..=1024] = "2^0..2^8",
    }
}

/// The darts.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// Of each count the points, those inside of the quarter disk first, and how many these are.
    steps: Vec<(Vec<Place>, u32)>,
    /// Whether each set holds the one before.
    grows: bool,
}

impl Kind for PiStepsKind {
    type Parameters = PiSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &PiSteps, problems: &mut Problems<'_, '_>) {
        problems.admit("sampler", &[p.sampler], p.n.as_slice(), 2);
        check_count(p.n.as_slice().len(), "n", problems);
    }

    fn weight(&self, p: &PiSteps) -> u64 {
        p.n.total()
    }

    fn run(&self, p: &PiSteps, seed: Seed) -> Result<Data, Failure> {
        let stream = seed.named(ABOUT.key).named(&p.sampler.name());
        let step = |n: usize| {
            let points =
                p.sampler.points(n, 2, stream).map_err(|refused| Failure::of("sampler", refused.to_string()))?;
            Ok(steps::places(&points))
        };
        let sets: Vec<Vec<Place>> = p.n.iter().map(step).collect::<Result<_, Failure>>()?;
        let grows = sets.windows(2).all(|two| two[1].starts_with(&two[0]));
        let sort = |set: Vec<Place>| {
            let inside = set.iter().filter(|at| at.0 * at.0 + at.1 * at.1 < 1.0).count() as u32;
            (set, inside)
        };
        Ok(Data { steps: sets.into_iter().map(sort).collect(), grows })
    }

    fn values(&self, p: &PiSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", std::f64::consts::PI);
        for (places, inside) in &data.steps {
            let name = format!("estimate.{}.{}", p.sampler.name(), places.len());
            if p.sampler.name() == "independent" {
                values.estimate(name, estimate(places, *inside), error(places.len()));
            } else {
                values.number(name, estimate(places, *inside));
            }
        }
        values
    }

    fn tables(&self, _: &PiSteps, data: &Data) -> Vec<Frame> {
        let frame = Frame::new("estimates")
            .counts("n", data.steps.iter().map(|step| step.0.len()))
            .counts("inside", data.steps.iter().map(|step| step.1 as usize))
            .numbers("estimate", data.steps.iter().map(|step| estimate(&step.0, step.1)));
        vec![frame]
    }

    fn draw(&self, p: &PiSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &PiSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// Four times the share inside.
fn estimate(places: &[Place], inside: u32) -> f64 {
    4.0 * f64::from(inside) / places.len().max(1) as f64
}

/// The standard error of the estimate from `n` independent points.
fn error(n: usize) -> f64 {
    let pi = std::f64::consts::PI;
    (pi * (4.0 - pi) / n.max(1) as f64).sqrt()
}

mod drawing {
    //! The darts, and their words.

    use std::fmt::Write as _;

    use super::{Data, PiSteps, Place, error, estimate};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Chart, ChartError, Disks, Drawing, Key, Marker, Marks, Panel, Role, Sheet, Steps, Style};

    pub(super) fn draw(p: &PiSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new().key_steps([data.steps.len() / 3 + 1, 2 * data.steps.len() / 3 + 1]);
        for (index, (places, inside)) in data.steps.iter().enumerate() {
            let chart = Chart::new(panel(data, &data.steps[..=index])).key(Key::Above);
            let n = places.len();
            let mut caption = format!(
                "$N = {n}$: {inside} inside, $4 \\cdot {inside}/{n}$ is {}",
                fixed(estimate(places, *inside), 4)
            );
            if p.sampler.name() == "independent" {
                let _ = write!(caption, ", with a standard error of {}", significant(error(n), 2));
            }
            steps.push(chart, caption + ".");
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(data: &Data, steps: &[(Vec<Place>, u32)]) -> Panel {
        let most = data.steps.iter().map(|step| step.0.len()).max().unwrap_or(1);
        let size = if most > 256 { 3.5 } else { 5.5 };
        let inside = |at: &Place| at.0 * at.0 + at.1 * at.1 < 1.0;
        let styles = [(true, Style::new(Role::Blue)), (false, Style::new(Role::Vermilion).marker(Marker::Ring))];
        let mut panel = Panel::unit_square().with(Disks::new(vec![(0.0, 0.0)], 1.0).style(Style::new(Role::Muted)));
        for (within, style) in styles {
            let label = if within { "inside" } else { "outside" };
            panel = panel.with(Marks::new(Vec::new()).style(style).label(label));
        }
        // Of a sequence each batch is drawn once, in the step that brings it.
        let first = if data.grows { 0 } else { steps.len().saturating_sub(1) };
        let mut from = 0;
        for (places, _) in steps.iter().skip(first) {
            let batch = places.get(from..).unwrap_or_default();
            for (within, style) in styles {
                let those = batch.iter().filter(|at| inside(at) == within).copied().collect();
                panel = panel.with(Marks::new(those).style(style).size(if within { size } else { size * 1.15 }));
            }
            from = if data.grows { places.len() } else { 0 };
        }
        panel
    }

    pub(super) fn alt(p: &PiSteps, data: &Data) -> String {
        let (Some(first), Some(last)) = (data.steps.first(), data.steps.last()) else { return String::new() };
        format!(
            "{} steps: points of {} in the unit square with a quarter disk, from N = {} to {}. Of the last {} are inside, so \
             that pi is estimated as {}.",
            data.steps.len(),
            p.sampler.title(),
            first.0.len(),
            integer(last.0.len() as i64),
            last.1,
            fixed(estimate(&last.0, last.1), 4)
        )
    }
}
