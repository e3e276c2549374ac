//! Where a piece of text that was taken out of a file stands in that file.

use std::ops::Range;

/// Maps the bytes of an extracted text to the bytes of its file, through runs that were copied as they stand.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct SourceMap {
    /// Runs `(start in the text, start in the file, length in the file)`, in the order of the text.
    runs: Vec<(usize, usize, usize)>,
}

impl SourceMap {
    /// A text that stands in its file as one run from `start`.
    pub fn whole(start: usize, length: usize) -> Self {
        Self { runs: vec![(0, start, length)] }
    }

    /// Adds a run: the text from `at` on stands at `range` in the file.
    pub fn push(&mut self, at: usize, range: Range<usize>) {
        self.runs.push((at, range.start, range.len()));
    }

    /// The place in the file of the byte `at` of the text.
    pub fn byte(&self, at: usize) -> usize {
        let after = self.runs.partition_point(|&(start, ..)| start <= at);
        match self.runs.get(after.saturating_sub(1)) {
            Some(&(start, place, length)) => place + at.saturating_sub(start).min(length),
            None => 0,
        }
    }

    /// The range in the file of the bytes `range` of the text.
    pub fn range(&self, range: Range<usize>) -> Range<usize> {
        let start = self.byte(range.start);
        // The end belongs to the run of the last byte, not to the run that begins there.
        let end = if range.end > range.start { self.byte(range.end - 1) + 1 } else { start };
        start..end.max(start)
    }

    /// The map of the part of the text that starts at `at`.
    #[must_use]
    pub fn from(&self, at: usize) -> Self {
        let first = self.runs.partition_point(|&(start, ..)| start <= at).saturating_sub(1);
        let shift = |&(start, place, length): &(usize, usize, usize)| match start.checked_sub(at) {
            Some(start) => (start, place, length),
            None => (0, place + (at - start).min(length), length - (at - start).min(length)),
        };
        Self { runs: self.runs.get(first..).unwrap_or_default().iter().map(shift).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::SourceMap;

    #[test]
    fn a_range_maps_through_the_run_that_holds_it() {
        let mut map = SourceMap::default();
        map.push(0, 10..14); // "abc\n" in a quote
        map.push(4, 16..20); // "def\n" after "> "
        assert_eq!(map.range(1..3), 11..13);
        assert_eq!(map.range(4..7), 16..19);
        assert_eq!(map.range(0..4), 10..14);
        assert_eq!(map.range(5..5), 17..17);
        assert_eq!(map.from(5).range(0..2), 17..19);
        assert_eq!(map.from(2).range(0..1), 12..13);
    }
}
