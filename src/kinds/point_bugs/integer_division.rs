//! Whole-number division in multi-jittered sampling: `i / columns` is 0 for every column i, and all points crowd in one cell.

use super::{Asked, Bug, Count, Facts, Found, Rule, Side, empty_boxes, mean_of, placed};
use crate::kinds::Failure;
use crate::metrics::occupancy;
use crate::seed::{Random, Seed};

/// Multi-jittered points on a square grid.
pub static BUG: Bug = Bug {
    key: "integer-division",
    title: "whole numbers divided",
    n: Some(Count::new(16, 4, 256).being(Rule::Square)),
    replicates: None,
    uses: &["multi-jittered"],
    weight: |asked| 2 * asked.n as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// The canonical arrangement, shuffled: i and j and their quotients are whole numbers.
fn wrong(columns: usize, rows: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let n = (columns * rows) as f64;
    let mut points = Vec::new();
    for i in 0..columns {
        for j in 0..rows {
            let x = (i / columns) as f64 + (j as f64 + random.uniform()) / n;
            let y = (j / rows) as f64 + (i as f64 + random.uniform()) / n;
            points.push([x, y]);
        }
    }
    shuffle(&mut points, columns, rows, random);
    points
}

/// The canonical arrangement, shuffled: numbers with a fraction are divided.
fn right(columns: usize, rows: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let n = (columns * rows) as f64;
    let mut points = Vec::new();
    for i in 0..columns {
        for j in 0..rows {
            let x = i as f64 / columns as f64 + (j as f64 + random.uniform()) / n;
            let y = j as f64 / rows as f64 + (i as f64 + random.uniform()) / n;
            points.push([x, y]);
        }
    }
    shuffle(&mut points, columns, rows, random);
    points
}

/// Shuffles x within each column of cells and y within each row; point (i, j) is number `i * rows + j`.
fn shuffle(points: &mut [[f64; 2]], columns: usize, rows: usize, random: &mut Random) {
    let mut swap = |a: usize, b: usize, axis: usize| {
        let other = points[b][axis];
        points[b][axis] = std::mem::replace(&mut points[a][axis], other);
    };
    for i in 0..columns {
        random.swaps(rows).for_each(|(j, k)| swap(i * rows + j, i * rows + k, 0));
    }
    for j in 0..rows {
        random.swaps(columns).for_each(|(i, k)| swap(i * rows + j, k * rows + j, 1));
    }
}

fn run(asked: &Asked, seed: Seed) -> Result<Found, Failure> {
    let side = asked.n.isqrt();
    // The same random numbers for both.
    let measured = |place: fn(usize, usize, &mut Random) -> Vec<[f64; 2]>| {
        measure(&place(side, side, &mut seed.named("multi-jitter").generator()), side)
    };
    let facts = Facts::default().number("expected-mean", 0.5 / side as f64).integer("columns", side as i64);
    Ok(Found { wrong: measured(wrong), right: measured(right), facts })
}

/// The test: one point in each of the cells, and one in each of the n slabs of both axes.
fn measure(points: &[[f64; 2]], side: usize) -> Side {
    let empty = empty_boxes(points, [side, side]);
    let set = placed(points);
    let slabs = |axis: usize| set.as_ref().map(|set| occupancy::slabs(set, axis)).unwrap_or_default();
    let empty_slabs = slabs(0).iter().filter(|count| **count == 0).count();
    let latin = set.as_ref().is_some_and(occupancy::is_latin);
    let largest = points.iter().map(|point| point[0]).fold(0.0, f64::max);
    let facts = Facts::default()
        .number("mean-x", mean_of(points.iter().map(|point| point[0])).mean())
        .number("mean-y", mean_of(points.iter().map(|point| point[1])).mean())
        .number("largest-x", largest)
        .integer("empty-cells", empty.len() as i64)
        .integer("empty-slabs", empty_slabs as i64);
    Side::new(empty.is_empty() && latin, facts).points(points).boxes(empty)
}

mod drawing {
    //! The points of both programs in their cells, and their words.

    use super::super::drawing::{RIGHT, WRONG, counted, pair, square};
    use super::{Asked, Found, Side};
    use crate::chart::number::{integer, significant};
    use crate::chart::{ChartError, Drawing, Sheet, Strata};

    pub(super) fn draw(_: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let cells = Strata::cells(found.facts.count("columns") as u32);
        let wrong = square(&found.wrong, WRONG, "Wrong: whole numbers divided", &[cells]).rug();
        let right = square(&found.right, RIGHT, "Right: fractions", &[cells]).rug();
        Ok(pair(wrong, right).draw(sheet)?.into())
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let told = |side: &Side| {
            let empty = counted(side.facts.count("empty-cells"), "cell");
            let slabs = counted(side.facts.count("empty-slabs"), "column");
            let mean = significant(side.facts.get("mean-x"), 3);
            format!("{empty} and {slabs} of the finer {} without a point, mean x {mean}", integer(asked.n as i64))
        };
        format!(
            "Two unit squares with {n} multi-jittered points and the grid of {n} equal cells, empty ones shaded. With whole numbers divided \
             all points lie in the lower left cell: {}. With fractions divided: {}.",
            told(&found.wrong),
            told(&found.right),
            n = integer(asked.n as i64),
        )
    }
}
