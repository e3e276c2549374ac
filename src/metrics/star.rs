//! The star discrepancy: the largest difference between the share of points in a box at the origin
//! and the box's volume.
//!
//! **Formula.** D* = sup over boxes \[0, q) in the unit cube of | #{x_i in \[0, q)} / n - vol |.
//! The supremum needs boxes open and closed at their upper faces, whose corners have coordinates of
//! points or 1.
//!
//! **Algorithms.** One dimension: sorting, 1/(2n) + max |x_(i) - (2i-1)/(2n)|. Two: a sweep along x
//! over blocks in y, O(n^(3/2) log n), as below. Three: such sweeps at heights that bounds cannot
//! skip. More: all boxes of the grid of coordinates, in the order of a tree that drops a branch as
//! soon as its best bound is below the best found, up to a fixed number of steps; beyond, a lower
//! bound, and called so.
//!
//! **The sweep.** Between two neighbouring abscissas X the box \[0, X) x \[0, y) holds a count c(y)
//! that changes by steps; the two differences c(y)/n - X y and X y - c(y)/n are, for each fixed
//! count, extremal at the ends of a step. Points that are kept sorted by y in blocks, each block
//! with the convex hulls of its (y, count) corners, give the maximum of count/n - X y over a block
//! by a binary search of the hull, since it is linear in X; adding a point rebuilds one block and
//! shifts the counts of the later ones.
//!
//! **Papers.** H. Niederreiter (1972), doi 10.1007/BF02412017; D. P. Dobkin, D. Eppstein and D. P.
//! Mitchell (1996), doi 10.1145/234535.234536.
//!
//! ```
//! use workbook::{metrics::star::star_discrepancy, points::Points};
//! let points = Points::from_rows(1, vec![0.25, 0.75]).unwrap();
//! assert_eq!(star_discrepancy(&points).unwrap().value, 0.25);
//! ```

use super::star_bound::branch;
use super::star_space::in_space;
use super::{Measured, Metric, Unmeasured, check};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;

/// The measure `star-discrepancy`.
pub struct StarDiscrepancy;

static ABOUT: About = About {
    key: "star-discrepancy",
    title: "Star discrepancy",
    summary: "The largest difference between the share of points in a box at the origin and its volume.",
    file: "metrics/star.rs",
    source: include_str!("star.rs"),
    papers: &[
        Paper {
            authors: "H. Niederreiter",
            year: 1972,
            title: "Discrepancy and Convex Programming",
            venue: "Annali di Matematica Pura ed Applicata 93, 89-97",
            doi: Some("10.1007/BF02412017"),
        },
        Paper {
            authors: "D. P. Dobkin, D. Eppstein and D. P. Mitchell",
            year: 1996,
            title: "Computing the Discrepancy with Applications to Supersampling Patterns",
            venue: "ACM Transactions on Graphics 15(4), 354-376",
            doi: Some("10.1145/234535.234536"),
        },
    ],
};

impl Entry for StarDiscrepancy {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Metric for StarDiscrepancy {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        star_discrepancy(points)
    }
}

/// The star discrepancy of `points` with the box where it is attained; a lower bound, marked as
/// such, where d >= 3 and the steps run out.
pub fn star_discrepancy(points: &Points) -> Result<Measured, Unmeasured> {
    check(points)?;
    Ok(match points.dimensions() {
        1 => on_the_line(points),
        2 => in_the_plane(points),
        3 => in_space(points),
        _ => branch(points),
    })
}

/// One dimension, exact.
fn on_the_line(points: &Points) -> Measured {
    let mut sorted: Vec<f64> = points.axis(0).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let mut best = Best::default();
    for (i, &x) in sorted.iter().enumerate() {
        // Open box: i points below x; closed box: i + 1 points up to x.
        best.offer(x - i as f64 / n, || vec![x]);
        best.offer((i + 1) as f64 / n - x, || vec![x]);
    }
    best.offer(1.0 - sorted.iter().filter(|&&x| x < 1.0).count() as f64 / n, || vec![1.0]);
    best.measured()
}

/// The largest difference so far, and its box.
#[derive(Default)]
pub(super) struct Best {
    pub(super) value: f64,
    pub(super) corner: Vec<f64>,
}

impl Best {
    pub(super) fn offer(&mut self, value: f64, corner: impl FnOnce() -> Vec<f64>) {
        if value > self.value || self.corner.is_empty() {
            self.value = value;
            self.corner = corner();
        }
    }

    pub(super) fn measured(self) -> Measured {
        Measured { value: self.value, is_bound: false, extremal: self.corner }
    }
}

/// Two dimensions, exact: a sweep over x with blocks of points sorted by y.
fn in_the_plane(points: &Points) -> Measured {
    let mut order: Vec<[f64; 2]> = points.rows().map(|x| [x[0], x[1]]).collect();
    order.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let mut best = [Best::default(), Best::default()];
    sweep(&order, points.len(), [1.0, 1.0], &mut best);
    let [full, empty] = best;
    if full.value > empty.value { full.measured() } else { empty.measured() }
}

