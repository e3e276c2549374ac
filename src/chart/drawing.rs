//! What a kind gives to be shown.

use super::{Figure, Pictures, Stepper, Table};

/// What a kind draws.
#[derive(Debug, Clone, PartialEq)]
pub enum Drawing {
    /// An SVG.
    Figure(Figure),
    /// A table.
    Table(Table),
    /// A figure that the reader steps through.
    Stepper(Stepper),
    /// Pictures made of pixels.
    Pictures(Pictures),
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

impl From<Stepper> for Drawing {
    fn from(stepper: Stepper) -> Self {
        Self::Stepper(stepper)
    }
}

impl From<Pictures> for Drawing {
    fn from(pictures: Pictures) -> Self {
        Self::Pictures(pictures)
    }
}

impl Drawing {
    /// Its drawing of lines, if it has one: of a stepper the last step, of pictures the chart below.
    pub fn figure(&self) -> Option<&Figure> {
        match self {
            Self::Figure(figure) | Self::Stepper(Stepper { figure, .. }) => Some(figure),
            Self::Pictures(pictures) => pictures.chart.as_ref(),
            Self::Table(_) => None,
        }
    }

    /// Everything of it that a reader can see, as text: what the lock's digest of a drawing covers.
    pub fn text(&self) -> String {
        match self {
            Self::Figure(figure) => figure.svg.clone(),
            Self::Table(table) => table.text(),
            Self::Stepper(stepper) => stepper.text(),
            Self::Pictures(pictures) => pictures.text(),
        }
    }
}
