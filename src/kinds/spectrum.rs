//! Power spectra of point sets, averaged over many of them: images, radial means, and anisotropies.
//!
//! The spectrum of one set is noise around the expected one, so R independent sets are averaged. Independent points have the
//! expectation 1 at every frequency but 0. On a k x k grid, jittered points have 1 - sinc^2(u/k) sinc^2(v/k), which rises with the
//! square of the frequency. A Latin hypercube of n points has 1 - sinc^2(u/n) on the axes and 1 + sinc^2(u/n) sinc^2(v/n) / (n - 1)
//! off them. Standard errors are those of the mean over the sets.

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{mean_with_error, replicates_of};
use super::placing::{Placing, unmeasured};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::metrics::spectrum::{Spectrum as Powers, power};
use crate::parameters::{choices, parameters};
use crate::raster::Png;
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::{portable, regression};

/// The kind `spectrum`.
pub static SPECTRUM: SpectrumKind = SpectrumKind;

/// The kind of experiment that averages power spectra.
pub struct SpectrumKind;

static ABOUT: About = About {
    key: "spectrum",
    title: "Power spectra",
    summary: "Expected power spectra of samplers as images, radial means or anisotropies.",
    file: "kinds/spectrum.rs",
    source: include_str!("spectrum.rs"),
    papers: &[Paper {
        authors: "R. A. Ulichney",
        year: 1988,
        title: "Dithering with Blue Noise",
        venue: "Proceedings of the IEEE 76(1), 56-79",
        doi: Some("10.1109/5.3288"),
    }],
};

choices! {
    /// What is shown of the spectra.
    pub enum Show {
        /// The powers as grey images: black for 0, white for 2 and more.
        Images = "images",
        /// The mean power over the length of the frequency.
        Radial = "radial",
        /// The same on logarithmic axes, where a power law is straight.
        Logarithmic = "logarithmic",
        /// The variance along rings, in decibels.
        Anisotropy = "anisotropy",
        /// The image and the radial mean beside it, a row for each sampler.
        Both = "both",
    }
}

parameters! {
    /// What a study of power spectra can choose.
    pub struct Spectrum {
        /// The samplers, each with an optional scramble.
        samplers: Vec<Method> [or sampler],
        /// How many points each set has.
        n: usize [in 1..=65_536] = 1024,
        /// Over how many sets the spectra are averaged.
        replicates: usize [in 1..=10_000] = 100,
        /// The highest frequency along an axis.
        reach: usize [in 4..=256] = 64,
        /// Up to which frequency power counts as low; a quarter of the root of n if it is not given.
        low: Option<usize> [in 2..=256],
        /// What is shown.
        @drawn show: Show = "images",
    }
}

/// The spectra of every sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    curves: Vec<Curve>,
}

/// The spectrum of one sampler.
#[derive(Debug, Serialize, Deserialize)]
struct Curve {
    method: String,
    title: String,
    replicates: u32,
    image: Png,
    rings: Vec<Mean>,
    /// Mean power over all frequencies but 0, with its standard error.
    mean: (f64, Option<f64>),
    /// Mean power over the low frequencies, with its standard error.
    low: (f64, Option<f64>),
    /// The slope of log2 of the power over log2 of the frequency at low frequencies, with its standard error.
    slope: Option<(f64, Option<f64>)>,
}

/// One ring of frequencies.
#[derive(Debug, Serialize, Deserialize)]
struct Mean {
    /// The root mean square of the ring's frequencies.
    frequency: f64,
    power: f64,
    error: Option<f64>,
    anisotropy: f64,
    /// The exact expectation, where it is known.
    expected: Option<f64>,
}

