//! The kinds of experiments: what a chapter can ask to be computed. One file each, and one catalogue.
//!
//! To add a kind, write its file and add its two lines here: its module and its place in [`KINDS`]. Nothing else knows the
//! kinds by name; the checks, the key, the lists, the schema and the book find them in the catalogue. The folder `experiment`
//! holds the interface, `estimation` the running of many estimates, which several kinds share.

mod convergence;
mod estimate_table;
mod estimation;
mod experiment;
mod function;
mod histogram;
mod points;
mod running_mean;
mod van_der_corput_table;

mod bias;
mod buffon;
mod bug;
mod bug_matrix;
mod bugs;
mod coverage;
mod distribution;
mod identities;
mod importance;
mod middle_square;
mod quadrature;
mod quicksort;
mod worked_path;

pub use experiment::{AnyKind, Entries, Experiment, Failure, Frame, Kind, Measured, Outcome, Problems, Value, Values};

/// Every kind, in the order of display.
pub static KINDS: &[&dyn AnyKind] = &[
    &function::FUNCTION,
    &estimate_table::ESTIMATE_TABLE,
    &running_mean::RUNNING_MEAN,
    &histogram::HISTOGRAM,
    &convergence::CONVERGENCE,
    &points::POINTS,
    &van_der_corput_table::VAN_DER_CORPUT_TABLE,
    &distribution::DISTRIBUTION,
    &identities::IDENTITIES,
    &importance::IMPORTANCE,
    &bias::BIAS,
    &quadrature::QUADRATURE,
    &coverage::COVERAGE,
    &buffon::BUFFON,
    &middle_square::MIDDLE_SQUARE,
    &quicksort::QUICKSORT,
    &worked_path::WORKED_PATH,
    &bug::BUG,
    &bug_matrix::BUG_MATRIX,
];

/// The kind whose key is `key`.
pub fn find(key: &str) -> Option<&'static dyn AnyKind> {
    KINDS.iter().copied().find(|kind| kind.about().key == key)
}
