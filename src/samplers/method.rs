//! A sampler with or without a scramble, by name.

use super::{Guarantee, Net, Refused, SAMPLERS, Sampler};
use crate::catalogue::{About, Entry, find, nearest};
use crate::points::Points;
use crate::scrambles::{self, SCRAMBLES, Scramble};
use crate::seed::Seed;
use std::fmt::{self, Debug, Display, Formatter};

/// A sampler with an optional scramble, such as `halton` or `sobol+xor`.
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
    sampler: &'static dyn Sampler,
    scramble: Option<&'static dyn Scramble>,
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
}

impl UnknownMethod {
    /// The right name to offer in place of the unknown part, if one is near.
    pub fn suggestion(&self) -> Option<&'static str> {
        match self {
            Self::Sampler { nearest, .. } | Self::Scramble { nearest, .. } => *nearest,
            Self::Combination { .. } => None,
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
        }
    }
}

impl std::error::Error for UnknownMethod {}

fn unknown(f: &mut Formatter<'_>, what: &str, written: &str, nearest: Option<&str>) -> fmt::Result {
    write!(f, "there is no {what} `{written}`")?;
    nearest.map_or(Ok(()), |name| write!(f, "; did you mean `{name}`?"))
}

impl Method {
    /// The method called `name`: a sampler's key, or a sampler's and a scramble's joined by `+`.
    pub fn parse(name: &str) -> Result<Self, UnknownMethod> {
        let (first, second) = match name.split_once('+') {
            Some((first, second)) => (first.trim(), Some(second.trim())),
            None => (name.trim(), None),
        };
        let sampler = find(SAMPLERS, first).ok_or_else(|| UnknownMethod::Sampler {
            written: first.to_owned(),
            nearest: nearest(first, SAMPLERS.iter().map(|sampler| sampler.about().key)),
        })?;
        let Some(second) = second else { return Ok(Self { sampler, scramble: None }) };
        let scramble = find(SCRAMBLES, second).ok_or_else(|| UnknownMethod::Scramble {
            written: second.to_owned(),
            nearest: nearest(second, SCRAMBLES.iter().map(|scramble| scramble.about().key)),
        })?;
        scramble.combines(sampler).map_err(|reason| UnknownMethod::Combination {
            sampler: sampler.about().key,
            scramble: scramble.about().key,
            reason,
        })?;
        Ok(Self { sampler, scramble: Some(scramble) })
    }

    /// Every method: each sampler alone, then with each scramble that it combines with.
    pub fn all() -> impl Iterator<Item = Self> {
        SAMPLERS.iter().flat_map(|&sampler| {
            let scrambles = SCRAMBLES.iter().filter(move |scramble| scramble.combines(sampler).is_ok());
            std::iter::once(None)
                .chain(scrambles.map(|&scramble| Some(scramble)))
                .map(move |scramble| Self { sampler, scramble })
        })
    }

    /// The name that [`parse`](Self::parse) reads: `sobol+xor`.
    pub fn name(&self) -> String {
        self.scramble.map_or_else(
            || self.sampler.about().key.to_owned(),
            |scramble| format!("{}+{}", self.sampler.about().key, scramble.about().key),
        )
    }

    /// The name as prose uses it: `Sobol' with XOR`.
    pub fn title(&self) -> String {
        self.scramble.map_or_else(
            || self.sampler.about().title.to_owned(),
            |scramble| format!("{} with {}", self.sampler.about().title, scramble.about().title),
        )
    }

    /// The sampler.
    pub fn sampler(&self) -> &'static dyn Sampler {
        self.sampler
    }

    /// The scramble, if there is one.
    pub fn scramble(&self) -> Option<&'static dyn Scramble> {
        self.scramble
    }

    /// What the parts tell about themselves: the sampler first.
    pub fn abouts(&self) -> Vec<&'static About> {
        std::iter::once(self.sampler.about()).chain(self.scramble.map(Entry::about)).collect()
    }

    /// Whether it can give exactly `n` points of `d` dimensions.
    pub fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        self.sampler.admits(n, d)
    }

    /// The `n x d` points for `seed`: the same arguments give the same bits, everywhere.
    pub fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        match self.scramble {
            None => self.sampler.points(n, d, seed.named(self.sampler.about().key)),
            Some(scramble) => scrambles::points(self.sampler, scramble, n, d, seed),
        }
    }

    /// Whether the seed matters.
    pub fn is_random(&self) -> bool {
        !self.guarantees().contains(&Guarantee::Deterministic)
    }

    /// What sampler and scramble promise together.
    pub fn guarantees(&self) -> Vec<Guarantee> {
        let Some(scramble) = self.scramble else { return self.sampler.guarantees().to_vec() };
        let kept = self.sampler.guarantees().iter().copied().filter(|&guarantee| match guarantee {
            Guarantee::Deterministic | Guarantee::Unbiased => !scramble.is_random(),
            other => scramble.keeps(other),
        });
        kept.chain(scramble.is_random().then_some(Guarantee::Unbiased)).collect()
    }

    /// The net that [`Guarantee::Whole`] promises of all `n` points in `d` dimensions, if it is
    /// promised.
    pub fn whole_net(&self, n: usize, d: usize) -> Option<Net> {
        self.guarantees().contains(&Guarantee::Whole).then(|| self.sampler.whole_net(n, d)).flatten()
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
            None => self.sampler.at(n, d, seed.named(self.sampler.about().key)),
            Some(scramble) => scrambles::sample(self.sampler, scramble, n, d, seed),
        }
    }

    /// The net that [`Guarantee::Net`] promises in `d` dimensions, if it is promised.
    pub fn net(&self, d: usize) -> Option<Net> {
        self.guarantees().contains(&Guarantee::Net).then(|| self.sampler.net(d)).flatten()
    }
}

impl PartialEq for Method {
    fn eq(&self, other: &Self) -> bool {
        let key = |method: &Self| (method.sampler.about().key, method.scramble.map(|scramble| scramble.about().key));
        key(self) == key(other)
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
