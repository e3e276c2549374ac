//! Braaten and Weller's permutations: fixed digit permutations, chosen one digit at a time.
//!
//! **What.** Each base b has one permutation with p(0) = 0; every further image is the digit that
//! makes the images so far, taken as points k/b, most even.
//!
//! **Formula.** p(j) is the r not yet used that minimises the L2 star discrepancy of p(1)/b, ...,
//! p(j-1)/b, r/b. Equal choices: the smaller at first (the larger in base 3, where it would be the
//! identity), the larger later. That gives the published table in bases 3, 5, 7, 11, 13 and 17.
//!
//! **Guarantees.** Deterministic; since p(0) = 0, trailing zeros stay zeros. Boxes and nets keep
//! their counts.
//!
//! **Cost.** b^2 steps to build a permutation, one division for each digit to use it.
//!
//! **Limits.** In base 2 it is the identity. No error estimate, since nothing is random.
//!
//! **Paper.** E. Braaten and G. Weller, An Improved Low-Discrepancy Sequence for Multidimensional
//! Quasi-Monte Carlo Integration, J. Comput. Phys. 33(2) (1979), doi 10.1016/0021-9991(79)90019-6.
//!
//! ```
//! use workbook::scrambles::braaten_weller::permutation;
//! assert_eq!(permutation(7), [0, 3, 5, 1, 6, 2, 4]);
//! ```

use super::{Action, Scramble, fixed};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::{Guarantee, Radix, Sampler};
use crate::seed::Seed;

/// The scramble `braaten-weller`.
pub struct BraatenWeller;

static ABOUT: About = About {
    key: "braaten-weller",
    title: "Braaten-Weller",
    summary: "Braaten and Weller's fixed permutation of the digits in each base, chosen greedily.",
    file: "scrambles/braaten_weller.rs",
    source: include_str!("braaten_weller.rs"),
    papers: &[Paper {
        authors: "E. Braaten and G. Weller",
        year: 1979,
        title: "An Improved Low-Discrepancy Sequence for Multidimensional Quasi-Monte Carlo Integration",
        venue: "Journal of Computational Physics 33(2), 249-258",
        doi: Some("10.1016/0021-9991(79)90019-6"),
    }],
};

impl Entry for BraatenWeller {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for BraatenWeller {
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

/// Braaten and Weller's permutation of `0..base`.
pub fn permutation(base: u32) -> Vec<u32> {
    let b = i64::from(base);
    let mut images = vec![0];
    let mut free: Vec<i64> = (1..b).collect();
    // For each digit r, the sum of max(r, s) over the images s chosen so far, 0 apart.
    let mut maxima = vec![0; base as usize];
    while !free.is_empty() {
        let count = images.len() as i64;
        // What depends on r in the squared L2 discrepancy of the chosen points and r/b (Warnock's
        // formula), times b^2 and the square of their number.
        let cost = |r: i64| count * r * r - b * (2 * maxima[r as usize] + r);
        let later = count > 1 || base == 3;
        let Some(best) = free.iter().copied().min_by_key(|&r| (cost(r), if later { -r } else { r })) else { break };
        free.retain(|&r| r != best);
        images.push(best as u32);
        for (r, sum) in maxima.iter_mut().enumerate() {
            *sum += best.max(r as i64);
        }
    }
    images
}

#[cfg(test)]
mod tests {
    use super::permutation;

    /// The table of the paper.
    #[test]
    fn published_permutations() {
        assert_eq!(permutation(3), [0, 2, 1]);
        assert_eq!(permutation(5), [0, 2, 4, 1, 3]);
        assert_eq!(permutation(11), [0, 5, 8, 2, 10, 3, 6, 1, 9, 7, 4]);
        assert_eq!(permutation(13), [0, 6, 10, 2, 8, 4, 12, 1, 9, 5, 11, 3, 7]);
        assert_eq!(permutation(17), [0, 8, 13, 3, 11, 5, 16, 1, 10, 7, 14, 4, 12, 2, 15, 6, 9]);
    }
}
