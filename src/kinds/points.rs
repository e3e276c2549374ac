//! Points: point sets beside each other, with the strata that they keep or break.
//!
//! In two dimensions a set is drawn in the unit square, in one dimension on a line. What the picture suggests is counted: how
//! many points the fullest of n equal cells holds, whether each of the n slabs of every axis holds exactly one, and how close
//! the closest pair is, across the borders; on demand also the elementary intervals of one shape, and the box where the star
//! discrepancy is attained.

use serde::{Deserialize, Serialize};

use super::placing::Placing;
use super::worst_box::WorstBox;
use super::{Failure, Frame, Kind, Problems, Rest, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::metrics::dispersion::minimum_distance;
use crate::metrics::occupancy;
use crate::parameters::{Counts, Pair, choices, parameters};
use crate::points::Points as Placed;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `points`.
pub static POINTS: PointsKind = PointsKind;

/// The kind of experiment that shows point sets.
pub struct PointsKind;

static ABOUT: About = About {
    key: "points",
    title: "Point sets",
    summary: "The points of one or several samplers beside each other, with strata and the counts of points in them.",
    file: "kinds/points.rs",
    source: include_str!("points.rs"),
    papers: &[],
};

choices! {
    /// Which strata are drawn.
    pub enum Strata {
        /// None.
        None = "none",
        /// The grid of n equal cells; n must be a square.
        Cells = "cells",
        /// The n slabs of either axis.
        Slabs = "slabs",
    }
}

parameters! {
    /// What a drawing of point sets can choose.
    pub struct Points {
        /// The samplers, each with an optional scramble, one panel each.
        samplers: Vec<Method> [or sampler],
        /// How many points each set has; several counts make a row of panels for each sampler.
        n: Counts [in 1..=1_048_576] = 16,
        /// One dimension for points on a line, two for the unit square.
        dimensions: usize [in 1..=2] = 2,
        /// Which strata are drawn behind the points.
        @drawn strata: Strata = "none",
        /// The elementary intervals to draw and to count: of sides base^-k by base^-l.
        elementary: Option<Pair> [in 0..=24],
        /// The base of the elementary intervals.
        base: usize [in 2..=36] = 2,
        /// Whether the box is shown where the star discrepancy is attained.
        worst: bool = false,
        /// Whether each point has its index beside it, counted from 0.
        @drawn labels: bool = false,
        /// Whether colours show the order of the points.
        @drawn order: bool = false,
        /// Whether each point has a disk around it; opposite borders of the square meet.
        @drawn disks: bool = false,
        /// The radius of the disks; if it is not given, half of the smallest distance in the set.
        @drawn radius: Option<f64> [in 0.0..=0.5],
        /// Whether ticks at the borders show the points' coordinates on each axis.
        @drawn projections: bool = false,
    }
}

/// The sets.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// The samplers in order, each with its counts.
    sets: Vec<Set>,
    /// What else was asked for, one for each set.
    extras: Rest<Extra>,
}

/// The points of one sampler, and what is counted of them.
#[derive(Debug, Serialize, Deserialize)]
struct Set {
    method: String,
    title: String,
    /// Row by row.
    coordinates: Vec<f64>,
    /// Points in the fullest of the n cells, and how many cells are empty; where n cells make a grid.
    cells: Option<(u32, u32)>,
    /// Points in the fullest slab of each axis.
    slabs: Vec<u32>,
    /// The least distance between two points, across the borders of the cube.
    distance: Option<f64>,
}

/// What is counted of a set on demand.
#[derive(Debug, Serialize, Deserialize)]
struct Extra {
    /// Points in the fullest elementary interval, and how many intervals are empty.
    elementary: Option<(u32, u32)>,
    worst: Option<WorstBox>,
}

