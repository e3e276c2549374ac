//! Genz's C0 family: continuous, with a kink on every axis.
//!
//! **Formula.** exp(-sum a_j |x_j - u_j|), in any d; a_j and u_j as in [`genz`](super::genz).
//!
//! **Integral and variance.** The mean is prod (2 - exp(-a_j u_j) - exp(-a_j (1 - u_j)))/a_j; the
//! second moment is the same with 2 a_j.

use super::Integrand;
use super::genz::{product, sum};
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable::exp;

/// The integrand `genz-continuous`.
pub struct Continuous;

static ABOUT: About = About {
    key: "genz-continuous",
    title: "Genz: continuous",
    summary: "Genz's C0 family with a kink, exp(-sum a_j |x_j - u_j|).",
    file: "integrands/genz_continuous.rs",
    source: include_str!("genz_continuous.rs"),
    papers: &[Paper {
        authors: "A. Genz",
        year: 1984,
        title: "Testing Multidimensional Integration Routines",
        venue: "Tools, Methods and Languages for Scientific and Engineering Computation, North-Holland, 81-94",
        doi: None,
    }],
};

impl Entry for Continuous {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Continuous {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        exp(-sum(x, |x, a, u| a * (x - u).abs()))
    }

    fn integral(&self, d: usize) -> Option<f64> {
        Some(product(d, tent))
    }

    fn variance(&self, d: usize) -> Option<f64> {
        let mean = self.integral(d)?;
        Some(product(d, |a, u| tent(2.0 * a, u)) - mean * mean)
    }

    fn formula(&self) -> &'static str {
        r"\exp\left(-\sum_j a_j |x_j - u_j|\right)"
    }
}

/// The integral of exp(-a |x - u|) over [0, 1].
fn tent(a: f64, u: f64) -> f64 {
    (2.0 - exp(-a * u) - exp(-a * (1.0 - u))) / a
}
