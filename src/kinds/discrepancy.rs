//! Discrepancy: a measure of evenness over the number of points, on logarithmic axes, beside what theory says.
//!
//! A random method is measured over R independent sets, and its mean is shown with the range from the least to the greatest. The
//! slope is fitted by least squares to log2 of the mean over log2 of N; at reachable N it lies below the asymptote, whose
//! logarithms are still felt.
//!
//! Bounds are proven for every N: for radical inverses in base 2 on the line N D* <= log2(N) / 3 + 1, and for the sequences of
//! Halton and the sets of Hammersley the bounds of Niederreiter's Theorems 3.6 and 3.8, with products over the primes. For
//! independent points the expected square of the L2 star discrepancy is known exactly: (2^-d - 3^-d) / N.

use serde::{Deserialize, Serialize};

use super::estimation::mean_with_error;
use super::measuring::Measure;
use super::placing::{Placing, unmeasured};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::metrics::measure;
use crate::parameters::{Counts, choices, parameters};
use crate::samplers::Method;
use crate::samplers::halton::PRIMES;
use crate::seed::Seed;
use crate::stats::{portable, regression};

/// The kind `discrepancy`.
pub static DISCREPANCY: DiscrepancyKind = DiscrepancyKind;

/// The kind of experiment that measures evenness over N.
pub struct DiscrepancyKind;

static ABOUT: About = About {
    key: "discrepancy",
    title: "Discrepancy",
    summary: "A measure of evenness over N for several samplers, with fitted slopes and proven bounds.",
    file: "kinds/discrepancy.rs",
    source: include_str!("discrepancy.rs"),
    papers: &[Paper {
        authors: "H. Niederreiter",
        year: 1992,
        title: "Random Number Generation and Quasi-Monte Carlo Methods",
        venue: "SIAM, CBMS-NSF Regional Conference Series in Applied Mathematics 63",
        doi: Some("10.1137/1.9781611970081"),
    }],
};

choices! {
    /// How the values are shown.
    pub enum Form {
        /// As lines over N.
        Figure = "figure",
        /// As a table: a row for each sampler, a column for each N.
        Table = "table",
    }
}

parameters! {
    /// What a study of discrepancy can choose.
    pub struct Discrepancy {
        /// The samplers to compare, each with an optional scramble.
        samplers: Vec<Method> [or sampler],
        /// The counts N.
        n: Counts [in 1..=1_048_576] = "2^2..2^10",
        /// What is measured.
        measure: Measure = "star-discrepancy",
        /// The dimensions of the unit cube.
        dimensions: usize [in 1..=16] = 2,
        /// Over how many independent sets each random method is measured.
        replicates: usize [in 1..=100_000] = 16,
        /// Whether a figure or a table is made.
        @drawn form: Form = "figure",
        /// The slopes of the reference lines beside the data; through the largest first value.
        @drawn slopes: Vec<f64> [in -10.0..=0.0] = [-0.5, -1],
        /// Whether the proven bounds and the exact expectations are drawn.
        @drawn bounds: bool = true,
    }
}

/// The measured values of every sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    curves: Vec<Curve>,
}

/// The values of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Curve {
    method: String,
    title: String,
    marks: Vec<Mark>,
    /// Slope and its standard error of log2 of the value over log2 of N.
    fit: Option<(f64, Option<f64>)>,
}

/// The value at one count.
#[derive(Debug, Serialize, Deserialize)]
struct Mark {
    n: u64,
    mean: f64,
    error: Option<f64>,
    least: f64,
    most: f64,
    /// Whether any of the values is only a lower bound of the measure.
    is_bound: bool,
    /// What no value of this method can exceed.
    bound: Option<f64>,
    /// The exact root of the expected square, or the exact value.
    expected: Option<f64>,
}

