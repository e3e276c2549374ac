//! The scenes: what pictures are rendered of. One file each, and one catalogue.
//!
//! A scene is a function on a unit cube for each pixel: its axes are the place in the pixel, and, where it has them, the point of the
//! lens, the time and the point of the lamp. The mean over the cube is the pixel's colour, so that a picture is an integration for each
//! pixel. [`tracer`] computes the function, [`film`] places the samples and takes the means.

use crate::catalogue::Entry;
use tracer::World;

mod checkerboard;
mod depth_of_field;
pub mod film;
mod motion_blur;
mod soft_shadows;
pub mod tracer;

/// Every scene, in the order of display.
pub static SCENES: &[&dyn Scene] =
    &[&checkerboard::Checkerboard, &soft_shadows::SoftShadows, &depth_of_field::DepthOfField, &motion_blur::MotionBlur];

/// What a picture is rendered of.
pub trait Scene: Entry + Sync {
    /// What its axes mean, in their order: the image first, the lamp last.
    fn parts(&self) -> &'static [Part];

    /// The things, lamps and the camera.
    fn world(&self) -> World;
}

impl std::fmt::Debug for dyn Scene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.about().key)
    }
}

/// What some consecutive axes of a scene mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The place in the pixel: two axes.
    Image,
    /// The point of the lens: two axes.
    Lens,
    /// The time while the shutter is open: one axis.
    Time,
    /// The point of the lamp: two axes.
    Light,
}

impl Part {
    /// How many axes it has.
    pub fn axes(self) -> usize {
        if self == Self::Time { 1 } else { 2 }
    }
}

/// How many axes these parts have together.
pub fn axes(parts: &[Part]) -> usize {
    parts.iter().map(|part| part.axes()).sum()
}
