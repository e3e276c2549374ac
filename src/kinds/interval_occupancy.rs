//! Occupancy: the elementary intervals of every shape of b^m points, and how many of them do not hold exactly one.
//!
//! Of a sequence, aligned blocks of n consecutive points are looked at; of a method whose points belong together, as many
//! independent sets. A net of quality 0 violates nothing.

use serde::{Deserialize, Serialize};

use super::placing::Placing;
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::metrics::occupancy;
use crate::parameters::{choices, parameters};
use crate::points::Points;
use crate::samplers::digits::logarithm;
use crate::samplers::{Guarantee, Method};
use crate::seed::Seed;

/// The kind `occupancy`.
pub static OCCUPANCY: OccupancyKind = OccupancyKind;

/// The kind of experiment that counts points in elementary intervals.
pub struct OccupancyKind;

static ABOUT: About = About {
    key: "occupancy",
    title: "Occupancy of elementary intervals",
    summary: "The elementary intervals of every shape, and how many do not hold exactly one point.",
    file: "kinds/interval_occupancy.rs",
    source: include_str!("interval_occupancy.rs"),
    papers: &[],
};

choices! {
    /// How the occupancy is shown.
    pub enum Form {
        /// Every shape of the first block as a panel, with the violated intervals marked.
        Figure = "figure",
        /// The counts of violated intervals of all blocks.
        Table = "table",
    }
}

parameters! {
    /// What a study of elementary intervals can choose.
    pub struct Occupancy {
        /// The samplers, each with an optional scramble.
        samplers: Vec<Method> [or sampler],
        /// How many points a block has: a power of the base.
        n: usize [in 2..=4096] = 16,
        /// The base of the intervals.
        base: usize [in 2..=64] = 2,
        /// How many aligned blocks of a sequence, or independent sets, are looked at.
        blocks: usize [in 1..=65_536] = 1,
        /// Whether a figure or a table is made.
        @drawn form: Form = "figure",
    }
}

/// The occupancy for every sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    sets: Vec<Set>,
}

/// The occupancy for one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Set {
    method: String,
    title: String,
    /// The points of the first block.
    points: Vec<(f64, f64)>,
    /// For each shape the counts of the intervals of the first block, the first axis fastest.
    counts: Vec<Vec<u32>>,
    /// For each shape how many intervals of all blocks do not hold one point.
    violated: Vec<u64>,
}

impl Set {
    fn total(&self) -> u64 {
        self.violated.iter().sum()
    }
}