/// Offers, for the boxes of the plane, the largest count/n - `heights[0]` x y over closed boxes and
/// the largest `heights[1]` x y - count/n over open ones, of points sorted by x. Boxes of space are
/// this, with the points below a height and the height.
pub(super) fn sweep(order: &[[f64; 2]], n: usize, heights: [f64; 2], best: &mut [Best; 2]) {
    let mut ys: Vec<f64> = order.iter().map(|x| x[1]).chain([1.0]).collect();
    ys.sort_unstable_by(f64::total_cmp);
    ys.dedup();
    let mut sweep = Sweep::new(&ys, n);
    let mut next = 0;
    while next < order.len() {
        let x = order[next][0];
        // Boxes open at x hold the points left of it.
        sweep.largest_empty(x, heights[1], &mut best[1]);
        while next < order.len() && order[next][0] == x {
            sweep.add(order[next][1]);
            next += 1;
        }
        // Boxes closed at x hold those on it as well.
        sweep.largest_full(x, heights[0], &mut best[0]);
    }
    if order.last().is_none_or(|x| x[0] < 1.0) {
        sweep.largest_empty(1.0, heights[1], &mut best[1]);
    }
}

/// The ordinates in blocks, with the counts of points below (open) and up to (closed) each.
struct Sweep<'a> {
    ys: &'a [f64],
    n: f64,
    size: usize,
    /// For each ordinate how many points lie on it.
    on: Vec<u32>,
    blocks: Vec<Block>,
}

/// One block of ordinates: counts inside it, how many points lie in the blocks below, and the hulls
/// of its corners.
#[derive(Default)]
struct Block {
    below: u32,
    /// How many points lie on the block's own ordinates.
    inside: u32,
    /// The last maximum over the full corners, less the share of points then: more points raise it
    /// by their share at most.
    full_base: f64,
    /// The last maximum over the empty corners, less the area times the block's last ordinate then:
    /// more area raises it by as much at most.
    empty_base: f64,
    /// Corners (ordinate, closed count), such that count/n - x y is largest at one of them for
    /// every x.
    full: Vec<(f64, u32)>,
    /// Corners (ordinate, open count), such that x y - count/n is largest at one of them.
    empty: Vec<(f64, u32)>,
}

impl<'a> Sweep<'a> {
    fn new(ys: &'a [f64], n: usize) -> Self {
        // Adding costs a block's size and the number of blocks; asking costs the number of blocks
        // and a search in each.
        let size = ((ys.len() as f64).sqrt()).ceil() as usize;
        let fresh = || Block { full_base: f64::INFINITY, empty_base: f64::INFINITY, ..Block::default() };
        let blocks = (0..ys.len().div_ceil(size)).map(|_| fresh()).collect();
        let mut sweep = Self { ys, n: n as f64, size, on: vec![0; ys.len()], blocks };
        (0..sweep.blocks.len()).for_each(|block| sweep.rebuild(block));
        sweep
    }

    /// Adds a point of ordinate `y`, one of `ys`.
    fn add(&mut self, y: f64) {
        let at = self.ys.partition_point(|&other| other < y);
        self.on[at] += 1;
        let block = at / self.size;
        self.rebuild(block);
        self.blocks[block + 1..].iter_mut().for_each(|block| block.below += 1);
    }

    /// The hulls of one block, by a walk over its ordinates.
    fn rebuild(&mut self, block: usize) {
        let from = block * self.size;
        let to = (from + self.size).min(self.ys.len());
        let Block { mut full, mut empty, below, full_base, empty_base, .. } = std::mem::take(&mut self.blocks[block]);
        full.clear();
        empty.clear();
        let mut count = 0;
        for at in from..to {
            push(&mut empty, (self.ys[at], count), false);
            count += self.on[at];
            push(&mut full, (self.ys[at], count), true);
        }
        self.blocks[block] = Block { below, inside: count, full_base, empty_base, full, empty };
    }

    /// Offers the largest count/n - x y over closed boxes.
    fn largest_full(&mut self, x: f64, height: f64, best: &mut Best) {
        let (n, area) = (self.n, x * height);
        let score = |(y, count): (f64, u32)| f64::from(count) / n - area * y;
        for block in &mut self.blocks {
            let share = f64::from(block.below + block.inside) / n;
            if block.full_base + share + SLACK < best.value {
                continue;
            }
            let (y, count) = peak(&block.full, score);
            let value = score((y, block.below + count));
            block.full_base = value - share;
            best.offer(value, || vec![x, y]);
        }
    }

    /// Offers the largest x y - count/n over open boxes.
    fn largest_empty(&mut self, x: f64, height: f64, best: &mut Best) {
        let (n, area) = (self.n, x * height);
        let score = |(y, count): (f64, u32)| area * y - f64::from(count) / n;
        for block in &mut self.blocks {
            let last = block.empty.last().map_or(1.0, |corner| corner.0);
            if block.empty_base + area * last + SLACK < best.value {
                continue;
            }
            let (y, count) = peak(&block.empty, score);
            let value = score((y, block.below + count));
            block.empty_base = value - area * last;
            best.offer(value, || vec![x, y]);
        }
    }
}

/// More than rounding can make of a bound.
const SLACK: f64 = 1e-12;

/// Adds a corner at the right of a hull that bends down (`upper`) or up.
fn push(hull: &mut Vec<(f64, u32)>, corner: (f64, u32), upper: bool) {
    while let [.., a, b] = hull[..] {
        let left = (b.0 - a.0) * (f64::from(corner.1) - f64::from(a.1));
        let right = (corner.0 - a.0) * (f64::from(b.1) - f64::from(a.1));
        let bends = if upper { left < right } else { left > right };
        if bends {
            break;
        }
        hull.pop();
    }
    hull.push(corner);
}

/// The corner of a hull where `score` is largest: it rises up to there and falls after.
fn peak(hull: &[(f64, u32)], score: impl Fn((f64, u32)) -> f64) -> (f64, u32) {
    let (mut low, mut high) = (0, hull.len() - 1);
    while low < high {
        let middle = usize::midpoint(low, high);
        if score(hull[middle]) < score(hull[middle + 1]) { low = middle + 1 } else { high = middle }
    }
    hull[low]
}
