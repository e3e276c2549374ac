//! A shuffle whose swap partner is never the item itself (S. Sattolo's algorithm, 1986): cyclic permutations only, (n-1)! of n!.
//!
//! A point of a Latin hypercube that is shuffled so on both axes lies in a diagonal cell with probability 1/(n-1), not 1/n.

use super::{Asked, Bug, Count, Facts, Found, Side};
use crate::kinds::Failure;
use crate::seed::{Random, Seed};
use crate::stats::inference::chi_square;
use crate::stats::moments::Moments;

/// Latin hypercubes of few points, whose permutations can be counted.
pub static BUG: Bug = Bug {
    key: "exclusive-shuffle",
    title: "an item never swapped with itself",
    n: Some(Count::new(4, 2, 5)),
    replicates: Some(Count::new(20_000, 5000, 200_000)),
    uses: &["latin-hypercube"],
    weight: |asked| 4 * (asked.n * asked.replicates) as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// Shuffles, but `below(i)` is one of 0, ..., i - 1: no item stays where it is.
fn wrong(items: &mut [usize], random: &mut Random) {
    for i in (1..items.len()).rev() {
        let k = random.below(i as u64) as usize;
        items.swap(i, k);
    }
}

/// Shuffles: one of 0, ..., i, each equally likely.
fn right(items: &mut [usize], random: &mut Random) {
    for i in (1..items.len()).rev() {
        let k = random.below(i as u64 + 1) as usize;
        items.swap(i, k);
    }
}

fn run(asked: &Asked, seed: Seed) -> Result<Found, Failure> {
    let (wrong, right) = (measure(asked, wrong, seed.named("wrong")), measure(asked, right, seed.named("right")));
    let n = asked.n as f64;
    let facts = Facts::default()
        .integer("orders", factorial(asked.n) as i64)
        .number("diagonal-wrong", 1.0 / (n - 1.0))
        .number("diagonal-right", 1.0 / n);
    Ok(Found { wrong, right, facts })
}

/// The test: every permutation occurs equally often, by the chi-square test at the level 10^-6.
///
/// Each replicate is a Latin hypercube of n points, both axes shuffled; the permutations of the first axis are counted.
fn measure(asked: &Asked, shuffle: fn(&mut [usize], &mut Random), seed: Seed) -> Side {
    let (n, mut random) = (asked.n, seed.generator());
    let mut orders = vec![0_u64; factorial(n)];
    let mut cells = vec![0_u64; n * n];
    let [mut product, mut kept, mut on_diagonal] = [Moments::default(); 3];
    let (mut columns, mut rows) = (vec![0; n], vec![0; n]);
    for _ in 0..asked.replicates {
        for items in [&mut columns, &mut rows] {
            items.iter_mut().enumerate().for_each(|(k, item)| *item = k);
            shuffle(items, &mut random);
        }
        orders[rank(&columns)] += 1;
        kept.push(columns.iter().enumerate().filter(|(k, item)| k == *item).count() as f64);
        let mut sum = 0.0;
        for (&column, &row) in columns.iter().zip(&rows) {
            cells[row * n + column] += 1;
            sum += (column as f64 + random.uniform()) * (row as f64 + random.uniform());
        }
        product.push(sum / (n * n * n) as f64);
        let diagonal = columns.iter().zip(&rows).filter(|(column, row)| column == row).count();
        on_diagonal.push(diagonal as f64 / n as f64);
    }
    let count = (asked.replicates * n) as f64;
    let verdict = chi_square(&orders);
    let facts = Facts::default()
        .integer("permutations", orders.iter().filter(|count| **count > 0).count() as i64)
        .estimate("diagonal", &on_diagonal)
        .estimate("mean-xy", &product)
        .estimate("fixed-items", &kept)
        .number("chi-square", verdict.map_or(f64::NAN, |verdict| verdict.statistic));
    let share = |counts: &[u64], of: f64| counts.iter().map(|&count| count as f64 / of).collect::<Vec<_>>();
    let side = Side::new(verdict.is_some_and(|verdict| verdict.probability > 1e-6), facts);
    side.column("share of the permutations", share(&orders, asked.replicates as f64))
        .list("cells", share(&cells, count))
}

/// The number of permutations of `n` items.
fn factorial(n: usize) -> usize {
    (1..=n).product()
}

/// The place of a permutation among all of them in lexicographic order, from 0.
fn rank(items: &[usize]) -> usize {
    let smaller = |k: usize| items[k + 1..].iter().filter(|later| **later < items[k]).count();
    (0..items.len()).map(|k| smaller(k) * factorial(items.len() - 1 - k)).sum()
}

mod drawing {
    //! The bars of all permutations, the cells of the points, and their words.

    use super::super::drawing::{RIGHT, WRONG};
    use super::{Asked, Found, Side};
    use crate::chart::number::{fixed, integer};
    use crate::chart::{
        Axis, Bars, Boxes, Chart, ChartError, Corner, Drawing, Key, Note, Panel, Rule, Sheet, Strata, Style,
    };

    pub(super) fn draw(asked: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let highest = found.wrong.get(SHARES).iter().copied().fold(0.0, f64::max);
        let sides =
            [(&found.wrong, WRONG, "Wrong: partner 0 to *i* − 1"), (&found.right, RIGHT, "Right: partner 0 to *i*")];
        let bars = sides.map(|(side, style, title)| bars(found, side, style, title, 1.15 * highest));
        let cells = sides.map(|(side, style, _)| cells(asked.n, side, style));
        Ok(Chart::grid(bars.into_iter().chain(cells).collect()).columns(2).key(Key::Hidden).draw(sheet)?.into())
    }

    const SHARES: &str = "share of the permutations";

    fn bars(found: &Found, side: &Side, style: Style, title: &str, top: f64) -> Panel {
        let shares = side.get(SHARES);
        let edges = (0..=shares.len()).map(|k| k as f64 + 0.5).collect();
        let last = shares.len();
        let ticks = [1, last / 2, last].into_iter().map(|k| (k as f64, k.to_string().into())).collect();
        let along = Axis::linear("permutation").range(0.5, last as f64 + 0.5).ticks_at(ticks);
        Panel::new(along, Axis::linear("share").range(0.0, top))
            .title(title)
            .ratio(0.55)
            .with(Bars::new(edges, shares.to_vec()).style(style))
            .with(Rule::horizontal(1.0 / found.facts.get("orders")))
    }

    /// The share of the points in each cell, in percent; the diagonal shaded.
    fn cells(n: usize, side: &Side, style: Style) -> Panel {
        let width = 1.0 / n as f64;
        let corner = |k: usize| k as f64 * width;
        let diagonal = (0..n).map(|k| [(corner(k), corner(k)), (corner(k + 1), corner(k + 1))]).collect();
        let note = |(cell, share): (usize, &f64)| {
            let at = (corner(cell % n) + width / 2.0, corner(cell / n) + width / 2.0);
            Note::new(at, format!("{}\u{202f}%", fixed(100.0 * share, 1))).corner(Corner::Centre)
        };
        Panel::unit_square()
            .title("Points in each cell")
            .strata(Strata::cells(n as u32))
            .with(Boxes::new(diagonal).plain().style(style))
            .with_all(side.get("cells").iter().enumerate().map(note))
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let orders = integer(found.facts.count("orders"));
        let told = |side: &Side| {
            format!(
                "{} of {orders} permutations occur, and {} % of the points lie in diagonal cells",
                integer(side.facts.count("permutations")),
                fixed(100.0 * side.facts.get("diagonal"), 1)
            )
        };
        format!(
            "Above, bars: how often each permutation of {n} items occurs in {} shuffles, beside its due share. Below, the {n} by {n} cells of \
             Latin hypercubes shuffled so, with the share of points in each. Partner never the item itself: {}. Partner also the item \
             itself: {}.",
            integer(asked.replicates as i64),
            told(&found.wrong),
            told(&found.right),
            n = asked.n,
        )
    }
}
