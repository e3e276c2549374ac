//! Las Vegas beside Monte Carlo: the comparisons of randomised quicksort, always right at a random cost, and the estimates of an
//! integral from N samples, whose cost is fixed and whose answer is random.
//!
//! Quicksort with random pivots makes 2(n + 1) H_n - 4n comparisons of n distinct keys on average, with variance
//! 7n^2 - 4(n + 1)^2 H_n^(2) - 2(n + 1) H_n + 13n, where H_n and H_n^(2) are the sums of 1/k and of 1/k^2.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Study, mean_with_error, reference};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::{Random, Seed};
use crate::stats::histogram::Histogram;
use crate::stats::moments;

/// The kind `quicksort`.
pub static QUICKSORT: QuicksortKind = QuicksortKind;

/// The kind of experiment that sets Las Vegas beside Monte Carlo.
pub struct QuicksortKind;

static ABOUT: About = About {
    key: "quicksort",
    title: "Las Vegas and Monte Carlo",
    summary: "The comparisons of randomised quicksort, every sort checked, beside the estimates of an integral from N samples.",
    file: "kinds/quicksort.rs",
    source: include_str!("quicksort.rs"),
    papers: &[
        Paper {
            authors: "C. A. R. Hoare",
            year: 1962,
            title: "Quicksort",
            venue: "The Computer Journal 5(1), 10-16",
            doi: Some("10.1093/comjnl/5.1.10"),
        },
        Paper {
            authors: "R. Sedgewick",
            year: 1977,
            title: "The Analysis of Quicksort Programs",
            venue: "Acta Informatica 7, 327-355",
            doi: Some("10.1007/BF00289467"),
        },
    ],
};

parameters! {
    /// What the comparison of Las Vegas with Monte Carlo can choose.
    pub struct Quicksort {
        /// How many keys are sorted.
        length: usize [in 2..=100_000] = 1000,
        /// How many sorts, and how many estimates.
        runs: usize [in 10..=100_000] = 2000,
        /// What Monte Carlo integrates over the unit interval, square, ...
        integrand: Function = "exp-sin",
        /// From how many samples each estimate is made.
        n: usize [in 1..=1_000_000] = 1000,
        /// Into how many bins the runs fall.
        bins: usize [in 2..=200] = 40,
    }
}

/// The two distributions.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    sorted: bool,
    comparisons: Distribution,
    estimates: Distribution,
    exact: f64,
    /// The expected number of comparisons and its standard deviation.
    expected: (f64, f64),
}

/// A distribution over the runs.
#[derive(Debug, Serialize, Deserialize)]
struct Distribution {
    mean: f64,
    mean_error: f64,
    deviation: f64,
    least: f64,
    most: f64,
    from: f64,
    to: f64,
    counts: Vec<u64>,
}

impl Kind for QuicksortKind {
    type Parameters = Quicksort;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Quicksort, problems: &mut Problems<'_, '_>) {
        if p.length.saturating_mul(p.runs) > 50_000_000 {
            let message = format!("{} sorts of {} keys take too long", p.runs, p.length);
            problems.at("length", Code::OutOfRange, message, Some("choose fewer runs or fewer keys".to_owned()));
        }
    }

    fn weight(&self, p: &Quicksort) -> u64 {
        (p.runs as u64).saturating_mul(12 * p.length as u64 + p.n as u64)
    }

    fn run(&self, p: &Quicksort, seed: Seed) -> Result<Data, Failure> {
        let stream = seed.named(ABOUT.key);
        let sort = |run: u64| {
            let mut random = stream.named("sort").at(run).generator();
            let mut keys: Vec<u32> = (0..p.length as u32).collect();
            random.shuffle(&mut keys);
            let comparisons = quicksort(&mut keys, &mut random);
            (comparisons, keys.iter().enumerate().all(|(place, &key)| place == key as usize))
        };
        let sorts: Vec<(u64, bool)> = (0..p.runs as u64).into_par_iter().map(piece(sort)).collect();
        let comparisons: Vec<f64> = sorts.iter().map(|(comparisons, _)| *comparisons as f64).collect();
        let d = p.integrand.dimensions().unwrap_or(1);
        let exact = reference(&p.integrand, d)?.value;
        let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed };
        let method = Method::parse("independent").map_err(|error| Failure::of("integrand", error.to_string()))?;
        let mut estimates = study.estimates(&[method], &[p.n], p.runs)?;
        let estimates = estimates.pop().and_then(|mut counts| counts.pop()).unwrap_or_default();
        let same = |what: &str| Failure::of("runs", format!("every {what} is the same: there is no distribution"));
        Ok(Data {
            sorted: sorts.iter().all(|(_, sorted)| *sorted),
            comparisons: distribution(&comparisons, p.bins)
                .ok_or_else(|| same("sort").help("sort more keys, or more often"))?,
            estimates: distribution(&estimates, p.bins)
                .ok_or_else(|| same("estimate").help("choose an integrand that varies"))?,
            exact,
            expected: expected(p.length),
        })
    }

    fn values(&self, _: &Quicksort, data: &Data) -> Values {
        let mut values = Values::new();
        let comparisons = &data.comparisons;
        values.boolean("sorted", data.sorted);
        values.estimate("mean", comparisons.mean, comparisons.mean_error);
        values.number("expected", data.expected.0);
        values.number("z", (comparisons.mean - data.expected.0) / comparisons.mean_error);
        values.number("deviation", comparisons.deviation);
        values.number("expected.deviation", data.expected.1);
        values.integer("least", comparisons.least as i64);
        values.integer("most", comparisons.most as i64);
        values.number("exact", data.exact);
        values.estimate("estimate", data.estimates.mean, data.estimates.mean_error);
        values.number("estimate.deviation", data.estimates.deviation);
        values
    }

    fn tables(&self, _: &Quicksort, data: &Data) -> Vec<Frame> {
        let frame = |name: &'static str, one: &Distribution| {
            let edge = |bin: usize| one.edge(bin);
            Frame::new(name)
                .numbers("from", (0..one.counts.len()).map(edge))
                .numbers("to", (1..=one.counts.len()).map(edge))
                .counts("count", one.counts.iter().map(|&count| count as usize))
        };
        vec![frame("comparisons", &data.comparisons), frame("estimates", &data.estimates)]
    }

    fn draw(&self, p: &Quicksort, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Quicksort, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Distribution {
    fn edge(&self, bin: usize) -> f64 {
        self.from + (self.to - self.from) * (bin as f64 / self.counts.len().max(1) as f64)
    }
}

/// The distribution of `runs`; `None` if they are all the same.
fn distribution(runs: &[f64], bins: usize) -> Option<Distribution> {
    let (least, most) =
        runs.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |ends, &run| (ends.0.min(run), ends.1.max(run)));
    let (mean, mean_error) = mean_with_error(runs);
    let bins = Histogram::new(runs, least, most, bins)?;
    let deviation = moments::variance(runs).sqrt();
    let (from, to) = (bins.from, bins.to);
    Some(Distribution { mean, mean_error: mean_error?, deviation, least, most, from, to, counts: bins.counts })
}

