//! Correlations of projections: Pearson's r of two axes, and the largest over all pairs.
//!
//! Late axes of the plain Halton sequence are all but equal for many points: axes 32 and 33 have
//! r = 1 for the first 131.
//!
//! **Paper.** E. Braaten and G. Weller, An Improved Low-Discrepancy Sequence for Multidimensional
//! Quasi-Monte Carlo Integration, J. Comput. Phys. 33(2) (1979), doi 10.1016/0021-9991(79)90019-6,
//! which points the fault out.
//!
//! ```
//! use workbook::{metrics::correlation::pearson, points::Points};
//! let points = Points::from_rows(2, vec![0.0, 1.0, 0.5, 0.5, 1.0, 0.0]).unwrap();
//! assert_eq!(pearson(&points, 0, 1), Some(-1.0));
//! ```

use super::{Known, Measured, Metric, Unmeasured};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::stats::moments::sum;

/// The measure `largest-correlation`.
pub struct LargestCorrelation;

static ABOUT: About = About {
    key: "largest-correlation",
    title: "Largest correlation",
    summary: "The largest absolute value of Pearson's r over all pairs of axes.",
    file: "metrics/correlation.rs",
    source: include_str!("correlation.rs"),
    papers: &[Paper {
        authors: "E. Braaten and G. Weller",
        year: 1979,
        title: "An Improved Low-Discrepancy Sequence for Multidimensional Quasi-Monte Carlo Integration",
        venue: "Journal of Computational Physics 33(2), 249-258",
        doi: Some("10.1016/0021-9991(79)90019-6"),
    }],
};
impl Entry for LargestCorrelation {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Metric for LargestCorrelation {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        let d = points.dimensions();
        let pairs = (0..d).flat_map(|i| (0..i).map(move |j| (i, j)));
        let largest = pairs.filter_map(|(i, j)| pearson(points, i, j)).map(f64::abs).reduce(f64::max);
        largest.map(Measured::exact).ok_or(Unmeasured::Kind("a correlation needs two axes that both vary"))
    }

    fn known(&self) -> &'static [Known] {
        &[
            Known { method: "centred-grid", n: 64, d: 2, value: "0", source: "the axes of a grid are independent" },
            Known { method: "korobov(generator=1)", n: 64, d: 2, value: "1", source: "both axes are the same" },
        ]
    }
}

/// Pearson's r of the axes `i` and `j`; `None` where one does not vary.
pub fn pearson(points: &Points, i: usize, j: usize) -> Option<f64> {
    let n = points.len() as f64;
    let centre = |axis| sum(points.axis(axis)) / n;
    let (a, b) = (centre(i), centre(j));
    let product = |f: &dyn Fn(&[f64]) -> f64| sum(points.rows().map(f));
    let covariance = product(&|x| (x[i] - a) * (x[j] - b));
    let spread = (product(&|x| (x[i] - a) * (x[i] - a)) * product(&|x| (x[j] - b) * (x[j] - b))).sqrt();
    (spread > 0.0).then(|| (covariance / spread).clamp(-1.0, 1.0))
}
