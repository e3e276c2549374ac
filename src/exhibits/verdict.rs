//! Verdicts: whether what a chapter claims of its results is true.

use crate::catalogue::nearest;
use crate::chart::number;
use crate::diag::{Code, Diagnostic, Place};
use crate::kinds::{Measured, Value, Values};
use crate::plan::{Bound, Claim, Exhibit, Format, Literal, escape, minus};

/// Whether one bound holds of one value.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// The value's name.
    pub value: String,
    /// The claim that it belongs to: its index among the exhibit's claims, and that of the bound among the claim's.
    pub claim: (usize, usize),
    /// What was measured.
    pub measured: Measured,
    /// What was claimed of it.
    pub bound: Bound,
    /// Whether it is true.
    pub holds: bool,
}

/// Judges every claim of an exhibit; a false one, and one of a value that is not there, are told.
pub(super) fn judge(exhibit: &Exhibit, values: &Values, diagnostics: &mut Vec<Diagnostic>) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    for (index, claim) in exhibit.claims.iter().enumerate() {
        let place = Place { file: exhibit.place.file.clone(), range: claim.range.clone() };
        let matching: Vec<(&str, &Measured)> = values.iter().filter(|(name, _)| fits(&claim.value, name)).collect();
        if matching.is_empty() {
            diagnostics.push(no_value(exhibit, claim, values, &place));
        }
        for (name, measured) in matching {
            for (which, bound) in claim.bounds.iter().enumerate() {
                let holds = match holds(bound, measured, values) {
                    Ok(holds) => holds,
                    Err(message) => {
                        diagnostics.push(Diagnostic::error(Code::BadClaim, message).at_place(&place));
                        continue;
                    }
                };
                let (value, measured, bound) = (name.to_owned(), measured.clone(), bound.clone());
                let verdict = Verdict { value, claim: (index, which), measured, bound, holds };
                if !holds {
                    diagnostics.push(false_claim(exhibit, &verdict, &place));
                }
                verdicts.push(verdict);
            }
        }
    }
    verdicts
}

/// Whether `name` is what `pattern` says, where `*` stands for any text.
fn fits(pattern: &str, name: &str) -> bool {
    match pattern.split_once('*') {
        None => pattern == name,
        Some((head, tail)) => name.strip_prefix(head).is_some_and(|rest| {
            (0..=rest.len()).filter(|&at| rest.is_char_boundary(at)).any(|at| fits(tail, &rest[at..]))
        }),
    }
}

/// Whether a bound holds; an error if it cannot be said of such a value.
fn holds(bound: &Bound, measured: &Measured, values: &Values) -> Result<bool, String> {
    match (bound, &measured.value) {
        (Bound::Holds(expected), Value::Boolean(truth)) => return Ok(expected == truth),
        (Bound::Equals(Literal::Text(expected)), Value::Text(text)) => return Ok(expected == text),
        _ => {}
    }
    let Some(number) = measured.number() else {
        return Err(format!("the value is {}, of which this cannot be claimed", describe(&measured.value)));
    };
    match bound {
        Bound::Near { target, within } => Ok((number - target).abs() <= *within),
        Bound::Below(limit) => Ok(number < *limit),
        Bound::Above(limit) => Ok(number > *limit),
        Bound::Equals(Literal::Number(expected)) => Ok(number == *expected),
        Bound::Agrees { with, within } => agrees(number, measured.standard_error, with, *within, values),
        Bound::Equals(Literal::Text(_)) | Bound::Holds(_) => {
            Err(format!("the value is {}, of which this cannot be claimed", describe(&measured.value)))
        }
    }
}

fn agrees(number: f64, standard_error: Option<f64>, with: &str, within: f64, values: &Values) -> Result<bool, String> {
    let other =
        values.get(with).and_then(Measured::number).ok_or_else(|| format!("the exhibit gives no number `{with}`"))?;
    let error = standard_error.ok_or("the value has no standard error, so `agrees` says nothing; use `near`")?;
    Ok((number - other).abs() <= within * error)
}

fn describe(value: &Value) -> &'static str {
    match value {
        Value::Number(_) | Value::Integer(_) => "a number",
        Value::Boolean(_) => "a truth value",
        Value::Text(_) => "a text",
    }
}

fn no_value(exhibit: &Exhibit, claim: &Claim, values: &Values, place: &Place) -> Diagnostic {
    let near = nearest(&claim.value, values.names()).map(|near| format!("did you mean `{near}`?"));
    Diagnostic::error(Code::UnknownValue, format!("`{}` gives no value `{}`", exhibit.id, claim.value))
        .at_place(place)
        .help_if(near)
        .help(format!("`workbook run {}` lists its values", exhibit.id))
}

