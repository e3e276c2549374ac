//! Distances on the torus: the smallest, and the same relative to the best possible.
//!
//! **Formula.** The relative radius is d_min over the distance of neighbours in the densest lattice,
//! in the plane sqrt(2 / (sqrt(3) n)): 1 for that lattice; good blue noise has 0.65 to 0.8,
//! independent points about 0.
//!
//! **Cost.** Linear in n in up to four dimensions, with buckets; n^2 d / 2 in more.
//!
//! **Paper.** A. Lagae and P. Dutre, A Comparison of Methods for Generating Poisson Disk
//! Distributions, Comput. Graph. Forum 27(1) (2008), doi 10.1111/j.1467-8659.2007.01100.x.
//!
//! ```
//! use workbook::{metrics::dispersion::minimum_distance, points::Points};
//! let points = Points::from_rows(2, vec![0.0, 0.0, 0.9, 0.0]).unwrap();
//! assert!((minimum_distance(&points).unwrap() - 0.1).abs() < 1e-15);
//! ```

use super::{Known, Measured, Metric, Unmeasured};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::samplers::digits::root;
use crate::samplers::poisson::{Buckets, densest};

/// The measure `minimum-distance`.
pub struct MinimumDistance;
/// The measure `relative-radius`.
pub struct RelativeRadius;

static DISTANCE: About = About {
    key: "minimum-distance",
    title: "Minimum distance",
    summary: "The smallest distance of two points on the torus.",
    file: "metrics/dispersion.rs",
    source: include_str!("dispersion.rs"),
    papers: &[Paper {
        authors: "A. Lagae and P. Dutré",
        year: 2008,
        title: "A Comparison of Methods for Generating Poisson Disk Distributions",
        venue: "Computer Graphics Forum 27(1), 114-129",
        doi: Some("10.1111/j.1467-8659.2007.01100.x"),
    }],
};
static RADIUS: About = About {
    key: "relative-radius",
    title: "Relative radius",
    summary: "The smallest distance on the torus over that of the densest lattice of as many points; up to four dimensions.",
    file: "metrics/dispersion.rs",
    source: include_str!("dispersion.rs"),
    papers: &[Paper {
        authors: "A. Lagae and P. Dutré",
        year: 2008,
        title: "A Comparison of Methods for Generating Poisson Disk Distributions",
        venue: "Computer Graphics Forum 27(1), 114-129",
        doi: Some("10.1111/j.1467-8659.2007.01100.x"),
    }],
};
impl Entry for MinimumDistance {
    fn about(&self) -> &'static About {
        &DISTANCE
    }
}
impl Entry for RelativeRadius {
    fn about(&self) -> &'static About {
        &RADIUS
    }
}

impl Metric for MinimumDistance {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        minimum_distance(points).map(Measured::exact).ok_or(Unmeasured::Kind("a distance needs two points"))
    }

    fn known(&self) -> &'static [Known] {
        &[
            Known { method: "grid", n: 64, d: 2, value: "1/8", source: "the side of a cell" },
            Known { method: "centred-grid", n: 256, d: 2, value: "1/16", source: "the side of a cell" },
        ]
    }
}

impl Metric for RelativeRadius {
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured> {
        let best = densest(points.len(), points.dimensions())
            .ok_or(Unmeasured::Kind("the relative radius is defined in one to four dimensions"))?;
        let distance = minimum_distance(points).ok_or(Unmeasured::Kind("a distance needs two points"))?;
        Ok(Measured::exact(distance / best))
    }

    fn known(&self) -> &'static [Known] {
        &[Known {
            method: "grid",
            n: 64,
            d: 2,
            value: "sqrt(sqrt(3)/2)",
            source: "the square lattice against the hexagonal one",
        }]
    }
}

/// The smallest distance of two points on the torus; `None` of fewer than two.
pub fn minimum_distance(points: &Points) -> Option<f64> {
    if points.len() < 2 {
        return None;
    }
    let square = match points.dimensions() {
        1 => in_buckets::<1>(points),
        2 => in_buckets::<2>(points),
        3 => in_buckets::<3>(points),
        4 => in_buckets::<4>(points),
        _ => pairwise(points),
    };
    Some(square.sqrt())
}

/// Each point asks for its nearest among those before it.
fn in_buckets<const D: usize>(points: &Points) -> f64 {
    let side = root(points.len() as u64, D as u32) as usize;
    let mut buckets = Buckets::<D>::new(side);
    let mut best = f64::INFINITY;
    for row in points.rows() {
        // 1 is 0 on the torus.
        let place = std::array::from_fn(|axis| row[axis] % 1.0);
        best = best.min(buckets.nearest_below(place, best));
        buckets.add(place);
    }
    best
}

fn pairwise(points: &Points) -> f64 {
    let wrapped = |x: &f64, y: &f64| {
        let difference = (x - y).abs();
        difference.min(1.0 - difference)
    };
    let square = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| wrapped(x, y) * wrapped(x, y)).sum::<f64>();
    let rows: Vec<&[f64]> = points.rows().collect();
    let pairs = rows.iter().enumerate().flat_map(|(i, a)| rows[..i].iter().map(move |b| square(a, b)));
    pairs.fold(f64::INFINITY, f64::min)
}
