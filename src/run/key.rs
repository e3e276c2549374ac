//! Keys: the address of a result, with everything in it that can change the result.
//!
//! A key is a named struct that people can read: `workbook why` prints it and says what differs from the last run.

use std::collections::BTreeMap;
use std::fmt;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::kinds::Experiment;
use crate::sources::{self, Digest};

/// The version of what the cache holds: raised when the encoding of results, or this module, changes its meaning.
pub const FORMAT: u32 = 1;

/// Everything that can change a result. File times, prose, captions and colours are not among it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Key {
    /// The version of the format, [`FORMAT`].
    pub format: u32,
    /// The kind of the experiment.
    pub kind: String,
    /// The parameters, every default filled in.
    pub parameters: Value,
    /// The seed.
    pub seed: u64,
    /// The digests of the entries' code that the experiment uses, by file.
    pub code: BTreeMap<String, Digest>,
    /// The digest of the code that all experiments share.
    pub engine: Digest,
    /// The digest of the locked dependencies.
    pub dependencies: Digest,
}

impl Key {
    /// The key of `experiment` with `seed`, for the code of this very program.
    pub fn new(experiment: &dyn Experiment, seed: u64) -> Self {
        let sources = sources::sources();
        Self {
            format: FORMAT,
            kind: experiment.kind().about().key.to_owned(),
            parameters: experiment.question(),
            seed,
            code: sources.code(experiment.abouts().into_iter().map(|about| about.file)),
            engine: sources.engine,
            dependencies: sources.dependencies,
        }
    }

    /// The key as JSON in its one canonical form: no spaces, every object sorted by name.
    pub fn canonical(&self) -> String {
        let mut text = String::new();
        // A key is numbers, texts and maps with texts for names: it always has a JSON form.
        write_canonical(&serde_json::to_value(self).unwrap_or_default(), &mut text);
        text
    }

    /// The address: the digest of the canonical form.
    pub fn digest(&self) -> Digest {
        Digest::of(self.canonical().as_bytes())
    }

    /// The first part that differs from `old`.
    pub fn first_difference(&self, old: &Self) -> Option<Difference> {
        self.differences(old).into_iter().next()
    }

    /// Every part that differs from `old`, in the order of the fields.
    pub fn differences(&self, old: &Self) -> Vec<Difference> {
        let mut found = Vec::new();
        let mut part = |part: &str, old: Option<String>, new: Option<String>| {
            if old != new {
                found.push(Difference { part: part.to_owned(), old, new });
            }
        };
        part("format", Some(old.format.to_string()), Some(self.format.to_string()));
        part("kind", Some(old.kind.clone()), Some(self.kind.clone()));
        let (before, after) = (leaves(&old.parameters), leaves(&self.parameters));
        for name in names(&before, &after) {
            part(name, before.get(name).cloned(), after.get(name).cloned());
        }
        part("seed", Some(old.seed.to_string()), Some(self.seed.to_string()));
        for file in names(&old.code, &self.code) {
            let of = |key: &Self| key.code.get(file).map(Digest::short);
            part(&format!("code.{file}"), of(old), of(self));
        }
        part("engine", Some(old.engine.short()), Some(self.engine.short()));
        part("dependencies", Some(old.dependencies.short()), Some(self.dependencies.short()));
        found
    }
}

/// A part of a key that differs from an older key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The part, e.g. `parameters.replicates` or `code.samplers/halton.rs`.
    pub part: String,
    /// What it was; `None` if it was not there.
    pub old: Option<String>,
    /// What it is; `None` if it is no longer there.
    pub new: Option<String>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shown = |value: &Option<String>| value.clone().unwrap_or_else(|| "absent".to_owned());
        write!(f, "{}: {} -> {}", self.part, shown(&self.old), shown(&self.new))
    }
}

/// The names of two maps, sorted, each once.
fn names<'a, T>(old: &'a BTreeMap<String, T>, new: &'a BTreeMap<String, T>) -> Vec<&'a str> {
    let mut names: Vec<&str> = old.keys().chain(new.keys()).map(String::as_str).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// The parameters by name, each as canonical JSON.
fn leaves(parameters: &Value) -> BTreeMap<String, String> {
    let shown = |value: &Value| {
        let mut text = String::new();
        write_canonical(value, &mut text);
        text
    };
    match parameters {
        Value::Object(fields) => {
            fields.iter().map(|(name, value)| (format!("parameters.{name}"), shown(value))).collect()
        }
        other => BTreeMap::from([("parameters".to_owned(), shown(other))]),
    }
}

/// Writes `value` without spaces and with sorted names, whatever order its objects keep.
fn write_canonical(value: &Value, text: &mut String) {
    match value {
        Value::Array(items) => {
            text.push('[');
            for (at, item) in items.iter().enumerate() {
                text.push_str(if at > 0 { "," } else { "" });
                write_canonical(item, text);
            }
            text.push(']');
        }
        Value::Object(fields) => {
            let sorted: BTreeMap<&String, &Value> = fields.iter().collect();
            text.push('{');
            for (at, (name, value)) in sorted.into_iter().enumerate() {
                text.push_str(if at > 0 { "," } else { "" });
                text.push_str(&Value::from(name.as_str()).to_string());
                text.push(':');
                write_canonical(value, text);
            }
            text.push('}');
        }
        plain => text.push_str(&plain.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn key() -> Key {
        Key {
            format: FORMAT,
            kind: "convergence".into(),
            parameters: json!({"samplers": ["halton"], "replicates": 64, "x": 0.1}),
            seed: u64::MAX,
            code: BTreeMap::from([("samplers/halton.rs".into(), Digest::of(b"a"))]),
            engine: Digest::of(b"b"),
            dependencies: Digest::of(b"c"),
        }
    }

    #[test]
    fn survives_json() {
        let back: Key = serde_json::from_str(&key().canonical()).unwrap();
        assert_eq!(back, key());
        assert_eq!(back.digest(), key().digest());
        let pretty: Key = serde_json::from_str(&serde_json::to_string_pretty(&key()).unwrap()).unwrap();
        assert_eq!(pretty.digest(), key().digest());
    }

    #[test]
    fn every_part_counts() {
        type Change = fn(&mut Key);
        let changes: [(&str, Change); 8] = [
            ("format", |key| key.format = 9),
            ("kind", |key| key.kind = "points".into()),
            ("parameters.replicates", |key| key.parameters["replicates"] = json!(65)),
            ("parameters.new", |key| key.parameters["new"] = json!(null)),
            ("seed", |key| key.seed = 1),
            ("code.samplers/halton.rs", |key| key.code.clear()),
            ("engine", |key| key.engine = Digest::of(b"x")),
            ("dependencies", |key| key.dependencies = Digest::of(b"x")),
        ];
        for (part, change) in changes {
            let mut new = key();
            change(&mut new);
            assert_ne!(new.digest(), key().digest(), "{part}");
            let found = new.differences(&key());
            assert_eq!(found.iter().map(|found| found.part.as_str()).collect::<Vec<_>>(), [part]);
            assert_eq!(new.first_difference(&key()), found.into_iter().next());
        }
        assert_eq!(key().first_difference(&key()), None);
    }

    #[test]
    fn differences_read_well() {
        let mut new = key();
        new.parameters = json!({"samplers": ["halton", "sobol+xor"], "x": 0.1});
        let shown: Vec<String> = new.differences(&key()).iter().map(ToString::to_string).collect();
        assert_eq!(
            shown,
            ["parameters.replicates: 64 -> absent", r#"parameters.samplers: ["halton"] -> ["halton","sobol+xor"]"#]
        );
    }
}
