//! The measures: how even a point set is. Exact values are exact; bounds are called bounds.
//!
//! Points must lie in the closed unit cube; [`check`] tells the first that does not.

use crate::catalogue::{About, Entry};
use crate::points::Points;
use std::fmt::{Display, Formatter};

pub mod correlation;
pub mod dispersion;
pub mod l2;
pub mod nets;
pub mod occupancy;
pub mod spectrum;
pub mod star;
mod star_bound;
mod star_space;
mod star_sweep;

/// Every measure that is one number, in the order of display.
pub static METRICS: &[&dyn Metric] = &[
    &star::StarDiscrepancy,
    &l2::L2Star,
    &l2::Centred,
    &l2::WrapAround,
    &dispersion::MinimumDistance,
    &dispersion::RelativeRadius,
    &nets::Quality,
    &correlation::LargestCorrelation,
];

/// A measure of a point set.
pub trait Metric: Entry + Sync {
    /// Its value for `points`, which [`check`] has found valid.
    fn measure(&self, points: &Points) -> Result<Measured, Unmeasured>;

    /// Values that are known exactly, from a publication or by hand.
    fn known(&self) -> &'static [Known] {
        &[]
    }
}

/// The exact value of a measure for points that anybody can place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Known {
    /// The method that places them, the same for every seed.
    pub method: &'static str,
    /// How many.
    pub n: usize,
    /// In how many dimensions.
    pub d: usize,
    /// The value as an expression.
    pub value: &'static str,
    /// Where it comes from, without a full stop.
    pub source: &'static str,
}

/// The value of a measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// Whether the value is a proven lower bound only, because the exact one is out of reach.
    pub is_bound: bool,
    /// The upper corner of the box where a discrepancy is attained; empty for other measures.
    pub extremal: Vec<f64>,
}

impl Measured {
    /// An exact value without a box.
    pub fn exact(value: f64) -> Self {
        Self { value, is_bound: false, extremal: Vec::new() }
    }
}

/// Why points cannot be measured.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Unmeasured {
    /// There is no point.
    Empty,
    /// A coordinate is not a number in [0, 1].
    Coordinate {
        /// The index of the point.
        point: usize,
        /// The axis.
        axis: usize,
        /// The value.
        value: f64,
    },
    /// Too many points for this measure in so many dimensions.
    Size {
        /// The number of points.
        n: usize,
        /// The dimensions.
        d: usize,
        /// What is possible.
        limit: &'static str,
    },
    /// Too few points or dimensions, or points of another kind than the measure is for.
    Kind(&'static str),
}

impl Display for Unmeasured {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Empty => f.write_str("there is no point"),
            Self::Coordinate { point, axis, value } => {
                write!(f, "coordinate {axis} of point {point} is {value}, not a number from 0 to 1")
            }
            Self::Size { n, d, limit } => write!(f, "n = {n} points of d = {d} dimensions are too many: {limit}"),
            Self::Kind(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for Unmeasured {}

/// Checks that there are points and that all coordinates are numbers from 0 to 1.
pub fn check(points: &Points) -> Result<(), Unmeasured> {
    if points.is_empty() {
        return Err(Unmeasured::Empty);
    }
    let d = points.dimensions();
    let bad = points.coordinates().iter().position(|x| !(0.0..=1.0).contains(x));
    bad.map_or(Ok(()), |at| {
        Err(Unmeasured::Coordinate { point: at / d, axis: at % d, value: points.coordinates()[at] })
    })
}

/// Checks `points` and measures them.
pub fn measure(metric: &dyn Metric, points: &Points) -> Result<Measured, Unmeasured> {
    check(points)?;
    metric.measure(points)
}

/// The measures' entries, for lists.
pub fn abouts() -> impl Iterator<Item = &'static About> {
    METRICS.iter().map(|metric| metric.about())
}
