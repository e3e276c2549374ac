//! The plain types: numbers, flags, text, lists, and what may be absent.

use std::ops::RangeInclusive;

use serde_json::{Value, json};
use toml::Spanned;
use toml::de::DeValue;

use super::{Complaint, ParameterType, enumerate, outside, wrong_type};
use crate::catalogue::{About, nearest};
use crate::diag::Code;

/// The limits of a type that has none.
#[derive(Debug, PartialEq, PartialOrd)]
pub enum Unbounded {}

impl std::fmt::Display for Unbounded {
    fn fmt(&self, _: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {}
    }
}

impl ParameterType for usize {
    type Bound = usize;

    fn type_name() -> String {
        "a whole number".to_owned()
    }

    fn schema() -> Value {
        json!({ "type": "integer", "minimum": 0 })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        limits: Option<&RangeInclusive<usize>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let DeValue::Integer(integer) = value.get_ref() else {
            wrong_type::<Self>(value, complaints);
            return None;
        };
        if let Ok(number) = usize::from_str_radix(integer.as_str(), integer.radix()) {
            return (!outside(&number, limits, &value.span(), complaints)).then_some(number);
        }
        let message = match limits {
            Some(limits) => {
                format!("{integer} is out of range: it must be from {} to {}", limits.start(), limits.end())
            }
            None => format!("{integer} is out of range: it must be from 0 to {}", usize::MAX),
        };
        complaints.push(Complaint::new(Code::OutOfRange, value.span(), message));
        None
    }

    fn canonical(&self) -> Value {
        json!(self)
    }
}

impl ParameterType for f64 {
    type Bound = f64;

    fn type_name() -> String {
        "a number".to_owned()
    }

    fn schema() -> Value {
        json!({ "type": "number" })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        limits: Option<&RangeInclusive<f64>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let number = match value.get_ref() {
            DeValue::Float(float) => float.as_str().parse::<f64>().ok(),
            DeValue::Integer(integer) => {
                i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(|integer| integer as f64)
            }
            _ => {
                wrong_type::<Self>(value, complaints);
                return None;
            }
        };
        let Some(number) = number.filter(|number| number.is_finite()) else {
            complaints.push(Complaint::new(Code::OutOfRange, value.span(), "the number must be finite"));
            return None;
        };
        (!outside(&number, limits, &value.span(), complaints)).then_some(number + 0.0)
    }

    fn canonical(&self) -> Value {
        json!(self)
    }
}

impl ParameterType for bool {
    type Bound = Unbounded;

    fn type_name() -> String {
        "true or false".to_owned()
    }

    fn schema() -> Value {
        json!({ "type": "boolean" })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        _: Option<&RangeInclusive<Unbounded>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let flag = value.get_ref().as_bool();
        if flag.is_none() {
            wrong_type::<Self>(value, complaints);
        }
        flag
    }

    fn canonical(&self) -> Value {
        json!(self)
    }
}

impl ParameterType for String {
    type Bound = Unbounded;

    fn type_name() -> String {
        "a string".to_owned()
    }

    fn schema() -> Value {
        json!({ "type": "string" })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        _: Option<&RangeInclusive<Unbounded>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let text = value.get_ref().as_str();
        if text.is_none() {
            wrong_type::<Self>(value, complaints);
        }
        text.map(str::to_owned)
    }

    fn canonical(&self) -> Value {
        json!(self)
    }
}

/// A list, in the order written; a single value is a list of one. Neither empty nor with anything twice.
impl<T: ParameterType> ParameterType for Vec<T> {
    type Bound = T::Bound;

    fn type_name() -> String {
        format!("{} or a list of such", T::type_name())
    }

    fn schema() -> Value {
        let one = T::schema();
        json!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 1, "uniqueItems": true }] })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        limits: Option<&RangeInclusive<T::Bound>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let DeValue::Array(elements) = value.get_ref() else {
            return T::read(value, limits, complaints).map(|one| vec![one]);
        };
        if elements.is_empty() {
            complaints.push(Complaint::new(Code::OutOfRange, value.span(), "the list is empty"));
            return None;
        }
        let mut list: Vec<T> = Vec::new();
        let mut whole = true;
        for element in elements {
            let Some(read) = T::read(element, limits, complaints) else {
                whole = false;
                continue;
            };
            let canonical = read.canonical();
            if list.iter().any(|other| other.canonical() == canonical) {
                let message = format!("{canonical} is in the list twice");
                complaints.push(Complaint::new(Code::Combination, element.span(), message).help("drop one of the two"));
                whole = false;
            }
            list.push(read);
        }
        whole.then_some(list)
    }

    fn canonical(&self) -> Value {
        self.iter().map(ParameterType::canonical).collect()
    }

    fn abouts(&self) -> Vec<&'static About> {
        self.iter().flat_map(ParameterType::abouts).collect()
    }
}

impl<T: ParameterType> ParameterType for Option<T> {
    type Bound = T::Bound;

    fn type_name() -> String {
        T::type_name()
    }

    fn schema() -> Value {
        T::schema()
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        limits: Option<&RangeInclusive<T::Bound>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        T::read(value, limits, complaints).map(Some)
    }

    fn canonical(&self) -> Value {
        self.as_ref().map_or(Value::Null, ParameterType::canonical)
    }

    fn abouts(&self) -> Vec<&'static About> {
        self.as_ref().map(ParameterType::abouts).unwrap_or_default()
    }

    fn absent() -> Option<Self> {
        Some(None)
    }
}

/// The index of the word among `words` that `value` is.
pub(crate) fn read_word<T: ParameterType>(
    value: &Spanned<DeValue<'_>>,
    words: &[&str],
    complaints: &mut Vec<Complaint>,
) -> Option<usize> {
    let Some(written) = value.get_ref().as_str() else {
        wrong_type::<T>(value, complaints);
        return None;
    };
    let index = words.iter().position(|word| *word == written);
    if index.is_none() {
        let message = format!("unknown choice `{written}`");
        let offer = nearest(written, words.iter().copied()).map(|word| format!("did you mean `{word}`?"));
        let all = format!("it is one of {}", enumerate(words, "and"));
        complaints.push(Complaint::new(Code::UnknownName, value.span(), message).help_if(offer).help(all));
    }
    index
}
