//! Boxes over a point set: what the star discrepancy measures, box by box, and last the worst box of all, which is exact.
//!
//! The boxes before it have uniform random corners; no such box can be worse than the star discrepancy.

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::metrics::star::star_discrepancy;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `box-steps`.
pub static BOX_STEPS: BoxStepsKind = BoxStepsKind;

/// The kind of experiment `box-steps`.
pub struct BoxStepsKind;

static ABOUT: About = About {
    key: "box-steps",
    title: "Boxes over a point set",
    summary: "Anchored boxes over a point set: the share of points inside against the volume, the worst box so far, and the worst of all.",
    file: "kinds/box_steps.rs",
    source: include_str!("box_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through boxes can choose.
    pub struct BoxSteps {
        /// The sampler, with an optional scramble.
        sampler: Method = "independent",
        /// How many points.
        n: usize [in 1..=256] = 16,
        /// How many random boxes come before the worst.
        boxes: usize [in 1..=40] = 11,
    }
}

/// The points and the boxes.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    places: Vec<Place>,
    boxes: Vec<Anchored>,
    star: f64,
}

/// A box between the origin and its corner.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Anchored {
    corner: Place,
    /// The points inside; with those on its upper sides where that makes the difference larger.
    inside: u32,
    /// Whether those on its upper sides count.
    closed: bool,
    volume: f64,
    difference: f64,
}

impl Kind for BoxStepsKind {
    type Parameters = BoxSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &BoxSteps, problems: &mut Problems<'_, '_>) {
        problems.admit("sampler", &[p.sampler], &[p.n], 2);
    }

    fn weight(&self, p: &BoxSteps) -> u64 {
        (p.n * (p.n + p.boxes)) as u64
    }

    fn run(&self, p: &BoxSteps, seed: Seed) -> Result<Data, Failure> {
        let stream = seed.named(ABOUT.key);
        let points = p.sampler.points(p.n, 2, stream.named(&p.sampler.name()).at(p.n as u64));
        let points = points.map_err(|refused| Failure::of("sampler", refused.to_string()))?;
        let places = steps::places(&points);
        let mut random = stream.named("boxes").generator();
        let mut boxes: Vec<Anchored> =
            (0..p.boxes).map(|_| anchored(&places, (random.uniform(), random.uniform()))).collect();
        let worst = star_discrepancy(&points).map_err(|_| Failure::of("n", "no star discrepancy is known of it"))?;
        if let [x, y] = worst.extremal[..] {
            boxes.push(anchored(&places, (x, y)));
        }
        Ok(Data { places, boxes, star: worst.value })
    }

    fn values(&self, p: &BoxSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("steps", data.boxes.len() as i64);
        values.number(format!("star.{}", p.sampler.name()), data.star);
        for (index, one) in data.boxes.iter().enumerate() {
            values.number(format!("difference.{}", index + 1), one.difference);
        }
        let largest = data.boxes.iter().take(p.boxes).map(|one| one.difference).fold(0.0, f64::max);
        values.number("largest.random", largest);
        values
    }

    fn tables(&self, _: &BoxSteps, data: &Data) -> Vec<Frame> {
        let boxes = || data.boxes.iter();
        let frame = Frame::new("boxes")
            .numbers("x", boxes().map(|one| one.corner.0))
            .numbers("y", boxes().map(|one| one.corner.1))
            .counts("points inside", boxes().map(|one| one.inside as usize))
            .numbers("volume", boxes().map(|one| one.volume))
            .numbers("difference", boxes().map(|one| one.difference));
        vec![frame, steps::table([data.places.as_slice()])]
    }

    fn draw(&self, p: &BoxSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &BoxSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The box with this corner: open, or closed where that makes its difference larger.
fn anchored(places: &[Place], corner: Place) -> Anchored {
    let n = places.len().max(1) as f64;
    let volume = corner.0 * corner.1;
    let open = places.iter().filter(|at| at.0 < corner.0 && at.1 < corner.1).count();
    let closed = places.iter().filter(|at| at.0 <= corner.0 && at.1 <= corner.1).count();
    let difference = |inside: usize| (inside as f64 / n - volume).abs();
    let larger = difference(closed) > difference(open);
    let inside = if larger { closed } else { open };
    Anchored { corner, inside: inside as u32, closed: larger, volume, difference: difference(inside) }
}

mod drawing {
    //! The boxes, and their words.

    use super::{Anchored, BoxSteps, Data};
    use crate::chart::number::{fixed, significant};
    use crate::chart::{
        Chart, ChartError, Drawing, Key, Marker, Marks, Panel, Region, Role, Sheet, Steps, Strata, Style,
    };

    pub(super) fn draw(p: &BoxSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new();
        let mut worst: Option<Anchored> = None;
        for (index, &one) in data.boxes.iter().enumerate() {
            let leads = worst.is_none_or(|worst| one.difference > worst.difference);
            steps.push(Chart::new(panel(p, data, one, worst.filter(|_| !leads))).key(Key::Hidden), {
                let last = index + 1 == data.boxes.len();
                caption(p, one, if last { "of all: the star discrepancy" } else { "so far" }, leads || last)
            });
            worst = if leads { Some(one) } else { worst };
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(p: &BoxSteps, data: &Data, one: Anchored, worst: Option<Anchored>) -> Panel {
        let region = |one: Anchored, role| Region::new((0.0, 0.0), one.corner).style(Style::new(role));
        let panel = Panel::unit_square().keeping(Strata::slabs(p.n as u32));
        let panel = panel.with_all(worst.map(|worst| region(worst, Role::Muted)));
        let panel = panel.with(region(one, if worst.is_none() { Role::Accent } else { Role::Blue }));
        panel.with(Marks::new(data.places.clone()).style(Style::of(&p.sampler.name()).marker(Marker::Disc)).size(8.0))
    }

    fn caption(p: &BoxSteps, one: Anchored, what: &str, leads: bool) -> String {
        let Anchored { inside, closed, volume, difference, .. } = one;
        let on = if closed { " (its upper sides included)" } else { "" };
        let share = fixed(f64::from(inside) / p.n as f64, 4);
        let worst = if leads { format!(", the worst {what}") } else { String::new() };
        format!(
            "{inside} of {} points inside{on}: {share}. Volume {}. Difference {}{worst}.",
            p.n,
            fixed(volume, 4),
            fixed(difference, 4)
        )
    }

    pub(super) fn alt(p: &BoxSteps, data: &Data) -> String {
        let Some(worst) = data.boxes.last() else { return String::new() };
        format!(
            "{} steps: boxes anchored at the origin over {} points of {}. The last is the worst of all, up to ({}, {}): {} \
             points inside, volume {}; the star discrepancy is {}.",
            data.boxes.len(),
            p.n,
            p.sampler.title(),
            significant(worst.corner.0, 3),
            significant(worst.corner.1, 3),
            worst.inside,
            significant(worst.volume, 3),
            significant(data.star, 3)
        )
    }
}
