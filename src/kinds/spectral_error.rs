//! What a power spectrum says about an error: the variance of an estimate as the overlap of two spectra.
//!
//! Of a set of n points that is shifted at random on the torus, the estimate of the integral of f has the variance
//!
//! ```text
//! V[F_N] = (1/N) sum over w != 0 of P(w) |f_w|^2
//! ```
//!
//! with the periodogram P of the set and the Fourier coefficients f_w of the integrand. Both sides are computed apart from each
//! other: the variance from estimates with shifted sets, the sum from the spectra of the sets and the coefficients of f, which are
//! those of a fine grid of f's values. The sum ends at the reach, so that it is complete only for a smooth and periodic f.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{check_dimensions, mean_with_error, replicates_of, undefined};
use super::placing::{Placing, unmeasured};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::integrands::Function;
use crate::metrics::spectrum::power;
use crate::parameters::{choices, parameters};
use crate::points::Points;
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::moments;

/// The kind `spectral-error`.
pub static SPECTRAL_ERROR: SpectralErrorKind = SpectralErrorKind;

/// The kind of experiment that predicts variances from spectra.
pub struct SpectralErrorKind;

static ABOUT: About = About {
    key: "spectral-error",
    title: "Errors from spectra",
    summary: "The variance of estimates beside the overlap of the spectra of points and integrand.",
    file: "kinds/spectral_error.rs",
    source: include_str!("spectral_error.rs"),
    papers: &[Paper {
        authors: "A. Pilleboue, G. Singh, D. Coeurjolly, M. Kazhdan and V. Ostromoukhov",
        year: 2015,
        title: "Variance Analysis for Monte Carlo Integration",
        venue: "ACM Transactions on Graphics 34(4), 124",
        doi: Some("10.1145/2766930"),
    }],
};

choices! {
    /// How the variances are shown.
    pub enum Show {
        /// Measured beside predicted, a sampler a row.
        Table = "table",
        /// The predicted variance by the length of the frequency that it comes from.
        Overlap = "overlap",
    }
}

parameters! {
    /// What a study of errors from spectra can choose.
    pub struct SpectralError {
        /// The samplers, each with an optional scramble; their sets are shifted at random on the torus.
        samplers: Vec<Method> [or sampler],
        /// What is integrated over the unit square; only if it is periodic is the sum of its spectrum complete.
        integrand: Function = "exp(cos(6.283185307179586*x) + cos(6.283185307179586*y))",
        /// How many points each set has.
        n: usize [in 2..=65_536] = 256,
        /// Over how many sets spectra are averaged, and how many estimates the variance is of.
        replicates: usize [in 10..=100_000] = 400,
        /// The highest frequency along an axis.
        reach: usize [in 2..=64] = 16,
        /// What is shown.
        @drawn show: Show = "table",
    }
}

/// The variances of every sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    integral: f64,
    /// The integrand's energy by the length of the frequency, rounded: from 1 on.
    energy: Vec<f64>,
    curves: Vec<Curve>,
}

/// The variances of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Curve {
    method: String,
    title: String,
    /// The mean square error of the estimates, with its standard error.
    measured: (f64, f64),
    /// The overlap of the spectra, with its standard error; 0 where there is a single set.
    predicted: (f64, f64),
    /// The parts of the overlap, as those of the energy.
    parts: Vec<f64>,
}

impl Curve {
    /// The difference of both variances in standard errors.
    fn z(&self) -> f64 {
        let (measured, predicted) = (self.measured.1, self.predicted.1);
        (self.measured.0 - self.predicted.0) / (measured * measured + predicted * predicted).sqrt()
    }
}

