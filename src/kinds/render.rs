//! Pictures: a scene rendered by several samplers, beside a reference, with the errors of each.
//!
//! Every panel is the scene with n samples a pixel. Its error is the difference of its luminance, in linear light, from that of a reference of
//! many samples by another method; the error of the reference, known from its two independent halves, is taken out of the root mean square.
//!
//! Samples that are independent from pixel to pixel make errors that are independent from pixel to pixel, and such errors have a flat spectrum however
//! much their variances differ. Samples that are the same in all pixels make patterns: neighbours err alike, and the spectrum has peaks.

use serde::{Deserialize, Serialize};

use rayon::prelude::*;

use super::imaging::{self, Errors, RINGS, Radial, Randomisation, Reference, ZoneError, Zones};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::{Counts, Pair, choices, parameters};
use crate::raster::Png;
use crate::samplers::Method;
use crate::scenes::Scene;
use crate::scenes::film::{Image, Rendering, Sampling};
use crate::seed::Seed;

/// The kind `render`.
pub static RENDER: RenderKind = RenderKind;

/// The kind of experiment that renders pictures.
pub struct RenderKind;

static ABOUT: About = About {
    key: "render",
    title: "Rendered pictures",
    summary: "A scene rendered by several samplers, with a reference, differences and the spectrum of the error.",
    file: "kinds/render.rs",
    source: include_str!("render.rs"),
    papers: &[],
};

choices! {
    /// What is shown of the pictures.
    pub enum Show {
        /// The reference.
        Reference = "reference",
        /// The pictures.
        Pictures = "pictures",
        /// What differs from the reference: blue where a pixel is too dark, vermilion where it is too bright.
        Differences = "differences",
        /// The power spectrum of the differences, frequency 0 in the middle, and its radial mean.
        Spectra = "spectra",
    }
}

parameters! {
    /// What a rendering can choose.
    pub struct Render {
        /// What is rendered.
        scene: &'static dyn Scene = "soft-shadows",
        /// The samplers to compare, each with an optional scramble.
        samplers: Vec<Method> [or sampler] = ["independent", "jittered"],
        /// How many samples each pixel gets; several counts give a picture each.
        n: Counts [in 1..=65_536] = 16,
        /// How many of them are light samples of one and the same image sample; n must be a multiple.
        light: Vec<usize> [in 1..=65_536] = 1,
        /// How pixels differ in their samples; several give a picture each.
        randomisation: Vec<Randomisation> = "pixel",
        /// Whether pixel, lens, time and lamp get samples of their own each, combined at random, even if the sampler has dimensions for all.
        padded: bool = false,
        /// The pixels in a row.
        width: usize [in 8..=1024] = 192,
        /// The rows.
        height: usize [in 8..=1024] = 144,
        /// How many samples a pixel the reference has.
        reference: usize [in 2..=65_536] = 256,
        /// What is shown.
        show: Vec<Show> = ["reference", "pictures"],
        /// The columns and rows where zones begin, from the top left: the error of each is told by itself, and the differences frame it.
        zones: Option<Vec<Pair>> [in 0..=1023],
        /// How many columns and rows each zone has.
        zone: Pair [in 2..=1024] = [16, 12],
        /// How many pixels of the screen each pixel takes along an axis.
        @drawn zoom: usize [in 1..=8] = 1,
    }
}

/// The pictures.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// The mean luminance of the reference, and its root mean square error.
    reference: (f64, f64),
    /// The reference as a picture, if it is shown.
    picture: Option<Png>,
    /// The difference that is shown in full colour.
    full: f64,
    shots: Vec<Shot>,
}

/// One picture.
#[derive(Debug, Serialize, Deserialize)]
struct Shot {
    /// The method, and of what differs between shots the part of this one: `jittered.1x16`.
    name: String,
    /// The same in words.
    title: String,
    method: String,
    looks: u32,
    lights: u32,
    randomisation: String,
    padded: bool,
    errors: Errors,
    zones: Vec<ZoneError>,
    /// What is shown of it: the picture, the differences and their spectrum.
    pictures: [Option<Png>; 3],
}

/// One picture before it is rendered.
struct Plan {
    index: usize,
    sampling: Sampling,
    randomisation: Randomisation,
}

