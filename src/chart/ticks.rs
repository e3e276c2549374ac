//! Where ticks stand and what they say.

use super::number;
use super::text::Rich;
use crate::stats::portable;

/// A tick at a position along the axis: on a logarithmic axis, at the logarithm.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub at: f64,
    /// `None` for a minor tick.
    pub label: Option<Rich>,
}

/// The step 1, 2 or 5 times a power of ten that divides `span` into at most about `count` parts.
pub(super) fn nice_step(span: f64, count: usize) -> f64 {
    let raw = span / count.max(1) as f64;
    let power = ten(portable::log10(raw).floor() as i32);
    let rest = raw / power;
    // A hair of slack, so that 1/5 is 0.2 and not 0.5 for having been divided.
    power * [1.0, 2.0, 5.0].into_iter().find(|m| rest <= m * (1.0 + 1e-9)).unwrap_or(10.0)
}

/// Ticks on a linear axis from `low` to `high`, `count` of them or fewer.
pub(super) fn linear(low: f64, high: f64, count: usize) -> Vec<Tick> {
    let step = nice_step(high - low, count);
    let slack = 1e-9 * (high - low);
    let (first, last) = (((low - slack) / step).ceil(), ((high + slack) / step).floor());
    if !(step.is_normal() && (0.0..1000.0).contains(&(last - first))) {
        return Vec::new();
    }
    let places = (-portable::log10(step * (1.0 + 1e-9)).floor()).max(0.0) as usize;
    let largest = low.abs().max(high.abs());
    let mut ticks = Vec::new();
    // Counted in whole numbers: far from 0 a sum of floats might not move at all.
    for index in 0..=(last - first) as i64 {
        let value = (first + index as f64) * step;
        let label =
            if (1e-3..1e6).contains(&largest) { number::fixed(value, places).into() } else { power_label(value, step) };
        ticks.push(Tick { at: value, label: Some(label) });
    }
    ticks
}

/// Ticks on an axis of logarithms to base 10 from `low` to `high`, with at most about `count` labels.
pub(super) fn decades(low: f64, high: f64, count: usize) -> Vec<Tick> {
    let (first, last) = ((low - 1e-9).ceil() as i32, (high + 1e-9).floor() as i32);
    let whole = last - first + 1;
    if whole < 2 {
        return within_a_decade(low, high);
    }
    let stride = (whole as usize).div_ceil(count.max(1)).max(1) as i32;
    let mut ticks = Vec::new();
    for exponent in first - 1..=last {
        if exponent >= first {
            let label = (exponent.rem_euclid(stride) == 0).then(|| Rich::power("10", exponent));
            ticks.push(Tick { at: f64::from(exponent), label });
        }
        for digit in 2..=9 {
            let at = f64::from(exponent) + portable::log10(f64::from(digit));
            if stride == 1 && whole <= 10 && at > low - 1e-9 && at < high + 1e-9 {
                ticks.push(Tick { at, label: None });
            }
        }
    }
    ticks
}

/// Ticks on an axis of logarithms to base 2, in powers of two; plain ones where there is no power.
pub(super) fn binary(low: f64, high: f64, count: usize) -> Vec<Tick> {
    let (first, last) = ((low - 1e-9).ceil() as i32, (high + 1e-9).floor() as i32);
    if first > last {
        let value = |at: f64| portable::pow(2.0, at);
        let plain = linear(value(low), value(high), count).into_iter();
        return plain.map(|tick| Tick { at: portable::log2(tick.at), ..tick }).collect();
    }
    let stride = (last - first + 1).max(1).cast_unsigned().div_ceil(count.max(1) as u32).cast_signed();
    let tick = |exponent: i32| {
        let label = (exponent.rem_euclid(stride) == 0).then(|| Rich::power("2", exponent));
        Tick { at: f64::from(exponent), label }
    };
    (first..=last).map(tick).collect()
}

