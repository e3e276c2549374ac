//! How a number in prose is written.

use std::fmt::Write as _;

use crate::kinds::{Measured, Value};

/// How a value is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// As short as reads back to the same number; integers with thin spaces between thousands.
    Shortest,
    /// This many decimals.
    Decimals(usize),
    /// This many decimals and a power of ten.
    Scientific(usize),
    /// This many significant digits.
    Significant(usize),
    /// Per cent with this many decimals.
    Percent(usize),
    /// A whole number with thin spaces between thousands.
    Whole,
    /// This many decimals, and the standard error behind it.
    WithError(usize),
}

impl Format {
    /// Reads `.3`, `.3e`, `.3g`, `.1%`, `d`, `.3±`, or nothing.
    pub fn parse(text: &str) -> Result<Self, String> {
        let wrong = || format!("`{text}` is no number format");
        match text {
            "" => return Ok(Self::Shortest),
            "d" => return Ok(Self::Whole),
            _ => {}
        }
        let rest = text.strip_prefix('.').ok_or_else(wrong)?;
        let length = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        let digits = rest[..length].parse::<usize>().ok().filter(|&digits| digits <= 17).ok_or_else(wrong)?;
        match &rest[length..] {
            "" | "f" => Ok(Self::Decimals(digits)),
            "e" => Ok(Self::Scientific(digits)),
            "g" if digits > 0 => Ok(Self::Significant(digits)),
            "%" => Ok(Self::Percent(digits)),
            "±" => Ok(Self::WithError(digits)),
            _ => Err(wrong()),
        }
    }

    /// The value as text for a page; the only markup is `<sup>` around exponents.
    pub fn write(self, measured: &Measured) -> String {
        match &measured.value {
            Value::Boolean(truth) => if *truth { "true" } else { "false" }.to_owned(),
            Value::Text(text) => escape(text),
            Value::Integer(integer) if matches!(self, Self::Shortest | Self::Whole) => thousands(&integer.to_string()),
            Value::Integer(integer) => self.number(*integer as f64, measured.standard_error),
            Value::Number(number) => self.number(*number, measured.standard_error),
        }
    }

    fn number(self, number: f64, standard_error: Option<f64>) -> String {
        if !number.is_finite() {
            return if number.is_nan() { "undefined".to_owned() } else { minus(&format!("{}∞", if number < 0.0 { "-" } else { "" })) };
        }
        match self {
            Self::Shortest => minus(&format!("{number}")),
            Self::Decimals(decimals) => minus(&unsigned_zero(format!("{number:.decimals$}"))),
            Self::Scientific(decimals) => scientific(number, decimals),
            Self::Significant(digits) => significant(number, digits),
            Self::Percent(decimals) => format!("{}\u{202f}%", minus(&unsigned_zero(format!("{:.decimals$}", number * 100.0)))),
            Self::Whole => thousands(&unsigned_zero(format!("{number:.0}"))),
            Self::WithError(decimals) => {
                let mut text = minus(&unsigned_zero(format!("{number:.decimals$}")));
                if let Some(error) = standard_error {
                    let _ = write!(text, "\u{202f}±\u{202f}{error:.decimals$}");
                }
                text
            }
        }
    }
}

/// `-0.00` is zero to the digits shown, and reads so.
fn unsigned_zero(text: String) -> String {
    match text.strip_prefix('-') {
        Some(rest) if !rest.contains(|c: char| c.is_ascii_digit() && c != '0') => rest.to_owned(),
        _ => text,
    }
}

/// The minus sign in place of the hyphen.
pub(crate) fn minus(text: &str) -> String {
    text.replace('-', "\u{2212}")
}

/// Thin spaces between thousands, from five digits on.
fn thousands(digits: &str) -> String {
    let (sign, digits) = digits.strip_prefix('-').map_or(("", digits), |rest| ("\u{2212}", rest));
    let mut text = sign.to_owned();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && digits.len() > 4 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

fn scientific(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    if exponent == "0" {
        return minus(mantissa);
    }
    format!("{}\u{202f}×\u{202f}10<sup>{}</sup>", minus(mantissa), minus(exponent))
}

fn significant(number: f64, digits: usize) -> String {
    let exponent: i32 = format!("{number:.*e}", digits - 1).split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    if !(-4..=6).contains(&exponent) {
        return scientific(number, digits - 1);
    }
    let decimals = usize::try_from(digits as i32 - 1 - exponent).unwrap_or(0);
    minus(&format!("{number:.decimals$}"))
}

/// Text for HTML.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::Format;
    use crate::kinds::{Measured, Value};

    fn write(format: &str, number: f64) -> String {
        let measured = Measured { value: Value::Number(number), standard_error: Some(0.012) };
        Format::parse(format).expect("a format").write(&measured)
    }

    #[test]
    fn numbers_read_as_in_a_book() {
        assert_eq!(write(".2", -0.4996), "\u{2212}0.50");
        assert_eq!(write(".2", -0.001), "0.00");
        assert_eq!(write(".2e", 3.047e-4), "3.05\u{202f}×\u{202f}10<sup>\u{2212}4</sup>");
        assert_eq!(write(".3g", 0.012_345), "0.0123");
        assert_eq!(write(".3g", 123_456.0), "123456");
        assert_eq!(write(".1%", 0.0234), "2.3\u{202f}%");
        assert_eq!(write("d", 1_000_000.0), "1\u{202f}000\u{202f}000");
        assert_eq!(write("d", 1000.0), "1000");
        assert_eq!(write(".2±", 1.5), "1.50\u{202f}±\u{202f}0.01");
        assert_eq!(write("", 0.25), "0.25");
        assert_eq!(write(".1", f64::NAN), "undefined");
    }

    #[test]
    fn what_is_no_format_is_refused() {
        for text in ["3", ".", ".x", ".3q", ".99", ".0g", "e"] {
            assert!(Format::parse(text).is_err(), "{text}");
        }
    }
}
