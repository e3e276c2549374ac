//! Genz's corner peak family.
//!
//! **Formula.** (1 + sum a_j x_j)^-(d+1), in any d; a_j as in [`genz`](super::genz).
//!
//! **Integral and variance.** Integrating (1 + s)^-p along each axis once gives the alternating sum
//! over the corners of the cube of (1 + a.corner)^-(p-d), over (p - 1) ... (p - d) prod a_j; with
//! p = d + 1 the mean, with 2 d + 2 the second moment. Stated for d <= 12, beyond which the 2^d
//! terms cancel too many digits.

use super::Integrand;
use super::genz::{difficulty, product, sum};
use crate::catalogue::{About, Entry, Paper};
use crate::stats::moments;
use crate::stats::portable::power;

/// The integrand `genz-corner-peak`.
pub struct CornerPeak;

static ABOUT: About = About {
    key: "genz-corner-peak",
    title: "Genz: corner peak",
    summary: "Genz's corner peak family, (1 + sum a_j x_j)^-(d+1).",
    file: "integrands/genz_corner_peak.rs",
    source: include_str!("genz_corner_peak.rs"),
    papers: &[Paper {
        authors: "A. Genz",
        year: 1984,
        title: "Testing Multidimensional Integration Routines",
        venue: "Tools, Methods and Languages for Scientific and Engineering Computation, North-Holland, 81-94",
        doi: None,
    }],
};

impl Entry for CornerPeak {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for CornerPeak {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        power(1.0 + sum(x, |x, a, _| a * x), -(x.len() as i32 + 1))
    }

    fn integral(&self, d: usize) -> Option<f64> {
        over_corners(d, d + 1)
    }

    fn variance(&self, d: usize) -> Option<f64> {
        let mean = self.integral(d)?;
        Some(over_corners(d, 2 * d + 2)? - mean * mean)
    }

    fn formula(&self) -> &'static str {
        r"\left(1 + \sum_j a_j x_j\right)^{-(d+1)}"
    }
}

/// The most dimensions for which the alternating sum keeps its digits.
const MOST: usize = 12;

/// The integral of (1 + sum a_j x_j)^-p over the cube, p > d.
fn over_corners(d: usize, p: usize) -> Option<f64> {
    if d > MOST {
        return None;
    }
    let term = |corner: u32| {
        let reach: f64 = (0..d).filter(|axis| corner >> axis & 1 == 1).map(difficulty).sum();
        let sign = if corner.count_ones().is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * power(1.0 + reach, d as i32 - p as i32)
    };
    let falling: f64 = (1..=d).map(|k| (p - k) as f64).product();
    Some(moments::sum((0..1 << d).map(term)) / (falling * product(d, |a, _| a)))
}
