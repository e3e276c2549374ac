//! Means, variances and standard errors, in one pass and without loss of digits.
//!
//! Values are centred as they arrive (Welford 1962, doi 10.1080/00401706.1962.10490022), so that a
//! large mean does not swallow a small variance, and the sums are compensated (Neumaier 1974, doi
//! 10.1002/zamm.19740540106), so that a million terms lose no more than a few units in the last
//! place.

/// A sum that carries along what rounding drops (Neumaier's variant of Kahan's summation).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sum {
    total: f64,
    lost: f64,
}

impl Sum {
    /// Adds `term`.
    #[inline]
    pub fn add(&mut self, term: f64) {
        let sum = self.total + term;
        // The smaller of the two addends is the one that lost digits.
        self.lost += if self.total.abs() >= term.abs() { (self.total - sum) + term } else { (term - sum) + self.total };
        self.total = sum;
    }

    /// The sum so far.
    #[inline]
    pub fn value(&self) -> f64 {
        // Once an infinity or NaN went in, the compensation is NaN, and the plain total tells the
        // truth.
        if self.lost.is_finite() { self.total + self.lost } else { self.total }
    }
}

impl Extend<f64> for Sum {
    fn extend<I: IntoIterator<Item = f64>>(&mut self, terms: I) {
        terms.into_iter().for_each(|term| self.add(term));
    }
}

/// The compensated sum of `terms`, in their order.
pub fn sum(terms: impl IntoIterator<Item = f64>) -> f64 {
    let mut sum = Sum::default();
    sum.extend(terms);
    sum.value()
}

/// Running mean and variance of values pushed one at a time.
///
/// ```
/// use workbook::stats::moments::Moments;
/// let mut moments = Moments::default();
/// [1.0, 2.0, 4.0].into_iter().for_each(|value| moments.push(value));
/// assert_eq!(moments.mean(), 7.0 / 3.0);
/// assert!((moments.variance() - 7.0 / 3.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: u64,
    mean: Sum,
    squares: Sum,
}

impl Moments {
    /// Takes `value` in.
    #[inline]
    pub fn push(&mut self, value: f64) {
        self.count += 1;
        let before = value - self.mean.value();
        self.mean.add(before / self.count as f64);
        self.squares.add(before * (value - self.mean.value()));
    }

    /// How many values went in.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The mean; NaN of no values.
    pub fn mean(&self) -> f64 {
        if self.count == 0 { f64::NAN } else { self.mean.value() }
    }

    /// The unbiased variance (divisor count - 1); NaN of fewer than two values.
    pub fn variance(&self) -> f64 {
        if self.count < 2 { f64::NAN } else { self.squares.value() / (self.count - 1) as f64 }
    }

    /// The standard deviation, the root of [`variance`](Self::variance).
    pub fn deviation(&self) -> f64 {
        self.variance().sqrt()
    }

    /// The standard error of the mean of independent values: deviation / sqrt(count).
    pub fn standard_error(&self) -> f64 {
        (self.variance() / self.count as f64).sqrt()
    }
}

impl Extend<f64> for Moments {
    fn extend<I: IntoIterator<Item = f64>>(&mut self, values: I) {
        values.into_iter().for_each(|value| self.push(value));
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        let mut moments = Self::default();
        moments.extend(values);
        moments
    }
}

/// The mean of `values`; NaN of none.
pub fn mean(values: &[f64]) -> f64 {
    sum(values.iter().copied()) / values.len() as f64
}

/// The unbiased variance of `values` (divisor count - 1), in two passes; NaN of fewer than two.
pub fn variance(values: &[f64]) -> f64 {
    if values.len() < 2 {
        return f64::NAN;
    }
    let centre = mean(values);
    sum(values.iter().map(|value| (value - centre) * (value - centre))) / (values.len() - 1) as f64
}

/// The root of the mean of the squares of `errors`: the RMSE; NaN of none.
pub fn root_mean_square(errors: &[f64]) -> f64 {
    (sum(errors.iter().map(|error| error * error)) / errors.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_keeps_what_rounding_drops() {
        assert_eq!(sum([1e16, 1.0, -1e16]), 1.0);
        assert_eq!(sum(std::iter::repeat_n(0.1, 10_000_000)), 1_000_000.0);
        assert_eq!(sum([f64::INFINITY, 1.0]), f64::INFINITY);
    }

    /// A large mean and a small variance, where the textbook formula gives rubbish: NIST `NumAcc4`
    /// (exact mean 10000000.2, variance 0.01).
    #[test]
    fn a_large_mean_leaves_the_variance_alone() {
        let values: Vec<f64> =
            (0..1001).map(|i| [10_000_000.2, 10_000_000.1, 10_000_000.3][if i == 0 { 0 } else { 2 - i % 2 }]).collect();
        let moments: Moments = values.iter().copied().collect();
        assert!((moments.mean() - 10_000_000.2).abs() < 1e-8);
        assert!((moments.variance() - 0.01).abs() < 1e-9);
        assert!((variance(&values) - 0.01).abs() < 1e-9);
        assert!((moments.standard_error() - (0.01_f64 / 1001.0).sqrt()).abs() < 1e-9);
    }
}
