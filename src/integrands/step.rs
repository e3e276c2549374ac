//! The step x < 1/pi, in any number of dimensions.
//!
//! **What.** 1 where the first coordinate is below 1/pi, 0 elsewhere, whatever the other
//! coordinates: an edge along an axis at a place that is in no grid.
//!
//! **Integral and variance.** 1/pi and (1/pi)(1 - 1/pi).

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};
use std::f64::consts::FRAC_1_PI;

/// The integrand `step`.
pub struct Step;

static ABOUT: About = About {
    key: "step",
    title: "Step",
    summary: "1 for x < 1/pi, 0 beyond: an edge across the first axis, in any number of dimensions.",
    file: "integrands/step.rs",
    source: include_str!("step.rs"),
    papers: &[Paper {
        authors: "P. Christensen, A. Kensler and C. Kilpatrick",
        year: 2018,
        title: "Progressive Multi-Jittered Sample Sequences",
        venue: "Computer Graphics Forum 37(4), 21-33",
        doi: Some("10.1111/cgf.13472"),
    }],
};

impl Entry for Step {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Step {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        f64::from(x[0] < FRAC_1_PI)
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(FRAC_1_PI)
    }

    fn variance(&self, _d: usize) -> Option<f64> {
        Some(FRAC_1_PI * (1.0 - FRAC_1_PI))
    }

    fn formula(&self) -> &'static str {
        r"\left[x_1 < 1/\pi\right]"
    }
}
