//! Von Neumann's middle-square generator: square a number of k digits and keep the k in the middle of the 2k.
//!
//! Every seed is followed until a number comes again: first a tail, then a cycle, which is often 0. The numbers of one seed are held
//! against the uniform law by the test of Kolmogorov and Smirnov, beside those of the generator of this library.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::{choices, parameters};
use crate::seed::Seed;
use crate::stats::inference;

/// The kind `middle-square`.
pub static MIDDLE_SQUARE: MiddleSquareKind = MiddleSquareKind;

/// The kind of experiment that takes an old generator apart.
pub struct MiddleSquareKind;

static ABOUT: About = About {
    key: "middle-square",
    title: "Middle squares",
    summary: "Von Neumann's middle-square generator: tails, cycles and collapse of every seed, beside a modern generator.",
    file: "kinds/middle_square.rs",
    source: include_str!("middle_square.rs"),
    papers: &[Paper {
        authors: "J. von Neumann",
        year: 1951,
        title: "Various Techniques Used in Connection with Random Digits",
        venue: "National Bureau of Standards Applied Mathematics Series 12, 36-38",
        doi: None,
    }],
};

choices! {
    /// What is drawn.
    pub enum Show {
        /// How many numbers each seed gives before one comes again, as a histogram.
        Runs = "runs",
        /// The cycles that seeds end in.
        Cycles = "cycles",
        /// Successive pairs of one seed, beside those of a modern generator.
        Pairs = "pairs",
    }
}

parameters! {
    /// What an examination of middle squares can choose.
    pub struct MiddleSquare {
        /// How many digits the numbers have; it must be even.
        digits: usize [in 2..=6] = 4,
        /// The seed whose successive pairs are drawn; that of the longest run if it is not given.
        start: Option<usize> [in 0..=999_999],
        /// How many numbers of it are tested and drawn.
        n: usize [in 10..=10_000] = 400,
        /// Into how many bins the runs fall.
        bins: usize [in 2..=200] = 37,
        /// What is drawn.
        @drawn show: Show = "runs",
    }
}

/// The examination.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// How many seeds have a run of 1, 2, ... different numbers.
    runs: Vec<u64>,
    /// A seed with the longest run.
    longest_seed: u64,
    /// The longest tail.
    tail: u64,
    /// The cycles by their least number: that number, the length, and how many seeds end in it.
    cycles: Vec<(u64, u64, u64)>,
    start: u64,
    /// The numbers of one seed, over 10^k, and those of the modern generator.
    old: Vec<f64>,
    modern: Vec<f64>,
    /// The probabilities of the test of Kolmogorov and Smirnov: old, modern.
    uniform: (f64, f64),
}

