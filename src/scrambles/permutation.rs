//! Random digit permutations: one for each axis and each position.
//!
//! **What.** On each axis a random permutation is drawn for each digit position, and applied to
//! that digit of every coordinate.
//!
//! **Formula.** x = 0.d_1 d_2 ... becomes 0.e_1 e_2 ... with e_k = p_k(d_k).
//!
//! **Guarantees.** Each point is uniform, hence the mean is unbiased; nets and the boxes of the
//! Halton sequence keep their counts; prefixes stay prefixes.
//!
//! **Cost.** One division for each digit of the base.
//!
//! **Limits.** The infinitely many zeros behind the last digit are permuted as well. Permuting only
//! the digits that the index has is a known trap: with p = (1, 0, 2) in base 3 points 0, 1 and 4
//! coincide, and 6 of 9 strata are hit. In base 2 it is the XOR.
//!
//! **Papers.** B. Tuffin (1996), doi 10.1515/mcma.1998.4.3.185, and A. B. Owen, A Randomized Halton
//! Algorithm in R (2017), arXiv 1706.02808.
//!
//! ```
//! use workbook::{samplers::Method, seed::Seed};
//! let points = Method::parse("halton+permutation")?.points(9, 2, Seed::new(3))?;
//! let mut thirds: Vec<u32> = points.axis(1).map(|x| (x * 9.0) as u32).collect();
//! thirds.sort_unstable();
//! assert_eq!(thirds, [0, 1, 2, 3, 4, 5, 6, 7, 8]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::walk::{Places, images, unit};
use super::{Action, Scramble};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::{Digits, Guarantee, Radix, Sampler};
use crate::seed::Seed;

/// The scramble `permutation`.
pub struct Permutation;

static ABOUT: About = About {
    key: "permutation",
    title: "digit permutations",
    summary: "A random permutation of the digits for each axis and each position, trailing zeros included.",
    file: "scrambles/permutation.rs",
    source: include_str!("permutation.rs"),
    papers: &[
        Paper {
            authors: "A. B. Owen",
            year: 2017,
            title: "A Randomized Halton Algorithm in R",
            venue: "arXiv 1706.02808",
            doi: Some("10.48550/arXiv.1706.02808"),
        },
        Paper {
            authors: "B. Tuffin",
            year: 1998,
            title: "A New Permutation Choice in Halton Sequences",
            venue: "Monte Carlo and Quasi-Monte Carlo Methods 1996, LNS 127, 427-435",
            doi: Some("10.1007/978-1-4612-1690-2_30"),
        },
    ],
};

impl Entry for Permutation {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for Permutation {
    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str> {
        if sampler.digits() == Digits::None { Err("its coordinates have no digits to scramble") } else { Ok(()) }
    }

    fn keeps(&self, guarantee: Guarantee) -> bool {
        !matches!(guarantee, Guarantee::Deterministic)
    }

    fn action(&self, radix: Radix, axis: usize, seed: Seed) -> Action {
        let seed = seed.at(axis as u64);
        let places = Places::new(radix);
        let keys: Vec<u64> = (0..u64::from(radix.digits)).map(|position| seed.at(position).word()).collect();
        // All zeros from here on have random images, which together are one uniform number, the
        // same for all points.
        let tail = if radix.base == 2 { 0.0 } else { unit(seed.named("tail").word()) };
        let images = keys.iter().map(|&key| images(u64::from(radix.base), key)).collect();
        Action::Positions { places, images, tail }
    }
}
