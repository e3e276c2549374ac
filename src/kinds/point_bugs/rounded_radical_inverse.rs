//! The radical inverse summed in single precision, and reversed bits converted to single precision: both return 1 at last.
//!
//! For each base the first index is found at which that happens. With k digits the sum is at most k/2 + 4 units of 2^-24 off: a weight
//! b^-j has gathered 2j roundings and its term one more, the weighted sum of which is below 4 units; and each of the k additions rounds by
//! half a unit. An index below 2^32 has at most 32 digits, so that the error is below 2^-19. A sum of 1 thus needs a radical inverse
//! of at least 1 - 2^-19, and so all its leading digits b - 1, as many as there are j with b^j <= 2^19: only every b^j-th index can be
//! the one, and these are tried in order.

use super::{Asked, Bug, Facts, Found, Side};
use crate::kinds::Failure;
use crate::samplers::halton::radical_inverse;
use crate::seed::Seed;

/// Radical inverses in six bases, and reversed bits.
pub static BUG: Bug = Bug {
    key: "rounded-radical-inverse",
    title: "digits summed in single precision",
    n: None,
    replicates: None,
    uses: &["halton", "van-der-corput"],
    weight: |_| 100_000,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

const BASES: [u32; 6] = [2, 3, 5, 7, 11, 13];

/// The radical inverse as a sum in single precision.
fn wrong(index: u32, base: u32) -> f32 {
    let inverse = 1.0 / base as f32;
    let (mut rest, mut weight, mut value) = (index, inverse, 0.0);
    while rest != 0 {
        value += (rest % base) as f32 * weight;
        weight *= inverse;
        rest /= base;
    }
    value
}

/// The radical inverse in base 2 by reversed bits: the conversion rounds to 24 bits.
fn wrong_bits(index: u32) -> f32 {
    index.reverse_bits() as f32 / 4_294_967_296.0
}

/// The radical inverse with the digits reversed as a whole number, then one division in double precision.
fn right(index: u32, base: u32) -> f64 {
    radical_inverse(u64::from(index), base)
}

fn run(_: &Asked, _: Seed) -> Result<Found, Failure> {
    let one = |value: f32| value >= 1.0;
    let mut rows: Vec<(u32, u32, f32)> = Vec::new();
    let mut facts = Facts::default();
    for base in BASES {
        let Some(index) = first(base, |index| one(wrong(index, base))) else { continue };
        rows.push((base, index, wrong(index, base)));
        facts = facts.integer(format!("first.{base}"), i64::from(index));
        if let Some(above) = first(base, |index| wrong(index, base) > 1.0) {
            facts = facts.integer(format!("first-above.{base}"), i64::from(above));
        }
    }
    if let Some(index) = first(2, |index| one(wrong_bits(index))) {
        rows.push((2, index, wrong_bits(index)));
        facts = facts.integer("first.bits", i64::from(index));
    }
    let summed: Vec<f64> = rows.iter().map(|row| f64::from(row.2)).collect();
    let divided: Vec<f64> = rows.iter().map(|row| right(row.1, row.0)).collect();
    Ok(Found { wrong: measure(&rows, summed), right: measure(&rows, divided), facts })
}

/// The test: every number is below 1.
fn measure(rows: &[(u32, u32, f32)], values: Vec<f64>) -> Side {
    let below = values.iter().filter(|value| **value < 1.0).count();
    let facts = Facts::default()
        .integer("below-one", below as i64)
        .integer("rows", values.len() as i64)
        .number("largest", values.iter().copied().fold(0.0, f64::max));
    let side = Side::new(below == values.len(), facts);
    let side = side.column("base", rows.iter().map(|row| f64::from(row.0)));
    side.column("index", rows.iter().map(|row| f64::from(row.1))).column("value", values)
}

/// The first index below 2^32 at which `reached` holds, of those whose radical inverse is at least 1 - 2^-19.
fn first(base: u32, reached: impl Fn(u32) -> bool) -> Option<u32> {
    let powers = std::iter::successors(Some(1_u32), |power| power.checked_mul(base));
    let step = powers.take_while(|power| *power <= 1 << 19).last()?;
    (step - 1..u32::MAX).step_by(step as usize).find(|&index| reached(index))
}

mod drawing {
    //! The table, and its words.

    use super::{Asked, BASES, Found};
    use crate::chart::number::{fixed, integer};
    use crate::chart::{Cell, ChartError, Column, Drawing, Sheet, Table};

    #[expect(clippy::unnecessary_wraps, reason = "as the other drawings")]
    pub(super) fn draw(_: &Asked, found: &Found, _: &Sheet) -> Result<Drawing, ChartError> {
        let mut table = Table::new(vec![
            Column::left("Base"),
            Column::right("First index"),
            Column::left(""),
            Column::left("Wrong: single precision"),
            Column::left("Right: one division"),
        ]);
        let values = found.wrong.get("value").iter().zip(found.right.get("value"));
        for (row, ((base, index), (&wrong, &right))) in
            found.wrong.pairs("base", "index").into_iter().zip(values).enumerate()
        {
            let name = if row < BASES.len() { format!("{base}, summed") } else { format!("{base}, bits reversed") };
            table.push([
                Cell::text(name),
                Cell::Integer(index as i64),
                Cell::Math(form(index as u32, base as u32)),
                below(wrong),
                below(right),
            ]);
        }
        Ok(Drawing::Table(table))
    }

    /// A number, and whether it is below 1.
    fn below(value: f64) -> Cell {
        Cell::Holds { holds: value < 1.0, text: fixed(value, 8) }
    }

    /// An index as one less than a digit times a power of the base, which it is where all its digits but the first are the last digit.
    fn form(index: u32, base: u32) -> String {
        let (mut digit, mut exponent) = (index + 1, 0);
        while digit % base == 0 {
            digit /= base;
            exponent += 1;
        }
        let times = if digit == 1 { String::new() } else { format!("{digit} \\cdot ") };
        format!("{times}{base}^{{{exponent}}} - 1")
    }

    pub(super) fn alt(_: &Asked, found: &Found) -> String {
        let rows = found.wrong.pairs("base", "index").into_iter().zip(found.wrong.get("value")).enumerate();
        let told = rows.map(|(row, ((base, index), value))| {
            let how = if row < BASES.len() { "" } else { " with bits reversed" };
            let reached = if *value > 1.0 { "beyond 1" } else { "exactly 1" };
            format!("base {base}{how}, {reached} at {}", integer(index as i64))
        });
        let told: Vec<String> = told.collect();
        let (below, rows) = (found.right.facts.count("below-one"), found.right.facts.count("rows"));
        format!(
            "The first index at which the radical inverse in single precision is not below 1: {}. With one division in double precision {below} of \
             {rows} are below 1.",
            told.join("; ")
        )
    }
}
