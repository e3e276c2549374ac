//! Equal strata of the unit square, and points that stay strictly inside theirs as written.
//!
//! Coordinates are written in hundredths of a unit. A point near the border of its stratum could be rounded onto the border
//! or across it, and a Latin square would be false as drawn. [`written`] moves such a point inside by as little as possible.

/// A grid of equal cells on the unit square.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Strata {
    /// The number of columns.
    pub columns: u32,
    /// The number of rows.
    pub rows: u32,
}

impl Strata {
    /// A grid of `k` by `k` cells.
    pub fn cells(k: u32) -> Self {
        Self { columns: k, rows: k }
    }

    /// Cells of any shape, such as elementary intervals.
    pub fn boxes(columns: u32, rows: u32) -> Self {
        Self { columns, rows }
    }

    /// The `n` slabs of each axis, as for a Latin square: strata for [`written`] as well as lines across.
    pub fn slabs(n: u32) -> Self {
        Self::cells(n)
    }
}

/// The hundredth at which to write `value` in [0, 1] on a side of `length` hundredths, strictly inside its stratum of each of
/// `counts` equal strata where a stratum is wide enough to have an inside.
pub fn written(value: f64, length: i32, counts: impl IntoIterator<Item = u32>) -> i32 {
    let length = i64::from(length);
    let nearest = (value * length as f64).round() as i64;
    let (mut low, mut high) = (i64::MIN, i64::MAX);
    for count in counts.into_iter().map(i64::from).filter(|&count| count > 0) {
        let stratum = ((value * count as f64).floor() as i64).clamp(0, count - 1);
        // The first hundredth past the border below, and the last before the one above, be they as they are or as drawn.
        let first = (length * stratum).div_euclid(count).max(drawn(stratum, count, length)) + 1;
        let last = (length * (stratum + 1) - 1).div_euclid(count).min(drawn(stratum + 1, count, length) - 1);
        if first <= last && first.max(low) <= last.min(high) {
            (low, high) = (low.max(first), high.min(last));
        }
    }
    if !(0.0..=1.0).contains(&value) {
        return nearest as i32;
    }
    nearest.clamp(low, high) as i32
}

/// The hundredth at which border `k` of `count` equal strata is drawn.
fn drawn(k: i64, count: i64, length: i64) -> i64 {
    (2 * length * k + count).div_euclid(2 * count)
}

/// The hundredths at which the inner borders of `count` equal strata are drawn on a side of `length`.
pub(super) fn borders(count: u32, length: i32) -> impl Iterator<Item = i32> {
    (1..count).map(move |k| drawn(k.into(), count.into(), length.into()) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether hundredth `at` of `length` lies strictly inside stratum `k` of `n`.
    fn inside(at: i32, length: i32, k: i64, n: i64) -> bool {
        let (at, length) = (i64::from(at), i64::from(length));
        at * n > length * k && at * n < length * (k + 1)
    }

    #[test]
    fn points_at_borders_move_inside() {
        for length in [1000, 999, 25_600, 31_337] {
            for n in [1, 2, 3, 7, 16, 64, 100, 333] {
                for k in 0..n {
                    let start = f64::from(k) / f64::from(n);
                    // The first number of the stratum, its last, and its middle.
                    let end = f64::from_bits((f64::from(k + 1) / f64::from(n)).to_bits() - 1);
                    for value in [start, end, f64::midpoint(start, end)] {
                        let own = (value * f64::from(n)).floor() as i64;
                        let at = written(value, length, [n]);
                        assert!(inside(at, length, own, i64::from(n)), "{value} of {n} on {length}: {at}");
                    }
                }
            }
        }
    }

    #[test]
    fn several_strata_hold_at_once() {
        for i in 0..256_u32 {
            let value = f64::from(i) / 256.0;
            let at = written(value, 25_000, [16, 256]);
            assert!(inside(at, 25_000, i64::from(i / 16), 16) && inside(at, 25_000, i64::from(i), 256));
        }
    }

    #[test]
    fn strata_without_an_inside_are_let_be() {
        assert_eq!(written(0.5, 100, [1000]), 50);
        assert_eq!(written(0.25, 1000, []), 250);
        assert_eq!(written(1.5, 1000, [4]), 1500);
        assert!(inside(written(1.0, 1000, [4]), 1000, 3, 4));
    }
}