impl Kind for SpectralErrorKind {
    type Parameters = SpectralError;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &SpectralError, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, &[p.n], 2);
        check_dimensions(&p.integrand, Some(2), problems);
    }

    fn weight(&self, p: &SpectralError) -> u64 {
        ((p.n * p.replicates * p.samplers.len()) as u64).saturating_mul((p.reach * p.reach) as u64 / 4 + 1)
    }

    fn run(&self, p: &SpectralError, seed: Seed) -> Result<Data, Failure> {
        let energies = energies(p)?;
        let placing = Placing { kind: ABOUT.key, d: 2, seed };
        let curves = p.samplers.iter().map(|method| curve(p, method, &placing, &energies)).collect::<Result<_, _>>()?;
        Ok(Data { integral: energies.integral, energy: energies.rings(|_, _| 1.0), curves })
    }

    fn values(&self, _: &SpectralError, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("integral", data.integral);
        for curve in &data.curves {
            let name = &curve.method;
            values.estimate(format!("measured.{name}"), curve.measured.0, curve.measured.1);
            values.estimate(format!("predicted.{name}"), curve.predicted.0, curve.predicted.1);
            values.number(format!("z.{name}"), curve.z());
        }
        values
    }

    fn tables(&self, _: &SpectralError, data: &Data) -> Vec<Frame> {
        let curves = || data.curves.iter();
        let variances = Frame::new("variances")
            .text("sampler", curves().map(|curve| curve.method.clone()))
            .numbers("measured", curves().map(|curve| curve.measured.0))
            .numbers("measured standard error", curves().map(|curve| curve.measured.1))
            .numbers("predicted", curves().map(|curve| curve.predicted.0))
            .numbers("predicted standard error", curves().map(|curve| curve.predicted.1));
        let rings = Frame::new("overlap")
            .counts("frequency", 1..=data.energy.len())
            .numbers("energy", data.energy.iter().copied());
        let add = |frame: Frame, curve: &Curve| frame.numbers(curve.method.clone(), curve.parts.iter().copied());
        vec![variances, curves().fold(rings, add)]
    }

    fn draw(&self, p: &SpectralError, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &SpectralError, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The squares of an integrand's Fourier coefficients.
struct Energies {
    reach: usize,
    /// The coefficient of the frequency 0.
    integral: f64,
    /// Rows v = -reach ..= reach of columns u = -reach ..= reach.
    squares: Vec<f64>,
}

impl Energies {
    /// The sums over rings of frequencies of about the same length, from 1 on, of `weight(u, v)` times the energy.
    fn rings(&self, weight: impl Fn(i32, i32) -> f64) -> Vec<f64> {
        let reach = self.reach as i32;
        let places = (-reach..=reach).flat_map(|v| (-reach..=reach).map(move |u| (u, v)));
        let mut rings = vec![moments::Sum::default(); self.reach * 3 / 2 + 1];
        for ((u, v), energy) in places.zip(&self.squares).filter(|(place, _)| *place != (0, 0)) {
            let ring = (f64::from(u * u + v * v).sqrt() + 0.5) as usize;
            if let Some(sum) = rings.get_mut(ring) {
                sum.add(weight(u, v) * energy);
            }
        }
        rings[1..].iter().map(moments::Sum::value).collect()
    }
}

/// The energies of the integrand, from its values on a grid with four times as many lines as the highest frequency.
fn energies(p: &SpectralError) -> Result<Energies, Failure> {
    let (side, reach) = (4 * p.reach, p.reach);
    let place = |index: usize| index as f64 / side as f64;
    let mut values = Vec::with_capacity(side * side);
    for (i, j) in (0..side).flat_map(|i| (0..side).map(move |j| (i, j))) {
        let point = [place(j), place(i)];
        let value = p.integrand.evaluate(&point);
        if !value.is_finite() {
            return Err(undefined(&p.integrand, &point));
        }
        values.push((value, 0.0));
    }
    // One axis after the other: rows of x become rows of u, then columns of y columns of v.
    let waves = Waves::new(side);
    let half: Vec<Vec<(f64, f64)>> = values.chunks_exact(side).map(|row| waves.coefficients(row, reach)).collect();
    let columns: Vec<Vec<(f64, f64)>> = (0..=2 * reach)
        .map(|u| waves.coefficients(&half.iter().map(|row| row[u]).collect::<Vec<_>>(), reach))
        .collect();
    let squares = (0..=2 * reach).flat_map(|v| columns.iter().map(move |column| column[v]));
    let squares: Vec<f64> = squares.map(|(re, im)| re * re + im * im).collect();
    Ok(Energies { reach, integral: columns[reach][reach].0, squares })
}

/// The values of one turn of a cosine and a sine at equal steps.
struct Waves {
    turn: Vec<(f64, f64)>,
}

impl Waves {
    fn new(side: usize) -> Self {
        use crate::stats::portable::{cos, sin};
        let angle = |k: usize| std::f64::consts::TAU * k as f64 / side as f64;
        Self { turn: (0..side).map(|k| (cos(angle(k)), sin(angle(k)))).collect() }
    }

    /// The coefficients of the frequencies -reach ..= reach of values at equal steps.
    fn coefficients(&self, values: &[(f64, f64)], reach: usize) -> Vec<(f64, f64)> {
        let side = self.turn.len();
        let coefficient = |frequency: usize| {
            let (mut re, mut im) = (moments::Sum::default(), moments::Sum::default());
            for (k, &(a, b)) in values.iter().enumerate() {
                // exp(-2 pi i w k / side), with w = frequency - reach.
                let (cosine, sine) = self.turn[(frequency + side - reach) * k % side];
                re.add(a * cosine + b * sine);
                im.add(b * cosine - a * sine);
            }
            (re.value() / side as f64, im.value() / side as f64)
        };
        (0..=2 * reach).map(coefficient).collect()
    }
}

/// Both variances of one method.
fn curve(p: &SpectralError, method: &Method, placing: &Placing, energies: &Energies) -> Result<Curve, Failure> {
    let sets = replicates_of(method, p.replicates);
    let points = |replicate: usize| placing.points(method, p.n, replicate.min(sets - 1));
    let error = |replicate: usize| {
        let error = estimate(p, &points(replicate)?, placing, replicate) - energies.integral;
        Ok(error * error)
    };
    let squares: Vec<Result<f64, Failure>> = (0..p.replicates).into_par_iter().map(piece(error)).collect();
    let (measured, error) = mean_with_error(&squares.into_iter().collect::<Result<Vec<_>, _>>()?);
    let overlap = |replicate: usize| {
        let powers = power(&points(replicate)?, p.reach).map_err(|error| unmeasured(method, &error))?;
        Ok(energies.rings(|u, v| powers.at(u, v) / p.n as f64))
    };
    let parts: Vec<Result<Vec<f64>, Failure>> = (0..sets).into_par_iter().map(piece(overlap)).collect();
    let parts = parts.into_iter().collect::<Result<Vec<_>, _>>()?;
    let totals: Vec<f64> = parts.iter().map(|rings| moments::sum(rings.iter().copied())).collect();
    let (predicted, spread) = mean_with_error(&totals);
    let mean = |ring: usize| moments::mean(&parts.iter().map(|rings| rings[ring]).collect::<Vec<_>>());
    Ok(Curve {
        method: method.name(),
        title: method.title(),
        measured: (measured, error.unwrap_or(f64::NAN)),
        predicted: (predicted, spread.unwrap_or(0.0)),
        parts: (0..p.reach * 3 / 2).map(mean).collect(),
    })
}

/// The estimate with a set that is shifted by a random vector of its own.
fn estimate(p: &SpectralError, points: &Points, placing: &Placing, replicate: usize) -> f64 {
    let mut random = placing.seed.named(ABOUT.key).named("shift").at(replicate as u64).generator();
    let (dx, dy) = (random.uniform(), random.uniform());
    let turned = |x: f64| if x < 1.0 { x } else { x - 1.0 };
    let value = |point: &[f64]| p.integrand.evaluate(&[turned(point[0] + dx), turned(point[1] + dy)]);
    moments::sum(points.rows().map(value)) / points.len() as f64
}

mod drawing {
    //! The variances as a table or as lines, and their words.

    use std::fmt::Write as _;

    use super::{Data, Show, SpectralError};
    use crate::chart::number::{integer, significant};
    use crate::chart::{Axis, Cell, Chart, ChartError, Column, Drawing, Line, Panel, Sheet, Style, Table};

    pub(super) fn draw(p: &SpectralError, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match p.show {
            Show::Table => Ok(table(data).into()),
            Show::Overlap => overlap(data, sheet),
        }
    }

    fn table(data: &Data) -> Table {
        let columns = vec![
            Column::left("Points"),
            Column::right("Variance measured"),
            Column::right("From the spectra"),
            Column::right("$z$"),
        ];
        let mut table = Table::new(columns);
        for curve in &data.curves {
            table.push([
                Cell::text(curve.title.as_str()),
                cell(curve.measured),
                cell(curve.predicted),
                Cell::fixed(curve.z(), 2),
            ]);
        }
        table
    }

    /// A variance with its error to two digits; the error of a single set is none.
    fn cell((value, error): (f64, f64)) -> Cell {
        let text = match (value == 0.0, error > 0.0) {
            (true, _) => "0".to_owned(),
            (_, false) => significant(value, 3),
            (_, true) => format!("{} ± {}", significant(value, 3), significant(error, 2)),
        };
        Cell::Decimal { value, text }
    }

    /// What is smaller than this share of the largest has no place in the figure.
    const LEAST: f64 = 1e-12;

    fn overlap(data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let highest = data.energy.iter().copied().fold(0.0, f64::max);
        let line = |rings: &[f64]| {
            let places = rings.iter().enumerate().map(|(ring, &part)| (ring as f64 + 1.0, part));
            Line::new(places.filter(|place| place.1 > highest * LEAST).collect()).marked()
        };
        let energy = line(&data.energy).style(Style::THEORY).label("integrand");
        let curves = data.curves.iter();
        let curves = curves.map(|curve| line(&curve.parts).style(Style::of(&curve.method)).label(curve.title.as_str()));
        let panel = Panel::new(Axis::linear("frequency").include(0.0), Axis::log("part of the variance")).ratio(0.6);
        Ok(Chart::new(panel.with(energy).with_all(curves)).draw(sheet)?.into())
    }

    pub(super) fn alt(p: &SpectralError, data: &Data) -> String {
        let mut text = format!(
            "The variance of the estimate of the integral of {} with {} points that are shifted at random",
            p.integrand.text(),
            integer(p.n as i64),
        );
        text += match p.show {
            Show::Table => ", measured and from the spectra.",
            Show::Overlap => ", by the length of the frequency that it comes from, on a logarithmic axis.",
        };
        for curve in &data.curves {
            let (measured, predicted) = (significant(curve.measured.0, 2), significant(curve.predicted.0, 2));
            let _ = write!(text, " {}: {measured} measured, {predicted} from the spectra.", curve.title);
        }
        text
    }
}
