//! Strata: how many of them k per axis make in d dimensions.
//!
//! Stratifying each of d axes into k parts makes k^d strata, with one sample each at the least. The counts are exact whole
//! numbers, however long.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::seed::Seed;

/// The kind `strata-count`.
pub static STRATA_COUNT: StrataCountKind = StrataCountKind;

/// The kind of experiment that counts strata.
pub struct StrataCountKind;

static ABOUT: About = About {
    key: "strata-count",
    title: "Strata in d dimensions",
    summary: "How many strata k per axis make in d dimensions, exactly, and which counts are out of reach.",
    file: "kinds/strata_count.rs",
    source: include_str!("strata_count.rs"),
    papers: &[],
};

parameters! {
    /// What a table of strata can choose.
    pub struct StrataCount {
        /// The numbers of strata along each axis: one column each.
        per_axis: Vec<usize> [in 1..=1_000_000] = [2, 4, 8, 16],
        /// The dimensions: one row each.
        dimensions: Vec<usize> [in 1..=64] = [1, 2, 3, 4, 6, 8, 16],
        /// How many samples are within reach.
        reach: f64 [in 1.0..=1e18] = 1e9,
    }
}

/// The counts, row by row.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// One list of k^d for each dimension, in decimal digits.
    rows: Vec<Vec<String>>,
}

impl Kind for StrataCountKind {
    type Parameters = StrataCount;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &StrataCount, _: &mut Problems<'_, '_>) {}

    fn weight(&self, p: &StrataCount) -> u64 {
        (p.per_axis.len() * p.dimensions.len()) as u64
    }

    fn run(&self, p: &StrataCount, _: Seed) -> Result<Data, Failure> {
        let row = |&d: &usize| p.per_axis.iter().map(|&k| power(k as u64, d)).collect();
        Ok(Data { rows: p.dimensions.iter().map(row).collect() })
    }

    fn values(&self, p: &StrataCount, data: &Data) -> Values {
        let mut values = Values::new();
        for (d, row) in p.dimensions.iter().zip(&data.rows) {
            for (k, count) in p.per_axis.iter().zip(row) {
                match count.parse::<i64>() {
                    Ok(count) => values.integer(format!("strata.{k}.{d}"), count),
                    Err(_) => values.number(format!("strata.{k}.{d}"), number(count)),
                }
                values.boolean(format!("within-reach.{k}.{d}"), number(count) <= p.reach);
            }
        }
        values
    }

    fn tables(&self, p: &StrataCount, data: &Data) -> Vec<Frame> {
        let cells = || {
            p.dimensions
                .iter()
                .zip(&data.rows)
                .flat_map(|(d, row)| p.per_axis.iter().zip(row).map(move |(k, count)| (*d, *k, count)))
        };
        let frame = Frame::new("strata")
            .counts("dimensions", cells().map(|cell| cell.0))
            .counts("strata per axis", cells().map(|cell| cell.1))
            .text("strata", cells().map(|cell| cell.2.clone()));
        vec![frame]
    }

    fn draw(&self, p: &StrataCount, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(p, data))
    }

    fn alt(&self, p: &StrataCount, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

/// k^d in decimal digits: schoolbook multiplication, nine digits at a time.
fn power(k: u64, d: usize) -> String {
    const GROUP: u64 = 1_000_000_000;
    let mut groups = vec![1_u64];
    for _ in 0..d {
        let mut carry = 0;
        for group in &mut groups {
            let product = *group * k + carry;
            (*group, carry) = (product % GROUP, product / GROUP);
        }
        while carry > 0 {
            groups.push(carry % GROUP);
            carry /= GROUP;
        }
    }
    let mut digits = groups.last().map_or_else(String::new, u64::to_string);
    groups.iter().rev().skip(1).for_each(|group| digits += format!("{group:09}").as_str());
    digits
}

/// The value of decimal digits; infinite where no number is so large.
fn number(digits: &str) -> f64 {
    digits.parse().unwrap_or(f64::INFINITY)
}

mod drawing {
    //! The table of counts, and its words.

    use super::{Data, StrataCount, number};
    use crate::chart::number::{integer, parts, significant};
    use crate::chart::{Cell, Column, Drawing, Table};

    /// Counts of more digits than this are rounded in print.
    const LONG: usize = 13;

    pub(super) fn draw(p: &StrataCount, data: &Data) -> Drawing {
        let mut columns = vec![Column::right("$d$")];
        columns.extend(p.per_axis.iter().map(|k| Column::right(format!("${k}^d$"))));
        let mut table = Table::new(columns);
        for (d, row) in p.dimensions.iter().zip(&data.rows) {
            let cells = row.iter().map(|count| cell(count, p.reach));
            table.push(std::iter::once(Cell::from(*d)).chain(cells));
        }
        Drawing::Table(table)
    }

    /// A count; what is out of reach is set in brackets.
    fn cell(count: &str, reach: f64) -> Cell {
        let value = number(count);
        let bracketed = |text: String| if value <= reach { text } else { format!("({text})") };
        match count.parse::<i64>() {
            Ok(whole) if count.len() <= LONG => Cell::Decimal { value, text: bracketed(integer(whole)) },
            _ => {
                // From the digits, since the count may be more than any number.
                let head = count.get(..16).unwrap_or(count);
                let (mantissa, exponent) = parts(number(head), 3);
                let exponent = exponent + (count.len() - head.len()) as i32;
                Cell::Math(bracketed(format!("{mantissa} \\times 10^{{{exponent}}}")))
            }
        }
    }

    pub(super) fn alt(p: &StrataCount, data: &Data) -> Option<String> {
        let cells = p
            .dimensions
            .iter()
            .zip(&data.rows)
            .flat_map(|(d, row)| p.per_axis.iter().zip(row).map(move |(k, count)| (*d, *k, number(count))));
        let cells: Vec<(usize, usize, f64)> = cells.collect();
        let least = cells.iter().min_by(|a, b| a.2.total_cmp(&b.2))?;
        let most = cells.iter().max_by(|a, b| a.2.total_cmp(&b.2))?;
        let beyond = cells.iter().filter(|cell| cell.2 > p.reach).count();
        let told = |&(d, k, count): &(usize, usize, f64)| {
            if count.is_finite() {
                format!("{} for {k} strata along each of {d} axes", significant(count, 4))
            } else {
                format!("more than 10^308 for {k} strata along each of {d} axes")
            }
        };
        let told = [told(least), told(most)].join(" to ");
        Some(format!(
            "The number of strata, from {told}. {beyond} of the {} counts, in brackets, are beyond {}.",
            cells.len(),
            significant(p.reach, 2)
        ))
    }
}
