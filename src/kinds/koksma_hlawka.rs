//! The inequality of Koksma and Hlawka: an error against its bound, variation times discrepancy.
//!
//! For an integrand of bounded variation V in the sense of Hardy and Krause, |F_N - F| <= V D*. All three numbers are computed:
//! the error against the exact integral, the exact star discrepancy, and the variation known of the integrand.

use serde::{Deserialize, Serialize};

use super::estimation::{check_dimensions, dimensions, reference, undefined};
use super::placing::{Placing, unmeasured};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::{Function, INTEGRANDS};
use crate::metrics::star;
use crate::parameters::{Counts, choices, parameters};
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::moments;

/// The kind `koksma-hlawka`.
pub static KOKSMA_HLAWKA: KoksmaHlawkaKind = KoksmaHlawkaKind;

/// The kind of experiment that holds errors against the bound.
pub struct KoksmaHlawkaKind;

static ABOUT: About = About {
    key: "koksma-hlawka",
    title: "The inequality of Koksma and Hlawka",
    summary: "Errors beside their bound, the integrand's variation times the exact star discrepancy.",
    file: "kinds/koksma_hlawka.rs",
    source: include_str!("koksma_hlawka.rs"),
    papers: &[Paper {
        authors: "E. Hlawka",
        year: 1961,
        title: "Funktionen von beschränkter Variation in der Theorie der Gleichverteilung",
        venue: "Annali di Matematica Pura ed Applicata 54, 325-333",
        doi: Some("10.1007/BF02415361"),
    }],
};

choices! {
    /// How the errors and bounds are shown.
    pub enum Form {
        /// As a table.
        Table = "table",
        /// As lines over N.
        Figure = "figure",
    }
}

parameters! {
    /// What a study of the inequality can choose.
    pub struct KoksmaHlawka {
        /// The samplers, each with an optional scramble.
        samplers: Vec<Method> [or sampler],
        /// The integrand: a catalogued one of known variation.
        integrand: Function,
        /// The counts N.
        n: Counts [in 1..=65_536] = [16, 64, 256, 1024],
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=8],
        /// Whether a table or a figure is made.
        @drawn form: Form = "table",
    }
}

/// The rows, sampler by sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    variation: f64,
    exact: f64,
    rows: Vec<Row>,
}

/// One sampler and count.
#[derive(Debug, Serialize, Deserialize)]
struct Row {
    method: String,
    title: String,
    n: u64,
    error: f64,
    discrepancy: f64,
    /// Whether the discrepancy is exact and not only bounded from below.
    is_exact: bool,
    bound: f64,
}

impl Row {
    fn holds(&self) -> bool {
        self.error <= self.bound
    }
}

