//! Maximal Poisson disks: dart throwing until nothing more fits, on the torus.
//!
//! **What.** Darts fall only into the cells of a grid that are not yet covered. After each round
//! the cells that no single disk covers are cut into four; what is left shrinks until no uncovered
//! cell remains: then no further point fits anywhere.
//!
//! **Formula.** Base cells have a diagonal of at most the radius, so that each holds at most one
//! point; a cell is dropped when one disk covers its farthest corner.
//!
//! **Guarantees.** No two points are nearer on the torus than 0.65 of the largest possible
//! distance; unbiased. The disks of half the radius cover 0.547 of the torus, and the relative
//! radius tends to 0.7767.
//!
//! **Cost.** Linear in n for each run; the radius is corrected over several runs until a run ends
//! with exactly n points.
//!
//! **Limits.** Two dimensions. If eight runs miss n, the nearest larger one loses its surplus at
//! random, and is maximal no more.
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

use super::poisson::{Buckets, Place, exactly};
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

    fn admits(&self, n: usize, d: usize) -> Result<(), Refused> {
        refused::plane(n, d)
    }

    fn points(&self, n: usize, d: usize, seed: Seed) -> Result<Points, Refused> {
        self.admits(n, d)?;
        let places = exactly(n, seed, 0.7767, saturate);
        refused::points(d, places.into_flattened())
    }
}

/// The finest level of cells: what is left uncovered below it is smaller than the rounding of a
/// coordinate.
const FINEST: u32 = 40;

/// A square cell: its lower corner in units of its side.
type Cell = [u64; 2];

/// A set to which no point can be added.
pub fn saturate(radius: f64, random: &mut Random) -> Vec<Place> {
    let side = ((2.0_f64.sqrt() / radius).ceil() as u64).max(1);
    let mut buckets = Buckets::new((1.0 / radius) as usize);
    let mut cells: Vec<Cell> = (0..side * side).map(|cell| [cell % side, cell / side]).collect();
    for level in 0..FINEST {
        let count = side << level;
        // Half as many darts as cells, at least a few: the rest is left to the finer levels.
        for _ in 0..cells.len().div_ceil(2).max(8) {
            if cells.is_empty() {
                return buckets.places().to_vec();
            }
            let chosen = random.below(cells.len() as u64) as usize;
            let dart = cells[chosen].map(|corner| (corner as f64 + random.uniform()) / count as f64);
            if dart[0] < 1.0 && dart[1] < 1.0 && !buckets.any_within(dart, radius) {
                buckets.add(dart);
                cells.swap_remove(chosen);
            }
        }
        let parts = cells
            .iter()
            .flat_map(|&[x, y]| [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[right, up]| [2 * x + right, 2 * y + up]));
        cells = parts.filter(|&cell| !is_covered(&buckets, cell, count * 2, radius)).collect();
    }
    buckets.places().to_vec()
}

/// Whether the disk of the point nearest to its centre covers the whole cell, one of `count` a
/// side.
fn is_covered(buckets: &Buckets, cell: Cell, count: u64, radius: f64) -> bool {
    let side = 1.0 / count as f64;
    let centre = cell.map(|corner| (corner as f64 + 0.5) * side);
    // The disk around the nearest point reaches at least as far as any other around this centre;
    // the corner is half a diagonal away.
    let farthest = buckets.nearest(centre).sqrt() + side * 0.5_f64.sqrt();
    farthest < radius
}
