//! An axis as asked for, and as resolved against the data.

use super::ChartError;
use super::text::Rich;
use super::ticks::{self, Tick};
use crate::stats::portable;

/// How values are laid along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scale {
    Linear,
    /// Logarithmic, with ticks at powers of ten.
    Decades,
    /// Logarithmic, with ticks at powers of two.
    Binary,
}

impl Scale {
    /// The position of a value; `None` where it has none.
    pub fn position(self, value: f64) -> Option<f64> {
        let position = match self {
            Self::Linear => value,
            _ if value <= 0.0 => return None,
            Self::Decades => portable::log10(value),
            Self::Binary => portable::log2(value),
        };
        position.is_finite().then_some(position)
    }

    /// The position of a value that may lie off the axis, such as the foot of a bar on a logarithmic axis.
    pub fn position_or_below(self, value: f64) -> Option<f64> {
        if self != Self::Linear && value <= 0.0 && value.is_finite() { Some(-1e9) } else { self.position(value) }
    }

    pub fn is_log(self) -> bool {
        self != Self::Linear
    }
}

/// An axis: its scale, its title, and what is fixed about its range and ticks.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(super) scale: Scale,
    pub(super) title: Rich,
    pub(super) range: Option<(f64, f64)>,
    pub(super) include: Vec<f64>,
    pub(super) ticks: Option<Vec<(f64, Rich)>>,
    pub(super) hidden: bool,
    pub(super) from: Option<f64>,
}

impl Axis {
    /// A linear axis.
    pub fn linear(title: impl Into<Rich>) -> Self {
        let (range, include, ticks) = (None, Vec::new(), None);
        Self { scale: Scale::Linear, title: title.into(), range, include, ticks, hidden: false, from: None }
    }

    /// A logarithmic axis with ticks at powers of ten.
    pub fn log(title: impl Into<Rich>) -> Self {
        Self { scale: Scale::Decades, ..Self::linear(title) }
    }

    /// A logarithmic axis with ticks at powers of two.
    pub fn log2(title: impl Into<Rich>) -> Self {
        Self { scale: Scale::Binary, ..Self::linear(title) }
    }

    /// From exactly `low` to `high`; otherwise from the data.
    #[must_use]
    pub fn range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// Reaching to this value at least, e.g. 0.
    #[must_use]
    pub fn include(mut self, value: f64) -> Self {
        self.include.push(value);
        self
    }

    /// With ticks at just these values.
    #[must_use]
    pub fn ticks_at(mut self, ticks: Vec<(f64, Rich)>) -> Self {
        self.ticks = Some(ticks);
        self
    }

    /// With a line that begins only at this value, though its panel begins before.
    #[must_use]
    pub fn from(mut self, value: f64) -> Self {
        self.from = Some(value);
        self
    }

    /// Without ticks, labels and line.
    #[must_use]
    pub fn hidden(mut self) -> Self {
        self.hidden = true;
        self
    }

    /// The range of positions for data that spans `data`, padded by a share of it where it is not fixed.
    pub(super) fn resolve(&self, data: Option<(f64, f64)>, pad: (f64, f64)) -> Result<Option<(f64, f64)>, ChartError> {
        if let Some((low, high)) = self.range {
            let wrong = ChartError::Range { low, high };
            let (Some(a), Some(b)) = (self.scale.position(low), self.scale.position(high)) else { return Err(wrong) };
            return if a < b && (b - a).is_finite() { Ok(Some((a, b))) } else { Err(wrong) };
        }
        let Some((data_low, data_high)) = data else { return Ok(None) };
        let (mut low, mut high) = (data_low, data_high);
        for at in self.include.iter().filter_map(|&value| self.scale.position(value)) {
            (low, high) = (low.min(at), high.max(at));
        }
        if high - low <= 1e-12 * low.abs().max(high.abs()) {
            // A single value stands in the middle of a sensible axis.
            let half = if self.scale.is_log() || low == 0.0 { 0.5 } else { low.abs() * 0.1 };
            (low, high) = (low - half, high + half);
        }
        let span = high - low;
        if !span.is_finite() {
            return Err(ChartError::Range { low, high });
        }
        // What was asked to be included is a border by intention.
        let bordered = |at: f64| self.include.iter().any(|&value| self.scale.position(value) == Some(at));
        let low = if bordered(low) && low < data_low { low } else { low - pad.0 * span };
        let high = if bordered(high) && high > data_high { high } else { high + pad.1 * span };
        Ok(Some((low, high)))
    }

    /// The ticks on a range of positions, with about `count` labels.
    pub(super) fn ticks(&self, (low, high): (f64, f64), count: usize) -> Vec<Tick> {
        if let Some(ticks) = &self.ticks {
            let inside = |at: &f64| *at >= low - 1e-9 && *at <= high + 1e-9;
            let tick = |(value, label): &(f64, Rich)| {
                let at = self.scale.position(*value).filter(inside)?;
                Some(Tick { at, label: Some(label.clone()) })
            };
            return ticks.iter().filter_map(tick).collect();
        }
        match self.scale {
            Scale::Linear => ticks::linear(low, high, count),
            Scale::Decades => ticks::decades(low, high, count),
            Scale::Binary => ticks::binary(low, high, count),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_follow_the_data() {
        let axis = Axis::linear("x");
        assert_eq!(axis.resolve(Some((0.0, 2.0)), (0.05, 0.05)), Ok(Some((-0.1, 2.1))));
        assert_eq!(axis.clone().include(0.0).resolve(Some((1.0, 2.0)), (0.5, 0.0)), Ok(Some((0.0, 2.0))));
        assert_eq!(axis.resolve(Some((5.0, 5.0)), (0.0, 0.0)), Ok(Some((4.5, 5.5))));
        assert_eq!(axis.resolve(None, (0.0, 0.0)), Ok(None));
        assert!(axis.resolve(Some((-f64::MAX, f64::MAX)), (0.0, 0.0)).is_err());
    }

    #[test]
    fn impossible_ranges_are_refused() {
        assert!(Axis::linear("").range(1.0, 0.0).resolve(None, (0.0, 0.0)).is_err());
        assert!(Axis::log("").range(0.0, 1.0).resolve(None, (0.0, 0.0)).is_err());
        assert!(Axis::linear("").range(0.0, f64::NAN).resolve(None, (0.0, 0.0)).is_err());
        assert_eq!(Scale::Decades.position(-1.0), None);
        assert_eq!(Scale::Linear.position(f64::INFINITY), None);
    }
}
