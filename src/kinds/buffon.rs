//! Buffon's needle: needles on a floor of boards, and pi from how many cross a joint.
//!
//! A needle of length l, thrown on boards of width 1 >= l, crosses a joint with probability 2 l / pi. Directions are drawn without pi,
//! by rejection from the disk. Lazzarini's stop: with l = 5/6 the estimate is 355/113 whenever 113 k of 213 k needles cross, so
//! who looks after every 213 needles, and stops when it is, is right to six decimals, by stopping alone. How often that comes within
//! k looks is known: the sums cross the line by a renewal process with u_k = Prob{113 k of 213 k}.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::{Counts, choices, parameters};
use crate::seed::{Random, Seed};
use crate::stats::moments::sum;
use crate::stats::portable;

/// The kind `buffon`.
pub static BUFFON: BuffonKind = BuffonKind;

/// The kind of experiment that throws needles.
pub struct BuffonKind;

static ABOUT: About = About {
    key: "buffon",
    title: "Buffon's needle",
    summary: "Needles on boards: the drop, the estimates of pi over N with their errors, and how lucky Lazzarini was.",
    file: "kinds/buffon.rs",
    source: include_str!("buffon.rs"),
    papers: &[
        Paper {
            authors: "G.-L. Leclerc, Comte de Buffon",
            year: 1777,
            title: "Essai d'arithmétique morale",
            venue: "Histoire naturelle, générale et particulière, Supplément 4, 46-148",
            doi: None,
        },
        Paper {
            authors: "L. Badger",
            year: 1994,
            title: "Lazzarini's Lucky Approximation of π",
            venue: "Mathematics Magazine 67(2), 83-91",
            doi: Some("10.1080/0025570X.1994.11996194"),
        },
    ],
};

/// Needles between two looks of Lazzarini's, and the crossings that make him stop: 2 (5/6) 213 / 113 is 355/113.
const LOOK: (u64, u64) = (213, 113);

/// The length of Lazzarini's needle in widths of a board: 2.5 cm on boards of 3 cm.
const LAZZARINI: f64 = 5.0 / 6.0;

/// How many needles one stream throws.
const BLOCK: u64 = 1 << 16;

choices! {
    /// What is drawn.
    pub enum Show {
        /// The needles where they fell.
        Drop = "drop",
        /// The estimates of pi over N.
        Table = "table",
        /// How often Lazzarini's stop comes.
        Lucky = "lucky",
    }
}

parameters! {
    /// What Buffon's experiment can choose.
    pub struct Buffon {
        /// The length of the needle, in widths of a board.
        length: f64 [in 0.01..=1.0] = 1.0,
        /// How many needles are drawn.
        needles: usize [in 1..=1000] = 100,
        /// How many boards are drawn; the floor is a square.
        boards: usize [in 2..=20] = 6,
        /// The numbers of needles, one row of the table each.
        n: Counts [in 1..=100_000_000] = "10^1..10^6",
        /// How many people try Lazzarini's stop.
        trials: usize [in 100..=1_000_000] = 4000,
        /// How often each looks before giving up; Lazzarini's 3408 needles are 16 looks.
        looks: usize [in 1..=256] = 16,
        /// What is drawn.
        @drawn show: Show = "drop",
    }
}

/// The needles, the estimates and the stops.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    needles: Vec<Needle>,
    rows: Vec<(u64, u64)>,
    /// For each look, how many have stopped at or before it, and the probability of that.
    stops: Vec<(u64, f64)>,
}

/// A needle: its ends, and whether it crosses a joint.
#[derive(Debug, Serialize, Deserialize)]
struct Needle {
    from: (f64, f64),
    to: (f64, f64),
    crosses: bool,
}

/// One row: the estimate of pi with its standard error; none where no needle crosses.
fn estimate(p: &Buffon, (n, crossings): (u64, u64)) -> Option<(f64, f64)> {
    let share = crossings as f64 / n as f64;
    let pi = 2.0 * p.length / share;
    (crossings > 0).then(|| (pi, pi * ((1.0 - share) / (n as f64 * share)).sqrt()))
}

