//! Verdicts: whether what a chapter claims of its results is true.

use super::compute::{Mistake, compute, describe, unknown};
use crate::chart::number;
use crate::diag::{Code, Diagnostic, Place};
use crate::integrands::Calculation;
use crate::kinds::{Measured, Value, Values};
use crate::parameters::inside;
use crate::plan::{Amount, Bound, Exhibit, Format, Literal, Settled, escape, minus};

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
    pub bound: Bound<Settled>,
    /// Whether it is true.
    pub holds: bool,
}

/// The values of an exhibit that is there.
type Lookup<'l, 'v> = &'l dyn Fn(&str) -> Option<&'v Values>;

/// Judges every claim of an exhibit; a false one, and one of a value that is not there, are told. `all` has the values of the others.
pub(super) fn judge(
    exhibit: &Exhibit,
    values: &Values,
    all: Lookup<'_, '_>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Verdict> {
    let mut verdicts = Vec::new();
    for (index, claim) in exhibit.claims.iter().enumerate() {
        let place = Place { file: exhibit.place.file.clone(), range: claim.range.clone() };
        let matching: Vec<(&str, &Measured)> = values.iter().filter(|(name, _)| fits(&claim.value, name)).collect();
        if matching.is_empty() {
            diagnostics.push(unknown(&exhibit.id, &claim.value, values).at_place(&place));
        }
        let texts = matching.iter().all(|(_, measured)| measured.number().is_none());
        let bounds: Vec<_> = claim.bounds.iter().map(|bound| settle(bound, texts, exhibit, all, diagnostics)).collect();
        for (name, measured) in matching {
            for (which, bound) in bounds.iter().enumerate() {
                let Some(bound) = bound.as_ref().map(|bound| narrowed(bound, measured)) else { continue };
                let holds = match holds(&bound, measured, values) {
                    Ok(holds) => holds,
                    Err(message) => {
                        diagnostics.push(Diagnostic::error(Code::BadClaim, message).at_place(&place));
                        continue;
                    }
                };
                let (value, measured) = (name.to_owned(), measured.clone());
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

/// The bound with its numbers; none if one of them cannot be had, which is told. If all values are `texts`, so is what they should equal.
fn settle(
    bound: &Bound,
    texts: bool,
    exhibit: &Exhibit,
    all: Lookup<'_, '_>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Bound<Settled>> {
    let mut number = |amount: &Amount| amount_of(amount, exhibit, all, diagnostics);
    Some(match bound {
        Bound::Near { target, within } => {
            let (target, within) = (number(target), number(within));
            Bound::Near { target: target?, within: distance(within?, bound, exhibit, diagnostics)? }
        }
        Bound::Below(limit) => Bound::Below(number(limit)?),
        Bound::Above(limit) => Bound::Above(number(limit)?),
        Bound::Equals(Literal::Number(expected)) => Bound::Equals(Literal::Number(number(expected)?)),
        Bound::Equals(Literal::Either(text, expected)) if !texts => {
            Bound::Equals(Literal::Either(text.clone(), number(expected)?))
        }
        Bound::Equals(Literal::Text(text) | Literal::Either(text, _)) => Bound::Equals(Literal::Text(text.clone())),
        Bound::Holds(expected) => Bound::Holds(*expected),
        Bound::Agrees { with, within } => {
            let within = number(within)?;
            Bound::Agrees { with: with.clone(), within: distance(within, bound, exhibit, diagnostics)? }
        }
    })
}

/// The number of a claim.
fn amount_of(
    amount: &Amount,
    exhibit: &Exhibit,
    all: Lookup<'_, '_>,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<Settled> {
    let (calculation, place) = match amount {
        Amount::Number(number) => return Some(Settled { number: *number, expression: None }),
        Amount::Computed { calculation, place } => (calculation, place),
    };
    match compute(calculation, Some(&exhibit.id), all) {
        Ok(number) => Some(Settled { number, expression: Some(calculation.text().to_owned()) }),
        Err(mistakes) => {
            let at = |mistake: Mistake| {
                let range = inside(calculation.text(), place, &mistake.range);
                mistake.error.at(&exhibit.place.file, range)
            };
            diagnostics.extend(mistakes.into_iter().map(at));
            None
        }
    }
}

/// A tolerance, which is told if it is negative.
fn distance(within: Settled, bound: &Bound, exhibit: &Exhibit, diagnostics: &mut Vec<Diagnostic>) -> Option<Settled> {
    if within.number >= 0.0 {
        return Some(within);
    }
    let message = format!("`within` is a distance: it cannot be negative, and it is {within}");
    let error = Diagnostic::error(Code::OutOfRange, message);
    diagnostics.push(match bound.amounts().last() {
        Some(Amount::Computed { place, .. }) => error.at(&exhibit.place.file, place.clone()),
        _ => error.at_place(&exhibit.place),
    });
    None
}

/// The bound as it is meant of this value: what a text should equal is a text, what a number should equal is a number.
fn narrowed(bound: &Bound<Settled>, measured: &Measured) -> Bound<Settled> {
    match bound {
        Bound::Equals(Literal::Either(text, number)) => Bound::Equals(match measured.value {
            Value::Text(_) => Literal::Text(text.clone()),
            _ => Literal::Number(number.clone()),
        }),
        plain => plain.clone(),
    }
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
fn holds(bound: &Bound<Settled>, measured: &Measured, values: &Values) -> Result<bool, String> {
    match (bound, &measured.value) {
        (Bound::Holds(expected), Value::Boolean(truth)) => return Ok(expected == truth),
        (Bound::Equals(Literal::Text(expected)), Value::Text(text)) => return Ok(expected == text),
        _ => {}
    }
    let refused = || format!("the value is {}, of which this cannot be claimed", describe(&measured.value));
    let Some(number) = measured.number() else { return Err(refused()) };
    match bound {
        Bound::Near { target, within } => Ok((number - target.number).abs() <= within.number),
        Bound::Below(limit) => Ok(number < limit.number),
        Bound::Above(limit) => Ok(number > limit.number),
        Bound::Equals(Literal::Number(expected) | Literal::Either(_, expected)) => Ok(number == expected.number),
        Bound::Agrees { with, within } => agrees(number, measured.standard_error, with, within.number, values),
        Bound::Equals(Literal::Text(text)) => Err(match Calculation::parse(text) {
            Err(error) => format!("the value is a number, and `{text}` gives none: {error}"),
            Ok(_) => refused(),
        }),
        Bound::Holds(_) => Err(refused()),
    }
}

fn agrees(number: f64, standard_error: Option<f64>, with: &str, within: f64, values: &Values) -> Result<bool, String> {
    let other =
        values.get(with).and_then(Measured::number).ok_or_else(|| format!("the exhibit gives no number `{with}`"))?;
    let error = standard_error.ok_or("the value has no standard error, so `agrees` says nothing; use `near`")?;
    Ok((number - other).abs() <= within * error)
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
    /// What was claimed, as plain text, e.g. `near -0.5, within 0.05`; what computed a number stands behind it.
    pub fn bound_text(&self) -> String {
        match &self.bound {
            Bound::Near { target, within } => format!("near {target}, within {within}"),
            Bound::Below(limit) => format!("below {limit}"),
            Bound::Above(limit) => format!("above {limit}"),
            Bound::Equals(Literal::Number(number) | Literal::Either(_, number)) => format!("equals {number}"),
            Bound::Equals(Literal::Text(text)) => format!("equals {text}"),
            Bound::Holds(true) => "holds".to_owned(),
            Bound::Holds(false) => "does not hold".to_owned(),
            Bound::Agrees { with, within } => format!("within {within} standard errors of `{with}`"),
        }
    }

    /// What was claimed, as a reader sees it; what computed a number is its title.
    pub fn bound_html(&self) -> String {
        match &self.bound {
            Bound::Near { target, within } => {
                let (near, far) = (near(target, within.number), tolerance(within));
                format!("{}\u{202f}±\u{202f}{}", titled(target, &near), titled(within, &far))
            }
            Bound::Below(limit) => format!("below {}", alone(limit)),
            Bound::Above(limit) => format!("above {}", alone(limit)),
            Bound::Equals(Literal::Number(number) | Literal::Either(_, number)) => format!("equals {}", alone(number)),
            Bound::Agrees { with, within } => {
                format!("within {} standard errors of <code>{}</code>", alone(within), escape(with))
            }
            Bound::Equals(Literal::Text(_)) | Bound::Holds(_) => escape(&self.bound_text()),
        }
    }

    /// What was measured, as a reader sees it: as many digits as the bound and the standard error give a meaning to.
    pub fn measured_html(&self) -> String {
        let format = match (&self.measured.value, self.measured.standard_error, &self.bound) {
            (Value::Number(_), Some(error), _) if error > 0.0 && error.is_finite() => {
                Format::WithError(decimals(error))
            }
            (Value::Number(_), _, Bound::Near { within, .. }) if within.number > 0.0 => {
                Format::Decimals(decimals(within.number))
            }
            (Value::Number(_), _, _) => Format::Significant(4),
            _ => Format::Shortest,
        };
        format.write(&self.measured)
    }
}

/// The longest number that is shown as it is.
const SHORT: usize = 8;

/// A number as it is, if that is short.
fn short(number: f64) -> Option<String> {
    let text = number.to_string();
    (text.len() <= SHORT).then(|| minus(&text))
}

/// What a value should be near: to the digits that the tolerance gives a meaning to.
fn near(target: &Settled, within: f64) -> String {
    short(target.number).unwrap_or_else(|| number::fixed(target.number, decimals(within)))
}

/// A tolerance: to one digit as it was written, to two if it was computed.
fn tolerance(within: &Settled) -> String {
    short(within.number).unwrap_or_else(|| match within.expression {
        None => number::scientific(within.number, 1),
        Some(_) => number::significant(within.number, 2),
    })
}

/// A number that stands alone: as it was written, or to some digits if it was computed.
fn alone(settled: &Settled) -> String {
    let text = match settled.expression {
        None => minus(&settled.number.to_string()),
        Some(_) => short(settled.number).unwrap_or_else(|| number::significant(settled.number, 5)),
    };
    titled(settled, &text)
}

/// The `text` of a number, with what computed it.
fn titled(settled: &Settled, text: &str) -> String {
    match &settled.expression {
        None => text.to_owned(),
        Some(expression) => format!("<span title=\"{}\">{text}</span>", escape(expression)),
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
    use crate::plan::{Bound, Literal, Settled};

    fn number(number: f64) -> Measured {
        Measured { value: Value::Number(number), standard_error: None }
    }

    fn settled(number: f64) -> Settled {
        Settled { number, expression: None }
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
        let near = Bound::Near { target: settled(0.5), within: settled(0.25) };
        assert_eq!(holds(&near, &number(0.75), &values), Ok(true));
        assert_eq!(holds(&near, &number(0.76), &values), Ok(false));
        assert_eq!(holds(&Bound::Below(settled(1.0)), &number(1.0), &values), Ok(false));
        assert_eq!(holds(&Bound::Above(settled(1.0)), &number(f64::NAN), &values), Ok(false));
        assert_eq!(holds(&near, &number(f64::NAN), &values), Ok(false));
        assert_eq!(holds(&Bound::Equals(Literal::Number(settled(2.0))), &number(2.0), &values), Ok(true));
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
