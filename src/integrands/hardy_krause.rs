//! A family of known variation: the product of 1 - x_j.
//!
//! **What.** On every face of the cube at 1 the function is 0, so that only its mixed derivative
//! counts: the variation in the sense of Hardy and Krause is the integral of |(-1)^d| = 1, whatever
//! d. The bound of Koksma and Hlawka is then the star discrepancy itself.
//!
//! **Integral and variance.** 2^-d, and 3^-d - 4^-d.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable::power;

/// The integrand `unit-variation`.
pub struct HardyKrause;

static ABOUT: About = About {
    key: "unit-variation",
    title: "Unit variation",
    summary: "The product of (1 - x_j), whose Hardy-Krause variation is 1 in every dimension.",
    file: "integrands/hardy_krause.rs",
    source: include_str!("hardy_krause.rs"),
    papers: &[Paper {
        authors: "E. Hlawka",
        year: 1961,
        title: "Funktionen von beschränkter Variation in der Theorie der Gleichverteilung",
        venue: "Annali di Matematica Pura ed Applicata 54, 325-333",
        doi: Some("10.1007/BF02415361"),
    }],
};

impl Entry for HardyKrause {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for HardyKrause {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        x.iter().map(|x| 1.0 - x).product()
    }

    fn integral(&self, d: usize) -> Option<f64> {
        Some(power(2.0, -(d as i32)))
    }

    fn variance(&self, d: usize) -> Option<f64> {
        Some(power(3.0, -(d as i32)) - power(4.0, -(d as i32)))
    }

    fn variation(&self, _d: usize) -> Option<f64> {
        Some(1.0)
    }

    fn formula(&self) -> &'static str {
        r"\prod_j (1 - x_j)"
    }
}
