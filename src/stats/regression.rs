//! Straight lines by least squares: the slope of an error against the number of points, with its
//! standard error.
//!
//! On log-log axes the slope is the rate of convergence. The standard error assumes independent,
//! equally noisy ordinates, as in Draper and Smith, *Applied Regression Analysis* (3rd ed., Wiley
//! 1998, section 1.4, doi 10.1002/9781118625590).

use super::moments::{mean, sum};

/// The line y = intercept + slope x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Rise for each unit of x.
    pub slope: f64,
    /// The value at x = 0.
    pub intercept: f64,
    /// The standard error of the slope; infinite where only two points leave no degree of freedom
    /// to estimate it.
    pub slope_error: f64,
}

impl Line {
    /// The line's value at `x`.
    pub fn at(&self, x: f64) -> f64 {
        self.intercept + self.slope * x
    }
}

/// The least-squares line through (`x[i]`, `y[i]`); `None` for fewer than two points, unequal
/// lengths, values that are not finite, or one single abscissa.
///
/// ```
/// use workbook::stats::regression::least_squares;
/// let line = least_squares(&[0.0, 1.0, 2.0], &[1.0, 3.0, 5.0]).unwrap();
/// assert_eq!((line.slope, line.intercept, line.slope_error), (2.0, 1.0, 0.0));
/// ```
pub fn least_squares(x: &[f64], y: &[f64]) -> Option<Line> {
    let n = x.len();
    if n < 2 || n != y.len() || x.iter().chain(y).any(|value| !value.is_finite()) {
        return None;
    }
    let (centre_x, centre_y) = (mean(x), mean(y));
    let spread = sum(x.iter().map(|x| (x - centre_x) * (x - centre_x)));
    if spread <= 0.0 {
        return None;
    }
    let slope = sum(x.iter().zip(y).map(|(x, y)| (x - centre_x) * (y - centre_y))) / spread;
    let intercept = centre_y - slope * centre_x;
    let left = sum(x.iter().zip(y).map(|(x, y)| {
        let residual = (y - centre_y) - slope * (x - centre_x);
        residual * residual
    }));
    let slope_error = if n == 2 { f64::INFINITY } else { (left / (n - 2) as f64 / spread).sqrt() };
    Some(Line { slope, intercept, slope_error })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Five points, fitted by hand in rational arithmetic.
    #[test]
    fn slope_error_by_hand() {
        // x = 0..4, y = (0, 1, 1, 3, 4): slope 1, intercept -1/5, residual sum of squares 4/5.
        let line = least_squares(&[0.0, 1.0, 2.0, 3.0, 4.0], &[0.0, 1.0, 1.0, 3.0, 4.0]).expect("five points");
        assert!((line.slope - 1.0).abs() < 1e-15);
        assert!((line.intercept + 0.2).abs() < 1e-15);
        assert!((line.slope_error - (0.8_f64 / 3.0 / 10.0).sqrt()).abs() < 1e-15);
    }

    #[test]
    fn no_line_through_one_abscissa() {
        assert_eq!(least_squares(&[1.0, 1.0], &[0.0, 1.0]), None);
        assert_eq!(least_squares(&[1.0], &[0.0]), None);
        assert_eq!(least_squares(&[1.0, f64::NAN], &[0.0, 1.0]), None);
    }
}
