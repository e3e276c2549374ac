//! Images in linear light, their luminance, and what a screen needs: eight bits on the curve of sRGB.

use crate::scenes::tracer::Colour;
use crate::stats::portable;

/// Linear red, green and blue for each pixel, row by row from the top; 1 is the white of the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// How many columns.
    pub width: usize,
    /// How many rows.
    pub height: usize,
    /// `width x height` colours.
    pub pixels: Vec<Colour>,
}

impl Image {
    /// The luminance Y of each pixel: 0.2126 R + 0.7152 G + 0.0722 B (ITU-R BT.709).
    pub fn luminance(&self) -> Vec<f64> {
        self.pixels.iter().map(|colour| luminance(*colour)).collect()
    }

    /// Eight bits a channel, red, green, blue, red, ..: see [`encode`].
    pub fn bytes(&self) -> Vec<u8> {
        self.pixels.iter().flat_map(|colour| [encode(colour.x), encode(colour.y), encode(colour.z)]).collect()
    }
}

/// The luminance of a colour.
pub fn luminance(colour: Colour) -> f64 {
    0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z
}

/// A linear value in eight bits on the curve of sRGB (IEC 61966-2-1), rounded; below 0 is 0, above 1 is 255, and what is no number is 0.
pub fn encode(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let curved = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * portable::pow(linear, 1.0 / 2.4) - 0.055 };
    (255.0 * curved + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of the standard, by its inverse: the linear value of each code is coded as that code.
    #[test]
    fn every_code_is_reached_by_its_linear_value() {
        for code in 0..=255_u8 {
            let curved = f64::from(code) / 255.0;
            let linear = if curved <= 0.040_45 { curved / 12.92 } else { portable::pow((curved + 0.055) / 1.055, 2.4) };
            assert_eq!(encode(linear), code);
        }
        assert_eq!((encode(-1.0), encode(2.0), encode(f64::NAN)), (0, 255, 0));
    }

    #[test]
    fn white_has_luminance_one() {
        assert!((luminance(Colour::grey(1.0)) - 1.0).abs() < 1e-15);
    }
}