impl Kind for PointsKind {
    type Parameters = Points;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Points, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, p.n.as_slice(), p.dimensions);
        let odd = p.n.iter().find(|&n| p.strata == Strata::Cells && side(p, n).is_none());
        if let Some(n) = odd {
            let root = n.isqrt();
            let message = format!("{n} points have no grid of as many equal cells: n must be a square");
            let help = format!("the nearest squares are {} and {}", root * root, (root + 1) * (root + 1));
            problems.at("n", Code::Count, message, Some(help));
        }
        let panels = p.samplers.len() * p.n.as_slice().len();
        if panels > 12 {
            let message = format!("{panels} sets are more than the 12 panels that a figure can hold");
            problems.at("samplers", Code::OutOfRange, message, None);
        }
        for (asked, name, most) in [(p.labels, "labels", 256), (p.disks, "disks", 4096), (p.worst, "worst", 65_536)] {
            if asked && p.n.largest() > most {
                let message = format!("`{name}` is for at most {most} points, not for {}", p.n.largest());
                problems.at(name, Code::Combination, message, Some("drop the line, or take fewer points".to_owned()));
            }
        }
        if let Some(Pair(k, l)) = p.elementary
            && cuts(p, Pair(k, l)).is_none()
        {
            let message = format!("elementary intervals of sides {0}^-{k} and {0}^-{l} are too many to count", p.base);
            problems.at("elementary", Code::OutOfRange, message, Some("take smaller exponents".to_owned()));
        }
    }

    fn weight(&self, p: &Points) -> u64 {
        p.n.total().saturating_mul(p.samplers.len() as u64)
    }

    fn run(&self, p: &Points, seed: Seed) -> Result<Data, Failure> {
        let placing = Placing { kind: ABOUT.key, d: p.dimensions, seed };
        let both = placing.measured(&p.samplers, p.n.as_slice(), 1, |method, points| {
            Ok((count(p, method, points), extra(p, method, points)?))
        })?;
        let (sets, extras): (Vec<Set>, Vec<Option<Extra>>) = both.into_iter().flatten().flatten().unzip();
        Ok(Data { sets, extras: Rest(extras.into_iter().flatten().collect()) })
    }

    fn values(&self, p: &Points, data: &Data) -> Values {
        let mut values = Values::new();
        for (index, set) in data.sets.iter().enumerate() {
            let name = set.name(p);
            if let Some((fullest, empty)) = set.cells {
                values.integer(format!("cells.max.{name}"), i64::from(fullest));
                values.integer(format!("cells.empty.{name}"), i64::from(empty));
                values.boolean(format!("one-per-cell.{name}"), fullest == 1);
            }
            values.integer(format!("slabs.max.{name}"), i64::from(set.fullest_slab()));
            values.boolean(format!("one-per-slab.{name}"), set.fullest_slab() == 1);
            values.number(format!("distance.{name}"), set.distance.unwrap_or(f64::NAN));
            let Some(extra) = data.extras.0.get(index) else { continue };
            if let Some((fullest, empty)) = extra.elementary {
                values.integer(format!("intervals.max.{name}"), i64::from(fullest));
                values.integer(format!("intervals.empty.{name}"), i64::from(empty));
                values.boolean(format!("one-per-interval.{name}"), fullest == 1 && empty == 0);
            }
            if let Some(worst) = &extra.worst {
                values.number(format!("dstar.{name}"), worst.discrepancy);
                values.integer(format!("box.count.{name}"), i64::from(worst.count));
                values.number(format!("box.volume.{name}"), worst.volume);
            }
        }
        values
    }

    fn tables(&self, p: &Points, data: &Data) -> Vec<Frame> {
        let rows = || data.sets.iter().flat_map(|set| set.coordinates.chunks_exact(p.dimensions).enumerate());
        let names = data.sets.iter().flat_map(|set| std::iter::repeat_n(set.method.clone(), set.len()));
        let mut frame = Frame::new("points").text("sampler", names);
        if p.n.as_slice().len() > 1 {
            frame = frame.counts("n", data.sets.iter().flat_map(|set| std::iter::repeat_n(set.len(), set.len())));
        }
        frame = frame.counts("index", rows().map(|(index, _)| index));
        for axis in 0..p.dimensions {
            let name = if axis == 0 { "x" } else { "y" };
            frame = frame.numbers(name, rows().map(|(_, row)| row.get(axis).copied().unwrap_or(f64::NAN)));
        }
        vec![frame]
    }

    fn draw(&self, p: &Points, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Points, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Set {
    fn fullest_slab(&self) -> u32 {
        self.slabs.iter().copied().max().unwrap_or(0)
    }

    fn len(&self) -> usize {
        self.coordinates.len() / self.slabs.len().max(1)
    }

    /// How values name it: with its count where there are several.
    fn name(&self, p: &Points) -> String {
        if p.n.as_slice().len() > 1 { format!("{}.{}", self.method, self.len()) } else { self.method.clone() }
    }
}

/// How many cells the grid of n cells has along an axis, if n allows such a grid.
fn side(p: &Points, n: usize) -> Option<usize> {
    if p.dimensions == 1 {
        return Some(n);
    }
    Some(n.isqrt()).filter(|side| side * side == n)
}

/// Into how many slabs each axis is cut by elementary intervals, if they are not too many.
fn cuts(p: &Points, Pair(k, l): Pair) -> Option<Vec<usize>> {
    let power = |exponent: usize| p.base.checked_pow(exponent as u32);
    let cuts = [power(k)?, power(l)?];
    cuts.iter().try_fold(1_usize, |all, &cut| all.checked_mul(cut)).filter(|&all| all <= 1 << 24)?;
    Some(cuts[..p.dimensions].to_vec())
}

/// The set of `points`, with its strata counted.
fn count(p: &Points, method: &Method, points: &Placed) -> Set {
    let cells = side(p, points.len()).and_then(|side| occupancy::cells(points, &vec![side; p.dimensions]));
    let slabs = (0..p.dimensions).map(|axis| fullest(&occupancy::slabs(points, axis)).0).collect();
    Set {
        method: method.name(),
        title: method.title(),
        coordinates: points.coordinates().to_vec(),
        cells: cells.map(|counts| fullest(&counts)),
        slabs,
        distance: minimum_distance(points),
    }
}

/// The points in the fullest of some cells, and how many cells are empty.
fn fullest(counts: &[u32]) -> (u32, u32) {
    let empty = counts.iter().filter(|&&count| count == 0).count() as u32;
    (counts.iter().copied().max().unwrap_or(0), empty)
}

/// What is counted of `points` on demand, if anything is.
fn extra(p: &Points, method: &Method, points: &Placed) -> Result<Option<Extra>, Failure> {
    if p.elementary.is_none() && !p.worst {
        return Ok(None);
    }
    let counts = p.elementary.and_then(|shape| occupancy::cells(points, &cuts(p, shape)?));
    let worst = p.worst.then(|| WorstBox::of(method, points)).transpose()?;
    Ok(Some(Extra { elementary: counts.map(|counts| fullest(&counts)), worst }))
}

mod drawing {
    //! The drawing of the sets, and their words.

    use std::fmt::Write as _;

    use super::{Data, Extra, Points, Set, Strata, cuts, side};
    use crate::chart::number::{integer, significant};
    use crate::chart::{
        self, Axis, Chart, ChartError, Disks, Drawing, Key, Marker, Marks, Panel, Region, Role, Sheet, Style,
    };

    pub(super) fn draw(p: &Points, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let several = data.sets.len() > 1;
        let panels = data.sets.iter().enumerate().map(|(index, set)| panel(p, set, data.extras.0.get(index), several));
        let chart = Chart::grid(panels.collect()).key(if p.order { Key::Above } else { Key::Hidden });
        let counts = p.n.as_slice().len();
        let chart = match (p.dimensions, counts) {
            (1, _) => chart.columns(1),
            (_, 2..=3) => chart.columns(counts),
            _ => chart,
        };
        Ok(chart.draw(sheet)?.into())
    }

    fn panel(p: &Points, set: &Set, extra: Option<&Extra>, titled: bool) -> Panel {
        let place = |row: &[f64]| (row.first().copied().unwrap_or(0.0), row.get(1).copied().unwrap_or(0.5));
        let points: Vec<(f64, f64)> = set.coordinates.chunks_exact(p.dimensions).map(place).collect();
        let panel = if p.dimensions == 1 { line() } else { Panel::unit_square() };
        let panel = strata(p, set.len(), panel);
        let panel = match (titled, p.n.as_slice().len(), extra.and_then(|extra| extra.worst.as_ref())) {
            (_, _, Some(worst)) => panel
                .title(format!("{}: {} of {} in {}", set.title, worst.count, set.len(), significant(worst.volume, 3)))
                .with(Region::new((0.0, 0.0), worst.corner_in_the_plane()).style(Style::ACCENT)),
            (true, 1, None) => panel.title(set.title.as_str()),
            (true, _, None) => panel.title(format!("{}, *N*\u{a0}=\u{a0}{}", set.title, integer(set.len() as i64))),
            (false, _, None) => panel,
        };
        let panel = if p.projections && p.dimensions == 2 { panel.rug() } else { panel };
        let panel = match p.radius.or(set.distance.map(|distance| distance / 2.0)) {
            Some(radius) if p.disks && p.dimensions == 2 => panel.with(disks(&points, radius, set)),
            _ => panel,
        };
        marks(p, set, panel, points)
    }

    /// The panel with the points, as discs, since each method has a panel of its own: in one colour, or with each part of the order in its own.
    fn marks(p: &Points, set: &Set, panel: Panel, points: Vec<(f64, f64)>) -> Panel {
        let sized = |marks: Marks| if p.dimensions == 1 && set.len() <= 64 { marks.size(8.0) } else { marks };
        let named = |marks: Marks, indices: std::ops::Range<usize>| {
            if p.labels { marks.names(indices.map(|index| index.to_string())) } else { marks }
        };
        if !p.order {
            let count = points.len();
            return panel
                .with(named(sized(Marks::new(points).style(Style::of(&set.method).marker(Marker::Disc))), 0..count));
        }
        let steps = Role::STEPS.len().min(points.len());
        let border = |step: usize| points.len() * step / steps;
        let shades = (0..steps).map(|step| {
            let (from, to) = (border(step), border(step + 1));
            let label = if to - from == 1 { from.to_string() } else { format!("{from}–{}", to - 1) };
            let role = Role::STEPS[step * (Role::STEPS.len() - 1) / (steps - 1).max(1)];
            let marks = Marks::new(points[from..to].to_vec()).style(Style::new(role)).among(points.len());
            let marks = if p.n.as_slice().len() == 1 { marks.label(label) } else { marks };
            named(sized(marks), from..to)
        });
        panel.with_all(shades.collect::<Vec<_>>())
    }

    /// The disks, with copies where they reach across a border.
    fn disks(points: &[(f64, f64)], radius: f64, set: &Set) -> Disks {
        let shifts =
            |at: f64| [-1.0, 0.0, 1.0].into_iter().filter(move |shift| (at + shift - 0.5).abs() < 0.5 + radius);
        let copies =
            points.iter().flat_map(|&(x, y)| shifts(x).flat_map(move |a| shifts(y).map(move |b| (x + a, y + b))));
        Disks::new(copies.collect(), radius).style(Style::new(Style::of(&set.method).role))
    }

    /// The unit interval, as a panel of little height.
    fn line() -> Panel {
        let ticks = [(0.0, "0"), (0.25, "1/4"), (0.5, "1/2"), (0.75, "3/4"), (1.0, "1")];
        let ticks = ticks.into_iter().map(|(at, label)| (at, label.into())).collect();
        // A little room at the ends, for the mark at 0 and its label.
        let along = Axis::linear("").range(-0.03, 1.03).ticks_at(ticks);
        Panel::new(along, Axis::linear("").range(0.0, 1.0).hidden()).ratio(0.1)
    }

    /// The panel with the strata that are asked for drawn, and every stratum kept as written.
    fn strata(p: &Points, n: usize, panel: Panel) -> Panel {
        let line = p.dimensions == 1;
        let cells = side(p, n).map(|side| chart::Strata::boxes(side as u32, if line { 1 } else { side as u32 }));
        let slabs = if line { chart::Strata::boxes(n as u32, 1) } else { chart::Strata::slabs(n as u32) };
        let intervals = p.elementary.and_then(|shape| cuts(p, shape)).unwrap_or_default();
        let panel = panel.keeping(slabs);
        if line {
            let drawn = if p.strata == Strata::None { intervals.first().copied() } else { Some(n) };
            return drawn.into_iter().fold(panel, |panel, n| panel.strata(chart::Strata::boxes(n as u32, 1)));
        }
        let panel = match intervals[..] {
            [columns, rows] => panel.strata(chart::Strata::boxes(columns as u32, rows as u32)),
            _ => panel,
        };
        match (p.strata, cells) {
            (Strata::Cells, Some(cells)) => panel.strata(cells),
            (Strata::Slabs, cells) => cells.into_iter().fold(panel.strata(slabs), Panel::keeping),
            (_, cells) => cells.into_iter().fold(panel, Panel::keeping),
        }
    }

    pub(super) fn alt(p: &Points, data: &Data) -> String {
        let place = if p.dimensions == 1 { "on the unit interval" } else { "in the unit square" };
        let counts: Vec<String> = p.n.iter().map(|n| integer(n as i64)).collect();
        let s = if p.n.largest() == 1 { "" } else { "s" };
        let mut text = format!("{} point{s} {place}", counts.join(", "));
        text.push_str(match p.strata {
            Strata::None => ".",
            _ if p.dimensions == 1 => ", with as many slabs.",
            Strata::Cells => ", with the grid of as many equal cells.",
            Strata::Slabs => ", with as many slabs along each axis.",
        });
        if p.order {
            text.push_str(" Colours follow the order, from the first to the last.");
        }
        for (index, set) in data.sets.iter().enumerate() {
            let _ = match counts.len() {
                1 => write!(text, " {}:", set.title),
                _ => write!(text, " {}, N = {}:", set.title, integer(set.len() as i64)),
            };
            if let Some((fullest, empty)) = set.cells.filter(|_| p.dimensions > 1) {
                match fullest {
                    1 => text.push_str(" one point in every cell;"),
                    _ => text += format!(" up to {fullest} points in a cell, {empty} cells empty;").as_str(),
                }
            }
            match set.fullest_slab() {
                1 => text.push_str(" one point in every slab"),
                fullest => text += format!(" up to {fullest} points in a slab").as_str(),
            }
            if let Some(distance) = set.distance {
                let _ = write!(text, "; the closest two are {} apart", significant(distance, 3));
            }
            data.extras.0.get(index).into_iter().for_each(|extra| told(p, set, extra, &mut text));
            text.push('.');
        }
        text
    }

    /// What was counted on demand, in words.
    fn told(p: &Points, set: &Set, extra: &Extra, text: &mut String) {
        if let (Some((fullest, empty)), Some([columns, rest @ ..])) =
            (extra.elementary, p.elementary.and_then(|shape| cuts(p, shape)).as_deref())
        {
            let rows = rest.first().copied().unwrap_or(1);
            let _ = write!(
                text,
                "; the {columns} by {rows} elementary intervals hold up to {fullest} points, {empty} are empty"
            );
        }
        if let Some(worst) = &extra.worst {
            let _ = write!(text, "; {}", worst.words(set.len()));
        }
    }
}