impl Kind for DiscrepancyKind {
    type Parameters = Discrepancy;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Discrepancy, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, p.n.as_slice(), p.dimensions);
    }

    fn weight(&self, p: &Discrepancy) -> u64 {
        p.n.total().saturating_mul(p.replicates as u64).saturating_mul(64 * p.samplers.len() as u64)
    }

    fn run(&self, p: &Discrepancy, seed: Seed) -> Result<Data, Failure> {
        let placing = Placing { kind: ABOUT.key, d: p.dimensions, seed };
        let metric = p.measure.metric();
        let all = placing.measured(&p.samplers, p.n.as_slice(), p.replicates, |method, points| {
            measure(metric, points).map_err(|error| unmeasured(method, &error))
        })?;
        let curve = |(method, counts): (&Method, Vec<Vec<crate::metrics::Measured>>)| {
            let marks = p.n.iter().zip(counts).map(|(n, sets)| {
                let values: Vec<f64> = sets.iter().map(|set| set.value).collect();
                mark(p, method, n, &values, sets.iter().any(|set| set.is_bound))
            });
            let marks: Vec<Mark> = marks.collect();
            Curve { method: method.name(), title: method.title(), fit: fit(&marks), marks }
        };
        Ok(Data { curves: p.samplers.iter().zip(all).map(curve).collect() })
    }

    fn values(&self, p: &Discrepancy, data: &Data) -> Values {
        let (mut values, quantity) = (Values::new(), p.measure.quantity());
        for curve in &data.curves {
            let name = &curve.method;
            for mark in &curve.marks {
                let n = mark.n;
                values.estimate(format!("{quantity}.{name}.{n}"), mark.mean, mark.error.unwrap_or(f64::NAN));
                if let Some(bound) = mark.bound {
                    values.number(format!("bound.{name}.{n}"), bound);
                }
                if let Some(expected) = mark.expected {
                    values.number(format!("expected.{name}.{n}"), expected);
                }
                if mark.is_bound {
                    values.boolean(format!("lower-bound-only.{name}.{n}"), true);
                }
            }
            if let Some((slope, error)) = curve.fit {
                values.estimate(format!("slope.{name}"), slope, error.unwrap_or(f64::NAN));
            }
            if curve.marks.iter().any(|mark| mark.bound.is_some()) {
                values.boolean(format!("bound.holds.{name}"), curve.marks.iter().all(Mark::is_bounded));
            }
        }
        if let Some((best, worst)) = extremes(data).filter(|_| p.measure.is_discrepancy()) {
            values.text("best", best.0);
            values.number("gain", worst.1 / best.1);
        }
        values
    }

    fn tables(&self, p: &Discrepancy, data: &Data) -> Vec<Frame> {
        let rows = || data.curves.iter().flat_map(|curve| curve.marks.iter().map(move |mark| (curve, mark)));
        let frame = Frame::new("discrepancy")
            .text("sampler", rows().map(|(curve, _)| curve.method.clone()))
            .counts("n", rows().map(|(_, mark)| mark.n as usize))
            .numbers(p.measure.key(), rows().map(|(_, mark)| mark.mean))
            .numbers("standard error", rows().map(|(_, mark)| mark.error.unwrap_or(f64::NAN)))
            .numbers("least", rows().map(|(_, mark)| mark.least))
            .numbers("greatest", rows().map(|(_, mark)| mark.most))
            .numbers("bound", rows().map(|(_, mark)| mark.bound.unwrap_or(f64::NAN)))
            .numbers("expected", rows().map(|(_, mark)| mark.expected.unwrap_or(f64::NAN)));
        vec![frame]
    }

    fn draw(&self, p: &Discrepancy, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Discrepancy, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

impl Mark {
    /// Whether no value exceeds the bound, up to rounding.
    fn is_bounded(&self) -> bool {
        self.bound.is_none_or(|bound| self.most <= bound * (1.0 + 1e-12))
    }
}

/// The values of one count.
fn mark(p: &Discrepancy, method: &Method, n: usize, values: &[f64], is_bound: bool) -> Mark {
    let (mean, error) = mean_with_error(values);
    Mark {
        n: n as u64,
        mean,
        error,
        least: values.iter().copied().fold(f64::INFINITY, f64::min),
        most: values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        is_bound,
        bound: bound(p, method, n),
        expected: expected(p, method, n),
    }
}

/// What the star discrepancy of a method is proven not to exceed.
fn bound(p: &Discrepancy, method: &Method, n: usize) -> Option<f64> {
    if p.measure.key() != "star-discrepancy" {
        return None;
    }
    let (d, count) = (p.dimensions, n as f64);
    // The factor of one prime in the bounds of Halton and Hammersley.
    let factor = |&prime: &u32| {
        let b = f64::from(prime);
        (b - 1.0) / (2.0 * portable::ln(b)) * portable::ln(count) + f64::midpoint(b, 1.0)
    };
    let over = |axes: usize| d as f64 / count + PRIMES.iter().take(axes).map(factor).product::<f64>() / count;
    match (method.name().as_str(), d) {
        ("van-der-corput" | "halton" | "sobol", 1) => Some((portable::log2(count) / 3.0 + 1.0) / count),
        ("halton", _) => Some(over(d)),
        ("hammersley", _) => Some(over(d - 1)),
        _ => None,
    }
}

/// The exact value or the root of the expected square, where it is known.
fn expected(p: &Discrepancy, method: &Method, n: usize) -> Option<f64> {
    let (d, count) = (p.dimensions as i32, n as f64);
    match (p.measure.key(), method.name().as_str(), d) {
        ("l2-star", "independent", _) => Some(((portable::power(2.0, -d) - portable::power(3.0, -d)) / count).sqrt()),
        // Halton and Zaremba (1969), for n = 2^m.
        ("star-discrepancy", "hammersley", 2) if n.is_power_of_two() && n >= 4 => {
            let m = n.trailing_zeros();
            let sign = if m.is_multiple_of(2) { 1.0 } else { -1.0 };
            Some((f64::from(m) / 3.0 + 13.0 / 9.0 - sign * 4.0 / (9.0 * count)) / count)
        }
        ("star-discrepancy", "centred-grid", 2) => Some((1.0 - 0.25 / count.sqrt()) / count.sqrt()),
        _ => None,
    }
}

/// The slope through the means on logarithmic axes.
fn fit(marks: &[Mark]) -> Option<(f64, Option<f64>)> {
    let positive = || marks.iter().filter(|mark| mark.mean > 0.0);
    let x: Vec<f64> = positive().map(|mark| portable::log2(mark.n as f64)).collect();
    let y: Vec<f64> = positive().map(|mark| portable::log2(mark.mean)).collect();
    let line = regression::least_squares(&x, &y).filter(|line| line.slope.is_finite())?;
    Some((line.slope, Some(line.slope_error).filter(|error| error.is_finite() && x.len() > 2)))
}

/// A sampler and its value.
type End<'a> = (&'a str, f64);

