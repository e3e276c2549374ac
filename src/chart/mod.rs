//! The drawing kit: from typed series to an SVG that could be printed in a textbook.
//!
//! A [`Chart`] is a grid of [`Panel`]s; a panel has two axes and [`Layer`]s. [`Chart::draw`] lays them out on a [`Sheet`] and
//! writes a [`Figure`]. The kit computes no statistics: what is drawn was computed before.
//!
//! Invariants: the same chart gives the same bytes everywhere; coordinates are whole hundredths of a unit; what cannot be
//! drawn is a [`ChartError`] or is told in the figure, and never left out in silence.

mod axis;
mod backend;
mod direct;
mod disk;
mod draw;
mod drawing;
mod error;
mod geometry;
mod layer;
mod layout;
mod legend;
pub mod number;
mod paint;
pub mod palette;
mod panel;
mod path;
mod picture;
mod resolve;
mod shape;
mod stepper;
pub mod strata;
mod table;
mod text;
mod ticks;

pub use axis::Axis;

pub use disk::{Boxes, Disks, Segments};
pub use drawing::Drawing;
pub use error::ChartError;
pub use layer::{Area, Band, Bars, Corner, ErrorBars, Image, Layer, Line, Marks, Note, Region, Rule};
pub use palette::{Dash, Marker, Role, Style};
pub use panel::{Chart, Key, Panel};
pub use picture::{Picture, Pictures};
pub use stepper::{KeyStep, MOST_STEPS, Stepper, Steps};
pub use strata::Strata;
pub use table::{Align, Cell, Column, Table};
pub use text::Rich;

/// The package that draws.
pub const PACKAGE: &str = "plotters";

/// What a drawing is told from outside: whose it is, its words, and how wide it may be.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// The exhibit's id: every id within the SVG begins with it.
    pub id: String,
    /// The drawing's name, read out first.
    pub title: String,
    /// What there is to see, for who cannot see it.
    pub description: String,
    /// The width in units; a unit is a CSS pixel where there is room for the whole width.
    pub width: f64,
}

impl Sheet {
    /// The width that suits a column of text: full size on a desk, still readable when a phone halves it.
    pub const WIDTH: f64 = 600.0;

    /// A sheet of the usual width.
    pub fn new(id: impl Into<String>, title: impl Into<String>, description: impl Into<String>) -> Self {
        Self { id: id.into(), title: title.into(), description: description.into(), width: Self::WIDTH }
    }
}

/// A drawing as a file has the faces that are there, of which some are wider than the one that it was measured with: they are set smaller.
const ADJUST: &str = " style=\"font-size-adjust:.45\"";

/// A finished drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The `<svg>` element: right as a file of its own, and themed by [`palette::css`] where it stands in a page.
    pub svg: String,
    /// Its width in units.
    pub width: f64,
    /// Its height in units.
    pub height: f64,
}

impl Figure {
    /// The drawing as it stands in a page: without the colours of its own, as [`palette::css`] gives them by class.
    pub fn in_a_page(&self) -> String {
        let mut out = String::with_capacity(self.svg.len());
        let mut rest = self.svg.as_str();
        while let Some((head, tail)) = rest.split_once("=\"#") {
            let kept = head.strip_suffix(" fill").or_else(|| head.strip_suffix(" stroke"));
            if let Some((kept, tail)) = kept.zip(tail.get(6..).and_then(|tail| tail.strip_prefix('"'))) {
                out.push_str(kept);
                rest = tail;
            } else {
                out.push_str(head);
                out.push_str("=\"#");
                rest = tail;
            }
        }
        out.push_str(rest);
        out.replacen(ADJUST, "", 1)
    }
}

#[cfg(test)]
mod tests;
