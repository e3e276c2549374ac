//! The star discrepancy in three dimensions: plane sweeps at a few heights.
//!
//! Sort the points by z. The first j of them, with the height of the last, give the closed boxes
//! that end there; with the height of the next, the open boxes. From one height to another both
//! extrema can only change so fast: with s more points the excess of points grows by at most s/n,
//! and the excess of volume by the difference of the heights, and likewise downwards. Heights whose
//! bound does not pass the best so far are skipped; the others are visited by halving the gaps.

use super::Measured;
use super::star::Best;
use super::star_sweep::{Ranked, sweep};
use crate::points::Points;

/// The extrema of one height: of the excess of points, and of the excess of volume.
type Extrema = [f64; 2];

/// The star discrepancy of points of three dimensions, with its box.
pub(super) fn in_space(points: &Points) -> Measured {
    let mut rows: Vec<&[f64]> = points.rows().collect();
    rows.sort_unstable_by(|a, b| a[2].total_cmp(&b[2]));
    let by = |axis: usize| {
        let mut order: Vec<usize> = (0..rows.len()).collect();
        order.sort_unstable_by(|&a, &b| rows[a][axis].total_cmp(&rows[b][axis]));
        order
    };
    let (by_x, by_y) = (by(0), by(1));
    let mut search = Search { rows, by_x, by_y, best: Best::default() };
    let n = search.rows.len();
    let (low, high) = (search.visit(0), search.visit(n));
    search.between(0, low, n, high);
    search.best.measured()
}

/// The share of the best below which extrema are not looked for.
const FLOOR: f64 = 0.8;

struct Search<'a> {
    /// The points by rising z.
    rows: Vec<&'a [f64]>,
    /// Their places by rising x.
    by_x: Vec<usize>,
    /// Their places by rising y.
    by_y: Vec<usize>,
    best: Best,
}

impl Search<'_> {
    /// The height of the last of `count` points, 0 for none.
    fn below(&self, count: usize) -> f64 {
        if count == 0 { 0.0 } else { self.rows[count - 1][2] }
    }

    /// The height of the next after `count` points, 1 at the end.
    fn above(&self, count: usize) -> f64 {
        self.rows.get(count).map_or(1.0, |row| row[2])
    }

    /// The extrema with the `count` lowest points.
    fn visit(&mut self, count: usize) -> Extrema {
        let heights = [self.below(count), self.above(count)];
        let mut ordinates = Vec::with_capacity(count + 1);
        let mut ranks = vec![0; count];
        for &place in self.by_y.iter().filter(|&&place| place < count) {
            let y = self.rows[place][1];
            if ordinates.last() != Some(&y) {
                ordinates.push(y);
            }
            ranks[place] = ordinates.len() - 1;
        }
        if ordinates.last() != Some(&1.0) {
            ordinates.push(1.0);
        }
        let lowest = self.by_x.iter().filter(|&&place| place < count);
        let plane: Vec<Ranked> = lowest.map(|&place| (self.rows[place][0], ranks[place])).collect();
        // Extrema below this share of the best need not be known exactly to skip their neighbours.
        let floor = FLOOR * self.best.value;
        let mut found = [(); 2].map(|()| Best { value: floor, corner: vec![0.0; 2] });
        sweep(&plane, &ordinates, self.rows.len(), heights, &mut found);
        let extrema = [found[0].value, found[1].value];
        for (found, height) in found.into_iter().zip(heights) {
            let Best { value, mut corner } = found;
            corner.push(height);
            self.best.offer(value, || corner);
        }
        extrema
    }

    /// Visits what bounds leave between the counts `low` and `high`, whose extrema are known.
    fn between(&mut self, low: usize, from_low: Extrema, high: usize, from_high: Extrema) {
        let n = self.rows.len() as f64;
        let passes = |count: usize| {
            let (up, down) = ((count - low) as f64 / n, (high - count) as f64 / n);
            let full = (from_low[0] + up).min(from_high[0] + self.below(high) - self.below(count));
            let empty = (from_low[1] + self.above(count) - self.above(low)).min(from_high[1] + down);
            full.max(empty) > self.best.value
        };
        // The gap shrinks to what may pass, and is halved there.
        let (Some(first), Some(last)) =
            ((low + 1..high).find(|&count| passes(count)), (low + 1..high).rfind(|&count| passes(count)))
        else {
            return;
        };
        let middle = usize::midpoint(first, last);
        let extrema = self.visit(middle);
        self.between(low, from_low, middle, extrema);
        self.between(middle, extrema, high, from_high);
    }
}
