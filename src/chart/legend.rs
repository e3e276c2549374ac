//! The key above the panels: a swatch and a name for each series, in rows.

use super::draw::Page;
use super::palette::{Role, Style};
use super::shape::{Ink, Kind};
use super::text::Rich;
use super::{Chart, ChartError, Layer};
use plotters_backend::text_anchor::{HPos, VPos};

/// What stands before a name.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Swatch {
    Line { width: f64, marked: bool },
    Mark,
    Block,
}

/// One series in the key.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Entry {
    label: Rich,
    style: Style,
    swatch: Swatch,
}

/// The height of a row, in units.
const ROW: f64 = 21.0;
/// The width of a swatch.
const SWATCH: f64 = 24.0;
/// The space between a swatch and its name.
const SPACE: f64 = 7.0;
/// The space between a name and the next swatch.
const GAP: f64 = 18.0;

impl Entry {
    fn of(layer: &Layer) -> Option<Self> {
        let (label, style, swatch) = match layer {
            Layer::Line(line) => {
                (&line.label, line.style, Swatch::Line { width: line.width.max(1.5), marked: line.marked })
            }
            Layer::Marks(marks) => (&marks.label, marks.style, Swatch::Mark),
            Layer::ErrorBars(bars) => (&bars.label, bars.style, Swatch::Line { width: 1.25, marked: false }),
            Layer::Bars(bars) => (&bars.label, bars.style, Swatch::Block),
            Layer::Band(band) => (&band.label, band.style, Swatch::Block),
            Layer::Area(area) => (&area.label, area.style, Swatch::Block),
            Layer::Boxes(boxes) => (&boxes.label, boxes.style, Swatch::Block),
            Layer::Disks(disks) => (&disks.label, disks.style, Swatch::Block),
            Layer::Segments(lines) => (&lines.label, lines.style, Swatch::Line { width: lines.width, marked: false }),
            // These carry their names where they are.
            Layer::Rule(_) | Layer::Region(_) | Layer::Image(_) | Layer::Note(_) => return None,
        };
        Some(Self { label: label.clone()?, style, swatch })
    }

    fn width(&self) -> f64 {
        SWATCH + SPACE + self.label.width()
    }
}

/// The named series of a chart, each once.
pub(super) fn entries(chart: &Chart) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    for entry in chart.panels.iter().flat_map(|panel| &panel.layers).filter_map(Entry::of) {
        if !entries.iter().any(|known| known.label == entry.label && known.style == entry.style) {
            entries.push(entry);
        }
    }
    entries
}

/// The entries in rows no wider than `width`.
pub(super) fn rows(entries: Vec<Entry>, width: f64) -> Vec<Vec<Entry>> {
    let mut rows: Vec<Vec<Entry>> = Vec::new();
    let mut used = f64::INFINITY;
    for entry in entries {
        let needed = entry.width() + GAP;
        if used + needed - GAP > width {
            rows.push(Vec::new());
            used = 0.0;
        }
        used += needed;
        if let Some(row) = rows.last_mut() {
            row.push(entry);
        }
    }
    rows
}

/// The height of the rows, with the space below them.
pub(super) fn height(rows: &[Vec<Entry>]) -> f64 {
    if rows.is_empty() { 0.0 } else { ROW * rows.len() as f64 + 8.0 }
}

/// The width of the longest row.
fn longest(rows: &[Vec<Entry>]) -> f64 {
    let long = |row: &Vec<Entry>| row.iter().map(|entry| entry.width() + GAP).sum::<f64>() - GAP;
    rows.iter().map(long).fold(0.0, f64::max)
}

/// Whether every row is within `width`: one entry alone may be wider.
pub(super) fn fits(rows: &[Vec<Entry>], width: f64) -> bool {
    longest(rows) <= width
}

/// Draws the rows from `(left, top)` on, or from further left where they would reach beyond `right`.
pub(super) fn draw(
    rows: &[Vec<Entry>],
    (left, top): (f64, f64),
    right: f64,
    page: &Page<'_>,
) -> Result<(), ChartError> {
    let left = left.min(right - longest(rows)).max(0.0);
    for (index, row) in rows.iter().enumerate() {
        let y = top + ROW * (index as f64 + 0.5);
        let mut x = left;
        for entry in row {
            swatch(entry, x, y, page)?;
            let text = (x + SWATCH + SPACE, y);
            page.text(&entry.label, text, (HPos::Left, VPos::Center), Role::Ink, false)?;
            x += entry.width() + GAP;
        }
    }
    Ok(())
}

fn swatch(entry: &Entry, x: f64, y: f64, page: &Page<'_>) -> Result<(), ChartError> {
    let Style { role, dash, marker } = entry.style;
    let middle = (x + SWATCH / 2.0, y);
    if let Swatch::Line { width, .. } = entry.swatch {
        let ink = Ink::new(role, width).dash(dash);
        page.shape(&[(x + 1.0, y), (x + SWATCH - 1.0, y)], Kind::Stroke(vec![2], ink))?;
    }
    if matches!(entry.swatch, Swatch::Mark | Swatch::Line { marked: true, .. }) {
        page.shape(&[middle], Kind::Marks(marker, 700, role))?;
    }
    if entry.swatch == Swatch::Block {
        let (left, right) = (x + 3.0, x + SWATCH - 1.0);
        let corners = [(left, y - 5.5), (right, y - 5.5), (right, y + 5.5), (left, y + 5.5)];
        let opacity = if role == Role::Fill { 1.0 } else { 0.3 };
        page.shape(&corners, Kind::Fill(vec![4], Ink::new(role, 1.0).opacity(opacity)))?;
    }
    Ok(())
}
