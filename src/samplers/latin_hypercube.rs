//! Latin hypercube sampling: on every axis one point in each of n slabs.
//!
//! **What.** Each axis is cut into n slabs; each slab gets one point, and the slabs are dealt to
//! the points by a random permutation of its own for each axis, as rooks that do not attack each
//! other.
//!
//! **Formula.** x_ij = (p_j(i) + u_ij) / n, with p_j random permutations of 0..n and u_ij uniform
//! on [0, 1), all independent.
//!
//! **Guarantees.** One point in each slab of every axis; unbiased. The variance of a sum of
//! functions of one variable each falls like n^(-3); for any f it is at most n / (n - 1) times that
//! of independent points (Owen 1997).
//!
//! **Cost.** Two random numbers for each coordinate.
//!
//! **Limits.** What depends on two axes together, such as the product xy, keeps the rate n^(-1) of
//! independent points. No prefix is Latin.
//!
//! **Papers.** M. D. McKay, R. J. Beckman and W. J. Conover, Technometrics 21(2) (1979), doi
//! 10.1080/00401706.1979.10489755; in graphics, as N-rooks: P. Shirley, Discrepancy as a Quality
//! Measure for Sample Distributions, Eurographics 1991, doi 10.2312/egtp.19911013.
//!
//! ```
//! use workbook::{points::slab, samplers::{Sampler, latin_hypercube::LatinHypercube}, seed::Seed};
//! let points = LatinHypercube.points(5, 2, Seed::new(7))?;
//! let mut columns: Vec<usize> = points.axis(0).map(|x| slab(x, 5)).collect();
//! columns.sort_unstable();
//! assert_eq!(columns, [0, 1, 2, 3, 4]);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::digits::within;
use super::{Feature, Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `latin-hypercube`.
pub struct LatinHypercube;

static ABOUT: About = About {
    key: "latin-hypercube",
    title: "Latin hypercube",
    summary: "One point in each of the n slabs of every axis, dealt by a random permutation for each axis.",
    file: "samplers/latin_hypercube.rs",
    source: include_str!("latin_hypercube.rs"),
    papers: &[
        Paper {
            authors: "M. D. McKay, R. J. Beckman and W. J. Conover",
            year: 1979,
            title: "A Comparison of Three Methods for Selecting Values of Input Variables in the Analysis of Output from a Computer Code",
            venue: "Technometrics 21(2), 239-245",
            doi: Some("10.1080/00401706.1979.10489755"),
        },
        Paper {
            authors: "P. Shirley",
            year: 1991,
            title: "Discrepancy as a Quality Measure for Sample Distributions",
            venue: "Eurographics 1991, 183-194",
            doi: Some("10.2312/egtp.19911013"),
        },
    ],
};

impl Entry for LatinHypercube {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for LatinHypercube {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Latin, Guarantee::Unbiased]
    }

    fn rate(&self, feature: Feature, d: usize) -> Option<f64> {
        let additive = d == 1 || feature == Feature::Additive;
        Some(match feature {
            Feature::Edge if d == 1 => -1.0,
            _ if additive => -1.5,
            _ => -0.5,
        })
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::check(n, d, usize::MAX)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let mut coordinates = refused::allocate(n, d)?;
        for axis in 0..d {
            let column = shuffled_slabs(n, &mut seed.at(axis as u64).generator());
            for (point, x) in coordinates.chunks_exact_mut(d).zip(column) {
                point[axis] = x;
            }
        }
        refused::points(d, coordinates)
    }
}

/// One axis: a uniform number in each of `n` slabs, in random order.
pub fn shuffled_slabs(n: usize, random: &mut Random) -> Vec<f64> {
    let mut column = Vec::with_capacity(n);
    for slab in 0..n as u64 {
        column.push(within(slab, n as u64, random.uniform()));
    }
    random.shuffle(&mut column);
    column
}
