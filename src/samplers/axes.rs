//! Point sets that are made axis by axis, each axis from a random stream of its own.

use super::{Refused, refused};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// `n x d` points, both admitted: `fill(j, random, out)` puts coordinate j of point i in
/// `out[i * d]`.
pub(super) fn by_axis(
    n: usize,
    d: usize,
    seed: Seed,
    fill: impl Fn(usize, &mut Random, &mut [f64]),
) -> Result<Points, Refused> {
    let mut coordinates = refused::allocate(n, d)?;
    for axis in 0..d {
        fill(axis, &mut seed.at(axis as u64).generator(), &mut coordinates[axis..]);
    }
    refused::points(d, coordinates)
}
