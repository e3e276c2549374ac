//! The Hammersley set: i/n beside radical inverses.
//!
//! **What.** The first axis has the fractions i/n, the axes behind it the radical inverses in the
//! first d - 1 primes: one radical inverse fewer than Halton's.
//!
//! **Formula.** x_i = (i/n, Phi_2(i), ..., Phi_p(i)) with p the (d-1)-th prime; where a base b is
//! set, x_i = (i/n, Phi_b(i)).
//!
//! **Guarantees.** Deterministic; star discrepancy O(log^(d-1)(n) / n). In two dimensions and for
//! n = b^m it is a (0, m, 2)-net in base b, in base 2 of discrepancy (m/3 + 13/9 - (4/9)
//! (-1/2)^m) / 2^m.
//!
//! **Cost.** As Halton's.
//!
//! **Limits.** A set, not a sequence: n must be known before the first point. At most 257
//! dimensions, two where a base is set. Scrambled, the first axis counts as one of base b where n = b^m with the smallest
//! such b, so that the shift or tree fits the net.
//!
//! **Paper.** J. M. Hammersley, Monte Carlo Methods for Solving Multivariable Problems, Ann. N. Y.
//! Acad. Sci. 86 (1960), doi 10.1111/j.1749-6632.1960.tb42846.x.
//!
//! ```
//! use workbook::{samplers::{Sampler, hammersley}, seed::Seed};
//! let points = hammersley::PLAIN.points(4, 2, Seed::new(1))?;
//! assert_eq!(points.coordinates(), [0.0, 0.0, 0.25, 0.5, 0.5, 0.25, 0.75, 0.75]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::digits::{logarithm, root};
use super::halton::{MOST_DIMENSIONS, PRIMES};
use super::{
    Digital, Digits, Feature, Guarantee, Net, Preset, Radix, Refused, Sampler, Setting, Values, batch, refused,
};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `hammersley`, in the base that it is told.
pub struct Hammersley {
    base: Option<u32>,
}

/// The sampler without settings.
pub const PLAIN: Hammersley = Hammersley { base: None };

static SETTINGS: [Setting; 1] = [Setting {
    name: "base",
    meaning: "the base b of the second of two axes",
    least: 2,
    most: 2048,
    is_prime: false,
    default: Preset::Rule("the primes in their order: 2 on the second axis, 3 on the third"),
}];

static ABOUT: About = About {
    key: "hammersley",
    title: "Hammersley",
    summary: "The regular fractions i/n on the first axis, radical inverses on the others.",
    file: "samplers/hammersley.rs",
    source: include_str!("hammersley.rs"),
    papers: &[Paper {
        authors: "J. M. Hammersley",
        year: 1960,
        title: "Monte Carlo Methods for Solving Multivariable Problems",
        venue: "Annals of the New York Academy of Sciences 86(3), 844-874",
        doi: Some("10.1111/j.1749-6632.1960.tb42846.x"),
    }],
};

impl Entry for Hammersley {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for Hammersley {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Whole, Guarantee::Deterministic]
    }

    fn settings(&self) -> &'static [Setting] {
        &SETTINGS
    }

    fn with(&self, values: Values) -> Option<Box<dyn Sampler>> {
        Some(Box::new(Self { base: values.at(0) }))
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, if self.base.is_some() { 2 } else { MOST_DIMENSIONS + 1 })
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            point[0] = i as f64 / n as f64;
        }
        for (axis, base) in (1..d).zip(self.bases()) {
            batch::radical(Radix::new(base), |_, digit| digit, 0.0, &mut coordinates[axis..], d);
        }
        refused::points(d, coordinates)
    }

    fn whole_net(&self, n: usize, d: usize) -> Option<Net> {
        let base = self.base.unwrap_or(2);
        (d <= 2 && logarithm(n as u64, base).is_some()).then_some(Net { base, t: 0 })
    }

    fn digits(&self) -> Digits {
        Digits::Mixed
    }

    fn has_prime_bases(&self) -> bool {
        false
    }

    fn digital(&self, n: usize, d: usize) -> Option<Box<dyn Digital>> {
        let (n, base) = (n as u64, smallest_root(n as u64)?);
        // Other bases than 2 stop at the last digit of i / n: what follows is zeros, which a
        // scramble takes as one.
        let first = if base == 2 { Radix::new(2) } else { Radix { base, digits: logarithm(n, base)?, scale: n } };
        let mut radices = vec![first];
        radices.extend(self.bases().take(d - 1).map(Radix::new));
        Some(Box::new(Set { n, radices }))
    }
}

impl Hammersley {
    /// The bases of the axes from the second on.
    fn bases(&self) -> impl Iterator<Item = u32> {
        let primes = if self.base.is_some() { &[] } else { &PRIMES[..] };
        self.base.into_iter().chain(primes.iter().copied())
    }
}

/// The smallest b of which `n` is a power; `None` where it does not fit in 32 bits.
fn smallest_root(n: u64) -> Option<u32> {
    let exponents = (2..64).rev();
    let base =
        exponents.map(|exponent| root(n, exponent)).find(|&base| base > 1 && logarithm(n, base as u32).is_some());
    u32::try_from(base.unwrap_or(n).max(2)).ok()
}

/// The digits of a set of n points.
struct Set {
    n: u64,
    radices: Vec<Radix>,
}

impl Digital for Set {
    fn radix(&self, axis: usize) -> Radix {
        self.radices[axis]
    }

    fn numerator(&self, index: u64, axis: usize) -> u64 {
        let radix = self.radices[axis];
        // n divides the scale: both are powers of the same base.
        if axis == 0 { index * (radix.scale / self.n) } else { radix.reversed(index) }
    }

    fn is_radical(&self, axis: usize) -> bool {
        axis > 0
    }
}
