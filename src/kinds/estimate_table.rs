//! The table of estimates: what the mean of n samples gives for growing n, beside the exact integral.
//!
//! Each row is an experiment of its own, with its own random numbers, so that the rows are independent and every one can be
//! held against the exact value in units of its standard error, sigma / sqrt(n). Samplers other than the independent one have
//! no standard error to predict from one estimate; their rows show the error alone.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Study, check_dimensions, dimensions, reference};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::integrands::Function;
use crate::parameters::{Counts, parameters};
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `estimate-table`.
pub static ESTIMATE_TABLE: EstimateTableKind = EstimateTableKind;

/// The kind of experiment that tabulates estimates.
pub struct EstimateTableKind;

static ABOUT: About = About {
    key: "estimate-table",
    title: "Table of estimates",
    summary: "Estimates of an integral for growing n, each with its standard error, its true error and its z-score.",
    file: "kinds/estimate_table.rs",
    source: include_str!("estimate_table.rs"),
    papers: &[],
};

parameters! {
    /// What a table of estimates can choose.
    pub struct EstimateTable {
        /// What is integrated over the unit cube.
        integrand: Function,
        /// The counts n, one row each.
        n: Counts [in 1..=16_777_216] = "10^0..10^5",
        /// Where the samples come from.
        sampler: Method = "independent",
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=64],
    }
}

/// The estimates and what they estimate.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    exact_error: f64,
    variance: Option<f64>,
    rows: Vec<Row>,
}

/// One estimate.
#[derive(Debug, Serialize, Deserialize)]
struct Row {
    n: u64,
    estimate: f64,
    standard_error: Option<f64>,
}

impl Row {
    fn error(&self, data: &Data) -> f64 {
        self.estimate - data.exact
    }

    /// The error in units of the standard error, where there is one.
    fn z(&self, data: &Data) -> Option<f64> {
        self.standard_error.filter(|error| *error > 0.0).map(|error| self.error(data) / error)
    }
}

