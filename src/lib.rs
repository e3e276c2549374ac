//! A literate course workbook: every figure computed, every claim verified.

pub mod catalogue;
pub mod integrands;
pub mod points;
pub mod samplers;
pub mod scrambles;
pub mod seed;
pub mod stats;

#[cfg(feature = "publish")]
pub mod chart;
#[cfg(feature = "publish")]
pub mod diag;
#[cfg(feature = "publish")]
pub mod exhibits;
#[cfg(feature = "publish")]
pub mod kinds;
#[cfg(feature = "publish")]
pub mod parameters;
