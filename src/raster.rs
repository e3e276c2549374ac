//! Rasters: pictures of eight bits a channel, and their PNG files.
//!
//! The PNG of a raster is made once, when the experiment runs, and kept with its result: packing a picture takes longer than
//! all other drawing.

use std::fmt;

use base64::Engine as _;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};
use serde::{Deserialize, Serialize};

/// The pixels of a picture, in rows from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Pixels {
    /// One byte a pixel: sRGB grey from black to white.
    Grey(Vec<u8>),
    /// Three bytes a pixel: sRGB red, green and blue.
    Colour(Vec<u8>),
}

/// A picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Raster {
    /// The pixels in a row.
    pub width: u32,
    /// The rows.
    pub height: u32,
    /// The pixels.
    pub pixels: Pixels,
}

/// A PNG file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Png {
    /// The pixels in a row.
    pub width: u32,
    /// The rows.
    pub height: u32,
    /// The file.
    pub bytes: Vec<u8>,
}

impl Png {
    /// The file in Base64, as a `data:` address holds it.
    pub fn base64(&self) -> String {
        base64::prelude::BASE64_STANDARD.encode(&self.bytes)
    }
}

/// The most pixels of a picture: beyond it no reader's screen and no page is served.
pub const MOST_PIXELS: u64 = 1 << 24;

/// Why a raster is no picture.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum RasterError {
    /// The picture has no pixel, too many, or not as many bytes as its size says.
    Size {
        /// The pixels in a row.
        width: u32,
        /// The rows.
        height: u32,
        /// The bytes that there are.
        bytes: usize,
    },
    /// The encoder failed.
    Encoding(String),
}

impl fmt::Display for RasterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { width, height, bytes } => {
                write!(f, "{bytes} bytes are no picture of {width} x {height} pixels (at most {MOST_PIXELS})")
            }
            Self::Encoding(message) => write!(f, "the picture cannot be packed: {message}"),
        }
    }
}

impl std::error::Error for RasterError {}

impl Raster {
    /// A picture in grey: `pixels[y * width + x]`.
    pub fn grey(width: u32, height: u32, pixels: Vec<u8>) -> Self {
        Self { width, height, pixels: Pixels::Grey(pixels) }
    }

    /// A picture in colour: red, green and blue of each pixel in turn.
    pub fn colour(width: u32, height: u32, pixels: Vec<u8>) -> Self {
        Self { width, height, pixels: Pixels::Colour(pixels) }
    }

    /// The picture as a PNG file: the smaller of what two filters give, with the same bytes everywhere.
    ///
    /// # Errors
    /// If the size is not that of the pixels, or is 0, or is more than [`MOST_PIXELS`].
    pub fn png(&self) -> Result<Png, RasterError> {
        let (bytes, colour, channels) = match &self.pixels {
            Pixels::Grey(bytes) => (bytes, ExtendedColorType::L8, 1),
            Pixels::Colour(bytes) => (bytes, ExtendedColorType::Rgb8, 3),
        };
        let count = u64::from(self.width) * u64::from(self.height);
        if count == 0 || count > MOST_PIXELS || bytes.len() as u64 != count * channels {
            return Err(RasterError::Size { width: self.width, height: self.height, bytes: bytes.len() });
        }
        let encode = |filter| -> Result<Vec<u8>, RasterError> {
            let mut out = Vec::new();
            PngEncoder::new_with_quality(&mut out, CompressionType::Best, filter)
                .write_image(bytes, self.width, self.height, colour)
                .map_err(|error| RasterError::Encoding(error.to_string()))?;
            Ok(out)
        };
        // Noise is smallest without a filter, smooth shades with one.
        let (plain, adaptive) = (encode(FilterType::NoFilter)?, encode(FilterType::Adaptive)?);
        let bytes = if plain.len() <= adaptive.len() { plain } else { adaptive };
        Ok(Png { width: self.width, height: self.height, bytes })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_png_holds_the_pixels() {
        let pixels: Vec<u8> = (0..3 * 5 * 4).map(|at| (at * 37 % 251) as u8).collect();
        let png = Raster::colour(5, 4, pixels.clone()).png().unwrap();
        let read = image::load_from_memory(&png.bytes).unwrap().to_rgb8();
        assert_eq!((read.width(), read.height()), (5, 4));
        assert_eq!(read.into_raw(), pixels);
        let grey: Vec<u8> = (0..=255).collect();
        let png = Raster::grey(16, 16, grey.clone()).png().unwrap();
        assert_eq!(image::load_from_memory(&png.bytes).unwrap().to_luma8().into_raw(), grey);
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        assert!(Raster::grey(2, 2, vec![0; 3]).png().is_err());
        assert!(Raster::grey(0, 2, Vec::new()).png().is_err());
        assert!(Raster::colour(u32::MAX, u32::MAX, Vec::new()).png().is_err());
    }
}
