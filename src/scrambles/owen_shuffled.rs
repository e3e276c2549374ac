//! Burley's shuffled scrambled sequence: the order of the points is scrambled as well as their
//! digits.
//!
//! **What.** Before a point is formed, its index goes through a nested scrambling of its own:
//! aligned blocks of 2^m indices become aligned blocks of 2^m, in shuffled order. Two such
//! sequences with different seeds can then be padded side by side without a pattern between them.
//!
//! **Formula.** Point i is the hash-scrambled point number nested(i).
//!
//! **Guarantees.** As [`owen_hash`](super::owen_hash): unbiased, every aligned block of 2^m points
//! a net with the same t, prefixes prefixes.
//!
//! **Cost.** One more hash for each point; the shuffled index has all 32 bits set at random, so
//! that its columns cannot be counted up one by one.
//!
//! **Limits.** Base 2, indices below 2^32, 32 digits.
//!
//! **Paper.** B. Burley, Practical Hash-based Owen Scrambling, J. Comput. Graph. Tech. 9(4) (2020),
//! <https://jcgt.org/published/0009/04/01/>.
//!
//! ```
//! use workbook::{samplers::Method, seed::Seed};
//! let points = Method::parse("sobol+owen-shuffled")?.points(4, 2, Seed::new(3))?;
//! assert_eq!(points.rows().filter(|x| x[0] < 0.5 && x[1] < 0.5).count(), 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::owen_hash::{GRAIN, scramble};
use super::{Action, Scramble};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::sobol::{first_digits, four_first_digits};
use crate::samplers::{Digits, Guarantee, Radix, Sampler};
use crate::seed::{Seed, mix};

/// The scramble `owen-shuffled`.
pub struct OwenShuffled;

static ABOUT: About = About {
    key: "owen-shuffled",
    title: "shuffled hash-based Owen scrambling",
    summary: "Hash-based Owen scrambling with the order of the points shuffled by the same kind of hash.",
    file: "scrambles/owen_shuffled.rs",
    source: include_str!("owen_shuffled.rs"),
    papers: &[
        Paper {
            authors: "B. Burley",
            year: 2020,
            title: "Practical Hash-based Owen Scrambling",
            venue: "Journal of Computer Graphics Techniques 9(4), 1-20",
            doi: None,
        },
        Paper {
            authors: "S. Laine and T. Karras",
            year: 2011,
            title: "Stratified Sampling for Stochastic Transparency",
            venue: "Computer Graphics Forum 30(4), 1197-1204",
            doi: Some("10.1111/j.1467-8659.2011.01978.x"),
        },
    ],
};

impl Entry for OwenShuffled {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for OwenShuffled {
    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str> {
        match sampler.digits() {
            Digits::Binary if sampler.guarantees().contains(&Guarantee::Prefix) => Ok(()),
            Digits::Binary => Err("it is no sequence: its points have no order to shuffle"),
            _ => Err("it works on binary digits only"),
        }
    }

    fn keeps(&self, guarantee: Guarantee) -> bool {
        !matches!(guarantee, Guarantee::Deterministic)
    }

    fn order(&self, seed: Seed) -> Option<Box<dyn Fn(u64) -> u64 + Send + Sync>> {
        let key = (seed.named("order").word() >> 32) as u32;
        Some(Box::new(move |index| u64::from(scramble(index as u32, key))))
    }

    fn action(&self, _radix: Radix, axis: usize, seed: Seed) -> Action {
        let key = (seed.at(axis as u64).word() >> 32) as u32;
        Action::Digits(Box::new(move |numerator: u64| f64::from(scramble((numerator >> 21) as u32, key)) * GRAIN))
    }
}

/// Random access without preparation: coordinate `axis < 256` of point `index` of the sequence
/// numbered `seed`, in [0, 1).
#[inline]
pub fn sample(index: u32, axis: usize, seed: u32) -> f64 {
    let shuffled = scramble(index, mix_in(seed, 0));
    f64::from(scramble(first_digits(shuffled, axis), mix_in(seed, axis as u32 + 1))) * GRAIN
}

/// The coordinates of point `index` on the axes 4 `four` to 4 `four` + 3, `four` < 64: those of
/// [`sample`], at less than half the cost, since the index is shuffled and looked up once.
#[inline]
pub fn sample_four(index: u32, four: usize, seed: u32) -> [f64; 4] {
    let mut digits = four_first_digits(scramble(index, mix_in(seed, 0)), four);
    for (axis, digits) in (4 * four as u32..).zip(&mut digits) {
        *digits = scramble(*digits, mix_in(seed, axis + 1));
    }
    digits.map(|digits| f64::from(digits) * GRAIN)
}

/// A key for `stream` of `seed`.
#[inline]
fn mix_in(seed: u32, stream: u32) -> u32 {
    (mix(u64::from(seed) << 32 | u64::from(stream)) >> 32) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_at_once_are_those_one_by_one() {
        for (index, seed) in [(0, 0), (1, 7), (12_345, 1), (u32::MAX, u32::MAX)] {
            for four in [0, 1, 17, 63] {
                let one_by_one = [0, 1, 2, 3].map(|axis| sample(index, 4 * four + axis, seed));
                assert_eq!(sample_four(index, four, seed), one_by_one, "point {index}, axes from {}", 4 * four);
            }
        }
    }
}
