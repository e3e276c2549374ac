//! Integrals over the unit cube by Gauss-Legendre panels, for functions whose integral nobody has
//! written down.
//!
//! The cube of d <= 3 dimensions is cut into 2^k panels an axis, each with a tensor rule of 10
//! points an axis, which is exact for polynomials of degree 19 in each variable. Halving the panels
//! shrinks the error of a smooth function about 10^6-fold, so that the difference of two successive
//! levels is a generous bound on the error of the finer. A function with a jump converges slowly
//! and is refused rather than guessed. (Davis and Rabinowitz, *Methods of Numerical Integration*,
//! 2nd ed., Academic Press 1984, doi 10.1016/C2013-0-10566-1.)

use super::moments::{Sum, sum};
use super::portable;
use std::f64::consts::PI;

/// Points of the rule along one axis of a panel.
const POINTS: usize = 10;

/// The most evaluations of one level: what two cores do in a few hundredths of a second.
const MOST_EVALUATIONS: usize = 600_000;

/// Two levels agree when they differ by less than this, relative to the integral of the absolute
/// value.
const TOLERANCE: f64 = 1e-9;

/// The value of an integral with a bound on its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral {
    /// The value.
    pub value: f64,
    /// A bound on the absolute error: the difference of the last two levels, at least a few units
    /// in the last place.
    pub error: f64,
}

/// The integral of `f` over the unit cube of `d` dimensions (1 to 3); `None` for other d, and where
/// the levels do not settle.
///
/// ```
/// use workbook::stats::quadrature::integrate;
/// let integral = integrate(2, |x| x[0] * x[1]).unwrap();
/// assert!((integral.value - 0.25).abs() <= integral.error);
/// assert!(integrate(1, |x| f64::from(x[0] < 0.3)).is_none());
/// ```
pub fn integrate(d: usize, f: impl Fn(&[f64]) -> f64) -> Option<Integral> {
    if !(1..=3).contains(&d) {
        return None;
    }
    let rule = legendre();
    let mut before: Option<(f64, f64)> = None;
    for level in 0_u32.. {
        let panels = 1_usize << level;
        if (panels * POINTS).checked_pow(d as u32).is_none_or(|evaluations| evaluations > MOST_EVALUATIONS) {
            break;
        }
        let (value, size) = refine(d, panels, &rule, &f);
        if !value.is_finite() {
            return None;
        }
        if let Some((coarser, difference)) = before {
            let now = (value - coarser).abs();
            // Two small differences in a row: one alone may be chance, as for a jump that falls on
            // a border of panels.
            if now.max(difference) <= TOLERANCE.sqrt() * size && now <= TOLERANCE * size {
                return Some(Integral { value, error: now.max(4.0 * f64::EPSILON * size) });
            }
            before = Some((value, now));
        } else {
            before = Some((value, f64::INFINITY));
        }
    }
    None
}

/// The composite rule with `panels` panels an axis: the integrals of `f` and of its absolute value.
fn refine(d: usize, panels: usize, rule: &[(f64, f64); POINTS], f: &impl Fn(&[f64]) -> f64) -> (f64, f64) {
    let width = 1.0 / panels as f64;
    let axis: Vec<(f64, f64)> = (0..panels)
        .flat_map(|panel| rule.iter().map(move |&(node, weight)| ((panel as f64 + node) * width, weight * width)))
        .collect();
    let (mut value, mut size) = (Sum::default(), Sum::default());
    let mut point = [0.0; 3];
    for index in 0..axis.len().pow(d as u32) {
        let (mut rest, mut weight) = (index, 1.0);
        for coordinate in &mut point[..d] {
            let (node, share) = axis[rest % axis.len()];
            *coordinate = node;
            weight *= share;
            rest /= axis.len();
        }
        let term = weight * f(&point[..d]);
        value.add(term);
        size.add(term.abs());
    }
    (value.value(), size.value())
}

/// Nodes and weights of the rule on [0, 1]: the zeros of the Legendre polynomial by Newton's method
/// from Tricomi's guess.
fn legendre() -> [(f64, f64); POINTS] {
    let mut rule = std::array::from_fn(|i| {
        let n = POINTS as f64;
        let mut z = -portable::cos(PI * (i as f64 + 0.75) / (n + 0.5));
        let mut slope = 0.0;
        for _ in 0..8 {
            let (mut last, mut here) = (1.0, z);
            for degree in 2..=POINTS {
                let k = degree as f64;
                (last, here) = (here, ((2.0 * k - 1.0) * z * here - (k - 1.0) * last) / k);
            }
            slope = n * (z * here - last) / (z * z - 1.0);
            z -= here / slope;
        }
        (0.5 * (1.0 + z), 1.0 / ((1.0 - z * z) * slope * slope))
    });
    // The weights come out a few units in the last place off; their sum is known.
    let total = sum(rule.iter().map(|&(_, weight)| weight));
    for (_, weight) in &mut rule {
        *weight /= total;
    }
    rule
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_is_exact_to_degree_19() {
        for degree in 0..20 {
            let sum: f64 = legendre().iter().map(|&(x, weight)| weight * portable::power(x, degree)).sum();
            assert!((sum - 1.0 / f64::from(degree + 1)).abs() < 1e-15, "degree {degree}: {sum}");
        }
    }

    #[test]
    fn known_integrals() {
        let deck = integrate(1, |x| portable::exp(portable::sin(3.0 * x[0] * x[0]))).expect("smooth");
        assert!((deck.value - 1.776_099_045_242_843_7).abs() < 1e-14, "{deck:?}");
        let sphere = integrate(3, |x| 1.0 / (1.0 + x[0] + x[1] + x[2])).expect("smooth");
        // Three integrations of 1/u give u^2 ln(u) / 2; its third difference at 1 is 8 ln 4 - 13.5
        // ln 3 + 6 ln 2.
        let exact = 8.0 * portable::ln(4.0) - 13.5 * portable::ln(3.0) + 6.0 * portable::ln(2.0);
        assert!((sphere.value - exact).abs() < 1e-13, "{sphere:?} {exact}");
    }

    #[test]
    fn jumps_and_poles_are_refused() {
        let on_a_border = integrate(1, |x| f64::from(x[0] < 0.5)).expect("panels end at the jump");
        assert!((on_a_border.value - 0.5).abs() < 1e-15);
        assert!(integrate(1, |x| f64::from(x[0] < 0.3)).is_none());
        assert!(integrate(2, |x| f64::from(x[1] > x[0])).is_none());
        assert!(integrate(1, |x| 1.0 / (x[0] - 0.3)).is_none());
        assert!(integrate(4, |_| 1.0).is_none());
    }
}
