//! Enumeration against search.

use proptest::prelude::*;
use workbook::points::slab;
use workbook::samplers::enumeration::{self, Interval};
use workbook::samplers::{halton::PRIMES, halton::radical_inverse, sobol::sobol};

fn inside(x: f64, base: u32, interval: &Interval) -> bool {
    slab(x, (base as usize).pow(interval.digits)) as u64 == interval.cell
}

proptest! {
    /// The first indices of a Halton progression are those that a search finds.
    #[test]
    fn halton_progressions_are_what_a_search_finds(digits in (0_u32..5, 0_u32..4, 0_u32..3), cells in any::<[u64; 3]>()) {
        let digits = [digits.0, digits.1, digits.2];
        let interval = |axis: usize| Interval { axis, digits: digits[axis], cell: cells[axis] % u64::from(PRIMES[axis]).pow(digits[axis]) };
        let intervals: Vec<Interval> = (0..3).map(interval).collect();
        let found = enumeration::halton(&intervals).expect("in range");
        let fits = |i: &u64| intervals.iter().all(|interval| inside(radical_inverse(*i, PRIMES[interval.axis]), PRIMES[interval.axis], interval));
        let search: Vec<u64> = (0..3 * found.step).filter(fits).collect();
        prop_assert_eq!(search, vec![found.first, found.first + found.step, found.first + 2 * found.step]);
    }

    /// The indices of a Sobol' block are those that a search finds, in two axes or three, whatever
    /// the block.
    #[test]
    fn sobol_indices_are_what_a_search_finds(digits in prop::collection::vec(0_u32..4, 1..4), cells in any::<[u64; 3]>(), block in 0_u64..1000, m in 0_u32..9) {
        let intervals: Vec<Interval> = digits.iter().enumerate()
            .map(|(axis, &digits)| Interval { axis, digits, cell: cells[axis] % (1 << digits) })
            .collect();
        let found = enumeration::sobol(&intervals, m, block).expect("in range");
        let fits = |i: &u64| intervals.iter().all(|interval| inside(sobol(*i, interval.axis), 2, interval));
        let search: Vec<u64> = (block << m..(block + 1) << m).filter(fits).collect();
        prop_assert_eq!(found, search);
    }
}

#[test]
fn boxes_out_of_range_are_refused() {
    let interval = |axis, digits, cell| Interval { axis, digits, cell };
    assert_eq!(enumeration::halton(&[interval(256, 1, 0)]), None);
    assert_eq!(enumeration::halton(&[interval(0, 2, 4)]), None);
    assert_eq!(enumeration::halton(&[interval(0, 2, 1), interval(0, 2, 1)]), None);
    assert_eq!(enumeration::halton(&[interval(0, 60, 1)]), None);
    assert_eq!(enumeration::sobol(&[interval(256, 1, 0)], 4, 0), None);
    assert_eq!(enumeration::sobol(&[interval(0, 1, 2)], 4, 0), None);
    assert_eq!(enumeration::sobol(&[interval(0, 1, 0)], 54, 0), None);
    assert_eq!(enumeration::sobol(&[], 40, 0), None);
    assert_eq!(enumeration::sobol(&[interval(0, 1, 0)], 30, u64::MAX), None);
    // In two axes every box of 2^-m holds one index of each block of 2^m: the pixel is met once a
    // pass.
    for pass in 0..20 {
        assert_eq!(
            enumeration::sobol(&[interval(0, 5, 17), interval(1, 5, 9)], 10, pass).map(|found| found.len()),
            Some(1)
        );
    }
}
