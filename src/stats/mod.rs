//! Statistics of experiments: portable functions, moments, quadrature, regression, the normal law,
//! histograms, spectra.

pub mod fourier;
pub mod histogram;
pub mod inference;
pub mod moments;
pub mod normal;
pub mod portable;
pub mod quadrature;
pub mod regression;
