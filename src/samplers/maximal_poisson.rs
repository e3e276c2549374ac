//! Maximal Poisson disks: dart throwing until nothing more fits, on the torus.
//!
//! **What.** Darts fall only into the cells of a grid that are not yet covered. After each round
//! the cells that no single disk covers are cut into 2^d; what is left shrinks until no uncovered
//! cell remains: then no further point fits anywhere.
//!
//! **Formula.** Base cells have a diagonal of at most the radius, so that each holds at most one
//! point; a cell is dropped when one disk covers its farthest corner.
//!
//! **Guarantees.** No two points are nearer on the torus than 0.65 of the largest possible
//! distance; the set is maximal: no place of the torus is farther than the smallest distance of two
//! points from all of them; unbiased. In the plane the disks of half the radius cover 0.547 of the
//! torus, and the relative radius tends to 0.7767.
//!
//! **Cost.** Linear in n for each run, with a factor that grows fast with d; the radius is corrected
//! over up to nine runs until one ends with exactly n points, and then shrunk in up to 64 steps.
//!
//! **Limits.** One to four dimensions. The count of a run cannot be foreseen. If no run hits n, the
//! nearest with fewer points takes more as the radius shrinks, by less than a per cent or two, until
//! n fit and no more: the set is maximal at the final radius, and only its last points came at a
//! smaller radius than the first.
//!
//! **Paper.** M. S. Ebeida, S. A. Mitchell, A. Patney, A. A. Davidson and J. D. Owens, A Simple
//! Algorithm for Maximal Poisson-Disk Sampling in High Dimensions, Comput. Graph. Forum 31(2)
//! (2012), doi 10.1111/j.1467-8659.2012.03059.x.
//!
//! ```
//! use workbook::{samplers::{Sampler, maximal_poisson::MaximalPoisson}, seed::Seed};
//! assert_eq!(MaximalPoisson.points(100, 2, Seed::new(1))?.len(), 100);
//! # Ok::<(), workbook::samplers::Refused>(())
//! ```

use super::poisson::{self, Buckets, Place, exactly, in_dimensions};
use super::{Guarantee, Refused, Sampler, refused};
use crate::catalogue::{About, Entry, Paper};
use crate::points::Points;
use crate::seed::{Random, Seed};

/// The sampler `maximal-poisson`.
pub struct MaximalPoisson;

static ABOUT: About = About {
    key: "maximal-poisson",
    title: "Maximal Poisson disk",
    summary: "Dart throwing continued until provably no further point fits.",
    file: "samplers/maximal_poisson.rs",
    source: include_str!("maximal_poisson.rs"),
    papers: &[Paper {
        authors: "M. S. Ebeida, S. A. Mitchell, A. Patney, A. A. Davidson and J. D. Owens",
        year: 2012,
        title: "A Simple Algorithm for Maximal Poisson-Disk Sampling in High Dimensions",
        venue: "Computer Graphics Forum 31(2), 785-794",
        doi: Some("10.1111/j.1467-8659.2012.03059.x"),
    }],
};

impl Entry for MaximalPoisson {
    fn about(&self) -> &'static About {
        &ABOUT
    }
}

impl Sampler for MaximalPoisson {
    fn guarantees(&self) -> &'static [Guarantee] {
        &[Guarantee::Separated { percent: 65 }, Guarantee::Unbiased]
    }

    fn searches(&self) -> bool {
        true
    }

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        poisson::check(n, d)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        refused::points(d, in_dimensions!(d, set(n, seed))?)
    }
}

/// Exactly `n` points.
fn set<const D: usize>(n: usize, seed: Seed) -> Result<Vec<Place<D>>, Refused> {
    exactly(n, seed, 0.7767, saturate_from)
}

/// The finest level of cells: what is left uncovered below it is smaller than the rounding of a
/// coordinate.
const FINEST: u32 = 40;

/// A cubic cell: its lower corner in units of its side.
type Cell<const D: usize> = [u64; D];

/// A set of the plane to which no point can be added.
pub fn saturate(radius: f64, random: &mut Random) -> Vec<Place<2>> {
    saturate_from(&[], radius, random)
}

/// The points of `start`, and more until no point can be added.
fn saturate_from<const D: usize>(start: &[Place<D>], radius: f64, random: &mut Random) -> Vec<Place<D>> {
    let side = (((D as f64).sqrt() / radius).ceil() as u64).max(1);
    let mut buckets = Buckets::holding((1.0 / radius) as usize, start);
    let all = (0..side.pow(D as u32)).map(|cell| std::array::from_fn(|axis| cell / side.pow(axis as u32) % side));
    let mut cells: Vec<Cell<D>> =
        all.filter(|&cell| start.is_empty() || !is_covered(&buckets, cell, side, radius)).collect();
    for level in 0..FINEST {
        let count = side << level;
        // Half as many darts as cells, at least a few: the rest is left to the finer levels.
        for _ in 0..cells.len().div_ceil(2).max(8) {
            if cells.is_empty() {
                return buckets.into_places();
            }
            let chosen = random.below(cells.len() as u64) as usize;
            let dart = cells[chosen].map(|corner| (corner as f64 + random.uniform()) / count as f64);
            if dart.iter().all(|&x| x < 1.0) && !buckets.any_within(dart, radius) {
                buckets.add(dart);
                cells.swap_remove(chosen);
            }
        }
        let parts = cells.iter().flat_map(|cell| {
            (0..1 << D).map(move |part: u64| std::array::from_fn(|axis| 2 * cell[axis] + (part >> axis & 1)))
        });
        cells = parts.filter(|&cell| !is_covered(&buckets, cell, count * 2, radius)).collect();
    }
    buckets.into_places()
}

/// Whether the disk of the point nearest to its centre covers the whole cell, one of `count` a
/// side.
fn is_covered<const D: usize>(buckets: &Buckets<D>, cell: Cell<D>, count: u64, radius: f64) -> bool {
    let side = 1.0 / count as f64;
    let centre = cell.map(|corner| (corner as f64 + 0.5) * side);
    // The disk around the nearest point reaches at least as far as any other around this centre;
    // the corner is half a diagonal away.
    let farthest = buckets.nearest(centre).sqrt() + side * (0.25 * D as f64).sqrt();
    farthest < radius
}
