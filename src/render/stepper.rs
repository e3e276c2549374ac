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
    strip: Vec<KeyContext>,
}

#[derive(Serialize)]
struct KeyContext {
    step: usize,
    drawing: String,
    caption: String,
}

/// What stands below the drawing of the stepper with this id.
pub(super) fn html(id: &str, stepper: &Stepper, rendering: &Rendering<'_>, told: &mut Vec<Diagnostic>) -> String {
    let captions: Vec<String> =
        stepper.captions.iter().map(|caption| held(&table::prose(caption, rendering.converter))).collect();
    let key = |key: &'_ crate::chart::KeyStep| captions.get(key.step - 1).cloned().unwrap_or_default();
    let strip = stepper.strip.iter().map(|step| KeyContext {
        step: step.step,
        drawing: step.figure.in_a_page(),
        caption: key(step),
    });
    let strip = strip.collect();
    let context = StepperContext { id, count: captions.len(), captions, strip };
    rendering.templates.fill("stepper.html", &StepperPart { stepper: context }, told)
}

/// The words with each formula held together with the full stop or comma behind it, before which a browser would break the line.
fn held(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(start) = rest.find("<math") {
        let Some(end) = rest[start..].find("</math>").map(|at| start + at + "</math>".len()) else { break };
        out.push_str(&rest[..start]);
        let mark = rest[end..].chars().next().filter(|c| ".,:;)".contains(*c));
        let stop = end + mark.map_or(0, char::len_utf8);
        let (open, close) = if mark.is_some() { ("<span class=\"held\">", "</span>") } else { ("", "") };
        out.extend([open, &rest[start..stop], close]);
        rest = &rest[stop..];
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn punctuation_stays_with_its_formula() {
        let html = "a <math>x</math>, b <math>y</math> c <math>z</math>.";
        let span = |part: &str| format!("<span class=\"held\">{part}</span>");
        let expected = format!("a {} b <math>y</math> c {}", span("<math>x</math>,"), span("<math>z</math>."));
        assert_eq!(held(html), expected);
        assert_eq!(held("none."), "none.");
    }
}
