//! What a chapter integrates: a catalogued integrand, or an expression.

use super::expression::{Expression, ExpressionError};
use super::{INTEGRANDS, Integrand};
use crate::catalogue::{About, find, nearest};
use crate::stats::quadrature::{Integral, integrate};
use std::fmt::{self, Debug, Formatter};

/// A catalogued integrand by its key, or an expression in `x`, `y` or `x1`, `x2`, ...
///
/// ```
/// use workbook::integrands::Function;
/// let function = Function::parse("exp(sin(3*x^2))")?;
/// assert_eq!(function.dimensions(), Some(1));
/// assert!((function.integral(1).unwrap().value - 1.7760990452428437).abs() < 1e-14);
/// # Ok::<(), workbook::integrands::ExpressionError>(())
/// ```
#[derive(Clone)]
pub struct Function {
    text: String,
    form: Form,
}

#[derive(Clone)]
enum Form {
    Catalogued(&'static dyn Integrand),
    Written(Expression),
}

/// The value of an integral that estimates are compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// The value.
    pub value: f64,
    /// A bound on its absolute error; 0 where the value is exact up to its last digit.
    pub error: f64,
}

impl Function {
    /// The function that `text` names or writes out.
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        let form = match find(INTEGRANDS, text.trim()) {
            Some(integrand) => Form::Catalogued(integrand),
            None => Form::Written(Expression::parse(text).map_err(|error| offer_keys(text, error))?),
        };
        Ok(Self { text: text.to_owned(), form })
    }

    /// The text, as written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The function as LaTeX.
    pub fn formula(&self) -> String {
        match &self.form {
            Form::Catalogued(integrand) => integrand.formula().to_owned(),
            Form::Written(expression) => expression.formula(),
        }
    }

    /// The number of dimensions; `None` where any will do.
    pub fn dimensions(&self) -> Option<usize> {
        match &self.form {
            Form::Catalogued(integrand) => integrand.dimensions(),
            Form::Written(expression) => Some(expression.dimensions()).filter(|&d| d > 0),
        }
    }

    /// Its value at `x`, of as many coordinates as it has dimensions; an expression takes a missing
    /// coordinate as NaN.
    pub fn evaluate(&self, x: &[f64]) -> f64 {
        match &self.form {
            Form::Catalogued(integrand) => integrand.evaluate(x),
            Form::Written(expression) => expression.evaluate(x),
        }
    }

    /// Its integral over the cube of `d` dimensions: exact where catalogued, by quadrature for a
    /// smooth expression of up to three variables; `None` where neither serves.
    pub fn integral(&self, d: usize) -> Option<Reference> {
        match &self.form {
            Form::Catalogued(integrand) => integrand.integral(d).map(|value| Reference { value, error: 0.0 }),
            Form::Written(expression) => {
                let Integral { value, error } = expression.integrate(d, |value| value)?;
                Some(Reference { value, error })
            }
        }
    }

    /// Its variance over the cube of `d` dimensions, from the same sources.
    pub fn variance(&self, d: usize) -> Option<f64> {
        match &self.form {
            Form::Catalogued(integrand) => integrand.variance(d),
            Form::Written(expression) => {
                let mean = expression.integrate(d, |value| value)?.value;
                // Centred first, so that a large mean leaves the digits of a small variance alone.
                Some(expression.integrate(d, |value| (value - mean) * (value - mean))?.value)
            }
        }
    }

    /// Its variation in the sense of Hardy and Krause over the cube of `d` dimensions, where the catalogue knows it.
    pub fn variation(&self, d: usize) -> Option<f64> {
        match &self.form {
            Form::Catalogued(integrand) => integrand.variation(d),
            Form::Written(_) => None,
        }
    }

    /// What the catalogued integrand tells about itself; nothing for an expression.
    pub fn abouts(&self) -> Vec<&'static About> {
        match &self.form {
            Form::Catalogued(integrand) => vec![integrand.about()],
            Form::Written(_) => Vec::new(),
        }
    }
}

impl Expression {
    /// The integral of `map` of the expression over the cube of `d` dimensions; the variables that
    /// it does not name do not matter.
    fn integrate(&self, d: usize, map: impl Fn(f64) -> f64) -> Option<Integral> {
        let needed = self.dimensions();
        if d < needed {
            return None;
        }
        integrate(needed.max(1), |x| map(self.evaluate(x)))
    }
}

/// Where the whole text is one unknown name, a catalogued integrand may have been meant as well.
fn offer_keys(text: &str, mut error: ExpressionError) -> ExpressionError {
    if error.suggestion.is_none() && text.trim().chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_') {
        error.suggestion =
            nearest(text.trim(), INTEGRANDS.iter().map(|integrand| integrand.about().key)).map(str::to_owned);
    }
    error
}

impl Debug for Function {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Function").field(&self.text).finish()
    }
}

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}
