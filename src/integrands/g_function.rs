//! Sobol's g-function: a product whose later axes matter less and less.
//!
//! **Formula.** prod (|4 x_j - 2| + a_j)/(1 + a_j), in any d, with a_1 = 0, a_2 = 1, a_3 = 2, ...
//!
//! **Integral and variance.** |4x - 2| has the mean 1 and the variance 1/3: the mean is 1, the
//! variance prod (1 + 1/(3 (1 + a_j)^2)) - 1.

use super::Integrand;
use crate::catalogue::{About, Entry, Paper};

/// The integrand `sobol-g`.
pub struct GFunction;

static ABOUT: About = About {
    key: "sobol-g",
    title: "Sobol' g-function",
    summary: "Sobol's g-function, prod (|4 x_j - 2| + a_j)/(1 + a_j) with a_j = 0, 1, 2, ...",
    file: "integrands/g_function.rs",
    source: include_str!("g_function.rs"),
    papers: &[Paper {
        authors: "A. Saltelli and I. M. Sobol'",
        year: 1995,
        title: "About the Use of Rank Transformation in Sensitivity Analysis of Model Output",
        venue: "Reliability Engineering and System Safety 50(3), 225-239",
        doi: Some("10.1016/0951-8320(95)00099-2"),
    }],
};

impl Entry for GFunction {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Integrand for GFunction {
    fn dimensions(&self) -> Option<usize> {
        None
    }

    fn evaluate(&self, x: &[f64]) -> f64 {
        x.iter().enumerate().map(|(axis, x)| ((4.0 * x - 2.0).abs() + axis as f64) / (1.0 + axis as f64)).product()
    }

    fn integral(&self, _d: usize) -> Option<f64> {
        Some(1.0)
    }

    fn variance(&self, d: usize) -> Option<f64> {
        let factor = |axis: usize| 1.0 + 1.0 / (3.0 * ((axis + 1) * (axis + 1)) as f64);
        Some((0..d).map(factor).product::<f64>() - 1.0)
    }

    fn formula(&self) -> &'static str {
        r"\prod_j \frac{|4 x_j - 2| + a_j}{1 + a_j}"
    }
}
