//! Averaging: what the mean of R runs gains if the runs are copies of each other, and if each is randomised anew.
//!
//! A low-discrepancy sequence is the same every time: the mean of R identical runs is one run, and its error stays. Runs that are randomised independently
//! have independent errors, whose mean falls like R^(-1/2) if they are unbiased.
//!
//! What runs is the estimate of an integral, or the rendering of a scene. Of an integral, the root mean square is over the
//! replicates; of a picture, over the pixels, and the error of the reference is taken out.

use serde::{Deserialize, Serialize};

use super::estimation::{Study, check_dimensions, dimensions, mean_with_error, reference};
use super::imaging::{self, Reference};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{Counts, parameters};
use crate::samplers::Method;
use crate::scenes::Scene;
use crate::scenes::film::{Randomisation, Rendering, Sampling};
use crate::seed::Seed;
use crate::stats::{portable, regression};

/// The kind `averaging`.
pub static AVERAGING: AveragingKind = AveragingKind;

/// The kind of experiment that averages repeated runs.
pub struct AveragingKind;

static ABOUT: About = About {
    key: "averaging",
    title: "Averaging of runs",
    summary: "The error of the mean of R runs, identical or randomised anew, of an integral or a rendered picture.",
    file: "kinds/averaging.rs",
    source: include_str!("averaging.rs"),
    papers: &[],
};

parameters! {
    /// What an averaging of runs can choose.
    pub struct Averaging {
        /// The samplers, each with an optional scramble.
        samplers: Vec<Method> [or sampler],
        /// What is integrated; either this or a scene.
        integrand: Option<Function>,
        /// What is rendered; either this or an integrand.
        scene: Option<&'static dyn Scene>,
        /// How many points each run has; of a scene, how many samples a pixel.
        n: usize [in 1..=1_048_576] = 16,
        /// How many runs are averaged.
        runs: Counts [in 1..=4096] = "2^0..2^6",
        /// Over how many independent repetitions the error of an integral is measured.
        replicates: usize [in 2..=100_000] = 64,
        /// The dimensions of an integrand, at least those of the formula, which are the default.
        dimensions: Option<usize> [in 1..=64],
        /// The pixels in a row of a picture.
        width: usize [in 8..=512] = 64,
        /// The rows of a picture.
        height: usize [in 8..=512] = 48,
        /// How many samples a pixel the reference of a picture has.
        reference: usize [in 2..=65_536] = 1024,
    }
}

/// The errors of every sampler.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    curves: Vec<Curve>,
}

/// The errors of one sampler: of identical runs and of randomised ones.
#[derive(Debug, Serialize, Deserialize)]
struct Curve {
    method: String,
    title: String,
    identical: Series,
    randomised: Series,
}

/// The error over the number of runs.
#[derive(Debug, Serialize, Deserialize)]
struct Series {
    marks: Vec<Mark>,
    /// The slope of log2 of the error over log2 of the runs, with its standard error.
    slope: Option<(f64, Option<f64>)>,
}

/// The error of the mean of some runs.
#[derive(Debug, Serialize, Deserialize)]
struct Mark {
    runs: u64,
    rmse: f64,
    rmse_error: Option<f64>,
}