impl Kind for MiddleSquareKind {
    type Parameters = MiddleSquare;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &MiddleSquare, problems: &mut Problems<'_, '_>) {
        if !p.digits.is_multiple_of(2) {
            let message = format!("a square of {} digits has no middle of as many", p.digits);
            problems.at("digits", Code::OutOfRange, message, Some("`digits` is 2, 4 or 6".to_owned()));
        }
        if let Some(start) = p.start.filter(|start| *start as u64 >= modulus(p.digits)) {
            let message = format!("{start} has more than {} digits", p.digits);
            problems.at("start", Code::OutOfRange, message, None);
        }
    }

    fn weight(&self, p: &MiddleSquare) -> u64 {
        4 * modulus(p.digits)
    }

    fn run(&self, p: &MiddleSquare, seed: Seed) -> Result<Data, Failure> {
        let ends = follow(p.digits);
        let length = |end: &End| end.tail + ends.cycle_length(end);
        let longest = ends.of.iter().map(length).max().unwrap_or(0);
        let mut runs = vec![0_u64; longest as usize];
        ends.of.iter().for_each(|end| runs[length(end) as usize - 1] += 1);
        let longest_seed = ends.of.iter().position(|end| length(end) == longest).unwrap_or(0) as u64;
        let start = p.start.map_or(longest_seed, |start| start as u64);
        let mut number = start;
        let mut old = Vec::with_capacity(p.n);
        for _ in 0..p.n {
            old.push(number as f64 / modulus(p.digits) as f64);
            number = next(number, p.digits);
        }
        let mut random = seed.named(ABOUT.key).generator();
        let modern: Vec<f64> = (0..p.n).map(|_| random.uniform()).collect();
        let test = |numbers: &[f64]| inference::kolmogorov_smirnov(numbers).map_or(f64::NAN, |test| test.probability);
        Ok(Data {
            runs,
            longest_seed,
            tail: ends.of.iter().map(|end| end.tail).max().unwrap_or(0),
            uniform: (test(&old), test(&modern)),
            cycles: ends.cycles,
            start,
            old,
            modern,
        })
    }

    fn values(&self, p: &MiddleSquare, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("seeds", modulus(p.digits) as i64);
        values.integer("longest", data.runs.len() as i64);
        values.integer("longest.seed", data.longest_seed as i64);
        values.integer("longest.tail", data.tail as i64);
        values.number("mean", data.mean());
        values.integer("cycles", data.cycles.len() as i64);
        values.integer("longest.cycle", data.cycles.iter().map(|cycle| cycle.1).max().unwrap_or(0) as i64);
        let zero = data.cycles.iter().find(|cycle| cycle.0 == 0).map_or(0, |cycle| cycle.2);
        values.integer("collapsed", zero as i64);
        values.number("collapsed.share", zero as f64 / modulus(p.digits) as f64);
        values.number("ks.middle-square", data.uniform.0);
        values.number("ks.modern", data.uniform.1);
        values
    }

    fn tables(&self, _: &MiddleSquare, data: &Data) -> Vec<Frame> {
        let runs = Frame::new("runs")
            .counts("different numbers", 1..=data.runs.len())
            .counts("seeds", data.runs.iter().map(|&seeds| seeds as usize));
        let cycles = Frame::new("cycles")
            .counts("least number", data.cycles.iter().map(|cycle| cycle.0 as usize))
            .counts("length", data.cycles.iter().map(|cycle| cycle.1 as usize))
            .counts("seeds", data.cycles.iter().map(|cycle| cycle.2 as usize));
        let numbers = Frame::new("numbers")
            .numbers("middle-square", data.old.iter().copied())
            .numbers("modern", data.modern.iter().copied());
        vec![runs, cycles, numbers]
    }

    fn draw(&self, p: &MiddleSquare, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &MiddleSquare, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Data {
    /// The mean number of different numbers that a seed gives.
    fn mean(&self) -> f64 {
        let weighted = self.runs.iter().enumerate().map(|(index, seeds)| (index as u64 + 1) * seeds).sum::<u64>();
        weighted as f64 / self.runs.iter().sum::<u64>().max(1) as f64
    }
}

/// How many numbers have at most so many digits.
fn modulus(digits: usize) -> u64 {
    10_u64.pow(digits as u32)
}

/// The middle digits of the square.
pub fn next(number: u64, digits: usize) -> u64 {
    number * number / modulus(digits / 2) % modulus(digits)
}

/// Where a seed ends: after how many numbers, in which cycle.
#[derive(Debug, Clone, Copy)]
struct End {
    tail: u64,
    cycle: usize,
}

/// Where every seed ends.
struct Ends {
    of: Vec<End>,
    /// The least number, the length, and the seeds of each cycle.
    cycles: Vec<(u64, u64, u64)>,
}

impl Ends {
    fn cycle_length(&self, end: &End) -> u64 {
        self.cycles.get(end.cycle).map_or(0, |cycle| cycle.1)
    }
}

/// Follows every seed until it meets one that was followed before, or itself.
fn follow(digits: usize) -> Ends {
    let mut ends: Vec<Option<End>> = vec![None; modulus(digits) as usize];
    let mut place = vec![usize::MAX; ends.len()];
    let mut cycles: Vec<(u64, u64, u64)> = Vec::new();
    for seed in 0..ends.len() {
        let mut path = Vec::new();
        let mut number = seed;
        while ends[number].is_none() && place[number] == usize::MAX {
            place[number] = path.len();
            path.push(number);
            number = next(number as u64, digits) as usize;
        }
        if ends[number].is_none() {
            // The path has met itself: what follows that place is a new cycle.
            let cycle = path.split_off(place[number]);
            let least = cycle.iter().copied().min().unwrap_or(0);
            for &member in &cycle {
                ends[member] = Some(End { tail: 0, cycle: cycles.len() });
            }
            cycles.push((least as u64, cycle.len() as u64, 0));
        }
        let mut end = ends[number].unwrap_or(End { tail: 0, cycle: 0 });
        for &before in path.iter().rev() {
            end.tail += 1;
            ends[before] = Some(end);
        }
    }
    let of: Vec<End> = ends.into_iter().flatten().collect();
    for end in &of {
        cycles[end.cycle].2 += 1;
    }
    // In the order of their least numbers, whatever seed found them.
    let mut order: Vec<usize> = (0..cycles.len()).collect();
    order.sort_unstable_by_key(|&cycle| cycles[cycle].0);
    let mut rank = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, &cycle)| rank[cycle] = place);
    let of = of.into_iter().map(|end| End { cycle: rank[end.cycle], ..end }).collect();
    Ends { of, cycles: order.into_iter().map(|cycle| cycles[cycle]).collect() }
}

mod drawing {
    //! The histogram of runs, the table of cycles, the pairs, and the words.

    use super::{Data, MiddleSquare, Show, modulus};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{
        Axis, Bars, Cell, Chart, ChartError, Column, Drawing, Key, Line, Marks, Panel, Role, Sheet, Style, Table,
    };

