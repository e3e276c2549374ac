//! Exhibits: what a reader sees of an experiment.

pub use crate::chart::{Align, Cell, Column, Drawing, Figure, Table};