/// The samplers with the least and the greatest value at the largest count.
fn extremes(data: &Data) -> Option<(End<'_>, End<'_>)> {
    let ends = || data.curves.iter().filter_map(|curve| Some((curve.title.as_str(), curve.marks.last()?.mean)));
    let best = ends().filter(|end| end.1 > 0.0).min_by(|a, b| a.1.total_cmp(&b.1))?;
    let worst = ends().max_by(|a, b| a.1.total_cmp(&b.1))?;
    (best.0 != worst.0).then_some((best, worst))
}

mod drawing {
    //! The drawing or the table of a measure over N, and its words.

    use std::fmt::Write as _;

    use super::{Curve, Data, Discrepancy, Form, Mark, extremes};
    use crate::chart::number::{fixed, integer, shortest, significant};
    use crate::chart::{
        Axis, Band, Cell, Chart, ChartError, Column, Dash, Drawing, ErrorBars, Layer, Line, Panel, Sheet, Style, Table,
    };

    pub(super) fn draw(p: &Discrepancy, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match p.form {
            Form::Figure => figure(p, data, sheet),
            Form::Table => Ok(Drawing::Table(table(p, data))),
        }
    }

    /// A row for each sampler: its values over N, and the slope of the line through them.
    fn table(p: &Discrepancy, data: &Data) -> Table {
        let mut columns = vec![Column::left("Sampler")];
        columns.extend(p.n.iter().map(|n| Column::right(format!("$N = {n}$"))));
        columns.push(Column::right("Slope"));
        let mut table = Table::new(columns);
        for curve in &data.curves {
            let values = curve.marks.iter().map(|mark| Cell::significant(mark.mean, 3));
            let slope = curve.fit.map_or(Cell::Empty, |(slope, _)| Cell::fixed(slope, 2));
            table.push([Cell::text(curve.title.as_str())].into_iter().chain(values).chain([slope]));
        }
        table
    }

    fn figure(p: &Discrepancy, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let zero = data.curves.iter().all(|curve| curve.marks.iter().any(|mark| mark.mean <= 0.0));
        let linear = p.measure.key() == "t-value" || zero;
        let title = title(p);
        let vertical = if linear { Axis::linear(title).include(0.0) } else { Axis::log(title) };
        let panel = Panel::new(Axis::log2("*N*"), vertical).ratio(0.62);
        let panel = if linear { panel } else { panel.with_all(references(p, data)) };
        let panel = if p.bounds { panel.with_all(data.curves.iter().flat_map(bounds)) } else { panel };
        let panel = panel.with_all(data.curves.iter().flat_map(|curve| line(curve, linear)));
        Ok(Chart::new(panel).draw(sheet)?.into())
    }

