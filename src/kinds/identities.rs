//! The identities of expectation and variance, each measured and predicted.
//!
//! Y1 and Y2 are functions of a uniform variable. Where they are independent each has its own variable; where they are dependent
//! both have the same. Every row has its own random numbers, so that no row's chance is another's. The predictions are by
//! quadrature. The standard error of a variance is sqrt((m4 - m2^2) / n), with the central moments m2 and m4.

use serde::{Deserialize, Serialize};

use super::estimation::undefined;
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::parameters;
use crate::seed::Seed;
use crate::stats::moments::{mean, sum};
use crate::stats::quadrature;

/// The kind `identities`.
pub static IDENTITIES: IdentitiesKind = IdentitiesKind;

/// The kind of experiment that tabulates identities.
pub struct IdentitiesKind;

static ABOUT: About = About {
    key: "identities",
    title: "Identities of expectation and variance",
    summary: "E[aY], E[Y1 + Y2], V[aY], V[Y] and V[Y1 + Y2], each measured beside its prediction, with z-scores.",
    file: "kinds/identities.rs",
    source: include_str!("identities.rs"),
    papers: &[],
};

parameters! {
    /// What a table of identities can choose.
    pub struct Identities {
        /// Y1, as an expression of a uniform variable x.
        y1: Function = "exp-sin",
        /// Y2, as an expression of a uniform variable x.
        y2: Function = "x^2",
        /// The factor a.
        a: f64 [in -1e6..=1e6] = 3.0,
        /// How many samples each row is measured with.
        n: usize [in 10..=10_000_000] = 100_000,
    }
}

/// The rows.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    rows: Vec<Row>,
    /// `V[Y1] + V[Y2]`, which ignores that dependent variables vary together.
    ignorant: f64,
}

/// One identity.
#[derive(Debug, Serialize, Deserialize)]
struct Row {
    name: String,
    measured: f64,
    error: f64,
    predicted: f64,
}

impl Row {
    fn z(&self) -> f64 {
        (self.measured - self.predicted) / self.error
    }
}

/// What is known of Y1 and Y2 by quadrature.
struct Known {
    means: (f64, f64),
    variances: (f64, f64),
    covariance: f64,
}

impl Kind for IdentitiesKind {
    type Parameters = Identities;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Identities, problems: &mut Problems<'_, '_>) {
        for (name, function) in [("y1", &p.y1), ("y2", &p.y2)] {
            if let Some(d) = function.dimensions().filter(|d| *d > 1) {
                let message = format!("`{}` has {d} variables; a random variable here is of one, x", function.text());
                problems.at(name, Code::Combination, message, None);
            }
        }
    }

    fn weight(&self, p: &Identities) -> u64 {
        9 * p.n as u64
    }

    fn run(&self, p: &Identities, seed: Seed) -> Result<Data, Failure> {
        let known = known(p)?;
        let (y1, y2) = (|u: f64| p.y1.evaluate(&[u]), |u: f64| p.y2.evaluate(&[u]));
        let draw = |name: &str, of: &dyn Fn(f64, f64) -> f64| -> Vec<f64> {
            let mut random = seed.named(ABOUT.key).named(name).generator();
            (0..p.n).map(|_| of(random.uniform(), random.uniform())).collect()
        };
        let mut rows = Vec::new();
        let mut row = |name: &str, (measured, error): (f64, f64), predicted: f64| {
            rows.push(Row { name: name.to_owned(), measured, error, predicted });
        };
        let (means, variances) = (known.means, known.variances);
        let total = variances.0 + variances.1;
        row("scaled-mean", expectation(&draw("scaled-mean", &|u, _| p.a * y1(u))), p.a * means.0);
        row("mean-of-sum", expectation(&draw("mean-of-sum", &|u, _| y1(u) + y2(u))), means.0 + means.1);
        row("scaled-variance", spread(&draw("scaled-variance", &|u, _| p.a * y1(u))), p.a * p.a * variances.0);
        row("variance", spread(&draw("variance", &|u, _| y1(u))), variances.0);
        row("independent-sum", spread(&draw("independent-sum", &|u, v| y1(u) + y2(v))), total);
        let dependent = total + 2.0 * known.covariance;
        row("dependent-sum", spread(&draw("dependent-sum", &|u, _| y1(u) + y2(u))), dependent);
        if let Some(row) = rows.iter().find(|row| !row.measured.is_finite()) {
            let function = if row.name == "variance" || row.name.starts_with("scaled") { &p.y1 } else { &p.y2 };
            return Err(undefined(function, &[]));
        }
        Ok(Data { rows, ignorant: total })
    }

    fn values(&self, _: &Identities, data: &Data) -> Values {
        let mut values = Values::new();
        for row in &data.rows {
            let name = &row.name;
            values.estimate(name.clone(), row.measured, row.error);
            values.number(format!("predicted.{name}"), row.predicted);
            values.number(format!("z.{name}"), row.z());
        }
        values.number("largest.z", data.rows.iter().map(|row| row.z().abs()).fold(0.0, f64::max));
        if let Some(row) = data.rows.last() {
            values.number("z.ignored-dependence", (row.measured - data.ignorant) / row.error);
        }
        values
    }

    fn tables(&self, _: &Identities, data: &Data) -> Vec<Frame> {
        let rows = || data.rows.iter();
        let frame = Frame::new("identities")
            .text("identity", rows().map(|row| row.name.clone()))
            .numbers("measured", rows().map(|row| row.measured))
            .numbers("standard error", rows().map(|row| row.error))
            .numbers("predicted", rows().map(|row| row.predicted))
            .numbers("z", rows().map(Row::z));
        vec![frame]
    }

    fn draw(&self, _: &Identities, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(data))
    }

    fn alt(&self, p: &Identities, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The mean with its standard error.
fn expectation(values: &[f64]) -> (f64, f64) {
    (mean(values), spread(values).0.sqrt() / (values.len() as f64).sqrt())
}

/// The variance with its standard error.
fn spread(values: &[f64]) -> (f64, f64) {
    let (n, centre) = (values.len() as f64, mean(values));
    let moment = |power: i32| {
        sum(values.iter().map(|value| {
            let square = (value - centre) * (value - centre);
            if power == 4 { square * square } else { square }
        })) / n
    };
    let (second, fourth) = (moment(2), moment(4));
    (second * n / (n - 1.0), ((fourth - second * second).max(0.0) / n).sqrt())
}

/// Means, variances and covariance by quadrature, each centred first.
fn known(p: &Identities) -> Result<Known, Failure> {
    let unknown = |name: &'static str, function: &Function| {
        let message = format!("the mean and the variance of `{}` are not known exactly enough", function.text());
        Failure::of(name, message).help("choose a smooth function")
    };
    let of = |name: &'static str, function: &Function| {
        let pair = function.integral(1).map(|mean| mean.value).zip(function.variance(1));
        pair.filter(|pair| pair.0.is_finite() && pair.1 > 0.0).ok_or_else(|| unknown(name, function))
    };
    let (first, second) = (of("y1", &p.y1)?, of("y2", &p.y2)?);
    let product = |u: &[f64]| (p.y1.evaluate(u) - first.0) * (p.y2.evaluate(u) - second.0);
    let covariance = quadrature::integrate(1, product).ok_or_else(|| unknown("y2", &p.y2))?.value;
    Ok(Known { means: (first.0, second.0), variances: (first.1, second.1), covariance })
}

