//! Histograms: counts of values in equal bins.

/// Counts of values in `counts.len()` equal bins of [`from`, `to`], the last bin closed; what falls
/// outside is counted apart, never dropped.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// The left end of the first bin.
    pub from: f64,
    /// The right end of the last bin.
    pub to: f64,
    /// How many values fell in each bin.
    pub counts: Vec<u64>,
    /// How many values lay below `from`.
    pub below: u64,
    /// How many values lay above `to`, or were not numbers.
    pub above: u64,
}

impl Histogram {
    /// Bins `values` in `bins` equal bins of [`from`, `to`]; `None` unless `bins > 0` and `from <
    /// to`, both finite.
    ///
    /// ```
    /// use workbook::stats::histogram::Histogram;
    /// let histogram = Histogram::new(&[0.0, 0.1, 0.5, 1.0, 2.0], 0.0, 1.0, 2).unwrap();
    /// assert_eq!((histogram.counts, histogram.above), (vec![2, 2], 1));
    /// ```
    pub fn new(values: &[f64], from: f64, to: f64, bins: usize) -> Option<Self> {
        let valid = bins > 0 && from < to && from.is_finite() && to.is_finite();
        if !valid {
            return None;
        }
        let mut histogram = Self { from, to, counts: vec![0; bins], below: 0, above: 0 };
        for &value in values {
            histogram.add(value);
        }
        Some(histogram)
    }

    fn add(&mut self, value: f64) {
        let last = self.counts.len() - 1;
        if value < self.from {
            self.below += 1;
        } else if value <= self.to {
            let bin = ((value - self.from) / (self.to - self.from) * self.counts.len() as f64) as usize;
            self.counts[bin.min(last)] += 1;
        } else {
            self.above += 1;
        }
    }

    /// The width of a bin.
    pub fn width(&self) -> f64 {
        (self.to - self.from) / self.counts.len() as f64
    }

    /// How many values there were, those outside included.
    pub fn total(&self) -> u64 {
        self.counts.iter().sum::<u64>() + self.below + self.above
    }

    /// For each bin its left end, its right end and the density of values in it, such that a
    /// density curve can be drawn over it.
    pub fn densities(&self) -> Vec<(f64, f64, f64)> {
        let (width, total) = (self.width(), self.total().max(1) as f64);
        let edge = |bin: usize| self.from + (self.to - self.from) * (bin as f64 / self.counts.len() as f64);
        self.counts
            .iter()
            .enumerate()
            .map(|(bin, &count)| (edge(bin), edge(bin + 1), count as f64 / total / width))
            .collect()
    }
}
