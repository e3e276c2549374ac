//! Imaging: pictures in parallel, the reference that many share, and what their errors are like.

mod errors;
mod powers;
mod radial;
mod randomisation;
mod shades;
mod zones;

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use rayon::prelude::*;

use super::experiment::{Failure, piece};
use crate::catalogue::About;
use crate::raster::{Png, Raster};
use crate::samplers::Method;
use crate::scenes::Scene;
use crate::scenes::film::{self, Image, Rendering, Sampling, Unfit};
use crate::scenes::tracer::Colour;
use crate::seed::Seed;
use crate::stats::moments;

pub use errors::{Errors, RINGS};
pub use powers::power_image;
pub use radial::{Radial, middle, radial};
pub use randomisation::Randomisation;
pub use shades::{signed, spectrum};
pub use zones::{ZoneError, Zones, zone_columns, zone_values};

/// The sampler of references: the best of those that are fast.
const REFERENCE: &str = "sobol+owen-hash";

/// The members of catalogues that a reference uses.
pub fn reference_uses() -> Vec<&'static About> {
    Method::parse(REFERENCE).map(|method| method.abouts()).unwrap_or_default()
}

/// What a picture should be.
pub struct Reference {
    /// The mean of two images that are independent of each other and of all else.
    pub image: Image,
    /// The root mean square error of a pixel's luminance, from the difference of the two.
    pub error: f64,
    /// By how much the luminances of the two differ.
    pub gaps: Vec<f64>,
}

/// A row of each of the two images.
type Row = Result<[Vec<Colour>; 2], Unfit>;

/// The two halves of a reference, and their rows as far as they are known.
struct Halves {
    halves: [Rendering; 2],
    rows: Vec<OnceLock<Row>>,
}

/// A scene, a width, a height and samples a pixel.
type Address = (&'static str, usize, usize, usize);

/// The references of this process. They depend on their address alone, so that pictures of one scene share them.
static REFERENCES: Mutex<BTreeMap<Address, Arc<Halves>>> = Mutex::new(BTreeMap::new());

/// The most references that are kept.
const MOST: usize = 16;

/// The reference of a scene with `samples` a pixel, at the `size` of width and height.
pub fn reference(scene: &'static dyn Scene, size: [usize; 2], samples: usize) -> Result<Reference, Failure> {
    let shared = halves(scene, size, samples)?;
    // A row is computed by whoever needs it first, on one thread: who waits for it waits a moment, and never for itself.
    let rows =
        |row: usize| shared.rows[row].get_or_init(|| Ok([shared.halves[0].row(row)?, shared.halves[1].row(row)?]));
    let rows: Result<Vec<_>, _> = (0..size[1]).into_par_iter().map(piece(|row| rows(row).as_ref())).collect();
    let rows = rows.map_err(|unfit| Failure::of("reference", unfit.to_string()))?;
    let flat = |half: usize| -> Vec<Colour> { rows.iter().flat_map(|row| row[half].iter().copied()).collect() };
    let [first, second] = [flat(0), flat(1)].map(|pixels| Image { width: size[0], height: size[1], pixels });
    let gaps: Vec<f64> = first.luminance().iter().zip(second.luminance()).map(|(a, b)| a - b).collect();
    let pixels = first.pixels.iter().zip(&second.pixels).map(|(&a, &b)| (a + b) * 0.5).collect();
    Ok(Reference { image: Image { pixels, ..first }, error: 0.5 * moments::root_mean_square(&gaps), gaps })
}

fn halves(scene: &'static dyn Scene, size: [usize; 2], samples: usize) -> Result<Arc<Halves>, Failure> {
    let failure = |message: String| Failure::of("reference", message);
    let address = (scene.about().key, size[0], size[1], samples);
    let mut references = REFERENCES.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(halves) = references.get(&address) {
        return Ok(Arc::clone(halves));
    }
    let method = Method::parse(REFERENCE).map_err(|error| failure(error.to_string()))?;
    let looks = (samples / 2).max(1);
    let sampling = Sampling { method, looks, lights: 1, randomisation: film::Randomisation::Pixel, padded: false };
    // Not the experiment's seed: a reference belongs to its scene.
    let seed = Seed::new(0).named("reference").named(address.0);
    let half =
        |which: u64| Rendering::new(scene, size, sampling, seed.at(which)).map_err(|unfit| failure(unfit.to_string()));
    let rows = (0..size[1]).map(|_| OnceLock::new()).collect();
    let halves = Arc::new(Halves { halves: [half(0)?, half(1)?], rows });
    if references.len() >= MOST {
        references.pop_first();
    }
    references.insert(address, Arc::clone(&halves));
    Ok(halves)
}

/// The images of several renderings of one size, row by row in parallel and put together by index.
pub fn images(renderings: &[Rendering], size: [usize; 2]) -> Result<Vec<Image>, Failure> {
    let tasks: Vec<(usize, usize)> =
        (0..renderings.len()).flat_map(|k| (0..size[1]).map(move |row| (k, row))).collect();
    let rows: Result<Vec<_>, _> =
        tasks.par_iter().map(piece(|&(k, row): &(usize, usize)| renderings[k].row(row))).collect();
    let rows = rows.map_err(|unfit| Failure::of("samplers", unfit.to_string()))?;
    let image = |rows: &[Vec<Colour>]| Image { width: size[0], height: size[1], pixels: rows.concat() };
    Ok(rows.chunks(size[1].max(1)).map(image).collect())
}

/// The errors of an image's luminance.
pub fn differences(image: &Image, reference: &Reference) -> Vec<f64> {
    image.luminance().iter().zip(reference.image.luminance()).map(|(is, should)| is - should).collect()
}

/// A picture of three bytes a pixel as a file.
pub fn pack(size: [usize; 2], bytes: Vec<u8>) -> Result<Png, Failure> {
    let raster = Raster::colour(size[0] as u32, size[1] as u32, bytes);
    raster.png().map_err(|error| Failure::of("width", error.to_string()))
}
