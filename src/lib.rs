//! Monte Carlo and quasi-Monte Carlo sampling: samplers, scrambles, integrands and statistics, each with its source.

pub mod catalogue;
#[cfg(feature = "publish")]
pub mod chart;
#[cfg(feature = "publish")]
pub mod exhibits;
pub mod integrands;
pub mod points;
pub mod samplers;
pub mod scrambles;
pub mod seed;
pub mod stats;
