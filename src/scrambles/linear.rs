//! Matousek's random linear scramble with a digital shift.
//!
//! **What.** On each axis the digits are multiplied by a random lower triangular matrix over the
//! integers modulo the base, with a diagonal that is nowhere 0, and a random digital shift is
//! added.
//!
//! **Formula.** e_k = (sum over j <= k of L_kj d_j + s_k) mod b, with L_kk uniform on 1..b, L_kj
//! and s_k uniform on 0..b.
//!
//! **Guarantees.** Each point is uniform, hence the mean is unbiased; nets stay nets with the same
//! t, prefixes prefixes. The variance of every mean is that of Owen's scrambling, with far fewer
//! random numbers.
//!
//! **Cost.** One XOR for each set bit of a coordinate in base 2; a product of matrix and vector in
//! other bases.
//!
//! **Limits.** Prime bases only: elsewhere a diagonal entry might have no inverse. Digits beyond
//! the last that a `f64` holds are not formed.
//!
//! **Paper.** J. Matousek, On the L2-Discrepancy for Anchored Boxes, J. Complexity 14(4) (1998),
//! doi 10.1006/jcom.1998.0489.
//!
//! ```
//! use workbook::{samplers::Method, seed::Seed};
//! let points = Method::parse("sobol+linear")?.points(8, 1, Seed::new(3))?;
//! let mut eighths: Vec<u32> = points.axis(0).map(|x| (x * 8.0) as u32).collect();
//! eighths.sort_unstable();
//! assert_eq!(eighths, [0, 1, 2, 3, 4, 5, 6, 7]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::walk::{Places, unit};
use super::{Action, Scramble};
use crate::catalogue::{About, Entry, Paper};
use crate::samplers::{Digits, Guarantee, Radix, Sampler};
use crate::seed::{Random, Seed};

/// The scramble `linear`.
pub struct Linear;

static ABOUT: About = About {
    key: "linear",
    title: "a random linear scramble",
    summary: "A random lower triangular matrix on the digits and a random digital shift.",
    file: "scrambles/linear.rs",
    source: include_str!("linear.rs"),
    papers: &[Paper {
        authors: "J. Matoušek",
        year: 1998,
        title: "On the L2-Discrepancy for Anchored Boxes",
        venue: "Journal of Complexity 14(4), 527-556",
        doi: Some("10.1006/jcom.1998.0489"),
    }],
};

impl Entry for Linear {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Scramble for Linear {
    fn combines(&self, sampler: &dyn Sampler) -> Result<(), &'static str> {
        match sampler.digits() {
            Digits::None => Err("its coordinates have no digits to scramble"),
            Digits::Mixed if !sampler.has_prime_bases() => Err("its bases need not be prime"),
            _ => Ok(()),
        }
    }

    fn keeps(&self, guarantee: Guarantee) -> bool {
        !matches!(guarantee, Guarantee::Deterministic)
    }

    fn action(&self, radix: Radix, axis: usize, seed: Seed) -> Action {
        let mut random = seed.at(axis as u64).generator();
        if radix.base == 2 {
            let (columns, shift) = (binary_columns(&mut random), random.below(radix.scale));
            return Action::Digits(Box::new(move |numerator| radix.coordinate(shift ^ multiply(&columns, numerator))));
        }
        let places = Places::new(radix);
        let (base, digits) = (u64::from(radix.base), radix.digits as usize);
        // Column j holds the entries of rows j, j + 1, ...
        let columns: Vec<Vec<u64>> = (0..digits)
            .map(|j| {
                (j..digits).map(|row| if row == j { 1 + random.below(base - 1) } else { random.below(base) }).collect()
            })
            .collect();
        let shift: Vec<u64> = (0..digits).map(|_| random.below(base)).collect();
        let tail = unit(random.next_u64());
        Action::Digits(Box::new(move |numerator| {
            let mut sums = shift.clone();
            for (j, digit, _) in places.digits(numerator).filter(|&(_, digit, _)| digit > 0) {
                for (sum, entry) in sums[j..].iter_mut().zip(&columns[j]) {
                    *sum += entry * digit;
                }
            }
            let scrambled = sums.iter().fold(0, |numerator, sum| numerator * base + sum % base);
            radix.coordinate_with(scrambled, tail)
        }))
    }
}

/// The columns of a random lower triangular binary matrix with ones on the diagonal; the first
/// digit is bit 52.
fn binary_columns(random: &mut Random) -> [u64; 53] {
    std::array::from_fn(|j| {
        let diagonal = 1 << (52 - j);
        diagonal | random.next_u64() & (diagonal - 1)
    })
}

/// The product of a binary matrix, by columns, with the digits of `numerator`.
fn multiply(columns: &[u64; 53], numerator: u64) -> u64 {
    let (mut rest, mut product) = (numerator, 0);
    while rest > 0 {
        let highest = rest.ilog2();
        product ^= columns[52 - highest as usize];
        rest ^= 1 << highest;
    }
    product
}
