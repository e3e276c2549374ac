//! Draws a placed panel: its frame, axes and words. The layers are `paint`'s.

use super::backend::{Backend, UNIT};
use super::layout::Plot;
use super::paint;
use super::palette::Role;
use super::shape::{Ink, Kind, Shape};
use super::text::Rich;
use super::ticks::Tick;
use super::{ChartError, Layer, strata};
use plotters::coord::Shift;
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingArea;
use plotters::element::{PathElement, Rectangle};
use plotters::prelude::{Cartesian2d, IntoDrawingArea};
use plotters_backend::text_anchor::{HPos, VPos};
use std::fmt::Display;

/// A panel's axes as plotters knows them.
pub(super) type Axes<'b> = DrawingArea<Backend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// The whole sheet.
pub(super) struct Page<'b> {
    root: DrawingArea<Backend<'b>, Shift>,
}

impl<'b> Page<'b> {
    /// A sheet of `size` hundredths that is written to `out`.
    pub fn new(out: &'b mut String, size: (u32, u32)) -> Self {
        Self { root: Backend::new(out, size).into_drawing_area() }
    }

    /// Ends the drawing.
    pub fn finish(&self) -> Result<(), ChartError> {
        self.root.present().map_err(failed)
    }

    /// Draws a shape at places in units.
    pub fn shape(&self, points: &[(f64, f64)], kind: Kind) -> Result<(), ChartError> {
        let points = points.iter().map(|&(x, y)| (whole(x), whole(y))).collect();
        self.root.draw(&Shape { points, kind }).map_err(failed)
    }

    /// Draws a shape at places in hundredths.
    pub fn shape_exact(&self, points: Vec<(i32, i32)>, kind: Kind) -> Result<(), ChartError> {
        self.root.draw(&Shape { points, kind }).map_err(failed)
    }

    /// Writes words at a place in units.
    pub fn text(
        &self,
        text: &Rich,
        at: (f64, f64),
        anchor: (HPos, VPos),
        role: Role,
        bold: bool,
    ) -> Result<(), ChartError> {
        self.shape(&[at], Kind::Text { text: text.clone(), anchor, role, bold })
    }