impl Kind for OccupancyKind {
    type Parameters = Occupancy;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Occupancy, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, &[p.n], 2);
        let shapes = shapes(p).len();
        if shapes == 0 {
            let below = (1..).map_while(|m| p.base.checked_pow(m)).take_while(|&power| power < p.n).last();
            let below = below.unwrap_or(p.base);
            let message = format!("{} points are no power of the base {}", p.n, p.base);
            let help = format!("the nearest powers are {below} and {}", below * p.base);
            problems.at("n", Code::Count, message, Some(help));
        } else if p.form == Form::Figure && p.samplers.len() * shapes > 12 {
            let message =
                format!("{shapes} shapes for each sampler are more than the 12 panels that a figure can hold");
            problems.at("samplers", Code::OutOfRange, message, Some("write `form = \"table\"`".to_owned()));
        }
    }

    fn weight(&self, p: &Occupancy) -> u64 {
        (p.n as u64 * p.samplers.len() as u64).saturating_mul(p.blocks as u64 * 8)
    }

    fn run(&self, p: &Occupancy, seed: Seed) -> Result<Data, Failure> {
        let placing = Placing { kind: ABOUT.key, d: 2, seed };
        let set = |method: &Method| -> Result<Set, Failure> {
            let blocks = blocks(p, method, &placing)?;
            let mut all = blocks.iter().map(|block| counts(p, block));
            let first: Vec<Vec<u32>> = all.next().unwrap_or_default();
            let mut violated: Vec<u64> = first.iter().map(|counts| wrong(counts)).collect();
            for block in all {
                violated.iter_mut().zip(&block).for_each(|(sum, counts)| *sum += wrong(counts));
            }
            let points = blocks.first().map(|block| block.axis(0).zip(block.axis(1)).collect());
            let (method, title) = (method.name(), method.title());
            Ok(Set { method, title, points: points.unwrap_or_default(), counts: first, violated })
        };
        Ok(Data { sets: p.samplers.iter().map(set).collect::<Result<_, _>>()? })
    }

    fn values(&self, p: &Occupancy, data: &Data) -> Values {
        let mut values = Values::new();
        let shapes = shapes(p);
        values.integer("intervals", (shapes.len() * p.n * p.blocks) as i64);
        for set in &data.sets {
            let name = &set.method;
            values.integer(format!("violations.{name}"), set.total() as i64);
            values.boolean(format!("perfect.{name}"), set.total() == 0);
            for ([columns, rows], count) in shapes.iter().zip(&set.violated) {
                values.integer(format!("violations.{name}.{columns}x{rows}"), *count as i64);
            }
        }
        values
    }

    fn tables(&self, p: &Occupancy, data: &Data) -> Vec<Frame> {
        let shapes = shapes(p);
        let rows = || data.sets.iter().flat_map(|set| shapes.iter().zip(&set.violated).map(move |one| (set, one)));
        let frame = Frame::new("occupancy")
            .text("sampler", rows().map(|(set, _)| set.method.clone()))
            .counts("columns", rows().map(|(_, (shape, _))| shape[0]))
            .counts("rows", rows().map(|(_, (shape, _))| shape[1]))
            .counts("violated", rows().map(|(_, (_, count))| *count as usize));
        vec![frame]
    }

    fn draw(&self, p: &Occupancy, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Occupancy, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// Every shape of elementary intervals of volume 1/n: into how many columns and rows it cuts the square.
fn shapes(p: &Occupancy) -> Vec<[usize; 2]> {
    let Some(m) = logarithm(p.n as u64, p.base as u32) else { return Vec::new() };
    (0..=m).rev().map(|k| [p.base.pow(k), p.base.pow(m - k)]).collect()
}

/// The blocks of a sequence, or as many independent sets.
fn blocks(p: &Occupancy, method: &Method, placing: &Placing) -> Result<Vec<Points>, Failure> {
    let is_sequence = method.guarantees().contains(&Guarantee::Prefix) && method.admits(p.n * p.blocks, 2).is_ok();
    if !is_sequence {
        let differ = super::estimation::replicates_of(method, p.blocks);
        return (0..p.blocks).map(|block| placing.points(method, p.n, block % differ)).collect();
    }
    let all = placing.points(method, p.n * p.blocks, 0)?;
    let block = |rows: &[f64]| Points::from_rows(2, rows.to_vec());
    Ok(all.coordinates().chunks_exact(2 * p.n).filter_map(block).collect())
}

/// The counts of the intervals of every shape.
fn counts(p: &Occupancy, block: &Points) -> Vec<Vec<u32>> {
    shapes(p).iter().filter_map(|shape| occupancy::cells(block, shape)).collect()
}

/// How many intervals do not hold one point.
fn wrong(counts: &[u32]) -> u64 {
    counts.iter().filter(|&&count| count != 1).count() as u64
}

mod drawing {
    //! The panels of all shapes or the table, and their words.

    use std::fmt::Write as _;

    use super::{Data, Form, Occupancy, Set, shapes};
    use crate::chart::number::integer;
    use crate::chart::{
        Cell, Chart, ChartError, Column, Drawing, Key, Marker, Marks, Panel, Region, Sheet, Strata, Style, Table,
    };

    pub(super) fn draw(p: &Occupancy, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        if p.form == Form::Table {
            return Ok(Drawing::Table(table(p, data)));
        }
        let titled = data.sets.len() > 1;
        let shapes = shapes(p);
        let panels = data.sets.iter().flat_map(|set| {
            shapes.iter().zip(&set.counts).map(move |(shape, counts)| panel(set, *shape, counts, titled))
        });
        let chart = Chart::grid(panels.collect()).key(Key::Hidden);
        let chart = if shapes.len() == 2 || shapes.len() == 4 { chart.columns(2) } else { chart.columns(3) };
        Ok(chart.draw(sheet)?.into())
    }

    fn panel(set: &Set, [columns, rows]: [usize; 2], counts: &[u32], titled: bool) -> Panel {
        let shape = format!("{columns} × {rows}");
        let title = if titled { format!("{}: {shape}", set.title) } else { shape };
        let (width, height) = (1.0 / columns as f64, 1.0 / rows as f64);
        let region = |(cell, _): (usize, &u32)| {
            let (x, y) = ((cell % columns) as f64 * width, (cell / columns) as f64 * height);
            Region::new((x, y), (x + width, y + height)).style(Style::ACCENT)
        };
        let wrong = counts.iter().enumerate().filter(|(_, count)| **count != 1).map(region);
        Panel::unit_square()
            .title(title)
            .strata(Strata::boxes(columns as u32, rows as u32))
            .with_all(wrong)
            .with(Marks::new(set.points.clone()).style(Style::of(&set.method).marker(Marker::Disc)))
    }

    fn table(p: &Occupancy, data: &Data) -> Table {
        let mut columns = vec![Column::left("Sampler")];
        columns.extend(shapes(p).iter().map(|[columns, rows]| Column::right(format!("{columns}×{rows}"))));
        columns.extend([Column::right("All"), Column::centre("None violated")]);
        let mut table = Table::new(columns);
        for set in &data.sets {
            let counts = set.violated.iter().map(|&count| Cell::Integer(count as i64));
            let total = [Cell::Integer(set.total() as i64), Cell::holds(set.total() == 0)];
            table.push(std::iter::once(Cell::text(set.title.as_str())).chain(counts).chain(total));
        }
        table
    }

    pub(super) fn alt(p: &Occupancy, data: &Data) -> String {
        let shapes = shapes(p);
        let blocks =
            if p.blocks == 1 { "one block".to_owned() } else { format!("{} blocks", integer(p.blocks as i64)) };
        let mut text = format!(
            "The elementary intervals in base {} of {blocks} of {} points, in {} shapes of {} intervals each.",
            p.base,
            p.n,
            shapes.len(),
            p.n
        );
        for set in &data.sets {
            let _ = match set.total() {
                0 => write!(text, " {}: every interval holds one point.", set.title),
                total => write!(text, " {}: {} intervals do not hold one point.", set.title, integer(total as i64)),
            };
        }
        text
    }
}
