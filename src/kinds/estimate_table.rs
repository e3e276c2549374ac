//! The table of estimates: what the mean of n samples gives for growing n, beside the exact integral.
//!
//! Each row is an experiment of its own, with its own random numbers, so that the rows are independent and every one can be
//! held against the exact value in units of its standard error, sigma / sqrt(n). Samplers other than the independent one have
//! no standard error to predict from one estimate; their rows show the error alone.
//!
//! On a domain [a, b] samples have the density 1 / (b - a), so that each contribution is (b - a) f.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Study, check_dimensions, check_ends, dimensions, reference};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{Counts, choices, parameters};
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::moments::Sum;
use crate::stats::quadrature;

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

choices! {
    /// What is drawn.
    pub enum Show {
        /// A table with a row for each N.
        Table = "table",
        /// The estimates over N with their error bars.
        Figure = "figure",
    }
}

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
        /// The ends a and b of the domain of an integrand of one variable.
        domain: Vec<f64> [in -1e6..=1e6] = [0.0, 1.0],
        /// Whether a table or a figure is drawn.
        @drawn show: Show = "table",
    }
}

impl EstimateTable {
    /// The ends of the domain, unless it is the unit cube.
    fn ends(&self) -> Option<(f64, f64)> {
        match self.domain.as_slice() {
            &[from, to] if from != 0.0 || to != 1.0 => Some((from, to)),
            _ => None,
        }
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
        if p.domain.len() != 2 {
            let message = "a domain has two ends, such as `[0, 2]`";
            problems.at("domain", Code::Combination, message, None);
        } else if let Some((from, to)) = p.ends() {
            check_ends(from, to, "domain", problems);
            if d > 1 {
                let message = format!("`{}` is integrated over the unit cube of {d} dimensions", p.integrand.text());
                problems.at("domain", Code::Combination, message, Some("drop the domain".to_owned()));
            }
        }
    }

    fn weight(&self, p: &EstimateTable) -> u64 {
        p.n.total()
    }

