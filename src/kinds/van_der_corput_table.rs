//! The table of the van der Corput sequence: an index, its digits, the digits reflected at the point, and the fraction they make.
//!
//! The digits here are found by whole-number arithmetic, apart from the sampler; the table thus also shows, in the value
//! `agrees`, that the sampler's floating-point numbers are the nearest to the exact fractions.

use serde::{Deserialize, Serialize};

use super::radical::{Row, sampler};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `van-der-corput-table`.
pub static VAN_DER_CORPUT_TABLE: VanDerCorputTableKind = VanDerCorputTableKind;

/// The kind of experiment that tabulates radical inverses.
pub struct VanDerCorputTableKind;

static ABOUT: About = About {
    key: "van-der-corput-table",
    title: "Table of the van der Corput sequence",
    summary: "Indices with their digits, the reflected digits and the exact fraction: the radical inverse by hand.",
    file: "kinds/van_der_corput_table.rs",
    source: include_str!("van_der_corput_table.rs"),
    papers: &[],
};

parameters! {
    /// What a table of the van der Corput sequence can choose.
    pub struct VanDerCorputTable {
        /// The last index; the first is 1.
        n: usize [in 1..=1024] = 16,
        /// The base of the digits.
        base: usize [in 2..=36] = 2,
    }
}

/// The rows, from index 1.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    rows: Vec<Row>,
}

impl Kind for VanDerCorputTableKind {
    type Parameters = VanDerCorputTable;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &VanDerCorputTable, _: &mut Problems<'_, '_>) {}

    fn uses(&self, p: &VanDerCorputTable) -> Vec<&'static About> {
        Method::parse(sampler(p.base)).map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, p: &VanDerCorputTable) -> u64 {
        p.n as u64
    }

    fn run(&self, p: &VanDerCorputTable, _: Seed) -> Result<Data, Failure> {
        Ok(Data { rows: (1..=p.n as u64).map(|index| Row::new(index, p.base as u64)).collect() })
    }

    fn values(&self, p: &VanDerCorputTable, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("base", p.base as i64);
        for row in &data.rows {
            values.number(format!("phi.{}", row.index), row.phi);
        }
        values.boolean("agrees", data.rows.iter().all(Row::agrees));
        values
    }

    fn tables(&self, _: &VanDerCorputTable, data: &Data) -> Vec<Frame> {
        let rows = || data.rows.iter();
        let frame = Frame::new("radical-inverse")
            .counts("n", rows().map(|row| row.index as usize))
            .text("digits", rows().map(|row| row.digits.clone()))
            .text("reflected digits", rows().map(|row| row.reflected.clone()))
            .counts("numerator", rows().map(|row| row.numerator as usize))
            .counts("denominator", rows().map(|row| row.denominator as usize))
            .numbers("phi", rows().map(|row| row.phi));
        vec![frame]
    }

    fn draw(&self, p: &VanDerCorputTable, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(p, data))
    }

    fn alt(&self, p: &VanDerCorputTable, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

mod drawing {
    //! The table of digits, and its words.

    use super::{Data, VanDerCorputTable};
    use crate::chart::{Cell, Column, Drawing, Table};

    pub(super) fn draw(p: &VanDerCorputTable, data: &Data) -> Drawing {
        let base = p.base;
        let mut table = Table::new(vec![
            Column::right("$i$"),
            Column::right(format!("$i$ in base {base}")),
            Column::left("Reflected"),
            Column::left(format!("$\\Phi_{{{base}}}(i)$")),
        ]);
        for row in &data.rows {
            table.push([
                Cell::Integer(row.index as i64),
                Cell::Code(row.digits.clone()),
                Cell::Code(row.reflected.clone()),
                Cell::Math(format!("{}/{}", row.numerator, row.denominator)),
            ]);
        }
        Drawing::Table(table)
    }

    pub(super) fn alt(p: &VanDerCorputTable, data: &Data) -> Option<String> {
        let (first, last) = (data.rows.first()?, data.rows.last()?);
        let told = |row: &super::Row| {
            format!(
                "{} is {} in base {}, reflected {}, {}/{}",
                row.index, row.digits, p.base, row.reflected, row.numerator, row.denominator
            )
        };
        Some(format!("The radical inverses of 1 to {}: {}; {}.", last.index, told(first), told(last)))
    }
}
