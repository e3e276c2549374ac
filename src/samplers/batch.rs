//! Many points at once: the fast paths, which give the bits of the slow ones.
//!
//! **Binary sequences.** The rows of P = 2^p consecutive points are one vector of P d words. The
//! vector of the next P points is it XOR a vector that depends only on how many low bits of the
//! block number flip, so that one XOR a word makes all coordinates, in the order in which they are
//! stored. The compiler turns that loop into the widest instructions of the processor, chosen at
//! run time; whole numbers and single roundings give the same bits on all of them.
//!
//! **Radical inverses.** The low digits of the index run through a table, the high digits change
//! once a table: a coordinate is one addition and one division.

use super::{Digital, Radix};
use crate::scrambles::owen_hash;
use crate::vectors::vectorised;

/// Words in the vector of a block, at least: a few of the widest registers.
const WORDS: usize = 64;

/// What is done to the 32 binary digits of every coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finish {
    /// Nothing.
    Plain,
    /// XOR with a mask of 53 digits.
    Mask(u64),
    /// The hash-based nested scrambling with this key.
    Hash(u32),
}

/// The first `rows / d` points, from index 0, of a binary sequence, row-major in `out`, each axis
/// finished in its way; `finishes` has one for each axis, all of one kind.
///
/// Nothing is done, and `false` returned, where the kinds differ or there are more than 2^32
/// points.
pub fn binary(digital: &dyn Digital, finishes: &[Finish], out: &mut [f64]) -> bool {
    let d = finishes.len();
    let n = out.len() / d.max(1);
    let Some(&first) = finishes.first() else { return false };
    let same = finishes.iter().all(|finish| std::mem::discriminant(finish) == std::mem::discriminant(&first));
    if !same || n as u64 > 1 << 32 {
        return false;
    }
    // Reversed words for the hash, which works on reversed digits.
    let turn = |word: u32| if matches!(first, Finish::Hash(_)) { word.reverse_bits() } else { word };
    let rows = Rows::new(digital, d, n, turn);
    let repeated = |axis: usize| finishes[axis % d];
    match first {
        Finish::Plain => plain(&rows, out),
        Finish::Mask(_) => {
            let mask = |axis: usize| if let Finish::Mask(mask) = repeated(axis) { mask } else { 0 };
            let masks = rows.repeat(|axis| (mask(axis) >> 21) as u32);
            let lows = rows.repeat(|axis| (mask(axis) & ((1 << 21) - 1)) as f64 * super::digits::GRAIN);
            masked(&rows, &masks, &lows, out);
        }
        Finish::Hash(_) => {
            let keys = rows.repeat(|axis| if let Finish::Hash(key) = repeated(axis) { key } else { 0 });
            hashed(&rows, &keys, out);
        }
    }
    true
}

/// The vector of the first block, and what to add to go on.
struct Rows {
    d: usize,
    start: Vec<u32>,
    /// `steps[c]`: the vector to add when the c low bits of the block number are ones, and flip
    /// with the next.
    steps: Vec<Vec<u32>>,
}

impl Rows {
    fn new(digital: &dyn Digital, d: usize, n: usize, turn: impl Fn(u32) -> u32) -> Self {
        let points = WORDS.div_ceil(d).next_power_of_two().min(n.next_power_of_two());
        let shift = points.trailing_zeros();
        let word = |index: u64, axis: usize| turn((digital.numerator(index, axis) >> 21) as u32);
        let start =
            (0..points).flat_map(|i| (0..d).map(move |axis| (i, axis))).map(|(i, axis)| word(i as u64, axis)).collect();
        let bits = n.next_power_of_two().trailing_zeros();
        let mut sum = vec![0; d];
        let mut steps = Vec::new();
        for bit in shift..bits {
            for (axis, sum) in sum.iter_mut().enumerate() {
                *sum ^= word(1 << bit, axis);
            }
            steps.push(sum.repeat(points));
        }
        Self { d, start, steps }
    }

    /// One value for each word of the vector, from its axis.
    fn repeat<T>(&self, value: impl Fn(usize) -> T) -> Vec<T> {
        (0..self.start.len()).map(|at| value(at % self.d)).collect()
    }

    /// The step after block `block`; nothing is left to add after the last.
    fn step(&self, block: usize) -> &[u32] {
        self.steps.get(block.trailing_ones() as usize).map_or(&[], Vec::as_slice)
    }
}

/// 2^-32.
const GRAIN: f64 = owen_hash::GRAIN;