    fn run(&self, p: &EstimateTable, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let (exact, variance) = truth(p, d)?;
        // Only independent samples have the variance sigma^2 / n.
        let sigma = variance.filter(|_| p.sampler.name() == "independent").map(|variance| variance.max(0.0).sqrt());
        let row = |&n: &usize| {
            let stream = study.stream(&p.sampler, n, 0);
            let estimate = match p.ends() {
                None => study.estimate(&p.sampler, n, stream)?,
                Some(ends) => between(&study, &p.sampler, n, stream, ends)?,
            };
            Ok(Row { n: n as u64, estimate, standard_error: sigma.map(|sigma| sigma / (n as f64).sqrt()) })
        };
        // From the largest n down: the longest rows start first.
        let rows: Vec<Result<Row, Failure>> = p.n.as_slice().par_iter().rev().with_max_len(1).map(piece(row)).collect();
        let rows = rows.into_iter().rev().collect::<Result<_, _>>()?;
        Ok(Data { exact: exact.0, exact_error: exact.1, variance, rows })
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

    fn draw(&self, p: &EstimateTable, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &EstimateTable, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

/// A value with a bound on its error.
type Bounded = (f64, f64);

/// The integral and the variance of one contribution.
fn truth(p: &EstimateTable, d: usize) -> Result<(Bounded, Option<f64>), Failure> {
    let Some((from, to)) = p.ends() else {
        let exact = reference(&p.integrand, d)?;
        return Ok(((exact.value, exact.error), p.integrand.variance(d)));
    };
    let contribution = |u: &[f64]| (to - from) * p.integrand.evaluate(&[from + (to - from) * u[0]]);
    let exact = quadrature::integrate(1, contribution).ok_or_else(|| {
        let message =
            format!("the integral of `{}` from {from} to {to} is not known exactly enough", p.integrand.text());
        Failure::of("integrand", message).help("choose a smooth function that is finite on the domain")
    })?;
    let spread = quadrature::integrate(1, |u| {
        let apart = contribution(u) - exact.value;
        apart * apart
    });
    Ok(((exact.value, exact.error), spread.map(|variance| variance.value)))
}

/// One estimate over the domain from end to end: the mean of f / p with p = 1 / (b - a).
fn between(study: &Study<'_>, method: &Method, n: usize, stream: Seed, (a, b): (f64, f64)) -> Result<f64, Failure> {
    let points = study.points(method, n, stream)?;
    let mut sum = Sum::default();
    for u in points.axis(0) {
        let (x, density) = (a + (b - a) * u, 1.0 / (b - a));
        sum.add(study.integrand.evaluate(&[x]) / density);
    }
    let mean = sum.value() / n as f64;
    if mean.is_finite() { Ok(mean) } else { Err(study.undefined(&points)) }
}

mod drawing {
    //! The table or the figure of estimates, and their words.

    use std::fmt::Write as _;

    use super::{Data, EstimateTable, Row, Show};
    use crate::chart::number::{fixed, integer, parts, significant};
    use crate::chart::{
        Axis, Cell, Chart, ChartError, Column, Drawing, ErrorBars, Key, Line, Marks, Panel, Rich, Sheet, Style, Table,
    };

    /// The digits after the point that a number with this error deserves: to the error's second digit.
    fn places(error: f64) -> usize {
        if error.is_finite() && error > 0.0 { (1 - parts(error, 2).1).clamp(0, 12) as usize } else { 6 }
    }

    /// The error that decides over the digits of a row: the standard one, or the true one.
    fn places_of(row: &Row, data: &Data) -> usize {
        places(row.standard_error.filter(|error| *error > 0.0).unwrap_or(row.error(data).abs()))
    }

    pub(super) fn draw(p: &EstimateTable, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match p.show {
            Show::Table => Ok(Drawing::Table(table(data))),
            Show::Figure => Ok(Chart::new(panel(p, data)).key(Key::Above).draw(sheet)?.into()),
        }
    }

    /// The estimates over N, with two standard errors to either side.
    fn panel(p: &EstimateTable, data: &Data) -> Panel {
        let style = Style::of(&p.sampler.name());
        let bar = |row: &Row| {
            let half = 2.0 * row.standard_error?;
            Some((row.n as f64, row.estimate - half, row.estimate + half))
        };
        let bars: Vec<(f64, f64, f64)> = data.rows.iter().filter_map(bar).collect();
        let ends = (data.rows.first().map_or(1, |row| row.n) as f64, data.rows.last().map_or(1, |row| row.n) as f64);
        let exact = Line::new(vec![(ends.0, data.exact), (ends.1, data.exact)]).style(Style::EXACT).label("exact");
        let estimates = data.rows.iter().map(|row| (row.n as f64, row.estimate)).collect();
        let mut panel = Panel::new(Axis::log("*N*"), Axis::linear("estimate *F*_{N}")).ratio(0.5).with(exact);
        if !bars.is_empty() {
            panel = panel.with(ErrorBars::new(bars).style(style).label("±2 standard errors"));
        }
        panel.with(Marks::new(estimates).style(style).size(8.0).label(Rich::plain(&p.sampler.title())))
    }

    fn table(data: &Data) -> Table {
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
        table
    }

    pub(super) fn alt(p: &EstimateTable, data: &Data) -> Option<String> {
        let (first, last) = (data.rows.first()?, data.rows.last()?);
        let exact = significant(data.exact, 8);
        let told = |row: &Row| {
            let estimate = fixed(row.estimate, places_of(row, data));
            let error = fixed(row.error(data), places_of(row, data));
            format!("{estimate} with N = {} (error {error})", integer(row.n as i64))
        };
        let domain = p.ends().map_or_else(String::new, |(from, to)| format!(" from {from} to {to}"));
        let name = p.integrand.text();
        let mut text = format!("Estimates of the integral of {name}{domain}, exactly {exact}: {}", told(first));
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
