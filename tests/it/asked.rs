//! Experiments by their fences, and the numbers that they give.

use crate::parameters::plan;
use workbook::kinds::{Experiment, Measured, Outcome, Value};
use workbook::seed::Seed;

/// The experiment that a fence asks for.
pub fn planned(fence: &str) -> Box<dyn Experiment> {
    plan(fence).unwrap_or_else(|complaints| panic!("{fence}: {complaints:#?}"))
}

/// What a fence's experiment gives for a seed.
pub fn seeded(fence: &str, seed: u64) -> Outcome {
    planned(fence).run(Seed::new(seed)).unwrap_or_else(|failure| panic!("{fence}: {failure:?}"))
}

/// What a fence's experiment gives.
pub fn outcome(fence: &str) -> Outcome {
    seeded(fence, 1)
}

/// The value called `name`.
pub fn measured<'a>(outcome: &'a Outcome, name: &str) -> &'a Measured {
    let names = || outcome.values.names().collect::<Vec<_>>();
    outcome.values.get(name).unwrap_or_else(|| panic!("no {name} among {:?}", names()))
}

/// The value called `name`, a number.
pub fn number(outcome: &Outcome, name: &str) -> f64 {
    let measured = measured(outcome, name);
    measured.number().unwrap_or_else(|| panic!("{name} is {measured:?}"))
}

/// The standard error of the value called `name`.
pub fn error(outcome: &Outcome, name: &str) -> f64 {
    measured(outcome, name).standard_error.unwrap_or_else(|| panic!("{name} has no standard error"))
}

/// The value called `name`, in standard errors off `expected`.
pub fn z(outcome: &Outcome, name: &str, expected: f64) -> f64 {
    (number(outcome, name) - expected) / error(outcome, name)
}

/// The truth called `name`.
pub fn holds(outcome: &Outcome, name: &str) -> bool {
    match measured(outcome, name).value {
        Value::Boolean(truth) => truth,
        ref other => panic!("{name} is {other:?}"),
    }
}
