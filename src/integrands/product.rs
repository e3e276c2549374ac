//! The product of two coordinates, f(x, y) = x y.
//!
//! **What.** Smooth, and the simplest function that is no sum of functions of one variable: Latin
//! hypercubes take only a part of its variance away.
//!
//! **Variation.** 3: one from the mixed derivative, one from each of the two sides at 1.
//!
//! **Integral and variance.** 1/4, and 1/9 - 1/16 = 7/144.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};

/// The integrand `xy`.
pub struct Product;

static ABOUT: About = About {
    key: "xy",
    title: "xy",
    summary: "The product of two coordinates: smooth, and not a sum of functions of one.",
    file: "integrands/product.rs",
    source: include_str!("product.rs"),
    papers: &[Paper {
        authors: "P. Christensen, A. Kensler and C. Kilpatrick",
        year: 2018,
        title: "Progressive Multi-Jittered Sample Sequences",
        venue: "Computer Graphics Forum 37(4), 21-33",
        doi: Some("10.1111/cgf.13472"),
    }],
};

impl Entry for Product {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Product {
    fn dimensions(&self) -> Option<usize> {
        Some(2)
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        x[0] * x[1]
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(0.25)
    }

    fn variance(&self, _d: usize) -> Option<f64> {
        Some(7.0 / 144.0)
    }

    fn variation(&self, _d: usize) -> Option<f64> {
        Some(3.0)
    }

    fn formula(&self) -> &'static str {
        r"x y"
    }
}
