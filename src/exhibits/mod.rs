//! Exhibits as typed values: what a kind gives to be shown on a page. Turning them into HTML is `render`'s.

mod table;

pub use crate::chart::Figure;
pub use table::{Align, Cell, Column, Table};

/// What a kind draws.
#[derive(Debug, Clone, PartialEq)]
pub enum Drawing {
    /// An SVG.
    Figure(Figure),
    /// A table.
    Table(Table),
}

impl From<Figure> for Drawing {
    fn from(figure: Figure) -> Self {
        Self::Figure(figure)
    }
}

impl From<Table> for Drawing {
    fn from(table: Table) -> Self {
        Self::Table(table)
    }
}
