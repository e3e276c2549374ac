//! Tests of hypotheses and intervals: z, chi-square, Kolmogorov-Smirnov, normal and Student's t.
//!
//! The incomplete gamma and beta functions are those of `pxfm`. Sources: W. H. Press et
//! al., *Numerical Recipes* (3rd ed., Cambridge 2007, chapters 6 and 14) for the relations; the law
//! of the Kolmogorov-Smirnov statistic with the correction of M. A. Stephens (1970), doi
//! 10.1111/j.2517-6161.1970.tb00821.x.

use super::moments::Moments;
use super::{normal, portable};

/// An interval that holds the mean with a given probability.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

impl Interval {
    /// Whether `value` lies inside.
    pub fn contains(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// The interval for the mean by the normal law, for many values; `confidence` in (0, 1). `None` of
/// fewer than two values.
pub fn normal_interval(moments: &Moments, confidence: f64) -> Option<Interval> {
    around(moments, confidence, normal::quantile(0.5 + 0.5 * confidence))
}

/// The interval for the mean by Student's t, right for few values of a normal law. `None` of fewer
/// than two values.
pub fn t_interval(moments: &Moments, confidence: f64) -> Option<Interval> {
    let freedom = moments.count().checked_sub(1)? as f64;
    around(moments, confidence, t_quantile(0.5 + 0.5 * confidence, freedom))
}

fn around(moments: &Moments, confidence: f64, quantile: f64) -> Option<Interval> {
    let valid = moments.count() > 1 && confidence > 0.0 && confidence < 1.0;
    let half = quantile * moments.standard_error();
    valid.then(|| Interval { low: moments.mean() - half, high: moments.mean() + half })
}

/// By how many standard errors the mean lies off `expected`; NaN of fewer than two values.
pub fn z(moments: &Moments, expected: f64) -> f64 {
    (moments.mean() - expected) / moments.standard_error()
}

/// The probability that a standard normal variable lies at least as far off 0 as `z`.
pub fn two_sided(z: f64) -> f64 {
    portable::erfc(z.abs() / std::f64::consts::SQRT_2)
}

/// The probability that Student's t with `freedom > 0` degrees is at most `t`.
pub fn t_distribution(t: f64, freedom: f64) -> f64 {
    let tail = 0.5 * pxfm::f_betainc_reg(0.5 * freedom, 0.5, freedom / (freedom + t * t));
    if t > 0.0 { 1.0 - tail } else { tail }
}

/// The t that Student's law with `freedom > 0` degrees stays below with probability `p` in (0, 1),
/// by bisection; infinite at the ends.
pub fn t_quantile(p: f64, freedom: f64) -> f64 {
    if p <= 0.0 || p >= 1.0 {
        return if p >= 1.0 { f64::INFINITY } else { f64::NEG_INFINITY };
    }
    let (mut low, mut high) = (-1.0, 1.0);
    while t_distribution(low, freedom) > p && low > -1e300 {
        low *= 2.0;
    }
    while t_distribution(high, freedom) < p && high < 1e300 {
        high *= 2.0;
    }
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if t_distribution(middle, freedom) < p { low = middle } else { high = middle }
    }
    f64::midpoint(low, high)
}

/// A test's statistic, and the probability of one at least as extreme if the hypothesis holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// The statistic.
    pub statistic: f64,
    /// The probability of one at least as large by chance.
    pub probability: f64,
}

/// The probability that a chi-square variable with `freedom > 0` degrees is at least `statistic`; also
/// for no statistic at all, and for one so large that nothing is left.
pub fn chi_square_tail(statistic: f64, freedom: f64) -> f64 {
    if statistic <= 0.0 {
        return 1.0;
    }
    let tail = pxfm::f_gamma_q(0.5 * freedom, 0.5 * statistic);
    // From there on the tail is below exp(-700), and the continued fraction gives no number.
    if statistic > 1500.0 + 10.0 * freedom { 0.0 } else { tail.clamp(0.0, 1.0) }
}

/// Pearson's chi-square test of `counts` against equal expected counts; `None` of fewer than two
/// cells or no count at all.
pub fn chi_square(counts: &[u64]) -> Option<Verdict> {
    let total: u64 = counts.iter().sum();
    if counts.len() < 2 || total == 0 {
        return None;
    }
    let expected = total as f64 / counts.len() as f64;
    let statistic = counts.iter().map(|&count| (count as f64 - expected) * (count as f64 - expected) / expected).sum();
    let freedom = (counts.len() - 1) as f64;
    Some(Verdict { statistic, probability: chi_square_tail(statistic, freedom) })
}

/// Pearson's chi-square test of `counts` against cells of these probabilities, which sum to at most 1;
/// cells that expect fewer than five are joined with the next, and what is left with the last (Cochran
/// 1954, doi 10.2307/3001616). `None` of fewer than two cells, unequal lengths or no count at all.
pub fn chi_square_against(counts: &[u64], probabilities: &[f64]) -> Option<Verdict> {
    let total = counts.iter().sum::<u64>() as f64;
    if counts.len() != probabilities.len() || total == 0.0 {
        return None;
    }
    let mut cells: Vec<(f64, f64)> = Vec::new();
    let mut open = (0.0, 0.0);
    for (&count, &probability) in counts.iter().zip(probabilities) {
        open = (open.0 + count as f64, open.1 + probability * total);
        if open.1 >= 5.0 {
            cells.push(std::mem::take(&mut open));
        }
    }
    let last = cells.last_mut()?;
    *last = (last.0 + open.0, last.1 + open.1);
    let freedom = cells.len().checked_sub(1).filter(|freedom| *freedom > 0)? as f64;
    let statistic = cells.iter().map(|(count, expected)| (count - expected) * (count - expected) / expected).sum();
    Some(Verdict { statistic, probability: chi_square_tail(statistic, freedom) })
}