vectorised! {
    fn plain(rows: &Rows, out: &mut [f64]) {
        let mut words = rows.start.clone();
        for (block, out) in out.chunks_mut(rows.start.len()).enumerate() {
            for (x, word) in out.iter_mut().zip(&words) {
                *x = f64::from(*word) * GRAIN;
            }
            for (word, step) in words.iter_mut().zip(rows.step(block)) {
                *word ^= step;
            }
        }
    }
}

vectorised! {
    /// `masks` are of the 32 digits of the words, `lows` what their further digits are worth: whole
    /// numbers of 2^-53 below 2^-32, so that the sum is exact.
    fn masked(rows: &Rows, masks: &[u32], lows: &[f64], out: &mut [f64]) {
        let mut words = rows.start.clone();
        for (block, out) in out.chunks_mut(rows.start.len()).enumerate() {
            for (((x, word), mask), low) in out.iter_mut().zip(&words).zip(masks).zip(lows) {
                *x = f64::from(word ^ mask) * GRAIN + low;
            }
            for (word, step) in words.iter_mut().zip(rows.step(block)) {
                *word ^= step;
            }
        }
    }
}

vectorised! {
    fn hashed(rows: &Rows, keys: &[u32], out: &mut [f64]) {
        let mut words = rows.start.clone();
        let mut digits = words.clone();
        for (block, out) in out.chunks_mut(rows.start.len()).enumerate() {
            // A loop of its own, so that twice as many words fit in a register as coordinates.
            for ((digits, word), key) in digits.iter_mut().zip(&words).zip(keys) {
                *digits = owen_hash::carry_up(*word, *key).reverse_bits();
            }
            for (x, digits) in out.iter_mut().zip(&digits) {
                *x = f64::from(*digits) * GRAIN;
            }
            for (word, step) in words.iter_mut().zip(rows.step(block)) {
                *word ^= step;
            }
        }
    }
}

/// Entries of the table of low digits, at most: it stays in the nearest cache.
const ENTRIES: u64 = 1024;

/// Radical inverses of the indices 0, 1, ... with every digit mapped by its position, in every
/// `stride`-th place of `out`.
///
/// `image(position, digit)` is the mapped digit, for positions from the first behind the point, and
/// `tail` the fraction of a last digit that is added.
pub fn radical(radix: Radix, image: impl Fn(usize, u64) -> u64, tail: f64, out: &mut [f64], stride: usize) {
    let base = u64::from(radix.base);
    let n = out.len().div_ceil(stride) as u64;
    let (mut low_digits, mut entries) = (0, 1);
    while low_digits < radix.digits as usize && entries * base <= ENTRIES && entries < n {
        entries *= base;
        low_digits += 1;
    }
    // The sum of the mapped digits at `positions` of an index' digits, the lowest first.
    let mapped = |index: u64, positions: std::ops::Range<usize>| {
        let mut rest = index;
        let mut place = radix.scale / base.pow(positions.start as u32);
        let mut sum = 0;
        for position in positions {
            place /= base;
            sum += image(position, rest % base) * place;
            rest /= base;
        }
        sum
    };
    // Numerators are below 2^53: as `f64` they are exact, and so is their sum. Each further digit
    // repeats the table b times.
    let mut table = vec![0.0];
    let mut place = radix.scale;
    for position in 0..low_digits {
        place /= base;
        let digits = (0..base).map(|digit| (image(position, digit) * place) as f64);
        table = digits.flat_map(|worth| table.iter().map(move |low| low + worth)).collect();
    }
    for (high, block) in out.chunks_mut(entries as usize * stride).enumerate() {
        let above = mapped(high as u64, low_digits..radix.digits as usize);
        if tail == 0.0 {
            divided(&table, above as f64, radix.scale as f64, block, stride);
        } else {
            for (x, low) in block.iter_mut().step_by(stride).zip(&table) {
                *x = radix.coordinate_with(*low as u64 + above, tail);
            }
        }
    }
}

vectorised! {
    fn divided(table: &[f64], above: f64, scale: f64, out: &mut [f64], stride: usize) {
        let mut quotients = [0.0; 64];
        for (out, lows) in out.chunks_mut(64 * stride).zip(table.chunks(64)) {
            for (quotient, low) in quotients.iter_mut().zip(lows) {
                *quotient = (low + above) / scale;
            }
            for (x, quotient) in out.iter_mut().step_by(stride).zip(&quotients) {
                *x = *quotient;
            }
        }
    }
}
