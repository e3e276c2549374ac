//! Verdicts: whether what a chapter claims of its results is true.

use super::compute::{Mistake, compute, describe, unknown};
use crate::chart::number;
use crate::diag::{Code, Diagnostic, Place};
use crate::integrands::Calculation;
use crate::kinds::{Measured, Value, Values};
use crate::parameters::inside;
use crate::plan::{Amount, Bound, Exhibit, Format, Literal, Other, Settled, escape, minus};

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
            let with = match with {
                Other::Value(name) => Other::Value(name.clone()),
                Other::Number(amount) => Other::Number(number(amount)?),
            };
            Bound::Agrees { with, within: distance(within, bound, exhibit, diagnostics)? }
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

fn agrees(
    number: f64,
    standard_error: Option<f64>,
    with: &Other<Settled>,
    within: f64,
    values: &Values,
) -> Result<bool, String> {
    let other = match with {
        Other::Number(other) => other.number,
        Other::Value(name) => {
            let other = values.get(name).and_then(Measured::number);
            other.ok_or_else(|| format!("the exhibit gives no number `{name}`"))?
        }
    };
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
            Bound::Agrees { with: Other::Value(name), within } => {
                format!("within {within} standard errors of `{name}`")
            }
            Bound::Agrees { with: Other::Number(number), within } => {
                format!("within {within} standard errors of {number}")
            }
        }
    }

    /// What was claimed, as a reader sees it; what computed a number is its title.
    pub fn bound_html(&self) -> String {
        match &self.bound {
            Bound::Near { target, within } => {
                let (near, far) = (near(target, within.number), tolerance(within));
                format!("{}\u{202f}±\u{202f}{}", titled(target, &near), titled(within, &far))
            }
            Bound::Below(limit) => format!("below {}", alone(limit, self.digits())),
            Bound::Above(limit) => format!("above {}", alone(limit, self.digits())),
            Bound::Equals(Literal::Number(number) | Literal::Either(_, number)) => {
                format!("equals {}", titled(number, &telling(number.number)))
            }
            Bound::Agrees { with, within } => {
                let with = match with {
                    Other::Value(name) => format!("<code>{}</code>", escape(name)),
                    Other::Number(number) => alone(number, 5),
                };
                format!("within {} standard errors of {with}", alone(within, 5))
            }
            Bound::Equals(Literal::Text(_)) | Bound::Holds(_) => escape(&self.bound_text()),
        }
    }

    /// What was measured, as a reader sees it: as many digits as the bound and the standard error give a meaning to, and at least
    /// as many as show that the claim is true.
    pub fn measured_html(&self) -> String {
        let Value::Number(value) = self.measured.value else { return Format::Shortest.write(&self.measured) };
        if let Some(error) = self.measured.standard_error.filter(|error| *error > 0.0 && error.is_finite()) {
            return with_error(value, error);
        }
        if value.fract() == 0.0 && value.abs() < 1e15 {
            return number::integer(value as i64);
        }
        match &self.bound {
            Bound::Near { within, .. } if within.number > 0.0 && decimals(within.number) <= FINE => {
                number::fixed(value, decimals(within.number))
            }
            Bound::Near { .. } => number::significant(value, 6),
            Bound::Equals(_) => telling(value),
            _ => number::significant(value, self.digits().max(4)),
        }
    }

    /// With how many digits the value and its limit are shown, so that what is shown is true where they are.
    fn digits(&self) -> usize {
        let (Some(value), Bound::Below(limit) | Bound::Above(limit)) = (self.measured.number(), &self.bound) else {
            return 5;
        };
        let shown = |number: f64, digits: usize| format!("{number:.*e}", digits - 1).parse::<f64>().unwrap_or(number);
        let told = |digits: usize| {
            let limit_shown = if is_whole(limit) { limit.number } else { shown(limit.number, digits.max(5)) };
            let value_shown = shown(value, digits);
            value_shown.partial_cmp(&limit_shown) == value.partial_cmp(&limit.number)
        };
        (4..17).find(|&digits| told(digits)).unwrap_or(17)
    }
}

/// Whether a limit is shown with all of its digits.
fn is_whole(limit: &Settled) -> bool {
    limit.expression.is_none() || short(limit.number).is_some()
}

/// More decimals than this are hard to count.
const FINE: usize = 12;

/// A value and its standard error to two digits of the error; with one power of ten for both where they are small.
fn with_error(value: f64, error: f64) -> String {
    let both = |scale: f64, places: usize| {
        format!("{}\u{202f}±\u{202f}{}", number::fixed(value / scale, places), number::fixed(error / scale, places))
    };
    let exponent = |number: f64| number::parts(number, 2).1;
    let most = if value.abs() > error { exponent(value) } else { exponent(error) };
    match (most >= -4, decimals(error) <= FINE) {
        (true, true) => return both(1.0, decimals(error)),
        // Rounding is all that there is of an error.
        (true, false) => {
            return format!("{}\u{202f}±\u{202f}{}", number::significant(value, 5), number::scientific(error, 2));
        }
        (false, _) => {}
    }
    let scale = format!("1e{most}").parse().unwrap_or(1.0);
    format!("({})\u{202f}×\u{202f}10{}", both(scale, decimals(error / scale)), number::raised(most))
}

/// A number with as many digits as tell it from a rounder one: 4, and two more of what 4 leave out.
fn telling(value: f64) -> String {
    if let Some(text) = short(value) {
        return text;
    }
    let round = format!("{value:.3e}").parse::<f64>().unwrap_or(value);
    let rest = (value - round).abs();
    let digits = number::parts(value, 4).1 - number::parts(rest, 2).1 + 2;
    number::significant(value, usize::try_from(digits).unwrap_or(4).clamp(4, 17))
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

/// A number that stands alone: as it was written, or to at least five digits if it was computed.
fn alone(settled: &Settled, digits: usize) -> String {
    let text = match settled.expression {
        None => minus(&settled.number.to_string()),
        Some(_) => short(settled.number).unwrap_or_else(|| number::significant(settled.number, digits.max(5))),
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
mod tests;
