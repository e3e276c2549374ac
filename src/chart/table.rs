//! Tables, whose typed cells keep their numbers. Turning them into HTML is `render`'s.

use super::number;

/// How a column stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Align {
    /// At the left: words.
    Left,
    /// In the middle: marks and short codes.
    Centre,
    /// At the right: whole numbers, and decimals of the same number of places.
    Right,
}

/// The head of a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Plain words, with LaTeX between dollars: `estimate $F_N$`.
    pub head: String,
    /// How its cells stand.
    pub align: Align,
}

impl Column {
    /// A column of words.
    pub fn left(head: impl Into<String>) -> Self {
        Self { head: head.into(), align: Align::Left }
    }

    /// A column of marks or short codes.
    pub fn centre(head: impl Into<String>) -> Self {
        Self { head: head.into(), align: Align::Centre }
    }

    /// A column of numbers.
    pub fn right(head: impl Into<String>) -> Self {
        Self { head: head.into(), align: Align::Right }
    }
}

/// A cell: a value, and what is printed of it.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Nothing.
    Empty,
    /// Plain words.
    Text(String),
    /// A whole number.
    Integer(i64),
    /// A number, and its decimals as printed.
    Decimal {
        /// The number in full precision.
        value: f64,
        /// As printed.
        text: String,
    },
    /// LaTeX, without dollars.
    Math(String),
    /// A literal, such as digits in a base.
    Code(String),
    /// Whether something holds: a drawn tick or cross, and the words beside it.
    Holds {
        /// Whether it does.
        holds: bool,
        /// The words: `yes`, or in how many cases.
        text: String,
    },
}

impl Cell {
    /// Plain words.
    pub fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    /// Whether something holds, as yes or no.
    pub fn holds(holds: bool) -> Self {
        Self::Holds { holds, text: if holds { "yes" } else { "no" }.to_owned() }
    }

    /// A number with so many decimals.
    pub fn fixed(value: f64, places: usize) -> Self {
        Self::Decimal { value, text: number::fixed(value, places) }
    }

    /// A number with so many significant digits.
    pub fn significant(value: f64, digits: usize) -> Self {
        Self::Decimal { value, text: number::significant(value, digits) }
    }

    /// A number with its standard error, both to the error's second digit: `1.4246 ± 0.0067`.
    pub fn estimate(value: f64, error: f64) -> Self {
        if !(error.is_finite() && error > 0.0) {
            return Self::significant(value, 6);
        }
        let (_, exponent) = number::parts(error, 2);
        let places = (1 - exponent).clamp(0, 12) as usize;
        Self::Decimal { value, text: format!("{} ± {}", number::fixed(value, places), number::fixed(error, places)) }
    }

    /// What is printed: LaTeX and literals as they are written.
    pub fn printed(&self) -> String {
        match self {
            Self::Empty => String::new(),
            Self::Text(text)
            | Self::Math(text)
            | Self::Code(text)
            | Self::Decimal { text, .. }
            | Self::Holds { text, .. } => text.clone(),
            Self::Integer(value) => number::integer(*value),
        }
    }

    /// Whether it is a number, whose digits should align.
    pub fn is_number(&self) -> bool {
        matches!(self, Self::Integer(_) | Self::Decimal { .. })
    }
}

impl From<i64> for Cell {
    fn from(value: i64) -> Self {
        Self::Integer(value)
    }
}

impl From<usize> for Cell {
    fn from(value: usize) -> Self {
        i64::try_from(value).map_or_else(|_| Self::Text(value.to_string()), Self::Integer)
    }
}

/// A table: columns, and rows of as many cells.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// The heads of the columns.
    pub columns: Vec<Column>,
    /// The rows.
    pub rows: Vec<Vec<Cell>>,
    /// How many columns from the left name their row.
    pub row_heads: usize,
    /// How many rows from the bottom sum up the others, and are set off by a line.
    pub footers: usize,
}

impl Table {
    /// A table without rows, whose first column names them.
    pub fn new(columns: Vec<Column>) -> Self {
        Self { columns, rows: Vec::new(), row_heads: 1, footers: 0 }
    }

    /// With one more row, made as long as there are columns.
    #[must_use]
    pub fn row(mut self, cells: impl IntoIterator<Item = Cell>) -> Self {
        self.push(cells);
        self
    }

    /// Without the columns in which no row has anything; those that name rows stay.
    #[must_use]
    pub fn without_empty_columns(mut self) -> Self {
        let filled =
            |column: usize| self.rows.iter().any(|row| row.get(column).is_some_and(|cell| *cell != Cell::Empty));
        let kept: Vec<bool> = (0..self.columns.len()).map(|column| column < self.row_heads || filled(column)).collect();
        let keep = |index: &usize| kept.get(*index).copied().unwrap_or(true);
        self.columns =
            self.columns.into_iter().enumerate().filter(|(i, _)| keep(i)).map(|(_, column)| column).collect();
        for row in &mut self.rows {
            *row = std::mem::take(row).into_iter().enumerate().filter(|(i, _)| keep(i)).map(|(_, cell)| cell).collect();
        }
        self
    }

    /// The cells as printed: tabs between columns, lines between rows.
    pub fn text(&self) -> String {
        let heads = self.columns.iter().map(|column| column.head.clone()).collect::<Vec<_>>().join("\t");
        let rows = self.rows.iter().map(|row| row.iter().map(Cell::printed).collect::<Vec<_>>().join("\t"));
        std::iter::once(heads).chain(rows).collect::<Vec<_>>().join("\n")
    }

    /// Adds a row, made as long as there are columns.
    pub fn push(&mut self, cells: impl IntoIterator<Item = Cell>) {
        let mut cells: Vec<Cell> = cells.into_iter().collect();
        cells.resize(self.columns.len(), Cell::Empty);
        self.rows.push(cells);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_print_their_digits() {
        assert_eq!(Cell::estimate(1.424_612, 0.006_71).printed(), "1.4246 ± 0.0067");
        assert_eq!(Cell::estimate(123.0, 14.0).printed(), "123 ± 14");
        assert_eq!(Cell::estimate(1.5, f64::NAN).printed(), "1.50000");
        assert_eq!(Cell::fixed(-1.0, 1).printed(), "−1.0");
        assert_eq!(Cell::from(100_000_usize).printed(), "100\u{202f}000");
    }

    #[test]
    fn columns_without_values_can_be_left_out() {
        let table = Table::new(vec![Column::left("n"), Column::right("a"), Column::right("b")]);
        let table = table.row([Cell::Empty, Cell::Empty, Cell::from(1_usize)]).without_empty_columns();
        assert_eq!(table.text(), "n\tb\n\t1");
    }

    #[test]
    fn rows_are_as_long_as_the_columns() {
        let table = Table::new(vec![Column::left("n"), Column::right("$F_N$")]).row([Cell::from(1_usize)]);
        assert_eq!(table.rows, vec![vec![Cell::Integer(1), Cell::Empty]]);
    }
}
