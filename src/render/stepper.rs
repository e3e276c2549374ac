//! Steppers as the template shows them: controls, a caption for each step, and a strip of key steps.

use serde::Serialize;

use super::{Rendering, table};
use crate::chart::Stepper;
use crate::diag::Diagnostic;

#[derive(Serialize)]
struct StepperPart<'a> {
    stepper: StepperContext<'a>,
}

#[derive(Serialize)]
struct StepperContext<'a> {
    id: &'a str,
    count: usize,
    captions: Vec<String>,
    strip: Vec<KeyContext<'a>>,
}

#[derive(Serialize)]
struct KeyContext<'a> {
    step: usize,
    drawing: &'a str,
    caption: String,
}

/// What stands below the drawing of the stepper with this id.
pub(super) fn html(id: &str, stepper: &Stepper, rendering: &Rendering<'_>, told: &mut Vec<Diagnostic>) -> String {
    let captions: Vec<String> =
        stepper.captions.iter().map(|caption| table::prose(&printed(caption), &rendering.converter)).collect();
    let key = |key: &'_ crate::chart::KeyStep| captions.get(key.step - 1).cloned().unwrap_or_default();
    let strip =
        stepper.strip.iter().map(|step| KeyContext { step: step.step, drawing: &step.figure.svg, caption: key(step) });
    let strip = strip.collect();
    let context = StepperContext { id, count: captions.len(), captions, strip };
    rendering.templates.fill("stepper.html", &StepperPart { stepper: context }, told)
}

/// The words with printed apostrophes, and with what binds a full stop or a comma to the formula before it; formulas as they are.
fn printed(caption: &str) -> String {
    let word = |(index, part): (usize, &str)| {
        if index % 2 == 1 {
            return part.to_owned();
        }
        let bound = index > 0 && part.starts_with(['.', ',', ':', ';', ')']);
        format!("{}{}", if bound { "\u{2060}" } else { "" }, part.replace('\'', "’"))
    };
    caption.split('$').enumerate().map(word).collect::<Vec<_>>().join("$")
}
