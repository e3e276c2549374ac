//! Owen's nested uniform scrambling, in any base.
//!
//! **What.** The unit interval is cut into b parts, which are put in random order; each part is cut
//! into b, which are put in an order of their own; and so on for ever. Each axis has its own tree
//! of permutations.
//!
//! **Formula.** e_k = p(d_k), where the random permutation p belongs to the node (d_1, ...,
//! d_(k-1)) of the axis' tree.
//!
//! **Guarantees.** Each point is uniform, hence the mean is unbiased; nets stay nets with the same
//! t, prefixes prefixes. On smooth functions the standard deviation falls like n^(-3/2)
//! log^((d-1)/2) n at n = b^m; it is never above a constant times that of independent points.
//!
//! **Cost.** One hash for each of 32 digits in base 2; in base b a shuffle of b for each digit.
//!
//! **Limits.** The tree's nodes are hashed, not stored: nothing is allocated, and a point is a pure
//! function of its index. Digits are permuted one by one up to a total of 2^32 nodes a level, and
//! the rest is one uniform number of its own for each point; points with an index below 2^32 cannot
//! tell the difference in law. The rate holds at n = b^m only.
//!
//! **Papers.** A. B. Owen, Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences (1995), doi
//! 10.1007/978-1-4612-2552-2_19; the variance: Ann. Statist. 25(4) (1997), doi
//! 10.1214/aos/1031594731.
//!
//! ```
//! use workbook::{samplers::Method, seed::Seed};
//! let points = Method::parse("sobol+owen")?.points(4, 2, Seed::new(3))?;
//! let corners = points.rows().filter(|x| x[0] < 0.5 && x[1] < 0.5).count();
//! assert_eq!(corners, 1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::walk::{Places, image, unit};
use super::{Action, Scramble};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::{Digits, Guarantee, Radix, Sampler};
use crate::seed::{Seed, mix};

/// Levels of the binary tree that are permuted one by one.
const FLIPS: u64 = 32;

/// The scramble `owen`.
pub struct Owen;

static ABOUT: About = About {
    key: "owen",
    title: "Owen scrambling",
    summary: "Owen's nested uniform scrambling: the permutation of each digit depends on all digits before it.",
    file: "scrambles/owen.rs",
    source: include_str!("owen.rs"),
    papers: &[
        Paper {
            authors: "A. B. Owen",
            year: 1995,
            title: "Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences",
            venue: "Monte Carlo and Quasi-Monte Carlo Methods in Scientific Computing, LNS 106, 299-317",
            doi: Some("10.1007/978-1-4612-2552-2_19"),
        },
        Paper {
            authors: "A. B. Owen",
            year: 1997,
            title: "Scrambled Net Variance for Integrals of Smooth Functions",
            venue: "The Annals of Statistics 25(4), 1541-1562",
            doi: Some("10.1214/aos/1031594731"),
        },
    ],
};

impl Entry for Owen {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for Owen {
    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str> {
        if sampler.digits() == Digits::None { Err("its coordinates have no digits to scramble") } else { Ok(()) }
    }

    fn keeps(&self, guarantee: Guarantee) -> bool {
        !matches!(guarantee, Guarantee::Deterministic)
    }

    fn action(&self, radix: Radix, axis: usize, seed: Seed) -> Action {
        let key = seed.at(axis as u64).word();
        if radix.base == 2 {
            return Action::Digits(Box::new(move |numerator| radix.coordinate(nested_flips(numerator, key))));
        }
        let places = Places::new(radix);
        Action::Digits(Box::new(move |numerator| nested_permutations(numerator, &places, key)))
    }
}

/// Base 2: the digits of `numerator < 2^53`, each flipped or not as the node of the digits before
/// it says.
pub fn nested_flips(numerator: u64, key: u64) -> u64 {
    let mut flips = 0;
    for position in 0..FLIPS {
        // The node: its depth, and the path to it, which is the numerator without the digits from
        // here on.
        let path = numerator >> (53 - position);
        flips |= (node(key, position, path) >> 63) << (52 - position);
    }
    numerator ^ flips ^ node(key, 64, numerator) >> (11 + FLIPS)
}

/// The coordinate of `numerator` after the nested permutations of base b.
pub fn nested_permutations(numerator: u64, places: &Places, key: u64) -> f64 {
    let base = u64::from(places.radix.base);
    let (mut scrambled, mut nodes) = (0, 1_u64);
    for (position, digit, place) in places.digits(numerator) {
        let path = numerator / place / base;
        let permuted = if nodes < 1 << FLIPS {
            image(digit, base, node(key, u64::from(position as u32), path))
        } else {
            // Every point is alone in its node by now: a random digit is as good as a permuted one.
            ((u128::from(node(key, 64 + position as u64, numerator)) * u128::from(base)) >> 64) as u64
        };
        scrambled += permuted * place;
        nodes = nodes.saturating_mul(base);
    }
    places.radix.coordinate_with(scrambled, unit(node(key, 63, numerator)))
}

/// The random word of the node at `depth` with the digits `path` before it.
#[inline]
fn node(key: u64, depth: u64, path: u64) -> u64 {
    mix(mix(path ^ key).wrapping_add(key.rotate_left(depth as u32)) ^ depth)
}
