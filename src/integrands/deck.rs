//! The smooth function exp(sin(3x^2)) of one variable.
//!
//! **What.** It rises from 1 to e at x = sqrt(pi/6) and falls to f(1) = exp(sin 3) = 1.1516:
//! smooth, bounded by e, with no integral in closed form.
//!
//! **Integral and variance.** 1.7760990452428437438 and 0.36025749874406696521, by quadrature to 20
//! digits in arithmetic of 40 digits. Total variation 2e - 1 - f(1) = 3.2850008204035555, since it
//! is monotone on both sides of its maximum.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable;

/// The integrand `exp-sin`.
pub struct Deck;

static ABOUT: About = About {
    key: "exp-sin",
    title: "exp(sin(3x²))",
    summary: "The lecture's smooth function of one variable, exp(sin(3x^2)).",
    file: "integrands/deck.rs",
    source: include_str!("deck.rs"),
    papers: &[Paper {
        authors: "A. B. Owen",
        year: 2013,
        title: "Monte Carlo Theory, Methods and Examples",
        venue: "https://artowen.su.domains/mc/",
        doi: None,
    }],
};

impl Entry for Deck {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Deck {
    fn dimensions(&self) -> Option<usize> {
        Some(1)
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        portable::exp(portable::sin(3.0 * x[0] * x[0]))
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(1.776_099_045_242_843_7)
    }

    fn variance(&self, _d: usize) -> Option<f64> {
        Some(0.360_257_498_744_066_95)
    }

    fn variation(&self, _d: usize) -> Option<f64> {
        Some(3.285_000_820_403_555)
    }

    fn formula(&self) -> &'static str {
        r"e^{\sin(3x^2)}"
    }
}
