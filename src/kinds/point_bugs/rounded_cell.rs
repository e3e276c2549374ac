//! A jittered point in single precision: i + u rounds up to i + 1 for the largest u, and the point lands in the next cell, or on 1.
//!
//! u is one of the 2^24 multiples of 2^-24 in [0, 1). Between 8 and 16 the numbers of single precision are 2^-20 apart, and the last
//! eight u of each cell there round up; n is a power of two, so that the division rounds nothing.

use super::{Asked, Bug, Count, Facts, Found, Rule, Side};
use crate::kinds::Failure;
use crate::seed::Seed;

/// Jittered points on the line.
pub static BUG: Bug = Bug {
    key: "rounded-cell",
    title: "a sum that rounds up to the next cell",
    n: Some(Count::new(16, 2, 64).being(Rule::PowerOf(2))),
    replicates: None,
    uses: &["jittered"],
    weight: |asked| 64 * asked.n as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// The point in cell i of n for u in [0, 1).
fn wrong(i: u32, n: u32, u: f32) -> f32 {
    (i as f32 + u) / n as f32
}

/// The same, held below the end of its cell.
fn right(i: u32, n: u32, u: f32) -> f32 {
    let x = (i as f32 + u) / n as f32;
    let end = (i + 1) as f32 / n as f32;
    if x < end { x } else { end.next_down() }
}

/// How many u there are.
const FRACTIONS: u32 = 1 << 24;

/// How many of the last u are shown.
const SHOWN: u32 = 64;

fn run(asked: &Asked, _: Seed) -> Result<Found, Failure> {
    let n = asked.n as u32;
    Ok(Found {
        wrong: measure(n, wrong),
        right: measure(n, right),
        facts: Facts::default().integer("last-cell", i64::from(n) - 1),
    })
}

/// The test: for no u does the point leave its cell.
fn measure(n: u32, place: fn(u32, u32, f32) -> f32) -> Side {
    let counts: Vec<u32> = (0..n).map(|i| leaving(i, n, place)).collect();
    let total = counts.iter().sum::<u32>();
    let last = counts.last().copied().unwrap_or(0);
    let each = f64::from(FRACTIONS);
    let facts = Facts::default()
        .integer("leaving", i64::from(total))
        .integer("leaving-last", i64::from(last))
        .number("share", f64::from(total) / (each * f64::from(n)))
        .number("share-last", f64::from(last) / each)
        .number("largest", f64::from(place(n - 1, n, fraction(FRACTIONS - 1))));
    let shown = || FRACTIONS - SHOWN..FRACTIONS;
    Side::new(total == 0, facts)
        .column("cell", (0..n).map(f64::from))
        .column("leaving", counts.into_iter().map(f64::from))
        .list("u to the end", shown().map(|k| f64::from(k) - each))
        .list("x less 1", shown().map(|k| f64::from(place(n - 1, n, fraction(k))) - 1.0))
}

/// For how many u the point of cell i is not below the cell's end: since x never falls as u grows, they are the last.
fn leaving(i: u32, n: u32, place: fn(u32, u32, f32) -> f32) -> u32 {
    let end = (i + 1) as f32 / n as f32;
    let (mut low, mut high) = (0, FRACTIONS);
    while low < high {
        let middle = u32::midpoint(low, high);
        if place(i, n, fraction(middle)) < end {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    FRACTIONS - low
}

/// The u number `k`, exact.
fn fraction(k: u32) -> f32 {
    k as f32 / FRACTIONS as f32
}

mod drawing {
    //! The end of the last cell and the counts of all, and their words.

    use super::super::drawing::{RIGHT, WRONG};
    use super::{Asked, Found, SHOWN, Side};
    use crate::chart::number::{integer, scientific};
    use crate::chart::{Axis, Bars, Chart, ChartError, Drawing, Key, Line, Panel, Rule, Sheet, Style};

    /// The distance of neighbours among single-precision numbers below 1.
    const GRAIN: f64 = 1.0 / 16_777_216.0;

    pub(super) fn draw(asked: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        Ok(Chart::grid(vec![steps(asked.n, found), bars(asked.n, found)])
            .columns(2)
            .key(Key::Above)
            .draw(sheet)?
            .into())
    }

    /// The position of the last cell's point for the last u.
    fn steps(n: usize, found: &Found) -> Panel {
        let ticks = [64, 48, 32, 16, 8].into_iter().map(|k| (f64::from(-k), format!("\u{2212}{k}").into()));
        let along = Axis::linear("*u* less 1, in 2^{-24}").range(-f64::from(SHOWN), 0.0).ticks_at(ticks.collect());
        let heights = (0..=4).map(|k| {
            let label = if k == 0 { "1".to_owned() } else { format!("1\u{2009}\u{2212}\u{2009}{k}·2^{{-24}}") };
            (-f64::from(k) * GRAIN, label.replace("1·", "").as_str().into())
        });
        let low = (f64::from(SHOWN) / n as f64).ceil().clamp(2.0, 6.0) + 0.3;
        let up = Axis::linear("*x*").range(-low * GRAIN, 0.4 * GRAIN).ticks_at(heights.collect());
        let line = |side: &Side, style: Style, label: &str| {
            Line::new(side.pairs("u to the end", "x less 1")).stepped().style(style).label(label)
        };
        Panel::new(along, up)
            .title(format!("The end of cell {}", n - 1).as_str())
            .ratio(0.95)
            .with(Rule::horizontal(0.0))
            .with(line(&found.wrong, WRONG, "wrong: as it rounds"))
            .with(line(&found.right, RIGHT, "right: held below the end"))
    }

    fn bars(n: usize, found: &Found) -> Panel {
        let edges = (0..=n).map(|cell| cell as f64 - 0.5).collect();
        let step = n.div_ceil(16) * if n > 8 { 3 } else { 1 };
        let ticks = (0..n).step_by(step).map(|cell| (cell as f64, cell.to_string().into())).collect();
        let along = Axis::linear("cell").range(-0.5, n as f64 - 0.5).ticks_at(ticks);
        Panel::new(along, Axis::linear("*u* that leave").include(0.0))
            .title(format!("Of 2^{{24}} *u*, {n} cells").as_str())
            .ratio(0.95)
            .with(Bars::new(edges, found.wrong.get("leaving").to_vec()).style(WRONG))
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let (wrong, right) = (&found.wrong.facts, &found.right.facts);
        format!(
            "Left, the point of the last of {n} cells in single precision for the last {SHOWN} of the 2^24 numbers u below 1: as it rounds, the staircase \
             reaches 1 for the last {}, a share of {}; held below the end it does not. Right, bars: how many u make the point leave each cell, \
             from {} in the first to {} in the last, {} in all; held below the end, {}.",
            wrong.count("leaving-last"),
            scientific(wrong.get("share-last"), 3),
            found.wrong.get("leaving").first().copied().unwrap_or(f64::NAN),
            wrong.count("leaving-last"),
            integer(wrong.count("leaving")),
            integer(right.count("leaving")),
            n = asked.n,
        )
    }
}
