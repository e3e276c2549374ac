//! Bit reversal: the radical inverse in base 2 without a loop over digits, held against the loop.
//!
//! A processor reverses the bits of a word in a few steps by swapping ever larger halves; as a fraction of the word's range that
//! is the radical inverse. The two are compared bit by bit for every index.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::{Method, halton, van_der_corput};
use crate::seed::Seed;

/// The kind `bit-reversal`.
pub static BIT_REVERSAL: BitReversalKind = BitReversalKind;

/// The kind of experiment that compares bit reversal with the digit loop.
pub struct BitReversalKind;

static ABOUT: About = About {
    key: "bit-reversal",
    title: "Bit reversal",
    summary: "Bit reversal against the loop over digits, for every index up to a count.",
    file: "kinds/bit_reversal.rs",
    source: include_str!("bit_reversal.rs"),
    papers: &[],
};

parameters! {
    /// What a comparison of bit reversal can choose.
    pub struct BitReversal {
        /// How many indices are compared, from 0.
        indices: usize [in 1..=67_108_864] = 1048576,
        /// How many rows are shown: the first ones, and the last index.
        @drawn rows: usize [in 1..=64] = 8,
    }
}

/// How many indices agree, and the first that does not.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    equal: u64,
    first_unequal: Option<u64>,
    largest: f64,
    shown: Vec<Shown>,
}

/// One index by both ways.
#[derive(Debug, Serialize, Deserialize)]
struct Shown {
    index: u64,
    reversed: f64,
    looped: f64,
}

impl Kind for BitReversalKind {
    type Parameters = BitReversal;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &BitReversal, _: &mut Problems<'_, '_>) {}

    fn uses(&self, _: &BitReversal) -> Vec<&'static About> {
        ["van-der-corput", "halton"]
            .into_iter()
            .filter_map(|name| Method::parse(name).ok())
            .flat_map(|m| m.abouts())
            .collect()
    }

    fn weight(&self, p: &BitReversal) -> u64 {
        p.indices as u64 * 8
    }

    fn run(&self, p: &BitReversal, _: Seed) -> Result<Data, Failure> {
        let last = p.indices as u64 - 1;
        let (mut equal, mut first_unequal, mut largest) = (0, None, 0.0_f64);
        for index in 0..=last {
            let Shown { reversed, looped, .. } = both(index);
            largest = largest.max(reversed).max(looped);
            if reversed.to_bits() == looped.to_bits() {
                equal += 1;
            } else {
                first_unequal = first_unequal.or(Some(index));
            }
        }
        let shown = (0..64.min(last)).chain([last]).map(both).collect();
        Ok(Data { equal, first_unequal, largest, shown })
    }

    fn values(&self, p: &BitReversal, data: &Data) -> Values {
        let mut values = Values::new();
        values.boolean("equal", data.equal == p.indices as u64);
        values.integer("checked", p.indices as i64);
        values.integer("count", data.equal as i64);
        values.number("largest", data.largest);
        if let Some(index) = data.first_unequal {
            values.integer("first-unequal", index as i64);
        }
        values
    }

    fn tables(&self, _: &BitReversal, data: &Data) -> Vec<Frame> {
        let frame = Frame::new("bit-reversal")
            .counts("n", data.shown.iter().map(|shown| shown.index as usize))
            .numbers("bit reversal", data.shown.iter().map(|shown| shown.reversed))
            .numbers("digit loop", data.shown.iter().map(|shown| shown.looped));
        vec![frame]
    }

    fn draw(&self, p: &BitReversal, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(p, data))
    }

    fn alt(&self, p: &BitReversal, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The radical inverse of `index` by both ways.
fn both(index: u64) -> Shown {
    Shown { index, reversed: van_der_corput::bit_reversal(index), looped: halton::radical_inverse(index, 2) }
}

mod drawing {
    //! The table of both ways, and its words.

    use super::{BitReversal, Data};
    use crate::chart::number::integer;
    use crate::chart::{Cell, Column, Drawing, Table};

    pub(super) fn draw(p: &BitReversal, data: &Data) -> Drawing {
        let mut table = Table::new(vec![
            Column::right("$i$"),
            Column::right("Bits"),
            Column::left("Reversed"),
            Column::right("Bit reversal"),
            Column::right("Digit loop"),
            Column::centre("Equal"),
        ]);
        let last = data.shown.len().saturating_sub(1);
        for (row, shown) in data.shown.iter().enumerate().filter(|(row, _)| *row + 1 < p.rows || *row == last) {
            // The last index stands for itself, with as many decimals as the others.
            let bits = format!("{:b}", shown.index);
            let reversed: String = bits.chars().rev().collect();
            let places = if row == last { 6 } else { 6.min(bits.len()) };
            table.push([
                Cell::Integer(shown.index as i64),
                Cell::Code(short(&bits)),
                Cell::Code(format!(".{}", short(&reversed))),
                Cell::fixed(shown.reversed, places),
                Cell::fixed(shown.looped, places),
                Cell::holds(shown.reversed.to_bits() == shown.looped.to_bits()),
            ]);
        }
        let all = data.equal == p.indices as u64;
        let text = format!("{} of {}", integer(data.equal as i64), integer(p.indices as i64));
        table.push([
            Cell::text("all"),
            Cell::Empty,
            Cell::Empty,
            Cell::Empty,
            Cell::Empty,
            Cell::Holds { holds: all, text },
        ]);
        table.footers = 1;
        Drawing::Table(table)
    }

    /// Bits as they are, or the first and last of many.
    fn short(bits: &str) -> String {
        let count = bits.len();
        if count <= 10 { bits.to_owned() } else { format!("{}…{}", &bits[..4], &bits[count - 4..]) }
    }

    pub(super) fn alt(p: &BitReversal, data: &Data) -> String {
        let (equal, all) = (integer(data.equal as i64), integer(p.indices as i64));
        format!("Bit reversal and the loop over digits give the same number for {equal} of {all} indices, from 0 on.")
    }
}
