//! The Hammersley set: i/n beside radical inverses.
//!
//! **What.** The first axis has the fractions i/n, the axes behind it the radical inverses in the
//! first d - 1 primes: one radical inverse fewer than Halton's.
//!
//! **Formula.** x_i = (i/n, Phi_2(i), ..., Phi_p(i)) with p the (d-1)-th prime.
//!
//! **Guarantees.** Deterministic; star discrepancy O(log^(d-1)(n) / n). In two dimensions and for
//! n = 2^m it is a (0, m, 2)-net of discrepancy (m/3 + 13/9 - (-1)^m 4/(9 2^m)) / 2^m.
//!
//! **Cost.** As Halton's.
//!
//! **Limits.** A set, not a sequence: n must be known before the first point. At most 257
//! dimensions. Scrambled, the first axis counts as one of base b where n = b^m with the smallest
//! such b, so that the shift or tree fits the net.
//!
//! **Paper.** J. M. Hammersley, Monte Carlo Methods for Solving Multivariable Problems, Ann. N. Y.
//! Acad. Sci. 86 (1960), doi 10.1111/j.1749-6632.1960.tb42846.x.
//!
//! ```
//! use workbook::{samplers::{Sampler, hammersley::Hammersley}, seed::Seed};
//! let points = Hammersley.points(4, 2, Seed::new(1))?;
//! assert_eq!(points.coordinates(), [0.0, 0.0, 0.25, 0.5, 0.5, 0.25, 0.75, 0.75]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::digits::{logarithm, root};
use super::halton::{MOST_DIMENSIONS, PRIMES};
use super::{Digital, Digits, Guarantee, Net, Radix, Refused, Sampler, batch, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::Seed;

/// The sampler `hammersley`.
pub struct Hammersley;

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

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, MOST_DIMENSIONS + 1)
    }

    fn points(&self, n: usize, d: usize, _seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        for (i, point) in coordinates.chunks_exact_mut(d).enumerate() {
            point[0] = i as f64 / n as f64;
        }
        for (axis, prime) in (1..d).zip(PRIMES) {
            batch::radical(Radix::new(prime), |_, digit| digit, 0.0, &mut coordinates[axis..], d);
        }
        refused::points(d, coordinates)
    }

    fn whole_net(&self, n: usize, d: usize) -> Option<Net> {
        (d <= 2 && logarithm(n as u64, 2).is_some()).then_some(Net { base: 2, t: 0 })
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
        radices.extend(PRIMES.iter().take(d - 1).map(|&prime| Radix::new(prime)));
        Some(Box::new(Set { n, radices }))
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
