//! L2 discrepancies: root mean squares over boxes instead of the worst one, with closed forms.
//!
//! **Star** (Warnock): boxes at the origin. D^2 = 3^-d - (2/n) sum_i prod_j (1 - x_ij^2)/2 +
//! (1/n^2) sum_ik prod_j (1 - max(x_ij, x_kj)).
//!
//! **Centred** (Hickernell): boxes at the nearest corner. D^2 = (13/12)^d - (2/n) sum_i prod_j
//! (1 + |z|/2 - z^2/2) + (1/n^2) sum_ik prod_j (1 + |z_i|/2 + |z_k|/2 - |x_i - x_k|/2), z = x -
//! 1/2.
//!
//! **Wrap-around** (Hickernell): boxes on the torus. D^2 = -(4/3)^d + (1/n^2) sum_ik prod_j
//! (3/2 - |x_i - x_k| (1 - |x_i - x_k|)).
//!
//! All values here are **not squared**. The expected square of the star form for independent points
//! is (2^-d - 3^-d) / n.
//!
//! **Cost.** n^2 d / 2 multiplications; the star form in two dimensions n log n.
//!
//! **Limits.** The sums cancel: below about 1e-8 the value is rounding.
//!
//! **Papers.** T. T. Warnock (1972), doi 10.1016/B978-0-12-775950-0.50015-7; F. J. Hickernell,
//! Math. Comp. 67 (1998), doi 10.1090/S0025-5718-98-00894-1; S. Heinrich, Math. Comp. 65 (1996),
//! doi 10.1090/S0025-5718-96-00756-1.
//!
//! ```
//! use workbook::{metrics::l2::star, points::Points};
//! let points = Points::from_rows(1, vec![0.5]).unwrap();
//! assert!((star(&points) - (1.0_f64 / 12.0).sqrt()).abs() < 1e-16);
//! ```

#![expect(clippy::inline_always, reason = "a function of its own would be compiled without the wide registers")]

use super::{Known, Measured, Metric, Unmeasured};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::stats::moments::{Sum, sum};
use crate::stats::portable::power;
use crate::vectors::vectorised;

/// The measure `l2-star`.
pub struct L2Star;
/// The measure `l2-centred`.
pub struct Centred;
/// The measure `l2-wrap-around`.
pub struct WrapAround;

static STAR: About = About {
    key: "l2-star",
    title: "L2 star discrepancy",
    summary: "The root mean square over boxes at the origin of share of points minus volume; not squared.",
    file: "metrics/l2.rs",
    source: include_str!("l2.rs"),
    papers: &[Paper {
        authors: "T. T. Warnock",
        year: 1972,
        title: "Computational Investigations of Low-Discrepancy Point Sets",
        venue: "Applications of Number Theory to Numerical Analysis, Academic Press, 319-343",
        doi: Some("10.1016/B978-0-12-775950-0.50015-7"),
    }],
};
static CENTRED: About = About {
    key: "l2-centred",
    title: "Centred L2 discrepancy",
    summary: "Hickernell's centred L2 discrepancy, not squared.",
    file: "metrics/l2.rs",
    source: include_str!("l2.rs"),
    papers: &[Paper {
        authors: "F. J. Hickernell",
        year: 1998,
        title: "A Generalized Discrepancy and Quadrature Error Bound",
        venue: "Mathematics of Computation 67(221), 299-322",
        doi: Some("10.1090/S0025-5718-98-00894-1"),
    }],
};
static WRAP: About = About {
    key: "l2-wrap-around",
    title: "Wrap-around L2 discrepancy",
    summary: "Hickernell's wrap-around L2 discrepancy, not squared.",
    file: "metrics/l2.rs",
    source: include_str!("l2.rs"),
    papers: &[Paper {
        authors: "F. J. Hickernell",
        year: 1998,
        title: "Lattice Rules: How Well Do They Measure Up?",
        venue: "Random and Quasi-Random Point Sets, LNS 138, 109-166",
        doi: Some("10.1007/978-1-4612-1702-2_3"),
    }],
};
impl Entry for L2Star {
    fn about(&self) -> &'static About {
        &STAR
    }
}
impl Entry for Centred {
    fn about(&self) -> &'static About {
        &CENTRED
    }
}
impl Entry for WrapAround {
    fn about(&self) -> &'static About {
        &WRAP
    }
}

