//! What the fixed digit permutations share: one permutation for each base, for every position.

use super::Action;
use super::walk::Places;
use crate::samplers::{Digits, Radix, Sampler};

/// Larger bases, which only the fractions i/n of a Hammersley set and single radical inverses have,
/// are left alone.
const LARGEST: u32 = 2048;

/// Whether there are digits, and not only binary ones, whose only permutation that keeps 0 is the
/// identity.
pub(super) fn combines(sampler: &dyn Sampler) -> Result<(), &'static str> {
    match sampler.digits() {
        Digits::None => Err("its coordinates have no digits to permute"),
        Digits::Binary => Err("in base 2 it is the identity"),
        Digits::Mixed => Ok(()),
    }
}

/// The action of `permutation`, which gives the images of the digits of a base.
pub(super) fn action(radix: Radix, permutation: impl Fn(u32) -> Vec<u32>) -> Action {
    if radix.base > LARGEST {
        return Action::Digits(Box::new(move |numerator| radix.coordinate(numerator)));
    }
    let images = permutation(radix.base).into_iter().map(u64::from).collect();
    Action::Positions { places: Places::new(radix), images: vec![images], tail: 0.0 }
}