impl Kind for RenderKind {
    type Parameters = Render;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Render, problems: &mut Problems<'_, '_>) {
        for &n in p.n.as_slice() {
            if let Some(light) = p.light.iter().find(|&&light| !n.is_multiple_of(light)) {
                let message = format!("{n} samples are no multiple of {light} light samples");
                return problems.at("light", Code::Combination, message, Some("choose a divisor of n".to_owned()));
            }
        }
        for plan in plans(p) {
            if let Err(unfit) = plan.sampling.arrange(p.scene.parts()) {
                let message = format!("`{}`: {unfit}", plan.sampling.method.name());
                let help = "choose another sampler, count, split or randomisation".to_owned();
                return problems.element("samplers", plan.index, Code::Combination, message, Some(help));
            }
        }
        if let Some(Pair(left, top)) = zones(p).outside(p.height) {
            let message = format!("the zone at column {left}, row {top} is not within the picture");
            problems.at("zones", Code::OutOfRange, message, Some("move it, or make `zone` smaller".to_owned()));
        }
        if self.weight(p) > MOST {
            let message = format!("{} samples in all are too many: at most {MOST}", self.weight(p));
            problems.at("n", Code::OutOfRange, message, Some("take fewer samples, or a smaller picture".to_owned()));
        }
    }

    fn uses(&self, _: &Render) -> Vec<&'static About> {
        imaging::reference_uses()
    }

    fn weight(&self, p: &Render) -> u64 {
        let shots = p.samplers.len() * p.light.len() * p.randomisation.len();
        let samples = p.n.total().saturating_mul(shots as u64).saturating_add(p.reference as u64);
        samples.saturating_mul((p.width * p.height) as u64)
    }

    fn run(&self, p: &Render, seed: Seed) -> Result<Data, Failure> {
        let size = [p.width, p.height];
        let reference = imaging::reference(p.scene, size, p.reference)?;
        let plans = plans(p);
        let renderings: Result<Vec<Rendering>, Failure> = plans.iter().map(|plan| plan.rendering(p, seed)).collect();
        let images = imaging::images(&renderings?, size)?;
        let shots = plans.iter().zip(&images).map(|(plan, image)| shot(p, plan, image, &reference));
        let mut shots: Vec<(Shot, Vec<f64>)> = shots.collect();
        let full = 2.0 * shots.iter().map(|(shot, _)| shot.errors.rmse).fold(reference.error, f64::max);
        let packed: Result<Vec<()>, Failure> = shots
            .par_iter_mut()
            .zip(&images)
            .map(|((shot, differences), image)| shot.pack(p, image, differences, full))
            .collect();
        packed?;
        let shown = p.show.contains(&Show::Reference);
        let picture = shown.then(|| imaging::pack(size, reference.image.bytes())).transpose()?;
        let light = reference.image.luminance();
        let mean = light.iter().sum::<f64>() / light.len() as f64;
        let shots = shots.into_iter().map(|(shot, _)| shot).collect();
        Ok(Data { reference: (mean, reference.error), picture, full, shots })
    }

    fn values(&self, _: &Render, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("mean", data.reference.0);
        values.number("reference.error", data.reference.1);
        for Shot { name, errors, zones, .. } in &data.shots {
            values.estimate(format!("rmse.{name}"), errors.rmse, errors.rmse_error.unwrap_or(f64::NAN));
            values.estimate(format!("bias.{name}"), errors.bias, errors.bias_error.unwrap_or(f64::NAN));
            values.estimate(format!("neighbours.{name}"), errors.neighbours, errors.neighbours_error);
            values.estimate(format!("low.{name}"), errors.low, errors.low_error);
            values.number(format!("peak.{name}"), errors.peak);
            imaging::zone_values(&mut values, name, zones);
        }
        if let Some((first, others)) = data.shots.split_first() {
            for other in others.iter().filter(|other| other.errors.rmse > 0.0) {
                let gain = first.errors.rmse / other.errors.rmse;
                let part = |errors: &Errors| errors.rmse_error.map_or(f64::NAN, |error| error / errors.rmse);
                let (a, b) = (part(&first.errors), part(&other.errors));
                values.estimate(format!("gain.{}", other.name), gain, gain * (a * a + b * b).sqrt());
            }
        }
        if let Some(best) = data.shots.iter().min_by(|a, b| a.errors.rmse.total_cmp(&b.errors.rmse)) {
            values.text("best", best.name.as_str());
        }
        values
    }

    fn tables(&self, _: &Render, data: &Data) -> Vec<Frame> {
        let shots = || data.shots.iter();
        let errors = Frame::new("errors")
            .text("sampler", shots().map(|shot| shot.method.clone()))
            .text("randomisation", shots().map(|shot| shot.randomisation.clone()))
            .counts("image samples", shots().map(|shot| shot.looks as usize))
            .counts("light samples for each", shots().map(|shot| shot.lights as usize))
            .numbers("rmse", shots().map(|shot| shot.errors.rmse))
            .numbers("rmse standard error", shots().map(|shot| shot.errors.rmse_error.unwrap_or(f64::NAN)))
            .numbers("bias", shots().map(|shot| shot.errors.bias))
            .numbers("bias standard error", shots().map(|shot| shot.errors.bias_error.unwrap_or(f64::NAN)))
            .numbers("correlation of neighbours", shots().map(|shot| shot.errors.neighbours))
            .numbers("low power", shots().map(|shot| shot.errors.low))
            .numbers("largest power", shots().map(|shot| shot.errors.peak));
        let errors = imaging::zone_columns(errors, &shots().map(|shot| &shot.zones[..]).collect::<Vec<_>>());
        let frequencies = Frame::new("spectra").numbers("cycles a pixel", (0..RINGS).map(imaging::middle));
        let spectra = shots()
            .fold(frequencies, |frame, shot| frame.numbers(shot.name.clone(), shot.errors.rings.iter().copied()));
        vec![errors, spectra]
    }

    fn draw(&self, p: &Render, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Render, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

/// The most samples of one exhibit.
const MOST: u64 = 1 << 33;

/// The zones that are asked for.
fn zones(p: &Render) -> Zones<'_> {
    Zones { corners: p.zones.as_deref().unwrap_or_default(), size: p.zone, width: p.width }
}

