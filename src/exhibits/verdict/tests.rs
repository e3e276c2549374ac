//! Verdicts: what is shown of a claim.

use super::{Verdict, agrees, decimals, fits, holds};
use crate::kinds::{Measured, Value, Values};
use crate::plan::{Bound, Literal, Other, Settled};

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
    let with = |name: &str| Other::Value(name.to_owned());
    assert_eq!(agrees(1.3, Some(0.1), &with("exact"), 4.0, &values), Ok(true));
    assert_eq!(agrees(1.5, Some(0.1), &with("exact"), 4.0, &values), Ok(false));
    assert!(agrees(1.0, None, &with("exact"), 4.0, &values).is_err());
    assert!(agrees(1.0, Some(0.1), &with("exakt"), 4.0, &values).is_err());
    assert_eq!(agrees(1.3, Some(0.1), &Other::Number(settled(1.6)), 4.0, &values), Ok(true));
    assert_eq!(agrees(1.3, Some(0.1), &Other::Number(settled(1.8)), 4.0, &values), Ok(false));
}

fn shown(value: f64, standard_error: Option<f64>, bound: Bound<Settled>) -> (String, String) {
    let measured = Measured { value: Value::Number(value), standard_error };
    let verdict = Verdict { value: "x".to_owned(), claim: (0, 0), measured, bound, holds: true };
    let bound = verdict.bound_html();
    let bare = |text: &str| text.split_once('>').map_or(text, |(_, rest)| rest.trim_end_matches("</span>")).to_owned();
    (verdict.measured_html(), bare(&bound))
}

#[test]
fn what_is_shown_of_a_true_claim_is_true() {
    let computed = |number: f64| Settled { number, expression: Some("x".to_owned()) };
    let equals = |number: Settled| Bound::Equals(Literal::Number(number));
    let pi = std::f64::consts::PI;
    assert_eq!(shown(pi, None, equals(settled(pi))).0, "3.14159");
    let close = 1.0 - 1.0 / f64::from(1 << 24);
    let (measured, bound) = shown(close, None, equals(computed(close)));
    assert_eq!((measured.as_str(), bound.as_str()), ("0.9999999404", "0.9999999404"));
    assert_eq!(shown(0.999_96, None, Bound::Below(settled(1.0))).0, "0.99996");
    assert_eq!(shown(2.0 / 3.0, None, Bound::Above(settled(0.66665))).0, "0.6667");
    let near = computed(0.333_333_333_3);
    assert_eq!(shown(1.0 / 3.0, None, Bound::Above(near)).0, "0.33333333333");
    assert_eq!(shown(256.0, None, equals(settled(256.0))).0, "256");
}

#[test]
fn small_values_have_digits() {
    let near = || Bound::Near { target: settled(0.0), within: settled(1e-9) };
    assert_eq!(shown(3.04e-17, Some(2.9e-12), near()).0, "(0.0\u{202f}±\u{202f}2.9)\u{202f}×\u{202f}10⁻¹²");
    assert_eq!(shown(3.04e-7, Some(2.9e-9), near()).0, "(3.040\u{202f}±\u{202f}0.029)\u{202f}×\u{202f}10⁻⁷");
    assert_eq!(shown(0.3331, Some(0.0021), near()).0, "0.3331\u{202f}±\u{202f}0.0021");
}

#[test]
fn two_digits_of_an_error_are_shown() {
    assert_eq!((decimals(0.012), decimals(1.5), decimals(250.0)), (3, 1, 0));
}
