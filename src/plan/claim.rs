//! Claims as written: statements about an exhibit's values that the build verifies.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::amount::Amount;
use crate::diag::Code;
use crate::parameters::{Complaint, Fields};
use crate::parse::SourceMap;

/// A statement about values of an exhibit.
#[derive(Debug, Clone, PartialEq)]
pub struct Claim {
    /// The value's name; `*` stands for any part of a name, and then every value that fits must satisfy the bounds.
    pub value: String,
    /// What must hold of it.
    pub bounds: Vec<Bound>,
    /// The bytes of the claim in the fence's TOML.
    pub range: Range<usize>,
}

/// What must hold of a value; `N` is what its numbers are: [`Amount`] as written, `Settled` once they are known.
#[derive(Debug, Clone, PartialEq)]
pub enum Bound<N = Amount> {
    /// Not further than `within` from `target`.
    Near {
        /// The number it should be near.
        target: N,
        /// The largest distance.
        within: N,
    },
    /// Less than this.
    Below(N),
    /// More than this.
    Above(N),
    /// Exactly this.
    Equals(Literal<N>),
    /// A truth that holds, or a falsehood that does not.
    Holds(bool),
    /// Not further than `within` standard errors from another value of the exhibit, or from a number.
    Agrees {
        /// What it should be near.
        with: Other<N>,
        /// How many standard errors.
        within: N,
    },
}

/// What an estimate can agree with.
#[derive(Debug, Clone, PartialEq)]
pub enum Other<N = Amount> {
    /// Another value of the exhibit, by its name.
    Value(String),
    /// A number.
    Number(N),
}

/// What a value can be equal to.
#[derive(Debug, Clone, PartialEq)]
pub enum Literal<N = Amount> {
    /// A number.
    Number(N),
    /// A text.
    Text(String),
    /// A text that is an expression as well: a value that is a text must be the text, a number what the expression gives.
    Either(String, N),
}

impl<N> Bound<N> {
    /// Its numbers.
    pub fn amounts(&self) -> Vec<&N> {
        match self {
            Self::Near { target, within } | Self::Agrees { with: Other::Number(target), within } => {
                vec![target, within]
            }
            Self::Below(amount)
            | Self::Above(amount)
            | Self::Agrees { within: amount, .. }
            | Self::Equals(Literal::Number(amount) | Literal::Either(_, amount)) => vec![amount],
            Self::Equals(Literal::Text(_)) | Self::Holds(_) => Vec::new(),
        }
    }
}

impl Claim {
    /// It with places in the file instead of those in the fence.
    pub(super) fn placed(self, map: &SourceMap) -> Self {
        let bounds = self.bounds.into_iter().map(|bound| match bound {
            Bound::Near { target, within } => Bound::Near { target: target.placed(map), within: within.placed(map) },
            Bound::Below(limit) => Bound::Below(limit.placed(map)),
            Bound::Above(limit) => Bound::Above(limit.placed(map)),
            Bound::Equals(Literal::Number(number)) => Bound::Equals(Literal::Number(number.placed(map))),
            Bound::Equals(Literal::Either(text, number)) => Bound::Equals(Literal::Either(text, number.placed(map))),
            Bound::Agrees { with: Other::Number(with), within } => {
                Bound::Agrees { with: Other::Number(with.placed(map)), within: within.placed(map) }
            }
            Bound::Agrees { with, within } => Bound::Agrees { with, within: within.placed(map) },
            plain @ (Bound::Equals(Literal::Text(_)) | Bound::Holds(_)) => plain,
        });
        Self { bounds: bounds.collect(), range: map.range(self.range), value: self.value }
    }
}

const KEYS: &[&str] = &["near", "within", "below", "above", "equals", "holds", "agrees"];

/// Reads the table `[claims]` of a fence.
pub(super) fn read_all(fields: &mut Fields<'_>) -> Vec<Claim> {
    let Some(table) = fields.table("claims") else { return Vec::new() };
    let mut claims = Vec::new();
    flatten(table, "", &mut fields.complaints, &mut claims);
    // The table is sorted by name; readers see the claims in the order in which they are written.
    claims.sort_by_key(|claim| claim.range.start);
    claims
}

