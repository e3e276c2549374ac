//! Enumeration: the samples of a pixel found directly, held against a search through all samples.
//!
//! The pixels of an image of b1^k by b2^l pixels are elementary intervals of the first two axes. For each of them the indices of
//! the sequence that fall in it are solved for, and compared with those that a pass over all points finds.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::{Pair, choices, parameters};
use crate::points::slab;
use crate::samplers::Method;
use crate::samplers::enumeration::{Interval, halton, sobol};
use crate::seed::Seed;

/// The kind `enumeration`.
pub static ENUMERATION: EnumerationKind = EnumerationKind;

/// The kind of experiment that finds the samples of pixels.
pub struct EnumerationKind;

static ABOUT: About = About {
    key: "enumeration",
    title: "Enumeration by pixels",
    summary: "The indices of a sequence that fall in each pixel, found directly and by a search through all samples.",
    file: "kinds/enumeration.rs",
    source: include_str!("enumeration.rs"),
    papers: &[Paper {
        authors: "L. Gruenschloss, M. Raab and A. Keller",
        year: 2012,
        title: "Enumerating Quasi-Monte Carlo Point Sequences in Elementary Intervals",
        venue: "Monte Carlo and Quasi-Monte Carlo Methods 2010, Springer, 399-408",
        doi: Some("10.1007/978-3-642-27440-4_21"),
    }],
};

choices! {
    /// The sequences whose samples can be enumerated.
    pub enum Sequence {
        /// Halton: a congruence for each axis, joined by the Chinese remainder theorem.
        Halton = "halton",
        /// Sobol': linear equations modulo 2 in the bits of the index.
        Sobol = "sobol",
    }
}

parameters! {
    /// What an enumeration can choose.
    pub struct Enumeration {
        /// The sequence.
        sampler: Sequence = "halton",
        /// The digits of a pixel's column and row: the image has b1^k by b2^l pixels.
        digits: Pair [in 1..=12] = [4, 3],
        /// How many samples each pixel gets; for Sobol' a power of 2.
        samples: usize [in 1..=4096] = 4,
        /// How many pixels are shown.
        @drawn rows: usize [in 1..=64] = 8,
    }
}

/// What was found.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    columns: u64,
    rows: u64,
    /// How many samples were enumerated directly, and how many of them the search found in the same pixel at the same place.
    enumerated: u64,
    equal: u64,
    /// Pixels whose two lists are the same.
    same: u64,
    shown: Vec<Pixel>,
}

/// One pixel with its samples.
#[derive(Debug, Serialize, Deserialize)]
struct Pixel {
    column: u64,
    row: u64,
    indices: Vec<u64>,
    is_same: bool,
}

