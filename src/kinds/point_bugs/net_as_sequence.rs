//! The Larcher-Pillichshammer coordinate in a sequence: (Phi_2(i), LP(i)) is no (0,2)-sequence, and its discrepancy stalls.
//!
//! The columns of its matrix make a net of quality 0 with i/N, and of quality m - 2 with the radical inverse.

use super::{Asked, Bug, Count, Facts, Found, Rule, Side, placed};
use crate::kinds::Failure;
use crate::metrics::{nets, star};
use crate::samplers::larcher_pillichshammer::ones;
use crate::samplers::van_der_corput::bit_reversal;
use crate::seed::Seed;

/// The first N points, for N = 4, 8, ..., n.
pub static BUG: Bug = Bug {
    key: "net-as-sequence",
    title: "a net used as a sequence",
    n: Some(Count::new(1024, 64, 4096).being(Rule::PowerOf(2))),
    replicates: None,
    uses: &["larcher-pillichshammer", "van-der-corput"],
    weight: |asked| 100 * asked.n as u64,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// 2^-53: the coordinates have 53 digits.
const GRAIN: f64 = 1.0 / 9_007_199_254_740_992.0;

/// The first points of a sequence: a new point needs no count.
fn wrong(count: usize) -> Vec<[f64; 2]> {
    (0..count as u64).map(|i| [bit_reversal(i), ones(i) as f64 * GRAIN]).collect()
}

/// The points of a net: the count must be known.
fn right(count: usize) -> Vec<[f64; 2]> {
    (0..count as u64).map(|i| [i as f64 / count as f64, ones(i) as f64 * GRAIN]).collect()
}

/// How many points are shown.
const SHOWN: usize = 64;

fn run(asked: &Asked, _: Seed) -> Result<Found, Failure> {
    Ok(Found {
        wrong: measure(asked.n, wrong),
        right: measure(asked.n, right),
        facts: Facts::default().integer("shown", SHOWN as i64),
    })
}

/// The test: of each N points the quality t as a net is 0.
fn measure(most: usize, place: fn(usize) -> Vec<[f64; 2]>) -> Side {
    let counts: Vec<usize> = (2..=most.ilog2()).map(|m| 1 << m).collect();
    let (mut facts, mut discrepancies, mut qualities) = (Facts::default(), Vec::new(), Vec::new());
    let mut boxes = Vec::new();
    for &count in &counts {
        let Some(points) = placed(&place(count)) else { continue };
        let quality = nets::quality(&points, 2).map_or(f64::NAN, f64::from);
        let measured = star::star_discrepancy(&points).ok();
        let discrepancy = measured.as_ref().map_or(f64::NAN, |measured| measured.value);
        if let Some([x, y]) = measured.filter(|_| count == SHOWN).map(|measured| measured.extremal).as_deref() {
            boxes.push([0.0, 0.0, *x, *y]);
        }
        facts = facts.number(format!("dstar.{count}"), discrepancy).number(format!("t.{count}"), quality);
        discrepancies.push(discrepancy);
        qualities.push(quality);
    }
    let shown = place(SHOWN);
    Side::new(qualities.iter().all(|quality| *quality == 0.0), facts)
        .column("N", counts.iter().map(|&count| count as f64))
        .column("star discrepancy", discrepancies)
        .column("t", qualities)
        .list("x", shown.iter().map(|point| point[0]))
        .list("y", shown.iter().map(|point| point[1]))
        .boxes(boxes)
}

mod drawing {
    //! The points of both with their worst boxes, the discrepancy over N, and their words.

    use super::super::drawing::{RIGHT, WRONG, square};
    use super::{Asked, Found, SHOWN, Side};
    use crate::chart::number::{integer, significant};
    use crate::chart::{Axis, Chart, ChartError, Drawing, Key, Line, Panel, Sheet, Style};

    pub(super) fn draw(_: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let wrong = square(&found.wrong, WRONG, "Wrong: a sequence", &[]);
        let right = square(&found.right, RIGHT, "Right: a net", &[]);
        let line = |side: &Side, style: Style| Line::new(side.pairs("N", "star discrepancy")).style(style).marked();
        let curve = Panel::new(Axis::log2("*N*"), Axis::log("*D*\\*"))
            .title("Star discrepancy")
            .ratio(0.7)
            .with(line(&found.wrong, WRONG))
            .with(line(&found.right, RIGHT));
        let quality = |side: &Side, style: Style| Line::new(side.pairs("N", "t")).style(style).marked();
        let qualities = Panel::new(Axis::log2("*N*"), Axis::linear("*t*").include(0.0))
            .title("Quality as a net")
            .ratio(0.7)
            .with(quality(&found.wrong, WRONG))
            .with(quality(&found.right, RIGHT));
        Ok(Chart::grid(vec![wrong, right, curve, qualities]).columns(2).key(Key::Hidden).draw(sheet)?.into())
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let told = |side: &Side| {
            let of = |count: usize| significant(side.facts.get(&format!("dstar.{count}")), 3);
            let t = side.facts.count(&format!("t.{}", asked.n));
            format!(
                "{} at N = {SHOWN}, {} at N = {} with the quality t = {t}",
                of(SHOWN),
                of(asked.n),
                integer(asked.n as i64)
            )
        };
        format!(
            "Two unit squares with {SHOWN} points and the box of the star discrepancy shaded, and below them two curves over N: the \
             discrepancy, and the quality t as a net. As a sequence, with the radical inverse: {}. As a net, with i/N: {}.",
            told(&found.wrong),
            told(&found.right)
        )
    }
}
