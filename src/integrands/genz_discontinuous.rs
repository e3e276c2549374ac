//! Genz's discontinuous family.
//!
//! **Formula.** 0 where x_1 > u_1 or x_2 > u_2, else exp(sum a_j x_j), in any d; a and u as in
//! [`genz`](super::genz).
//!
//! **Integral and variance.** The mean is the product of (exp(a_j u_j) - 1)/a_j over the first two
//! axes and of (exp(a_j) - 1)/a_j over the others; the second moment is the same with 2 a_j.

use super::Integrand;
use super::genz::{difficulty, shift, sum};
use crate::catalogue::{About, Entry, Paper};
use crate::stats::portable::exp;

/// The integrand `genz-discontinuous`.
pub struct Discontinuous;

static ABOUT: About = About {
    key: "genz-discontinuous",
    title: "Genz: discontinuous",
    summary: "Genz's discontinuous family: exp(sum a_j x_j) where x_1 <= u_1 and x_2 <= u_2, else 0.",
    file: "integrands/genz_discontinuous.rs",
    source: include_str!("genz_discontinuous.rs"),
    papers: &[Paper {
        authors: "A. Genz",
        year: 1984,
        title: "Testing Multidimensional Integration Routines",
        venue: "Tools, Methods and Languages for Scientific and Engineering Computation, North-Holland, 81-94",
        doi: None,
    }],
};

impl Entry for Discontinuous {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for Discontinuous {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        let outside = x.iter().take(2).enumerate().any(|(axis, &x)| x > shift(axis));
        if outside { 0.0 } else { exp(sum(x, |x, a, _| a * x)) }
    }

    fn integral(&self, d: usize) -> Option<f64> {
        Some(mean_of_power(d, 1.0))
    }

    fn variance(&self, d: usize) -> Option<f64> {
        let mean = self.integral(d)?;
        Some(mean_of_power(d, 2.0) - mean * mean)
    }

    fn formula(&self) -> &'static str {
        r"\left[x_1 \le u_1, x_2 \le u_2\right] \exp\left(\sum_j a_j x_j\right)"
    }
}

/// The mean of the function raised to `exponent`.
fn mean_of_power(d: usize, exponent: f64) -> f64 {
    let factor = |axis| {
        let (a, end) = (exponent * difficulty(axis), if axis < 2 { shift(axis) } else { 1.0 });
        (exp(a * end) - 1.0) / a
    };
    (0..d).map(factor).product()
}
