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

impl Drawing {
    /// Everything of it that a reader can see, as text: what the lock's digest of a drawing covers.
    pub fn text(&self) -> String {
        match self {
            Self::Figure(figure) => figure.svg.clone(),
            Self::Table(table) => table.text(),
        }
    }
}
