//! The integrands: functions on the unit cube whose mean is known, and expressions that chapters
//! write.

use crate::catalogue::Entry;

pub mod additive;
pub mod deck;
pub mod disk;
pub mod edge;
pub mod expression;
mod function;
pub mod g_function;
pub mod gaussian;
pub mod genz;
pub mod genz_continuous;
pub mod genz_corner_peak;
pub mod genz_discontinuous;
pub mod genz_gaussian;
pub mod genz_oscillatory;
pub mod genz_product_peak;
pub mod hardy_krause;
pub mod identity;
pub mod product;
pub mod step;

pub use expression::{Calculation, ExpressionError};
pub use function::{Function, Reference};

/// Every integrand, in the order of display.
pub static INTEGRANDS: &[&dyn Integrand] = &[
    &deck::Deck,
    &identity::Identity,
    &product::Product,
    &disk::Disk,
    &edge::Edge,
    &step::Step,
    &gaussian::Gaussian,
    &genz_oscillatory::Oscillatory,
    &genz_product_peak::ProductPeak,
    &genz_corner_peak::CornerPeak,
    &genz_gaussian::GenzGaussian,
    &genz_continuous::Continuous,
    &genz_discontinuous::Discontinuous,
    &additive::Additive,
    &g_function::GFunction,
    &hardy_krause::HardyKrause,
];

/// A function on the unit cube.
pub trait Integrand: Entry + Sync {
    /// The number of dimensions; `None` where any will do.
    fn dimensions(&self) -> Option<usize>;

    /// Its value at `x`, of as many coordinates as it has dimensions.
    fn evaluate(&self, x: &[f64]) -> f64;

    /// Its exact integral over the cube of `d` dimensions, to the last digit of a `f64`; `None`
    /// where it is not known.
    fn integral(&self, d: usize) -> Option<f64>;

    /// Its exact variance over the cube of `d` dimensions.
    fn variance(&self, d: usize) -> Option<f64>;

    /// Its variation over the cube of `d` dimensions in the sense of Hardy and Krause, anchored at
    /// 1, where it is known: the factor of the star discrepancy in the bound of Koksma and Hlawka.
    fn variation(&self, _d: usize) -> Option<f64> {
        None
    }

    /// It as LaTeX.
    fn formula(&self) -> &'static str;
}
