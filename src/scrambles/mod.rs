//! The scrambles: randomisations of digital samplers, a catalogue of their own, combined by name as
//! `sobol+xor`.

use crate::catalogue::Entry;
use crate::points::Points;
use crate::samplers::batch::{self, Finish};
use crate::samplers::{Digits, Guarantee, Radix, Refused, Sampler, allocate, points as checked};
use crate::seed::Seed;
use walk::Places;

pub mod braaten_weller;
pub mod cranley_patterson;
pub mod faure_permutation;
mod fixed;
pub mod linear;
pub mod owen;
pub mod owen_hash;
pub mod owen_shuffled;
pub mod permutation;
pub mod walk;
pub mod xor;

/// Every scramble, in the order of display.
pub static SCRAMBLES: &[&dyn Scramble] = &[
    &xor::Xor,
    &cranley_patterson::CranleyPatterson,
    &permutation::Permutation,
    &faure_permutation::FaurePermutation,
    &braaten_weller::BraatenWeller,
    &linear::Linear,
    &owen::Owen,
    &owen_hash::OwenHash,
    &owen_shuffled::OwenShuffled,
];

/// A map of the coordinates of a sampler, one for each axis, that keeps what makes the sampler
/// good.
pub trait Scramble: Entry + Sync {
    /// Whether the seed matters.
    fn is_random(&self) -> bool {
        true
    }

    /// Whether it can be combined with `sampler`; the reason if not.
    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str>;

    /// Whether `guarantee` of a sampler still holds for the scrambled points.
    fn keeps(&self, guarantee: Guarantee) -> bool;

    /// The map that shuffles the order of the points, if it does; most leave the order alone.
    fn order(&self, _seed: Seed) -> Option<Box<dyn Fn(u64) -> u64 + Send + Sync>> {
        None
    }

    /// What it does to 32 binary digits, where that is all it does, for the fast path.
    fn finish(&self, _axis: usize, _seed: Seed) -> Option<Finish> {
        None
    }

    /// Its action on the axis `axis`, whose base is `radix`; `seed` is the scramble's, the same for
    /// all axes.
    fn action(&self, radix: Radix, axis: usize, seed: Seed) -> Action;
}

/// What a scramble does to one axis.
pub enum Action {
    /// It maps the digits.
    Digits(Box<dyn DigitMap>),
    /// It maps each digit on its own, by position: `images[position][digit]`, or `images[0]` for
    /// all positions; then adds `tail` of a last digit.
    Positions {
        /// The places of the digits.
        places: Places,
        /// The tables of images.
        images: Vec<Vec<u64>>,
        /// The fraction of a last digit that is added, in [0, 1).
        tail: f64,
    },
    /// It maps the coordinate, in [0, 1) before and after.
    Coordinate(Box<dyn Fn(f64) -> f64 + Send + Sync>),
}

impl Action {
    /// The image of `numerator`, in [0, 1).
    fn coordinate(&self, numerator: u64, radix: Radix) -> f64 {
        match self {
            Self::Digits(map) => map.coordinate(numerator),
            Self::Coordinate(map) => map(radix.coordinate(numerator)),
            Self::Positions { places, images, tail } => {
                let mapped = places.map(numerator, |position, digit| images[position % images.len()][digit as usize]);
                radix.coordinate_with(mapped, *tail)
            }
        }
    }
}

/// A map from numerators to scrambled coordinates.
pub trait DigitMap: Send + Sync {
    /// The scrambled coordinate, in [0, 1), of `numerator`.
    fn coordinate(&self, numerator: u64) -> f64;

    /// The same for many: the coordinate of `numerators[i]` goes to `out[i * stride]`.
    fn coordinates(&self, numerators: &[u64], out: &mut [f64], stride: usize) {
        for (x, &numerator) in out.iter_mut().step_by(stride).zip(numerators) {
            *x = self.coordinate(numerator);
        }
    }
}

impl<F: Fn(u64) -> f64 + Send + Sync> DigitMap for F {
    fn coordinate(&self, numerator: u64) -> f64 {
        self(numerator)
    }
}

