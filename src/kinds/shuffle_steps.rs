//! The shuffles that make a Latin hypercube or a multi-jittered set, step by step.
//!
//! The frames are computed here, swap by swap; the last is compared with what the sampler itself gives for the same seed, in
//! the value `agrees`. That the strata are kept is counted in every frame, not only at the end.

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::{choices, parameters};
use crate::samplers::Method;
use crate::samplers::digits::within;
use crate::samplers::{Sampler as _, multi_jittered};
use crate::seed::Seed;

/// The kind `shuffle-steps`.
pub static SHUFFLE_STEPS: ShuffleStepsKind = ShuffleStepsKind;

/// The kind of experiment that steps through shuffles.
pub struct ShuffleStepsKind;

static ABOUT: About = About {
    key: "shuffle-steps",
    title: "Shuffles, step by step",
    summary: "How shuffles make a Latin hypercube of the diagonal, or a multi-jittered set of the canonical arrangement.",
    file: "kinds/shuffle_steps.rs",
    source: include_str!("shuffle_steps.rs"),
    papers: &[],
};

choices! {
    /// What is constructed.
    pub enum Construction {
        /// A Latin hypercube in two dimensions, one step for each swap.
        Latin = "latin-hypercube",
        /// A multi-jittered set, one step for each column and each row.
        Jittered = "multi-jittered",
    }
}

parameters! {
    /// What stepping through shuffles can choose.
    pub struct ShuffleSteps {
        /// The sampler whose construction is shown.
        sampler: Construction = "latin-hypercube",
        /// How many points; for a multi-jittered set with a grid of as many cells.
        n: usize [in 2..=36] = 8,
    }
}

/// The frames.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    steps: Vec<Step>,
    /// Columns and rows of cells, where there are cells.
    cells: Option<(u32, u32)>,
    /// Whether each slab holds one point in every step; and each cell, where there are cells.
    latin: bool,
    stratified: bool,
    /// Whether the last step is what the sampler gives.
    agrees: bool,
}

/// One frame.
#[derive(Debug, Serialize, Deserialize)]
struct Step {
    /// The axis that is shuffled: 0 or 1; the number of the shuffle's part along it.
    axis: u32,
    part: u32,
    /// The points that exchange their places.
    moved: Vec<u32>,
    places: Vec<Place>,
}

