//! Measures: a table of point sets by how even they are.
//!
//! Every method is a row for each count, every measure a column; then whether the set is Latin, whether it keeps the grid of n cells, and how
//! many elementary intervals of volume 1/n do not hold one point. A random method shows the mean over its replicates; what it
//! keeps, it keeps in all of them.

use serde::{Deserialize, Serialize};

use super::estimation::mean_with_error;
use super::measuring::Measure;
use super::placing::Placing;
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::metrics::{self, nets, occupancy};
use crate::parameters::{Counts, parameters};
use crate::points::Points;
use crate::samplers::{Method, digits};
use crate::seed::Seed;

/// The kind `measures`.
pub static MEASURES: MeasuresKind = MeasuresKind;

/// The kind of experiment that compares point sets in a table.
pub struct MeasuresKind;

static ABOUT: About = About {
    key: "measures",
    title: "Measures of point sets",
    summary: "A table of samplers by discrepancies, distances, quality and the strata that they keep.",
    file: "kinds/measures.rs",
    source: include_str!("measures.rs"),
    papers: &[],
};

parameters! {
    /// What a table of measures can choose.
    pub struct MeasureTable {
        /// The samplers, each with an optional scramble: one row each.
        samplers: Vec<Method> [or sampler],
        /// How many points each set has; several counts give a row each.
        n: Counts [in 1..=65_536] = 64,
        /// The dimensions of the unit cube.
        dimensions: usize [in 1..=16] = 2,
        /// The measures: one column each.
        measures: Vec<Measure> = ["t-value", "star-discrepancy", "l2-star", "l2-centred", "l2-wrap-around", "minimum-distance", "relative-radius"],
        /// Whether the strata that a set keeps are told as well.
        strata: bool = true,
        /// The base of the elementary intervals.
        base: usize [in 2..=64] = 2,
        /// Over how many sets a random method is averaged.
        replicates: usize [in 1..=10_000] = 1,
    }
}

/// The rows of the table.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    rows: Vec<Row>,
}

/// One method.
#[derive(Debug, Serialize, Deserialize)]
struct Row {
    method: String,
    title: String,
    /// Mean and standard error of each measure, where it is defined.
    measured: Vec<Option<(f64, Option<f64>)>>,
    kept: Kept,
}

/// What every set of a method keeps; `None` where it is not defined.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Kept {
    latin: bool,
    cells: Option<bool>,
    violations: Option<f64>,
}

/// What one set gives.
type One = (Vec<Option<f64>>, Kept);

impl Kind for MeasuresKind {
    type Parameters = MeasureTable;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &MeasureTable, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, p.n.as_slice(), p.dimensions);
    }

    fn weight(&self, p: &MeasureTable) -> u64 {
        let pairs: u64 = p.n.iter().map(|n| (n as u64).saturating_mul(n as u64)).sum();
        pairs.saturating_mul(p.samplers.len() as u64 * p.replicates as u64)
    }

    fn run(&self, p: &MeasureTable, seed: Seed) -> Result<Data, Failure> {
        let placing = Placing { kind: ABOUT.key, d: p.dimensions, seed };
        let all = placing.measured(&p.samplers, p.n.as_slice(), p.replicates, |_, points| Ok(one(p, points)))?;
        let rows = |(method, counts): (&Method, Vec<Vec<One>>)| {
            counts.iter().map(|sets| row(p, method, sets)).collect::<Vec<Row>>()
        };
        Ok(Data { rows: p.samplers.iter().zip(all).flat_map(rows).collect() })
    }

    fn values(&self, p: &MeasureTable, data: &Data) -> Values {
        let mut values = Values::new();
        for (row, n) in data.with_counts(p) {
            let name = if p.n.as_slice().len() > 1 { format!("{}.{n}", row.method) } else { row.method.clone() };
            for (measure, measured) in p.measures.iter().zip(&row.measured) {
                if let Some((mean, error)) = measured {
                    values.estimate(format!("{}.{name}", measure.quantity()), *mean, error.unwrap_or(f64::NAN));
                }
            }
            if p.strata {
                values.boolean(format!("latin.{name}"), row.kept.latin);
                if let Some(cells) = row.kept.cells {
                    values.boolean(format!("one-per-cell.{name}"), cells);
                }
                values.number(format!("violations.{name}"), row.kept.violations.unwrap_or(f64::NAN));
            }
        }
        values
    }

    fn tables(&self, p: &MeasureTable, data: &Data) -> Vec<Frame> {
        let mut frame = Frame::new("measures").text("sampler", data.rows.iter().map(|row| row.method.clone()));
        if p.n.as_slice().len() > 1 {
            frame = frame.counts("n", data.with_counts(p).map(|(_, n)| n));
        }
        for (index, measure) in p.measures.iter().enumerate() {
            let number = |row: &Row| row.measured.get(index).copied().flatten().map_or(f64::NAN, |measured| measured.0);
            frame = frame.numbers(measure.key(), data.rows.iter().map(number));
        }
        let word = |kept: Option<bool>| kept.map_or("", |kept| if kept { "yes" } else { "no" }).to_owned();
        if p.strata {
            frame = frame
                .text("latin", data.rows.iter().map(|row| word(Some(row.kept.latin))))
                .text("one per cell", data.rows.iter().map(|row| word(row.kept.cells)))
                .numbers("violated intervals", data.rows.iter().map(|row| row.kept.violations.unwrap_or(f64::NAN)));
        }
        vec![frame]
    }

    fn draw(&self, p: &MeasureTable, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(p, data))
    }

    fn alt(&self, p: &MeasureTable, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Data {
    /// The rows, each with its count: those of a method follow each other.
    fn with_counts<'a>(&'a self, p: &'a MeasureTable) -> impl Iterator<Item = (&'a Row, usize)> {
        self.rows.iter().zip(p.n.as_slice().iter().copied().cycle())
    }
}

