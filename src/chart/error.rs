//! Why a chart cannot be drawn.

use std::fmt;

/// Why a chart cannot be drawn.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ChartError {
    /// The chart has no panel.
    NoPanel,
    /// A panel has nothing that can be drawn: no data, or none that is finite and on the axes.
    Empty {
        /// The panel, counted from 0.
        panel: usize,
    },
    /// An axis was given a range that is not one: reversed, empty, not finite, or not positive for a logarithm.
    Range {
        /// The lower end that was given.
        low: f64,
        /// The upper end that was given.
        high: f64,
    },
    /// Columns that belong together have different lengths, e.g. n + 1 edges for n bars.
    Lengths {
        /// What they are.
        what: &'static str,
        /// The one length.
        left: usize,
        /// The other.
        right: usize,
    },
    /// The sheet is too narrow for the panels and their labels.
    Narrow {
        /// The width of the sheet.
        width: f64,
        /// A width that would do.
        needed: f64,
    },
    /// The drawing itself failed.
    Drawing(String),
}

impl fmt::Display for ChartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoPanel => write!(f, "the chart has no panel"),
            Self::Empty { panel } => {
                write!(f, "panel {} has nothing to draw: no value is finite and on its axes", panel + 1)
            }
            Self::Range { low, high } => write!(f, "an axis cannot run from {low} to {high}"),
            Self::Lengths { what, left, right } => write!(f, "{what}: {left} and {right} do not fit together"),
            Self::Narrow { width, needed } => {
                write!(f, "a width of {width} is too narrow for the chart: it needs {needed}")
            }
            Self::Drawing(message) => write!(f, "{message}"),
        }
    }
}

impl std::error::Error for ChartError {}