impl Metric for L2Star {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        Ok(Measured::exact(star(points)))
    }

    fn known(&self) -> &'static [Known] {
        &[
            Known {
                method: "centred-grid",
                n: 16,
                d: 1,
                value: "1/(16*sqrt(12))",
                source: "by hand: every interval of length $1/n$ has the same share",
            },
            Known {
                method: "hammersley",
                n: 64,
                d: 2,
                value: "sqrt(6^2/64 + 29*6/192 + 3/8 - 6/2^10 + 1/2^8 - 1/(72*4^6))/64",
                source: "Halton and Zaremba (1969), for $n = 2^m$",
            },
        ]
    }
}

impl Metric for Centred {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        Ok(Measured::exact(centred(points)))
    }

    fn known(&self) -> &'static [Known] {
        &[Known {
            method: "centred-grid",
            n: 64,
            d: 2,
            value: "sqrt((13/12)^2 - 2*(13/12 + 1/(24*64))^2 + (13/12 + 1/(6*64))^2)",
            source: "by hand: on a grid the sums of the formula factor over the axes",
        }]
    }
}

impl Metric for WrapAround {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        Ok(Measured::exact(wrap_around(points)))
    }

    fn known(&self) -> &'static [Known] {
        &[Known {
            method: "grid",
            n: 64,
            d: 2,
            value: "sqrt((4/3 + 1/(6*64))^2 - (4/3)^2)",
            source: "by hand: on a grid the sums of the formula factor over the axes",
        }]
    }
}

/// The L2 star discrepancy.
pub fn star(points: &Points) -> f64 {
    let (n, d) = (points.len() as f64, points.dimensions() as i32);
    let single = sum(points.rows().map(|x| x.iter().map(|x| 0.5 * (1.0 - x * x)).product::<f64>()));
    let double = if d == 2 { pairs_in_the_plane(points) } else { pairs(points, Corner) };
    root(power(3.0, -d) - 2.0 / n * single + double / (n * n))
}

/// The centred L2 discrepancy.
pub fn centred(points: &Points) -> f64 {
    let (n, d) = (points.len() as f64, points.dimensions() as i32);
    let factor = |x: &f64| {
        let z = (x - 0.5).abs();
        1.0 + 0.5 * z - 0.5 * z * z
    };
    let single = sum(points.rows().map(|x| x.iter().map(factor).product::<f64>()));
    let double = pairs(points, Nearest);
    root(power(13.0 / 12.0, d) - 2.0 / n * single + double / (n * n))
}

/// The wrap-around L2 discrepancy.
pub fn wrap_around(points: &Points) -> f64 {
    let (n, d) = (points.len() as f64, points.dimensions() as i32);
    let double = pairs(points, Torus);
    root(double / (n * n) - power(4.0 / 3.0, d))
}

/// The root; 0 where rounding made the square negative.
fn root(square: f64) -> f64 {
    square.max(0.0).sqrt()
}

/// The smaller; one instruction, since neither is NaN.
#[inline(always)]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// A symmetric function of two coordinates, from what can be made of each beforehand.
trait Factor: Copy {
    /// What is made of a coordinate.
    fn of(self, x: f64) -> [f64; 2];

    /// The factor, of what is made of both.
    fn pair(self, a: [f64; 2], b: [f64; 2]) -> f64;
}

/// 1 - max(x, y).
#[derive(Clone, Copy)]
struct Corner;

impl Factor for Corner {
    fn of(self, x: f64) -> [f64; 2] {
        [1.0 - x, 0.0]
    }

    #[inline(always)]
    fn pair(self, a: [f64; 2], b: [f64; 2]) -> f64 {
        least(a[0], b[0])
    }
}

/// 1 + |z|/2 + |w|/2 - |z - w|/2, z = x - 1/2, w = y - 1/2: that is 1 and the smaller of |z| and
/// |w|, or 1 if their signs differ.
#[derive(Clone, Copy)]
struct Nearest;

impl Factor for Nearest {
    fn of(self, x: f64) -> [f64; 2] {
        [1.0 + (x - 0.5).max(0.0), (0.5 - x).max(0.0)]
    }

    #[inline(always)]
    fn pair(self, a: [f64; 2], b: [f64; 2]) -> f64 {
        least(a[0], b[0]) + least(a[1], b[1])
    }
}

/// 3/2 - |x - y| (1 - |x - y|).
#[derive(Clone, Copy)]
struct Torus;

impl Factor for Torus {
    fn of(self, x: f64) -> [f64; 2] {
        [x, 0.0]
    }

