//! The samplers: how points are placed in the unit cube. One file each, and one catalogue.
//!
//! A sampler *declares* what it guarantees; the battery in `tests/` holds it to each declaration
//! over many n, d and seeds. Those whose coordinates are made of digits expose them as [`Digital`],
//! which is what the scrambles of [`crate::scrambles`] work on. Some have [settings](Setting). A
//! [`Method`] is a sampler with or without a scramble, by name: `sobol+xor`, `faure(base=5)`.

use crate::catalogue::Entry;
use crate::points::Points;
use crate::seed::Seed;

mod axes;
pub mod batch;
pub mod best_candidate;
pub mod bridson;
pub mod centred_grid;
pub mod correlated_multi_jittered;
pub mod dart_throwing;
pub mod digits;
pub mod enumeration;
pub mod faure;
pub mod fibonacci;
pub mod folded;
pub mod grid;
pub mod halton;
pub mod hammersley;
pub mod independent;
pub mod jittered;
pub mod korobov;
pub mod kronecker;
pub mod larcher_pillichshammer;
pub mod latin_hypercube;
pub mod maximal_poisson;
mod method;
pub mod multi_jittered;
pub mod niederreiter;
pub mod orthogonal_array;
pub mod orthogonal_array_bush;
pub mod padded_jittered;
pub mod poisson;
pub mod progressive_multi_jittered;
pub mod radical_inverse;
mod refused;
mod regular;
mod settings;
mod sides;
pub mod sobol;
pub mod uniform_jitter;
pub mod van_der_corput;
pub mod zero_two;

pub use digits::Radix;
pub use method::{Chosen, Method, UnknownMethod};
pub use refused::{MOST_COORDINATES, Refused};
pub(crate) use refused::{allocate, points};
pub use settings::{Preset, Setting, Values, WrongSetting};

/// Every sampler, in the order of display.
pub static SAMPLERS: &[&dyn Sampler] = &[
    &independent::Independent,
    &grid::Grid,
    &centred_grid::CentredGrid,
    &uniform_jitter::PLAIN,
    &jittered::PLAIN,
    &padded_jittered::PaddedJittered,
    &latin_hypercube::LatinHypercube,
    &multi_jittered::PLAIN,
    &correlated_multi_jittered::PLAIN,
    &orthogonal_array::OrthogonalArray,
    &orthogonal_array_bush::PLAIN,
    &dart_throwing::DartThrowing,
    &bridson::PLAIN,
    &maximal_poisson::MaximalPoisson,
    &best_candidate::PLAIN,
    &van_der_corput::VanDerCorput,
    &radical_inverse::PLAIN,
    &halton::Halton,
    &hammersley::PLAIN,
    &folded::Folded,
    &faure::PLAIN,
    &sobol::Sobol,
    &niederreiter::Niederreiter,
    &zero_two::ZeroTwo,
    &larcher_pillichshammer::LarcherPillichshammer,
    &progressive_multi_jittered::ProgressiveMultiJittered,
    &korobov::PLAIN,
    &fibonacci::Fibonacci,
    &kronecker::Kronecker,
];

/// A way to place points in the unit cube.
pub trait Sampler: Entry + Sync {
    /// What this sampler promises for every n, d and seed that it admits.
    fn guarantees(&self) -> &'static [Guarantee];

    /// What it can be told by name, as in `faure(base=5)`; at most two numbers.
    fn settings(&self) -> &'static [Setting] {
        &[]
    }

    /// The same sampler with the values of its [`settings`](Self::settings); `None` where it has
    /// none.
    fn with(&self, _values: Values) -> Option<Box<dyn Sampler>> {
        None
    }

    /// Whether it can give exactly `n` points of `d` dimensions. It never rounds n in silence.
    fn admits(&self, n: usize, d: usize) -> Result<(), Refused>;

    /// The `n x d` points for `seed`: the same arguments give the same bits, everywhere. Those of a
    /// digital sampler are made of its digits.
    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        digital_points(self, n, d)
    }

    /// The net that [`Guarantee::Net`] promises in `d` dimensions.
    fn net(&self, _d: usize) -> Option<Net> {
        None
    }

    /// The net that [`Guarantee::Whole`] promises of all `n` points in `d` dimensions.
    fn whole_net(&self, _n: usize, _d: usize) -> Option<Net> {
        None
    }

    /// Into how many slabs each axis is cut for the cells of [`Guarantee::Strata`]; `n` and `d` are
    /// admitted.
    fn strata(&self, n: usize, d: usize) -> Vec<usize> {
        vec![digits::root(n as u64, d as u32) as usize; d]
    }

    /// The exponent of n in the root mean square error that theory gives it in `d` dimensions, up to
    /// logarithms, for integrands with this `_feature`; `None` where nothing is said.
    fn rate(&self, _feature: Feature, _d: usize) -> Option<f64> {
        None
    }

    /// Whether each point is searched for among those before, so that many points take long.
    fn searches(&self) -> bool {
        false
    }

    /// Coordinate `axis` of point `index`, pure by position, for the `n` points of `d` dimensions
    /// that `seed` gives; `None` where points depend on each other. Sequences heed no n.
    fn at(&self, n: usize, d: usize, _seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        let digital = self.digital(n, d)?;
        Some(Box::new(move |index, axis| digital.radix(axis).coordinate(digital.numerator(index, axis))))
    }

    /// In which base its coordinates are digits, which says what scrambles it can be combined with.
    fn digits(&self) -> Digits {
        Digits::None
    }

    /// Whether the bases of all axes are prime.
    fn has_prime_bases(&self) -> bool {
        true
    }

    /// The digits of its coordinates for `n` points of `d` dimensions, both admitted; `None` where
    /// there are none.
    fn digital(&self, _n: usize, _d: usize) -> Option<Box<dyn Digital>> {
        None
    }
}

