//! Pairs: two whole numbers that belong together, such as two axes or the sides of an interval.

use std::ops::RangeInclusive;

use serde_json::{Value, json};
use toml::Spanned;
use toml::de::DeValue;

use super::{Complaint, ParameterType, wrong_type};

/// Two whole numbers: `[2, 3]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pair(pub usize, pub usize);

impl ParameterType for Pair {
    type Bound = usize;

    fn type_name() -> String {
        "a pair of whole numbers, such as `[2, 3]`".to_owned()
    }

    fn schema() -> Value {
        json!({ "type": "array", "items": { "type": "integer", "minimum": 0 }, "minItems": 2, "maxItems": 2 })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        limits: Option<&RangeInclusive<usize>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let Some([first, second]) = value.get_ref().as_array().map(|elements| &elements[..]) else {
            wrong_type::<Self>(value, complaints);
            return None;
        };
        let (first, second) = (usize::read(first, limits, complaints), usize::read(second, limits, complaints));
        Some(Self(first?, second?))
    }

    fn canonical(&self) -> Value {
        json!([self.0, self.1])
    }
}
