//! The normal law: density, distribution and quantile.

use super::portable;
use std::f64::consts::{PI, SQRT_2};

/// The density at `x` of the normal law with mean `mean` and standard deviation `deviation > 0`.
pub fn density(x: f64, mean: f64, deviation: f64) -> f64 {
    let z = (x - mean) / deviation;
    portable::exp(-0.5 * z * z) / (deviation * (2.0 * PI).sqrt())
}

/// The probability that a standard normal variable is at most `z`.
pub fn distribution(z: f64) -> f64 {
    0.5 * portable::erfc(-z / SQRT_2)
}

/// The `z` that a standard normal variable stays below with probability `p` in (0, 1); infinite at
/// the ends, NaN outside.
pub fn quantile(p: f64) -> f64 {
    -SQRT_2 * pxfm::f_erfcinv(2.0 * p)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Abramowitz and Stegun, tables 26.1 and 26.5.
    #[test]
    fn tabulated_values() {
        assert!((density(0.0, 0.0, 1.0) - 0.398_942_280_401_432_7).abs() < 1e-16);
        assert!((density(5.0, 1.0, 2.0) - 0.053_990_966_513_188_06 / 2.0).abs() < 1e-16);
        assert!((distribution(1.0) - 0.841_344_746_068_542_9).abs() < 1e-15);
        assert!((quantile(0.975) - 1.959_963_984_540_054).abs() < 1e-14);
        assert_eq!(quantile(0.5), 0.0);
    }
}
