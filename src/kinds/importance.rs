//! Importance sampling: one integral, estimated with samples from several densities.
//!
//! The estimator is the mean of f(X) / p(X), X from p by inversion. Its variance for one sample is the integral of f^2 / p less the
//! square of the integral of f: small where p follows f, large or infinite where p is small and f is not.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Density, check_density, check_ends};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{choices, parameters};
use crate::seed::Seed;
use crate::stats::moments::{mean, sum};
use crate::stats::quadrature;

/// The kind `importance`.
pub static IMPORTANCE: ImportanceKind = ImportanceKind;

/// The kind of experiment that compares sampling densities.
pub struct ImportanceKind;

static ABOUT: About = About {
    key: "importance",
    title: "Importance sampling",
    summary: "An integral estimated with samples of several densities: each beside the integrand, with its variance, measured and exact.",
    file: "kinds/importance.rs",
    source: include_str!("importance.rs"),
    papers: &[Paper {
        authors: "H. Kahn and A. W. Marshall",
        year: 1953,
        title: "Methods of Reducing Sample Size in Monte Carlo Computations",
        venue: "Journal of the Operations Research Society of America 1(5), 263-278",
        doi: Some("10.1287/opre.1.5.263"),
    }],
};

/// Into how many steps the curves are cut.
const STEPS: usize = 300;

choices! {
    /// What is drawn.
    pub enum Show {
        /// A panel for each density, with the integrand.
        Densities = "densities",
        /// The estimates and the variances.
        Table = "table",
    }
}

parameters! {
    /// What a comparison of densities can choose.
    pub struct Importance {
        /// What is integrated, of one variable.
        integrand: Function,
        /// The densities, as expressions in x up to their factors.
        densities: Vec<Function> [or density],
        /// Their names, in the order of the densities; otherwise they are density-1, density-2, ...
        names: Option<Vec<String>>,
        /// The lower end of the integral.
        from: f64 [in -1e6..=1e6] = 0.0,
        /// The upper end.
        to: f64 [in -1e6..=1e6] = 1.0,
        /// How many samples each estimate is the mean of.
        n: usize [in 10..=10_000_000] = 10_000,
        /// What is drawn.
        @drawn show: Show = "densities",
    }
}

/// The estimates.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    heights: Vec<f64>,
    rows: Vec<Row>,
}

/// One density and its estimate.
#[derive(Debug, Serialize, Deserialize)]
struct Row {
    name: String,
    text: String,
    /// The density, made to have mass 1, along the curve.
    density: Vec<f64>,
    estimate: f64,
    /// The variance of one sample, with its standard error.
    variance: (f64, f64),
    exact_variance: Option<f64>,
    n: u64,
}

impl Row {
    fn error(&self) -> f64 {
        (self.variance.0 / self.n as f64).sqrt()
    }

    /// The error that the exact variance predicts, or that of the samples.
    fn standard_error(&self) -> f64 {
        self.exact_variance.map_or_else(|| self.error(), |variance| (variance.max(0.0) / self.n as f64).sqrt())
    }

    fn z(&self, exact: f64) -> f64 {
        (self.estimate - exact) / self.standard_error()
    }
}

