//! Points: point sets beside each other, with the strata that they keep or break.
//!
//! In two dimensions a set is drawn in the unit square, in one dimension on a line. What the picture suggests is counted: how
//! many points the fullest of n equal cells holds, whether each of the n slabs of every axis holds exactly one, and how close
//! the closest pair is.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::{choices, parameters};
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
        /// How many points each set has.
        n: usize [in 1..=65_536] = 16,
        /// One dimension for points on a line, two for the unit square.
        dimensions: usize [in 1..=2] = 2,
        /// Which strata are drawn behind the points.
        @drawn strata: Strata = "none",
        /// Whether each point has its index beside it, counted from 0.
        @drawn labels: bool = false,
    }
}

/// The sets.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    sets: Vec<Set>,
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

impl Kind for PointsKind {
    type Parameters = Points;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Points, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, &[p.n], p.dimensions);
        if p.strata == Strata::Cells && side(p).is_none() {
            let root = p.n.isqrt();
            let message = format!("{} points have no grid of as many equal cells: n must be a square", p.n);
            let help = format!("the nearest squares are {} and {}", root * root, (root + 1) * (root + 1));
            problems.at("n", Code::Count, message, Some(help));
        }
        if p.samplers.len() > 12 {
            let message = format!("{} samplers are more than the 12 panels that a figure can hold", p.samplers.len());
            problems.at("samplers", Code::OutOfRange, message, None);
        }
    }

    fn weight(&self, p: &Points) -> u64 {
        (p.n as u64).saturating_mul(p.samplers.len() as u64)
    }

    fn run(&self, p: &Points, seed: Seed) -> Result<Data, Failure> {
        let set = |method: &Method| {
            let stream = seed.named(ABOUT.key).named(&method.name()).at(p.n as u64).at(0);
            let placed = method.points(p.n, p.dimensions, stream);
            placed
                .map(|points| count(p, method, &points))
                .map_err(|refused| Failure::of("samplers", refused.to_string()))
        };
        Ok(Data { sets: p.samplers.iter().map(set).collect::<Result<_, _>>()? })
    }

    fn values(&self, _: &Points, data: &Data) -> Values {
        let mut values = Values::new();
        for set in &data.sets {
            let name = &set.method;
            if let Some((fullest, empty)) = set.cells {
                values.integer(format!("cells.max.{name}"), i64::from(fullest));
                values.integer(format!("cells.empty.{name}"), i64::from(empty));
                values.boolean(format!("one-per-cell.{name}"), fullest == 1);
            }
            values.integer(format!("slabs.max.{name}"), i64::from(set.fullest_slab()));
            values.boolean(format!("one-per-slab.{name}"), set.fullest_slab() == 1);
            values.number(format!("distance.{name}"), set.distance.unwrap_or(f64::NAN));
        }
        values
    }

    fn tables(&self, p: &Points, data: &Data) -> Vec<Frame> {
        let rows = || data.sets.iter().flat_map(|set| set.coordinates.chunks_exact(p.dimensions).enumerate());
        let names = data.sets.iter().flat_map(|set| std::iter::repeat_n(set.method.clone(), p.n));
        let mut frame = Frame::new("points").text("sampler", names).counts("index", rows().map(|(index, _)| index));
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
}

/// How many cells the grid of n cells has along an axis, if n allows such a grid.
fn side(p: &Points) -> Option<usize> {
    if p.dimensions == 1 {
        return Some(p.n);
    }
    Some(p.n.isqrt()).filter(|side| side * side == p.n)
}

/// The set of `points`, with its strata counted.
fn count(p: &Points, method: &Method, points: &Placed) -> Set {
    let slab = |coordinate: f64, slabs: usize| ((coordinate * slabs as f64) as usize).min(slabs - 1);
    let fullest = |places: &mut dyn Iterator<Item = usize>| {
        let mut counts = vec![0_u32; p.n];
        places.for_each(|place| {
            if let Some(count) = counts.get_mut(place) {
                *count += 1;
            }
        });
        let empty = counts.iter().filter(|&&count| count == 0).count() as u32;
        (counts.iter().copied().max().unwrap_or(0), empty)
    };
    let cells = side(p).map(|side| {
        let cell = |row: &[f64]| row.iter().fold(0, |cell, &coordinate| cell * side + slab(coordinate, side));
        fullest(&mut points.rows().map(cell))
    });
    let slabs = (0..p.dimensions).map(|axis| fullest(&mut points.axis(axis).map(|x| slab(x, p.n))).0).collect();
    Set {
        method: method.name(),
        title: method.title(),
        coordinates: points.coordinates().to_vec(),
        cells,
        slabs,
        distance: distance(points),
    }
}

