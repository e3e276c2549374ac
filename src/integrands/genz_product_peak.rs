//! Genz's product peak family.
//!
//! **Formula.** prod 1/(a_j^-2 + (x_j - u_j)^2), in any d; a_j and u_j as in [`genz`](super::genz).
//!
//! **Integral and variance.** The mean is prod a_j (atan(a_j (1 - u_j)) + atan(a_j u_j)); the
//! second moment follows from the primitive t/(2 c^2 (c^2 + t^2)) + atan(t/c)/(2 c^3) of 1/(c^2 +
//! t^2)^2, c = 1/a.

use super::Integrand;
use super::genz::{difficulty, product, shift};
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable::atan;

/// The integrand `genz-product-peak`.
pub struct ProductPeak;

static ABOUT: About = About {
    key: "genz-product-peak",
    title: "Genz: product peak",
    summary: "Genz's product peak family, prod 1/(a_j^-2 + (x_j - u_j)^2).",
    file: "integrands/genz_product_peak.rs",
    source: include_str!("genz_product_peak.rs"),
    papers: &[Paper {
        authors: "A. Genz",
        year: 1984,
        title: "Testing Multidimensional Integration Routines",
        venue: "Tools, Methods and Languages for Scientific and Engineering Computation, North-Holland, 81-94",
        doi: None,
    }],
};

impl Entry for ProductPeak {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for ProductPeak {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        x.iter().enumerate().map(|(axis, &x)| peak(x - shift(axis), difficulty(axis))).product()
    }

    fn integral(&self, d: usize) -> Option<f64> {
        Some(product(d, |a, u| a * (atan(a * (1.0 - u)) + atan(a * u))))
    }

    fn variance(&self, d: usize) -> Option<f64> {
        let mean = self.integral(d)?;
        let primitive = |t: f64, a: f64| 0.5 * a * a * t * peak(t, a) + 0.5 * a * a * a * atan(a * t);
        Some(product(d, |a, u| primitive(1.0 - u, a) - primitive(-u, a)) - mean * mean)
    }

    fn formula(&self) -> &'static str {
        r"\prod_j \frac{1}{a_j^{-2} + (x_j - u_j)^2}"
    }
}

/// One factor, at the distance `t` from its peak.
fn peak(t: f64, a: f64) -> f64 {
    1.0 / (1.0 / (a * a) + t * t)
}
