//! Numbers that expressions give, once the values are there that they name.

use std::ops::Range;

use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic};
use crate::integrands::Calculation;
use crate::kinds::{Measured, Value, Values};
use crate::plan::address;

/// What is wrong with an expression, and at which of its bytes.
pub(super) struct Mistake {
    pub(super) range: Range<usize>,
    pub(super) error: Diagnostic,
}

/// The number that `calculation` gives; names without an exhibit are values of `home`, and `values` has those of each exhibit that is
/// there. No number and no mistake: what it needs is not there, which has been told.
pub(super) fn compute<'v>(
    calculation: &Calculation,
    home: Option<&str>,
    values: &dyn Fn(&str) -> Option<&'v Values>,
) -> Result<f64, Vec<Mistake>> {
    let names = calculation.names();
    let count = names.len();
    let (mut numbers, mut mistakes) = (Vec::with_capacity(count), Vec::new());
    for (name, range) in names {
        let Some((exhibit, value)) = address(name, home) else { continue };
        let Some(values) = values(exhibit) else { continue };
        match values.get(value).map(|measured| (measured.number(), measured)) {
            Some((Some(number), _)) => numbers.push(number),
            Some((None, measured)) => mistakes.push(Mistake { range, error: no_number(exhibit, value, measured) }),
            None => mistakes.push(Mistake { range, error: unknown(exhibit, value, values) }),
        }
    }
    if !mistakes.is_empty() || numbers.len() < count {
        return Err(mistakes);
    }
    let number = calculation.evaluate(&numbers);
    if number.is_finite() {
        return Ok(number);
    }
    let message = format!("`{}` is no finite number: it gives {number}", calculation.text());
    let error = Diagnostic::error(Code::Expression, message);
    Err(vec![Mistake {
        range: 0..calculation.text().len(),
        error: error.help("mend what it divides by, or takes the root or the logarithm of"),
    }])
}

/// A computed number as a value: one without a fraction is written as a count is.
pub(super) fn measured(number: f64) -> Measured {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    let whole = number.fract() == 0.0 && number.abs() <= EXACT;
    Measured { value: if whole { Value::Integer(number as i64) } else { Value::Number(number) }, standard_error: None }
}

/// What `exhibit` does not give.
pub(super) fn unknown(exhibit: &str, name: &str, values: &Values) -> Diagnostic {
    let near = nearest(name, values.names()).map(|near| format!("did you mean `{near}`?"));
    Diagnostic::error(Code::UnknownValue, format!("`{exhibit}` gives no value `{name}`"))
        .help_if(near)
        .help(format!("`workbook run {exhibit}` lists its values"))
}

/// What a value is, in words.
pub(super) fn describe(value: &Value) -> &'static str {
    match value {
        Value::Number(_) | Value::Integer(_) => "a number",
        Value::Boolean(_) => "a truth value",
        Value::Text(_) => "a text",
    }
}

fn no_number(exhibit: &str, name: &str, measured: &Measured) -> Diagnostic {
    let message =
        format!("`{name}` of `{exhibit}` is {}, with which nothing can be computed", describe(&measured.value));
    Diagnostic::error(Code::Expression, message).help(format!("`workbook run {exhibit}` lists its values"))
}
