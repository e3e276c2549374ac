//! The worst box: where the star discrepancy of a point set is attained, with what it holds.

use serde::{Deserialize, Serialize};

use super::experiment::Failure;
use super::placing::unmeasured;
use crate::chart::number::significant;
use crate::metrics::star;
use crate::points::Points;
use crate::samplers::Method;

/// The box at the origin where the star discrepancy is attained.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorstBox {
    /// The difference between its share of the points and its volume.
    pub discrepancy: f64,
    /// Its upper corner.
    pub corner: Vec<f64>,
    /// Points in it, with its upper faces where it has too many, without them where it has too few.
    pub count: u32,
    /// Its volume.
    pub volume: f64,
}

impl WorstBox {
    /// The worst box of `points`, which `method` placed.
    pub fn of(method: &Method, points: &Points) -> Result<Self, Failure> {
        let measured = star::star_discrepancy(points).map_err(|error| unmeasured(method, &error))?;
        let corner = measured.extremal;
        let volume = corner.iter().product::<f64>();
        let inside = |closed: bool| {
            let within = |(&x, &edge): (&f64, &f64)| x < edge || (closed && x == edge);
            points.rows().filter(|row| row.iter().zip(&corner).all(within)).count()
        };
        // Of the two counts the one that is further off is the one of the discrepancy.
        let off = |count: usize| (count as f64 / points.len() as f64 - volume).abs();
        let (open, closed) = (inside(false), inside(true));
        let count = if off(closed) >= off(open) { closed } else { open };
        Ok(Self { discrepancy: measured.value, corner, count: count as u32, volume })
    }

    /// The upper corner in the unit square, the whole height where there is one axis only.
    pub fn corner_in_the_plane(&self) -> (f64, f64) {
        let edge = |axis: usize| self.corner.get(axis).copied().unwrap_or(1.0);
        (edge(0), edge(1))
    }

    /// What it is, among `n` points.
    pub fn words(&self, n: usize) -> String {
        let corner: Vec<String> = self.corner.iter().map(|&edge| significant(edge, 3)).collect();
        format!(
            "the worst box reaches to ({}), holds {} of {n} points and has the volume {}: discrepancy {}",
            corner.join(", "),
            self.count,
            significant(self.volume, 3),
            significant(self.discrepancy, 3)
        )
    }
}
