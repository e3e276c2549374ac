//! Parameters: from the keys of an experiment's fence to typed values, with every mistake told at its place.
//!
//! A kind declares its parameters once, with `parameters!`; the declaration is the struct, its reader, its documentation and
//! its canonical form. Reading never stops at the first mistake: complaints gather in [`Fields`].

use std::collections::BTreeSet;
use std::ops::{Range, RangeInclusive};

use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::catalogue::{About, nearest};
use crate::diag::Code;

#[macro_use]
mod declare;
mod counts;
mod names;
mod pair;
mod scalars;

pub use counts::Counts;
pub(crate) use counts::place_of;
pub(crate) use declare::{choices, parameters};
pub(crate) use names::inside;
pub use pair::Pair;
pub use scalars::Unbounded;
pub(crate) use scalars::read_word;

/// The keys that every experiment's fence may have, whatever its kind.
pub const COMMON_KEYS: &[&str] = &["id", "kind", "caption", "alt", "seed", "claims"];

/// One mistake in a fence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complaint {
    /// Which kind of mistake.
    pub code: Code,
    /// The bytes in the fence's TOML.
    pub range: Range<usize>,
    /// What is wrong, in one line.
    pub message: String,
    /// What to do, one line each.
    pub help: Vec<String>,
}

impl Complaint {
    /// A complaint without help.
    pub fn new(code: Code, range: Range<usize>, message: impl Into<String>) -> Self {
        Self { code, range, message: message.into(), help: Vec::new() }
    }

    /// With a line that says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help.push(help.into());
        self
    }

    /// With a line that says what to do, if there is one.
    #[must_use]
    pub fn help_if(self, help: Option<String>) -> Self {
        match help {
            Some(help) => self.help(help),
            None => self,
        }
    }
}

/// The keys of a fence: which were read, and what was wrong with them.
pub struct Fields<'a> {
    table: &'a DeTable<'a>,
    used: BTreeSet<String>,
    /// The keys that are read elsewhere.
    common: &'static [&'static str],
    /// What is wrong so far, in the order of discovery.
    pub complaints: Vec<Complaint>,
}

impl<'a> Fields<'a> {
    /// The fields of a fence's table, none of them read yet.
    pub fn new(table: &'a DeTable<'a>) -> Self {
        Self { table, used: BTreeSet::new(), common: COMMON_KEYS, complaints: Vec::new() }
    }

    /// The fields of a table that is no experiment's, so that no key is common.
    pub fn plain(table: &'a DeTable<'a>) -> Self {
        Self { common: &[], ..Self::new(table) }
    }

    /// The table at `key`, if it is there and is one.
    pub fn table(&mut self, key: &str) -> Option<&'a DeTable<'a>> {
        let value = self.take(key)?;
        let table = value.get_ref().as_table();
        if table.is_none() {
            let message = format!("expected a table, found {}", found(value.get_ref()));
            self.complaints.push(Complaint::new(Code::WrongType, value.span(), message));
        }
        table
    }

    /// The value of `key`, which counts as known from now on.
    pub fn take(&mut self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.used.insert(key.to_owned());
        self.table.get(key)
    }

    /// The value of `key`, read as a `T` if it is there and right.
    pub fn read<T: ParameterType>(&mut self, key: &str) -> Option<T> {
        let value = self.take(key)?;
        T::read(value, None, &mut self.complaints)
    }

    /// The value of `key`, known or not.
    pub fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table.get(key)
    }

    /// Where to complain of `key`: its value, or the value of `kind` where the key is not written.
    pub fn place(&self, key: &str) -> Range<usize> {
        self.value(key).or_else(|| self.value("kind")).map_or(0..0, Spanned::span)
    }

    /// Complains of every key that was not read; the nearest of `known` and of the common keys is offered.
    pub fn finish(&mut self, known: &[&str]) {
        let names = || known.iter().chain(self.common).copied();
        for (key, _) in self.table {
            let written: &str = key.get_ref();
            if self.used.contains(written) || self.common.contains(&written) {
                continue;
            }
            let offer = nearest(written, names()).map(|name| format!("did you mean `{name}`?"));
            let all = format!("its parameters are {}", enumerate(known, "and"));
            let complaint = Complaint::new(Code::UnknownKey, key.span(), format!("unknown key `{written}`"));
            self.complaints.push(complaint.help_if(offer).help(all));
        }
    }
}

/// The parameters of a kind of experiment; declared with `parameters!`.
pub trait Parameters: Sized + Send + Sync + 'static {
    /// Every parameter, in the order of the declaration.
    fn docs() -> Vec<ParameterDoc>;

    /// Reads every parameter; all that is wrong is in `fields`, and defaults stand in for it. `None` if one without a default is
    /// missing or wrong.
    fn read(fields: &mut Fields<'_>) -> Option<Self>;

    /// The parameters as an object with every default filled in: equal questions give equal objects.
    fn canonical(&self) -> Value;

    /// The parameters that only the drawing reads.
    fn drawn() -> Vec<&'static str>;

    /// The members of catalogues that the parameters name.
    fn abouts(&self) -> Vec<&'static About>;
}