    pub(super) fn draw(p: &MiddleSquare, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match p.show {
            Show::Runs => Ok(Chart::new(runs(p, data)).draw(sheet)?.into()),
            Show::Cycles => Ok(Drawing::Table(cycles(p, data))),
            Show::Pairs => {
                let style = Style::new(Role::Blue);
                let old =
                    pairs(&data.old, style).title(format!("Middle squares from {}", written(data.start, p.digits)));
                let modern = pairs(&data.modern, Style::of("independent")).title("A modern generator");
                Ok(Chart::grid(vec![old, modern]).columns(2).key(Key::Hidden).draw(sheet)?.into())
            }
        }
    }

    /// A number with all of its digits.
    fn written(number: u64, digits: usize) -> String {
        format!("{number:0digits$}")
    }

    /// How many different numbers the seeds give.
    fn runs(p: &MiddleSquare, data: &Data) -> Panel {
        let longest = data.runs.len();
        // Bins of whole numbers, all of one width.
        let width = longest.div_ceil(p.bins).max(1);
        let heights: Vec<f64> = data.runs.chunks(width).map(|runs| runs.iter().sum::<u64>() as f64).collect();
        let edges: Vec<f64> = (0..=heights.len()).map(|bin| (bin * width) as f64 + 0.5).collect();
        let top = heights.iter().copied().fold(0.0, f64::max);
        Panel::new(Axis::linear("different numbers before one comes again"), Axis::linear("seeds").include(0.0))
            .ratio(0.5)
            .with(Bars::new(edges, heights).label("seeds"))
            .with(Line::new(vec![(data.mean(), 0.0), (data.mean(), 1.05 * top)]).style(Style::EXACT).label("mean"))
    }

    /// Successive pairs, each where it is once; those that come again and again are larger.
    fn pairs(numbers: &[f64], style: Style) -> Panel {
        let mut pairs: Vec<(f64, f64)> =
            numbers.windows(2).filter_map(|pair| Some((*pair.first()?, *pair.last()?))).collect();
        let count = pairs.len();
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let hits: Vec<(usize, (f64, f64))> =
            pairs.chunk_by(|a, b| a == b).filter_map(|same| Some((same.len(), *same.first()?))).collect();
        let mut panel = Panel::unit_square();
        // From how often on, and how large.
        for (least, most, size) in [(1, 1, None), (2, 9, Some(4.5)), (10, 99, Some(7.0)), (100, usize::MAX, Some(10.0))]
        {
            let hit = hits.iter().filter(|(hits, _)| (least..=most).contains(hits)).map(|(_, at)| *at);
            let marks = Marks::new(hit.collect()).style(style).among(count);
            panel = panel.with(match size {
                Some(size) => marks.size(size),
                None => marks,
            });
        }
        panel
    }

    fn cycles(p: &MiddleSquare, data: &Data) -> Table {
        let mut table = Table::new(vec![
            Column::right("Least number"),
            Column::right("Length of the cycle"),
            Column::right("Seeds that end in it"),
            Column::right("Share"),
        ]);
        let mut cycles = data.cycles.clone();
        cycles.sort_by_key(|cycle| std::cmp::Reverse(cycle.2));
        for (least, length, seeds) in cycles {
            let share = 100.0 * seeds as f64 / modulus(p.digits) as f64;
            table.push([
                Cell::Code(written(least, p.digits)),
                Cell::Integer(length as i64),
                Cell::Integer(seeds as i64),
                Cell::Decimal { value: share, text: format!("{} %", fixed(share, 2)) },
            ]);
        }
        table
    }

    pub(super) fn alt(p: &MiddleSquare, data: &Data) -> String {
        let seeds = integer(modulus(p.digits) as i64);
        let zero = data.cycles.iter().find(|cycle| cycle.0 == 0).map_or(0, |cycle| cycle.2);
        match p.show {
            Show::Runs => format!(
                "How many different numbers of {} digits the middle squares give before one comes again, for all {seeds} seeds: {} on average, at most {} (seed {}).",
                p.digits,
                fixed(data.mean(), 1),
                data.runs.len(),
                written(data.longest_seed, p.digits),
            ),
            Show::Cycles => format!(
                "The {} cycles in which the middle squares of {} digits end: the longest has {} numbers; {} of {seeds} seeds end in 0.",
                data.cycles.len(),
                p.digits,
                data.cycles.iter().map(|cycle| cycle.1).max().unwrap_or(0),
                integer(zero as i64),
            ),
            Show::Pairs => format!(
                "Successive pairs of {} numbers in the unit square. Left, middle squares from {}: the probability of the Kolmogorov-Smirnov test is {}. Right, a modern generator: {}.",
                integer(p.n as i64),
                written(data.start, p.digits),
                significant(data.uniform.0, 2),
                significant(data.uniform.1, 2),
            ),
        }
    }
}
