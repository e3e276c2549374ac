//! The integration tests, in one binary so that they link once.

#[cfg(feature = "publish")]
mod kinds;
#[cfg(feature = "publish")]
mod parameters;
