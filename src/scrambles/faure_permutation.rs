//! Faure's permutations: fixed digit permutations of low discrepancy.
//!
//! **What.** Each base b has one permutation, built by recursion, that is applied to every digit:
//! of all b! it makes the one-dimensional sequence especially even.
//!
//! **Formula.** p_2 = (0, 1). For even b, p_b = (2 p_(b/2), 2 p_(b/2) + 1). For odd b = 2 c + 1,
//! take p_(b-1), raise by 1 its values from c on, and put c in the middle.
//!
//! **Guarantees.** Deterministic; since p(0) = 0, trailing zeros stay zeros. Boxes and nets keep
//! their counts.
//!
//! **Cost.** One division for each digit of the base.
//!
//! **Limits.** In base 2 it is the identity. No error estimate, since nothing is random.
//!
//! **Paper.** H. Faure, Good Permutations for Extreme Discrepancy, J. Number Theory 42(1) (1992),
//! doi 10.1016/0022-314X(92)90107-Z.
//!
//! ```
//! use workbook::scrambles::faure_permutation::permutation;
//! assert_eq!(permutation(5), [0, 3, 2, 1, 4]);
//! assert_eq!(permutation(8), [0, 4, 2, 6, 1, 5, 3, 7]);
//! ```

use super::{Action, Scramble, fixed};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::{Guarantee, Radix, Sampler};
use crate::seed::Seed;

/// The scramble `faure-permutation`.
pub struct FaurePermutation;

static ABOUT: About = About {
    key: "faure-permutation",
    title: "Faure's permutations",
    summary: "Faure's fixed permutation of the digits in each base.",
    file: "scrambles/faure_permutation.rs",
    source: include_str!("faure_permutation.rs"),
    papers: &[Paper {
        authors: "H. Faure",
        year: 1992,
        title: "Good Permutations for Extreme Discrepancy",
        venue: "Journal of Number Theory 42(1), 47-56",
        doi: Some("10.1016/0022-314X(92)90107-Z"),
    }],
};

impl Entry for FaurePermutation {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for FaurePermutation {
    fn is_random(&self) -> bool {
        false
    }

    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str> {
        fixed::combines(sampler)
    }

    fn keeps(&self, _guarantee: Guarantee) -> bool {
        true
    }

    fn action(&self, radix: Radix, _axis: usize, _seed: Seed) -> Action {
        fixed::action(radix, permutation)
    }
}

/// Faure's permutation of `0..base`.
pub fn permutation(base: u32) -> Vec<u32> {
    match base {
        0 | 1 => vec![0; base as usize],
        2 => vec![0, 1],
        _ if base.is_multiple_of(2) => {
            let half = permutation(base / 2);
            let even = half.iter().map(|&value| 2 * value);
            let odd = half.iter().map(|&value| 2 * value + 1);
            even.chain(odd).collect()
        }
        _ => {
            let middle = base / 2;
            let mut images = permutation(base - 1);
            for image in &mut images {
                *image += u32::from(*image >= middle);
            }
            images.insert(middle as usize, middle);
            images
        }
    }
}
