//! Names and formulas: samplers with their scrambles, integrands, and scenes.

use std::ops::{Range, RangeInclusive};

use serde_json::{Value, json};
use toml::Spanned;
use toml::de::DeValue;

use super::{Complaint, ParameterType, Unbounded, wrong_type};
use crate::catalogue::{About, find, nearest};
use crate::diag::Code;
use crate::integrands::{ExpressionError, Function, INTEGRANDS};
use crate::samplers::{Method, UnknownMethod, WrongSetting};
use crate::scenes::{SCENES, Scene};

impl ParameterType for Method {
    type Bound = Unbounded;

    fn type_name() -> String {
        "the name of a sampler".to_owned()
    }

    fn schema() -> Value {
        let name = "[a-z0-9-]+";
        let setting = format!("{name} *= *[0-9]+");
        let settings = format!("\\( *{setting} *(, *{setting} *)*\\)");
        json!({ "type": "string", "pattern": format!("^{name}({settings})?(\\+{name})?$") })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        _: Option<&RangeInclusive<Unbounded>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let Some(text) = value.get_ref().as_str() else {
            wrong_type::<Self>(value, complaints);
            return None;
        };
        match Method::parse(text) {
            Ok(method) => Some(method),
            Err(error) => {
                complaints.push(unknown(text, &error, &value.span()));
                None
            }
        }
    }

    fn canonical(&self) -> Value {
        json!(self.name())
    }

    fn abouts(&self) -> Vec<&'static About> {
        Method::abouts(self)
    }
}

/// What is wrong with the name `text` of a method, which stands at `place`, quotes included.
fn unknown(text: &str, error: &UnknownMethod, place: &Range<usize>) -> Complaint {
    let whole = place.clone();
    let (code, place, message, list) = match error {
        UnknownMethod::Sampler { written, .. } => {
            (Code::UnknownName, whole, format!("unknown sampler `{written}`"), "samplers")
        }
        UnknownMethod::Scramble { written, .. } => {
            (Code::UnknownName, whole, format!("unknown scramble `{written}`"), "scrambles")
        }
        UnknownMethod::Setting { error: wrong, range, .. } => {
            let code = match wrong {
                WrongSetting::Unknown { .. } => Code::UnknownKey,
                WrongSetting::Value { .. } => Code::OutOfRange,
                _ => Code::Expression,
            };
            (code, inside(text, place, range), error.to_string(), "samplers")
        }
        other => (Code::Combination, whole, other.to_string(), "scrambles"),
    };
    Complaint::new(code, place, message)
        .help_if(error.suggestion().map(|name| format!("did you mean `{name}`?")))
        .help(format!("`workbook list {list}` shows all"))
}

impl ParameterType for &'static dyn Scene {
    type Bound = Unbounded;

    fn type_name() -> String {
        "the name of a scene".to_owned()
    }

    fn schema() -> Value {
        json!({ "enum": SCENES.iter().map(|scene| scene.about().key).collect::<Vec<_>>() })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        _: Option<&RangeInclusive<Unbounded>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        let Some(text) = value.get_ref().as_str() else {
            wrong_type::<Self>(value, complaints);
            return None;
        };
        let found = find(SCENES, text);
        if found.is_none() {
            let offer = nearest(text, SCENES.iter().map(|scene| scene.about().key));
            let complaint = Complaint::new(Code::UnknownName, value.span(), format!("unknown scene `{text}`"))
                .help_if(offer.map(|name| format!("did you mean `{name}`?")))
                .help("`workbook list scenes` shows all");
            complaints.push(complaint);
        }
        found
    }

    fn canonical(&self) -> Value {
        json!(self.about().key)
    }

    fn abouts(&self) -> Vec<&'static About> {
        vec![self.about()]
    }
}

impl ParameterType for Function {
    type Bound = Unbounded;

    fn type_name() -> String {
        "an integrand: a catalogued name, or an expression such as \"exp(sin(3*x^2))\"".to_owned()
    }

    fn schema() -> Value {
        json!({ "type": ["string", "number"] })
    }

    fn read(
        value: &Spanned<DeValue<'_>>,
        _: Option<&RangeInclusive<Unbounded>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self> {
        // A plain number is an expression, whether it is quoted or not.
        let text = match value.get_ref() {
            DeValue::String(text) => text.to_string(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.to_string(),
            DeValue::Float(float) => float.as_str().to_owned(),
            _ => {
                wrong_type::<Self>(value, complaints);
                return None;
            }
        };
        let text = text.as_str();
        match Function::parse(text) {
            Ok(function) => Some(function),
            Err(error) => {
                complaints.push(complain(text, &value.span(), error));
                None
            }
        }
    }

    fn canonical(&self) -> Value {
        json!(self.text().trim())
    }

    fn abouts(&self) -> Vec<&'static About> {
        Function::abouts(self)
    }
}

/// What is wrong with the integrand `text`, which stands at `place`, quotes included.
fn complain(text: &str, place: &Range<usize>, error: ExpressionError) -> Complaint {
    let all = "`workbook list integrands` shows the catalogued ones; an expression is in x, y or x1, x2, ...";
    let is_name = !text.is_empty() && text.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '-');
    if is_name && (error.range == (0..text.len()) || text.contains('-')) {
        let offer = nearest(text, INTEGRANDS.iter().map(|integrand| integrand.about().key));
        let offer = offer.map(str::to_owned).or(error.suggestion).map(|name| format!("did you mean `{name}`?"));
        return Complaint::new(Code::UnknownName, place.clone(), format!("unknown integrand `{text}`"))
            .help_if(offer)
            .help(all);
    }
    Complaint::new(Code::Expression, inside(text, place, &error.range), error.message)
        .help_if(error.suggestion.map(|name| format!("did you mean `{name}`?")))
        .help(all)
}

/// The bytes of the fence where `range` of the string `text` stands; the whole string if it is written with escapes.
pub(crate) fn inside(text: &str, place: &Range<usize>, range: &Range<usize>) -> Range<usize> {
    let plain = place.len() == text.len() + 2;
    if !plain || range.start > range.end || range.end > text.len() {
        return place.clone();
    }
    let start = place.start + 1 + range.start;
    // A range of nothing, such as the end of the expression, marks at least the quote after it.
    start..(place.start + 1 + range.end).max(start + 1)
}
