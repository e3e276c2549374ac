//! Measuring: a measure of the catalogue as a parameter, and how values, axes and tables call it.

use std::ops::RangeInclusive;

use serde_json::{Value, json};
use toml::Spanned;
use toml::de::DeValue;

use crate::catalogue::{About, find};
use crate::metrics::{METRICS, Metric};
use crate::parameters::{Complaint, ParameterType, Unbounded, read_word};

/// A measure by its name in the catalogue.
#[derive(Clone, Copy)]
pub struct Measure(&'static dyn Metric);

impl std::fmt::Debug for Measure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Measure").field(&self.key()).finish()
    }
}

/// The names of all measures.
fn keys() -> Vec<&'static str> {
    METRICS.iter().map(|metric| metric.about().key).collect()
}

/// What names of values of the measure `key` begin with.
pub fn quantity(key: &'static str) -> &'static str {
    match key {
        "star-discrepancy" => "dstar",
        "l2-star" => "l2star",
        "l2-centred" => "centred",
        "l2-wrap-around" => "wraparound",
        "minimum-distance" => "distance",
        "relative-radius" => "radius",
        "t-value" => "t",
        "largest-correlation" => "correlation",
        other => other,
    }
}

impl Measure {
    /// The measure itself.
    pub fn metric(self) -> &'static dyn Metric {
        self.0
    }

    /// Its name in chapters.
    pub fn key(self) -> &'static str {
        self.0.about().key
    }

    /// Its name as prose uses it.
    pub fn title(self) -> &'static str {
        self.0.about().title
    }

    /// What names of values begin with.
    pub fn quantity(self) -> &'static str {
        quantity(self.key())
    }

    /// Its symbol in LaTeX.
    pub fn symbol(self) -> &'static str {
        match self.key() {
            "star-discrepancy" => "D^*",
            "l2-star" => "L_2^*",
            "l2-centred" => r"\mathit{CD}_2",
            "l2-wrap-around" => r"\mathit{WD}_2",
            "minimum-distance" => r"d_{\min}",
            "relative-radius" => r"\rho",
            "t-value" => "t",
            "largest-correlation" => "|r|",
            other => other,
        }
    }

    /// Whether it is a discrepancy, for which less is better.
    pub fn is_discrepancy(self) -> bool {
        matches!(self.key(), "star-discrepancy" | "l2-star" | "l2-centred" | "l2-wrap-around")
    }
}

impl ParameterType for Measure {
    type Bound = Unbounded;

    fn type_name() -> String {
        "the name of a measure".to_owned()
    }

    fn schema() -> Value {
        json!({ "enum": keys() })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        _: Option<&RangeInclusive<Unbounded>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let index = read_word::<Self>(value, &keys(), complaints)?;
        find(METRICS, keys().get(index)?).map(Self)
    }

    fn canonical(&self) -> Value {
        json!(self.key())
    }

    fn abouts(&self) -> Vec<&'static About> {
        vec![self.0.about()]
    }
}