impl Kind for ImportanceKind {
    type Parameters = Importance;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Importance) {
        let count = p.densities.len();
        p.names.get_or_insert_with(|| (1..=count).map(|index| format!("density-{index}")).collect());
    }

    fn check(&self, p: &Importance, problems: &mut Problems<'_, '_>) {
        check_ends(p.from, p.to, "to", problems);
        check_density(&p.integrand, "integrand", None, problems);
        for (index, density) in p.densities.iter().enumerate() {
            check_density(density, "densities", Some(index), problems);
        }
        let names = p.names.as_deref().unwrap_or_default();
        if names.len() != p.densities.len() {
            let message = format!("{} names do not fit {} densities", names.len(), p.densities.len());
            problems.at("names", Code::Combination, message, Some("write one name for each density".to_owned()));
        }
        if let Some(name) = names.iter().find(|name| name.is_empty() || name.contains(|c: char| !plain(c))) {
            let message = format!("`{name}` cannot be part of a value's name");
            let help = "use lower-case letters, digits and hyphens".to_owned();
            problems.at("names", Code::Combination, message, Some(help));
        }
        if p.densities.len() > 8 {
            problems.at("densities", Code::OutOfRange, "more than 8 densities do not fit a figure", None);
        }
    }

    fn weight(&self, p: &Importance) -> u64 {
        20 * (p.n as u64) * p.densities.len() as u64
    }

    fn run(&self, p: &Importance, seed: Seed) -> Result<Data, Failure> {
        let f = |x: f64| p.integrand.evaluate(&[x]);
        let unknown = || {
            Failure::of("integrand", format!("the integral of `{}` is not known exactly enough", p.integrand.text()))
                .help("choose a smooth function that is finite between the ends")
        };
        let exact = integral(p, f).ok_or_else(unknown)?;
        let names = p.names.as_deref().unwrap_or_default();
        let pairs: Vec<(&Function, &String)> = p.densities.iter().zip(names).collect();
        let rows: Vec<Result<Row, Failure>> =
            pairs.par_iter().map(|(density, name)| row(p, density, name, exact, seed)).collect();
        let rows = rows.into_iter().collect::<Result<Vec<_>, _>>()?;
        Ok(Data { exact, heights: (0..=STEPS).map(|step| f(at(p, step))).collect(), rows })
    }

    fn values(&self, _: &Importance, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        let of = |row: &Row| row.exact_variance.unwrap_or(row.variance.0);
        let first = data.rows.first().map_or(f64::NAN, of);
        for row in &data.rows {
            let name = &row.name;
            values.estimate(format!("estimate.{name}"), row.estimate, row.standard_error());
            values.number(format!("z.{name}"), row.z(data.exact));
            values.estimate(format!("variance.{name}"), row.variance.0, row.variance.1);
            if let Some(exact) = row.exact_variance {
                values.number(format!("variance.exact.{name}"), exact);
            }
            values.number(format!("ratio.{name}"), of(row) / first);
        }
        values
    }

    fn tables(&self, p: &Importance, data: &Data) -> Vec<Frame> {
        let rows = || data.rows.iter();
        let estimates = Frame::new("estimates")
            .text("density", rows().map(|row| row.name.clone()))
            .numbers("estimate", rows().map(|row| row.estimate))
            .numbers("standard error", rows().map(Row::standard_error))
            .numbers("variance", rows().map(|row| row.variance.0))
            .numbers("variance standard error", rows().map(|row| row.variance.1))
            .numbers("exact variance", rows().map(|row| row.exact_variance.unwrap_or(f64::NAN)));
        let mut curves = Frame::new("curves")
            .numbers("x", (0..=STEPS).map(|step| at(p, step)))
            .numbers("f", data.heights.iter().copied());
        for row in &data.rows {
            curves = curves.numbers(row.name.clone(), row.density.iter().copied());
        }
        vec![estimates, curves]
    }

    fn draw(&self, p: &Importance, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Importance, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// Whether a letter may stand in a value's name.
fn plain(c: char) -> bool {
    c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'
}

fn at(p: &Importance, step: usize) -> f64 {
    p.from + (p.to - p.from) * (step as f64 / STEPS as f64)
}

/// The integral of `f` from end to end.
fn integral(p: &Importance, f: impl Fn(f64) -> f64) -> Option<f64> {
    let width = p.to - p.from;
    quadrature::integrate(1, |u| f(p.from + width * u[0])).map(|integral| integral.value * width)
}

/// The estimate with samples of `density`.
fn row(p: &Importance, density: &Function, name: &str, exact: f64, seed: Seed) -> Result<Row, Failure> {
    let law = Density::new(density, p.from, p.to, "densities")?;
    let mut random = seed.named(ABOUT.key).named(density.text()).at(p.n as u64).generator();
    let weights = (0..p.n).map(|_| {
        let x = law.inverse(random.uniform());
        p.integrand.evaluate(&[x]) / law.height(x)
    });
    let weights: Vec<f64> = weights.collect();
    let estimate = mean(&weights);
    if !estimate.is_finite() {
        let message = format!("f(x) / p(x) is not finite at a sample of `{}`", density.text());
        return Err(Failure::of("densities", message).help("choose a density that is positive wherever f is not 0"));
    }
    let n = p.n as f64;
    let square = |weight: &f64| (weight - estimate) * (weight - estimate);
    let second = sum(weights.iter().map(square)) / n;
    let fourth = sum(weights.iter().map(|weight| square(weight) * square(weight))) / n;
    // Centred first: the variance is the integral of p (f / p - exact)^2.
    let exact_variance = integral(p, |x| {
        let (f, height) = (p.integrand.evaluate(&[x]), law.height(x));
        let apart = f - exact * height;
        // Where p follows f perfectly, what is left is rounding.
        if apart.abs() <= 16.0 * f64::EPSILON * f.abs() { 0.0 } else { apart * apart / height }
    });
    Ok(Row {
        name: name.to_owned(),
        text: density.text().to_owned(),
        density: (0..=STEPS).map(|step| law.height(at(p, step))).collect(),
        estimate,
        variance: (second * n / (n - 1.0), ((fourth - second * second).max(0.0) / n).sqrt()),
        exact_variance,
        n: p.n as u64,
    })
}

mod drawing {
    //! The panels of densities or the table of their variances, and the words.

    use std::fmt::Write as _;

    use super::{Data, Importance, Row, Show, at};
    use crate::chart::number::{integer, significant};
    use crate::chart::{
        Area, Axis, Cell, Chart, ChartError, Column, Dash, Drawing, Key, Line, Panel, Role, Sheet, Style, Table,
    };

    pub(super) fn draw(p: &Importance, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        if p.show == Show::Table {
            return Ok(Drawing::Table(table(data)));
        }
        let panels: Vec<Panel> = data.rows.iter().map(|row| panel(p, data, row)).collect();
        let columns = panels.len().clamp(1, 2);
        Ok(Chart::grid(panels).columns(columns).key(Key::Above).draw(sheet)?.into())
    }

    /// A density over the integrand, which is drawn as if it were a density, so that their shapes compare.
    fn panel(p: &Importance, data: &Data, row: &Row) -> Panel {
        let curve = |heights: &[f64], factor: f64| -> Vec<(f64, f64)> {
            heights.iter().enumerate().map(|(step, height)| (at(p, step), height * factor)).collect()
        };
        let scale = if data.exact == 0.0 { 1.0 } else { 1.0 / data.exact };
        let variance = row.exact_variance.unwrap_or(row.variance.0);
        let top =
            row.density.iter().copied().chain(data.heights.iter().map(|height| height * scale)).fold(0.0, f64::max);
        Panel::new(Axis::linear("*x*"), Axis::linear("density").include(0.0).include(1.06 * top))
            .title(format!("{}: variance {}", row.name, significant(variance, 3)))
            .ratio(0.66)
            .with(Area::new(curve(&data.heights, scale)).label("*f* / ∫*f*"))
            .with(Line::new(curve(&row.density, 1.0)).style(Style::new(Role::Accent).dash(Dash::Solid)).label("*p*"))
    }

    fn table(data: &Data) -> Table {
        let mut table = Table::new(vec![
            Column::left("Density $p$"),
            Column::left("Estimate"),
            Column::left("Variance of one sample"),
            Column::left("Exact variance"),
            Column::right("$z$"),
        ]);
        for row in &data.rows {
            table.push([
                Cell::text(&row.name),
                Cell::estimate(row.estimate, row.standard_error()),
                Cell::estimate(row.variance.0, row.variance.1),
                row.exact_variance.map_or(Cell::text("not known"), |variance| Cell::significant(variance, 5)),
                Cell::fixed(row.z(data.exact), 2),
            ]);
        }
        table.push([Cell::text("exact"), Cell::significant(data.exact, 8)]);
        table.footers = 1;
        table
    }

    pub(super) fn alt(p: &Importance, data: &Data) -> String {
        let mut text = format!(
            "The integral of {} from {} to {}, exactly {}, estimated with {} samples from each of {} densities.",
            p.integrand.text(),
            p.from,
            p.to,
            significant(data.exact, 6),
            integer(p.n as i64),
            data.rows.len(),
        );
        for row in &data.rows {
            let _ = write!(
                text,
                " {}, p proportional to {}: estimate {}, variance of one sample {}",
                row.name,
                row.text,
                significant(row.estimate, 5),
                significant(row.variance.0, 3),
            );
            if let Some(exact) = row.exact_variance {
                let _ = write!(text, " (exactly {})", significant(exact, 3));
            }
            text.push('.');
        }
        text
    }
}
