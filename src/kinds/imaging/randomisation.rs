//! How pixels differ in their samples, as a chapter asks for it.

use crate::parameters::choices;
use crate::scenes::film;

choices! {
    /// How the samples of one pixel relate to those of the others.
    pub enum Randomisation {
        /// Right: each pixel has a seed of its own.
        Pixel = "pixel",
        /// Right: one set, shifted on the torus by random numbers of each pixel's own.
        Shift = "shift",
        /// Right: one sequence for the image, each pixel taking the points that fall into it (`halton` or `sobol`).
        Sequence = "sequence",
        /// Wrong: the same points in every pixel.
        Same = "same",
        /// Wrong: shifts that repeat in every tile of 8 x 8 pixels.
        Tiled = "tiled",
        /// Wrong: one random number a pixel, the shift of every axis.
        Diagonal = "diagonal",
    }
}

impl From<Randomisation> for film::Randomisation {
    fn from(randomisation: Randomisation) -> Self {
        match randomisation {
            Randomisation::Pixel => Self::Pixel,
            Randomisation::Shift => Self::Shift,
            Randomisation::Sequence => Self::Sequence,
            Randomisation::Same => Self::Same,
            Randomisation::Tiled => Self::Tiled,
            Randomisation::Diagonal => Self::Diagonal,
        }
    }
}

impl Randomisation {
    /// The word that a chapter uses.
    pub fn name(self) -> &'static str {
        self.word()
    }

    /// It as the title of a picture.
    pub fn title(self) -> &'static str {
        match self {
            Self::Pixel => "A seed for each pixel",
            Self::Shift => "A shift for each pixel",
            Self::Sequence => "One sequence",
            Self::Same => "The same in all pixels",
            Self::Tiled => "The same in all tiles",
            Self::Diagonal => "One shift for all axes",
        }
    }
}
