//! Claims as written: statements about an exhibit's values that the build verifies.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::diag::Code;
use crate::parameters::{Complaint, Fields};

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

/// What must hold of a value.
#[derive(Debug, Clone, PartialEq)]
pub enum Bound {
    /// Not further than `within` from `target`.
    Near {
        /// The number it should be near.
        target: f64,
        /// The largest distance.
        within: f64,
    },
    /// Less than this.
    Below(f64),
    /// More than this.
    Above(f64),
    /// Exactly this.
    Equals(Literal),
    /// A truth that holds, or a falsehood that does not.
    Holds(bool),
    /// Not further than `within` standard errors from another value of the exhibit.
    Agrees {
        /// The other value's name.
        with: String,
        /// How many standard errors.
        within: f64,
    },
}

/// What a value can be equal to.
#[derive(Debug, Clone, PartialEq)]
pub enum Literal {
    /// A number.
    Number(f64),
    /// A text.
    Text(String),
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
        .help("or `{ agrees = \"exact\", within = 4 }`: within 4 standard errors of another value")
}

fn read_bounds(fields: &mut Fields<'_>, key: Range<usize>) -> Vec<Bound> {
    let mut bounds = Vec::new();
    let within = fields.read::<f64>("within");
    if within.is_some_and(|within| within < 0.0) {
        let place = fields.place("within");
        fields.complaints.push(Complaint::new(
            Code::OutOfRange,
            place,
            "`within` is a distance: it cannot be negative",
        ));
    }
    if let Some(target) = fields.read::<f64>("near") {
        match within {
            Some(within) => bounds.push(Bound::Near { target, within }),
            None => fields.complaints.push(
                Complaint::new(Code::BadClaim, fields.place("near"), "`near` needs `within`: how near?").help(
                    "write `{ near = x, within = y }` with a tolerance that theory or a standard error justifies",
                ),
            ),
        }
    }
    bounds.extend(fields.read::<f64>("below").map(Bound::Below));
    bounds.extend(fields.read::<f64>("above").map(Bound::Above));
    bounds.extend(fields.read::<bool>("holds").map(Bound::Holds));
    bounds.extend(read_equals(fields));
    if let Some(with) = fields.read::<String>("agrees") {
        bounds.push(Bound::Agrees { with, within: within.unwrap_or(4.0) });
    } else if within.is_some() && fields.value("near").is_none() {
        let place = fields.place("within");
        fields.complaints.push(Complaint::new(Code::BadClaim, place, "`within` goes with `near` or with `agrees`"));
    }
    if bounds.is_empty() && fields.complaints.is_empty() {
        fields.complaints.push(shapeless("this value", key));
    }
    bounds
}

fn read_equals(fields: &mut Fields<'_>) -> Option<Bound> {
    let value = fields.value("equals")?;
    let literal = match value.get_ref() {
        DeValue::String(text) => {
            fields.take("equals");
            Literal::Text(text.to_string())
        }
        DeValue::Boolean(truth) => {
            fields.take("equals");
            return Some(Bound::Holds(*truth));
        }
        _ => Literal::Number(fields.read::<f64>("equals")?),
    };
    Some(Bound::Equals(literal))
}
