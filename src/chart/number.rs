//! Numbers as they are printed: a true minus sign, thin spaces between thousands, powers of ten.

/// The minus sign.
pub const MINUS: char = '\u{2212}';
/// The space between groups of three digits.
pub const THIN: char = '\u{202f}';

/// `value` with `places` decimals; nothing rounds to a negative zero.
pub fn fixed(value: f64, places: usize) -> String {
    if !value.is_finite() {
        return not_finite(value);
    }
    let text = format!("{:.*}", places, value.abs());
    let (whole, decimals) = text.split_once('.').map_or((text.as_str(), ""), |(whole, decimals)| (whole, decimals));
    let mut out = String::new();
    if value < 0.0 && text.bytes().any(|byte| matches!(byte, b'1'..=b'9')) {
        out.push(MINUS);
    }
    out.push_str(&grouped(whole));
    if places > 0 {
        out.push('.');
        out.push_str(decimals);
    }
    out
}

/// `value` with as many decimals as it needs, at most three.
pub fn shortest(value: f64) -> String {
    let exact = |places: &usize| format!("{value:.places$}").parse() == Ok(value);
    fixed(value, (0..3).find(exact).unwrap_or(3))
}

/// An integer with thin spaces.
pub fn integer(value: i64) -> String {
    let digits = grouped(&value.unsigned_abs().to_string());
    if value < 0 { format!("{MINUS}{digits}") } else { digits }
}

/// `value` to `digits` significant digits, as a decimal where that is short, else with a power of ten.
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return not_finite(value);
    }
    let (_, exponent) = parts(value, digits);
    if value == 0.0 || !(-4..7).contains(&exponent) {
        return if value == 0.0 { "0".to_owned() } else { scientific(value, digits) };
    }
    fixed(value, (digits as i32 - 1 - exponent).max(0) as usize)
}

/// `value` as a mantissa of `digits` digits and a power of ten: `1.2 × 10⁻⁵`.
pub fn scientific(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return not_finite(value);
    }
    let (mantissa, exponent) = parts(value, digits);
    format!("{mantissa}{THIN}×{THIN}10{}", raised(exponent))
}

/// The mantissa, as printed with `digits` digits, and the power of ten.
pub fn parts(value: f64, digits: usize) -> (String, i32) {
    let text = format!("{:.*e}", digits.max(1) - 1, value);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text.as_str(), "0"));
    (mantissa.replace('-', "\u{2212}"), exponent.parse().unwrap_or(0))
}

/// An integer in superscript digits.
pub fn raised(value: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = value.unsigned_abs().to_string();
    let digits = digits.bytes().filter_map(|byte| DIGITS.get(usize::from(byte - b'0')));
    if value < 0 { std::iter::once(&'⁻').chain(digits).collect() } else { digits.collect() }
}

/// Digits in groups of three from the right, if there are five or more.
fn grouped(digits: &str) -> String {
    if digits.len() < 5 {
        return digits.to_owned();
    }
    let mut out = String::with_capacity(digits.len() * 2);
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            out.push(THIN);
        }
        out.push(digit);
    }
    out
}

fn not_finite(value: f64) -> String {
    if value.is_nan() {
        "—".to_owned()
    } else if value > 0.0 {
        "∞".to_owned()
    } else {
        format!("{MINUS}∞")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_printed() {
        assert_eq!(fixed(-0.5, 2), "−0.50");
        assert_eq!(fixed(-0.001, 2), "0.00");
        assert_eq!(fixed(12345.6, 1), "12\u{202f}345.6");
        assert_eq!([-0.5, -1.0, -0.75, 1.0 / 3.0].map(shortest), ["−0.5", "−1", "−0.75", "0.333"]);
        assert_eq!(integer(-1_048_576), "−1\u{202f}048\u{202f}576");
        assert_eq!(integer(1024), "1024");
        assert_eq!(significant(0.001_234_56, 3), "0.00123");
        assert_eq!(significant(1.5e-9, 2), "1.5\u{202f}×\u{202f}10⁻⁹");
        assert_eq!(significant(9.999, 2), "10");
        assert_eq!(significant(0.0, 3), "0");
        assert_eq!(fixed(f64::NAN, 2), "—");
        assert_eq!(fixed(f64::NEG_INFINITY, 2), "−∞");
    }
}