/// Labels at 1, 2 and 5 (or every digit) times a power of ten, where there are fewer than two powers to label.
fn within_a_decade(low: f64, high: f64) -> Vec<Tick> {
    let mut ticks = Vec::new();
    let wide = high - low > 0.5;
    for exponent in low.floor() as i32..=high.floor() as i32 {
        for digit in 1..=9 {
            let at = f64::from(exponent) + portable::log10(f64::from(digit));
            if at < low - 1e-9 || at > high + 1e-9 {
                continue;
            }
            let label = (!wide || matches!(digit, 1 | 2 | 5)).then(|| product(digit, exponent));
            ticks.push(Tick { at, label });
        }
    }
    ticks
}

/// `digit` times a power of ten, as a decimal where that is short.
fn product(digit: i32, exponent: i32) -> Rich {
    if (-3..=3).contains(&exponent) {
        return number::fixed(f64::from(digit) * ten(exponent), (-exponent).max(0) as usize).into();
    }
    match digit {
        1 => Rich::power("10", exponent),
        _ => Rich::power(&format!("{digit}\u{200a}×\u{200a}10"), exponent),
    }
}

/// A tick's value with a power of ten, with as many digits as the step needs.
fn power_label(value: f64, step: f64) -> Rich {
    if value == 0.0 {
        return "0".into();
    }
    let exponent = |x: f64| portable::log10(x.abs() * (1.0 + 1e-9)).floor() as i32;
    let digits = (exponent(value) - exponent(step)).clamp(0, 15) as usize + 1;
    let (mantissa, power) = number::parts(value, digits);
    Rich::power(&format!("{mantissa}\u{200a}×\u{200a}10"), power)
}

/// A power of ten, exactly rounded.
fn ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &[Tick]) -> Vec<String> {
        let text = |rich: &Rich| rich.runs.iter().map(|run| run.text.as_str()).collect::<Vec<_>>().join("^");
        ticks.iter().filter_map(|tick| tick.label.as_ref().map(text)).collect()
    }

    #[test]
    fn linear_ticks_are_round() {
        assert_eq!(labels(&linear(0.0, 1.0, 5)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&linear(-0.3, 0.31, 4)), ["−0.2", "0.0", "0.2"]);
        assert_eq!(labels(&linear(0.0, 1000.0, 4)), ["0", "500", "1000"]);
        assert_eq!(labels(&linear(1.20, 1.29, 5)), ["1.20", "1.22", "1.24", "1.26", "1.28"]);
        assert_eq!(
            labels(&linear(0.0, 3e7, 3)),
            ["0", "1\u{200a}×\u{200a}10^7", "2\u{200a}×\u{200a}10^7", "3\u{200a}×\u{200a}10^7"]
        );
    }

    #[test]
    fn steps_are_one_two_five() {
        for (span, count, step) in [(1.0, 5, 0.2), (1.0, 10, 0.1), (7.0, 4, 2.0), (0.03, 4, 0.01), (99.0, 3, 50.0)] {
            assert!((nice_step(span, count) / step - 1.0).abs() < 1e-12, "{span} in {count}");
        }
    }

    #[test]
    fn decades_are_powers_of_ten() {
        let ticks = decades(portable::log10(16.0), portable::log10(16384.0), 8);
        assert_eq!(labels(&ticks), ["10^2", "10^3", "10^4"]);
        assert_eq!(ticks.iter().filter(|tick| tick.label.is_none()).count(), 8 + 8 + 8);
        assert_eq!(labels(&decades(-12.0, 0.0, 5)), ["10^−12", "10^−9", "10^−6", "10^−3", "10^0"]);
        assert_eq!(labels(&decades(-0.1, 0.8, 5)), ["1", "2", "5"]);
        assert_eq!(labels(&binary(4.0, 14.0, 6)), ["2^4", "2^6", "2^8", "2^10", "2^12", "2^14"]);
    }

    #[test]
    fn between_two_powers_of_two_ticks_are_plain() {
        let (low, high) = (portable::log2(576.0), portable::log2(676.0));
        let ticks = binary(low, high, 4);
        assert_eq!(labels(&ticks), ["600", "650"]);
        assert!(ticks.iter().all(|tick| (low..=high).contains(&tick.at)));
    }

    #[test]
    fn nothing_loops_without_end() {
        assert!(linear(0.0, f64::MAX, 5).len() < 10);
        assert!(linear(0.0, 0.0, 5).is_empty());
        assert!(linear(1.0, 1.0 + f64::EPSILON, 5).len() < 10);
    }
}
