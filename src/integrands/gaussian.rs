//! The bump exp(-x^2 - y^2).
//!
//! **What.** Smooth in both variables and a product of functions of one.
//!
//! **Integral and variance.** With g(a) the integral of exp(-a x^2) over [0, 1], which is
//! sqrt(pi/a) erf(sqrt(a)) / 2: g(1)^2 = 0.557746, and g(2)^2 - g(1)^4.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable;
use std::f64::consts::PI;

/// The integrand `gaussian`.
pub struct Gaussian;

static ABOUT: About = About {
    key: "gaussian",
    title: "Gaussian",
    summary: "The smooth bump exp(-x^2 - y^2).",
    file: "integrands/gaussian.rs",
    source: include_str!("gaussian.rs"),
    papers: &[Paper {
        authors: "P. Christensen, A. Kensler and C. Kilpatrick",
        year: 2018,
        title: "Progressive Multi-Jittered Sample Sequences",
        venue: "Computer Graphics Forum 37(4), 21-33",
        doi: Some("10.1111/cgf.13472"),
    }],
};

impl Entry for Gaussian {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Gaussian {
    fn dimensions(&self) -> Option<usize> {
        Some(2)
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        portable::exp(-x[0] * x[0] - x[1] * x[1])
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(bump(1.0) * bump(1.0))
    }

    fn variance(&self, _d: usize) -> Option<f64> {
        Some(bump(2.0) * bump(2.0) - portable::power(bump(1.0), 4))
    }

    fn formula(&self) -> &'static str {
        r"e^{-x^2 - y^2}"
    }
}

/// The integral of exp(-a x^2) over [0, 1].
fn bump(a: f64) -> f64 {
    0.5 * (PI / a).sqrt() * portable::erf(a.sqrt())
}
