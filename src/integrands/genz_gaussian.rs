//! Genz's Gaussian family.
//!
//! **Formula.** exp(-sum a_j^2 (x_j - u_j)^2), in any d; a_j and u_j as in [`genz`](super::genz).
//!
//! **Integral and variance.** The mean is prod sqrt(pi)/(2 a_j) (erf(a_j (1 - u_j)) + erf(a_j
//! u_j)); the second moment is the same with sqrt(2) a_j.

use super::Integrand;
use super::genz::{product, sum};
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable::{erf, exp};
use std::f64::consts::{PI, SQRT_2};

/// The integrand `genz-gaussian`.
pub struct GenzGaussian;

static ABOUT: About = About {
    key: "genz-gaussian",
    title: "Genz: Gaussian",
    summary: "Genz's Gaussian family, exp(-sum a_j^2 (x_j - u_j)^2).",
    file: "integrands/genz_gaussian.rs",
    source: include_str!("genz_gaussian.rs"),
    papers: &[Paper {
        authors: "A. Genz",
        year: 1984,
        title: "Testing Multidimensional Integration Routines",
        venue: "Tools, Methods and Languages for Scientific and Engineering Computation, North-Holland, 81-94",
        doi: None,
    }],
};

impl Entry for GenzGaussian {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for GenzGaussian {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        exp(-sum(x, |x, a, u| a * a * (x - u) * (x - u)))
    }

    fn integral(&self, d: usize) -> Option<f64> {
        Some(product(d, bump))
    }

    fn variance(&self, d: usize) -> Option<f64> {
        let mean = self.integral(d)?;
        Some(product(d, |a, u| bump(SQRT_2 * a, u)) - mean * mean)
    }

    fn formula(&self) -> &'static str {
        r"\exp\left(-\sum_j a_j^2 (x_j - u_j)^2\right)"
    }
}

/// The integral of exp(-a^2 (x - u)^2) over [0, 1].
fn bump(a: f64, u: f64) -> f64 {
    0.5 * PI.sqrt() / a * (erf(a * (1.0 - u)) + erf(a * u))
}
