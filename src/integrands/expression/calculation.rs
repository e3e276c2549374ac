//! Expressions of named values: what prose and claims compute from results.

use super::{Expression, ExpressionError, parser};
use std::fmt::{self, Debug, Formatter};
use std::ops::Range;

/// An expression in which names in square brackets stand for numbers.
///
/// ```
/// use workbook::integrands::Calculation;
/// let ratio = Calculation::parse("sqrt([rmse.16] / [rmse.64])")?;
/// assert_eq!(ratio.names().map(|(name, _)| name).collect::<Vec<_>>(), ["rmse.16", "rmse.64"]);
/// assert_eq!(ratio.evaluate(&[8.0, 2.0]), 2.0);
/// # Ok::<(), workbook::integrands::ExpressionError>(())
/// ```
#[derive(Clone)]
pub struct Calculation {
    text: String,
    expression: Expression,
    names: Vec<Range<usize>>,
}

impl Calculation {
    /// Reads `text`.
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        let (tree, names) = parser::parse_bracketed(text)?;
        Ok(Self { text: text.to_owned(), expression: Expression::compiled(tree), names })
    }

    /// The text, as written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The names in the order of the text, each as often as it stands there, and the bytes of the text where it does.
    pub fn names(&self) -> impl ExactSizeIterator<Item = (&str, Range<usize>)> {
        self.names.iter().map(|range| (&self.text[range.clone()], range.clone()))
    }

    /// Its value; `values` are those of the names, in their order.
    pub fn evaluate(&self, values: &[f64]) -> f64 {
        self.expression.evaluate(values)
    }
}

impl Debug for Calculation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Calculation").field(&self.text).finish()
    }
}

impl PartialEq for Calculation {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}