    /// The axes of a panel.
    pub fn axes(&self, plot: &Plot<'_>) -> Axes<'b> {
        let (rect, window) = (plot.rect, plot.window);
        let actual = (rect.left..rect.right, rect.bottom..rect.top);
        self.root.apply_coord_spec(Cartesian2d::new(window.x.0..window.x.1, window.y.0..window.y.1, actual))
    }
}

/// The error of plotters as ours.
pub(super) fn failed(error: impl Display) -> ChartError {
    ChartError::Drawing(error.to_string())
}

/// Hundredths of `units`.
pub(super) fn whole(units: f64) -> i32 {
    (units * UNIT).round() as i32
}

/// Draws a placed panel.
pub(super) fn plot(plot: &Plot<'_>, page: &Page<'_>) -> Result<(), ChartError> {
    let axes = page.axes(plot);
    if plot.panel.square {
        borders(plot, page)?;
    } else {
        grid(plot, page)?;
    }
    let drawn = paint::layers(plot, page, &axes)?;
    if drawn == 0 {
        return Err(ChartError::Empty { panel: plot.index });
    }
    if plot.panel.square {
        let rect = plot.rect;
        let frame =
            Rectangle::new([(rect.left, rect.top), (rect.right, rect.bottom)], Ink::new(Role::Axis, 1.0).style(false));
        page.root.draw(&frame).map_err(failed)?;
        rug(plot, page)?;
    } else {
        lines(plot, page)?;
    }
    labels(plot, page)?;
    words(plot, page)
}

/// The borders of strata on the unit square, each line once.
fn borders(plot: &Plot<'_>, page: &Page<'_>) -> Result<(), ChartError> {
    let rect = plot.rect;
    for (index, cells) in plot.panel.strata.iter().enumerate() {
        let (mut points, mut ends) = (Vec::new(), Vec::new());
        for x in strata::borders(cells.columns, rect.right - rect.left) {
            points.extend([(rect.left + x, rect.top), (rect.left + x, rect.bottom)]);
            ends.push(points.len());
        }
        for y in strata::borders(cells.rows, rect.bottom - rect.top) {
            points.extend([(rect.left, rect.bottom - y), (rect.right, rect.bottom - y)]);
            ends.push(points.len());
        }
        if points.is_empty() {
            continue;
        }
        // The first strata are the coarser ones of interest; many lines are drawn thinner.
        let width = if index == 0 && ends.len() <= 70 { 0.9 } else { 0.5 };
        page.shape_exact(points, Kind::Stroke(ends, Ink::new(Role::Strata, width)))?;
    }
    Ok(())
}

/// The room that the ticks of a rug need beyond the frame, in units.
pub(super) const RUG: f64 = 14.0;

/// The coordinates of all marks as ticks above and at the right of the frame.
fn rug(plot: &Plot<'_>, page: &Page<'_>) -> Result<(), ChartError> {
    let (rect, panel) = (plot.rect, plot.panel);
    if !panel.rug {
        return Ok(());
    }
    for layer in &panel.layers {
        let Layer::Marks(marks) = layer else { continue };
        let (mut points, mut ends) = (Vec::new(), Vec::new());
        let (width, height) = (rect.right - rect.left, rect.bottom - rect.top);
        let all = || panel.strata.iter().chain(&panel.kept);
        for &(x, y) in &marks.points {
            let x = rect.left + strata::written(x, width, all().map(|s| s.columns));
            let y = rect.bottom - strata::written(y, height, all().map(|s| s.rows));
            points.extend([(x, rect.top - 300), (x, rect.top - 1100), (rect.right + 300, y), (rect.right + 1100, y)]);
            ends.extend([points.len() - 2, points.len()]);
        }
        let width = if marks.points.len() > 64 { 0.6 } else { 1.4 };
        page.shape_exact(points, Kind::Stroke(ends, Ink::new(marks.style.role, width)))?;
    }
    Ok(())
}

/// Where ticks stand, in hundredths from the axis's start.
fn places(ticks: &[Tick], (low, high): (f64, f64), length: i32) -> impl Iterator<Item = (i32, &Tick)> {
    ticks.iter().filter_map(move |tick| {
        let share = (tick.at - low) / (high - low);
        (-1e-6..=1.0 + 1e-6).contains(&share).then(|| ((share * f64::from(length)).round() as i32, tick))
    })
}

/// Faint lines at the labelled ticks.
fn grid(plot: &Plot<'_>, page: &Page<'_>) -> Result<(), ChartError> {
    let (rect, panel) = (plot.rect, plot.panel);
    let (mut points, mut ends) = (Vec::new(), Vec::new());
    if !panel.y.hidden {
        for (y, _) in places(&plot.y_ticks, plot.window.y, rect.bottom - rect.top)
            .filter(|(y, tick)| *y > 0 && tick.label.is_some())
        {
            points.extend([(rect.left, rect.bottom - y), (rect.right, rect.bottom - y)]);
            ends.push(points.len());
        }
    }
    if !panel.x.hidden && panel.x.scale.is_log() {
        for (x, _) in places(&plot.x_ticks, plot.window.x, rect.right - rect.left)
            .filter(|(x, tick)| *x > 0 && tick.label.is_some())
        {
            points.extend([(rect.left + x, rect.top), (rect.left + x, rect.bottom)]);
            ends.push(points.len());
        }
    }
    if points.is_empty() { Ok(()) } else { page.shape_exact(points, Kind::Stroke(ends, Ink::new(Role::Grid, 0.75))) }
}

/// The lines of the axes with their ticks.
fn lines(plot: &Plot<'_>, page: &Page<'_>) -> Result<(), ChartError> {
    let (rect, panel) = (plot.rect, plot.panel);
    let ink = Ink::new(Role::Axis, 1.0);
    let (mut points, mut ends) = (Vec::new(), Vec::new());
    let length = |tick: &Tick| if tick.label.is_some() { 500 } else { 300 };
    if !panel.x.hidden {
        let (low, high) = plot.window.x;
        let begun = panel.x.from.and_then(|value| panel.x.scale.position(value));
        let share = begun.map_or(0.0, |at| ((at - low) / (high - low)).clamp(0.0, 1.0));
        let left = rect.left + (share * f64::from(rect.right - rect.left)).round() as i32;
        page.root
            .draw(&PathElement::new([(left, rect.bottom), (rect.right, rect.bottom)], ink.style(false)))
            .map_err(failed)?;
        for (x, tick) in places(&plot.x_ticks, plot.window.x, rect.right - rect.left) {
            points.extend([(rect.left + x, rect.bottom), (rect.left + x, rect.bottom + length(tick))]);
            ends.push(points.len());
        }
    }
    if !panel.y.hidden {
        page.root
            .draw(&PathElement::new([(rect.left, rect.top), (rect.left, rect.bottom)], ink.style(false)))
            .map_err(failed)?;
        for (y, tick) in places(&plot.y_ticks, plot.window.y, rect.bottom - rect.top) {
            points.extend([(rect.left, rect.bottom - y), (rect.left - length(tick), rect.bottom - y)]);
            ends.push(points.len());
        }
    }
    if points.is_empty() { Ok(()) } else { page.shape_exact(points, Kind::Stroke(ends, ink)) }
}

/// The labels of ticks.
fn labels(plot: &Plot<'_>, page: &Page<'_>) -> Result<(), ChartError> {
    let (rect, panel) = (plot.rect, plot.panel);
    let gap = if panel.square { 500 } else { 800 };
    let text = |label: &Rich, at, anchor| {
        let kind = Kind::Text { text: label.clone(), anchor, role: Role::Axis, bold: false };
        page.shape_exact(vec![at], kind)
    };
    if plot.labelled.0 && !panel.x.hidden {
        for (x, tick) in places(&plot.x_ticks, plot.window.x, rect.right - rect.left) {
            if let Some(label) = &tick.label {
                text(label, (rect.left + x, rect.bottom + gap), (HPos::Center, VPos::Top))?;
            }
        }
    }
    if plot.labelled.1 && !panel.y.hidden {
        for (y, tick) in places(&plot.y_ticks, plot.window.y, rect.bottom - rect.top) {
            if let Some(label) = &tick.label {
                text(label, (rect.left - gap, rect.bottom - y), (HPos::Right, VPos::Center))?;
            }
        }
    }
    Ok(())
}

/// The height of a line of a title, in units.
pub(super) const TITLE: f64 = 17.0;

/// The titles of the panel and of its axes, and what is not shown.
fn words(plot: &Plot<'_>, page: &Page<'_>) -> Result<(), ChartError> {
    let (rect, panel) = (plot.rect, plot.panel);
    let unit = |hundredths: i32| f64::from(hundredths) / UNIT;
    let middle = f64::midpoint(unit(rect.left), unit(rect.right));
    let (top, cell) = plot.head;
    for (row, line) in plot.title.iter().enumerate() {
        let at = (middle, top + 15.0 + TITLE * row as f64);
        page.text(line, at, (HPos::Center, VPos::Bottom), Role::Ink, true)?;
    }
    if plot.labelled.1 && !panel.y.title.is_empty() {
        let at = (cell + 2.0, unit(rect.top) - 12.0);
        page.text(&panel.y.title, at, (HPos::Left, VPos::Bottom), Role::Ink, false)?;
    }
    let mut below = unit(rect.bottom) + if plot.labelled.0 && !panel.x.hidden { 24.0 } else { 4.0 };
    if plot.labelled.0 && !panel.x.title.is_empty() {
        page.text(&panel.x.title, (middle, below + 4.0), (HPos::Center, VPos::Top), Role::Ink, false)?;
        below += 20.0;
    }
    if let Some(told) = plot.extent.told() {
        page.text(&Rich::plain(&told), (unit(rect.right), below + 4.0), (HPos::Right, VPos::Top), Role::Axis, false)?;
    }
    Ok(())
}
