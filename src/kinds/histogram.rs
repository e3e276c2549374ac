//! Histograms: how the estimates from N points are distributed over many runs, with the normal density beside.
//!
//! The central limit theorem predicts the normal law with the integral as its mean and sigma / sqrt(N) as its deviation, for
//! independent samples. Where that is not known, or for another sampler, the curve has the deviation that was measured.

use serde::{Deserialize, Serialize};

use super::estimation::{Study, check_dimensions, dimensions, mean_with_error, reference};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{Counts, choices, parameters};
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::histogram::Histogram as Bins;
use crate::stats::moments;

/// The kind `histogram`.
pub static HISTOGRAM: HistogramKind = HistogramKind;

/// The kind of experiment that shows distributions of estimates.
pub struct HistogramKind;

static ABOUT: About = About {
    key: "histogram",
    title: "Histograms of estimates",
    summary: "The distribution of the estimate from N points over many runs, one panel for each N, with the normal density.",
    file: "kinds/histogram.rs",
    source: include_str!("histogram.rs"),
    papers: &[],
};

choices! {
    /// How the axes of the panels relate.
    pub enum Axes {
        /// Each panel shows the shape of its own distribution.
        Own = "own",
        /// All panels show the same estimates, so that the distributions are seen to shrink.
        Shared = "shared",
    }
}

parameters! {
    /// What histograms of estimates can choose.
    pub struct Histogram {
        /// What is integrated over the unit cube.
        integrand: Function,
        /// The counts N, one panel each.
        n: Counts [in 1..=1_000_000] = "10^0..10^3",
        /// Where the samples come from; it must be random.
        sampler: Method = "independent",
        /// How many estimates each histogram is made of.
        replicates: usize [in 10..=1_000_000] = 2000,
        /// Into how many bins the estimates fall.
        bins: usize [in 2..=200] = 40,
        /// Whether all panels have the same axis of estimates.
        axes: Axes = "own",
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 1..=64],
    }
}

/// The distributions.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    exact: f64,
    sigma: Option<f64>,
    panels: Vec<Distribution>,
}

/// The distribution of the estimates for one count.
#[derive(Debug, Serialize, Deserialize)]
struct Distribution {
    n: u64,
    mean: f64,
    mean_error: f64,
    deviation: f64,
    deviation_error: f64,
    /// sigma / sqrt(N), where samples are independent.
    predicted: Option<f64>,
    /// Which part of the estimates is within two (predicted) deviations of the integral.
    within: f64,
    from: f64,
    to: f64,
    counts: Vec<u64>,
}

impl Kind for HistogramKind {
    type Parameters = Histogram;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Histogram) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions));
    }

    fn check(&self, p: &Histogram, problems: &mut Problems<'_, '_>) {
        check_dimensions(&p.integrand, p.dimensions, problems);
        let d = dimensions(&p.integrand, p.dimensions);
        problems.admit("sampler", std::slice::from_ref(&p.sampler), p.n.as_slice(), d);
        if !p.sampler.is_random() {
            let message =
                format!("`{}` gives the same estimate for every seed: it has no distribution", p.sampler.name());
            let help = "choose a random sampler, or a scramble such as `sobol+xor`".to_owned();
            problems.at("sampler", Code::Combination, message, Some(help));
        }
        if p.n.as_slice().len() > 12 {
            let message = format!("{} counts are more than the 12 panels that a figure can hold", p.n.as_slice().len());
            problems.at("n", Code::OutOfRange, message, None);
        }
    }

    fn weight(&self, p: &Histogram) -> u64 {
        p.n.total().saturating_mul(p.replicates as u64)
    }

    fn run(&self, p: &Histogram, seed: Seed) -> Result<Data, Failure> {
        let d = dimensions(&p.integrand, p.dimensions);
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let exact = reference(&p.integrand, d)?.value;
        let sigma = p.integrand.variance(d).map(|variance| variance.max(0.0).sqrt());
        let predicted = sigma.filter(|_| p.sampler.name() == "independent");
        let all = study.estimates(std::slice::from_ref(&p.sampler), p.n.as_slice(), p.replicates)?;
        let ranges = ranges(all.iter().flatten(), p.axes);
        let panels = p.n.iter().zip(all.iter().flatten()).zip(ranges).map(|((n, estimates), (from, to))| {
            let predicted = predicted.map(|sigma| sigma / (n as f64).sqrt());
            distribution(n, estimates, exact, predicted, Bins::new(estimates, from, to, p.bins))
        });
        let panels = panels.collect::<Option<Vec<_>>>().ok_or_else(|| {
            let message = format!("every estimate of `{}` is the same: there is no distribution", p.integrand.text());
            Failure::of("integrand", message).help("choose an integrand that varies")
        })?;
        Ok(Data { exact, sigma, panels })
    }

    fn values(&self, _: &Histogram, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("exact", data.exact);
        if let Some(sigma) = data.sigma {
            values.number("sigma", sigma);
        }
        for panel in &data.panels {
            let n = panel.n;
            values.estimate(format!("mean.{n}"), panel.mean, panel.mean_error);
            values.estimate(format!("deviation.{n}"), panel.deviation, panel.deviation_error);
            if let Some(predicted) = panel.predicted {
                values.number(format!("predicted.{n}"), predicted);
            }
            values.number(format!("within.{n}"), panel.within);
        }
        values
    }

    fn tables(&self, _: &Histogram, data: &Data) -> Vec<Frame> {
        let bins = || data.panels.iter().flat_map(|panel| (0..panel.counts.len()).map(move |bin| (panel, bin)));
        let frame = Frame::new("histogram")
            .counts("n", bins().map(|(panel, _)| panel.n as usize))
            .numbers("from", bins().map(|(panel, bin)| panel.edge(bin)))
            .numbers("to", bins().map(|(panel, bin)| panel.edge(bin + 1)))
            .counts("count", data.panels.iter().flat_map(|panel| panel.counts.iter().map(|&count| count as usize)));
        vec![frame]
    }

    fn draw(&self, p: &Histogram, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Histogram, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Distribution {
    fn edge(&self, bin: usize) -> f64 {
        self.from + (self.to - self.from) * (bin as f64 / self.counts.len().max(1) as f64)
    }

    fn total(&self) -> u64 {
        self.counts.iter().sum()
    }
}

/// The ends of each panel's bins: those of its own estimates, or those of all.
fn ranges<'a>(all: impl Iterator<Item = &'a Vec<f64>>, axes: Axes) -> Vec<(f64, f64)> {
    let ends = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    let own: Vec<(f64, f64)> = all.map(|estimates| estimates.iter().copied().fold(none, ends)).collect();
    match axes {
        Axes::Own => own,
        Axes::Shared => vec![own.iter().flat_map(|&(low, high)| [low, high]).fold(none, ends); own.len()],
    }
}

