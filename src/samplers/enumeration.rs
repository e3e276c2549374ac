//! Enumeration: which indices of a Halton or Sobol' sequence fall in a given box, found without
//! search.
//!
//! **Halton.** A coordinate lies in the interval c / b^k ... (c + 1) / b^k exactly if the k lowest
//! digits of the index are those of c in reverse: a congruence modulo b^k. Several axes have
//! coprime moduli, and the Chinese remainder theorem makes one congruence of all.
//!
//! **Sobol'.** The k first digits of a coordinate are k linear equations modulo 2 in the bits of
//! the index. Elimination solves those of all axes at once, for the indices of any aligned block of
//! 2^m.
//!
//! A pixel of an image is such a box: a renderer can go from pixel to pixel and still use one
//! sequence for the whole picture.
//!
//! **Paper.** L. Gruenschloss, M. Raab and A. Keller, Enumerating Quasi-Monte Carlo Point Sequences
//! in Elementary Intervals, Monte Carlo and Quasi-Monte Carlo Methods 2010, doi
//! 10.1007/978-3-642-27440-4_21.
//!
//! ```
//! use workbook::samplers::{enumeration::{Interval, halton}, halton::radical_inverse};
//! // The pixel in column 3 of 4 and row 5 of 9.
//! let indices = halton(&[Interval { axis: 0, digits: 2, cell: 3 }, Interval { axis: 1, digits: 2, cell: 5 }]).unwrap();
//! assert_eq!(indices.step, 36);
//! let fifth = indices.first + 4 * indices.step;
//! assert_eq!((radical_inverse(fifth, 2) * 4.0) as u32, 3);
//! assert_eq!((radical_inverse(fifth, 3) * 9.0) as u32, 5);
//! ```

use super::Radix;
use super::halton::PRIMES;
use super::sobol;

/// An interval of one axis: the coordinates whose first `digits` digits are those of `cell`, i.e.
/// \[cell / b^digits, (cell + 1) / b^digits).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Interval {
    /// The axis, from 0.
    pub axis: usize,
    /// How many digits are fixed.
    pub digits: u32,
    /// Their value, below b^digits.
    pub cell: u64,
}

/// The indices `first`, `first + step`, `first + 2 step`, ...
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progression {
    /// The first index.
    pub first: u64,
    /// The distance of neighbours.
    pub step: u64,
}

/// The indices of the Halton sequence whose points lie in the box of
/// `intervals`, at most one for each axis. `None` where a cell or an axis is
/// out of range, an axis comes twice, or the product of all b^digits is not
/// below 2^53.
pub fn halton(intervals: &[Interval]) -> Option<Progression> {
    let mut all = Progression { first: 0, step: 1 };
    for (k, interval) in intervals.iter().enumerate() {
        let base = u64::from(*PRIMES.get(interval.axis)?);
        let count = base.checked_pow(interval.digits)?;
        let step = all.step.checked_mul(count)?;
        let same = |other: &Interval| other.axis == interval.axis;
        let twice = intervals[..k].iter().any(same);
        if twice || interval.cell >= count || step >= 1 << 53 {
            return None;
        }
        let remainder = reversed(interval.cell, base, interval.digits);
        // first + step t = remainder modulo count: t is the difference over
        // the step, whose inverse exists, since the moduli are coprime.
        let difference = (remainder + count - all.first % count) % count;
        let t = multiply(difference, inverse(all.step % count, count), count);
        all = Progression { first: all.first + all.step * t, step };
    }
    Some(all)
}

/// The `digits` digits of `cell` in reverse order.
fn reversed(cell: u64, base: u64, digits: u32) -> u64 {
    let (mut rest, mut value) = (cell, 0);
    for _ in 0..digits {
        value = value * base + rest % base;
        rest /= base;
    }
    value
}

fn multiply(a: u64, b: u64, modulus: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(modulus)) as u64
}

/// The inverse of `a` modulo `modulus`, which have no common divisor (Euclid's algorithm with one
/// coefficient); 0 modulo 1.
fn inverse(a: u64, modulus: u64) -> u64 {
    let m = i128::from(modulus);
    let (mut old, mut new) = ((i128::from(a), 1), (m, 0));
    while new.0 != 0 {
        let quotient = old.0 / new.0;
        (old, new) = (new, (old.0 - quotient * new.0, old.1 - quotient * new.1));
    }
    old.1.rem_euclid(m) as u64
}

/// The most indices that one call gives: 2^20.
const MOST_FREE_BITS: u32 = 20;

/// The indices of the Sobol' sequence in the block `block * 2^m .. (block + 1) * 2^m` whose points
/// lie in the box of `intervals`, in rising order. `None` where an axis, a cell or the block is out
/// of range, or the indices are more than 2^20.
pub fn sobol(intervals: &[Interval], m: u32, block: u64) -> Option<Vec<u64>> {
    let digits = Radix::new(2).digits;
    if m > digits || block.checked_shl(m).is_none_or(|first| first >> m != block || first >> digits != 0) {
        return None;
    }
    let first = block << m;
    let mut equations = Vec::new();
    for interval in intervals {
        let valid = interval.axis < sobol::MOST_DIMENSIONS
            && interval.digits <= digits
            && interval.cell >> interval.digits == 0;
        if !valid {
            return None;
        }
        // What the bits of the block alone give must be mended by the low bits.
        let target = interval.cell ^ sobol::sobol_bits(first, interval.axis) >> (digits - interval.digits);
        for digit in 0..interval.digits {
            let place = digits - 1 - digit;
            let bits = (0..m).filter(|&bit| sobol::columns(interval.axis)[bit as usize] >> place & 1 == 1);
            let row = bits.fold(0, |row, bit| row | 1 << bit);
            equations.push((row, target >> (interval.digits - 1 - digit) & 1 == 1));
        }
    }
    solve(equations, m).map(|mut low| {
        for index in &mut low {
            *index |= first;
        }
        low.sort_unstable();
        low
    })
}

/// All words of `m` bits whose products with the rows are the right-hand sides, modulo 2.
fn solve(mut equations: Vec<(u64, bool)>, m: u32) -> Option<Vec<u64>> {
    let mut pivots: Vec<(u32, u64, bool)> = Vec::new();
    while let Some((mut row, mut side)) = equations.pop() {
        for &(bit, pivot, value) in &pivots {
            if row >> bit & 1 == 1 {
                row ^= pivot;
                side ^= value;
            }
        }
        if row == 0 {
            // Nothing on the left: either always true, or never.
            if side {
                return Some(Vec::new());
            }
            continue;
        }
        let bit = row.trailing_zeros();
        for (_, pivot, value) in &mut pivots {
            if *pivot >> bit & 1 == 1 {
                *pivot ^= row;
                *value ^= side;
            }
        }
        pivots.push((bit, row, side));
    }
    let free: Vec<u32> = (0..m).filter(|bit| pivots.iter().all(|pivot| pivot.0 != *bit)).collect();
    if free.len() as u32 > MOST_FREE_BITS {
        return None;
    }
    let choice = |choice: u64| {
        free.iter().enumerate().filter(|(k, _)| choice >> k & 1 == 1).fold(0, |word, (_, bit)| word | 1 << bit)
    };
    let complete = |chosen: u64| {
        let on = pivots.iter().filter(|&&(_, row, side)| ((row & chosen).count_ones() % 2 == 1) != side);
        on.fold(chosen, |word, &(bit, ..)| word | 1 << bit)
    };
    Some((0..1_u64 << free.len()).map(|k| complete(choice(k))).collect())
}
