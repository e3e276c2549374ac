//! Sampling: which points of its cube each pixel gets, rightly and, as exhibits, wrongly.
//!
//! A pixel needs n points of the scene's cube. *Rightly*, the points of different pixels are independent ([`Randomisation::Pixel`],
//! [`Randomisation::Shift`]), or all pixels share one sequence that is spread over the whole image ([`Randomisation::Sequence`]; L. Gruenschloss, M. Raab and
//! A. Keller, 2012, doi 10.1007/978-3-642-27440-4_21). *Wrongly*, all pixels get the same points, or use random numbers twice. Then the errors of
//! neighbours are alike, and what should be noise is a pattern that looks like a part of the picture.
//!
//! **Padding.** Where a sampler has not so many dimensions, each part of the axes (pixel, lens, time, lamp) gets points of its own, in a random order
//! (T. Kollig and A. Keller, Efficient Multidimensional Sampling, 2002, doi 10.1111/1467-8659.00706).
//!
//! **Splitting.** With s > 1 light samples for each of k samples of the other axes, each of the k gets its own s points on the lamp.

use crate::samplers::enumeration::{self, Interval};
use crate::samplers::{Method, Refused};
use crate::scenes::{Part, axes};
use crate::seed::Seed;
use std::fmt::{Display, Formatter};

/// How the points of one pixel relate to those of the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Randomisation {
    /// Right: each pixel draws its points with a seed of its own.
    Pixel,
    /// Right: all pixels take the same points, each shifted on the torus by random numbers of its own (Cranley and Patterson 1976).
    Shift,
    /// Right: one Halton or Sobol' sequence for the image; each pixel takes the points that fall into it.
    Sequence,
    /// Wrong: the same points in every pixel.
    Same,
    /// Wrong: shifts that repeat in every tile of 8 x 8 pixels.
    Tiled,
    /// Wrong: one random number a pixel, used as the shift of every axis.
    Diagonal,
}

/// The side of the tiles of [`Randomisation::Tiled`], in pixels.
const TILE: u64 = 8;

/// How the samples of an image are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// The sampler.
    pub method: Method,
    /// How many samples of all axes but the lamp's each pixel gets.
    pub looks: usize,
    /// How many samples of the lamp each of these gets. Where it is 1, lamp and other axes are sampled together.
    pub lights: usize,
    /// How pixels differ.
    pub randomisation: Randomisation,
    /// Whether each part of the axes gets points of its own even if the sampler has enough dimensions for all.
    pub padded: bool,
}

/// Why samples cannot be taken so.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Unfit {
    /// The sampler does not give such points.
    Refused(Refused),
    /// One sequence for the image is possible only for these samplers, as they are, and without splitting.
    Sequence,
    /// There is no lamp to be sampled more than once.
    Lights,
}

impl Display for Unfit {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Refused(refused) => write!(f, "{refused}"),
            Self::Sequence => f.write_str(
                "one sequence for the image is for `halton` and `sobol` without a scramble, unsplit and not padded, \
                 and for fewer than 2^32 points",
            ),
            Self::Lights => f.write_str("the scene has no lamp to sample more than once"),
        }
    }
}

impl From<Refused> for Unfit {
    fn from(refused: Refused) -> Self {
        Self::Refused(refused)
    }
}

impl Sampling {
    /// How many samples each pixel gets.
    pub fn total(&self) -> usize {
        self.looks.saturating_mul(self.lights)
    }

    /// The parts that are sampled together with the camera's, and whether each gets points of its own; or why it cannot be.
    pub fn arrange(&self, parts: &'static [Part]) -> Result<Arrangement, Unfit> {
        let split = self.lights > 1;
        let joint = match parts {
            [camera @ .., Part::Light] if split => camera,
            _ if split => return Err(Unfit::Lights),
            all => all,
        };
        if self.randomisation == Randomisation::Sequence {
            let known = self.method.scramble().is_none() && ["halton", "sobol"].contains(&self.key());
            return if known && !split && !self.padded {
                Ok(Arrangement { joint, padded: false })
            } else {
                Err(Unfit::Sequence)
            };
        }
        if split {
            self.method.admits(self.lights, Part::Light.axes())?;
        }
        let together = self.method.admits(self.looks, axes(joint));
        if together.is_ok() && !self.padded {
            return Ok(Arrangement { joint, padded: false });
        }
        for part in joint {
            // The first refusal is the clearer one where both ways are closed.
            self.method.admits(self.looks, part.axes()).map_err(|own| together.clone().err().unwrap_or(own))?;
        }
        Ok(Arrangement { joint, padded: joint.len() > 1 })
    }