/// Every picture that is asked for: for each sampler each count, split and randomisation.
fn plans(p: &Render) -> Vec<Plan> {
    let mut plans = Vec::new();
    for (index, &method) in p.samplers.iter().enumerate() {
        for n in p.n.iter() {
            for &lights in &p.light {
                for &randomisation in &p.randomisation {
                    let looks = n / lights;
                    let sampling =
                        Sampling { method, looks, lights, randomisation: randomisation.into(), padded: p.padded };
                    plans.push(Plan { index, sampling, randomisation });
                }
            }
        }
    }
    plans
}

impl Plan {
    fn rendering(&self, p: &Render, seed: Seed) -> Result<Rendering, Failure> {
        let Sampling { method, looks, lights, .. } = self.sampling;
        let seed = seed.named(ABOUT.key).named(&method.name()).at(looks as u64).at(lights as u64);
        Rendering::new(p.scene, [p.width, p.height], self.sampling, seed)
            .map_err(|unfit| Failure::of("samplers", unfit.to_string()))
    }

    /// What this picture is called among the others, as part of a value's name and in words.
    fn names(&self, p: &Render) -> (String, String) {
        let Sampling { method, looks, lights, .. } = self.sampling;
        let (mut name, mut words) = (method.name(), Vec::new());
        let mut add = |differs: bool, part: &str, word: String| {
            if differs {
                name.extend([".", part]);
                words.push(word);
            }
        };
        let n = looks * lights;
        add(p.n.as_slice().len() > 1, &n.to_string(), format!("{n} sample{}", if n == 1 { "" } else { "s" }));
        add(p.light.len() > 1, &format!("{looks}x{lights}"), format!("{looks}\u{2009}×\u{2009}{lights}"));
        add(p.randomisation.len() > 1, self.randomisation.name(), self.randomisation.title().to_owned());
        // A sampler that is the same in all pictures need not be told.
        if p.samplers.len() > 1 || words.is_empty() {
            for word in &mut words {
                *word = word.to_lowercase();
            }
            words.insert(0, method.title());
        }
        (name, words.join(", "))
    }
}

/// The errors of one picture, with the differences themselves.
fn shot(p: &Render, plan: &Plan, image: &Image, reference: &Reference) -> (Shot, Vec<f64>) {
    let differences = imaging::differences(image, reference);
    let independent = match plan.randomisation {
        Randomisation::Pixel => plan.sampling.method.is_random(),
        Randomisation::Shift | Randomisation::Diagonal => true,
        _ => false,
    };
    let errors = Errors::new(&differences, p.width, reference.error, independent);
    let (name, title) = plan.names(p);
    let shot = Shot {
        name,
        title,
        method: plan.sampling.method.name(),
        looks: plan.sampling.looks as u32,
        lights: plan.sampling.lights as u32,
        randomisation: plan.randomisation.name().to_owned(),
        padded: plan.sampling.arrange(p.scene.parts()).is_ok_and(|arrangement| arrangement.padded),
        errors,
        zones: zones(p).errors(&differences, reference, independent),
        pictures: [const { None }; 3],
    };
    (shot, differences)
}

impl Shot {
    /// Packs the pictures that are shown.
    fn pack(&mut self, p: &Render, image: &Image, differences: &[f64], full: f64) -> Result<(), Failure> {
        let size = [p.width, p.height];
        let shown = |show: Show, bytes: &dyn Fn() -> Vec<u8>| {
            p.show.contains(&show).then(|| imaging::pack(size, bytes())).transpose()
        };
        self.pictures = [
            shown(Show::Pictures, &|| image.bytes())?,
            shown(Show::Differences, &|| {
                zones(p).framed(differences.iter().flat_map(|difference| imaging::signed(difference / full)).collect())
            })?,
            shown(Show::Spectra, &|| imaging::spectrum(&self.errors.powers, size))?,
        ];
        Ok(())
    }
}

