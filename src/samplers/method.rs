//! A sampler with or without a scramble, by name.

use super::settings::{Part, Values, WrongSetting};
use super::{Guarantee, Net, Refused, SAMPLERS, Sampler};
use crate::catalogue::{About, Entry, find, nearest};
use crate::points::Points;
use crate::scrambles::{self, SCRAMBLES, Scramble};
use crate::seed::Seed;
use std::fmt::{self, Debug, Display, Formatter};
use std::ops::{Deref, Range};

/// A sampler, perhaps with settings, and an optional scramble: `halton`, `sobol+xor`,
/// `faure(base=5)+owen`.
///
/// ```
/// use workbook::{samplers::Method, seed::Seed};
/// let method = Method::parse("sobol+xor")?;
/// let points = method.points(16, 2, Seed::new(1))?;
/// assert_eq!((points.len(), points.dimensions()), (16, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Method {
    entry: &'static dyn Sampler,
    values: Values,
    scramble: Option<&'static dyn Scramble>,
}

/// A sampler as a method has it: the catalogue's own, or one that has been told its settings.
pub enum Chosen {
    /// The catalogue's.
    Plain(&'static dyn Sampler),
    /// One with settings.
    Told(Box<dyn Sampler>),
}

impl Deref for Chosen {
    type Target = dyn Sampler;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Plain(sampler) => *sampler,
            Self::Told(sampler) => sampler.as_ref(),
        }
    }
}

/// Why a name is not the name of a method.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum UnknownMethod {
    /// No sampler has this name.
    Sampler {
        /// The name as written.
        written: String,
        /// The sampler most likely meant.
        nearest: Option<&'static str>,
    },
    /// No scramble has this name.
    Scramble {
        /// The name as written.
        written: String,
        /// The scramble most likely meant.
        nearest: Option<&'static str>,
    },
    /// Both are known, but cannot be combined.
    Combination {
        /// The sampler's name.
        sampler: &'static str,
        /// The scramble's name.
        scramble: &'static str,
        /// Why not.
        reason: &'static str,
    },
    /// The sampler is known, but not what is set in it.
    Setting {
        /// The sampler's name.
        sampler: &'static str,
        /// What is wrong.
        error: WrongSetting,
        /// The bytes of the name where it is wrong.
        range: Range<usize>,
    },
}

impl UnknownMethod {
    /// The right name to offer in place of the unknown part, if one is near.
    pub fn suggestion(&self) -> Option<&'static str> {
        match self {
            Self::Sampler { nearest, .. }
            | Self::Scramble { nearest, .. }
            | Self::Setting { error: WrongSetting::Unknown { nearest, .. }, .. } => *nearest,
            Self::Setting { .. } | Self::Combination { .. } => None,
        }
    }
}

impl Display for UnknownMethod {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sampler { written, nearest } => unknown(f, "sampler", written, *nearest),
            Self::Scramble { written, nearest } => unknown(f, "scramble", written, *nearest),
            Self::Combination { sampler, scramble, reason } => {
                write!(f, "`{sampler}` cannot be combined with `{scramble}`: {reason}")
            }
            Self::Setting { sampler, error, .. } => write!(f, "`{sampler}`: {error}"),
        }
    }
}

impl std::error::Error for UnknownMethod {}

fn unknown(f: &mut Formatter<'_>, what: &str, written: &str, nearest: Option<&str>) -> fmt::Result {
    write!(f, "there is no {what} `{written}`")?;
    nearest.map_or(Ok(()), |name| write!(f, "; did you mean `{name}`?"))
}

