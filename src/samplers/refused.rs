//! Why a sampler cannot give what was asked of it, and the checks that all samplers share.

use super::digits::{self, root};
use crate::points::Points;
use std::fmt::{Display, Formatter};

/// The most coordinates, n x d, of one point set: 2^30, which take 8 GiB.
pub const MOST_COORDINATES: usize = 1 << 30;

/// Why a sampler cannot give what was asked of it.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Refused {
    /// It cannot give this n; the nearest that it can, below and above.
    Count {
        /// What was asked for.
        n: usize,
        /// The nearest count below that it can give, if any.
        below: Option<usize>,
        /// The nearest count above that it can give, if any.
        above: Option<usize>,
        /// What the count must be, e.g. `a square`.
        rule: &'static str,
    },
    /// It cannot give this d.
    Dimensions {
        /// What was asked for.
        d: usize,
        /// The fewest that it can give.
        least: usize,
        /// The most that it can give.
        most: usize,
    },
    /// n x d is over the limit, or over what memory allows at the moment.
    Memory {
        /// The count asked for.
        n: usize,
        /// The dimensions asked for.
        d: usize,
        /// The most coordinates that may be asked for.
        most: usize,
    },
}

impl Display for Refused {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match *self {
            Self::Count { n, below, above, rule } => {
                write!(f, "n = {n} is not possible: it must be {rule}")?;
                match (below, above) {
                    (Some(below), Some(above)) => write!(f, "; the nearest are {below} and {above}"),
                    (Some(nearest), None) | (None, Some(nearest)) => write!(f, "; the nearest is {nearest}"),
                    (None, None) => Ok(()),
                }
            }
            Self::Dimensions { d, least, most } if least == most => {
                write!(
                    f,
                    "d = {d} is not possible: this method has {most} dimension{}",
                    if most == 1 { "" } else { "s" }
                )
            }
            Self::Dimensions { d, least, most: usize::MAX } => {
                write!(f, "d = {d} is not possible: d must be at least {least}")
            }
            Self::Dimensions { d, least, most } => {
                write!(f, "d = {d} is not possible: d must be from {least} to {most}")
            }
            Self::Memory { n, d, most } => {
                write!(f, "n = {n} points of d = {d} dimensions do not fit in memory: n x d must be at most {most}")
            }
        }
    }
}

impl std::error::Error for Refused {}

/// Checks what holds for every sampler: n and d at least 1, d at most `most`, n x d at most
/// [`MOST_COORDINATES`].
pub(super) fn check(n: usize, d: usize, most: usize) -> Result<(), Refused> {
    if d == 0 || d > most {
        return Err(Refused::Dimensions { d, least: 1, most });
    }
    if n == 0 {
        return Err(Refused::Count { n, below: None, above: Some(1), rule: "at least 1" });
    }
    if n.checked_mul(d).is_none_or(|size| size > MOST_COORDINATES) {
        return Err(Refused::Memory { n, d, most: MOST_COORDINATES });
    }
    Ok(())
}

/// As [`check`], and n must be k^d for a whole number k.
pub(super) fn power(n: usize, d: usize) -> Result<(), Refused> {
    check(n, d, usize::MAX)?;
    let dimensions = d as u32;
    let k = root(n as u64, dimensions);
    let power = |k: u64| k.checked_pow(dimensions).map(|power| power as usize);
    if power(k) == Some(n) {
        return Ok(());
    }
    Err(Refused::Count { n, below: power(k).filter(|&n| n > 0), above: power(k + 1), rule: "k^d for a whole number k" })
}

/// As [`check`], and n must be p^`exponent` for a prime p of at least `least`; `rule` says so.
pub(super) fn prime_power(n: usize, exponent: u32, least: usize, rule: &'static str) -> Result<(), Refused> {
    let fits = |p: usize| p >= least && digits::is_prime(p as u64);
    let p = root(n as u64, exponent) as usize;
    let power = |p: usize| p.checked_pow(exponent);
    if power(p) == Some(n) && fits(p) {
        return Ok(());
    }
    let below = (2..=p).rev().find(|&p| fits(p)).and_then(power);
    let above = (p.max(least.saturating_sub(1)) + 1..).take(1 << 12).find(|&p| fits(p)).and_then(power);
    Err(Refused::Count { n, below, above, rule })
}

/// Room for `n x d` coordinates, all zero, once `n` and `d` have been checked; refused rather than
/// aborted where memory is short.
pub(crate) fn allocate(n: usize, d: usize) -> Result<Vec<f64>, Refused> {
    let refused = Refused::Memory { n, d, most: MOST_COORDINATES };
    let size = n.checked_mul(d).filter(|&size| size <= MOST_COORDINATES).ok_or(refused.clone())?;
    let mut coordinates = Vec::new();
    coordinates.try_reserve_exact(size).map_err(|_| refused)?;
    coordinates.resize(size, 0.0);
    Ok(coordinates)
}

/// Rows of `d` checked coordinates as points.
pub(crate) fn points(d: usize, coordinates: Vec<f64>) -> Result<Points, Refused> {
    Points::from_rows(d, coordinates).ok_or(Refused::Dimensions { d, least: 1, most: usize::MAX })
}
