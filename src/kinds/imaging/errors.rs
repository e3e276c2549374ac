//! What the errors of a picture's pixels are like: how large, how biased, how like their neighbours', and of which frequencies.

use serde::{Deserialize, Serialize};

use crate::kinds::estimation::mean_with_error;
use crate::stats::{fourier, moments};

/// Into how many rings the frequencies up to half a cycle a pixel are cut.
pub const RINGS: usize = 24;

/// The highest frequency that counts as low, in cycles a pixel.
const LOW: f64 = 1.0 / 16.0;

/// The errors of a picture, summed up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// The root mean square, without what the reference's own error adds to it.
    pub rmse: f64,
    /// Its standard error, where pixels are independent.
    pub rmse_error: Option<f64>,
    /// The mean.
    pub bias: f64,
    /// Its standard error, where pixels are independent.
    pub bias_error: Option<f64>,
    /// The correlation of errors of pixels that are next to each other; about 0 where pixels are independent.
    pub neighbours: f64,
    /// The standard error of that correlation if pixels are independent.
    pub neighbours_error: f64,
    /// The mean power at low frequencies, 1 where pixels are independent.
    pub low: f64,
    /// The standard error of that power if pixels are independent and of one variance; more where a few pixels err most.
    pub low_error: f64,
    /// The largest power at any frequency but 0; about the logarithm of their number where pixels are independent.
    pub peak: f64,
    /// The mean power in each of [`RINGS`] rings; NaN in an empty one.
    pub rings: Vec<f64>,
    /// The power at every frequency, row by row, that of frequency 0 first.
    #[serde(skip)]
    pub powers: Vec<f64>,
}

impl Errors {
    /// Sums up the errors of pixels in rows of `width`, against a reference of root mean square error `floor`. `independent` tells
    /// whether the pixels have samples that are independent of each other.
    pub fn new(errors: &[f64], width: usize, floor: f64, independent: bool) -> Self {
        let squares: Vec<f64> = errors.iter().map(|error| error * error).collect();
        let (square, square_error) = mean_with_error(&squares);
        let rmse = (square - floor * floor).max(0.0).sqrt();
        let (bias, bias_error) = mean_with_error(errors);
        let (neighbours, neighbours_error) = neighbours(errors, width, square);
        let powers = fourier::power(errors, width);
        let (rings, low, count) = rings(&powers, width);
        let largest = powers.iter().skip(1).copied().fold(0.0, f64::max);
        Self {
            rmse,
            rmse_error: square_error.filter(|_| independent && rmse > 0.0).map(|error| error / (2.0 * rmse)),
            bias,
            bias_error: bias_error.filter(|_| independent),
            neighbours,
            neighbours_error,
            low,
            // Powers come in pairs of equals, and each is as large as its standard deviation.
            low_error: (2.0 / count as f64).sqrt(),
            peak: largest,
            rings,
            powers,
        }
    }
}

/// The correlation of neighbours, across and along, whose mean square is `square`, and its standard error if they are independent: the
/// products then have mean 0, whatever the variances of the pixels.
fn neighbours(errors: &[f64], width: usize, square: f64) -> (f64, f64) {
    let across = errors.chunks_exact(width.max(1)).flat_map(|row| row.windows(2).map(|pair| pair[0] * pair[1]));
    let along = errors.iter().zip(errors.iter().skip(width)).map(|(a, b)| a * b);
    let products: Vec<f64> = across.chain(along).collect();
    if square <= 0.0 || products.is_empty() {
        return (0.0, 0.0);
    }
    let spread = moments::root_mean_square(&products) / (products.len() as f64).sqrt();
    (moments::mean(&products) / square, spread / square)
}

/// The mean power in each ring, the mean power at low frequencies, and how many those are.
fn rings(powers: &[f64], width: usize) -> (Vec<f64>, f64, usize) {
    let height = powers.len().checked_div(width).unwrap_or(0);
    let cycles = |k: usize, n: usize| k.min(n - k) as f64 / n as f64;
    let mut rings = vec![Vec::new(); RINGS];
    let mut low = Vec::new();
    for (at, &power) in powers.iter().enumerate().skip(1) {
        let (u, v) = (cycles(at % width, width), cycles(at / width, height));
        let frequency = (u * u + v * v).sqrt();
        if frequency < LOW {
            low.push(power);
        }
        if let Some(ring) = rings.get_mut((frequency * 2.0 * RINGS as f64) as usize) {
            ring.push(power);
        }
    }
    (rings.iter().map(|ring| moments::mean(ring)).collect(), moments::mean(&low), low.len())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seed::Seed;

    #[test]
    fn independent_errors_are_told_from_a_pattern() {
        let (width, height) = (64, 48);
        let mut random = Seed::new(8).named("errors").generator();
        // Of very different variances, as in a picture, and yet flat.
        let noise: Vec<f64> =
            (0..width * height).map(|at| (random.uniform() - 0.5) * if at % width < 20 { 5.0 } else { 0.5 }).collect();
        let noise = Errors::new(&noise, width, 0.0, true);
        assert!((noise.low - 1.0).abs() < 4.0 * noise.low_error && noise.neighbours.abs() < 0.1, "{noise:?}");
        assert!(noise.peak < 30.0);
        let waves: Vec<f64> = (0..width * height).map(|at| f64::from((at % width / 8) as u32 % 2) - 0.5).collect();
        let waves = Errors::new(&waves, width, 0.3, false);
        assert!(waves.neighbours > 0.8 && waves.peak > 300.0 && waves.rmse_error.is_none(), "{waves:?}");
        // 0.5 squared less the reference's 0.3 squared.
        assert!((waves.rmse - 0.4).abs() < 1e-12);
    }
}