/// Points by their digits: every coordinate is a whole number over a power of its axis' base. Pure
/// by position.
pub trait Digital: Send + Sync {
    /// The base of the axis `axis`, with the number of digits; 2 unless it is said.
    fn radix(&self, _axis: usize) -> Radix {
        const { Radix::new(2) }
    }

    /// The numerator, over `radix(axis).scale`, of the coordinate of point `index` on the axis
    /// `axis < d`.
    fn numerator(&self, index: u64, axis: usize) -> u64;

    /// Whether the numerators on `axis` are the radical inverses of the index in its base.
    fn is_radical(&self, _axis: usize) -> bool {
        false
    }

    /// The numerators of points `first`, `first + 1`, ... on one axis: the same as one by one, but
    /// faster.
    fn numerators(&self, first: u64, axis: usize, out: &mut [u64]) {
        for (index, numerator) in (first..).zip(out) {
            *numerator = self.numerator(index, axis);
        }
    }
}

/// Whether the coordinates of a sampler are digits of some base.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Digits {
    /// Real numbers without digits of their own.
    None,
    /// Base 2 on every axis.
    Binary,
    /// Some base on each axis, not 2 on all.
    Mixed,
}

/// The parameters of a (t, m, d)-net: of b^m points, every elementary interval of volume b^(t - m)
/// holds b^t.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Net {
    /// The base b.
    pub base: u32,
    /// The quality parameter t; 0 is best.
    pub t: u32,
}

/// What decides on the rate at which an integrand's error falls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feature {
    /// It is smooth, and no sum of functions of one variable.
    Smooth,
    /// It is a sum of smooth functions of one variable each.
    Additive,
    /// It is continuous, with a kink across an axis.
    Kink,
    /// It jumps at an edge that is parallel to no axis; on the line, at a point.
    Edge,
}

/// A promise that a sampler makes and the battery proves. Every sampler moreover stays in [0, 1).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Guarantee {
    /// The first m of n points are the m points.
    Prefix,
    /// One point in each of the n slabs of every axis.
    Latin,
    /// One point in each cell of the grid of n equal cells.
    Strata,
    /// Every aligned block of b^m points is a (t, m, d)-net in base b, with the parameters of
    /// [`Sampler::net`].
    Net,
    /// All n points together are a (t, m, d)-net, with the parameters of [`Sampler::whole_net`].
    Whole,
    /// Of any consecutive b1^k1 ... bd^kd points, one falls in each of the equal boxes that cut
    /// axis j into bj^kj.
    Boxes,
    /// One point in each cell of the square grid of the axes 2p and 2p + 1, for every p.
    Pairs,
    /// Any t axes show every cell of the grid of n^(1/t) slabs once.
    Strength {
        /// The number of axes t.
        t: u32,
    },
    /// No two points are nearer on the torus than so many per cent of the largest possible
    /// distance.
    Separated {
        /// The relative radius in per cent.
        percent: u32,
    },
    /// Over seeds the points together are uniform, so that the mean is unbiased.
    Unbiased,
    /// The same points for every seed.
    Deterministic,
}

impl std::fmt::Display for Guarantee {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match *self {
            Self::Pairs => "one point in each cell of the square grid of the axes 2p and 2p + 1",
            Self::Strength { t } => {
                return write!(f, "one point in each cell of any {t} axes cut into n^(1/{t}) slabs");
            }
            Self::Separated { percent } => {
                return write!(
                    f,
                    "no two points nearer on the torus than {percent} % of the largest possible distance"
                );
            }
            Self::Prefix => "the first m of n points are the m points",
            Self::Latin => "one point in each of the n slabs of every axis",
            Self::Strata => "one point in each cell of the grid of n equal cells",
            Self::Net => "every aligned block of b^m points is a (t, m, d)-net in base b",
            Self::Whole => "all n = b^m points together are a (t, m, d)-net in base b",
            Self::Boxes => {
                "one point in each box of sides b_j^-k_j among as many consecutive points as there are boxes"
            }
            Self::Unbiased => "over seeds the points together are uniform, so that the mean is unbiased",
            Self::Deterministic => "the same points for every seed",
        })
    }
}

/// The points of a digital sampler as they are, block by block.
fn digital_points(sampler: &(impl Sampler + ?Sized), n: usize, d: usize) -> Result<Points, Refused> {
    sampler.admits(n, d)?;
    let digital = sampler.digital(n, d).ok_or(Refused::Dimensions { d, least: 1, most: 1 })?;
    let mut coordinates = refused::allocate(n, d)?;
    if sampler.digits() == Digits::Binary
        && batch::binary(digital.as_ref(), &vec![batch::Finish::Plain; d], &mut coordinates)
    {
        return refused::points(d, coordinates);
    }
    let mut block = [0; 256];
    for axis in 0..d {
        let radix = digital.radix(axis);
        if digital.is_radical(axis) {
            batch::radical(radix, |_, digit| digit, 0.0, &mut coordinates[axis..], d);
            continue;
        }
        for (k, rows) in coordinates.chunks_mut(block.len() * d).enumerate() {
            let numerators = &mut block[..rows.len() / d];
            digital.numerators((k * 256) as u64, axis, numerators);
            for (row, &numerator) in rows.chunks_exact_mut(d).zip(&*numerators) {
                row[axis] = radix.coordinate(numerator);
            }
        }
    }
    refused::points(d, coordinates)
}