/// The Kolmogorov-Smirnov test of `values` against the uniform law on [0, 1]; `None` of no values
/// or where one is not a number.
pub fn kolmogorov_smirnov(values: &[f64]) -> Option<Verdict> {
    if values.is_empty() || values.iter().any(|value| value.is_nan()) {
        return None;
    }
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let gap = |(i, &x): (usize, &f64)| (x - i as f64 / n).max((i + 1) as f64 / n - x);
    let statistic = sorted.iter().enumerate().map(gap).fold(0.0, f64::max);
    let scaled = (n.sqrt() + 0.12 + 0.11 / n.sqrt()) * statistic;
    Some(Verdict { statistic, probability: kolmogorov(scaled) })
}

/// The probability that the limit law of Kolmogorov exceeds `x`: 2 sum (-1)^(k-1) exp(-2 k^2 x^2),
/// or its dual form for small x, where that converges slowly.
fn kolmogorov(x: f64) -> f64 {
    use std::f64::consts::PI;
    if x < 1.0 {
        let term = |k: f64| portable::exp(-(2.0 * k - 1.0) * (2.0 * k - 1.0) * PI * PI / (8.0 * x * x));
        return 1.0 - (2.0 * PI).sqrt() / x * (term(1.0) + term(2.0) + term(3.0));
    }
    let term = |k: f64| portable::exp(-2.0 * k * k * x * x);
    2.0 * (term(1.0) - term(2.0) + term(3.0))
}

#[cfg(test)]
mod checks {
    use super::*;

    /// Tables of Abramowitz and Stegun (26.8, 26.10) and of Smirnov (1948).
    #[test]
    fn tabulated_quantiles() {
        for (freedom, quantile) in [(1.0, 12.706_204_736), (5.0, 2.570_581_836), (30.0, 2.042_272_456)] {
            assert!((t_quantile(0.975, freedom) - quantile).abs() < 1e-8, "{freedom}: {}", t_quantile(0.975, freedom));
        }
        let verdict = chi_square(&[10, 20, 30]).expect("three cells");
        assert_eq!(verdict.statistic, 10.0);
        assert!((verdict.probability - portable::exp(-5.0)).abs() < 1e-15);
        assert_eq!(chi_square(&[7, 7, 7]).expect("three cells").probability, 1.0);
        assert_eq!(chi_square(&[100_000, 0, 0, 0]).expect("four cells").probability, 0.0);
        // One degree of freedom: the square of a normal variable, over the whole range.
        for statistic in [1e-12, 1e-3, 1.0, 25.0, 100.0, 600.0, 1300.0] {
            let (tail, normal) = (chi_square_tail(statistic, 1.0), two_sided(statistic.sqrt()));
            assert!((tail - normal).abs() <= 1e-12 + 1e-9 * normal, "{statistic}: {tail} {normal}");
        }
        // Two degrees: exp(-x/2). Thirty-two: a sum of Poisson terms.
        for statistic in [1e-9, 3.0, 40.0, 90.0, 400.0, 1200.0] {
            let (half, mut term, mut sum) = (0.5 * statistic, 1.0, 1.0);
            for k in 1..16 {
                term *= half / f64::from(k);
                sum += term;
            }
            let poisson = sum * portable::exp(-half);
            assert!((chi_square_tail(statistic, 32.0) - poisson).abs() <= 1e-12, "{statistic}");
        }
        let against = chi_square_against(&[10, 20, 30], &[1.0 / 3.0; 3]).expect("three cells");
        assert!((against.statistic - 10.0).abs() < 1e-12);
        // Cells of 2, 3 and 5 expected: the first two are joined.
        let joined = chi_square_against(&[1, 4, 5], &[0.2, 0.3, 0.5]).expect("two cells");
        assert!(joined.statistic.abs() < 1e-12 && (joined.probability - 1.0).abs() < 1e-12);
        assert_eq!(chi_square_against(&[1, 2], &[0.5, 0.5]), None);
        assert!((kolmogorov(1.358_098_6) - 0.05).abs() < 1e-7);
        assert!((kolmogorov(0.828_757_355_5) - 0.497_7).abs() < 2e-3);
        assert!((two_sided(1.959_963_984_540_054) - 0.05).abs() < 1e-15);
    }

    #[test]
    fn the_two_forms_of_the_limit_law_meet() {
        assert!((kolmogorov(1.0 - 1e-12) - kolmogorov(1.0)).abs() < 1e-10);
        assert_eq!(kolmogorov_smirnov(&[]), None);
        let even: Vec<f64> = (0..100).map(|i| (f64::from(i) + 0.5) / 100.0).collect();
        let verdict = kolmogorov_smirnov(&even).expect("values");
        assert!((verdict.statistic - 0.005).abs() < 1e-15 && verdict.probability > 0.999_999);
        let halved: Vec<f64> = even.iter().map(|x| 0.5 * x).collect();
        assert!(kolmogorov_smirnov(&halved).expect("values").probability < 1e-12);
    }

    #[test]
    fn intervals_hold_the_mean() {
        let moments: Moments = [1.0, 2.0, 3.0].into_iter().collect();
        let (wide, narrow) =
            (t_interval(&moments, 0.95).expect("three"), normal_interval(&moments, 0.95).expect("three"));
        assert!(wide.low < narrow.low && narrow.contains(2.0) && !narrow.contains(3.2));
        assert!((wide.high - 2.0 - 4.302_652_729_911_275 / 3.0_f64.sqrt()).abs() < 1e-9);
        assert_eq!(z(&moments, 2.0), 0.0);
    }
}
