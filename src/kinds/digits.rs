//! Radical inverses in one or several bases: digits, reflected digits, the exact fraction and its decimals.
//!
//! Generalises the table of the van der Corput sequence to any bases and any range of indices, as the axes of Halton's sequence
//! need it. The digits are found by whole-number arithmetic; the value `agrees` says that the samplers' numbers are the nearest
//! to the exact fractions.

use serde::{Deserialize, Serialize};

use super::radical::{Row, sampler};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `digits`.
pub static DIGITS: DigitsKind = DigitsKind;

/// The kind of experiment that tabulates radical inverses in any bases.
pub struct DigitsKind;

static ABOUT: About = About {
    key: "digits",
    title: "Table of radical inverses",
    summary: "Indices with their digits in one or several bases, reflected, as exact fractions and as decimals.",
    file: "kinds/digits.rs",
    source: include_str!("digits.rs"),
    papers: &[],
};

parameters! {
    /// What a table of radical inverses can choose.
    pub struct Digits {
        /// The bases: a group of columns each.
        bases: Vec<usize> [in 2..=36] [or base] = [2, 3],
        /// The first index.
        from: usize [in 0..=4_294_967_295] = 0,
        /// How many indices.
        n: usize [in 1..=1024] = 16,
        /// How many decimals are printed; none if 0.
        @drawn decimals: usize [in 0..=15] = 4,
    }
}

/// The rows of every base.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    bases: Vec<Vec<Row>>,
}

impl Kind for DigitsKind {
    type Parameters = Digits;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Digits, problems: &mut Problems<'_, '_>) {
        if p.bases.len() > 4 {
            let message = format!("{} bases are more than the 4 that a table has room for", p.bases.len());
            problems.at("bases", Code::OutOfRange, message, Some("make several tables".to_owned()));
        }
    }

    fn uses(&self, p: &Digits) -> Vec<&'static About> {
        let abouts = |&base: &usize| Method::parse(sampler(base)).map(|method| method.abouts()).unwrap_or_default();
        p.bases.iter().flat_map(abouts).collect()
    }

    fn weight(&self, p: &Digits) -> u64 {
        (p.n * p.bases.len()) as u64
    }

    fn run(&self, p: &Digits, _: Seed) -> Result<Data, Failure> {
        let first = p.from as u64;
        let rows = |&base: &usize| (first..first + p.n as u64).map(|index| Row::new(index, base as u64)).collect();
        Ok(Data { bases: p.bases.iter().map(rows).collect() })
    }

    fn values(&self, p: &Digits, data: &Data) -> Values {
        let mut values = Values::new();
        for (base, rows) in p.bases.iter().zip(&data.bases) {
            for row in rows {
                values.number(format!("phi.{base}.{}", row.index), row.phi);
            }
            values.boolean(format!("agrees.{base}"), rows.iter().all(Row::agrees));
        }
        values.boolean("agrees", data.bases.iter().flatten().all(Row::agrees));
        values
    }

    fn tables(&self, p: &Digits, data: &Data) -> Vec<Frame> {
        let rows = || p.bases.iter().zip(&data.bases).flat_map(|(base, rows)| rows.iter().map(move |row| (*base, row)));
        let frame = Frame::new("radical-inverses")
            .counts("base", rows().map(|(base, _)| base))
            .counts("n", rows().map(|(_, row)| row.index as usize))
            .text("digits", rows().map(|(_, row)| row.digits.clone()))
            .text("reflected digits", rows().map(|(_, row)| row.reflected.clone()))
            .text("fraction", rows().map(|(_, row)| row.fraction()))
            .numbers("phi", rows().map(|(_, row)| row.phi));
        vec![frame]
    }

    fn draw(&self, p: &Digits, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(p, data))
    }

    fn alt(&self, p: &Digits, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

mod drawing {
    //! The table of digits, and its words.

    use super::{Data, Digits};
    use crate::chart::{Cell, Column, Drawing, Table};

    pub(super) fn draw(p: &Digits, data: &Data) -> Drawing {
        let mut columns = vec![Column::right("$i$")];
        for base in &p.bases {
            columns.push(Column::right(format!("Base {base}")));
            columns.push(Column::left("Reflected"));
            columns.push(Column::left(format!("$\\Phi_{{{base}}}(i)$")));
            columns.extend((p.decimals > 0).then(|| Column::right("")));
        }
        let mut table = Table::new(columns);
        let count = data.bases.first().map_or(0, Vec::len);
        for index in 0..count {
            let rows = || data.bases.iter().filter_map(|rows| rows.get(index));
            let n = rows().next().map_or(0, |row| row.index);
            let cells = rows().flat_map(|row| {
                let decimal = (p.decimals > 0).then(|| Cell::fixed(row.phi, p.decimals));
                let exact =
                    [Cell::Code(row.digits.clone()), Cell::Code(row.reflected.clone()), Cell::Math(row.fraction())];
                exact.into_iter().chain(decimal)
            });
            table.push(std::iter::once(Cell::Integer(n as i64)).chain(cells));
        }
        Drawing::Table(table)
    }

    pub(super) fn alt(p: &Digits, data: &Data) -> Option<String> {
        let told = p.bases.iter().zip(&data.bases).filter_map(|(base, rows)| {
            let last = rows.last()?;
            Some(format!(
                "in base {base}, {} is {}, reflected {}, {}",
                last.index,
                last.digits,
                last.reflected,
                last.fraction()
            ))
        });
        let first = data.bases.first()?.first()?.index;
        let told: Vec<String> = told.collect();
        Some(format!("Radical inverses of {} indices from {first}: {}.", p.n, told.join("; ")))
    }
}
