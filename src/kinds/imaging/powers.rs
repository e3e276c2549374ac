//! A spectrum as an image.

use crate::kinds::Failure;
use crate::metrics::spectrum::Spectrum;
use crate::raster::{Png, Raster};

/// Shades of grey in an image: enough to see, few enough to pack well.
const SHADES: f64 = 32.0;

/// The powers as shades: 0 black, 2 and more white; the frequency 0 black.
pub fn power_image(powers: &Spectrum) -> Result<Png, Failure> {
    let reach = powers.reach() as i32;
    let shade = |(u, v): (i32, i32)| {
        let share = if (u, v) == (0, 0) { 0.0 } else { (powers.at(u, v) / 2.0).clamp(0.0, 1.0) };
        ((share * (SHADES - 1.0)).round() * 255.0 / (SHADES - 1.0)).round() as u8
    };
    let places = (-reach..=reach).rev().flat_map(|v| (-reach..=reach).map(move |u| (u, v)));
    let side = 2 * powers.reach() as u32 + 1;
    let raster = Raster::grey(side, side, places.map(shade).collect());
    raster.png().map_err(|error| Failure::of("reach", error.to_string()))
}
