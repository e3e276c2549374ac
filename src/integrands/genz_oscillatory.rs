//! Genz's oscillatory family.
//!
//! **Formula.** cos(2 pi u_1 + sum a_j x_j), in any d; a_j and u_j as in [`genz`](super::genz).
//!
//! **Integral and variance.** The integral of exp(i a x) is exp(i a/2) 2 sin(a/2)/a, so that the
//! mean is cos(2 pi u_1 + sum a_j/2) prod 2 sin(a_j/2)/a_j; cos^2 = (1 + cos of twice the angle)/2
//! gives the variance.

use super::Integrand;
use super::genz::{product, shift, sum};
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable::{cos, sin};
use std::f64::consts::TAU;

/// The integrand `genz-oscillatory`.
pub struct Oscillatory;

static ABOUT: About = About {
    key: "genz-oscillatory",
    title: "Genz: oscillatory",
    summary: "Genz's oscillatory family, cos(2 pi u_1 + sum a_j x_j).",
    file: "integrands/genz_oscillatory.rs",
    source: include_str!("genz_oscillatory.rs"),
    papers: &[Paper {
        authors: "A. Genz",
        year: 1984,
        title: "Testing Multidimensional Integration Routines",
        venue: "Tools, Methods and Languages for Scientific and Engineering Computation, North-Holland, 81-94",
        doi: None,
    }],
};

impl Entry for Oscillatory {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Oscillatory {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        cos(TAU * shift(0) + sum(x, |x, a, _| a * x))
    }

    fn integral(&self, d: usize) -> Option<f64> {
        Some(mean_of_wave(d, 1.0))
    }

    fn variance(&self, d: usize) -> Option<f64> {
        let mean = self.integral(d)?;
        Some(0.5 + 0.5 * mean_of_wave(d, 2.0) - mean * mean)
    }

    fn formula(&self) -> &'static str {
        r"\cos\left(2\pi u_1 + \sum_j a_j x_j\right)"
    }
}

/// The mean of cos(multiple (2 pi u_1 + sum a_j x_j)).
fn mean_of_wave(d: usize, multiple: f64) -> f64 {
    let middle = sum(&vec![0.5; d], |x, a, _| multiple * a * x);
    cos(multiple * TAU * shift(0) + middle) * product(d, |a, _| 2.0 * sin(0.5 * multiple * a) / (multiple * a))
}
