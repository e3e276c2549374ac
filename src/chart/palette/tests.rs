//! Contrast and distinguishability.
