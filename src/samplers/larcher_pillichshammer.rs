//! The Larcher-Pillichshammer net.
//!
//! **What.** Beside the fractions i/n stands a digital coordinate whose matrix is full of ones
//! above and on the diagonal: every digit of the index is added to all digits up to its own.
//!
//! **Formula.** x_i = (i/n, LP(i)) with C\[r\]\[c\] = 1 for r <= c, n = 2^m.
//!
//! **Guarantees.** A (0, m, 2)-net in base 2, of lower star discrepancy than Hammersley's.
//! Deterministic.
//!
//! **Cost.** One XOR and shift for each bit of the index.
//!
//! **Limits.** n = 2^m and two dimensions. It is a *net*, not a sequence: (Phi_2(i), LP(i)) has t =
//! m - 2, and its discrepancy stalls near 1/8.
//!
//! **Paper.** G. Larcher and F. Pillichshammer, Walsh Series Analysis of the L2-Discrepancy of
//! Symmetrisized Point Sets, Monatsh. Math. 132 (2001), doi 10.1007/s006050170054; in graphics: T.
//! Kollig and A. Keller (2002), doi 10.1111/1467-8659.00706.
//!
//! ```
//! use workbook::samplers::larcher_pillichshammer::ones;
//! assert_eq!([ones(0), ones(1), ones(2), ones(3)].map(|v| v >> 51), [0, 0b10, 0b11, 0b01]);
//! ```

use super::digits::logarithm;
use super::{Digital, Digits, Feature, Guarantee, Net, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};

/// The sampler `larcher-pillichshammer`.
pub struct LarcherPillichshammer;

static ABOUT: About = About {
    key: "larcher-pillichshammer",
    title: "Larcher-Pillichshammer",
    summary: "A binary net of two dimensions with the matrix full of ones: low discrepancy for n = 2^m.",
    file: "samplers/larcher_pillichshammer.rs",
    source: include_str!("larcher_pillichshammer.rs"),
    papers: &[
        Paper {
            authors: "G. Larcher and F. Pillichshammer",
            year: 2001,
            title: "Walsh Series Analysis of the L2-Discrepancy of Symmetrisized Point Sets",
            venue: "Monatshefte für Mathematik 132, 1-18",
            doi: Some("10.1007/s006050170054"),
        },
        Paper {
            authors: "T. Kollig and A. Keller",
            year: 2002,
            title: "Efficient Multidimensional Sampling",
            venue: "Computer Graphics Forum 21(3), 557-563",
            doi: Some("10.1111/1467-8659.00706"),
        },
    ],
};

impl Entry for LarcherPillichshammer {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for LarcherPillichshammer {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Whole, Guarantee::Deterministic]
    }

    fn rate(&self, feature: Feature, _d: usize) -> Option<f64> {
        // By the inequality of Koksma and Hlawka.
        (feature != Feature::Edge).then_some(-1.0)
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, 2)?;
        if n.is_power_of_two() {
            return Ok(());
        }
        let above = n.checked_next_power_of_two();
        Err(Refused::Count { n, below: above.map(|above| above / 2), above, rule: "a power of 2" })
    }

    fn whole_net(&self, _n: usize, _d: usize) -> Option<Net> {
        Some(Net { base: 2, t: 0 })
    }

    fn digits(&self) -> Digits {
        Digits::Binary
    }

    fn digital(&self, n: usize, _d: usize) -> Option<Box<dyn Digital>> {
        logarithm(n as u64, 2).map(|m| Box::new(Set { m }) as Box<dyn Digital>)
    }
}

/// The digits of a set of 2^m points.
struct Set {
    m: u32,
}

impl Digital for Set {
    fn numerator(&self, index: u64, axis: usize) -> u64 {
        if axis == 0 { index << (53 - self.m) } else { ones(index) }
    }
}

/// The 53 digits, as a whole number, of the second coordinate: bit c of the index flips the digits
/// 0 to c.
pub fn ones(index: u64) -> u64 {
    let (mut rest, mut column, mut digits) = (index, 1 << 52, 0);
    while rest > 0 {
        if rest & 1 == 1 {
            digits ^= column;
        }
        column |= column >> 1;
        rest >>= 1;
    }
    digits
}