/// Sorts distinct keys in place with random pivots; how many keys were
/// compared with a pivot.
pub fn quicksort(keys: &mut [u32], random: &mut Random) -> u64 {
    if keys.len() < 2 {
        return 0;
    }
    let last = keys.len() - 1;
    keys.swap(random.below(keys.len() as u64) as usize, last);
    let pivot = keys[last];
    let mut border = 0;
    for i in 0..last {
        if keys[i] < pivot {
            keys.swap(i, border);
            border += 1;
        }
    }
    keys.swap(border, last);
    let (left, right) = keys.split_at_mut(border);
    let below = quicksort(left, random);
    let above = quicksort(&mut right[1..], random);
    last as u64 + below + above
}

/// The mean and the standard deviation of the number of comparisons of `n` keys.
fn expected(n: usize) -> (f64, f64) {
    let harmonic =
        |square: bool| moments::sum((1..=n).map(|k| if square { 1.0 / (k as f64 * k as f64) } else { 1.0 / k as f64 }));
    let (n, first, second) = (n as f64, harmonic(false), harmonic(true));
    let mean = 2.0 * (n + 1.0) * first - 4.0 * n;
    let variance = 7.0 * n * n - 4.0 * (n + 1.0) * (n + 1.0) * second - 2.0 * (n + 1.0) * first + 13.0 * n;
    (mean, variance.max(0.0).sqrt())
}

mod drawing {
    //! The two histograms, and their words.

    use super::{Data, Distribution, Quicksort};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Bars, Chart, ChartError, Drawing, Key, Line, Panel, Role, Sheet, Style};

    pub(super) fn draw(p: &Quicksort, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let sorts = panel(&data.comparisons, data.expected.0, "comparisons", Style::new(Role::Blue))
            .title("Las Vegas: the cost is random");
        let what = format!("estimate from {} samples", integer(p.n as i64));
        let estimates = panel(&data.estimates, data.exact, &what, Style::of("independent"))
            .title("Monte Carlo: the answer is random");
        Ok(Chart::grid(vec![sorts, estimates]).columns(2).key(Key::Above).draw(sheet)?.into())
    }

    fn panel(one: &Distribution, expected: f64, what: &str, style: Style) -> Panel {
        let edges: Vec<f64> = (0..=one.counts.len()).map(|bin| one.edge(bin)).collect();
        let heights: Vec<f64> = one.counts.iter().map(|&count| count as f64).collect();
        let top = 1.05 * heights.iter().copied().fold(0.0, f64::max);
        Panel::new(Axis::linear(what), Axis::linear("runs").include(0.0))
            .ratio(0.72)
            .with(Bars::new(edges, heights).style(style))
            .with(Line::new(vec![(expected, 0.0), (expected, top)]).style(Style::EXACT).label("expected"))
    }

    pub(super) fn alt(p: &Quicksort, data: &Data) -> String {
        let comparisons = &data.comparisons;
        format!(
            "Two histograms of {} runs. Left, the comparisons that randomised quicksort makes of {} keys: from {} to {}, {} ± {} on average, {} expected; {}. Right, the estimates of the integral of {} from {} samples: exactly {}, with a standard deviation of {}.",
            integer(p.runs as i64),
            integer(p.length as i64),
            integer(comparisons.least as i64),
            integer(comparisons.most as i64),
            fixed(comparisons.mean, 1),
            fixed(comparisons.mean_error, 1),
            fixed(data.expected.0, 1),
            if data.sorted { "every sort was right" } else { "not every sort was right" },
            p.integrand.text(),
            integer(p.n as i64),
            significant(data.exact, 5),
            significant(data.estimates.deviation, 2),
        )
    }
}