mod drawing {
    //! The table of identities, and its words.

    use super::{Data, Identities, Row};
    use crate::chart::number::{fixed, integer, parts};
    use crate::chart::{Cell, Column, Drawing, Table};

    /// An identity, and what it needs.
    fn formula(name: &str) -> &'static str {
        match name {
            "scaled-mean" => "\\mathrm{E}[aY_1]=a\\,\\mathrm{E}[Y_1]",
            "mean-of-sum" => "\\mathrm{E}[Y_1+Y_2]=\\mathrm{E}[Y_1]+\\mathrm{E}[Y_2]",
            "scaled-variance" => "\\mathrm{V}[aY_1]=a^2\\,\\mathrm{V}[Y_1]",
            "variance" => "\\mathrm{V}[Y_1]=\\mathrm{E}[Y_1^2]-\\mathrm{E}[Y_1]^2",
            "independent-sum" => "\\mathrm{V}[Y_1+Y_2]=\\mathrm{V}[Y_1]+\\mathrm{V}[Y_2]\\text{ if independent}",
            _ => "\\mathrm{V}[Y_1+Y_2]=\\mathrm{V}[Y_1]+\\mathrm{V}[Y_2]+2\\,\\mathrm{Cov}[Y_1,Y_2]",
        }
    }

    /// The digits after the point to the error's second digit.
    fn places(error: f64) -> usize {
        if error > 0.0 { (1 - parts(error, 2).1).clamp(0, 12) as usize } else { 6 }
    }

    pub(super) fn draw(data: &Data) -> Drawing {
        let mut table = Table::new(vec![
            Column::left("Identity"),
            Column::left("Measured"),
            Column::left("Predicted"),
            Column::right("$z$"),
        ]);
        for row in &data.rows {
            table.push([
                Cell::Math(formula(&row.name).to_owned()),
                Cell::estimate(row.measured, row.error),
                Cell::fixed(row.predicted, places(row.error)),
                Cell::fixed(row.z(), 2),
            ]);
        }
        if let Some(row) = data.rows.last() {
            table.push([
                Cell::Math("\\mathrm{V}[Y_1]+\\mathrm{V}[Y_2]\\text{ if dependent (wrong)}".to_owned()),
                Cell::estimate(row.measured, row.error),
                Cell::fixed(data.ignorant, places(row.error)),
                Cell::fixed((row.measured - data.ignorant) / row.error, 1),
            ]);
            table.footers = 1;
        }
        Drawing::Table(table)
    }

    pub(super) fn alt(p: &Identities, data: &Data) -> String {
        let largest = data.rows.iter().map(|row| row.z().abs()).fold(0.0, f64::max);
        let off = data.rows.last().map_or(0.0, |row: &Row| (row.measured - data.ignorant) / row.error);
        format!(
            "A table of {} identities of expectation and variance for Y1 = {}, Y2 = {} and a = {}, each measured with {} samples beside its prediction: the largest z-score is {}. Without the covariance the prediction for the dependent sum is off by {} standard errors.",
            data.rows.len(),
            p.y1.text(),
            p.y2.text(),
            p.a,
            integer(p.n as i64),
            fixed(largest, 2),
            fixed(off, 1),
        )
    }
}