/// The distribution of `estimates`; `None` if they are all the same.
fn distribution(
    n: usize,
    estimates: &[f64],
    exact: f64,
    predicted: Option<f64>,
    bins: Option<Bins>,
) -> Option<Distribution> {
    let bins = bins?;
    let (mean, mean_error) = mean_with_error(estimates);
    let squares: Vec<f64> = estimates.iter().map(|estimate| (estimate - mean) * (estimate - mean)).collect();
    let (_, square_error) = mean_with_error(&squares);
    let deviation = moments::variance(estimates).sqrt();
    if deviation.is_nan() || deviation <= 0.0 {
        return None;
    }
    let half = 2.0 * predicted.unwrap_or(deviation);
    let within = estimates.iter().filter(|estimate| (*estimate - exact).abs() <= half).count();
    Some(Distribution {
        n: n as u64,
        mean,
        mean_error: mean_error?,
        deviation,
        deviation_error: square_error? / (2.0 * deviation),
        predicted,
        within: within as f64 / estimates.len() as f64,
        from: bins.from,
        to: bins.to,
        counts: bins.counts,
    })
}

mod drawing {
    //! The drawing of the distributions, and their words.

    use std::fmt::Write as _;

    use super::{Axes, Data, Distribution, Histogram};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Bars, Chart, ChartError, Drawing, Key, Line, Panel, Sheet, Style};
    use crate::stats::normal;

    /// Of how many pieces the normal curve is drawn.
    const PIECES: usize = 160;

    pub(super) fn draw(p: &Histogram, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let panels: Vec<Panel> = data.panels.iter().map(|one| panel(data, one, p)).collect();
        // Three in one row, so that none stands alone in a second.
        let columns = if panels.len() == 3 { 3 } else { panels.len().min(2) };
        Ok(Chart::grid(panels).columns(columns).key(Key::Above).draw(sheet)?.into())
    }

    fn panel(data: &Data, one: &Distribution, p: &Histogram) -> Panel {
        let total = one.total().max(1) as f64;
        let edges: Vec<f64> = (0..=one.counts.len()).map(|bin| one.edge(bin)).collect();
        let curve = curve(data, one);
        let width = (one.to - one.from) / one.counts.len().max(1) as f64;
        let heights: Vec<f64> = one.counts.iter().map(|&count| count as f64 / total / width).collect();
        let style = Style::of(&p.sampler.name());
        let tallest = highest(&heights).max(highest(&curve.iter().map(|(_, height)| *height).collect::<Vec<_>>()));
        let exact = Line::new(vec![(data.exact, 0.0), (data.exact, tallest)]).style(Style::EXACT).label("exact");
        let x = Axis::linear("estimate");
        let x = if p.axes == Axes::Shared { x.range(one.from, one.to) } else { x };
        Panel::new(x, Axis::linear("density").include(0.0))
            .title(format!("*N* = {}", integer(one.n as i64)))
            .ratio(0.62)
            .with(Bars::new(edges, heights).style(style).label("estimates"))
            .with(Line::new(curve).style(Style::THEORY).label("normal density"))
            .with(exact)
    }

    fn highest(heights: &[f64]) -> f64 {
        heights.iter().copied().fold(0.0, f64::max)
    }

    /// The normal density across the bins, with the predicted deviation where there is one.
    fn curve(data: &Data, one: &Distribution) -> Vec<(f64, f64)> {
        let (mean, deviation) = one.predicted.map_or((one.mean, one.deviation), |predicted| (data.exact, predicted));
        let at = |piece: usize| one.from + (one.to - one.from) * (piece as f64 / PIECES as f64);
        (0..=PIECES).map(at).map(|x| (x, normal::density(x, mean, deviation))).collect()
    }

    pub(super) fn alt(p: &Histogram, data: &Data) -> String {
        let mut text = format!(
            "Histograms of {} estimates of the integral of {}, exactly {}. Sampler: {}.",
            integer(p.replicates as i64),
            p.integrand.text(),
            significant(data.exact, 5),
            p.sampler.title(),
        );
        for one in &data.panels {
            let _ = write!(
                text,
                " N = {}: mean {}, standard deviation {}",
                integer(one.n as i64),
                significant(one.mean, 4),
                significant(one.deviation, 3),
            );
            if let Some(predicted) = one.predicted {
                let _ = write!(text, " (predicted {})", significant(predicted, 3));
            }
            let _ = write!(text, ", {} per cent within two deviations of the integral.", fixed(100.0 * one.within, 1));
        }
        text
    }
}
