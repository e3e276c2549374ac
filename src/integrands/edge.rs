//! The triangle y > x.
//!
//! **What.** 1 above the diagonal, 0 below: an edge along no axis, of infinite Hardy-Krause
//! variation, and the worst case for a rigid digital shift.
//!
//! **Integral and variance.** 1/2 and 1/4, by symmetry.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};

/// The integrand `edge`.
pub struct Edge;

static ABOUT: About = About {
    key: "edge",
    title: "Edge",
    summary: "1 above the diagonal, 0 below: an edge along no axis.",
    file: "integrands/edge.rs",
    source: include_str!("edge.rs"),
    papers: &[Paper {
        authors: "P. Christensen, A. Kensler and C. Kilpatrick",
        year: 2018,
        title: "Progressive Multi-Jittered Sample Sequences",
        venue: "Computer Graphics Forum 37(4), 21-33",
        doi: Some("10.1111/cgf.13472"),
    }],
};

impl Entry for Edge {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Edge {
    fn dimensions(&self) -> Option<usize> {
        Some(2)
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        f64::from(x[1] > x[0])
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(0.5)
    }

    fn variance(&self, _d: usize) -> Option<f64> {
        Some(0.25)
    }

    fn formula(&self) -> &'static str {
        r"\left[y > x\right]"
    }
}