/// By how many standard deviations the number of crossings is off the expected one; positive where the estimate of pi is too large.
///
/// It has the exact deviation, not the one that the needles show: of ten needles all may cross.
fn z(p: &Buffon, (n, crossings): (u64, u64)) -> f64 {
    let (n, share) = (n as f64, 2.0 * p.length / std::f64::consts::PI);
    (n * share - crossings as f64) / (n * share * (1.0 - share)).sqrt()
}

impl Kind for BuffonKind {
    type Parameters = Buffon;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &Buffon, _: &mut Problems<'_, '_>) {}

    fn weight(&self, p: &Buffon) -> u64 {
        p.n.total().saturating_add((p.trials * p.looks) as u64 * LOOK.0)
    }

    fn run(&self, p: &Buffon, seed: Seed) -> Result<Data, Failure> {
        let seed = seed.named(ABOUT.key);
        let mut random = seed.named("drop").generator();
        let needles = (0..p.needles).map(|_| needle(p, &mut random)).collect();
        let count = |n: usize| (n as u64, crossings(p.length, n as u64, seed.named("table").at(n as u64)));
        let rows = p.n.iter().map(count).collect();
        let stop = |trial: usize| stopped(p.looks, seed.named("lucky").at(trial as u64));
        let stopped: Vec<Option<usize>> = (0..p.trials).into_par_iter().map(piece(stop)).collect();
        let exact = stopping(p.looks);
        let by = |look: usize| stopped.iter().flatten().filter(|at| **at <= look).count() as u64;
        Ok(Data { needles, rows, stops: (1..=p.looks).map(by).zip(exact).collect() })
    }

    fn values(&self, p: &Buffon, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("pi", std::f64::consts::PI);
        values.integer("crossings", data.needles.iter().filter(|needle| needle.crosses).count() as i64);
        let mut largest = 0.0_f64;
        for &row in &data.rows {
            if let Some((pi, error)) = estimate(p, row) {
                let n = row.0;
                values.estimate(format!("pi.{n}"), pi, error);
                values.number(format!("error.{n}"), pi - std::f64::consts::PI);
            }
            let z = z(p, row);
            values.number(format!("z.{}", row.0), z);
            largest = largest.max(z.abs());
        }
        values.number("largest.z", largest);
        if let Some(&(stopped, exact)) = data.stops.last() {
            let n = p.trials as f64;
            values.estimate("lucky", stopped as f64 / n, (exact * (1.0 - exact) / n).sqrt());
            values.number("lucky.expected", exact);
            values.number("lucky.once", on_the_line(p.looks as u64));
        }
        values
    }

    fn tables(&self, p: &Buffon, data: &Data) -> Vec<Frame> {
        let part = |of: fn((f64, f64)) -> f64| {
            data.rows.iter().map(move |&row| estimate(p, row).map_or(f64::NAN, of)).collect::<Vec<_>>()
        };
        let estimates = Frame::new("estimates")
            .counts("n", data.rows.iter().map(|row| row.0 as usize))
            .counts("crossings", data.rows.iter().map(|row| row.1 as usize))
            .numbers("pi", part(|estimate| estimate.0))
            .numbers("standard error", part(|estimate| estimate.1));
        let needles = || data.needles.iter();
        let drop = Frame::new("needles")
            .numbers("x1", needles().map(|needle| needle.from.0))
            .numbers("y1", needles().map(|needle| needle.from.1))
            .numbers("x2", needles().map(|needle| needle.to.0))
            .numbers("y2", needles().map(|needle| needle.to.1))
            .counts("crosses", needles().map(|needle| usize::from(needle.crosses)));
        let stops = Frame::new("stops")
            .counts("needles", (1..=data.stops.len()).map(|look| look * LOOK.0 as usize))
            .counts("stopped", data.stops.iter().map(|stop| stop.0 as usize))
            .numbers("probability", data.stops.iter().map(|stop| stop.1));
        vec![estimates, drop, stops]
    }

    fn draw(&self, p: &Buffon, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Buffon, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// A random direction as a vector of length 1: a point of the disk by rejection, so that pi is not used to find pi.
fn direction(random: &mut Random) -> (f64, f64) {
    loop {
        let (x, y) = (2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0);
        let square = x * x + y * y;
        if square > 0.0 && square <= 1.0 {
            let length = square.sqrt();
            return (x / length, y / length);
        }
    }
}

/// A needle whose middle lies on the floor that is drawn; joints are at whole y.
fn needle(p: &Buffon, random: &mut Random) -> Needle {
    let side = p.boards as f64;
    let (x, y) = (side * random.uniform(), side * random.uniform());
    let (dx, dy) = direction(random);
    let half = 0.5 * p.length;
    let (from, to) = ((x - half * dx, y - half * dy), (x + half * dx, y + half * dy));
    Needle { from, to, crosses: from.1.floor() != to.1.floor() }
}

/// Whether a needle of this length crosses: where its middle is between two joints, and how far it reaches towards them.
fn crosses(length: f64, random: &mut Random) -> bool {
    let middle = random.uniform();
    let reach = 0.5 * length * direction(random).1.abs();
    middle < reach || middle + reach >= 1.0
}

/// How many of n needles cross.
fn crossings(length: f64, n: u64, stream: Seed) -> u64 {
    let block = |block: u64| {
        let mut random = stream.at(block).generator();
        (0..BLOCK.min(n - block * BLOCK)).filter(|_| crosses(length, &mut random)).count() as u64
    };
    (0..n.div_ceil(BLOCK)).into_par_iter().map(piece(block)).sum()
}

/// At which look one of Lazzarini's followers stops, if at any.
fn stopped(looks: usize, stream: Seed) -> Option<usize> {
    let mut random = stream.generator();
    let mut crossings = 0;
    (1..=looks).find(|&look| {
        crossings += (0..LOOK.0).filter(|_| crosses(LAZZARINI, &mut random)).count() as u64;
        crossings == LOOK.1 * look as u64
    })
}

/// The probability that exactly 113 k of 213 k needles cross.
fn on_the_line(k: u64) -> f64 {
    let (n, hits) = (LOOK.0 * k, LOOK.1 * k);
    let share = 2.0 * LAZZARINI / std::f64::consts::PI;
    // The binomial probability, by its logarithm.
    let choices = sum((1..=hits).map(|i| portable::ln((n - hits + i) as f64) - portable::ln(i as f64)));
    portable::exp(choices + hits as f64 * portable::ln(share) + (n - hits) as f64 * portable::ln(1.0 - share))
}

/// The probabilities of having stopped by look 1, 2, ...: the first times f_k of the renewal process with u_k, summed, where
/// u_k = f_k + the sum of f_j u_(k-j) over j < k.
fn stopping(looks: usize) -> Vec<f64> {
    let u: Vec<f64> = (1..=looks as u64).map(on_the_line).collect();
    let mut first: Vec<f64> = Vec::with_capacity(looks);
    for k in 0..looks {
        let again = sum((0..k).map(|j| first[j] * u[k - j - 1]));
        first.push(u[k] - again);
    }
    let mut total = 0.0;
    first
        .into_iter()
        .map(|probability| {
            total += probability;
            total
        })
        .collect()
}

mod drawing {
    //! The needles on their boards, the tables, and the words.

    use super::{Buffon, Data, LOOK, Show, estimate, z};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Cell, Chart, ChartError, Column, Drawing, Key, Line, Panel, Rule, Sheet, Style, Table};

    pub(super) fn draw(p: &Buffon, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match p.show {
            Show::Drop => Ok(Chart::new(floor(p, data)).key(Key::Above).draw(sheet)?.into()),
            Show::Table => Ok(Drawing::Table(table(p, data))),
            Show::Lucky => Ok(Drawing::Table(lucky(p, data))),
        }
    }

    /// The boards with the needles, those that cross apart.
    fn floor(p: &Buffon, data: &Data) -> Panel {
        let side = p.boards as f64;
        let reach = 0.5 * p.length;
        let axis = || Axis::linear("").range(-reach, side + reach).ticks_at(Vec::new()).hidden();
        let joint = |board: usize| Rule::horizontal(board as f64).style(Style::MUTED);
        let mut panel = Panel::new(axis(), axis()).equal().with_all((0..=p.boards).map(joint));
        // Told apart by their width too, not by colour alone.
        for (crosses, style, width, name) in
            [(false, Style::INK, 1.2, "between the joints"), (true, Style::ACCENT, 2.8, "across a joint")]
        {
            let lines = data.needles.iter().filter(|needle| needle.crosses == crosses);
            for (index, needle) in lines.enumerate() {
                let line = Line::new(vec![needle.from, needle.to]).style(style).width(width);
                panel = panel.with(if index == 0 { line.label(name) } else { line });
            }
        }
        panel
    }

    fn table(p: &Buffon, data: &Data) -> Table {
        let mut table = Table::new(vec![
            Column::right("$N$"),
            Column::right("Crossings"),
            Column::left("Estimate of $\\pi$"),
            Column::right("Error"),
            Column::right("$z$"),
        ]);
        for &row in &data.rows {
            let mut cells = vec![Cell::Integer(row.0 as i64), Cell::Integer(row.1 as i64)];
            match estimate(p, row) {
                Some((pi, error)) => {
                    let off = pi - std::f64::consts::PI;
                    cells.extend([Cell::estimate(pi, error), Cell::significant(off, 2), Cell::fixed(z(p, row), 2)]);
                }
                None => cells.push(Cell::text("none: no needle crosses")),
            }
            table.push(cells);
        }
        table.push([Cell::text("exact"), Cell::Empty, Cell::fixed(std::f64::consts::PI, 10)]);
        table.footers = 1;
        table
    }

    /// Which looks have a row: the powers of two, and the last.
    fn rows(data: &Data) -> impl Iterator<Item = (usize, (u64, f64))> + '_ {
        let last = data.stops.len();
        (1..=last).filter(move |look| look.is_power_of_two() || *look == last).map(|look| (look, data.stops[look - 1]))
    }

    fn lucky(p: &Buffon, data: &Data) -> Table {
        let mut table = Table::new(vec![
            Column::right("Needles at most"),
            Column::right("Looks"),
            Column::left("Share that found 355/113"),
            Column::left("Expected"),
            Column::right("$z$"),
        ]);
        let n = p.trials as f64;
        for (look, (stopped, exact)) in rows(data) {
            let error = (exact * (1.0 - exact) / n).sqrt();
            let share = stopped as f64 / n;
            table.push([
                Cell::Integer((look * LOOK.0 as usize) as i64),
                Cell::from(look),
                Cell::estimate(share, error),
                Cell::fixed(exact, 4),
                Cell::fixed((share - exact) / error, 2),
            ]);
        }
        table
    }

    pub(super) fn alt(p: &Buffon, data: &Data) -> String {
        let crossing = data.needles.iter().filter(|needle| needle.crosses).count();
        match p.show {
            Show::Drop => format!(
                "{} needles, {} times as long as a board is wide, on {} boards: {crossing} lie across a joint, {} between the joints.",
                p.needles,
                p.length,
                p.boards,
                p.needles - crossing,
            ),
            Show::Table => {
                let told = data.rows.iter().filter_map(|&row| {
                    let (pi, error) = estimate(p, row)?;
                    Some(format!("{} ± {} from {}", significant(pi, 6), significant(error, 2), integer(row.0 as i64)))
                });
                format!("Estimates of pi from needles: {}.", told.collect::<Vec<_>>().join(", "))
            }
            Show::Lucky => {
                let (stopped, exact) = data.stops.last().copied().unwrap_or_default();
                format!(
                    "How often 355/113 is found by looking after every {} needles and stopping when it is there: of {} who try with at most {} needles, {} per cent; {} per cent are expected.",
                    LOOK.0,
                    integer(p.trials as i64),
                    integer((data.stops.len() as u64 * LOOK.0) as i64),
                    fixed(100.0 * stopped as f64 / p.trials as f64, 1),
                    fixed(100.0 * exact, 1),
                )
            }
        }
    }
}
