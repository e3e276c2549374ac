//! Projections: pairs of axes of point sets of many dimensions.
//!
//! A set can be even in the whole cube and poor in the projection that an integrand sees. Each pair of axes is a panel; its
//! correlation is Pearson's r, and where n is a power of the base the elementary intervals that do not hold one point are counted.

use serde::{Deserialize, Serialize};

use super::placing::Placing;
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::metrics::{correlation, nets};
use crate::parameters::{Pair, parameters};
use crate::points::Points;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `projections`.
pub static PROJECTIONS: ProjectionsKind = ProjectionsKind;

/// The kind of experiment that shows pairs of axes.
pub struct ProjectionsKind;

static ABOUT: About = About {
    key: "projections",
    title: "Projections",
    summary: "Chosen pairs of axes of point sets of many dimensions, with their correlations and violated intervals.",
    file: "kinds/projections.rs",
    source: include_str!("projections.rs"),
    papers: &[],
};

parameters! {
    /// What a drawing of projections can choose.
    pub struct Projections {
        /// The samplers, each with an optional scramble: one row of panels each, or one column if there is one pair.
        samplers: Vec<Method> [or sampler],
        /// How many points each set has.
        n: usize [in 2..=65_536] = 256,
        /// The pairs of axes, counted from 1.
        pairs: Vec<Pair> [in 1..=256] = [[1, 2]],
        /// The dimensions of the sets; if not given, as many as the largest axis.
        dimensions: Option<usize> [in 2..=256],
        /// The base of the elementary intervals that are counted.
        base: usize [in 2..=64] = 2,
    }
}

/// The projections, sampler by sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    sets: Vec<Set>,
}

/// The projections of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Set {
    method: String,
    title: String,
    projections: Vec<Projection>,
}

/// One pair of axes.
#[derive(Debug, Serialize, Deserialize)]
struct Projection {
    points: Vec<(f64, f64)>,
    correlation: Option<f64>,
    /// Elementary intervals of volume 1/n that do not hold one point, where n is a power of the base.
    violations: Option<u64>,
}

