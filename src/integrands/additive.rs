//! The sum of the coordinates, in any number of dimensions.
//!
//! **What.** A sum of functions of one variable each: the case that Latin hypercubes are made for.
//! For n of them the variance of the mean is d/(12 n^3), for independent points d/(12 n).
//!
//! **Integral and variance.** d/2 and d/12. **Variation.** d: one from each edge at 1.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};

/// The integrand `sum`.
pub struct Additive;

static ABOUT: About = About {
    key: "sum",
    title: "Sum",
    summary: "The sum of the coordinates: a function of one variable at a time.",
    file: "integrands/additive.rs",
    source: include_str!("additive.rs"),
    papers: &[Paper {
        authors: "M. Stein",
        year: 1987,
        title: "Large Sample Properties of Simulations Using Latin Hypercube Sampling",
        venue: "Technometrics 29(2), 143-151",
        doi: Some("10.1080/00401706.1987.10488205"),
    }],
};

impl Entry for Additive {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Additive {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        x.iter().sum()
    }

    fn integral(&self, d: usize) -> Option<f64> {
        Some(0.5 * d as f64)
    }

    fn variance(&self, d: usize) -> Option<f64> {
        Some(d as f64 / 12.0)
    }

    fn variation(&self, d: usize) -> Option<f64> {
        Some(d as f64)
    }

    fn formula(&self) -> &'static str {
        r"\sum_j x_j"
    }
}