    fn key(&self) -> &'static str {
        self.method.sampler().about().key
    }
}

/// How the axes of a scene are sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arrangement {
    /// The parts that each look samples.
    pub joint: &'static [Part],
    /// Whether each of them gets points of its own.
    pub padded: bool,
}

/// The samples of one pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Samples {
    /// For each look a point on all joint axes.
    pub looks: Vec<f64>,
    /// For each look the points (u, v) of the lamp; empty where the lamp is among the joint axes.
    pub lights: Vec<f64>,
}

/// The points of an image's pixels.
pub struct Pixels {
    sampling: Sampling,
    arrangement: Arrangement,
    width: usize,
    seed: Seed,
    source: Source,
}

/// Where a pixel's points come from.
enum Source {
    /// They are drawn for each pixel.
    Fresh,
    /// They are these, for some randomisations shifted.
    Kept(Samples),
    /// They are those of one sequence.
    Sequence(Box<Enumerated>),
}

/// One sequence that all pixels share.
struct Enumerated {
    at: Box<dyn Fn(u64, usize) -> f64 + Send + Sync>,
    /// Digits of each image axis: the sequence covers b^digits columns and rows.
    digits: [u32; 2],
    bases: [u64; 2],
    /// Sobol': in how many blocks, and of what size as a power of 2, the indices are looked for.
    block: Option<u32>,
}

impl Pixels {
    /// The points of an image of `width` x `height` pixels of a scene with these parts.
    pub fn new(
        sampling: Sampling,
        parts: &'static [Part],
        [width, height]: [usize; 2],
        seed: Seed,
    ) -> Result<Self, Unfit> {
        let arrangement = sampling.arrange(parts)?;
        let mut pixels = Self { sampling, arrangement, width, seed, source: Source::Fresh };
        pixels.source = match sampling.randomisation {
            Randomisation::Pixel => Source::Fresh,
            Randomisation::Sequence => Source::Sequence(Box::new(pixels.enumerated(height)?)),
            _ => Source::Kept(pixels.draw(seed.named("kept"))?),
        };
        Ok(pixels)
    }

    /// How many axes a look has.
    pub fn axes(&self) -> usize {
        axes(self.arrangement.joint)
    }

    /// The samples of the pixel in this column and row.
    pub fn samples(&self, column: usize, row: usize) -> Result<Samples, Unfit> {
        let pixel = (row * self.width + column) as u64;
        let kept = match &self.source {
            Source::Fresh => return Ok(self.draw(self.seed.at(pixel))?),
            Source::Sequence(sequence) => return sequence.samples(column, row, self.sampling.looks, self.axes()),
            Source::Kept(kept) => kept,
        };
        let seed = self.seed.named("shift");
        Ok(match self.sampling.randomisation {
            Randomisation::Tiled => self.shifted(kept, seed.at(row as u64 % TILE * TILE + column as u64 % TILE)),
            Randomisation::Shift | Randomisation::Diagonal => self.shifted(kept, seed.at(pixel)),
            _ => kept.clone(),
        })
    }

    /// The samples that one seed gives.
    fn draw(&self, seed: Seed) -> Result<Samples, Refused> {
        let Sampling { method, looks: n, lights, .. } = self.sampling;
        let looks = if self.arrangement.padded {
            self.padded(seed)?
        } else {
            method.points(n, self.axes(), seed)?.coordinates().to_vec()
        };
        let mut all = Samples { looks, lights: Vec::new() };
        if lights > 1 {
            let seed = seed.named("light");
            for look in 0..n {
                all.lights.extend_from_slice(method.points(lights, 2, seed.at(look as u64))?.coordinates());
            }
        }
        Ok(all)
    }

