//! A walk over the digits of a numerator, the most significant first: what the scrambles of any
//! base share.

use crate::samplers::Radix;
use crate::seed::mix;

/// The places of the digits of one radix: `places[k]` is b^(m-1-k), the worth of digit k.
#[derive(Clone, Debug)]
pub struct Places {
    /// The radix.
    pub radix: Radix,
    places: Vec<u64>,
}

impl Places {
    /// The places of `radix`.
    pub fn new(radix: Radix) -> Self {
        let worth = |&place: &u64| (place > 1).then(|| place / u64::from(radix.base));
        Self { radix, places: std::iter::successors(worth(&radix.scale), worth).collect() }
    }

    /// Each digit of `numerator`, the most significant first, with its position and its place.
    pub fn digits(&self, numerator: u64) -> impl Iterator<Item = (usize, u64, u64)> + '_ {
        let mut rest = numerator;
        self.places.iter().enumerate().map(move |(position, &place)| {
            let digit = rest / place;
            rest -= digit * place;
            (position, digit, place)
        })
    }

    /// The numerator whose digits are the images of those of `numerator` under `image(position,
    /// digit) < base`.
    pub fn map(&self, numerator: u64, image: impl Fn(usize, u64) -> u64) -> u64 {
        self.digits(numerator).map(|(position, digit, place)| image(position, digit) * place).sum()
    }
}

/// A number in [0, 1) from 64 random bits.
pub fn unit(word: u64) -> f64 {
    (word >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
}

/// Above this size, shuffling a permutation to look up one image costs too much, and it is computed
/// by hashing instead.
const SHUFFLED: u64 = 2048;

/// The image of `digit < base` under the random permutation of `0..base` that `key` numbers: a
/// shuffle for small bases, [`permuted`] for large.
pub fn image(digit: u64, base: u64, key: u64) -> u64 {
    if base == 2 {
        return digit ^ (key >> 63);
    }
    if base > SHUFFLED {
        return permuted(digit, base, key);
    }
    // Durstenfeld's shuffle, followed for one item: the swaps are replayed backwards on its
    // position alone.
    let mut place = digit;
    for i in (1..base).rev() {
        let other = partner(i, key);
        if place == i {
            place = other;
        } else if place == other {
            place = i;
        }
    }
    place
}

/// The item with which the shuffle that `key` numbers swaps item `i`.
fn partner(i: u64, key: u64) -> u64 {
    let word = mix(key.wrapping_add(i.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
    ((u128::from(word) * u128::from(i + 1)) >> 64) as u64
}

/// The images of all digits of a base, as [`image()`] gives them one by one.
pub fn images(base: u64, key: u64) -> Vec<u64> {
    if base == 2 || base > SHUFFLED {
        return (0..base).map(|digit| image(digit, base, key)).collect();
    }
    let mut items: Vec<u64> = (0..base).collect();
    for i in (1..base).rev() {
        items.swap(i as usize, partner(i, key) as usize);
    }
    let mut images = vec![0; items.len()];
    for (place, item) in (0..).zip(items) {
        images[item as usize] = place;
    }
    images
}

/// The image of `index < count` under a permutation of `0..count` computed from `key` alone: a
/// bijection of the next power of two, applied until it lands below `count` (cycle walking; Kensler
/// 2013, Correlated Multi-Jittered Sampling, section 4).
pub fn permuted(index: u64, count: u64, key: u64) -> u64 {
    if count < 2 {
        return 0;
    }
    let mask = count.next_power_of_two().wrapping_sub(1);
    let half = mask.count_ones().div_ceil(2);
    let mut value = index;
    loop {
        for round in 0..4 {
            // Odd multiplications, additions and right shifts of the masked word are each
            // bijections of it.
            let word = mix(key.wrapping_add(round));
            value = value.wrapping_add(word) & mask;
            value ^= value >> half;
            value = value.wrapping_mul(word >> 32 | 1) & mask;
            value ^= value >> half.min(3);
        }
        if value < count {
            return value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_permutations() {
        for base in [2, 3, 5, 16, 131, 3000] {
            for key in 0..20 {
                for map in [image, permuted] {
                    let mut seen = vec![false; base as usize];
                    (0..base).for_each(|digit| seen[map(digit, base, mix(key)) as usize] = true);
                    assert!(seen.iter().all(|&seen| seen), "base {base}, key {key}");
                }
            }
        }
    }

    #[test]
    fn all_images_at_once_are_those_one_by_one() {
        for base in [2, 3, 7, 131, 3000] {
            let one_by_one: Vec<u64> = (0..base).map(|digit| image(digit, base, 9)).collect();
            assert_eq!(images(base, 9), one_by_one);
        }
    }

    #[test]
    fn digits_come_back() {
        for base in [2, 3, 131, 1619] {
            let places = Places::new(Radix::new(base));
            for numerator in [0, 1, 12_345_678_901, places.radix.scale - 1] {
                assert_eq!(places.map(numerator, |_, digit| digit), numerator);
                assert_eq!(places.digits(numerator).count(), places.radix.digits as usize);
            }
        }
    }
}
