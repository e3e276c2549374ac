//! The samplers: how points are placed in the unit cube. One file each, and one catalogue.
//!
//! A sampler *declares* what it guarantees; the battery in `tests/` holds it to each declaration over many n, d and seeds.

use crate::catalogue::Entry;
use crate::points::Points;
use crate::seed::Seed;

mod independent;

/// Every sampler, in the order of display.
pub static SAMPLERS: &[&dyn Sampler] = &[
    &independent::INDEPENDENT,
];

/// A way to place points in the unit cube.
pub trait Sampler: Entry + Sync {
    /// What this sampler promises for every n, d and seed that it admits.
    fn guarantees(&self) -> &'static [Guarantee];

    /// Whether it can give exactly `n` points of `d` dimensions. It never rounds n in silence.
    fn admits(&self, n: usize, d: usize) -> Result<(), Refused>;

    /// The `n x d` points for `seed`: the same arguments give the same bits, everywhere.
    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused>;
}

/// A promise that a sampler makes and the battery proves. Every sampler moreover stays in [0, 1).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Guarantee {
    /// The first m of n points are the m points.
    Prefix,
    /// One point in each of the n slabs of every axis.
    Latin,
    /// One point in each cell of the grid of n equal cells.
    Strata,
    /// Every aligned block of b^m points is a (t, m, s)-net in base b.
    Net {
        /// The base b.
        base: u32,
        /// The quality parameter t; 0 is best.
        t: u32,
    },
    /// Each point is uniform over seeds, so that the mean is unbiased.
    Unbiased,
    /// The same points for every seed.
    Deterministic,
}

/// Why a sampler cannot give what was asked of it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Refused {
    /// It cannot give this n; the nearest that it can, below and above.
    Count {
        /// What was asked for.
        n: usize,
        /// The nearest count below that it can give, if any.
        below: Option<usize>,
        /// The nearest count above that it can give, if any.
        above: Option<usize>,
        /// What the count must be, e.g. `a square`.
        rule: &'static str,
    },
    /// It cannot give this d.
    Dimensions {
        /// What was asked for.
        d: usize,
        /// The most that it can give.
        most: usize,
    },
}