    #[inline(always)]
    fn pair(self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let distance = (a[0] - b[0]).abs();
        1.5 - distance * (1.0 - distance)
    }
}

/// One axis: what is made of each coordinate, and zeros up to whole lanes.
type Axis = [Vec<f64>; 2];

/// The sum over all pairs, ordered, of the product over axes of `factor`.
fn pairs(points: &Points, factor: impl Factor) -> f64 {
    // Axis by axis, so that the inner loop runs over neighbours in memory.
    let axis = |axis| {
        [0, 1].map(|part| {
            let mut column: Vec<f64> = points.axis(axis).map(|x| factor.of(x)[part]).collect();
            column.resize(points.len() + LANES, 0.0);
            column
        })
    };
    all_pairs(&(0..points.dimensions()).map(axis).collect::<Vec<_>>(), points.len(), factor)
}

vectorised! {
    /// The same, of `n` points that are prepared; the same order of roundings on every processor.
    fn all_pairs<F: Factor>(axes: &[Axis], n: usize, factor: F) -> f64 {
        let mut total = Sum::default();
        for i in 0..n {
            let mut lanes = [0.0; LANES];
            let mut from = i + 1;
            while from + LANES <= n {
                let products = products(axes, i, from, factor);
                for (lane, product) in lanes.iter_mut().zip(&products) {
                    *lane += product;
                }
                from += LANES;
            }
            let (mut sum, mut rest) = (0.0, 0.0);
            for product in &products(axes, i, from, factor)[..n - from] {
                rest += product;
            }
            for lane in lanes {
                sum += lane;
            }
            // Each pair counts twice, a point with itself once.
            let own = products(axes, i, i, factor)[0];
            total.add(2.0 * (sum + rest) + own);
        }
        total.value()
    }
}

/// The products for point i and the points from `from` on.
#[inline(always)]
fn products<F: Factor>(axes: &[Axis], i: usize, from: usize, factor: F) -> [f64; LANES] {
    let mut products = [1.0; LANES];
    for [a, b] in axes {
        let own = [a[i], b[i]];
        for ((product, a), b) in products.iter_mut().zip(&a[from..from + LANES]).zip(&b[from..from + LANES]) {
            *product *= factor.pair(own, [*a, *b]);
        }
    }
    products
}

/// Pairs side by side.
const LANES: usize = 32;

/// The double sum of the star form in the plane, in n log n: points by falling x, so that the
/// maximum in x is known, and prefix sums over y in a tree.
fn pairs_in_the_plane(points: &Points) -> f64 {
    let n = points.len();
    let mut order: Vec<&[f64]> = points.rows().collect();
    order.sort_unstable_by(|a, b| b[0].total_cmp(&a[0]));
    let mut ys: Vec<f64> = points.axis(1).collect();
    ys.sort_unstable_by(f64::total_cmp);
    // For the points so far: sums of (1 - x) and of (1 - x)(1 - y), by the rank of y.
    let (mut widths, mut areas) = (Tree::new(n), Tree::new(n));
    let (mut all, mut total) = (0.0, Sum::default());
    for x in order {
        let rank = ys.partition_point(|&y| y < x[1]);
        let (width, height) = (1.0 - x[0], 1.0 - x[1]);
        // Points before have the larger x: theirs is the width. Where their y is lower, this
        // point's height counts, else their own.
        let lower = widths.prefix(rank);
        total.add(2.0 * (lower * height + areas.suffix(rank, all)) + width * height);
        widths.add(rank, width);
        areas.add(rank, width * height);
        all += width * height;
    }
    total.value()
}

/// Prefix sums under additions (Fenwick 1994, doi 10.1002/spe.4380240306).
struct Tree(Vec<f64>);

impl Tree {
    fn new(n: usize) -> Self {
        Self(vec![0.0; n + 1])
    }

    fn add(&mut self, at: usize, value: f64) {
        let mut k = at + 1;
        while k < self.0.len() {
            self.0[k] += value;
            k += k & k.wrapping_neg();
        }
    }

    /// The sum of what was added below `end`.
    fn prefix(&self, end: usize) -> f64 {
        let (mut k, mut total) = (end, 0.0);
        while k > 0 {
            total += self.0[k];
            k &= k - 1;
        }
        total
    }

    /// The sum of what was added from `start` on, where `all` is the sum of everything.
    fn suffix(&self, start: usize, all: f64) -> f64 {
        all - self.prefix(start)
    }
}