impl Kind for ProjectionsKind {
    type Parameters = Projections;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Projections) {
        p.dimensions = Some(dimensions(p));
    }

    fn check(&self, p: &Projections, problems: &mut Problems<'_, '_>) {
        let d = dimensions(p);
        problems.admit("samplers", &p.samplers, &[p.n], d);
        for (index, &Pair(i, j)) in p.pairs.iter().enumerate() {
            if i == j {
                let message = format!("a projection needs two axes, not {i} twice");
                problems.element("pairs", index, Code::Combination, message, None);
            } else if i.max(j) > d {
                let message = format!("axis {} is beyond the {d} dimensions of the sets", i.max(j));
                problems.element("pairs", index, Code::OutOfRange, message, None);
            }
        }
        let panels = p.samplers.len() * p.pairs.len();
        if panels > 12 {
            let message = format!("{panels} projections are more than the 12 panels that a figure can hold");
            problems.at("pairs", Code::OutOfRange, message, Some("take fewer pairs or samplers".to_owned()));
        }
    }

    fn weight(&self, p: &Projections) -> u64 {
        (p.n as u64).saturating_mul((p.samplers.len() * dimensions(p)) as u64)
    }

    fn run(&self, p: &Projections, seed: Seed) -> Result<Data, Failure> {
        let placing = Placing { kind: ABOUT.key, d: dimensions(p), seed };
        let sets = placing.measured(&p.samplers, &[p.n], 1, |method, points| {
            let projections = p.pairs.iter().filter_map(|&pair| project(points, pair, p.base as u32)).collect();
            Ok(Set { method: method.name(), title: method.title(), projections })
        })?;
        Ok(Data { sets: sets.into_iter().flatten().flatten().collect() })
    }

    fn values(&self, p: &Projections, data: &Data) -> Values {
        let mut values = Values::new();
        for set in &data.sets {
            for (projection, Pair(i, j)) in set.projections.iter().zip(&p.pairs) {
                let name = format!("{}.{i}-{j}", set.method);
                values.number(format!("correlation.{name}"), projection.correlation.unwrap_or(f64::NAN));
                if let Some(violations) = projection.violations {
                    values.integer(format!("violations.{name}"), violations as i64);
                }
            }
        }
        values
    }

    fn tables(&self, p: &Projections, data: &Data) -> Vec<Frame> {
        let projections =
            || data.sets.iter().flat_map(|set| set.projections.iter().zip(&p.pairs).map(move |both| (set, both)));
        let rows = || projections().flat_map(|(set, (one, pair))| one.points.iter().map(move |at| (set, pair, at)));
        let points = Frame::new("projections")
            .text("sampler", rows().map(|(set, ..)| set.method.clone()))
            .counts("first axis", rows().map(|(_, pair, _)| pair.0))
            .counts("second axis", rows().map(|(_, pair, _)| pair.1))
            .numbers("x", rows().map(|(.., at)| at.0))
            .numbers("y", rows().map(|(.., at)| at.1));
        let correlations = Frame::new("correlations")
            .text("sampler", projections().map(|(set, _)| set.method.clone()))
            .counts("first axis", projections().map(|(_, (_, pair))| pair.0))
            .counts("second axis", projections().map(|(_, (_, pair))| pair.1))
            .numbers("correlation", projections().map(|(_, (one, _))| one.correlation.unwrap_or(f64::NAN)));
        vec![points, correlations]
    }

    fn draw(&self, p: &Projections, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Projections, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The dimensions of the sets.
fn dimensions(p: &Projections) -> usize {
    p.dimensions.unwrap_or_else(|| p.pairs.iter().map(|pair| pair.0.max(pair.1)).max().unwrap_or(2).max(2))
}

/// The projection of `points` on a pair of axes that they have.
fn project(points: &Points, Pair(i, j): Pair, base: u32) -> Option<Projection> {
    let (i, j) = (i.checked_sub(1)?, j.checked_sub(1)?);
    let pairs: Vec<(f64, f64)> = points.axis(i).zip(points.axis(j)).collect();
    let plane = Points::from_rows(2, pairs.iter().flat_map(|&(x, y)| [x, y]).collect())?;
    Some(Projection {
        correlation: correlation::pearson(&plane, 0, 1),
        violations: nets::violations(&plane, base, 0),
        points: pairs,
    })
}

mod drawing {
    //! The panels of pairs, and their words.

    use std::fmt::Write as _;

    use super::{Data, Projection, Projections, Set};
    use crate::chart::number::{fixed, integer};
    use crate::chart::{Chart, ChartError, Drawing, Key, Marker, Marks, Panel, Sheet, Strata, Style};
    use crate::parameters::Pair;

    pub(super) fn draw(p: &Projections, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let panels = data.sets.iter().flat_map(|set| set.projections.iter().zip(&p.pairs).map(move |one| (set, one)));
        let panels = panels.map(|(set, (projection, pair))| panel(p, set, projection, *pair)).collect();
        let chart = Chart::grid(panels).key(Key::Hidden);
        // One row for each sampler, as far as the panels stay readable.
        let chart = if (2..=3).contains(&p.pairs.len()) { chart.columns(p.pairs.len()) } else { chart };
        Ok(chart.draw(sheet)?.into())
    }

    fn panel(p: &Projections, set: &Set, projection: &Projection, Pair(i, j): Pair) -> Panel {
        let axes = format!("axes\u{a0}{i},\u{a0}{j}");
        let title = if p.samplers.len() > 1 { format!("{}: {axes}", set.title) } else { axes };
        let marks = Marks::new(projection.points.clone()).style(Style::of(&set.method).marker(Marker::Disc));
        let panel = Panel::unit_square().title(title).with(marks);
        match cells(p) {
            Some(side) => panel.strata(Strata::boxes(side, side)),
            None => panel,
        }
    }

    /// How many cells a side has where a pair of axes can hold one point in each: base by base cells of base^2 points.
    fn cells(p: &Projections) -> Option<u32> {
        u32::try_from(p.base).ok().filter(|_| p.base.checked_mul(p.base) == Some(p.n))
    }

    pub(super) fn alt(p: &Projections, data: &Data) -> String {
        let mut text = format!("Projections of {} points of {} dimensions.", integer(p.n as i64), super::dimensions(p));
        for set in &data.sets {
            let _ = write!(text, " {}:", set.title);
            for (index, (projection, Pair(i, j))) in set.projections.iter().zip(&p.pairs).enumerate() {
                let comma = if index > 0 { ";" } else { "" };
                let _ = write!(text, "{comma} axes {i} and {j}");
                if let Some(correlation) = projection.correlation {
                    let _ = write!(text, " have the correlation {}", fixed(correlation, 3));
                }
                if let Some(violations) = projection.violations {
                    let _ = write!(text, ", {violations} elementary intervals in base {} are violated", p.base);
                }
            }
            text.push('.');
        }
        text
    }
}