/// Reads a table of claims; a dotted key that was not quoted is a table in a table, and means the same.
fn flatten(table: &DeTable<'_>, prefix: &str, complaints: &mut Vec<Complaint>, claims: &mut Vec<Claim>) {
    for (key, value) in table {
        let name = format!("{prefix}{}", key.get_ref());
        match value.get_ref() {
            DeValue::Table(inner) if inner.keys().any(|key| KEYS.contains(&&**key.get_ref())) => {
                let mut fields = Fields::plain(inner);
                let bounds = read_bounds(&mut fields, key.span());
                fields.finish(KEYS);
                complaints.append(&mut fields.complaints);
                claims.push(Claim {
                    value: name,
                    bounds,
                    range: key.span().start..value.span().end.max(key.span().end),
                });
            }
            DeValue::Table(inner) if !inner.is_empty() => flatten(inner, &format!("{name}."), complaints, claims),
            _ => complaints.push(shapeless(&name, value.span())),
        }
    }
}

fn shapeless(name: &str, range: Range<usize>) -> Complaint {
    Complaint::new(Code::BadClaim, range, format!("the claim of `{name}` says nothing that can be verified"))
        .help(
            "write `{ near = x, within = y }`, `{ below = x }`, `{ above = x }`, `{ equals = x }`, `{ holds = true }`",
        )
        .help("or `{ agrees = \"exact\", within = 4 }`: within 4 standard errors of another value, or of a number")
}

fn read_bounds(fields: &mut Fields<'_>, key: Range<usize>) -> Vec<Bound> {
    let mut bounds = Vec::new();
    let within = Amount::read(fields, "within");
    if within.as_ref().and_then(Amount::constant).is_some_and(|within| within < 0.0) {
        let place = fields.place("within");
        fields.complaints.push(Complaint::new(
            Code::OutOfRange,
            place,
            "`within` is a distance: it cannot be negative",
        ));
    }
    if let Some(target) = Amount::read(fields, "near") {
        match within.clone() {
            Some(within) => bounds.push(Bound::Near { target, within }),
            // A tolerance that cannot be read has been told.
            None if fields.value("within").is_some() => {}
            None => fields.complaints.push(
                Complaint::new(Code::BadClaim, fields.place("near"), "`near` needs `within`: how near?").help(
                    "write `{ near = x, within = y }` with a tolerance that theory or a standard error justifies",
                ),
            ),
        }
    }
    bounds.extend(Amount::read(fields, "below").map(Bound::Below));
    bounds.extend(Amount::read(fields, "above").map(Bound::Above));
    bounds.extend(fields.read::<bool>("holds").map(Bound::Holds));
    bounds.extend(read_equals(fields));
    if let Some(with) = read_other(fields) {
        bounds.push(Bound::Agrees { with, within: within.unwrap_or(Amount::Number(4.0)) });
    } else if within.is_some() && fields.value("near").is_none() {
        let place = fields.place("within");
        fields.complaints.push(Complaint::new(Code::BadClaim, place, "`within` goes with `near` or with `agrees`"));
    }
    if bounds.is_empty() && fields.complaints.is_empty() {
        fields.complaints.push(shapeless("this value", key));
    }
    bounds
}

/// What `agrees` names: a number, an expression such as `4/3`, or else another value of the exhibit.
fn read_other(fields: &mut Fields<'_>) -> Option<Other> {
    let value = fields.value("agrees")?;
    let DeValue::String(text) = value.get_ref() else { return Amount::read(fields, "agrees").map(Other::Number) };
    let named = text.starts_with(|c: char| c.is_ascii_alphabetic());
    let bare = text.bytes().all(|byte| byte.is_ascii_alphanumeric() || b"._+-".contains(&byte));
    // Some names of values, such as `pi`, are expressions too: a name is meant. In an expression a value stands in brackets.
    if named && (bare || Amount::computed(text, value).is_err()) {
        return fields.read("agrees").map(Other::Value);
    }
    Amount::read(fields, "agrees").map(Other::Number)
}

fn read_equals(fields: &mut Fields<'_>) -> Option<Bound> {
    let value = fields.value("equals")?;
    let literal = match value.get_ref() {
        DeValue::String(text) => {
            fields.take("equals");
            // What is no expression can still be what a text is equal to.
            match Amount::computed(text, value) {
                Ok(amount) => Literal::Either(text.to_string(), amount),
                Err(_) => Literal::Text(text.to_string()),
            }
        }
        DeValue::Boolean(truth) => {
            fields.take("equals");
            return Some(Bound::Holds(*truth));
        }
        _ => Literal::Number(Amount::read(fields, "equals")?),
    };
    Some(Bound::Equals(literal))
}
