//! An exhibit with other parameters than its chapter gives it: what a reader asks for who changes an experiment.

use std::sync::Arc;

use toml::de::{DeTable, DeValue};

use super::{Exhibit, Plan, Reading, Seen, exhibit};
use crate::diag::Diagnostic;
use crate::parse::{Chapter, Course, Fence, SourceMap};
use crate::workspace::{Source, Workspace};

/// A parameter that is asked for, and its value as TOML.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    name: String,
    value: String,
}

impl Change {
    /// `name` is to be `value`: TOML, or a word that stands for itself; several with commas between them are a list. What begins as a
    /// list, a table or a string and is none is an error.
    pub fn new(name: &str, value: &str) -> Result<Self, String> {
        let value = match DeValue::parse(value) {
            Ok(_) => value.to_owned(),
            Err(error) if value.starts_with(['[', '{', '"', '\'']) => {
                return Err(format!("`{value}` is no TOML: {}", error.message()));
            }
            Err(_) => match listed(value)[..] {
                [_] | [] => word(value),
                ref several => {
                    format!("[{}]", several.iter().map(|one| element(one)).collect::<Vec<_>>().join(", "))
                }
            },
        };
        Ok(Self { name: name.to_owned(), value })
    }
}

/// A word as TOML.
fn word(word: &str) -> String {
    toml::Value::from(word).to_string()
}

/// One element of a list as TOML.
fn element(written: &str) -> String {
    if DeValue::parse(written).is_ok() { written.to_owned() } else { word(written) }
}

/// The parts of `16,4096`; a comma within parentheses, as in `min(x1, x2)`, parts nothing, and neither does one with nothing on a side.
fn listed(text: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0_usize, 0);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => {
                parts.push(text[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(text[start..].trim());
    if parts.iter().any(|part| part.is_empty()) { vec![text] } else { parts }
}

/// An exhibit that was changed, with the text that complaints of it are about.
pub struct Changed {
    /// The exhibit; none if a change is wrong.
    pub exhibit: Option<Exhibit>,
    /// Its fence as changed.
    pub workspace: Workspace,
    /// What is wrong.
    pub diagnostics: Vec<Diagnostic>,
}

impl Plan {
    /// The exhibit `id` with `changes`, read as a chapter's fence is; none if the book has no such exhibit.
    pub fn changed(&self, course: &Course, id: &str, changes: &[Change]) -> Option<Changed> {
        let index = self.exhibits.iter().position(|exhibit| exhibit.id == id)?;
        let original = &self.exhibits[index];
        let chapter = course.chapters.get(original.chapter)?;
        let fences = chapter.content.experiments.iter().zip(&self.exhibit_of[original.chapter]);
        let fence = fences.into_iter().find(|(_, of)| **of == Some(index))?.0;
        let aliases = aliases(original);
        let text = changes.iter().fold(fence.text.clone(), |text, change| change.of(&text, &aliases));
        let asked = changes.iter().map(|change| format!("-p {}={}", change.name, change.value));
        let path = std::iter::once(id.to_owned()).chain(asked).collect::<Vec<_>>().join(" ");
        let source = Source { path: path.into(), text: text.as_str().into() };
        let fence = Fence { map: SourceMap::whole(0, text.len()), range: 0..text.len(), text };
        let chapter = Chapter { file: Arc::clone(&source.path), content: Arc::default(), ..chapter.clone() };
        let workspace = Workspace::of(source);
        let reading =
            Reading { chapter: &chapter, index: original.chapter, seed: original.seed, workspace: &workspace };
        let mut diagnostics = Vec::new();
        let exhibit = exhibit::read(&fence, &reading, &mut Seen::default(), &mut diagnostics);
        Some(Changed { exhibit, workspace, diagnostics })
    }
}

/// The names of parameters that have two.
fn aliases(exhibit: &Exhibit) -> Vec<(&'static str, &'static str)> {
    let docs = exhibit.experiment.kind().parameters();
    docs.into_iter().filter_map(|doc| Some((doc.name, doc.alias?))).collect()
}

impl Change {
    /// The TOML `text` with this change: in the place of what is there, under either name, or before all else.
    fn of(&self, text: &str, aliases: &[(&str, &str)]) -> String {
        let line = format!("{} = {}", self.name, self.value);
        let same = |key: &str| {
            key == self.name || aliases.contains(&(key, &self.name)) || aliases.contains(&(&self.name, key))
        };
        let (table, _) = DeTable::parse_recoverable(text);
        let old = table.get_ref().iter().find(|(key, _)| same(key.get_ref()));
        match old.map(|(key, value)| (key.span().start, value.span().end)) {
            Some((start, end)) => format!("{}{line}{}", &text[..start], &text[end..]),
            None => format!("{line}\n{text}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_is_toml_or_a_word() {
        let value = |written| Change::new("x", written).unwrap().value;
        for toml in ["4000", "1.5", "true", "[\"a\", 2]", "\"4\"", "'x'"] {
            assert_eq!(value(toml), toml);
        }
        assert_eq!(value("sobol+owen"), "\"sobol+owen\"");
        assert_eq!(value("2^4..2^8"), "\"2^4..2^8\"");
        assert_eq!(value("a\"b\\"), "'a\"b\\'");
        assert_eq!(value("16,4096"), "[16, 4096]");
        assert_eq!(value("halton, sobol+owen,2^4..2^8"), "[\"halton\", \"sobol+owen\", \"2^4..2^8\"]");
        assert_eq!(value("min(x1, x2)"), "\"min(x1, x2)\"");
        assert_eq!(value("16,"), "\"16,\"");
        let two = value("4\nid = 3");
        assert_eq!(DeValue::parse(&two).unwrap().get_ref().as_str(), Some("4\nid = 3"), "{two}");
        for broken in ["[a", "\"a", "[1] 2"] {
            assert!(Change::new("x", broken).unwrap_err().contains(broken), "told, not taken as a word");
        }
    }

    #[test]
    fn a_change_takes_the_place_of_what_is_there() {
        let text = "id = \"fig-x\"\nsampler = \"halton\" # plain\nn = [1,\n  2]\n\n[claims]\n";
        let change = |name, value| Change::new(name, value).unwrap().of(text, &[("samplers", "sampler")]);
        assert_eq!(change("n", "4"), text.replace("[1,\n  2]", "4"));
        assert_eq!(change("samplers", "['a']"), text.replace("sampler = \"halton\"", "samplers = ['a']"));
        assert_eq!(change("d", "2"), format!("d = 2\n{text}"));
    }
}
