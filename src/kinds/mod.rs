//! The kinds of experiments: what a chapter can ask to be computed. One file each, and one catalogue.
//!
//! To add a kind, write its file and add its two lines here: its module and its place in [`KINDS`]. Nothing else knows the
//! kinds by name; the checks, the key, the lists, the schema and the book find them in the catalogue. The folder `experiment`
//! holds the interface, `estimation` the running of many estimates, which several kinds share, `imaging` the rendering of pictures, `steps` what those have in common
//! that a reader steps through.

mod bit_reversal;
mod convergence;
mod digits;
mod discrepancy;
mod enumeration;
mod estimate_table;
mod estimation;
mod experiment;
mod function;
mod guarantees;
mod histogram;
mod imaging;
mod interval_occupancy;
mod koksma_hlawka;
mod measures;
mod measuring;
mod placing;
mod points;
mod projections;
mod radical;
mod render;
mod running_mean;
mod spectral_error;
mod spectrum;
mod strata_count;
mod van_der_corput_table;
mod worst_box;

mod box_steps;
mod candidate_steps;
mod dart_steps;
mod digit_steps;
mod estimator_steps;
mod growth_steps;
mod interval_steps;
mod line_steps;
mod owen_steps;
mod padding_steps;
mod pi_steps;
mod randomisation_steps;
mod shuffle_steps;
mod steps;
mod xor_steps;

mod averaging;
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

pub use experiment::{
    AnyKind, Entries, Experiment, Failure, Frame, Kind, Measured, Outcome, Problems, Rest, Value, Values,
};

/// Every kind, in the order of display.
pub static KINDS: &[&dyn AnyKind] = &[
    &function::FUNCTION,
    &estimate_table::ESTIMATE_TABLE,
    &running_mean::RUNNING_MEAN,
    &histogram::HISTOGRAM,
    &convergence::CONVERGENCE,
    &points::POINTS,
    &projections::PROJECTIONS,
    &strata_count::STRATA_COUNT,
    &spectrum::SPECTRUM,
    &spectral_error::SPECTRAL_ERROR,
    &discrepancy::DISCREPANCY,
    &measures::MEASURES,
    &koksma_hlawka::KOKSMA_HLAWKA,
    &interval_occupancy::OCCUPANCY,
    &guarantees::GUARANTEES,
    &enumeration::ENUMERATION,
    &digits::DIGITS,
    &bit_reversal::BIT_REVERSAL,
    &van_der_corput_table::VAN_DER_CORPUT_TABLE,
    &shuffle_steps::SHUFFLE_STEPS,
    &growth_steps::GROWTH_STEPS,
    &interval_steps::INTERVAL_STEPS,
    &box_steps::BOX_STEPS,
    &randomisation_steps::RANDOMISATION_STEPS,
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
    &render::RENDER,
    &averaging::AVERAGING,
    &dart_steps::DART_STEPS,
    &candidate_steps::CANDIDATE_STEPS,
    &line_steps::LINE_STEPS,
    &estimator_steps::ESTIMATOR_STEPS,
    &pi_steps::PI_STEPS,
    &digit_steps::DIGIT_STEPS,
    &xor_steps::XOR_STEPS,
    &owen_steps::OWEN_STEPS,
    &padding_steps::PADDING_STEPS,
];

/// The kind whose key is `key`.
pub fn find(key: &str) -> Option<&'static dyn AnyKind> {
    KINDS.iter().copied().find(|kind| kind.about().key == key)
}
