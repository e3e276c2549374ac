//! Seeds and streams: where every random number of the course comes from.
//!
//! A [`Seed`] is never used as it is. Each use derives its own stream by hashing,
//! `seed.named("halton").at(3)`, so that a new figure shifts no other figure's numbers, and
//! consecutive seeds, which bias hash-based scrambling, are harmless. The generator is xoshiro256++
//! (Blackman and Vigna 2021, doi 10.1145/3460772), a named algorithm whose output never changes;
//! floats, ranges and shuffles are built on its 64-bit words here, because the conveniences of a
//! random-number crate may change values between releases.
//!
//! ```
//! use workbook::seed::Seed;
//! let mut random = Seed::new(1).named("example").generator();
//! assert!((0.0..1.0).contains(&random.uniform()));
//! ```

use rand::SeedableRng;
use rand::rand_core::Rng;
use rand::rngs::Xoshiro256PlusPlus;

/// The state from which streams are derived: a hash of the number given and of every name and index
/// on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seed(u64);

/// The golden ratio times 2^64, the increment of the `SplitMix64` sequence.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Keeps the streams of names apart from those of indices.
const NAMES: u64 = 0xd1b5_4a32_d192_ed03;

/// A bijection of 64-bit words that avalanches: the finaliser of `SplitMix64` in the variant
/// "Mix13" of D. Stafford (Steele, Lea and Flood 2014, doi 10.1145/2660193.2660195).
#[inline]
pub const fn mix(word: u64) -> u64 {
    let word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}

impl Seed {
    /// The seed of the number `number`; every `u64` is as good as any other.
    pub const fn new(number: u64) -> Self {
        Self(mix(number.wrapping_add(GOLDEN)))
    }

    /// The stream called `name`: for an experiment, a sampler, a part of an algorithm.
    #[must_use]
    pub fn named(self, name: &str) -> Self {
        let start = mix(self.0 ^ NAMES);
        let hash =
            name.bytes().fold(start, |hash, byte| mix(hash.rotate_left(8) ^ u64::from(byte)).wrapping_add(GOLDEN));
        // The length parts a name from a longer one that begins with it even where a byte is zero.
        Self(mix(hash ^ name.len() as u64))
    }

    /// The stream numbered `index`: for a replicate, a dimension, a block of points.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u64) -> Self {
        Self(mix(self.0.wrapping_add(GOLDEN) ^ mix(index.wrapping_add(GOLDEN))))
    }

    /// One 64-bit word of this stream: all that a hash-based scramble needs.
    #[inline]
    pub const fn word(self) -> u64 {
        mix(self.0 ^ GOLDEN)
    }

    /// A generator that starts this stream.
    pub fn generator(self) -> Random {
        let mut bytes = [0; 32];
        for (k, chunk) in bytes.chunks_exact_mut(8).enumerate() {
            chunk.copy_from_slice(&self.at(k as u64).word().to_le_bytes());
        }
        Random(Xoshiro256PlusPlus::from_seed(bytes))
    }
}

/// A stream of random numbers: xoshiro256++, period 2^256 - 1.
#[derive(Clone, Debug)]
pub struct Random(Xoshiro256PlusPlus);

impl Random {
    /// The next 64 random bits.
    #[inline]
    pub fn next_u64(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// A number in [0, 1), uniform on the 2^53 multiples of 2^-53.
    #[inline]
    pub fn uniform(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// A whole number in `0..n`, without bias (Lemire 2019, doi 10.1145/3230636); 0 where `n` is 0.
    #[inline]
    pub fn below(&mut self, n: u64) -> u64 {
        let mut product = u128::from(self.next_u64()) * u128::from(n);
        if (product as u64) < n {
            // 2^64 is no multiple of n: the first 2^64 mod n low words are one too many, and are
            // drawn again.
            let surplus = n.wrapping_neg() % n.max(1);
            while (product as u64) < surplus {
                product = u128::from(self.next_u64()) * u128::from(n);
            }
        }
        (product >> 64) as u64
    }

    /// Shuffles `items` in place, every order equally likely (Fisher and Yates 1938, Durstenfeld's
    /// form).
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for (i, j) in self.swaps(items.len()) {
            items.swap(i, j);
        }
    }

    /// The swaps that shuffle `n` items, in order: for each i from the last to the second, j is
    /// uniform in `0..=i`.
    pub fn swaps(&mut self, n: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        // `i` itself is among the choices: leaving it out would give cyclic permutations only.
        (1..n).rev().map(|i| (i, self.below(i as u64 + 1) as usize))
    }

    /// A random permutation of `0..n`.
    pub fn permutation(&mut self, n: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        self.shuffle(&mut order);
        order
    }
}