impl Kind for AveragingKind {
    type Parameters = Averaging;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Averaging) {
        p.dimensions = p.integrand.as_ref().map(|integrand| dimensions(integrand, p.dimensions));
    }

    fn check(&self, p: &Averaging, problems: &mut Problems<'_, '_>) {
        match (&p.integrand, p.scene) {
            (Some(integrand), None) => {
                check_dimensions(integrand, p.dimensions, problems);
                problems.admit("samplers", &p.samplers, &[p.n], dimensions(integrand, p.dimensions));
            }
            (None, Some(scene)) => {
                for (index, &method) in p.samplers.iter().enumerate() {
                    if let Err(unfit) = sampling(p, method).arrange(scene.parts()) {
                        let message = format!("`{}`: {unfit}", method.name());
                        problems.element("samplers", index, Code::Combination, message, None);
                    }
                }
            }
            _ => {
                let help = Some("name an integrand, or a scene".to_owned());
                problems.at("integrand", Code::Combination, "either an integrand or a scene is averaged", help);
            }
        }
        if self.weight(p) > MOST {
            let message = format!("{} samples in all are too many: at most {MOST}", self.weight(p));
            problems.at("runs", Code::OutOfRange, message, Some("take fewer runs or samples".to_owned()));
        }
    }

    fn uses(&self, p: &Averaging) -> Vec<&'static About> {
        if p.scene.is_some() { imaging::reference_uses() } else { Vec::new() }
    }

    fn weight(&self, p: &Averaging) -> u64 {
        let one = (p.n as u64).saturating_mul(p.runs.largest() as u64).saturating_mul(p.samplers.len() as u64);
        if p.scene.is_some() {
            one.saturating_add(p.reference as u64).saturating_mul((p.width * p.height) as u64)
        } else {
            one.saturating_mul(p.replicates as u64)
        }
    }

    fn run(&self, p: &Averaging, seed: Seed) -> Result<Data, Failure> {
        let curves = match (&p.integrand, p.scene) {
            (Some(integrand), _) => integrals(p, integrand, seed),
            (None, Some(scene)) => pictures(p, scene, seed),
            (None, None) => Err(Failure::of("integrand", "there is nothing to average")),
        };
        Ok(Data { curves: curves? })
    }

    fn values(&self, _: &Averaging, data: &Data) -> Values {
        let mut values = Values::new();
        for curve in &data.curves {
            for (way, series) in curve.ways() {
                let name = format!("{way}.{}", curve.method);
                for mark in &series.marks {
                    let error = mark.rmse_error.unwrap_or(f64::NAN);
                    values.estimate(format!("rmse.{name}.{}", mark.runs), mark.rmse, error);
                }
                if let Some((slope, error)) = series.slope {
                    values.estimate(format!("slope.{name}"), slope, error.unwrap_or(f64::NAN));
                }
            }
            if let (Some(alone), Some(together)) = (curve.identical.marks.last(), curve.randomised.marks.last()) {
                values.number(format!("gain.{}", curve.method), alone.rmse / together.rmse);
            }
        }
        values
    }

    fn tables(&self, _: &Averaging, data: &Data) -> Vec<Frame> {
        let rows = || {
            let series = data.curves.iter().flat_map(|curve| curve.ways().map(|(way, series)| (curve, way, series)));
            series.flat_map(|(curve, way, series)| series.marks.iter().map(move |mark| (curve, way, mark)))
        };
        let frame = Frame::new("rmse")
            .text("sampler", rows().map(|(curve, ..)| curve.method.clone()))
            .text("runs are", rows().map(|(_, way, _)| way.to_owned()))
            .counts("runs", rows().map(|(.., mark)| mark.runs as usize))
            .numbers("rmse", rows().map(|(.., mark)| mark.rmse))
            .numbers("rmse standard error", rows().map(|(.., mark)| mark.rmse_error.unwrap_or(f64::NAN)));
        vec![frame]
    }

    fn draw(&self, _: &Averaging, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(data, sheet)
    }

    fn alt(&self, p: &Averaging, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

/// The most samples of one exhibit.
const MOST: u64 = 1 << 33;

impl Curve {
    /// The errors of both ways, each with its name.
    fn ways(&self) -> [(&'static str, &Series); 2] {
        [("identical", &self.identical), ("randomised", &self.randomised)]
    }
}

impl Series {
    /// The errors over the counts of runs, each a mean square with its standard error.
    fn new(p: &Averaging, mut square: impl FnMut(usize) -> (f64, Option<f64>)) -> Self {
        let mark = |runs: usize| {
            let (square, error) = square(runs);
            let rmse = square.sqrt();
            let rmse_error = error.filter(|_| rmse > 0.0).map(|error| error / (2.0 * rmse));
            Mark { runs: runs as u64, rmse, rmse_error }
        };
        let marks: Vec<Mark> = p.runs.iter().map(mark).collect();
        let seen: Vec<&Mark> = marks.iter().filter(|mark| mark.rmse > 0.0).collect();
        let x: Vec<f64> = seen.iter().map(|mark| portable::log2(mark.runs as f64)).collect();
        let y: Vec<f64> = seen.iter().map(|mark| portable::log2(mark.rmse)).collect();
        let line = regression::least_squares(&x, &y);
        let slope = line.map(|line| (line.slope, Some(line.slope_error).filter(|error| error.is_finite())));
        Self { marks, slope }
    }
}

/// The errors of averaged estimates of an integral.
fn integrals(p: &Averaging, integrand: &Function, seed: Seed) -> Result<Vec<Curve>, Failure> {
    let d = dimensions(integrand, p.dimensions);
    let exact = reference(integrand, d)?.value;
    let study = Study { kind: ABOUT.key, integrand, d, seed };
    let most = p.runs.largest();
    let all = study.estimates(&p.samplers, &[p.n], most * p.replicates)?;
    let curve = |(method, estimates): (&Method, Vec<Vec<f64>>)| {
        let estimates = estimates.concat();
        // A method that no seed changes has one estimate: all its runs are that.
        let groups: Vec<&[f64]> = estimates.chunks(most).collect();
        let squares = |runs: usize, identical: bool| {
            let error = |group: &&[f64]| {
                let taken = if identical { &group[..1] } else { &group[..runs.min(group.len())] };
                let gap = taken.iter().sum::<f64>() / taken.len() as f64 - exact;
                gap * gap
            };
            mean_with_error(&groups.iter().map(error).collect::<Vec<_>>())
        };
        Curve {
            method: method.name(),
            title: method.title(),
            identical: Series::new(p, |runs| squares(runs, true)),
            randomised: Series::new(p, |runs| squares(runs, false)),
        }
    };
    Ok(p.samplers.iter().zip(all).map(curve).collect())
}

/// How a picture's samples are taken.
fn sampling(p: &Averaging, method: Method) -> Sampling {
    Sampling { method, looks: p.n, lights: 1, randomisation: Randomisation::Pixel, padded: false }
}

/// The errors of averaged pictures.
fn pictures(p: &Averaging, scene: &'static dyn Scene, seed: Seed) -> Result<Vec<Curve>, Failure> {
    let reference = imaging::reference(scene, [p.width, p.height], p.reference)?;
    p.samplers.iter().map(|&method| pixels(p, scene, method, &reference, seed)).collect()
}

/// The errors of averaged pictures by one method.
fn pixels(
    p: &Averaging,
    scene: &'static dyn Scene,
    method: Method,
    reference: &Reference,
    seed: Seed,
) -> Result<Curve, Failure> {
    let size = [p.width, p.height];
    let seed = seed.named(ABOUT.key).named(&method.name()).at(p.n as u64);
    let square = |errors: &[f64], runs: usize| {
        let squares: Vec<f64> = errors.iter().map(|error| error / runs as f64).map(|error| error * error).collect();
        let (square, error) = mean_with_error(&squares);
        ((square - reference.error * reference.error).max(0.0), error)
    };
    let runs = if method.is_random() { p.runs.largest() } else { 1 };
    let mut sums = vec![0.0; p.width * p.height];
    let mut first = Vec::new();
    let mut squares = Vec::new();
    for run in 0..runs {
        let rendering = Rendering::new(scene, size, sampling(p, method), seed.at(run as u64))
            .map_err(|unfit| Failure::of("samplers", unfit.to_string()))?;
        for image in imaging::images(&[rendering], size)? {
            let errors = imaging::differences(&image, reference);
            sums.iter_mut().zip(&errors).for_each(|(sum, error)| *sum += error);
            if run == 0 {
                first = errors;
            }
        }
        squares.push(square(&sums, run + 1));
    }
    let alone = square(&first, 1);
    Ok(Curve {
        method: method.name(),
        title: method.title(),
        identical: Series::new(p, |_| alone),
        randomised: Series::new(p, |runs| squares.get(runs - 1).copied().unwrap_or(alone)),
    })
}

mod drawing {
    //! The errors over the number of runs, and their words.

    use std::fmt::Write as _;

    use super::{Averaging, Curve, Data, Series};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Chart, ChartError, Dash, Drawing, Key, Line, Panel, Sheet, Style};

    pub(super) fn draw(data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let panel = Panel::new(Axis::log2("runs averaged, *R*"), Axis::log("RMSE of the mean")).ratio(0.62);
        let lines = data.curves.iter().flat_map(|curve| {
            let style = Style::of(&curve.method);
            let identical = line(curve, &curve.identical, "identical", style.dash(Dash::Dotted));
            [identical, line(curve, &curve.randomised, "randomised", style.dash(Dash::Solid))]
        });
        let panel = panel.with_all(root(data)).with_all(lines);
        Ok(Chart::new(panel).key(Key::Above).draw(sheet)?.into())
    }

    fn line(curve: &Curve, series: &Series, way: &str, style: Style) -> Line {
        let marks = series.marks.iter().filter(|mark| mark.rmse > 0.0);
        let slope = series.slope.map(|(slope, _)| format!(" ({})", fixed(slope, 2))).unwrap_or_default();
        let points = marks.map(|mark| (mark.runs as f64, mark.rmse)).collect();
        Line::new(points).style(style).marked().label(format!("{}, {way}{slope}", curve.title))
    }

    /// The slope -1/2 through the highest first error.
    fn root(data: &Data) -> Option<Line> {
        let ends = data.curves.iter().filter_map(|curve| {
            let marks = &curve.randomised.marks;
            Some((marks.first()?, marks.last()?))
        });
        let (first, last) = ends.max_by(|a, b| a.0.rmse.total_cmp(&b.0.rmse))?;
        let (from, to) = (first.runs as f64, last.runs as f64);
        let drawn = to > from && first.rmse > 0.0;
        drawn.then(|| Line::power(from, 1.25 * first.rmse, -0.5, to).label("slope −1/2"))
    }

    pub(super) fn alt(p: &Averaging, data: &Data) -> Option<String> {
        let what = match (&p.integrand, p.scene) {
            (Some(integrand), _) => format!("estimates of the integral of {}", integrand.text()),
            (None, Some(scene)) => format!("pictures of the scene {}", scene.about().title),
            (None, None) => return None,
        };
        let mut text = format!("The root mean square error of the mean of R {what}, on logarithmic axes.");
        for curve in &data.curves {
            let (Some(alone), Some(last)) = (curve.identical.marks.last(), curve.randomised.marks.last()) else {
                continue;
            };
            let _ = write!(
                text,
                " {}: identical runs stay at {}; {} randomised ones come to {}",
                curve.title,
                significant(alone.rmse, 2),
                integer(last.runs as i64),
                significant(last.rmse, 2),
            );
            if let Some((slope, _)) = curve.randomised.slope {
                let _ = write!(text, ", slope {}", fixed(slope, 2));
            }
            text.push('.');
        }
        Some(text)
    }
}