/// Points handled together: their numerators stay in the nearest cache.
const BLOCK: usize = 256;

/// The `n x d` points of `sampler`, whose random stream is called `name`, scrambled by `scramble`.
pub(crate) fn points(
    (sampler, name): (&dyn Sampler, &str),
    scramble: &dyn Scramble,
    n: usize,
    d: usize,
    seed: Seed,
) -> Result<Points, Refused> {
    sampler.admits(n, d)?;
    let own = seed.named(scramble.about().key);
    let Some(digital) = sampler.digital(n, d) else {
        let points = sampler.points(n, d, seed.named(name))?;
        return shifted(&points, scramble, own);
    };
    let mut coordinates = allocate(n, d)?;
    let finishes: Option<Vec<Finish>> = (0..d).map(|axis| scramble.finish(axis, own)).collect();
    if sampler.digits() == Digits::Binary
        && finishes.is_some_and(|finishes| batch::binary(digital.as_ref(), &finishes, &mut coordinates))
    {
        return checked(d, coordinates);
    }
    let order = scramble.order(own);
    let mut numerators = [0; BLOCK];
    for axis in 0..d {
        let radix = digital.radix(axis);
        let action = scramble.action(radix, axis, own);
        if let (Action::Positions { images, tail, .. }, true) = (&action, digital.is_radical(axis)) {
            let image = |position: usize, digit: u64| images[position % images.len()][digit as usize];
            batch::radical(radix, image, *tail, &mut coordinates[axis..], d);
            continue;
        }
        for (k, rows) in coordinates.chunks_mut(BLOCK * d).enumerate() {
            let numerators = &mut numerators[..rows.len() / d];
            let first = (k * BLOCK) as u64;
            match &order {
                None => digital.numerators(first, axis, numerators),
                Some(order) => {
                    for (index, numerator) in (first..).zip(&mut *numerators) {
                        *numerator = digital.numerator(order(index), axis);
                    }
                }
            }
            apply(&action, radix, numerators, &mut rows[axis..], d);
        }
    }
    checked(d, coordinates)
}

/// Random access to the scrambled points.
pub(crate) fn sample(
    (sampler, name): (&dyn Sampler, &str),
    scramble: &dyn Scramble,
    n: usize,
    d: usize,
    seed: Seed,
) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
    let own = seed.named(scramble.about().key);
    let order = scramble.order(own);
    let index = move |index| order.as_ref().map_or(index, |order| order(index));
    if let Some(digital) = sampler.digital(n, d) {
        let actions: Vec<Action> = (0..d).map(|axis| scramble.action(digital.radix(axis), axis, own)).collect();
        return Some(Box::new(move |i, axis| {
            actions[axis].coordinate(digital.numerator(index(i), axis), digital.radix(axis))
        }));
    }
    let plain = sampler.at(n, d, seed.named(name))?;
    let actions: Vec<Action> = (0..d).map(|axis| scramble.action(Radix::new(2), axis, own)).collect();
    Some(Box::new(move |i, axis| match &actions[axis] {
        Action::Coordinate(map) => map(plain(index(i), axis)),
        Action::Digits(_) | Action::Positions { .. } => f64::NAN,
    }))
}

/// Applies `action` to one axis of a block.
fn apply(action: &Action, radix: Radix, numerators: &[u64], out: &mut [f64], stride: usize) {
    match action {
        Action::Digits(map) => map.coordinates(numerators, out, stride),
        action => {
            for (x, &numerator) in out.iter_mut().step_by(stride).zip(numerators) {
                *x = action.coordinate(numerator, radix);
            }
        }
    }
}

/// Points without digits under a scramble that maps coordinates.
fn shifted(points: &Points, scramble: &dyn Scramble, seed: Seed) -> Result<Points, Refused> {
    let d = points.dimensions();
    let mut coordinates = points.coordinates().to_vec();
    for axis in 0..d {
        if let Action::Coordinate(map) = scramble.action(Radix::new(2), axis, seed) {
            coordinates.iter_mut().skip(axis).step_by(d).for_each(|x| *x = map(*x));
        }
    }
    checked(d, coordinates)
}