    /// The name of the vertical axis.
    fn title(p: &Discrepancy) -> &'static str {
        match p.measure.key() {
            "star-discrepancy" => "star discrepancy *D*^{∗}",
            "t-value" => "quality *t*",
            _ => p.measure.title(),
        }
    }

    /// The means of one sampler, with the range of its values.
    fn line(curve: &Curve, linear: bool) -> Vec<Layer> {
        let shown = || curve.marks.iter().filter(|mark| linear || mark.mean > 0.0);
        let label = match curve.fit {
            Some((slope, _)) if !linear => format!("{} ({})", curve.title, fixed(slope, 2)),
            _ => curve.title.clone(),
        };
        let style = Style::of(&curve.method);
        let ranges: Vec<_> =
            shown().filter(|mark| mark.least < mark.most).map(|mark| (mark.n as f64, mark.least, mark.most)).collect();
        let line = Line::new(shown().map(|mark| (mark.n as f64, mark.mean)).collect());
        let line = line.style(style).label(label);
        let line = if curve.marks.len() > 40 { line } else { line.marked() };
        // Many error bars would hide the lines.
        let ranges: Option<Layer> = match ranges.len() {
            0 => None,
            1..=20 => Some(ErrorBars::new(ranges).style(style).into()),
            _ => Some(Band::new(ranges).style(style).into()),
        };
        ranges.into_iter().chain([line.into()]).collect()
    }

    /// The bound and the exact values of one sampler.
    fn bounds(curve: &Curve) -> Vec<Layer> {
        let role = Style::of(&curve.method).role;
        let through = |value: fn(&Mark) -> Option<f64>, what: &str, dash: Dash| {
            let points: Vec<(f64, f64)> =
                curve.marks.iter().filter_map(|mark| Some((mark.n as f64, value(mark)?))).collect();
            let line = Line::new(points)
                .style(Style::new(role).dash(dash))
                .width(1.0)
                .label(format!("{}: {what}", curve.title));
            (curve.marks.iter().filter_map(value).count() > 1).then(|| line.into())
        };
        let lines =
            [through(|mark| mark.bound, "bound", Dash::Dashed), through(|mark| mark.expected, "exact", Dash::Dotted)];
        lines.into_iter().flatten().collect()
    }

    /// The reference slopes through the largest first value.
    fn references(p: &Discrepancy, data: &Data) -> Vec<Line> {
        let firsts = data.curves.iter().filter_map(|curve| curve.marks.first());
        let Some(start) = firsts.map(|mark| mark.mean).max_by(f64::total_cmp).filter(|&start| start > 0.0) else {
            return Vec::new();
        };
        let (Some(first), Some(last)) = (p.n.iter().next(), p.n.iter().last()) else { return Vec::new() };
        let line = |(&slope, dash): (&f64, Dash)| {
            let line = Line::power(first as f64, start, slope, last as f64).style(Style::THEORY.dash(dash));
            line.label(format!("slope {}", shortest(slope)))
        };
        let broken = p.slopes.iter().zip(Dash::REFERENCES.into_iter().cycle());
        if first == last { Vec::new() } else { broken.map(line).collect() }
    }

    pub(super) fn alt(p: &Discrepancy, data: &Data) -> Option<String> {
        let (first, last) = (p.n.iter().next()?, p.n.iter().last()?);
        let mut text = format!(
            "{} in {} dimension{} over N, from {} to {} points.",
            p.measure.title(),
            p.dimensions,
            if p.dimensions == 1 { "" } else { "s" },
            integer(first as i64),
            integer(last as i64),
        );
        for curve in &data.curves {
            let (Some(from), Some(to)) = (curve.marks.first(), curve.marks.last()) else { continue };
            let _ = write!(text, " {}: {}", curve.title, significant(from.mean, 3));
            if to.n > from.n {
                let _ = write!(text, " at first, {} at the end", significant(to.mean, 3));
            }
            if let Some((slope, error)) = curve.fit {
                let _ = write!(text, "; slope {}", fixed(slope, 2));
                if let Some(error) = error {
                    let _ = write!(text, " ± {}", fixed(error, 2));
                }
            }
            if curve.marks.iter().any(|mark| mark.bound.is_some()) {
                let holds = if curve.marks.iter().all(Mark::is_bounded) { "below" } else { "not below" };
                let _ = write!(text, "; {holds} its bound");
            }
            text.push('.');
        }
        if let Some((best, worst)) = extremes(data).filter(|_| p.measure.is_discrepancy()) {
            let gain = significant(worst.1 / best.1, 2);
            let _ = write!(text, " At the largest N {} is least, {gain} times less than {}.", best.0, worst.0);
        }
        Some(text)
    }
}
