//! The numbers of claims: written out, or computed from other values.

use std::fmt::{Display, Formatter};
use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use crate::diag::Code;
use crate::integrands::{Calculation, ExpressionError};
use crate::parameters::{Complaint, Fields, inside};
use crate::parse::SourceMap;

/// A number of a claim, as written.
#[derive(Debug, Clone, PartialEq)]
pub enum Amount {
    /// A number.
    Number(f64),
    /// An expression: the number is known once the values are that it names.
    Computed {
        /// The expression.
        calculation: Calculation,
        /// Where it stands, with its quotes.
        place: Range<usize>,
    },
}

/// A number of a claim, as it came out.
#[derive(Debug, Clone, PartialEq)]
pub struct Settled {
    /// The number.
    pub number: f64,
    /// The expression that gave it, if it is not written out.
    pub expression: Option<String>,
}

impl Display for Settled {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.number)?;
        self.expression.as_ref().map_or(Ok(()), |expression| write!(f, " ({expression})"))
    }
}

impl Amount {
    /// The amount at `key`; what is wrong with it is told.
    pub(super) fn read(fields: &mut Fields<'_>, key: &str) -> Option<Self> {
        let value = fields.value(key)?;
        let DeValue::String(text) = value.get_ref() else { return fields.read::<f64>(key).map(Self::Number) };
        fields.take(key);
        match Self::computed(text, value) {
            Ok(amount) => Some(amount),
            Err(complaint) => {
                fields.complaints.push(complaint);
                None
            }
        }
    }

    /// The amount that the text of `value` computes. One that names no value is a number already, and must be finite.
    pub(super) fn computed(text: &str, value: &Spanned<DeValue<'_>>) -> Result<Self, Complaint> {
        let place = value.span();
        let calculation = Calculation::parse(text).map_err(|error| unread(text, &place, error))?;
        let amount = Self::Computed { calculation, place };
        if amount.constant().is_some_and(|number| !number.is_finite()) {
            let message = format!("`{text}` is no finite number");
            return Err(Complaint::new(Code::Expression, value.span(), message));
        }
        Ok(amount)
    }

    /// The number, if it is known before anything runs.
    pub(super) fn constant(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            Self::Computed { calculation, .. } => (calculation.names().len() == 0).then(|| calculation.evaluate(&[])),
        }
    }

    /// It with the place in the file instead of that in the fence.
    pub(super) fn placed(self, map: &SourceMap) -> Self {
        match self {
            Self::Number(_) => self,
            Self::Computed { calculation, place } => Self::Computed { calculation, place: map.range(place) },
        }
    }

    /// The names that it needs, with their places.
    pub fn names(&self) -> Vec<(&str, Range<usize>)> {
        match self {
            Self::Number(_) => Vec::new(),
            Self::Computed { calculation, place } => {
                calculation.names().map(|(name, range)| (name, inside(calculation.text(), place, &range))).collect()
            }
        }
    }
}

/// What is wrong with the expression `text`, which stands at `place`, quotes included.
fn unread(text: &str, place: &Range<usize>, error: ExpressionError) -> Complaint {
    Complaint::new(Code::Expression, inside(text, place, &error.range), error.message)
        .help_if(error.suggestion.map(|name| format!("did you mean `{name}`?")))
        .help("a bound is a number, or an expression such as \"4*[deviation.16]/sqrt(1000)\"")
}