impl Kind for EstimateTableKind {
    type Parameters = EstimateTable;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut EstimateTable) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions));
    }

    fn check(&self, p: &EstimateTable, problems: &mut Problems<'_, '_>) {
        check_dimensions(&p.integrand, p.dimensions, problems);
        let d = dimensions(&p.integrand, p.dimensions);
        problems.admit("sampler", std::slice::from_ref(&p.sampler), p.n.as_slice(), d);
    }

    fn weight(&self, p: &EstimateTable) -> u64 {
        p.n.total()
    }

    fn run(&self, p: &EstimateTable, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let exact = reference(&p.integrand, d)?;
        // Only independent samples have the variance sigma^2 / n.
        let variance = p.integrand.variance(d);
        let sigma = variance.filter(|_| p.sampler.name() == "independent").map(|variance| variance.max(0.0).sqrt());
        let row = |&n: &usize| {
            let estimate = study.estimate(&p.sampler, n, study.stream(&p.sampler, n, 0))?;
            Ok(Row { n: n as u64, estimate, standard_error: sigma.map(|sigma| sigma / (n as f64).sqrt()) })
        };
        // From the largest n down: the longest rows start first.
        let rows: Vec<Result<Row, Failure>> = p.n.as_slice().par_iter().rev().with_max_len(1).map(row).collect();
        let rows = rows.into_iter().rev().collect::<Result<_, _>>()?;
        Ok(Data { exact: exact.value, exact_error: exact.error, variance, rows })
    }

    fn values(&self, _: &EstimateTable, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        if let Some(variance) = data.variance {
            values.number("variance", variance);
            values.number("sigma", variance.max(0.0).sqrt());
        }
        let mut largest: Option<f64> = None;
        for row in &data.rows {
            let n = row.n;
            values.estimate(format!("estimate.{n}"), row.estimate, row.standard_error.unwrap_or(f64::NAN));
            values.number(format!("error.{n}"), row.error(data));
            if let Some(z) = row.z(data) {
                values.number(format!("z.{n}"), z);
                largest = Some(largest.map_or(z.abs(), |largest| largest.max(z.abs())));
            }
        }
        if let Some(largest) = largest {
            values.number("largest.z", largest);
        }
        values
    }

    fn tables(&self, _: &EstimateTable, data: &Data) -> Vec<Frame> {
        let rows = || data.rows.iter();
        let frame = Frame::new("estimates")
            .counts("n", rows().map(|row| row.n as usize))
            .numbers("estimate", rows().map(|row| row.estimate))
            .numbers("standard error", rows().map(|row| row.standard_error.unwrap_or(f64::NAN)))
            .numbers("error", rows().map(|row| row.error(data)))
            .numbers("z", rows().map(|row| row.z(data).unwrap_or(f64::NAN)));
        vec![frame]
    }

    fn draw(&self, _: &EstimateTable, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(data))
    }

    fn alt(&self, p: &EstimateTable, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

mod drawing {
    //! The table of estimates, and its words.

    use std::fmt::Write as _;

    use super::{Data, EstimateTable, Row};
    use crate::chart::number::{fixed, integer, parts, significant};
    use crate::chart::{Cell, Column, Drawing, Table};

    /// The digits after the point that a number with this error deserves: to the error's second digit.
    fn places(error: f64) -> usize {
        if error.is_finite() && error > 0.0 { (1 - parts(error, 2).1).clamp(0, 12) as usize } else { 6 }
    }

    /// The error that decides over the digits of a row: the standard one, or the true one.
    fn places_of(row: &Row, data: &Data) -> usize {
        places(row.standard_error.filter(|error| *error > 0.0).unwrap_or(row.error(data).abs()))
    }

    pub(super) fn draw(data: &Data) -> Drawing {
        let with_errors = data.rows.iter().any(|row| row.z(data).is_some());
        let mut columns = vec![Column::right("$N$"), Column::left("Estimate $F_N$")];
        if with_errors {
            columns.push(Column::left("Standard error"));
        }
        columns.push(Column::right("Error"));
        if with_errors {
            columns.push(Column::right("$z$"));
        }
        let mut table = Table::new(columns);
        for row in &data.rows {
            let places = places_of(row, data);
            let mut cells = vec![Cell::Integer(row.n as i64), Cell::fixed(row.estimate, places)];
            if with_errors {
                cells.push(row.standard_error.map_or(Cell::Empty, |error| Cell::fixed(error, places)));
            }
            cells.push(Cell::fixed(row.error(data), places));
            if with_errors {
                cells.push(row.z(data).map_or(Cell::Empty, |z| Cell::fixed(z, 2)));
            }
            table.push(cells);
        }
        // The exact value deserves as many digits as the best row, and two more.
        let most = data.rows.iter().map(|row| places_of(row, data)).max().unwrap_or(6);
        let known = if data.exact_error > 0.0 { places(data.exact_error) } else { 15 };
        table.push([Cell::text("exact"), Cell::fixed(data.exact, (most + 2).min(known).min(15))]);
        table.footers = 1;
        Drawing::Table(table)
    }

    pub(super) fn alt(p: &EstimateTable, data: &Data) -> Option<String> {
        let (first, last) = (data.rows.first()?, data.rows.last()?);
        let exact = significant(data.exact, 8);
        let told = |row: &Row| {
            let estimate = fixed(row.estimate, places_of(row, data));
            let error = fixed(row.error(data), places_of(row, data));
            format!("{estimate} with N = {} (error {error})", integer(row.n as i64))
        };
        let mut text = format!("Estimates of the integral of {}, exactly {exact}: {}", p.integrand.text(), told(first));
        if data.rows.len() > 1 {
            let _ = write!(text, ", and in {} rows down to {}", data.rows.len(), told(last));
        }
        let largest = data.rows.iter().filter_map(|row| row.z(data)).map(f64::abs).max_by(f64::total_cmp);
        if let Some(largest) = largest {
            let _ = write!(text, "; no error is larger than {} standard errors", fixed(largest, 2));
        }
        text.push('.');
        Some(text)
    }
}
