//! The power spectrum of a picture: the discrete Fourier transform of its values in two dimensions.
//!
//! F(u, v) = sum f(x, y) exp(-2 pi i (u x / w + v y / h)), by rows and then by columns: w h (w + h) steps, little for the small pictures of a book.
//! Values that are independent with mean 0, of whatever variances, have a spectrum that is flat in expectation.

use crate::stats::portable;
use std::f64::consts::TAU;

/// |F(u, v)|^2 over the sum of |f|^2 at `v * width + u`, for u < width and v < height: the mean over all frequencies is 1. `values` are
/// row-major, `width` to a row. Zeros where all values are 0, or their number is no multiple of `width`.
pub fn power(values: &[f64], width: usize) -> Vec<f64> {
    let height = values.len().checked_div(width).unwrap_or(0);
    let total: f64 = values.iter().map(|value| value * value).sum();
    if total <= 0.0 || width * height != values.len() {
        return vec![0.0; values.len()];
    }
    let (across, along) = (roots(width), roots(height));
    // Real rows: the frequencies beyond the middle are the conjugates of those before it.
    let half = width / 2 + 1;
    let mut columns = vec![vec![(0.0, 0.0); height]; half];
    for (y, row) in values.chunks_exact(width).enumerate() {
        for (u, column) in columns.iter_mut().enumerate() {
            column[y] = transform(row.iter().map(|&value| (value, 0.0)), &across, u);
        }
    }
    let mut out = vec![0.0; values.len()];
    for (u, column) in columns.iter().enumerate() {
        for v in 0..height {
            let (re, im) = transform(column.iter().copied(), &along, v);
            let power = (re * re + im * im) / total;
            out[v * width + u] = power;
            // P(-u, -v) = P(u, v).
            out[(height - v) % height * width + (width - u) % width] = power;
        }
    }
    out
}

/// One coefficient of the transform of `values`.
fn transform(values: impl Iterator<Item = (f64, f64)>, roots: &[(f64, f64)], frequency: usize) -> (f64, f64) {
    let (mut re, mut im, mut at) = (0.0, 0.0, 0);
    for (a, b) in values {
        let (cos, sin) = roots[at];
        re += a * cos + b * sin;
        im += b * cos - a * sin;
        at += frequency;
        if at >= roots.len() {
            at -= roots.len();
        }
    }
    (re, im)
}

/// cos and sin of k n-ths of a turn.
fn roots(n: usize) -> Vec<(f64, f64)> {
    let angle = |k: usize| TAU * k as f64 / n as f64;
    (0..n).map(|k| (portable::cos(angle(k)), portable::sin(angle(k)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::seed::Seed;

    #[test]
    fn a_wave_is_one_frequency_and_its_mirror() {
        let (width, height) = (12, 8);
        let wave =
            |at: usize| portable::cos(TAU * (3.0 * (at % width) as f64 / 12.0 + 2.0 * (at / width) as f64 / 8.0));
        let values: Vec<f64> = (0..width * height).map(wave).collect();
        let power = power(&values, width);
        for (at, &found) in power.iter().enumerate() {
            let (u, v) = (at % width, at / width);
            let expected = if (u, v) == (3, 2) || (u, v) == (9, 6) { 48.0 } else { 0.0 };
            assert!((found - expected).abs() < 1e-9, "{u} {v}: {found}");
        }
    }

    /// Parseval: the mean power is 1, for odd sides as for even ones; and the first coefficient is the sum.
    #[test]
    fn the_mean_power_is_one() {
        let mut random = Seed::new(2).named("fourier").generator();
        for (width, height) in [(7, 5), (8, 6), (1, 9), (9, 1), (16, 3)] {
            let values: Vec<f64> = (0..width * height).map(|_| random.uniform() - 0.3).collect();
            let power = power(&values, width);
            let mean = power.iter().sum::<f64>() / power.len() as f64;
            assert!((mean - 1.0).abs() < 1e-12, "{mean}");
            let (sum, squares): (f64, f64) = (values.iter().sum(), values.iter().map(|value| value * value).sum());
            assert!((power[0] - sum * sum / squares).abs() < 1e-12);
        }
        assert_eq!(power(&[0.0; 6], 3), [0.0; 6]);
        assert_eq!(power(&[], 0), [0.0; 0]);
    }
}
