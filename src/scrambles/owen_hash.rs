//! Owen scrambling in base 2 by one hash of the reversed digits.
//!
//! **What.** The 32 digits of a coordinate are reversed, so that the first is the lowest bit, and
//! hashed by steps in which a bit depends on the lower bits only: additions, odd multiplications,
//! and XORs with an even multiple. Reversed back, each digit is flipped or not by a function of
//! those before it: a nested scrambling.
//!
//! **Formula.** With n reversed: `n ^= n * 0x3d20adea`, `n += s`, `n *= (s >> 16) | 1`, `n ^= n *
//! 0x05526c56`, `n ^= n * 0x53a22864` (N. Vegdahl's constants of 2021, which mend the weak early
//! digits of those first published).
//!
//! **Guarantees.** As Owen's: unbiased up to 2^-33, nets stay nets, prefixes prefixes.
//!
//! **Cost.** Four multiplications for each coordinate, in parallel on many lanes.
//!
//! **Limits.** Base 2. Coordinates have 32 digits, and indices must be below 2^32. The trees are
//! not independent as Owen asks, only hard to tell from it; the seed of each axis is hashed first,
//! since raw consecutive seeds correlate the axes.
//!
//! **Papers.** S. Laine and T. Karras (2011), doi 10.1111/j.1467-8659.2011.01978.x; B. Burley,
//! Practical Hash-based Owen Scrambling, J. Comput. Graph. Tech. 9(4) (2020).
//!
//! ```
//! use workbook::scrambles::owen_hash::scramble;
//! let mut eighths: Vec<u32> = (0..8).map(|k: u32| scramble(k << 29, 12345) >> 29).collect();
//! eighths.sort_unstable();
//! assert_eq!(eighths, [0, 1, 2, 3, 4, 5, 6, 7]);
//! ```

use super::{Action, Scramble};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::batch::Finish;
use crate::samplers::{Digits, Guarantee, Radix, Sampler};
use crate::seed::Seed;

/// 2^-32.
pub const GRAIN: f64 = 1.0 / 4_294_967_296.0;

/// The scramble `owen-hash`.
pub struct OwenHash;

static ABOUT: About = About {
    key: "owen-hash",
    title: "hash-based Owen scrambling",
    summary: "Owen's scrambling in base 2 by a hash whose carries run from the first digit to the later ones only.",
    file: "scrambles/owen_hash.rs",
    source: include_str!("owen_hash.rs"),
    papers: &[
        Paper {
            authors: "S. Laine and T. Karras",
            year: 2011,
            title: "Stratified Sampling for Stochastic Transparency",
            venue: "Computer Graphics Forum 30(4), 1197-1204",
            doi: Some("10.1111/j.1467-8659.2011.01978.x"),
        },
        Paper {
            authors: "B. Burley",
            year: 2020,
            title: "Practical Hash-based Owen Scrambling",
            venue: "Journal of Computer Graphics Techniques 9(4), 1-20",
            doi: None,
        },
    ],
};

impl Entry for OwenHash {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for OwenHash {
    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str> {
        if sampler.digits() == Digits::Binary {
            Ok(())
        } else {
            Err("it works on binary digits only; `owen` takes any base")
        }
    }

    fn keeps(&self, guarantee: Guarantee) -> bool {
        !matches!(guarantee, Guarantee::Deterministic)
    }

    fn finish(&self, axis: usize, seed: Seed) -> Option<Finish> {
        Some(Finish::Hash(key(axis, seed)))
    }

    fn action(&self, _radix: Radix, axis: usize, seed: Seed) -> Action {
        let key = key(axis, seed);
        Action::Digits(Box::new(move |numerator: u64| {
            // The 32 first of 53 digits.
            f64::from(scramble((numerator >> 21) as u32, key)) * GRAIN
        }))
    }
}

/// The key of one axis: hashed, since raw consecutive keys correlate the axes.
fn key(axis: usize, seed: Seed) -> u32 {
    (seed.at(axis as u64).word() >> 32) as u32
}

/// The nested scrambling of 32 binary digits, the first in the highest bit.
#[inline]
pub fn scramble(digits: u32, seed: u32) -> u32 {
    carry_up(digits.reverse_bits(), seed).reverse_bits()
}

/// The hash in which every bit depends on the lower bits and the seed only
/// (Laine and Karras, with Vegdahl's constants).
#[inline]
pub fn carry_up(word: u32, seed: u32) -> u32 {
    let word = word ^ word.wrapping_mul(0x3d20_adea);
    let word = word.wrapping_add(seed);
    let word = word.wrapping_mul((seed >> 16) | 1);
    let word = word ^ word.wrapping_mul(0x0552_6c56);
    word ^ word.wrapping_mul(0x53a2_2864)
}
