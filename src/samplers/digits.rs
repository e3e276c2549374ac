//! Digits of whole numbers, and how they become coordinates: the common ground of the digital
//! sequences and their scrambles.
//!
//! A digital construction gives, for each axis, a *numerator*: the whole number v whose base-b
//! digits, most significant first, are those of the coordinate x = v / b^m. Digits are worked on as
//! integers and divided once, so that no coordinate ever rounds up to 1.

/// 2^53: every whole number up to it is a `f64`.
const EXACT: u64 = 1 << 53;

/// 2^-53, the grain of `f64` just below 1.
pub const GRAIN: f64 = 1.0 / EXACT as f64;

/// A base with as many digits as a `f64` holds exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Radix {
    /// The base b, at least 2.
    pub base: u32,
    /// The number of digits m: the most with b^m <= 2^53 (53 in base 2, 33 in base 3, 7 in base
    /// 131).
    pub digits: u32,
    /// b^m, the denominator of every coordinate.
    pub scale: u64,
}

impl Radix {
    /// The radix of `base`, which is raised to 2 if it is less.
    pub const fn new(base: u32) -> Self {
        let base = if base < 2 { 2 } else { base };
        let (mut digits, mut scale) = (0, 1);
        while scale <= EXACT / base as u64 {
            scale *= base as u64;
            digits += 1;
        }
        Self { base, digits, scale }
    }

    /// The coordinate of `numerator < scale`: one division of two exact numbers, hence the nearest
    /// `f64`, and below 1.
    #[inline]
    pub fn coordinate(self, numerator: u64) -> f64 {
        numerator as f64 / self.scale as f64
    }

    /// The coordinate of `numerator` with the fraction `tail` in [0, 1) of a last digit added; it
    /// stays in its interval.
    #[inline]
    pub fn coordinate_with(self, numerator: u64, tail: f64) -> f64 {
        within(numerator, self.scale, tail)
    }

    /// The numerator whose digits are those of `index` in reverse: the radical inverse times
    /// `scale`. Digits of `index` beyond the `digits`-th are dropped.
    pub fn reversed(self, index: u64) -> u64 {
        if self.base == 2 {
            return index.reverse_bits() >> 11;
        }
        let base = u64::from(self.base);
        let (mut rest, mut numerator) = (index, 0);
        for _ in 0..self.digits {
            numerator = numerator * base + rest % base;
            rest /= base;
        }
        numerator
    }
}

/// The number (`cell` + `fraction`) / `count`, kept inside [cell / count,
/// (cell + 1) / count) where rounding would push it out.
///
/// `fraction` is in [0, 1), and `cell < count`. In plain arithmetic (15 + u)
/// / 16 rounds to 1 for u close to 1.
#[inline]
pub fn within(cell: u64, count: u64, fraction: f64) -> f64 {
    let x = (cell as f64 + fraction) / count as f64;
    // A gap of 2^-30 to the end, relative to at most 2^20 cells, is more than two
    // roundings can bridge.
    if fraction < 1.0 - 1.0 / 1_073_741_824.0 && count <= 1 << 20 {
        return x;
    }
    let end = (cell + 1) as f64 / count as f64;
    if x < end { x } else { end.next_down() }
}

/// Whether `n` is a power of `base`, and of which exponent.
pub fn logarithm(n: u64, base: u32) -> Option<u32> {
    let mut exponent = 0;
    let mut power = 1_u64;
    while power < n {
        power = power.checked_mul(u64::from(base))?;
        exponent += 1;
    }
    (power == n).then_some(exponent)
}

/// The largest k with k^d <= n.
pub fn root(n: u64, d: u32) -> u64 {
    let fits = |k: u64| k.checked_pow(d).is_some_and(|power| power <= n);
    let (mut low, mut high) = (0, n.min(u64::from(u32::MAX)) + 1);
    if d < 2 {
        return n;
    }
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if fits(middle) { low = middle } else { high = middle }
    }
    low
}

/// Whether `n` is prime.
pub fn is_prime(n: u64) -> bool {
    n > 1 && (2..n).take_while(|k| k * k <= n).all(|k| !n.is_multiple_of(k))
}

/// The first `count` primes.
pub const fn primes<const COUNT: usize>() -> [u32; COUNT] {
    let mut primes = [0; COUNT];
    let (mut found, mut candidate) = (0, 2);
    while found < COUNT {
        let (mut k, mut prime) = (0, true);
        while k < found && primes[k] * primes[k] <= candidate {
            if candidate % primes[k] == 0 {
                prime = false;
                break;
            }
            k += 1;
        }
        if prime {
            primes[found] = candidate;
            found += 1;
        }
        candidate += 1;
    }
    primes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_are_the_largest_that_are_exact() {
        assert_eq!(Radix::new(2), Radix { base: 2, digits: 53, scale: 1 << 53 });
        assert_eq!(Radix::new(3).digits, 33);
        assert_eq!(Radix::new(131).digits, 7);
        for base in 2..2000 {
            let radix = Radix::new(base);
            assert!(radix.scale <= EXACT && radix.scale > EXACT / u64::from(base));
            assert!(radix.coordinate(radix.scale - 1) < 1.0);
            assert!(radix.coordinate_with(radix.scale - 1, 1.0 - GRAIN) < 1.0);
        }
    }

    #[test]
    fn roots_and_logarithms() {
        assert_eq!(
            (root(16, 2), root(15, 2), root(27, 3), root(5, 1), root(u64::MAX, 2)),
            (4, 3, 3, 5, u64::from(u32::MAX))
        );
        assert_eq!(
            (logarithm(1, 3), logarithm(81, 3), logarithm(80, 3), logarithm(u64::MAX, 2)),
            (Some(0), Some(4), None, None)
        );
        assert_eq!(primes::<256>()[..6], [2, 3, 5, 7, 11, 13]);
        assert_eq!(primes::<256>()[255], 1619);
    }

    #[test]
    fn a_cell_is_never_left() {
        let nearly_one = 1.0 - GRAIN;
        for count in [1_u64, 3, 16, 1000, 1 << 20] {
            for cell in [0, count / 2, count - 1] {
                let x = within(cell, count, nearly_one);
                assert!(x < (cell + 1) as f64 / count as f64 && x >= cell as f64 / count as f64);
            }
        }
    }
}