impl Kind for KoksmaHlawkaKind {
    type Parameters = KoksmaHlawka;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut KoksmaHlawka) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions));
    }

    fn check(&self, p: &KoksmaHlawka, problems: &mut Problems<'_, '_>) {
        check_dimensions(&p.integrand, p.dimensions, problems);
        let d = dimensions(&p.integrand, p.dimensions);
        problems.admit("samplers", &p.samplers, p.n.as_slice(), d);
        if p.integrand.variation(d).is_none() {
            let known: Vec<String> = INTEGRANDS
                .iter()
                .filter(|integrand| integrand.variation(integrand.dimensions().unwrap_or(d)).is_some())
                .map(|integrand| format!("`{}`", integrand.about().key))
                .collect();
            let message = format!("the variation of `{}` in {d} dimensions is not known", p.integrand.text());
            let help = format!("it is known of {}", known.join(", "));
            problems.at("integrand", Code::Combination, message, Some(help));
        }
    }

    fn weight(&self, p: &KoksmaHlawka) -> u64 {
        p.n.total().saturating_mul(64 * p.samplers.len() as u64)
    }

    fn run(&self, p: &KoksmaHlawka, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let exact = reference(&p.integrand, d)?.value;
        let variation = p.integrand.variation(d).unwrap_or(f64::INFINITY);
        let placing = Placing { kind: ABOUT.key, d, seed };
        let rows = placing.measured(&p.samplers, p.n.as_slice(), 1, |method, points| {
            let heights: Vec<f64> = points.rows().map(|point| p.integrand.evaluate(point)).collect();
            if let Some(at) = heights.iter().position(|height| !height.is_finite()) {
                return Err(undefined(&p.integrand, points.rows().nth(at).unwrap_or_default()));
            }
            let measured = star::star_discrepancy(points).map_err(|error| unmeasured(method, &error))?;
            Ok(Row {
                method: method.name(),
                title: method.title(),
                n: points.len() as u64,
                error: (moments::mean(&heights) - exact).abs(),
                discrepancy: measured.value,
                is_exact: !measured.is_bound,
                bound: variation * measured.value,
            })
        })?;
        Ok(Data { variation, exact, rows: rows.into_iter().flatten().flatten().collect() })
    }

    fn values(&self, _: &KoksmaHlawka, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("variation", data.variation);
        values.number("exact", data.exact);
        for row in &data.rows {
            let name = format!("{}.{}", row.method, row.n);
            values.number(format!("error.{name}"), row.error);
            values.number(format!("dstar.{name}"), row.discrepancy);
            values.number(format!("bound.{name}"), row.bound);
            values.number(format!("share.{name}"), row.error / row.bound);
            values.boolean(format!("holds.{name}"), row.holds());
        }
        values.boolean("holds", data.rows.iter().all(Row::holds));
        values.boolean("discrepancies.exact", data.rows.iter().all(|row| row.is_exact));
        values
    }

    fn tables(&self, _: &KoksmaHlawka, data: &Data) -> Vec<Frame> {
        let rows = || data.rows.iter();
        let frame = Frame::new("koksma-hlawka")
            .text("sampler", rows().map(|row| row.method.clone()))
            .counts("n", rows().map(|row| row.n as usize))
            .numbers("error", rows().map(|row| row.error))
            .numbers("star discrepancy", rows().map(|row| row.discrepancy))
            .numbers("bound", rows().map(|row| row.bound));
        vec![frame]
    }

    fn draw(&self, p: &KoksmaHlawka, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &KoksmaHlawka, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

mod drawing {
    //! The table or the lines, and their words.

    use super::{Data, Form, KoksmaHlawka, Row};
    use crate::chart::number::{integer, significant};
    use crate::chart::{Axis, Cell, Chart, ChartError, Column, Drawing, Line, Panel, Sheet, Style, Table};

    pub(super) fn draw(p: &KoksmaHlawka, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match p.form {
            Form::Table => Ok(Drawing::Table(table(data))),
            Form::Figure => figure(data, sheet),
        }
    }

    fn table(data: &Data) -> Table {
        let mut table = Table::new(vec![
            Column::left("Sampler"),
            Column::right("$N$"),
            Column::right("$|F_N - F|$"),
            Column::right("$D^*$"),
            Column::right("$V D^*$"),
            Column::centre("Holds"),
        ]);
        table.row_heads = 2;
        for row in &data.rows {
            table.push([
                Cell::text(row.title.as_str()),
                Cell::Integer(row.n as i64),
                Cell::significant(row.error, 3),
                Cell::significant(row.discrepancy, 4),
                Cell::significant(row.bound, 4),
                Cell::holds(row.holds()),
            ]);
        }
        table
    }

    /// For each sampler a line of errors, and above it the line of bounds.
    fn figure(data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut panel = Panel::new(Axis::log2("*N*"), Axis::log("error and bound")).ratio(0.62);
        for rows in data.rows.chunk_by(|a, b| a.method == b.method) {
            let Some(Row { method, title, .. }) = rows.first() else { continue };
            let through = |value: fn(&Row) -> f64| {
                let points = rows.iter().map(|row| (row.n as f64, value(row))).filter(|point| point.1 > 0.0);
                Line::new(points.collect()).style(Style::of(method))
            };
            panel = panel.with(through(|row| row.bound).width(1.0).label(format!("{title}: *V D*^{{∗}}")));
            panel = panel.with(through(|row| row.error).marked().label(format!("{title}: error")));
        }
        Ok(Chart::new(panel).draw(sheet)?.into())
    }

    pub(super) fn alt(p: &KoksmaHlawka, data: &Data) -> String {
        let share = |row: &&Row| row.error / row.bound;
        let nearest = data.rows.iter().max_by(|a, b| share(a).total_cmp(&share(b)));
        let held = data.rows.iter().filter(|row| row.holds()).count();
        let mut text = format!(
            "Errors for {} and the bound V times D*, with the variation V = {}: the inequality holds in {held} of {} rows.",
            p.integrand.text(),
            significant(data.variation, 6),
            data.rows.len()
        );
        if let Some(row) = nearest {
            text += format!(
                " The error comes nearest to its bound for {} at N = {}: {} of {}.",
                row.title,
                integer(row.n as i64),
                significant(row.error, 3),
                significant(row.bound, 3)
            )
            .as_str();
        }
        text
    }
}
