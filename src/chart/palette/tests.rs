//! Contrast by the formula of WCAG 2, distinguishability, and fixed assignment.

use super::*;
use crate::stats::portable;

fn channels(colour: &str) -> [f64; 3] {
    [1, 3, 5].map(|at| {
        let value = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
        if value <= 0.03928 { value / 12.92 } else { portable::pow((value + 0.055) / 1.055, 2.4) }
    })
}

fn luminance(colour: &str) -> f64 {
    let [r, g, b] = channels(colour);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

fn contrast(a: &str, b: &str) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[test]
fn what_matters_stands_out_from_the_page() {
    for role in Role::all().filter(|role| !matches!(role, Role::Page | Role::Grid | Role::Strata)) {
        let text = if matches!(role, Role::Ink | Role::Axis) { 4.5 } else { 3.0 };
        for page in ["#ffffff", "#fdfcf9"] {
            assert!(contrast(role.light(), page) >= text, "{role:?} on {page}: {}", contrast(role.light(), page));
        }
        for page in [Role::Page.dark(), "#15171b"] {
            assert!(contrast(role.dark(), page) >= text, "{role:?} on {page}: {}", contrast(role.dark(), page));
        }
    }
    assert!((contrast("#000000", "#ffffff") - 21.0).abs() < 1e-9);
}

#[test]
fn methods_differ_in_more_than_colour() {
    for (i, (name, a)) in SAMPLERS.iter().enumerate() {
        for (other, b) in &SAMPLERS[i + 1..] {
            assert!(a != b, "{name} and {other} look the same");
            let differences = [a.role != b.role, a.dash != b.dash, a.marker != b.marker];
            assert!(differences.iter().filter(|&&d| d).count() >= 2, "{name} and {other} differ in one thing only");
        }
    }
}

#[test]
fn no_two_samplers_of_the_catalogue_look_the_same() {
    let keys = || crate::samplers::SAMPLERS.iter().map(|sampler| sampler.about().key);
    let named: Vec<(&str, Style)> = keys().map(|key| (key, Style::of(key))).chain(SAMPLERS).collect();
    for (i, (name, a)) in named.iter().enumerate() {
        for (other, b) in named[i + 1..].iter().filter(|(other, _)| other != name) {
            assert!((a.role, a.dash) != (b.role, b.dash), "the lines of {name} and {other} look the same");
            assert!((a.role, a.marker) != (b.role, b.marker), "the points of {name} and {other} look the same");
        }
    }
}

#[test]
fn styles_are_of_methods_that_there_are() {
    for (name, _) in SAMPLERS {
        assert!(crate::samplers::Method::parse(name).is_ok(), "{name}");
    }
}

#[test]
fn styles_are_fixed() {
    assert_eq!(Style::of("independent").role, Role::Vermilion);
    assert_eq!(Style::of("sobol+later"), Style::of("sobol+later"));
    for name in ["later-one", "sobol+shift", "", "poisson-disk"] {
        assert!(SAMPLERS.iter().all(|row| row.1 != Style::of(name)), "{name} looks like another");
    }
    assert!((0..10).all(|i| (0..i).all(|j| Style::nth(i).role != Style::nth(j).role)));
}

#[test]
fn roles_are_in_the_order_of_the_table() {
    assert!(Role::all().enumerate().all(|(index, role)| role as usize == index));
    assert!(css().contains("--chart-vermilion:#c9480a;"));
    assert!(css().contains(".chart .s-blue{stroke:var(--chart-blue)}"));
}