impl Method {
    /// The method called `name`: a sampler's key, perhaps with settings in brackets, or that and a
    /// scramble's key joined by `+`.
    pub fn parse(name: &str) -> Result<Self, UnknownMethod> {
        let whole = Part::new(name);
        let (first, second) = match whole.split_once('+') {
            Some((first, second)) => (first, Some(second.text)),
            None => (whole, None),
        };
        let (key, brackets) = first.split_once('(').map_or((first, None), |(key, rest)| (key, Some(rest)));
        let entry = find(SAMPLERS, key.text).ok_or_else(|| UnknownMethod::Sampler {
            written: key.text.to_owned(),
            nearest: nearest(key.text, SAMPLERS.iter().map(|sampler| sampler.about().key)),
        })?;
        let read = |brackets: Part<'_>| {
            let inside = brackets.strip_end(')').ok_or((WrongSetting::Form, first.range()))?;
            Values::read(entry.settings(), inside)
        };
        let values = brackets.map_or(Ok(Values::default()), read);
        let wrong = |(error, range)| UnknownMethod::Setting { sampler: entry.about().key, error, range };
        let method = Self { entry, values: values.map_err(wrong)?, scramble: None };
        second.map_or(Ok(method), |second| method.scrambled(second))
    }

    /// The same sampler with the scramble called `name`.
    fn scrambled(self, name: &str) -> Result<Self, UnknownMethod> {
        let scramble = find(SCRAMBLES, name).ok_or_else(|| UnknownMethod::Scramble {
            written: name.to_owned(),
            nearest: nearest(name, SCRAMBLES.iter().map(|scramble| scramble.about().key)),
        })?;
        scramble.combines(&*self.sampler()).map_err(|reason| UnknownMethod::Combination {
            sampler: self.entry.about().key,
            scramble: scramble.about().key,
            reason,
        })?;
        Ok(Self { scramble: Some(scramble), ..self })
    }

    /// Every method without settings: each sampler alone, then with each scramble that it combines
    /// with.
    pub fn all() -> impl Iterator<Item = Self> {
        SAMPLERS.iter().flat_map(|&entry| Self { entry, values: Values::default(), scramble: None }.family())
    }

    /// This sampler, with its settings, alone and with each scramble that it combines with.
    pub fn family(self) -> impl Iterator<Item = Self> {
        let scrambles = SCRAMBLES.iter().filter(move |scramble| scramble.combines(&*self.sampler()).is_ok());
        std::iter::once(None)
            .chain(scrambles.map(|&scramble| Some(scramble)))
            .map(move |scramble| Self { scramble, ..self })
    }

    /// The name that [`parse`](Self::parse) reads, in its one canonical form: `sobol+xor`,
    /// `faure(base=5)`. Settings stand in the order of their declaration, defaults are left out.
    pub fn name(&self) -> String {
        let sampler = self.sampler_name();
        self.scramble.map_or_else(|| sampler.clone(), |scramble| format!("{sampler}+{}", scramble.about().key))
    }

    /// The name of the sampler with its settings, which is also the name of its random stream.
    fn sampler_name(&self) -> String {
        let key = self.entry.about().key;
        if self.values.is_plain() { key.to_owned() } else { format!("{key}({})", self.told('=', ",")) }
    }

    /// The settings that are not the defaults.
    fn told(&self, equals: char, comma: &str) -> String {
        let settings = self.values.written(self.entry.settings());
        settings.map(|(setting, value)| format!("{}{equals}{value}", setting.name)).collect::<Vec<_>>().join(comma)
    }

    /// The name as prose uses it: `Sobol' with XOR`, `Faure (base 5)`.
    pub fn title(&self) -> String {
        let title = self.entry.about().title;
        let sampler =
            if self.values.is_plain() { title.to_owned() } else { format!("{title} ({})", self.told(' ', ", ")) };
        self.scramble.map_or_else(|| sampler.clone(), |scramble| format!("{sampler} with {}", scramble.about().title))
    }

    /// The sampler.
    pub fn sampler(&self) -> Chosen {
        let told = if self.values.is_plain() { None } else { self.entry.with(self.values) };
        told.map_or(Chosen::Plain(self.entry), Chosen::Told)
    }

    /// The scramble, if there is one.
    pub fn scramble(&self) -> Option<&'static dyn Scramble> {
        self.scramble
    }

    /// What the parts tell about themselves: the sampler first.
    pub fn abouts(&self) -> Vec<&'static About> {
        std::iter::once(self.entry.about()).chain(self.scramble.map(Entry::about)).collect()
    }

    /// Whether it can give exactly `n` points of `d` dimensions.
    pub fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        self.sampler().admits(n, d)
    }

    /// The `n x d` points for `seed`: the same arguments give the same bits, everywhere.
    pub fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        match self.scramble {
            None => self.sampler().points(n, d, seed.named(&self.sampler_name())),
            Some(scramble) => scrambles::points((&*self.sampler(), &self.sampler_name()), scramble, n, d, seed),
        }
    }

    /// Whether the seed matters.
    pub fn is_random(&self) -> bool {
        !self.guarantees().contains(&Guarantee::Deterministic)
    }

    /// What sampler and scramble promise together.
    pub fn guarantees(&self) -> Vec<Guarantee> {
        let own = self.sampler().guarantees();
        let Some(scramble) = self.scramble else { return own.to_vec() };
        let kept = own.iter().copied().filter(|&guarantee| match guarantee {
            Guarantee::Deterministic | Guarantee::Unbiased => !scramble.is_random(),
            other => scramble.keeps(other),
        });
        kept.chain(scramble.is_random().then_some(Guarantee::Unbiased)).collect()
    }

    /// The net that [`Guarantee::Whole`] promises of all `n` points in `d` dimensions, if it is
    /// promised.
    pub fn whole_net(&self, n: usize, d: usize) -> Option<Net> {
        self.guarantees().contains(&Guarantee::Whole).then(|| self.sampler().whole_net(n, d)).flatten()
    }

    /// Random access: coordinate `axis < d` of point `index`, the same bits as in
    /// [`points`](Self::points); `None` where n or d are not admitted, or where the points depend
    /// on each other. Sequences, which promise [`Guarantee::Prefix`], heed no n, and give every
    /// index; sets give those below n.
    ///
    /// ```
    /// use workbook::{samplers::Method, seed::Seed};
    /// let method = Method::parse("halton+owen")?;
    /// let sample = method.sample(100, 3, Seed::new(1)).ok_or("a sequence")?;
    /// assert_eq!(sample(42, 2), method.points(100, 3, Seed::new(1))?.coordinates()[42 * 3 + 2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sample(&self, n: usize, d: usize, seed: Seed) -> Option<Box<dyn Fn(u64, usize) -> f64 + Send + Sync>> {
        self.admits(n, d).ok()?;
        match self.scramble {
            None => self.sampler().at(n, d, seed.named(&self.sampler_name())),
            Some(scramble) => scrambles::sample((&*self.sampler(), &self.sampler_name()), scramble, n, d, seed),
        }
    }

    /// The net that [`Guarantee::Net`] promises in `d` dimensions, if it is promised.
    pub fn net(&self, d: usize) -> Option<Net> {
        self.guarantees().contains(&Guarantee::Net).then(|| self.sampler().net(d)).flatten()
    }
}

impl PartialEq for Method {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

impl Eq for Method {}

impl Debug for Method {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Method").field(&self.name()).finish()
    }
}

impl Display for Method {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name())
    }
}