mod drawing {
    //! The pictures with their notes, and their words.

    use std::fmt::Write as _;

    use super::{Data, Png, Radial, Render, Shot, Show, imaging};
    use crate::chart::number::{fixed, significant};
    use crate::chart::{ChartError, Drawing, Figure, Picture, Pictures, Sheet};

    pub(super) fn draw(p: &Render, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut items = Vec::new();
        if let Some(png) = &data.picture {
            let note = format!("{} samples a pixel", p.reference);
            let alt = format!("{}, all but without noise.", p.scene.about().title);
            items.push(Picture::new("reference", "Reference", alt, png.clone()).note(note));
        }
        for picture in [pictures, differences, spectra] {
            items.extend(data.shots.iter().filter_map(|shot| picture(p, data, shot)));
        }
        let pictures = Pictures::new(items).zoom(p.zoom as u32);
        let chart = p.show.contains(&Show::Spectra).then(|| radial(data, sheet)).transpose()?;
        Ok(match chart {
            Some(chart) => pictures.chart(chart).into(),
            None => pictures.into(),
        })
    }

    /// One picture of a shot, if it is shown.
    fn item(shot: &Shot, which: usize, title: String, alt: String, note: String) -> Option<Picture> {
        let png: &Png = shot.pictures[which].as_ref()?;
        let name = [shot.name.as_str(), ["", "-difference", "-spectrum"][which]].concat();
        Some(Picture::new(name, title, alt, png.clone()).note(note))
    }

    fn pictures(p: &Render, _: &Data, shot: &Shot) -> Option<Picture> {
        let error = significant(shot.errors.rmse, 2);
        // What was asked for need not be told.
        let padded = if shot.padded && !p.padded { ", padded" } else { "" };
        let alt = format!(
            "{} by {}{padded}, {} samples a pixel: root mean square error {error}.",
            p.scene.about().title,
            shot.title,
            shot.looks * shot.lights
        );
        item(shot, 0, shot.title.clone(), alt, format!("RMSE {error}{padded}"))
    }

    fn differences(_: &Render, data: &Data, shot: &Shot) -> Option<Picture> {
        let bias = significant(shot.errors.bias, 2);
        let alt = format!("What {} differs from the reference: on average by {bias}.", shot.title);
        let first = data.shots.first().is_some_and(|first| first.name == shot.name);
        let colours = if first { "; blue is too dark, red too bright" } else { "" };
        let note = format!("full colour at ±{}{colours}", significant(data.full, 2));
        item(shot, 1, format!("{}: error", shot.title), alt, note)
    }

    fn spectra(_: &Render, _: &Data, shot: &Shot) -> Option<Picture> {
        let peak = significant(shot.errors.peak, 2);
        let alt = format!("The power spectrum of the error of {}: the largest power is {peak}.", shot.title);
        let note = format!("largest power {peak}; correlation of neighbours {}", fixed(shot.errors.neighbours, 2));
        item(shot, 2, format!("{}: spectrum", shot.title), alt, note)
    }

    /// The radial means of the spectra.
    fn radial(data: &Data, sheet: &Sheet) -> Result<Figure, ChartError> {
        let lines = data.shots.iter().map(|shot| Radial {
            title: &shot.title,
            method: &shot.method,
            rings: &shot.errors.rings,
        });
        imaging::radial(&lines.collect::<Vec<_>>(), sheet)
    }

    pub(super) fn alt(p: &Render, data: &Data) -> Option<String> {
        let mut text = format!("{}, {} by {} pixels.", p.scene.about().title, p.width, p.height);
        for shot in &data.shots {
            let _ = write!(text, " {}: root mean square error {}", shot.title, significant(shot.errors.rmse, 2));
            if p.show.contains(&Show::Spectra) {
                let correlation = fixed(shot.errors.neighbours, 2);
                let _ = write!(text, ", neighbouring errors correlate by {correlation}");
            }
            text.push('.');
        }
        let first = data.shots.first()?;
        let best = data.shots.iter().min_by(|a, b| a.errors.rmse.total_cmp(&b.errors.rmse))?;
        if best.name != first.name && best.errors.rmse > 0.0 {
            let gain = significant(first.errors.rmse / best.errors.rmse, 2);
            let _ = write!(text, " The error of {} is {gain} times smaller than that of {}.", best.title, first.title);
        }
        Some(text)
    }
}
