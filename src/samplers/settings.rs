//! Settings: whole numbers that a sampler can be told by name, as in `faure(base=5)`.
//!
//! A sampler declares them in [`Sampler::settings`](super::Sampler::settings), and
//! [`Sampler::with`](super::Sampler::with) makes the sampler that has been told; nothing else knows
//! them. What is not written has its default, and a value that is the default is as good as none:
//! both make the same method of the same name.

use super::digits::is_prime;
use crate::catalogue::nearest;
use std::fmt::{Display, Formatter};
use std::ops::Range;

/// The most settings that a sampler has.
const MOST_SETTINGS: usize = 2;

/// A setting of a sampler: a whole number from `least` to `most`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Setting {
    /// Its name, e.g. `base`.
    pub name: &'static str,
    /// What it means, without a full stop.
    pub meaning: &'static str,
    /// The smallest value.
    pub least: u32,
    /// The largest value.
    pub most: u32,
    /// Whether only primes will do.
    pub is_prime: bool,
    /// What holds where it is not written.
    pub default: Preset,
}

/// What holds for a setting that is not written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Preset {
    /// This value.
    Number(u32),
    /// A value that follows from n and d, in words.
    Rule(&'static str),
}

impl Display for Preset {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => number.fmt(f),
            Self::Rule(words) => f.write_str(words),
        }
    }
}

impl Setting {
    /// The values that it takes, in words: `a prime from 2 to 257`.
    pub fn limits(&self) -> String {
        let kind = if self.is_prime { "a prime" } else { "a whole number" };
        format!("{kind} from {} to {}", self.least, self.most)
    }

    fn admits(&self, value: u32) -> bool {
        (self.least..=self.most).contains(&value) && (!self.is_prime || is_prime(u64::from(value)))
    }

    /// The nearest values below and above `value` that it takes, where there are such.
    fn neighbours(&self, value: u32) -> impl Iterator<Item = u32> {
        let below = (self.least..value.clamp(self.least, self.most.saturating_add(1))).rev();
        let above = value.saturating_add(1).max(self.least)..=self.most;
        [{ below }.find(|&other| self.admits(other)), { above }.find(|&other| self.admits(other))].into_iter().flatten()
    }
}

/// The values of a sampler's settings, in the order of its declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Values([Option<u32>; MOST_SETTINGS]);

impl Values {
    /// The value of setting `index`, if it was written and is not the default.
    pub fn at(self, index: usize) -> Option<u32> {
        self.0.get(index).copied().flatten()
    }

    /// Whether nothing was written but defaults.
    pub fn is_plain(self) -> bool {
        self == Self::default()
    }

    /// Each of `settings` that has a value, with it.
    pub fn written(self, settings: &[Setting]) -> impl Iterator<Item = (&Setting, u32)> {
        settings.iter().zip(self.0).filter_map(|(setting, value)| Some((setting, value?)))
    }

    /// Reads what stands between the brackets, e.g. `rows=4, columns=8`.
    pub(super) fn read(settings: &'static [Setting], inside: Part<'_>) -> Result<Self, (WrongSetting, Range<usize>)> {
        let mut values = Self::default();
        let mut rest = Some(inside);
        while let Some(part) = rest {
            let (item, after) = part.split_once(',').map_or((part, None), |(item, after)| (item, Some(after)));
            rest = after;
            let (name, value) = item.split_once('=').ok_or((WrongSetting::Form, item.range()))?;
            let index = settings.iter().position(|setting| setting.name == name.text);
            let (Some(index), Some(setting)) = (index, index.and_then(|index| settings.get(index))) else {
                return Err((WrongSetting::unknown(name.text, settings), name.range()));
            };
            let number = value.text.parse().ok().filter(|&number| setting.admits(number));
            let number = number
                .ok_or_else(|| (WrongSetting::Value { setting, written: value.text.to_owned() }, value.range()))?;
            if values.0[index].replace(number).is_some() {
                return Err((WrongSetting::Twice(setting.name), name.range()));
            }
        }
        for (value, setting) in values.0.iter_mut().zip(settings) {
            *value = value.filter(|&value| setting.default != Preset::Number(value));
        }
        Ok(values)
    }
}

/// Why settings cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum WrongSetting {
    /// They are not of the form `name=number, ...`, or a bracket is missing.
    Form,
    /// The sampler has no such setting.
    Unknown {
        /// The name as written.
        written: String,
        /// The setting most likely meant.
        nearest: Option<&'static str>,
        /// All that there are.
        settings: &'static [Setting],
    },
    /// A setting comes twice.
    Twice(&'static str),
    /// A setting cannot have this value.
    Value {
        /// The setting.
        setting: &'static Setting,
        /// The value as written.
        written: String,
    },
}

impl WrongSetting {
    fn unknown(written: &str, settings: &'static [Setting]) -> Self {
        let nearest = nearest(written, settings.iter().map(|setting| setting.name));
        Self::Unknown { written: written.to_owned(), nearest, settings }
    }
}

impl Display for WrongSetting {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Form => f.write_str("settings are written as in `faure(base=5)`, with commas between them"),
            Self::Unknown { written, settings: [], .. } => write!(f, "it has no setting `{written}`, nor any other"),
            Self::Unknown { written, settings, .. } => {
                let names: Vec<String> = settings.iter().map(|setting| format!("`{}`", setting.name)).collect();
                write!(f, "it has no setting `{written}`, only {}", names.join(" and "))
            }
            Self::Twice(name) => write!(f, "`{name}` is set twice"),
            Self::Value { setting, written } => {
                write!(f, "`{}` cannot be `{written}`: it must be {}", setting.name, setting.limits())?;
                let Ok(value) = written.parse() else { return Ok(()) };
                let near: Vec<String> = setting.neighbours(value).map(|near| near.to_string()).collect();
                write!(f, "; the nearest {} {}", if near.len() == 1 { "is" } else { "are" }, near.join(" and "))
            }
        }
    }
}

impl std::error::Error for WrongSetting {}

/// A part of a longer text, with its place there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part<'t> {
    /// The part itself.
    pub(super) text: &'t str,
    start: usize,
}

impl<'t> Part<'t> {
    /// The whole of `text`, without the blanks at its ends.
    pub(super) fn new(text: &'t str) -> Self {
        Self { text, start: 0 }.trim()
    }

    /// The bytes of the longer text.
    pub(super) fn range(self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// What stands before and behind the first `mark`, without blanks.
    pub(super) fn split_once(self, mark: char) -> Option<(Self, Self)> {
        let (before, behind) = self.text.split_once(mark)?;
        let start = self.start + before.len() + mark.len_utf8();
        Some((Self { text: before, ..self }.trim(), Self { text: behind, start }.trim()))
    }

    /// The part without `mark` at its end and the blanks before that.
    pub(super) fn strip_end(self, mark: char) -> Option<Self> {
        Some(Self { text: self.text.strip_suffix(mark)?, ..self }.trim())
    }

    fn trim(self) -> Self {
        let start = self.start + self.text.len() - self.text.trim_start().len();
        Self { text: self.text.trim(), start }
    }
}
