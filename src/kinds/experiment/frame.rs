//! Frames: the data of a result as named columns, for whoever wants the numbers rather than the picture.

/// One column's entries.
#[derive(Debug, Clone, PartialEq)]
pub enum Entries {
    /// Numbers; NaN stands for one that does not exist.
    Numbers(Vec<f64>),
    /// Counts.
    Integers(Vec<i64>),
    /// Words.
    Text(Vec<String>),
}

impl Entries {
    /// The number of entries.
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(numbers) => numbers.len(),
            Self::Integers(integers) => integers.len(),
            Self::Text(words) => words.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Named columns of equal length.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// What the frame holds, as part of a file name: `rmse`.
    pub name: &'static str,
    /// The columns in order, each with its name.
    pub columns: Vec<(String, Entries)>,
}

impl Frame {
    /// A frame without columns.
    pub fn new(name: &'static str) -> Self {
        Self { name, columns: Vec::new() }
    }

    /// With a column of numbers.
    #[must_use]
    pub fn numbers(mut self, name: impl Into<String>, numbers: impl IntoIterator<Item = f64>) -> Self {
        self.columns.push((name.into(), Entries::Numbers(numbers.into_iter().collect())));
        self
    }

    /// With a column of counts.
    #[must_use]
    pub fn counts(mut self, name: impl Into<String>, counts: impl IntoIterator<Item = usize>) -> Self {
        self.columns.push((name.into(), Entries::Integers(counts.into_iter().map(|count| count as i64).collect())));
        self
    }

    /// With a column of words.
    #[must_use]
    pub fn text(mut self, name: impl Into<String>, words: impl IntoIterator<Item = String>) -> Self {
        self.columns.push((name.into(), Entries::Text(words.into_iter().collect())));
        self
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.columns.iter().map(|(_, entries)| entries.len()).max().unwrap_or(0)
    }
}
