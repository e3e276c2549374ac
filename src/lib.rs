//! A literate course workbook.

pub mod catalogue;
#[cfg(feature = "publish")]
pub mod diag;
#[cfg(feature = "publish")]
pub mod run;
