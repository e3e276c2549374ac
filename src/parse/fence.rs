//! Fences that the workbook reads: `experiment` and `listing`, whose content is TOML.

use std::ops::Range;

use super::source_map::SourceMap;

/// A fence as written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fence {
    /// The text between the fences.
    pub text: String,
    /// Where each byte of that text stands in the file.
    pub map: SourceMap,
    /// The whole fence in the file.
    pub range: Range<usize>,
}

impl Fence {
    /// The first line of the fence, for complaints about the fence as a whole.
    pub fn head(&self, file: &str) -> Range<usize> {
        let line = file.get(self.range.clone()).and_then(|text| text.lines().next()).unwrap_or_default();
        self.range.start..self.range.start + line.len()
    }
}
