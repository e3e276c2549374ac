//! The kinds of experiments: what a chapter can ask to be computed. One file each, and one catalogue.
//!
//! To add a kind, write its file and add its two lines here: its module and its place in [`KINDS`]. Nothing else knows the
//! kinds by name; the checks, the key, the lists, the schema and the book find them in the catalogue. The folder `experiment`
//! holds the interface. What several kinds share: `estimation` runs many estimates, `placing` and `measuring` make and measure
//! point sets, `radical` has digits, `worst_box` the extremal box, `imaging` renders, `bugs` is the catalogue of planted bugs,
//! `point_bugs` that of mistakes in placing points, and `steps` is what the kinds have in common that a reader steps through.

mod averaging;
mod bias;
mod bit_reversal;
mod box_steps;
mod buffon;
mod bug;
mod bug_matrix;
mod bugs;
mod candidate_steps;
mod convergence;
mod coverage;
mod dart_steps;
mod digit_steps;
mod digits;
mod discrepancy;
mod distribution;
mod enumeration;
mod estimate_table;
mod estimation;
mod estimator_steps;
mod experiment;
mod function;
mod growth_steps;
mod guarantees;
mod histogram;
mod identities;
mod imaging;
mod importance;
mod interval_occupancy;
mod interval_steps;
mod koksma_hlawka;
mod line_steps;
mod measures;
mod measuring;
mod middle_square;
mod owen_steps;
mod padding_steps;
mod pi_steps;
mod placing;
mod point_bug;
mod point_bugs;
mod points;
mod projections;
mod quadrature;
mod quicksort;
mod radical;
mod randomisation_steps;
mod render;
mod running_mean;
mod shuffle_steps;
mod spectral_error;
mod spectrum;
mod steps;
mod strata_count;
mod surface;
mod van_der_corput_table;
mod worked_path;
mod worst_box;
mod xor_steps;

pub use experiment::{
    AnyKind, Entries, Experiment, Failure, Frame, Halt, Kind, Measured, Outcome, Problems, Rest, Value, Values, piece,
};
pub use measuring::quantity;

/// Every kind, in the order of display.
pub static KINDS: &[&dyn AnyKind] = &[
    &function::FUNCTION,
    &surface::SURFACE,
    &distribution::DISTRIBUTION,
    &identities::IDENTITIES,
    &estimate_table::ESTIMATE_TABLE,
    &estimator_steps::ESTIMATOR_STEPS,
    &running_mean::RUNNING_MEAN,
    &histogram::HISTOGRAM,
    &convergence::CONVERGENCE,
    &importance::IMPORTANCE,
    &bias::BIAS,
    &quadrature::QUADRATURE,
    &coverage::COVERAGE,
    &averaging::AVERAGING,
    &buffon::BUFFON,
    &pi_steps::PI_STEPS,
    &middle_square::MIDDLE_SQUARE,
    &quicksort::QUICKSORT,
    &points::POINTS,
    &projections::PROJECTIONS,
    &strata_count::STRATA_COUNT,
    &guarantees::GUARANTEES,
    &padding_steps::PADDING_STEPS,
    &shuffle_steps::SHUFFLE_STEPS,
    &growth_steps::GROWTH_STEPS,
    &dart_steps::DART_STEPS,
    &candidate_steps::CANDIDATE_STEPS,
    &spectrum::SPECTRUM,
    &spectral_error::SPECTRAL_ERROR,
    &discrepancy::DISCREPANCY,
    &measures::MEASURES,
    &box_steps::BOX_STEPS,
    &koksma_hlawka::KOKSMA_HLAWKA,
    &interval_occupancy::OCCUPANCY,
    &interval_steps::INTERVAL_STEPS,
    &enumeration::ENUMERATION,
    &digits::DIGITS,
    &van_der_corput_table::VAN_DER_CORPUT_TABLE,
    &bit_reversal::BIT_REVERSAL,
    &digit_steps::DIGIT_STEPS,
    &line_steps::LINE_STEPS,
    &randomisation_steps::RANDOMISATION_STEPS,
    &xor_steps::XOR_STEPS,
    &owen_steps::OWEN_STEPS,
    &render::RENDER,
    &worked_path::WORKED_PATH,
    &bug::BUG,
    &bug_matrix::BUG_MATRIX,
    &point_bug::POINT_BUG,
];

/// The kind whose key is `key`.
pub fn find(key: &str) -> Option<&'static dyn AnyKind> {
    KINDS.iter().copied().find(|kind| kind.about().key == key)
}
