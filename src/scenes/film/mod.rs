//! The film: which samples each pixel gets, and the image that their means make.

mod image;
mod render;
mod sampling;

pub use image::{Image, encode, luminance};
pub use render::Rendering;
pub use sampling::{Arrangement, Pixels, Randomisation, Samples, Sampling, Unfit};

#[cfg(test)]
mod tests;
