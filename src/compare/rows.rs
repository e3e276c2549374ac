//! Numbers and claims next to each other: old, new, and by how much they differ.

use serde::Serialize;
use serde_json::{Map, Value as Json};

use super::record::{Claim, Record};

/// Something that has one value in the old book and another in the new.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// What it is.
    pub name: String,
    /// What the old book has; empty if it has none.
    pub old: String,
    /// What the new book has; empty if it has none.
    pub new: String,
    /// By how much numbers differ, in words; may be empty.
    pub difference: String,
}

/// A claim that one of the books has, or both with another verdict.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stated {
    /// What is claimed.
    pub claim: String,
    /// What the old book measured; empty if it does not claim this.
    pub old: String,
    /// What the new book measured; empty if it does not claim this.
    pub new: String,
    /// Whether it held in the old book, if that claims it.
    pub held: Option<bool>,
    /// Whether it holds in the new book, if that claims it.
    pub holds: Option<bool>,
    /// Whether both claim it, with different verdicts.
    pub verdict_changed: bool,
}

/// Kind, seed and parameters that differ.
pub(super) fn parameters(was: &Record, is: &Record) -> Vec<Row> {
    let head = |record: &Record| {
        let mut all = record.parameters.clone();
        all.insert("kind".to_owned(), Json::String(record.kind.clone()));
        all.insert("seed".to_owned(), record.seed.clone());
        all
    };
    values(&head(was), &head(is))
}

/// The entries that differ, sorted by name with numbers in names in their order.
pub(super) fn values(was: &Map<String, Json>, is: &Map<String, Json>) -> Vec<Row> {
    let mut names: Vec<&String> = was.keys().chain(is.keys().filter(|name| !was.contains_key(*name))).collect();
    names.sort_by_cached_key(|name| sortable(name));
    let differs = |name: &&String| was.get(*name) != is.get(*name);
    let row = |name: &String| {
        let (old, new) = (was.get(name), is.get(name));
        let difference = match (old.and_then(Json::as_f64), new.and_then(Json::as_f64)) {
            (Some(old), Some(new)) => by(old, new),
            _ => String::new(),
        };
        Row { name: name.clone(), old: text(old), new: text(new), difference }
    };
    names.into_iter().filter(differs).map(row).collect()
}

/// A name with its numbers padded, so that 64 comes before 1024.
fn sortable(name: &str) -> String {
    let pad = |part: &str| part.parse::<u64>().map_or_else(|_| part.to_owned(), |number| format!("{number:020}"));
    name.split('.').map(pad).collect::<Vec<_>>().join(".")
}

/// By how much a number changed: in per cent where that says something.
fn by(old: f64, new: f64) -> String {
    let change = new - old;
    if old == 0.0 || !(change / old).is_finite() {
        return format!("{change:+.3e}");
    }
    let percent = 100.0 * change / old.abs();
    match percent.abs() {
        share if share < 1e-3 => format!("{percent:+.1e} %"),
        share if share < 1e4 => format!("{percent:+.3} %"),
        _ => format!("× {:.3e}", new / old),
    }
}

/// A value as text.
fn text(value: Option<&Json>) -> String {
    match value {
        None => String::new(),
        Some(Json::String(words)) => words.clone(),
        Some(other) => other.to_string(),
    }
}

/// The claims that only one of the books has, and those with another verdict.
pub(super) fn claims(was: &[Claim], is: &[Claim]) -> Vec<Stated> {
    let same = |a: &Claim, b: &Claim| (&a.value, &a.bound) == (&b.value, &b.bound);
    let mut stated = Vec::new();
    for claim in is {
        let old = was.iter().find(|old| same(old, claim));
        if old.is_none_or(|old| old.holds != claim.holds) {
            stated.push(state(old, Some(claim)));
        }
    }
    stated.extend(was.iter().filter(|old| !is.iter().any(|claim| same(old, claim))).map(|old| state(Some(old), None)));
    stated
}

fn state(old: Option<&Claim>, new: Option<&Claim>) -> Stated {
    let claim = new.or(old).map(|claim| format!("{} {}", claim.value, claim.bound)).unwrap_or_default();
    let measured = |claim: Option<&Claim>| claim.map(|claim| text(Some(&claim.measured))).unwrap_or_default();
    let (held, holds) = (old.map(|claim| claim.holds), new.map(|claim| claim.holds));
    Stated {
        claim,
        old: measured(old),
        new: measured(new),
        held,
        holds,
        verdict_changed: held.is_some() && holds.is_some() && held != holds,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn map(value: Json) -> Map<String, Json> {
        serde_json::from_value(value).unwrap()
    }

    #[test]
    fn only_what_differs_is_listed_in_the_order_of_its_numbers() {
        let was = map(json!({ "rmse.a.1024": 2.0, "rmse.a.64": 1.0, "same": 3, "gone": "x" }));
        let is = map(json!({ "rmse.a.1024": 1.0, "rmse.a.64": 1.5, "same": 3, "new": true }));
        let rows = values(&was, &is);
        let names: Vec<&str> = rows.iter().map(|row| row.name.as_str()).collect();
        assert_eq!(names, ["gone", "new", "rmse.a.64", "rmse.a.1024"]);
        assert_eq!((rows[0].old.as_str(), rows[0].new.as_str()), ("x", ""));
        assert_eq!((rows[2].difference.as_str(), rows[3].difference.as_str()), ("+50.000 %", "-50.000 %"));
    }

    #[test]
    fn differences_are_told_in_words_that_say_something() {
        assert_eq!(by(0.0, 1e-3), "+1.000e-3");
        assert_eq!(by(-2.0, -1.0), "+50.000 %");
        assert_eq!(by(1.0, 1.0 + 1e-9), "+1.0e-7 %");
        assert_eq!(by(1.0, 1e6), "× 1.000e6");
    }

    #[test]
    fn claims_are_told_where_they_or_their_verdicts_differ() {
        let claim = |value: &str, holds| Claim {
            value: value.to_owned(),
            bound: "below 1".to_owned(),
            measured: json!(0.5),
            holds,
        };
        let told = claims(
            &[claim("a", true), claim("b", true), claim("c", true)],
            &[claim("a", true), claim("b", false), claim("d", true)],
        );
        let told: Vec<(&str, bool)> =
            told.iter().map(|stated| (stated.claim.as_str(), stated.verdict_changed)).collect();
        assert_eq!(told, [("b below 1", true), ("d below 1", false), ("c below 1", false)]);
    }
}
