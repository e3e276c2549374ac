//! A digit permutation that moves 0, on the digits that an index has: the zeros behind them, infinitely many, are forgotten.
//!
//! In base 3 with 0, 1, 2 becoming 1, 0, 2 the indices 0, 1 and 4 fall on one point, and of 9 slabs only 6 are hit.

use super::{Asked, Bug, Count, Facts, Found, Rule, Side, mean_of};
use crate::kinds::Failure;
use crate::points::slab;
use crate::seed::Seed;

/// The radical inverses in base 3 with permuted digits.
pub static BUG: Bug = Bug {
    key: "moves-zero",
    title: "zeros that are not permuted",
    n: Some(Count::new(9, 9, 81).being(Rule::PowerOf(3))),
    replicates: None,
    uses: &["halton"],
    weight: |asked| 34 * asked.n as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// What each digit becomes.
const PERMUTED: [u64; 3] = [1, 0, 2];

/// The radical inverse with the digits of the index permuted: it stops at the last digit that is not 0.
fn wrong(index: u64) -> f64 {
    let (mut rest, mut reversed, mut scale) = (index, 0, 1_u64);
    while rest > 0 {
        reversed = 3 * reversed + PERMUTED[(rest % 3) as usize];
        scale *= 3;
        rest /= 3;
    }
    reversed as f64 / scale as f64
}

/// The radical inverse with all digits permuted that a `f64` can hold: 3^33 is below 2^53.
fn right(index: u64) -> f64 {
    let (mut rest, mut reversed, mut scale) = (index, 0, 1_u64);
    for _ in 0..33 {
        reversed = 3 * reversed + PERMUTED[(rest % 3) as usize];
        scale *= 3;
        rest /= 3;
    }
    reversed as f64 / scale as f64
}

fn run(asked: &Asked, _: Seed) -> Result<Found, Failure> {
    let measured = |place: fn(u64) -> f64| measure(&(0..asked.n as u64).map(place).collect::<Vec<f64>>());
    Ok(Found {
        wrong: measured(wrong),
        right: measured(right),
        facts: Facts::default().integer("slabs", asked.n as i64),
    })
}

/// The test: one point in each of the n slabs of equal width.
fn measure(places: &[f64]) -> Side {
    let n = places.len();
    let mut counts = vec![0_u32; n];
    for &place in places {
        counts[slab(place, n)] += 1;
    }
    let empty: Vec<usize> = (0..n).filter(|&slab| counts[slab] == 0).collect();
    let together = |place: &f64| places.iter().filter(|other| *other == place).count();
    let border = |slab: usize| slab as f64 / n as f64;
    let boxes = empty.iter().map(|&slab| [border(slab), -0.5, border(slab + 1), n as f64 - 0.5]).collect();
    let facts = Facts::default()
        .integer("slabs-hit", (n - empty.len()) as i64)
        .integer("most-together", places.iter().map(together).max().unwrap_or(0) as i64)
        .number("mean", mean_of(places.iter().copied()).mean());
    let side = Side::new(empty.is_empty(), facts).boxes(boxes);
    side.column("index", (0..n).map(|index| index as f64)).column("place", places.iter().copied())
}

mod drawing {
    //! Each index at its place, and their words.

    use super::super::drawing::{RIGHT, WRONG, pair};
    use super::{Asked, Found, Side};
    use crate::chart::number::{integer, significant};
    use crate::chart::{Axis, Boxes, ChartError, Drawing, Marks, Panel, Role, Rule, Sheet, Style};

    pub(super) fn draw(asked: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let wrong = panel(asked.n, &found.wrong, WRONG, "Wrong: zeros left out");
        let right = panel(asked.n, &found.right, RIGHT, "Right: all digits permuted");
        Ok(pair(wrong, right).draw(sheet)?.into())
    }

    fn panel(n: usize, side: &Side, style: Style, title: &str) -> Panel {
        let border = |k: usize| Rule::vertical(k as f64 / n as f64).style(Style::new(Role::Strata));
        let boxes: Vec<_> = side.boxes.iter().map(|&[left, low, right, high]| [(left, low), (right, high)]).collect();
        let ticks = [(0.0, "0"), (1.0 / 3.0, "1/3"), (2.0 / 3.0, "2/3"), (1.0, "1")];
        let ticks = ticks.into_iter().map(|(at, label)| (at, label.into())).collect();
        let step = n.div_ceil(9);
        let indices = (0..n).step_by(step).map(|index| (index as f64, index.to_string().into())).collect();
        let up = Axis::linear("index").range(-0.5, n as f64 - 0.5).ticks_at(indices);
        let panel = Panel::new(Axis::linear("").range(0.0, 1.0).ticks_at(ticks), up).title(title).ratio(0.9);
        let panel = if boxes.is_empty() { panel } else { panel.with(Boxes::new(boxes).plain().opacity(0.14)) };
        panel.with_all((0..=n).map(border)).with(Marks::new(side.pairs("place", "index")).style(style))
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let told = |side: &Side| {
            format!(
                "{} of {} slabs are hit, at most {} of the indices share a point, the mean is {}",
                integer(side.facts.count("slabs-hit")),
                integer(asked.n as i64),
                side.facts.count("most-together"),
                significant(side.facts.get("mean"), 3)
            )
        };
        format!(
            "Two panels with the unit interval across, cut into {n} slabs, each with its left border, of which the empty ones are shaded, and the indices 0 to {last} \
             upwards: each index at its radical inverse in base 3 with the digits 0, 1, 2 changed to 1, 0, 2. Only the digits of the index: \
             {}. All digits: {}.",
            told(&found.wrong),
            told(&found.right),
            n = asked.n,
            last = asked.n - 1,
        )
    }
}