impl Kind for EnumerationKind {
    type Parameters = Enumeration;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Enumeration, problems: &mut Problems<'_, '_>) {
        if p.sampler == Sequence::Sobol && !p.samples.is_power_of_two() {
            let message = format!("{} samples in a pixel are no power of 2", p.samples);
            let above = p.samples.next_power_of_two();
            let help = format!("the nearest powers of 2 are {} and {above}", above / 2);
            problems.at("samples", Code::Count, message, Some(help));
        }
        let (columns, rows) = size(p);
        let all = columns.saturating_mul(rows).saturating_mul(p.samples as u64);
        if all > 1 << 22 {
            let message = format!("{all} samples are more than the {} that a search goes through", 1 << 22);
            problems.at("digits", Code::OutOfRange, message, Some("take fewer digits or samples".to_owned()));
        }
    }

    fn uses(&self, p: &Enumeration) -> Vec<&'static About> {
        Method::parse(p.sampler.word()).map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, p: &Enumeration) -> u64 {
        let (columns, rows) = size(p);
        columns.saturating_mul(rows).saturating_mul(4 * p.samples as u64)
    }

    fn run(&self, p: &Enumeration, seed: Seed) -> Result<Data, Failure> {
        let (columns, rows) = size(p);
        let found = search(p, seed)?;
        let mut data = Data { columns, rows, enumerated: 0, equal: 0, same: 0, shown: Vec::new() };
        let pixels = columns * rows;
        for (pixel, found) in found.iter().enumerate() {
            let (column, row) = (pixel as u64 % columns, pixel as u64 / columns);
            let indices = direct(p, column, row)
                .ok_or_else(|| Failure::of("digits", "a pixel is beyond what can be enumerated"))?;
            data.enumerated += indices.len() as u64;
            data.equal += indices.iter().zip(found).filter(|(a, b)| a == b).count() as u64;
            let is_same = indices == *found;
            data.same += u64::from(is_same);
            // 64 pixels all over the image: in steps that meet every column and row.
            if pixel as u64 * 64 / pixels != (pixel as u64 + 1) * 64 / pixels || pixels <= 64 {
                data.shown.push(Pixel { column, row, indices, is_same });
            }
        }
        Ok(data)
    }

    fn values(&self, _: &Enumeration, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("pixels", (data.columns * data.rows) as i64);
        values.integer("checked", data.enumerated as i64);
        values.integer("count", data.equal as i64);
        values.boolean("equal", data.same == data.columns * data.rows);
        values
    }

    fn tables(&self, _: &Enumeration, data: &Data) -> Vec<Frame> {
        let rows = || data.shown.iter().flat_map(|pixel| pixel.indices.iter().map(move |index| (pixel, *index)));
        let frame = Frame::new("enumeration")
            .counts("column", rows().map(|(pixel, _)| pixel.column as usize))
            .counts("row", rows().map(|(pixel, _)| pixel.row as usize))
            .counts("index", rows().map(|(_, index)| index as usize));
        vec![frame]
    }

    fn draw(&self, p: &Enumeration, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(p, data))
    }

    fn alt(&self, p: &Enumeration, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The base of the second axis.
fn second_base(p: &Enumeration) -> u64 {
    if p.sampler == Sequence::Halton { 3 } else { 2 }
}

/// The columns and rows of the image.
fn size(p: &Enumeration) -> (u64, u64) {
    (2_u64.pow(p.digits.0 as u32), second_base(p).pow(p.digits.1 as u32))
}

/// The indices of the samples in a pixel, solved for.
fn direct(p: &Enumeration, column: u64, row: u64) -> Option<Vec<u64>> {
    let intervals = [
        Interval { axis: 0, digits: p.digits.0 as u32, cell: column },
        Interval { axis: 1, digits: p.digits.1 as u32, cell: row },
    ];
    match p.sampler {
        Sequence::Halton => {
            let indices = halton(&intervals)?;
            Some((0..p.samples as u64).map(|k| indices.first + k * indices.step).collect())
        }
        Sequence::Sobol => {
            let bits = (p.digits.0 + p.digits.1) as u32 + p.samples.trailing_zeros();
            sobol(&intervals, bits, 0)
        }
    }
}

/// The indices of the samples in every pixel, by a pass over all samples.
fn search(p: &Enumeration, seed: Seed) -> Result<Vec<Vec<u64>>, Failure> {
    let (columns, rows) = size(p);
    let method = Method::parse(p.sampler.word()).map_err(|error| Failure::of("sampler", error.to_string()))?;
    let n = columns * rows * p.samples as u64;
    let points = method.points(n as usize, 2, seed).map_err(|error| Failure::of("sampler", error.to_string()))?;
    let mut found = vec![Vec::new(); (columns * rows) as usize];
    for (index, row) in points.rows().enumerate() {
        let [x, y] = [row[0], row[1]];
        let pixel = slab(y, rows as usize) * columns as usize + slab(x, columns as usize);
        if let Some(list) = found.get_mut(pixel) {
            list.push(index as u64);
        }
    }
    Ok(found)
}

mod drawing {
    //! The table of pixels, and its words.

    use super::{Data, Enumeration, Pixel};
    use crate::chart::number::integer;
    use crate::chart::{Cell, Column, Drawing, Table};

    pub(super) fn draw(p: &Enumeration, data: &Data) -> Drawing {
        let mut table = Table::new(vec![
            Column::right("Column"),
            Column::right("Row"),
            Column::left("Samples, found directly"),
            Column::centre("As by search"),
        ]);
        table.row_heads = 2;
        let rows = p.rows.min(data.shown.len());
        let chosen = (0..rows).filter_map(|k| data.shown.get(k * (data.shown.len() - 1) / (rows - 1).max(1)));
        for pixel in chosen {
            let (column, row) = (Cell::Integer(pixel.column as i64), Cell::Integer(pixel.row as i64));
            table.push([column, row, Cell::Text(indices(pixel)), Cell::holds(pixel.is_same)]);
        }
        let pixels = data.columns * data.rows;
        let text = format!("{} of {}", integer(data.same as i64), integer(pixels as i64));
        let samples = format!("{} samples", integer(data.enumerated as i64));
        let verdict = Cell::Holds { holds: data.same == pixels, text };
        table.push([Cell::text("all"), Cell::Empty, Cell::Text(samples), verdict]);
        table.footers = 1;
        Drawing::Table(table)
    }

    /// The first indices of a pixel.
    fn indices(pixel: &Pixel) -> String {
        let shown: Vec<String> = pixel.indices.iter().take(6).map(|&index| integer(index as i64)).collect();
        let more = if pixel.indices.len() > 6 { ", …" } else { "" };
        format!("{}{more}", shown.join(", "))
    }

    pub(super) fn alt(p: &Enumeration, data: &Data) -> String {
        let pixels = data.columns * data.rows;
        format!(
            "The samples of the {} sequence in {} by {} pixels, {} in each: found directly they are those of a search in {} of {} pixels.",
            p.sampler.word(),
            data.columns,
            data.rows,
            p.samples,
            integer(data.same as i64),
            integer(pixels as i64)
        )
    }
}
