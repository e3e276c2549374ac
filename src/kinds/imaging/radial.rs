//! The radial means of the spectra of errors, as a chart.

use super::RINGS;
use crate::chart::{Axis, Chart, ChartError, Dash, Figure, Line, Marker, Panel, Role, Rule, Sheet, Style};

/// One line of the chart.
pub struct Radial<'a> {
    /// What it is called.
    pub title: &'a str,
    /// The method, which gives the style where no other line is of it.
    pub method: &'a str,
    /// The mean power in each ring.
    pub rings: &'a [f64],
}

/// The middle of a ring, in cycles a pixel.
pub fn middle(ring: usize) -> f64 {
    (ring as f64 + 0.5) / (2.0 * RINGS as f64)
}

/// The radial means of the spectra.
pub fn radial(all: &[Radial<'_>], sheet: &Sheet) -> Result<Figure, ChartError> {
    const DASHES: [Dash; 4] = [Dash::Solid, Dash::Dashed, Dash::DashDot, Dash::Long];
    const MARKERS: [Marker; 4] = [Marker::Disc, Marker::Square, Marker::Up, Marker::Diamond];
    const ROLES: [Role; 4] = [Role::Vermilion, Role::Blue, Role::Green, Role::Purple];
    let line = |(index, it): (usize, &Radial<'_>)| {
        let rings = it.rings.iter().enumerate();
        let points = rings.filter(|(_, power)| **power > 0.0).map(|(ring, &power)| (middle(ring), power));
        // Lines of one method differ in something else, and need styles of their own.
        let alone = all.iter().filter(|other| other.method == it.method).count() == 1;
        let own = Style { role: ROLES[index % 4], dash: DASHES[index % 4], marker: MARKERS[index % 4] };
        let style = if alone { Style::of(it.method) } else { own };
        Line::new(points.collect()).style(style).marked().label(it.title)
    };
    let flat = Rule::horizontal(1.0).style(Style::THEORY).label("independent pixels");
    let panel = Panel::new(Axis::linear("frequency in cycles a pixel").range(0.0, 0.5), Axis::log("mean power"));
    let panel = panel.ratio(0.5).with(flat).with_all(all.iter().enumerate().map(line));
    Chart::new(panel).draw(sheet)
}
