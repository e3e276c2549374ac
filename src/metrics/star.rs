//! The star discrepancy: the largest difference between the share of points in a box at the origin
//! and the box's volume.
//!
//! **Formula.** D* = sup over boxes \[0, q) in the unit cube of | #{x_i in \[0, q)} / n - vol |.
//! The supremum needs boxes open and closed at their upper faces, whose corners have coordinates of
//! points or 1.
//!
//! **Algorithms.** One dimension: sorting, 1/(2n) + max |x_(i) - (2i-1)/(2n)|. Two: a sweep along x
//! over blocks in y, n^(3/2) additions and comparisons of which many go side by side. Three: such sweeps at heights that bounds cannot
//! skip. More: all boxes of the grid of coordinates, in the order of a tree that drops a branch as
//! soon as its best bound is below the best found, up to a fixed number of steps; beyond, a lower
//! bound, and called so.
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
use super::star_sweep::sweep;
use super::{Known, Measured, Metric, Unmeasured, check};
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

    fn known(&self) -> &'static [Known] {
        &[
            Known {
                method: "centred-grid",
                n: 16,
                d: 1,
                value: "1/(2*16)",
                source: "the least that 16 points of the line can have (Niederreiter 1972)",
            },
            Known {
                method: "grid",
                n: 64,
                d: 2,
                value: "1 - (1 - 1/8)^2",
                source: "the box that ends just before the last row and the last column",
            },
            Known {
                method: "centred-grid",
                n: 64,
                d: 2,
                value: "(1 - 1/32)/8",
                source: "the box that ends just before the last column",
            },
            Known {
                method: "hammersley",
                n: 64,
                d: 2,
                value: "(6/3 + 13/9 - 4/(9*64))/64",
                source: "Halton and Zaremba (1969), for $n = 2^m$",
            },
        ]
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

/// Two dimensions, exact: a sweep over x.
fn in_the_plane(points: &Points) -> Measured {
    let mut ordinates: Vec<f64> = points.axis(1).chain([1.0]).collect();
    ordinates.sort_unstable_by(f64::total_cmp);
    ordinates.dedup();
    let rank = |y: f64| ordinates.partition_point(|&other| other < y);
    let mut order: Vec<(f64, usize)> = points.rows().map(|x| (x[0], rank(x[1]))).collect();
    order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let mut best = [Best::default(), Best::default()];
    sweep(&order, &ordinates, points.len(), [1.0, 1.0], &mut best);
    let [full, empty] = best;
    if full.value > empty.value { full.measured() } else { empty.measured() }
}