fn false_claim(exhibit: &Exhibit, verdict: &Verdict, place: &Place) -> Diagnostic {
    let measured = Format::Shortest.write(&verdict.measured);
    let error = verdict.measured.standard_error.map(|error| format!(" (standard error {error})")).unwrap_or_default();
    Diagnostic::error(
        Code::FalseClaim,
        format!("a claim of `{}` is false: `{}` is {measured}{error}", exhibit.id, verdict.value),
    )
    .at_place(place)
    .label(format!("claimed: {}", verdict.bound_text()))
    .help("if the result is right, correct the claim and the prose around it; else mend what computes it")
}

impl Verdict {
    /// What was claimed, as plain text, e.g. `near -0.5, within 0.05`.
    pub fn bound_text(&self) -> String {
        match &self.bound {
            Bound::Near { target, within } => format!("near {target}, within {within}"),
            Bound::Below(limit) => format!("below {limit}"),
            Bound::Above(limit) => format!("above {limit}"),
            Bound::Equals(Literal::Number(number)) => format!("equals {number}"),
            Bound::Equals(Literal::Text(text)) => format!("equals {text}"),
            Bound::Holds(true) => "holds".to_owned(),
            Bound::Holds(false) => "does not hold".to_owned(),
            Bound::Agrees { with, within } => format!("within {within} standard errors of `{with}`"),
        }
    }

    /// What was claimed, as a reader sees it.
    pub fn bound_html(&self) -> String {
        match &self.bound {
            Bound::Near { target, within } => {
                format!("{}\u{202f}±\u{202f}{}", plain(*target, *within), plain(*within, *within))
            }
            Bound::Agrees { with, within } => {
                format!("within {within} standard errors of <code>{}</code>", escape(with))
            }
            _ => minus(&escape(&self.bound_text())),
        }
    }

    /// What was measured, as a reader sees it: as many digits as the bound and the standard error give a meaning to.
    pub fn measured_html(&self) -> String {
        let format = match (&self.measured.value, self.measured.standard_error, &self.bound) {
            (Value::Number(_), Some(error), _) if error > 0.0 && error.is_finite() => {
                Format::WithError(decimals(error))
            }
            (Value::Number(_), _, Bound::Near { within, .. }) if *within > 0.0 => Format::Decimals(decimals(*within)),
            (Value::Number(_), _, _) => Format::Significant(4),
            _ => Format::Shortest,
        };
        format.write(&self.measured)
    }
}

/// A number of a claim: as it was written where that is short, else to the digits that the tolerance gives a meaning to.
fn plain(value: f64, within: f64) -> String {
    let text = value.to_string();
    match text.len() {
        0..=8 => minus(&text),
        _ if value == within => number::scientific(value, 1),
        _ => number::fixed(value, decimals(within)),
    }
}

/// The decimals that show two digits of a standard error or a tolerance.
fn decimals(error: f64) -> usize {
    let text = format!("{error:.1e}");
    let exponent: i32 = text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    usize::try_from(1 - exponent).unwrap_or(0).min(15)
}

#[cfg(test)]
mod tests {
    use super::{agrees, decimals, fits, holds};
    use crate::kinds::{Measured, Value, Values};
    use crate::plan::{Bound, Literal};

    fn number(number: f64) -> Measured {
        Measured { value: Value::Number(number), standard_error: None }
    }

    #[test]
    fn a_star_stands_for_any_part_of_a_name() {
        assert!(fits("rmse.*.64", "rmse.sobol+xor.64"));
        assert!(!fits("rmse.*.64", "rmse.sobol+xor.640"));
        assert!(fits("*", "anything") && fits("a*b*c", "aXbYc") && !fits("a*b*c", "acb"));
    }

    #[test]
    fn bounds_include_their_limit_only_where_they_say_so() {
        let values = Values::new();
        let near = Bound::Near { target: 0.5, within: 0.25 };
        assert_eq!(holds(&near, &number(0.75), &values), Ok(true));
        assert_eq!(holds(&near, &number(0.76), &values), Ok(false));
        assert_eq!(holds(&Bound::Below(1.0), &number(1.0), &values), Ok(false));
        assert_eq!(holds(&Bound::Above(1.0), &number(f64::NAN), &values), Ok(false));
        assert_eq!(holds(&near, &number(f64::NAN), &values), Ok(false));
        assert_eq!(holds(&Bound::Equals(Literal::Number(2.0)), &number(2.0), &values), Ok(true));
        assert!(holds(&Bound::Holds(true), &number(1.0), &values).is_err());
    }

    #[test]
    fn agreement_needs_a_standard_error_and_another_value() {
        let mut values = Values::new();
        values.number("exact", 1.0);
        assert_eq!(agrees(1.3, Some(0.1), "exact", 4.0, &values), Ok(true));
        assert_eq!(agrees(1.5, Some(0.1), "exact", 4.0, &values), Ok(false));
        assert!(agrees(1.0, None, "exact", 4.0, &values).is_err());
        assert!(agrees(1.0, Some(0.1), "exakt", 4.0, &values).is_err());
    }

    #[test]
    fn two_digits_of_an_error_are_shown() {
        assert_eq!((decimals(0.012), decimals(1.5), decimals(250.0)), (3, 1, 0));
    }
}
