//! Monte Carlo and quasi-Monte Carlo sampling: samplers, scrambles, integrands and statistics, each with its source.

pub mod catalogue;
pub mod integrands;
pub mod metrics;
pub mod points;
pub mod samplers;
pub mod scrambles;
pub mod seed;
pub mod stats;