impl Kind for ShuffleStepsKind {
    type Parameters = ShuffleSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &ShuffleSteps, problems: &mut Problems<'_, '_>) {
        if p.sampler == Construction::Jittered && method(p).is_some_and(|method| method.admits(p.n, 2).is_err()) {
            let message = format!("{} points have no grid of as many cells of nearly equal sides", p.n);
            problems.at("n", Code::Count, message, Some("take a number such as 9, 12, 16, 20 or 25".to_owned()));
        }
    }

    fn uses(&self, p: &ShuffleSteps) -> Vec<&'static About> {
        method(p).map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, p: &ShuffleSteps) -> u64 {
        (p.n * p.n) as u64
    }

    fn run(&self, p: &ShuffleSteps, seed: Seed) -> Result<Data, Failure> {
        let stream = seed.named(ABOUT.key).named(p.sampler.word()).at(p.n as u64);
        // What a method gives for a seed, its sampler makes from the stream of its own name.
        let own = stream.named(p.sampler.word());
        let steps = match p.sampler {
            Construction::Latin => latin(p.n, own),
            Construction::Jittered => jittered(p.n, own),
        };
        let drawn = method(p).and_then(|method| method.points(p.n, 2, stream).ok());
        let agrees = drawn.is_some_and(|points| steps.last().is_some_and(|step| step.places == steps::places(&points)));
        let cells = match multi_jittered::PLAIN.strata(p.n, 2)[..] {
            [columns, rows] if p.sampler == Construction::Jittered => Some((columns as u32, rows as u32)),
            _ => None,
        };
        let latin = steps.iter().all(|step| steps::is_latin(&step.places));
        let stratified = cells.is_some_and(|(columns, rows)| {
            steps.iter().all(|step| steps::one_per_cell(&step.places, columns as usize, rows as usize))
        });
        Ok(Data { steps, cells, latin, stratified, agrees })
    }

    fn values(&self, _: &ShuffleSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("steps", data.steps.len() as i64);
        values.boolean("one-per-slab.every-step", data.latin);
        if data.cells.is_some() {
            values.boolean("one-per-cell.every-step", data.stratified);
        }
        values.boolean("agrees", data.agrees);
        values
    }

    fn tables(&self, _: &ShuffleSteps, data: &Data) -> Vec<Frame> {
        vec![steps::table(data.steps.iter().map(|step| step.places.as_slice()))]
    }

    fn draw(&self, p: &ShuffleSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &ShuffleSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The method that is constructed.
fn method(p: &ShuffleSteps) -> Option<Method> {
    Method::parse(p.sampler.word()).ok()
}

/// The diagonal, then each swap of the shuffles of both axes.
fn latin(n: usize, seed: Seed) -> Vec<Step> {
    let mut random = [seed.at(0).generator(), seed.at(1).generator()];
    let mut columns = random
        .each_mut()
        .map(|random| -> Vec<f64> { (0..n).map(|slab| within(slab as u64, n as u64, random.uniform())).collect() });
    let mut steps = vec![Step { axis: 0, part: 0, moved: Vec::new(), places: zipped(&columns) }];
    for (axis, random) in random.iter_mut().enumerate() {
        for (part, (i, j)) in random.swaps(n).enumerate() {
            columns[axis].swap(i, j);
            let moved = if i == j { vec![i as u32] } else { vec![i as u32, j as u32] };
            steps.push(Step { axis: axis as u32, part: part as u32 + 1, moved, places: zipped(&columns) });
        }
    }
    steps
}

fn zipped([x, y]: &[Vec<f64>; 2]) -> Vec<Place> {
    x.iter().copied().zip(y.iter().copied()).collect()
}

/// The canonical arrangement, then the shuffle of x within each column and of y within each row.
fn jittered(n: usize, seed: Seed) -> Vec<Step> {
    let cuts = multi_jittered::PLAIN.strata(n, 2);
    let [columns, rows] = cuts[..] else { return Vec::new() };
    // Of each axis and stratum: the order of its slabs, and the place of each point within its slab.
    let strata = [(columns, rows), (rows, columns)];
    let drawn: Vec<Vec<(Vec<usize>, Vec<f64>)>> = strata
        .iter()
        .enumerate()
        .map(|(axis, &(own, across))| {
            let mut random = seed.at(axis as u64).generator();
            (0..own).map(|_| (random.permutation(across), (0..across).map(|_| random.uniform()).collect())).collect()
        })
        .collect();
    let places = |done: [usize; 2]| -> Vec<Place> {
        let coordinate = |axis: usize, stratum: usize, k: usize| -> f64 {
            let Some((order, jitter)) = drawn.get(axis).and_then(|strata| strata.get(stratum)) else { return 0.0 };
            let slab = if stratum < done[axis] { order[k] } else { k };
            within((stratum * strata[axis].1 + slab) as u64, n as u64, jitter[k])
        };
        let cell = |cell: usize| {
            let (column, row) = (cell % columns, cell / columns);
            (coordinate(0, column, row), coordinate(1, row, column))
        };
        (0..n).map(cell).collect()
    };
    let mut steps = vec![Step { axis: 0, part: 0, moved: Vec::new(), places: places([0, 0]) }];
    for (axis, &(own, _)) in strata.iter().enumerate() {
        for part in 0..own {
            let done = if axis == 0 { [part + 1, 0] } else { [columns, part + 1] };
            let inside = |cell: &usize| if axis == 0 { cell % columns == part } else { cell / columns == part };
            let moved = (0..n).filter(inside).map(|cell| cell as u32).collect();
            steps.push(Step { axis: axis as u32, part: part as u32 + 1, moved, places: places(done) });
        }
    }
    steps
}

mod drawing {
    //! The frames, and their words.

    use super::{Construction, Data, ShuffleSteps, Step};
    use crate::chart::{
        Chart, ChartError, Drawing, Key, Marker, Marks, Panel, Region, Segments, Sheet, Steps, Strata, Style,
    };

    pub(super) fn draw(p: &ShuffleSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new();
        // The first step, and the one between the two shuffles.
        if let Some(half) = data.steps.iter().position(|step| step.axis == 1) {
            steps = steps.key_steps([1, half / 2 + 1, half]);
        }
        for step in &data.steps {
            steps.push(Chart::new(panel(p, data, step)).key(Key::Hidden), caption(p, step));
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(p: &ShuffleSteps, data: &Data, step: &Step) -> Panel {
        let slabs = Strata::slabs(p.n as u32);
        let mut panel = Panel::unit_square();
        let cells = data.cells.map(|(columns, rows)| Strata::boxes(columns, rows));
        panel = match cells {
            Some(cells) => panel.strata(cells).strata(slabs),
            None => panel.strata(slabs),
        };
        if let Some((columns, rows)) = data.cells.filter(|_| step.part > 0) {
            let count = f64::from(if step.axis == 0 { columns } else { rows });
            let (low, high) = (f64::from(step.part - 1) / count, f64::from(step.part) / count);
            let (from, to) = if step.axis == 0 { ((low, 0.0), (high, 1.0)) } else { ((0.0, low), (1.0, high)) };
            panel = panel.with(Region::new(from, to));
        } else if step.part > 0 {
            let moved = step.moved.iter().filter_map(|&index| step.places.get(index as usize).copied());
            panel = panel.with(Segments::spots(moved));
        }
        let style = Style::of(p.sampler.word()).marker(Marker::Disc);
        panel.with(Marks::new(step.places.clone()).style(style).size(9.0).tracked("p"))
    }

    fn caption(p: &ShuffleSteps, step: &Step) -> String {
        let n = p.n;
        match (p.sampler, step.part, step.axis) {
            (Construction::Latin, 0, _) => {
                format!("The diagonal: point $i$ lies in slab $i$ of both axes, at a random place in it; $N = {n}$.")
            }
            (Construction::Latin, part, axis) => {
                let (axis, slabs) = if axis == 0 { ("x", "columns") } else { ("y", "rows") };
                let of = format!("Shuffle of ${axis}$, swap {part} of {}", n - 1);
                match step.moved[..] {
                    [_, _] => format!("{of}: the two marked points exchange their {slabs}."),
                    _ => format!("{of}: the marked point draws itself, and stays."),
                }
            }
            (Construction::Jittered, 0, _) => {
                "The canonical arrangement: one point in each cell, in each column and in each row.".to_owned()
            }
            (Construction::Jittered, part, 0) => {
                format!("Column {part}: its points exchange their $x$, and each stays in its cell.")
            }
            (Construction::Jittered, part, _) => {
                format!("Row {part}: its points exchange their $y$, and each stays in its cell.")
            }
        }
    }

    pub(super) fn alt(p: &ShuffleSteps, data: &Data) -> String {
        let (n, count) = (p.n, data.steps.len());
        let swaps = data.steps.iter().filter(|step| step.moved.len() == 2).count();
        let kept = match (data.latin, data.cells) {
            (true, None) => "In every step each of the slabs of both axes holds exactly one point.",
            (true, Some(_)) if data.stratified => "In every step each slab of both axes and each cell holds one point.",
            _ => "In some step a slab or a cell does not hold exactly one point.",
        };
        match p.sampler {
            Construction::Latin => format!(
                "{count} steps: {n} points on the diagonal of the unit square are shuffled along x, then along y, by \
                 {swaps} swaps of two points. {kept}"
            ),
            Construction::Jittered => format!(
                "{count} steps: {n} points in their canonical arrangement are shuffled along x within each column of \
                 cells, then along y within each row. {kept}"
            ),
        }
    }
}
