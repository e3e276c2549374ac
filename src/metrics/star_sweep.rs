//! The sweep that finds the extremal boxes of the plane, along x over blocks in y.
//!
//! Between two neighbouring abscissas X the box \[0, X) x \[0, y) holds a count c(y), which a new
//! point raises by one for all y above its own. Looking at every y for every X costs n^2. Instead
//! the ordinates are taken in blocks, and of each block only a bound is carried along. Say that the
//! largest c(y) - n X y of a block was M at some X. Since then X grew by D, and K points came below
//! the block's upper end; the largest is now at most M + K - n D l, with the block's lowest ordinate
//! l. Only when that passes the best difference found so far, which is seldom, since points come as
//! fast as the area grows, are the block's ordinates looked at again. Likewise n X y - c(y) is at
//! most M + n D u - K, with the highest ordinate u and the K points below the block.
//!
//! **Cost.** With blocks of b ordinates, b + n/b additions and comparisons for each point, side by
//! side in the processor's widest registers: in practice a few nanoseconds per point and hundred
//! blocks.

#![expect(clippy::inline_always, reason = "a function of its own would be compiled without the wide registers")]

use super::star::Best;
use crate::vectors::vectorised;

/// A point of the plane: its abscissa, and the place of its ordinate among the sorted ones.
pub(super) type Ranked = (f64, usize);

/// More than rounding can make of a bound in units of points.
const SLACK: f64 = 1e-6;

/// Offers, for the boxes of the plane, the largest count/n - `heights[0]` x y over closed boxes and
/// the largest `heights[1]` x y - count/n over open ones. Boxes of space are this, with the points
/// below a height and the height.
///
/// `order` are the points by rising x; `ordinates` rise and end with 1. What is no larger than the
/// best so far is left out.
pub(super) fn sweep(order: &[Ranked], ordinates: &[f64], n: usize, heights: [f64; 2], best: &mut [Best; 2]) {
    let [full, empty] = best;
    run(order, Blocks::new(ordinates, n as f64), heights, full, empty);
}

vectorised! {
    fn run(order: &[Ranked], blocks: Blocks, heights: [f64; 2], full: &mut Best, empty: &mut Best) {
        let (mut rest, mut blocks) = (order, blocks);
        while let Some(&(x, _)) = rest.first() {
            // Boxes open at x hold the points left of it.
            blocks.look::<EMPTY>(x, x * heights[EMPTY], empty);
            let ties = 1 + rest[1..].iter().take_while(|point| point.0 == x).count();
            for &(_, rank) in &rest[..ties] {
                blocks.add(rank);
            }
            rest = &rest[ties..];
            // Boxes closed at x hold those on it as well.
            blocks.look::<FULL>(x, x * heights[FULL], full);
        }
        if order.last().is_none_or(|point| point.0 < 1.0) {
            blocks.look::<EMPTY>(1.0, heights[EMPTY], empty);
        }
    }
}

/// Closed boxes, with too many points.
const FULL: usize = 0;
/// Open boxes, with too few.
const EMPTY: usize = 1;

/// Ordinates, and blocks, that are looked at side by side.
const LANES: usize = 8;

/// The ordinates in blocks of `size`, both filled up to whole lanes. Counts are whole numbers, as
/// `f64` for the arithmetic.
struct Blocks {
    n: f64,
    size: usize,
    /// The ordinates, and at the end NaN, which no comparison finds large.
    ordinates: Vec<f64>,
    /// For each block, of `size + 1` places: how many points lie in the block below its ordinate 0,
    /// 1, ..., and how many in all of it.
    inside: Vec<f64>,
    /// How many points lie below each block, and at the end how many there are.
    below: Vec<f64>,
    /// The lowest and the highest ordinate of each block.
    ends: [Vec<f64>; 2],
    /// For each block, n times the last largest excess of points, and of area, without the part
    /// that follows the area and the count.
    bounds: [Vec<f64>; 2],
}

