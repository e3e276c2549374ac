//! Occupancy: how many points fall in each cell of a grid, and in each slab of each axis.
//!
//! A set is *stratified* where each of n cells holds one point, *Latin* where each of n slabs of
//! every axis does. Cells are found by comparison with their borders as they are in `f64`
//! ([`slab`]), so that rounding moves no point.
//!
//! ```
//! use workbook::{metrics::occupancy::{cells, is_latin}, points::Points};
//! let points = Points::from_rows(2, vec![0.1, 0.6, 0.7, 0.2]).unwrap();
//! assert_eq!(cells(&points, &[2, 2]), Some(vec![0, 1, 1, 0]));
//! assert!(is_latin(&points));
//! ```

use crate::points::{Points, slab};

/// The most cells of a grid.
const MOST_CELLS: usize = 1 << 28;

/// The counts of the cells of the grid with `cuts[j]` slabs on axis j, the first axis fastest;
/// `None` unless there is one positive cut for each axis, and at most 2^28 cells.
pub fn cells(points: &Points, cuts: &[usize]) -> Option<Vec<u32>> {
    let total = cuts.iter().try_fold(1_usize, |total, &cut| total.checked_mul(cut))?;
    if cuts.len() != points.dimensions() || total == 0 || total > MOST_CELLS {
        return None;
    }
    let mut counts = vec![0; total];
    for row in points.rows() {
        counts[row.iter().zip(cuts).rev().fold(0, |cell, (&x, &cut)| cell * cut + slab(x, cut))] += 1;
    }
    Some(counts)
}

/// The counts of the n slabs of axis `axis`.
pub fn slabs(points: &Points, axis: usize) -> Vec<u32> {
    let mut counts = vec![0; points.len()];
    points.axis(axis).for_each(|x| counts[slab(x, points.len())] += 1);
    counts
}

/// Whether every axis has one point in each of its n slabs.
pub fn is_latin(points: &Points) -> bool {
    (0..points.dimensions()).all(|axis| slabs(points, axis).iter().all(|&count| count == 1))
}