/// The least distance between two of `points` on the torus, where opposite borders of the cube meet.
fn distance(points: &Placed) -> Option<f64> {
    let mut rows: Vec<&[f64]> = points.rows().collect();
    rows.sort_by(|a, b| a.first().unwrap_or(&0.0).total_cmp(b.first().unwrap_or(&0.0)));
    let n = rows.len();
    let wrapped = |a: f64, b: f64| (a - b).abs().min(1.0 - (a - b).abs());
    let mut least = f64::INFINITY;
    for i in 0..n {
        // Only neighbours along the first axis can be closer than the closest so far.
        for j in 1..n {
            let (a, b) = (rows[i], rows[(i + j) % n]);
            let ahead = (b[0] - a[0]).rem_euclid(1.0);
            if ahead * ahead >= least {
                break;
            }
            least = least.min(a.iter().zip(b).map(|(&a, &b)| wrapped(a, b) * wrapped(a, b)).sum());
        }
    }
    least.is_finite().then(|| least.sqrt())
}

mod drawing {
    //! The drawing of the sets, and their words.

    use std::fmt::Write as _;

    use super::{Data, Points, Set, Strata, side};
    use crate::chart::number::{integer, significant};
    use crate::chart::{self, Axis, Chart, ChartError, Drawing, Key, Marks, Panel, Role, Rule, Sheet, Style};

    pub(super) fn draw(p: &Points, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let panels = data.sets.iter().map(|set| panel(p, set, data.sets.len() > 1)).collect();
        let chart = Chart::grid(panels).key(Key::Hidden);
        let chart = if p.dimensions == 1 { chart.columns(1) } else { chart };
        Ok(chart.draw(sheet)?.into())
    }

    fn panel(p: &Points, set: &Set, titled: bool) -> Panel {
        let place = |row: &[f64]| (row.first().copied().unwrap_or(0.0), row.get(1).copied().unwrap_or(0.5));
        let points: Vec<(f64, f64)> = set.coordinates.chunks_exact(p.dimensions).map(place).collect();
        let marks = Marks::new(points).style(Style::of(&set.method));
        let mut marks = if p.dimensions == 1 && p.n <= 64 { marks.size(8.0) } else { marks };
        if p.labels {
            marks = marks.names((0..p.n).map(|index| index.to_string()));
        }
        let panel = if p.dimensions == 1 { line() } else { Panel::unit_square() };
        let panel = strata(p, panel);
        let panel = if titled { panel.title(set.title.as_str()) } else { panel };
        panel.with(marks)
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
    fn strata(p: &Points, panel: Panel) -> Panel {
        let line = p.dimensions == 1;
        let cells = side(p).map(|side| chart::Strata::boxes(side as u32, if line { 1 } else { side as u32 }));
        let slabs = if line { chart::Strata::boxes(p.n as u32, 1) } else { chart::Strata::slabs(p.n as u32) };
        let panel = panel.keeping(slabs);
        if line && p.strata != Strata::None {
            let border = |slab: usize| Rule::vertical(slab as f64 / p.n as f64).style(Style::new(Role::Strata));
            return panel.with_all((0..=p.n).map(border));
        }
        match (p.strata, cells) {
            (Strata::Cells, Some(cells)) => panel.strata(cells),
            (Strata::Slabs, cells) => cells.into_iter().fold(panel.strata(slabs), Panel::keeping),
            (_, cells) => cells.into_iter().fold(panel, Panel::keeping),
        }
    }

    pub(super) fn alt(p: &Points, data: &Data) -> String {
        let place = if p.dimensions == 1 { "on the unit interval" } else { "in the unit square" };
        let s = if p.n == 1 { "" } else { "s" };
        let mut text = format!("{} point{s} {place}", integer(p.n as i64));
        text.push_str(match p.strata {
            Strata::None => ".",
            _ if p.dimensions == 1 => ", with as many slabs.",
            Strata::Cells => ", with the grid of as many equal cells.",
            Strata::Slabs => ", with as many slabs along each axis.",
        });
        for set in &data.sets {
            let _ = write!(text, " {}:", set.title);
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
            text.push('.');
        }
        text
    }
}
