//! Regular grids: the same place in each of n = k^d equal cells.

use super::digits::root;
use super::{Refused, refused};
use crate::points::Points;

/// The `n x d` points, n and d admitted, at the place `offset` in [0, 1) of each cell; cell i has
/// the coordinates of i written in base k, the first axis fastest.
pub(super) fn points(n: usize, d: usize, offset: f64) -> Result<Points, Refused> {
    let mut coordinates = refused::allocate(n, d)?;
    let k = root(n as u64, d as u32);
    for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
        let mut rest = i as u64;
        for x in point {
            *x = ((rest % k) as f64 + offset) / k as f64;
            rest /= k;
        }
    }
    refused::points(d, coordinates)
}

/// The same by position.
pub(super) fn at(n: usize, d: usize, offset: f64) -> Box<dyn Fn(u64, usize) -> f64 + Send + Sync> {
    let k = root(n as u64, d as u32);
    Box::new(move |index, axis| {
        let rest = (0..axis).fold(index, |rest, _| rest / k);
        ((rest % k) as f64 + offset) / k as f64
    })
}