/// What a parameter is, for lists, help and the schema.
#[derive(Debug, Clone, PartialEq)]
pub struct ParameterDoc {
    /// The key in the fence.
    pub name: &'static str,
    /// Another name for it, if it has one.
    pub alias: Option<&'static str>,
    /// What is expected, e.g. `a list of samplers`.
    pub type_name: String,
    /// Its JSON schema.
    pub schema: Value,
    /// The default as TOML; `None` where the key must be written or may be absent.
    pub default: Option<&'static str>,
    /// Whether the key must be written.
    pub required: bool,
    /// Its limits, e.g. `2 to 1000000`.
    pub limits: Option<String>,
    /// What it means, in a sentence.
    pub meaning: &'static str,
}

/// A type that a parameter can have.
pub trait ParameterType: Sized {
    /// What the limits of a parameter of this type are made of.
    type Bound: PartialOrd + std::fmt::Display;

    /// What is expected, as help says it: `a whole number`.
    fn type_name() -> String;

    /// The JSON schema of the type.
    fn schema() -> Value;

    /// Reads a value; complains and gives `None` if it is wrong.
    fn read(
        value: &Spanned<DeValue<'_>>,
        limits: Option<&RangeInclusive<Self::Bound>>,
        complaints: &mut Vec<Complaint>,
    ) -> Option<Self>;

    /// The value in its one canonical form.
    fn canonical(&self) -> Value;

    /// The members of catalogues that the value names.
    fn abouts(&self) -> Vec<&'static About> {
        Vec::new()
    }

    /// The value of a key that is not written and has no default, if it may be absent.
    fn absent() -> Option<Self> {
        None
    }
}

/// How `parameters!` hands one parameter's declaration to [`read_parameter`].
pub(crate) struct Declared<T: ParameterType> {
    pub(crate) name: &'static str,
    pub(crate) alias: Option<&'static str>,
    pub(crate) limits: Option<RangeInclusive<T::Bound>>,
    pub(crate) default: Option<&'static str>,
    pub(crate) meaning: &'static str,
}

/// Reads the parameter `declared`, under either of its names, or its default.
pub(crate) fn read_parameter<T: ParameterType>(fields: &mut Fields<'_>, declared: &Declared<T>) -> Option<T> {
    let name = declared.name;
    let written = fields.take(name);
    let aliased = declared.alias.and_then(|alias| fields.take(alias));
    if let (Some(_), Some(second), Some(alias)) = (written, aliased, declared.alias) {
        let message = format!("`{alias}` is another name for `{name}`, which is there already");
        fields.complaints.push(Complaint::new(Code::Combination, second.span(), message).help("keep one of the two"));
    }
    if let Some(value) = written.or(aliased) {
        return T::read(value, declared.limits.as_ref(), &mut fields.complaints);
    }
    if let Some(default) = fallback(declared) {
        return Some(default);
    }
    let absent = T::absent();
    if absent.is_none() {
        let message = format!("the key `{name}` is missing");
        let help = format!("`{name}` is {}: {}", T::type_name(), declared.meaning);
        fields.complaints.push(Complaint::new(Code::MissingKey, fields.place("kind"), message).help(help));
    }
    absent
}

/// The default of the parameter `declared`, if it has one.
pub(crate) fn fallback<T: ParameterType>(declared: &Declared<T>) -> Option<T> {
    let value = DeValue::parse(declared.default?).ok()?;
    T::read(&value, declared.limits.as_ref(), &mut Vec::new())
}

/// What the parameter `declared` is.
pub(crate) fn document<T: ParameterType>(declared: &Declared<T>) -> ParameterDoc {
    ParameterDoc {
        name: declared.name,
        alias: declared.alias,
        type_name: T::type_name(),
        schema: T::schema(),
        default: declared.default,
        required: declared.default.is_none() && T::absent().is_none(),
        limits: declared.limits.as_ref().map(|limits| format!("{} to {}", limits.start(), limits.end())),
        meaning: declared.meaning,
    }
}

/// Complains that `value` is not what was expected.
pub(crate) fn wrong_type<T: ParameterType>(value: &Spanned<DeValue<'_>>, complaints: &mut Vec<Complaint>) {
    let message = format!("expected {}, found {}", T::type_name(), found(value.get_ref()));
    complaints.push(Complaint::new(Code::WrongType, value.span(), message));
}

/// What a TOML value is, in words.
fn found(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(_) => "a whole number",
        DeValue::Float(_) => "a number with a fraction",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}

/// Complains that `written` lies outside of `limits`, if it does.
pub(crate) fn outside<B: PartialOrd + std::fmt::Display>(
    number: &B,
    limits: Option<&RangeInclusive<B>>,
    place: &Range<usize>,
    complaints: &mut Vec<Complaint>,
) -> bool {
    let Some(limits) = limits.filter(|limits| !limits.contains(number)) else { return false };
    let message = format!("{number} is out of range: it must be from {} to {}", limits.start(), limits.end());
    complaints.push(Complaint::new(Code::OutOfRange, place.clone(), message));
    true
}

/// The names in a sentence: `a`, `b` and `c`.
pub(crate) fn enumerate(names: &[&str], last: &str) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.as_slice() {
        [] => "none".to_owned(),
        [one] => one.clone(),
        [most @ .., end] => format!("{} {last} {end}", most.join(", ")),
    }
}