/// The measures of one set.
fn one(p: &MeasureTable, points: &Points) -> One {
    let measured = |measure: &Measure| metrics::measure(measure.metric(), points).ok().map(|measured| measured.value);
    let n = points.len();
    let side = digits::root(n as u64, p.dimensions as u32) as usize;
    let grid = (side.checked_pow(p.dimensions as u32) == Some(n)).then(|| vec![side; p.dimensions]);
    let single = |counts: Vec<u32>| counts.iter().all(|&count| count == 1);
    let kept = Kept {
        latin: p.strata && occupancy::is_latin(points),
        cells: grid.filter(|_| p.strata).and_then(|cuts| occupancy::cells(points, &cuts)).map(single),
        violations: p.strata.then(|| nets::violations(points, p.base as u32, 0)).flatten().map(|count| count as f64),
    };
    (p.measures.iter().map(measured).collect(), kept)
}

/// The row of a method from its sets.
fn row(p: &MeasureTable, method: &Method, sets: &[One]) -> Row {
    let mean = |index: usize| {
        let values: Option<Vec<f64>> = sets.iter().map(|set| set.0.get(index).copied().flatten()).collect();
        values.filter(|values| !values.is_empty()).map(|values| mean_with_error(&values))
    };
    let violations: Option<Vec<f64>> = sets.iter().map(|set| set.1.violations).collect();
    let cells: Option<Vec<bool>> = sets.iter().map(|set| set.1.cells).collect();
    Row {
        method: method.name(),
        title: method.title(),
        measured: (0..p.measures.len()).map(mean).collect(),
        kept: Kept {
            latin: sets.iter().all(|set| set.1.latin),
            cells: cells.map(|kept| kept.iter().all(|&kept| kept)),
            violations: violations.map(|counts| mean_with_error(&counts).0),
        },
    }
}

mod drawing {
    //! The table, and its words.

    use std::fmt::Write as _;

    use super::{Data, MeasureTable, Row};
    use crate::chart::number::{integer, significant};
    use crate::chart::{Cell, Column, Drawing, Table};

    pub(super) fn draw(p: &MeasureTable, data: &Data) -> Drawing {
        let several = p.n.as_slice().len() > 1;
        // One sampler is named by the caption.
        let named = p.samplers.len() > 1 || !several;
        let mut columns = Vec::from_iter(named.then(|| Column::left("Sampler")));
        columns.extend(several.then(|| Column::right("$N$")));
        columns.extend(p.measures.iter().map(|measure| Column::right(format!("${}$", measure.symbol()))));
        if p.strata {
            columns.extend([Column::centre("Latin"), Column::centre("Cells"), Column::right("Violated")]);
        }
        let mut table = Table::new(columns);
        for (row, n) in data.with_counts(p) {
            let head = named.then(|| Cell::text(row.title.as_str()));
            let count = several.then_some(Cell::Integer(n as i64));
            table.push(head.into_iter().chain(count).chain(cells(p, row)));
        }
        Drawing::Table(table.without_empty_columns())
    }

    fn cells(p: &MeasureTable, row: &Row) -> Vec<Cell> {
        let mut cells = Vec::new();
        for (measure, measured) in p.measures.iter().zip(&row.measured) {
            cells.push(match measured {
                None => Cell::Empty,
                Some((mean, _)) if measure.key() == "t-value" && mean.fract() == 0.0 => Cell::Integer(*mean as i64),
                Some((mean, None)) => Cell::significant(*mean, 3),
                Some((mean, Some(_))) => Cell::significant(*mean, 2),
            });
        }
        if p.strata {
            cells.push(Cell::holds(row.kept.latin));
            cells.push(row.kept.cells.map_or(Cell::Empty, Cell::holds));
            cells.push(match row.kept.violations {
                Some(count) if count.fract() == 0.0 => Cell::Integer(count as i64),
                Some(count) => Cell::fixed(count, 1),
                None => Cell::Empty,
            });
        }
        cells
    }

    pub(super) fn alt(p: &MeasureTable, data: &Data) -> String {
        let d = p.dimensions;
        let counts: Vec<String> = p.n.iter().map(|n| integer(n as i64)).collect();
        let mut text = format!(
            "Measures of sets of {} points in {d} dimension{}.",
            counts.join(", "),
            if d == 1 { "" } else { "s" }
        );
        for (index, measure) in p.measures.iter().enumerate() {
            let numbers = || {
                let rows = data.with_counts(p);
                rows.filter_map(|(row, n)| Some((row, n, row.measured.get(index).copied().flatten()?.0)))
            };
            let least = numbers().min_by(|a, b| a.2.total_cmp(&b.2));
            let most = numbers().max_by(|a, b| a.2.total_cmp(&b.2));
            if let (Some(least), Some(most)) = (least, most) {
                let told = |(row, n, value): (&Row, usize, f64)| match counts.len() {
                    1 => format!("{} ({})", significant(value, 3), row.title),
                    _ => format!("{} ({}, N = {})", significant(value, 3), row.title, integer(n as i64)),
                };
                let _ = write!(text, " {}: from {} to {}.", measure.title(), told(least), told(most));
            }
        }
        let mut latin: Vec<&str> =
            data.rows.iter().filter(|row| row.kept.latin).map(|row| row.title.as_str()).collect();
        latin.dedup();
        if !latin.is_empty() {
            let _ = write!(text, " Latin: {}.", latin.join(", "));
        }
        text
    }
}