impl Kind for SpectrumKind {
    type Parameters = Spectrum;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Spectrum) {
        p.low = Some(low(p));
    }

    fn check(&self, p: &Spectrum, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, &[p.n], 2);
        let kept = p.replicates as u64 * (2 * p.reach as u64 + 1) * (p.reach as u64 + 1);
        if kept > 1 << 27 {
            let message = format!("{} spectra of reach {} are too many to average", p.replicates, p.reach);
            problems.at("replicates", Code::OutOfRange, message, Some("take fewer, or a smaller reach".to_owned()));
        }
        if low(p) > p.reach {
            let message = format!("the low frequencies, up to {}, go beyond the reach {}", low(p), p.reach);
            problems.at("low", Code::Combination, message, None);
        }
        if p.samplers.len() > 12 {
            let message = format!("{} samplers are more than the 12 that a figure can hold", p.samplers.len());
            problems.at("samplers", Code::OutOfRange, message, None);
        }
    }

    fn weight(&self, p: &Spectrum) -> u64 {
        ((p.n * p.replicates * p.samplers.len()) as u64).saturating_mul((p.reach * p.reach) as u64 / 4)
    }

    fn run(&self, p: &Spectrum, seed: Seed) -> Result<Data, Failure> {
        let placing = Placing { kind: ABOUT.key, d: 2, seed };
        Ok(Data { curves: p.samplers.iter().map(|method| curve(p, method, &placing)).collect::<Result<_, _>>()? })
    }

    fn values(&self, _: &Spectrum, data: &Data) -> Values {
        let mut values = Values::new();
        for curve in &data.curves {
            let name = &curve.method;
            let nan = |error: Option<f64>| error.unwrap_or(f64::NAN);
            values.estimate(format!("mean.{name}"), curve.mean.0, nan(curve.mean.1));
            values.estimate(format!("low.{name}"), curve.low.0, nan(curve.low.1));
            if let Some((slope, error)) = curve.slope {
                values.estimate(format!("slope.{name}"), slope, nan(error));
            }
            if let Some((ring, peak)) = curve.peak() {
                values.number(format!("peak.{name}"), ring as f64);
                values.estimate(format!("peak.power.{name}"), peak.power, nan(peak.error));
            }
            let off = |value: fn(&Mean) -> Option<f64>| curve.rings.iter().filter_map(value).reduce(f64::max);
            values.number(format!("flatness.{name}"), off(|ring| Some((ring.power - 1.0).abs())).unwrap_or(f64::NAN));
            let z = off(|ring| Some((ring.power - 1.0).abs() / ring.error?));
            values.number(format!("flatness.z.{name}"), z.unwrap_or(f64::NAN));
            let z = off(|ring| Some((ring.power - ring.expected?).abs() / ring.error?));
            values.number(format!("theory.z.{name}"), z.unwrap_or(f64::NAN));
            if let Some((ring, most)) = curve.anisotropies().max_by(|a, b| a.1.total_cmp(&b.1)) {
                values.number(format!("anisotropy.{name}"), most);
                values.number(format!("anisotropy.ring.{name}"), ring as f64);
            }
            // What independent directions give: each ring's variance is its mean squared, over the number of sets.
            values.number(format!("isotropic.{name}"), isotropic(curve.replicates));
            for (ring, anisotropy) in curve.anisotropies() {
                values.number(format!("anisotropy.{name}.{ring}"), anisotropy);
            }
        }
        values
    }

    fn tables(&self, _: &Spectrum, data: &Data) -> Vec<Frame> {
        let rows = || data.curves.iter().flat_map(|curve| curve.rings.iter().enumerate().map(move |one| (curve, one)));
        let frame = Frame::new("radial")
            .text("sampler", rows().map(|(curve, _)| curve.method.clone()))
            .counts("ring", rows().map(|(_, (ring, _))| ring + 1))
            .numbers("frequency", rows().map(|(_, (_, mean))| mean.frequency))
            .numbers("power", rows().map(|(_, (_, mean))| mean.power))
            .numbers("standard error", rows().map(|(_, (_, mean))| mean.error.unwrap_or(f64::NAN)))
            .numbers("expected", rows().map(|(_, (_, mean))| mean.expected.unwrap_or(f64::NAN)))
            .numbers("anisotropy", rows().map(|(_, (_, mean))| mean.anisotropy));
        vec![frame]
    }

    fn draw(&self, p: &Spectrum, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Spectrum, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Curve {
    /// The ring of the greatest power, counted from 1.
    fn peak(&self) -> Option<(usize, &Mean)> {
        (1..).zip(&self.rings).max_by(|a, b| a.1.power.total_cmp(&b.1.power))
    }

    /// The anisotropies in decibels of the rings that have one, with the rings counted from 1.
    fn anisotropies(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        (1..).zip(&self.rings).map(|(ring, mean)| (ring, mean.anisotropy)).filter(|one| one.1.is_finite())
    }
}

/// The anisotropy in decibels of a ring whose directions are as random as sets allow, averaged over so many.
fn isotropic(replicates: u32) -> f64 {
    -10.0 * portable::log10(f64::from(replicates))
}

/// Up to which frequency power counts as low.
fn low(p: &Spectrum) -> usize {
    p.low.unwrap_or_else(|| (p.n.isqrt() / 4).clamp(2, p.reach))
}

/// The spectrum of one method, averaged over its sets in their order.
fn curve(p: &Spectrum, method: &Method, placing: &Placing) -> Result<Curve, Failure> {
    let one = |replicate: usize| {
        let points = placing.points(method, p.n, replicate)?;
        let powers = power(&points, p.reach).map_err(|error| unmeasured(method, &error))?;
        let means: Vec<(usize, f64)> = powers.radial().iter().map(|ring| (ring.count, ring.mean)).collect();
        Ok((powers, means))
    };
    let replicates = replicates_of(method, p.replicates);
    let all: Vec<Result<_, Failure>> = (0..replicates).into_par_iter().map(piece(one)).collect();
    let (spectra, means): (Vec<Powers>, Vec<Vec<(usize, f64)>>) =
        all.into_iter().collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
    let averaged = Powers::average(&spectra).ok_or_else(|| Failure::of("replicates", "there is no spectrum"))?;
    // Over several rings each frequency counts once.
    let over = |rings: usize| {
        let one = |means: &Vec<(usize, f64)>| {
            let rings = &means[..rings.min(means.len())];
            let count: usize = rings.iter().map(|ring| ring.0).sum();
            rings.iter().map(|ring| ring.0 as f64 * ring.1).sum::<f64>() / count as f64
        };
        mean_with_error(&means.iter().map(one).collect::<Vec<_>>())
    };
    let exact = radial(p, |_, _| 1.0, |u, v| expected(&method.name(), p.n, u, v));
    let squares = radial(p, |u, v| f64::from(u * u + v * v), |_, _| None);
    let ring = |(index, ring): (usize, &crate::metrics::spectrum::Ring)| {
        let powers: Vec<f64> = means.iter().filter_map(|means| Some(means.get(index)?.1)).collect();
        let (power, error) = mean_with_error(&powers);
        let frequency = squares.get(index).map_or(f64::NAN, |ring| ring.0.sqrt());
        let expected = exact.get(index).and_then(|ring| ring.1);
        Mean { frequency, power, error, anisotropy: ring.anisotropy, expected }
    };
    let rings: Vec<Mean> = averaged.radial().iter().enumerate().map(ring).collect();
    Ok(Curve {
        method: method.name(),
        title: method.title(),
        replicates: replicates as u32,
        image: super::imaging::power_image(&averaged)?,
        mean: over(p.reach),
        low: over(low(p)),
        slope: slope(&rings[..low(p).min(rings.len())]),
        rings,
    })
}

/// The means over each ring of `weight` and of `known`, where all of the ring is known.
fn radial(
    p: &Spectrum,
    weight: impl Fn(i32, i32) -> f64,
    known: impl Fn(i32, i32) -> Option<f64>,
) -> Vec<(f64, Option<f64>)> {
    let reach = p.reach as i32;
    let mut rings = vec![(0.0, 0.0, Some(0.0)); p.reach + 1];
    for (u, v) in (-reach..=reach).flat_map(|v| (-reach..=reach).map(move |u| (u, v))) {
        let length = f64::from(u * u + v * v).sqrt();
        if let Some(ring) = rings.get_mut((length + 0.5) as usize) {
            *ring = (ring.0 + 1.0, ring.1 + weight(u, v), ring.2.and_then(|sum| Some(sum + known(u, v)?)));
        }
    }
    rings[1..].iter().map(|ring| (ring.1 / ring.0, ring.2.map(|sum| sum / ring.0))).collect()
}

/// The exact expectation of the power at a frequency, where it is known.
fn expected(method: &str, n: usize, u: i32, v: i32) -> Option<f64> {
    let squared_sinc = |x: f64| {
        let angle = std::f64::consts::PI * x;
        if x == 0.0 { 1.0 } else { (portable::sin(angle) / angle) * (portable::sin(angle) / angle) }
    };
    let both = |side: usize| squared_sinc(f64::from(u) / side as f64) * squared_sinc(f64::from(v) / side as f64);
    match method {
        _ if (u, v) == (0, 0) => None,
        "independent" => Some(1.0),
        "jittered" => Some(1.0 - both(n.isqrt())),
        "latin-hypercube" if u == 0 || v == 0 => Some(1.0 - both(n)),
        "latin-hypercube" => Some(1.0 + both(n) / (n as f64 - 1.0)),
        _ => None,
    }
}

/// The slope of the power at low frequencies on logarithmic axes.
fn slope(rings: &[Mean]) -> Option<(f64, Option<f64>)> {
    let positive = || rings.iter().filter(|ring| ring.power > 1e-20);
    let x: Vec<f64> = positive().map(|ring| portable::log2(ring.frequency)).collect();
    let y: Vec<f64> = positive().map(|ring| portable::log2(ring.power)).collect();
    let line = regression::least_squares(&x, &y).filter(|line| line.slope.is_finite())?;
    Some((line.slope, Some(line.slope_error).filter(|error| error.is_finite())))
}

mod drawing {
    //! The images or the lines, and their words.

    use std::fmt::Write as _;

    use super::{Curve, Data, Mean, Show, Spectrum, isotropic, low};
    use crate::chart::number::{MINUS, fixed, integer, significant};
    use crate::chart::{Axis, Chart, ChartError, Drawing, Image, Key, Line, Marker, Marks, Panel, Rule, Sheet, Style};

    pub(super) fn draw(p: &Spectrum, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let chart = match p.show {
            Show::Images => Chart::grid(data.curves.iter().map(|curve| panel(p, curve)).collect()).shared(),
            Show::Radial => Chart::new(lines(p, &data.curves).ratio(0.55)),
            Show::Logarithmic => Chart::new(logarithmic(p, data)),
            Show::Anisotropy => Chart::new(anisotropy(data)),
            Show::Both => {
                let both = |curve| [panel(p, curve), lines(p, std::slice::from_ref(curve)).ratio(1.0)];
                Chart::grid(data.curves.iter().flat_map(both).collect()).columns(2)
            }
        };
        let chart = if matches!(p.show, Show::Images | Show::Both) { chart.key(Key::Hidden) } else { chart };
        Ok(chart.draw(sheet)?.into())
    }

    /// One image, with the frequency 0 marked in its middle.
    fn panel(p: &Spectrum, curve: &Curve) -> Panel {
        let reach = p.reach as f64;
        let axis = || {
            let ends = [(-reach, format!("{MINUS}{}", p.reach)), (0.0, "0".to_owned()), (reach, p.reach.to_string())];
            let ticks = ends.into_iter().map(|(at, label)| (at, label.into())).collect();
            Axis::linear("").range(-reach - 0.5, reach + 0.5).ticks_at(ticks)
        };
        let corner = reach + 0.5;
        let centre = Marks::new(vec![(0.0, 0.0)]).style(Style::ACCENT.marker(Marker::Ring)).size(9.0);
        Panel::new(axis(), axis())
            .equal()
            .title(curve.title.as_str())
            .with(Image::new((-corner, -corner), (corner, corner), curve.image.clone()))
            .with(centre)
    }

    fn through(curve: &Curve, value: fn(&Mean) -> f64) -> Line {
        let points = curve.rings.iter().map(|ring| (ring.frequency, value(ring))).filter(|at| at.1.is_finite());
        Line::new(points.collect()).style(Style::of(&curve.method)).label(curve.title.as_str())
    }

    /// The exact expectations, named once.
    fn theory(curves: &[Curve]) -> Vec<Line> {
        let known = curves.iter().filter(|curve| curve.method != "independent");
        let lines = known.filter_map(|curve| {
            let points: Option<Vec<(f64, f64)>> =
                curve.rings.iter().map(|ring| Some((ring.frequency, ring.expected?))).collect();
            Some(Line::new(points?).style(Style::THEORY).width(1.0))
        });
        let mut lines: Vec<Line> = lines.collect();
        if let Some(last) = lines.pop() {
            lines.push(last.label("exact"));
        }
        lines
    }

    /// What is more than this of a linear axis is cut off.
    const HIGHEST: f64 = 4.0;

    fn lines(p: &Spectrum, curves: &[Curve]) -> Panel {
        let highest = curves.iter().flat_map(|curve| &curve.rings).map(|ring| ring.power).fold(1.0, f64::max);
        let power = Axis::linear("mean power").range(0.0, (highest * 1.06).clamp(1.5, HIGHEST));
        let frequency = Axis::linear("frequency").range(0.0, p.reach as f64);
        let flat = Rule::horizontal(1.0).style(Style::THEORY);
        let panel = Panel::new(frequency, power).with(flat).with_all(theory(curves));
        panel.with_all(curves.iter().map(|curve| through(curve, |ring| ring.power)))
    }

    /// Rounding alone is no power, and has no place on a logarithmic axis.
    fn logarithmic(p: &Spectrum, data: &Data) -> Panel {
        let panel = Panel::new(Axis::log2("frequency").range(1.0, p.reach as f64), Axis::log("mean power")).ratio(0.62);
        let panel = panel.with(Rule::horizontal(1.0).style(Style::THEORY)).with_all(theory(&data.curves));
        panel.with_all(data.curves.iter().map(|curve| {
            let sloped = |(slope, _)| format!("{} ({})", curve.title, fixed(slope, 2));
            let label = curve.slope.map_or_else(|| curve.title.clone(), sloped);
            through(curve, |ring| if ring.power > 1e-12 { ring.power } else { f64::NAN }).label(label)
        }))
    }

    /// Anisotropies; for independent sets the line of their number is that of no direction.
    fn anisotropy(data: &Data) -> Panel {
        let panel = Panel::new(Axis::linear("frequency").include(0.0), Axis::linear("anisotropy in dB")).ratio(0.55);
        let replicates = data.curves.iter().map(|curve| curve.replicates).max().unwrap_or(1);
        let flat = Rule::horizontal(isotropic(replicates)).style(Style::THEORY);
        let finite = |curve: &Curve| curve.rings.iter().any(|ring| ring.anisotropy.is_finite());
        let curves = data.curves.iter().filter(|curve| finite(curve));
        panel.with(flat.label("isotropic")).with_all(curves.map(|curve| through(curve, |ring| ring.anisotropy)))
    }

    pub(super) fn alt(p: &Spectrum, data: &Data) -> String {
        let mut text = format!(
            "Power spectra of {} points, averaged over {} sets, up to the frequency {} along an axis. {}",
            integer(p.n as i64),
            integer(p.replicates as i64),
            p.reach,
            match p.show {
                Show::Images => "Grey images, black for no power and white for twice that of independent points.",
                Show::Radial => "Mean power over the length of the frequency.",
                Show::Logarithmic => "Mean power over the length of the frequency, on logarithmic axes.",
                Show::Anisotropy => "Anisotropy along rings over the length of the frequency, in decibels.",
                Show::Both =>
                    "Grey images, white for twice the power of independent points, and the mean power over the frequency.",
            }
        );
        for curve in &data.curves {
            let _ =
                write!(text, " {}: mean power {} up to frequency {}", curve.title, significant(curve.low.0, 2), low(p));
            if let Some((slope, _)) = curve.slope {
                let _ = write!(text, ", with slope {}", fixed(slope, 2));
            }
            if let Some((ring, peak)) = curve.peak() {
                let _ = write!(text, "; greatest, {}, at frequency {ring}", significant(peak.power, 2));
            }
            text.push('.');
        }
        text
    }
}
