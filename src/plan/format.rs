//! How a number in prose is written.

use crate::chart::number;
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

    /// The value as text for a page.
    pub fn write(self, measured: &Measured) -> String {
        match &measured.value {
            Value::Boolean(truth) => if *truth { "true" } else { "false" }.to_owned(),
            Value::Text(text) => escape(text),
            Value::Integer(integer) if matches!(self, Self::Shortest | Self::Whole) => number::integer(*integer),
            Value::Integer(integer) => self.number(*integer as f64, measured.standard_error),
            Value::Number(number) => self.number(*number, measured.standard_error),
        }
    }

    fn number(self, value: f64, standard_error: Option<f64>) -> String {
        match self {
            Self::Shortest => minus(&value.to_string()),
            Self::Decimals(places) => number::fixed(value, places),
            Self::Scientific(places) => number::scientific(value, places + 1),
            Self::Significant(digits) => number::significant(value, digits),
            Self::Percent(places) => format!("{}\u{202f}%", number::fixed(value * 100.0, places)),
            Self::Whole => number::fixed(value, 0),
            Self::WithError(places) => {
                let error = standard_error.map(|error| format!("\u{202f}±\u{202f}{}", number::fixed(error, places)));
                number::fixed(value, places) + &error.unwrap_or_default()
            }
        }
    }
}

/// The minus sign in place of the hyphen.
pub(crate) fn minus(text: &str) -> String {
    text.replace('-', "\u{2212}")
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
        assert_eq!(write(".2e", 3.047e-4), "3.05\u{202f}×\u{202f}10⁻⁴");
        assert_eq!(write(".3g", 0.012_345), "0.0123");
        assert_eq!(write(".1%", 0.0234), "2.3\u{202f}%");
        assert_eq!(write("d", 1_000_000.0), "1\u{202f}000\u{202f}000");
        assert_eq!(write(".2±", 1.5), "1.50\u{202f}±\u{202f}0.01");
        assert_eq!(write("", 0.25), "0.25");
    }

    #[test]
    fn what_is_no_format_is_refused() {
        for text in ["3", ".", ".x", ".3q", ".99", ".0g", "e"] {
            assert!(Format::parse(text).is_err(), "{text}");
        }
    }
}
