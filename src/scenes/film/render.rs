//! Rendering: the mean of a scene over each pixel, row by row.

use super::sampling::{Pixels, Sampling, Unfit};
use super::{Image, Samples};
use crate::scenes::tracer::{Colour, Look, World};
use crate::scenes::{Part, Scene};
use crate::seed::Seed;

/// A scene, the size of its image and the samples of every pixel.
pub struct Rendering {
    world: World,
    size: [usize; 2],
    pixels: Pixels,
    /// Where the axes of each part begin in a look.
    lens: Option<usize>,
    time: Option<usize>,
    light: Option<usize>,
    lights: usize,
}

impl Rendering {
    /// Prepares an image of `size` (width and height in pixels), with the samples that `sampling` and `seed` give.
    pub fn new(scene: &dyn Scene, size: [usize; 2], sampling: Sampling, seed: Seed) -> Result<Self, Unfit> {
        let pixels = Pixels::new(sampling, scene.parts(), size, seed)?;
        let place = |wanted: Part| {
            let before: Vec<Part> = scene.parts().iter().copied().take_while(|part| *part != wanted).collect();
            let first = crate::scenes::axes(&before);
            (first < pixels.axes()).then_some(first)
        };
        Ok(Self {
            world: scene.world(),
            size,
            lens: place(Part::Lens),
            time: place(Part::Time),
            light: place(Part::Light),
            pixels,
            lights: sampling.lights,
        })
    }

    /// The colours of one row of pixels, the first row being the top.
    pub fn row(&self, row: usize) -> Result<Vec<Colour>, Unfit> {
        let mut seen = Vec::new();
        (0..self.size[0])
            .map(|column| Ok(self.pixel(column, row, &self.pixels.samples(column, row)?, &mut seen)))
            .collect()
    }

    /// The whole image.
    pub fn image(&self) -> Result<Image, Unfit> {
        let rows: Result<Vec<_>, _> = (0..self.size[1]).map(|row| self.row(row)).collect();
        Ok(Image { width: self.size[0], height: self.size[1], pixels: rows?.concat() })
    }

    /// The mean over the samples of one pixel; `seen` is room for the things in it.
    fn pixel(&self, column: usize, row: usize, samples: &Samples, seen: &mut Vec<usize>) -> Colour {
        let [width, height] = self.size.map(|side| side as f64);
        let corner = [column as f64, row as f64];
        let middle = [(corner[0] + 0.5) / width, (corner[1] + 0.5) / height];
        self.world.see(middle, [1.0 / width, 1.0 / height], width / height, seen);
        let axes = self.pixels.axes();
        let mut sum = Colour::default();
        for (k, point) in samples.looks.chunks_exact(axes).enumerate() {
            let pair = |first: Option<usize>| first.map_or([0.5, 0.5], |first| [point[first], point[first + 1]]);
            let look = Look {
                image: [(corner[0] + point[0]) / width, (corner[1] + point[1]) / height],
                lens: pair(self.lens),
                time: self.time.map_or(0.0, |first| point[first]),
            };
            let lights = match self.light {
                Some(first) => &point[first..first + 2],
                None => samples.lights.get(k * 2 * self.lights..(k + 1) * 2 * self.lights).unwrap_or_default(),
            };
            sum = sum + self.world.radiance(&look, width / height, lights, seen);
        }
        sum * (1.0 / (samples.looks.len() / axes).max(1) as f64)
    }
}
