//! The coordinate itself, f(x) = x.
//!
//! **What.** The plainest function of one variable: for it every variance of an estimate can be
//! written down. For n points, independent ones give 1/(12 n), one in each of n slabs 1/(12 n^3).
//!
//! **Integral and variance.** 1/2 and 1/12.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};

/// The integrand `x`.
pub struct Identity;

static ABOUT: About = About {
    key: "x",
    title: "x",
    summary: "The coordinate itself: the plainest function of one variable.",
    file: "integrands/identity.rs",
    source: include_str!("identity.rs"),
    papers: &[Paper {
        authors: "A. B. Owen",
        year: 2013,
        title: "Monte Carlo Theory, Methods and Examples",
        venue: "https://artowen.su.domains/mc/",
        doi: None,
    }],
};

impl Entry for Identity {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Identity {
    fn dimensions(&self) -> Option<usize> {
        Some(1)
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        x[0]
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(0.5)
    }

    fn variance(&self, _d: usize) -> Option<f64> {
        Some(1.0 / 12.0)
    }

    fn variation(&self, _d: usize) -> Option<f64> {
        Some(1.0)
    }

    fn formula(&self) -> &'static str {
        r"x"
    }
}
