//! Values: the named numbers of a result, which prose quotes and claims are held against.

use std::collections::BTreeMap;

use serde::Serialize;

/// What a value is.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// Whether something holds.
    Boolean(bool),
    /// A count.
    Integer(i64),
    /// A number.
    Number(f64),
    /// A word, such as the name of a sampler.
    Text(String),
}

/// A value and, where it was estimated, how uncertain it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Measured {
    /// The value.
    pub value: Value,
    /// Its standard error, if it is an estimate that has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_error: Option<f64>,
}

impl Measured {
    /// The value as a number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self.value {
            Value::Number(number) => Some(number),
            Value::Integer(integer) => Some(integer as f64),
            Value::Boolean(_) | Value::Text(_) => None,
        }
    }
}

/// The values of a result by name, in the order of the names.
///
/// A name is dotted and lower-case: the quantity, then the sampler, then n, as in `rmse.sobol+xor.1024`.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[serde(transparent)]
pub struct Values(BTreeMap<String, Measured>);

impl Values {
    /// No values yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a number that is exact, or whose error is not known. A number that is not finite is no value and is left out.
    pub fn number(&mut self, name: impl Into<String>, number: f64) {
        if number.is_finite() {
            self.insert(name.into(), Value::Number(number), None);
        }
    }

    /// Adds an estimate with its standard error. An estimate that is not finite is no value and is left out.
    pub fn estimate(&mut self, name: impl Into<String>, number: f64, standard_error: f64) {
        if number.is_finite() {
            let standard_error = Some(standard_error).filter(|error| error.is_finite());
            self.insert(name.into(), Value::Number(number), standard_error);
        }
    }

    /// Adds a count.
    pub fn integer(&mut self, name: impl Into<String>, integer: i64) {
        self.insert(name.into(), Value::Integer(integer), None);
    }

    /// Adds whether something holds.
    pub fn boolean(&mut self, name: impl Into<String>, holds: bool) {
        self.insert(name.into(), Value::Boolean(holds), None);
    }

    /// Adds a word.
    pub fn text(&mut self, name: impl Into<String>, text: impl Into<String>) {
        self.insert(name.into(), Value::Text(text.into()), None);
    }

    /// The value called `name`.
    pub fn get(&self, name: &str) -> Option<&Measured> {
        self.0.get(name)
    }

    /// Every name with its value, in the order of the names.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&str, &Measured)> {
        self.0.iter().map(|(name, measured)| (name.as_str(), measured))
    }

    /// Every name, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }

    /// The number of values.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn insert(&mut self, name: String, value: Value, standard_error: Option<f64>) {
        self.0.insert(name, Measured { value, standard_error });
    }
}