impl Blocks {
    fn new(ordinates: &[f64], n: f64) -> Self {
        // A point costs additions in a block and comparisons of all blocks, of which there are two
        // kinds.
        let size = (((2 * ordinates.len()) as f64).sqrt() as usize + 1).next_multiple_of(LANES);
        let count = ordinates.len().div_ceil(size);
        let room = count.next_multiple_of(LANES);
        let ends = |end: fn(&[f64]) -> Option<&f64>| {
            let mut ends: Vec<f64> = ordinates.chunks(size).filter_map(end).copied().collect();
            ends.resize(room, 0.0);
            ends
        };
        let ends = [ends(<[f64]>::first), ends(<[f64]>::last)];
        let mut bounds = vec![f64::INFINITY; count];
        bounds.resize(room, f64::NEG_INFINITY);
        let mut ordinates = ordinates.to_vec();
        ordinates.resize(count * size, f64::NAN);
        let (inside, below) = (vec![0.0; count * (size + 1)], vec![0.0; room + 1]);
        Self { n, size, ordinates, inside, below, ends, bounds: [bounds.clone(), bounds] }
    }

    /// Adds a point on the ordinate `rank`.
    #[inline(always)]
    fn add(&mut self, rank: usize) {
        let (block, place) = (rank / self.size, rank % self.size);
        let places = self.size + 1;
        raise_after(&mut self.inside[block * places + 1..][..self.size], place);
        raise_after(&mut self.below[1..], block);
    }

    /// Offers the largest excess of `KIND` over the boxes that end at `x` and have the area `area`
    /// by y, of the blocks that can have it.
    #[inline(always)]
    fn look<const KIND: usize>(&mut self, x: f64, area: f64, best: &mut Best) {
        let area_n = area * self.n;
        let (below, _) = self.below[1 - KIND..].as_chunks::<LANES>();
        let (ends, _) = self.ends[KIND].as_chunks::<LANES>();
        let (bounds, _) = self.bounds[KIND].as_chunks_mut::<LANES>();
        for (chunk, ((bounds, below), ends)) in bounds.iter_mut().zip(below).zip(ends).enumerate() {
            let limit = best.value * self.n - SLACK;
            let mut change = [0.0; LANES];
            let mut passes = false;
            for lane in 0..LANES {
                change[lane] = signed::<KIND>(below[lane] - area_n * ends[lane]);
                passes |= bounds[lane] + change[lane] > limit;
            }
            if !passes {
                continue;
            }
            for lane in 0..LANES {
                if bounds[lane] + change[lane] > best.value * self.n - SLACK {
                    let block = chunk * LANES + lane;
                    let ordinates = &self.ordinates[block * self.size..][..self.size];
                    let counts = &self.inside[block * (self.size + 1) + 1 - KIND..][..self.size];
                    let (n, below) = (self.n, self.below[block]);
                    let score = |y, count| signed::<KIND>((below + count) / n - area * y);
                    let value = largest(ordinates, counts, score);
                    best.offer(value, || {
                        let has_it = |(y, count): &(&f64, &f64)| score(**y, **count) == value;
                        vec![x, ordinates.iter().zip(counts).find(has_it).map_or(1.0, |(&y, _)| y)]
                    });
                    bounds[lane] = value * n - change[lane];
                }
            }
        }
    }
}

/// The excess of points as the excess of `KIND`.
#[inline(always)]
fn signed<const KIND: usize>(excess: f64) -> f64 {
    if KIND == FULL { excess } else { -excess }
}

/// Adds 1 to each count from the place `from` on. No closures here: they would be compiled without
/// the wide registers.
#[inline(always)]
fn raise_after(counts: &mut [f64], from: usize) {
    let (chunks, _) = counts.as_chunks_mut::<LANES>();
    for chunk in &mut chunks[from / LANES..] {
        for count in chunk {
            *count += 1.0;
        }
    }
    // The lanes before it, in its chunk, were no part of it.
    for count in &mut chunks[from / LANES][..from % LANES] {
        *count -= 1.0;
    }
}

/// The largest score of an ordinate with its count.
#[inline(always)]
fn largest(ordinates: &[f64], counts: &[f64], score: impl Fn(f64, f64) -> f64) -> f64 {
    let mut largest = [f64::NEG_INFINITY; LANES];
    let ordinates = ordinates.as_chunks::<LANES>().0;
    for (ordinates, counts) in ordinates.iter().zip(counts.as_chunks::<LANES>().0) {
        for lane in 0..LANES {
            let value = score(ordinates[lane], counts[lane]);
            largest[lane] = if value > largest[lane] { value } else { largest[lane] };
        }
    }
    largest.into_iter().fold(f64::NEG_INFINITY, f64::max)
}
