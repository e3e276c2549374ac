//! Counts: how many points to take, as one number, a list, or every power of a base.

use std::ops::RangeInclusive;

use serde_json::{Value, json};
use toml::Spanned;
use toml::de::DeValue;

use super::{Complaint, ParameterType, outside, wrong_type};
use crate::diag::Code;

/// The most counts that one parameter may ask for.
const MOST: usize = 4096;

/// Counts of points, ascending and distinct, never empty: `1000`, `"2^4..2^14"` (every power), `"1..64"` (every
/// number), or a list of such.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counts(Vec<usize>);

impl Counts {
    /// The counts in ascending order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.0.iter().copied()
    }

    /// The counts in ascending order.
    pub fn as_slice(&self) -> &[usize] {
        &self.0
    }

    /// The largest count.
    pub fn largest(&self) -> usize {
        self.0.last().copied().unwrap_or(0)
    }

    /// The sum of the counts, for weights.
    pub fn total(&self) -> u64 {
        self.iter().fold(0, |sum, count| sum.saturating_add(count as u64))
    }

    /// The counts that the string `text` stands for, or what is wrong with it.
    pub fn parse(text: &str) -> Result<Vec<usize>, String> {
        let Some((from, to)) = text.split_once("..") else {
            return Power::parse(text)?.value().map(|count| vec![count]);
        };
        let (from, to) = (Power::parse(from)?, Power::parse(to)?);
        let (least, most) = (from.value()?, to.value()?);
        if least > most {
            return Err(format!("the range `{text}` runs backwards"));
        }
        match (from.exponent, to.exponent) {
            (Some(low), Some(high)) if from.base == to.base && from.base >= 2 => {
                (low..=high).map(|exponent| Power { base: from.base, exponent: Some(exponent) }.value()).collect()
            }
            (None, None) if most - least < MOST => Ok((least..=most).collect()),
            (None, None) => Err(format!("the range `{text}` has more than {MOST} counts")),
            _ => Err(format!("the two ends of `{text}` must be powers of one base of at least 2")),
        }
    }
}

/// A number as written: `1000` or `10^3`.
struct Power {
    base: usize,
    exponent: Option<u32>,
}

impl Power {
    fn parse(text: &str) -> Result<Self, String> {
        let number = |digits: &str| {
            let digits = digits.trim();
            if digits.is_empty() {
                return Err(format!("a number is missing in `{text}`"));
            }
            digits.replace('_', "").parse::<usize>().map_err(|_| format!("`{digits}` is not a whole number"))
        };
        match text.split_once('^') {
            None => Ok(Self { base: number(text)?, exponent: None }),
            Some((base, exponent)) => {
                let exponent = u32::try_from(number(exponent)?).map_err(|_| format!("`{text}` is too large"))?;
                Ok(Self { base: number(base)?, exponent: Some(exponent) })
            }
        }
    }

    fn value(&self) -> Result<usize, String> {
        let exponent = self.exponent.unwrap_or(1);
        self.base.checked_pow(exponent).ok_or_else(|| format!("`{}^{exponent}` is too large", self.base))
    }
}

/// The counts that one TOML value stands for; complains if it is wrong.
fn expand(
    value: &Spanned<DeValue<'_>>,
    limits: Option<&RangeInclusive<usize>>,
    complaints: &mut Vec<Complaint>,
) -> Option<Vec<usize>> {
    let DeValue::String(text) = value.get_ref() else {
        if value.get_ref().is_integer() {
            return usize::read(value, limits.or(Some(&(1..=usize::MAX))), complaints).map(|count| vec![count]);
        }
        wrong_type::<Counts>(value, complaints);
        return None;
    };
    match Counts::parse(text) {
        Ok(counts) => {
            let (limits, place) = (limits.or(Some(&(1..=usize::MAX))), value.span());
            let inside = !counts.iter().any(|count| outside(count, limits, &place, complaints));
            inside.then_some(counts)
        }
        Err(message) => {
            let help = "write counts as `1000`, `\"10^3\"`, `\"2^4..2^14\"` for every power, or a list of such";
            complaints.push(Complaint::new(Code::WrongType, value.span(), message).help(help));
            None
        }
    }
}

/// The place in the written `value` of counts that asks for `count`: the element of a list, or the whole value.
pub(crate) fn place_of(value: &Spanned<DeValue<'_>>, count: usize) -> std::ops::Range<usize> {
    let asks = |element: &&Spanned<DeValue<'_>>| {
        expand(element, None, &mut Vec::new()).is_some_and(|counts| counts.contains(&count))
    };
    let element = value.get_ref().as_array().and_then(|elements| elements.iter().find(asks));
    element.unwrap_or(value).span()
}

impl ParameterType for Counts {
    type Bound = usize;

    fn type_name() -> String {
        "counts (`1000`, `\"2^4..2^14\"`, or a list of such)".to_owned()
    }

    fn schema() -> Value {
        let one = json!({ "anyOf": [
            { "type": "integer", "minimum": 1 },
            { "type": "string", "pattern": r"^\s*[0-9_]+(\^[0-9]+)?\s*(\.\.\s*[0-9_]+(\^[0-9]+)?\s*)?$" },
        ] });
        json!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 1 }] })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        limits: Option<&RangeInclusive<usize>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let mut counts = Vec::new();
        match value.get_ref().as_array() {
            None => counts = expand(value, limits, complaints)?,
            Some(elements) => {
                let before = complaints.len();
                for element in elements {
                    counts.extend(expand(element, limits, complaints).unwrap_or_default());
                }
                if complaints.len() > before {
                    return None;
                }
            }
        }
        counts.sort_unstable();
        counts.dedup();
        if counts.is_empty() || counts.len() > MOST {
            let message = format!("expected 1 to {MOST} counts, found {}", counts.len());
            complaints.push(Complaint::new(Code::OutOfRange, value.span(), message));
            return None;
        }
        Some(Self(counts))
    }

    fn canonical(&self) -> Value {
        json!(self.0)
    }
}