    /// Points for each part on its own, in orders that do not heed each other.
    fn padded(&self, seed: Seed) -> Result<Vec<f64>, Refused> {
        let (n, d) = (self.sampling.looks, self.axes());
        let mut looks = vec![0.0; n * d];
        let mut first = 0;
        for (k, part) in self.arrangement.joint.iter().enumerate() {
            let own = seed.at(k as u64);
            let points = self.sampling.method.points(n, part.axes(), own)?;
            let mut order: Vec<usize> = (0..n).collect();
            if k > 0 {
                own.named("order").generator().shuffle(&mut order);
            }
            for (look, point) in order.into_iter().zip(points.rows()) {
                looks[look * d + first..look * d + first + part.axes()].copy_from_slice(point);
            }
            first += part.axes();
        }
        Ok(looks)
    }

    /// `kept`, each axis shifted on the torus.
    fn shifted(&self, kept: &Samples, seed: Seed) -> Samples {
        let mut random = seed.generator();
        let first = random.uniform();
        let diagonal = self.sampling.randomisation == Randomisation::Diagonal;
        let mut shift = || if diagonal { first } else { random.uniform() };
        let mut samples = kept.clone();
        let shifts: Vec<f64> = (0..self.axes()).map(|_| shift()).collect();
        for look in samples.looks.chunks_exact_mut(shifts.len()) {
            look.iter_mut().zip(&shifts).for_each(|(x, shift)| *x = on_torus(*x + shift));
        }
        for lights in samples.lights.chunks_exact_mut(2 * self.sampling.lights) {
            let shifts = [shift(), shift()];
            for pair in lights.chunks_exact_mut(2) {
                pair.iter_mut().zip(shifts).for_each(|(x, shift)| *x = on_torus(*x + shift));
            }
        }
        samples
    }

    /// The sequence that covers the image.
    fn enumerated(&self, height: usize) -> Result<Enumerated, Unfit> {
        let digits = |count: usize, base: u64| (0..64).find(|&k| base.saturating_pow(k) >= count as u64).unwrap_or(0);
        let (bases, digits, block): ([u64; 2], _, _) = if self.sampling.key() == "halton" {
            ([2, 3], [digits(self.width, 2), digits(height, 3)], None)
        } else {
            // The first two coordinates have quality t = 0: each block of 2^(2k) points has one in each of 2^k x 2^k pixels.
            let k = digits(self.width.max(height), 2);
            let m = 2 * k + digits(self.sampling.looks, 2);
            ([2, 2], [k, k], Some(m))
        };
        let cells = u64::saturating_mul(bases[0].saturating_pow(digits[0]), bases[1].saturating_pow(digits[1]));
        let most = cells.saturating_mul(self.sampling.looks.next_power_of_two() as u64);
        let at = self.sampling.method.sample(2, self.axes(), self.seed).filter(|_| most < 1 << 32);
        at.map(|at| Enumerated { at, digits, bases, block }).ok_or(Unfit::Sequence)
    }
}

impl Enumerated {
    /// The first points of the sequence that fall into a pixel, on `axes` axes, the first two counted from the pixel's corner.
    fn samples(&self, column: usize, row: usize, looks: usize, axes: usize) -> Result<Samples, Unfit> {
        let cells = [column as u64, row as u64];
        let interval = |axis: usize| Interval { axis, digits: self.digits[axis], cell: cells[axis] };
        let intervals = [interval(0), interval(1)];
        let indices: Vec<u64> = if let Some(m) = self.block {
            enumeration::sobol(&intervals, m, 0).ok_or(Unfit::Sequence)?
        } else {
            let all = enumeration::halton(&intervals).ok_or(Unfit::Sequence)?;
            (0..looks as u64).map(|k| all.first + k * all.step).collect()
        };
        let mut points = Vec::with_capacity(looks * axes);
        for index in indices.into_iter().take(looks) {
            for axis in 0..axes {
                let x = (self.at)(index, axis);
                // Exact for base 2; for base 3 rounding could leave the pixel by a hair.
                points.push(cells.get(axis).map_or(x, |&cell| {
                    let side = self.bases[axis].pow(self.digits[axis]) as f64;
                    (x * side - cell as f64).clamp(0.0, BELOW_ONE)
                }));
            }
        }
        Ok(Samples { looks: points, lights: Vec::new() })
    }
}

/// The largest number below 1.
const BELOW_ONE: f64 = 1.0 - f64::EPSILON / 2.0;

/// A number in [0, 2) taken into [0, 1).
#[inline]
fn on_torus(x: f64) -> f64 {
    if x >= 1.0 { x - 1.0 } else { x }
}
