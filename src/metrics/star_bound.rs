//! The star discrepancy in four and more dimensions: all boxes of the grid, with branches dropped
//! by bounds.
//!
//! A branch fixes the upper corner's coordinates on the first axes and carries along the points
//! that are still inside. With the axes left open the count only falls and the volume only shrinks,
//! which bounds every box of the branch: the excess of points by what is inside now, the excess of
//! volume by the volume now.

use super::Measured;
use super::star::Best;
use crate::points::Points;

/// Points looked at before the search settles for a lower bound: some seconds.
const STEPS: u64 = 4_000_000_000;

/// The star discrepancy of points of any dimension, or a lower bound where the steps run out.
pub(super) fn branch(points: &Points) -> Measured {
    let (n, d) = (points.len(), points.dimensions());
    let grid: Vec<Vec<f64>> = (0..d)
        .map(|axis| {
            let mut values: Vec<f64> = points.axis(axis).chain([1.0]).collect();
            values.sort_unstable_by(f64::total_cmp);
            values.dedup();
            values
        })
        .collect();
    let mut search = Search { n: n as f64, grid, corner: vec![1.0; d], best: Best::default(), steps: STEPS };
    let rows: Vec<&[f64]> = points.rows().collect();
    search.closed(0, 1.0, &rows);
    search.open(0, 1.0, &rows);
    let complete = search.steps > 0;
    Measured { is_bound: !complete, ..search.best.measured() }
}

struct Search {
    n: f64,
    grid: Vec<Vec<f64>>,
    corner: Vec<f64>,
    best: Best,
    steps: u64,
}

impl Search {
    /// Closed boxes, with too many points: `inside` are the points that the first `axis`
    /// coordinates leave.
    fn closed(&mut self, axis: usize, volume: f64, inside: &[&[f64]]) {
        if axis == self.grid.len() {
            let corner = &self.corner;
            self.best.offer(inside.len() as f64 / self.n - volume, || corner.clone());
            return;
        }
        // The best box ends at a point on every axis; with k points it has at least the volume of
        // the first k.
        let mut sorted: Vec<&[f64]> = inside.to_vec();
        sorted.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
        // The smallest volume that the axes behind can leave.
        let rest: f64 = (axis + 1..self.grid.len()).map(|axis| self.grid[axis][0]).product();
        for count in (1..=sorted.len()).rev() {
            let side = sorted[count - 1][axis];
            if count < sorted.len() && sorted[count][axis] == side {
                continue;
            }
            if count as f64 / self.n <= self.best.value || self.steps == 0 {
                break;
            }
            if count as f64 / self.n - volume * side * rest > self.best.value {
                self.steps = self.steps.saturating_sub(count as u64);
                self.corner[axis] = side;
                self.closed(axis + 1, volume * side, &sorted[..count]);
            }
        }
    }

    /// Open boxes, with too few points.
    fn open(&mut self, axis: usize, volume: f64, inside: &[&[f64]]) {
        if axis == self.grid.len() {
            let corner = &self.corner;
            self.best.offer(volume - inside.len() as f64 / self.n, || corner.clone());
            return;
        }
        if axis + 1 == self.grid.len() {
            return self.open_last(volume, inside);
        }
        let mut sorted: Vec<&[f64]> = inside.to_vec();
        sorted.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
        for at in (0..self.grid[axis].len()).rev() {
            let side = self.grid[axis][at];
            // A smaller side has a smaller volume, however few points are inside.
            if volume * side <= self.best.value || self.steps == 0 {
                break;
            }
            let count = sorted.partition_point(|x| x[axis] < side);
            self.steps = self.steps.saturating_sub(count as u64 + 1);
            self.corner[axis] = side;
            self.open(axis + 1, volume * side, &sorted[..count]);
        }
    }

    /// The last axis of open boxes: the best end at a point that is inside, or at 1.
    fn open_last(&mut self, volume: f64, inside: &[&[f64]]) {
        let axis = self.grid.len() - 1;
        let mut values: Vec<f64> = inside.iter().map(|x| x[axis]).collect();
        values.sort_unstable_by(f64::total_cmp);
        let mut below = 0;
        for (k, side) in values.iter().copied().chain([1.0]).enumerate() {
            if k > 0 && values[k - 1] < side {
                below = k;
            }
            if volume * side - below as f64 / self.n > self.best.value {
                self.corner[axis] = side;
                let corner = &self.corner;
                self.best.offer(volume * side - below as f64 / self.n, || corner.clone());
            }
        }
    }
}
