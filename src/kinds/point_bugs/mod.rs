//! The gallery of mistakes in placing points: small programs, each wrong and right, with the test that tells them apart.
//!
//! To add a mistake, write its file and add its two lines here: its module and its place in [`BUGS`]. The wrong program is a
//! function called `wrong` and the right one `right`, short enough to be read as listings; all that is measured of them is in
//! the [`Found`] that `run` gives, and below the line `mod drawing {` it is only drawn and put into words.

#![allow(
    clippy::unnecessary_wraps,
    reason = "every mistake has the same signature, whether its program can fail or not"
)]

mod drawing;
mod exclusive_shuffle;
mod found;
mod integer_division;
mod moves_zero;
mod net_as_sequence;
mod plain_distance;
mod raw_seeds;
mod repeated_base;
mod rounded_cell;
mod rounded_radical_inverse;
mod rounded_shift;

use crate::chart::{ChartError, Drawing, Sheet};
use crate::kinds::Failure;
use crate::seed::Seed;

pub use found::{Facts, Found, Side, empty_boxes, mean_of, placed};

/// Every mistake, in the order of display.
pub static BUGS: &[&Bug] = &[
    &integer_division::BUG,
    &exclusive_shuffle::BUG,
    &plain_distance::BUG,
    &repeated_base::BUG,
    &moves_zero::BUG,
    &net_as_sequence::BUG,
    &raw_seeds::BUG,
    &rounded_radical_inverse::BUG,
    &rounded_shift::BUG,
    &rounded_cell::BUG,
];

/// A program that places points or numbers in two forms, of which one is wrong.
pub struct Bug {
    /// Its name in chapters.
    pub key: &'static str,
    /// What is wrong, in a few words.
    pub title: &'static str,
    /// What can be chosen as `n`, if the program has such a number.
    pub n: Option<Count>,
    /// How often it can be repeated, if it is.
    pub replicates: Option<Count>,
    /// The methods of the book that it uses, by name.
    pub uses: &'static [&'static str],
    /// How much there is to compute, in placements of a point.
    pub weight: fn(&Asked) -> u64,
    /// Runs both forms and the test.
    pub run: fn(&Asked, Seed) -> Result<Found, Failure>,
    /// What was found as a figure or a table.
    pub draw: fn(&Asked, &Found, &Sheet) -> Result<Drawing, ChartError>,
    /// What was found in words.
    pub alt: fn(&Asked, &Found) -> String,
}

/// The numbers that a chapter chose; 1 where the program has no such number.
#[derive(Debug, Clone, Copy)]
pub struct Asked {
    /// How many points, or items, or cells.
    pub n: usize,
    /// How many repetitions with new random numbers.
    pub replicates: usize,
}

/// A number that a chapter can choose.
#[derive(Debug, Clone, Copy)]
pub struct Count {
    /// Where the chapter chooses none.
    pub default: usize,
    /// The least.
    pub least: usize,
    /// The most.
    pub most: usize,
    /// What else it must be.
    pub rule: Rule,
}

/// What a count must be besides within its limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rule {
    /// Nothing else.
    Any,
    /// A square.
    Square,
    /// A power of this base.
    PowerOf(usize),
}

impl Count {
    /// A number from `least` to `most`.
    pub const fn new(default: usize, least: usize, most: usize) -> Self {
        Self { default, least, most, rule: Rule::Any }
    }

    /// One that must also be a square, or a power.
    pub const fn being(self, rule: Rule) -> Self {
        Self { rule, ..self }
    }

    /// Whether `count` can be chosen.
    pub fn admits(&self, count: usize) -> bool {
        let follows = match self.rule {
            Rule::Any => true,
            Rule::Square => count.isqrt() * count.isqrt() == count,
            Rule::PowerOf(base) => {
                let powers = std::iter::successors(Some(1_usize), |power| power.checked_mul(base));
                powers.take_while(|power| *power <= count).last() == Some(count)
            }
        };
        (self.least..=self.most).contains(&count) && follows
    }

    /// What can be chosen, in words.
    pub fn words(&self) -> String {
        let what = match self.rule {
            Rule::Any => String::new(),
            Rule::Square => "a square ".to_owned(),
            Rule::PowerOf(base) => format!("a power of {base} "),
        };
        format!("{what}from {} to {}", self.least, self.most)
    }
}

/// The mistake whose key is `key`.
pub fn find(key: &str) -> Option<&'static Bug> {
    BUGS.iter().copied().find(|bug| bug.key == key)
}
