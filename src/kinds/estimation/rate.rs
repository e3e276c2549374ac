//! Errors over N: root mean squares with their standard errors, and the rates at which they fall.

use serde::{Deserialize, Serialize};

use super::mean_with_error;
use crate::stats::{portable, regression};

/// The root of the mean of the squares of `errors`, with its standard error, which a single error or no error at all does not have.
pub fn root_mean_square(errors: &[f64]) -> (f64, Option<f64>) {
    let squares: Vec<f64> = errors.iter().map(|error| error * error).collect();
    let (square, square_error) = mean_with_error(&squares);
    let root = square.sqrt();
    // The derivative of the root carries the error of the mean square over to the root.
    (root, square_error.filter(|_| root > 0.0).map(|error| error / (2.0 * root)))
}

/// How fast an error falls: the exponent of N, with its standard error where more than two errors tell it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Rate {
    /// The slope on logarithmic axes.
    pub slope: f64,
    /// Its standard error.
    pub error: Option<f64>,
}

/// The least-squares slope through `(N, error)` on logarithmic axes; errors that are not positive say nothing and are left out.
pub fn rate(points: impl IntoIterator<Item = (f64, f64)>) -> Option<Rate> {
    let positive = points.into_iter().filter(|point| point.0 > 0.0 && point.1 > 0.0);
    let (x, y): (Vec<f64>, Vec<f64>) = positive.map(|(n, error)| (portable::log2(n), portable::log2(error))).unzip();
    let line = regression::least_squares(&x, &y)?;
    Some(Rate { slope: line.slope, error: Some(line.slope_error).filter(|error| error.is_finite()) })
}
