//! Paints the layers of a panel on its axes.

use super::backend::UNIT;
use super::direct::{LINE, TAIL, spread};
use super::draw::{Axes, Page, failed};
use super::geometry::{Lines, polygon, stairs, thinned};
use super::layout::Plot;
use super::palette::{Dash, Marker, Role, Style};
use super::resolve::{between, positions, rectangles, under};
use super::shape::{Ink, Kind, Shape};
use super::strata::{self, Strata};
use super::text::Rich;
use super::{Boxes, ChartError, Corner, Disks, ErrorBars, Image, Layer, Line, Marks, Note, Region, Rule, Segments};
use plotters::element::{PathElement, Rectangle};
use plotters_backend::text_anchor::{HPos, VPos};

/// A painter at work on one panel.
struct Painter<'p, 'b> {
    plot: &'p Plot<'p>,
    page: &'p Page<'b>,
    axes: &'p Axes<'b>,
    /// How many things were drawn.
    drawn: usize,
    /// Names that belong at the ends of lines: where the line ends in hundredths, its role and its name.
    ends: Vec<((i32, i32), Role, &'p Rich)>,
}

/// Draws all layers; how many of them left a trace.
pub(super) fn layers<'b>(plot: &Plot<'_>, page: &Page<'b>, axes: &Axes<'b>) -> Result<usize, ChartError> {
    let mut painter = Painter { plot, page, axes, drawn: 0, ends: Vec::new() };
    for layer in &plot.panel.layers {
        painter.layer(layer)?;
    }
    painter.names()?;
    Ok(painter.drawn)
}

impl<'p> Painter<'p, '_> {
    fn layer(&mut self, layer: &'p Layer) -> Result<(), ChartError> {
        let (sx, sy) = (self.plot.panel.x.scale, self.plot.panel.y.scale);
        match layer {
            Layer::Line(line) => self.line(line),
            Layer::Marks(marks) => self.marks(marks),
            Layer::ErrorBars(bars) => self.error_bars(bars),
            Layer::Band(band) => self.fill(between(&band.points, sx, sy), band.style.role, 0.2),
            Layer::Area(area) => {
                let opacity = if area.style.role == Role::Fill { 0.45 } else { 0.25 };
                self.fill(under(area, sx, sy), area.style.role, opacity)
            }
            Layer::Bars(bars) => {
                let bodies = rectangles(bars, sx, sy);
                let thin = bodies.len() > 120;
                self.fill(bodies.clone(), bars.style.role, if bars.style.role == Role::Fill { 1.0 } else { 0.7 })?;
                if thin { Ok(()) } else { self.outlines(&bodies) }
            }
            Layer::Rule(rule) => self.rule(rule),
            Layer::Region(region) => self.region(region),
            Layer::Image(image) => self.image(image),
            Layer::Note(note) => self.note(note),
            Layer::Disks(disks) => self.disks(disks),
            Layer::Segments(segments) => self.segments(segments),
            Layer::Boxes(boxes) => self.boxes(boxes),
        }
    }

    /// Draws a shape at positions along the axes.
    fn shape(&mut self, points: Vec<(f64, f64)>, kind: Kind) -> Result<(), ChartError> {
        if points.is_empty() {
            return Ok(());
        }
        self.drawn += 1;
        self.axes.draw(&Shape { points, kind }).map_err(failed)
    }

    fn line(&mut self, line: &'p Line) -> Result<(), ChartError> {
        let (sx, sy) = (self.plot.panel.x.scale, self.plot.panel.y.scale);
        let points = if line.stepped { stairs(&line.points) } else { line.points.clone() };
        let rect = self.plot.rect;
        let columns = ((rect.right - rect.left) / 100).max(1) as usize;
        let places = thinned(positions(&points, sx, sy), &self.plot.window, columns);
        let lines = Lines::clipped(places.into_iter(), &self.plot.window);
        let words = if self.plot.direct { &line.label } else { &line.tail };
        if let (Some(words), Some(end)) = (words, lines.points.last()) {
            self.ends.push((self.axes.map_coordinate(end), line.style.role, words));
        }
        let ink = Ink::new(line.style.role, line.width).dash(line.style.dash).opacity(line.opacity);
        self.shape(lines.points, Kind::Stroke(lines.ends, ink))?;
        if line.marked {
            let points = positions(&line.points, sx, sy);
            let points = points.into_iter().flatten().filter(|&p| self.plot.window.contains(p)).collect();
            self.shape(points, Kind::Marks(line.style.marker, 640, line.style.role))?;
        }
        Ok(())
    }

    fn marks(&mut self, marks: &Marks) -> Result<(), ChartError> {
        let panel = self.plot.panel;
        let places = positions(&marks.points, panel.x.scale, panel.y.scale);
        let on = |p: &(f64, f64)| self.plot.window.contains(*p);
        let points: Vec<(f64, f64)> = places.iter().flatten().copied().filter(on).collect();
        let size = marks.size.unwrap_or_else(|| size(points.len().max(marks.among), self.side()));
        let points = if panel.square { self.inside(points) } else { points };
        for (place, name) in places.iter().zip(&marks.names) {
            let Some(place) = place.filter(on) else { continue };
            let (x, y) = self.axes.map_coordinate(&place);
            let away = size * 0.5 + 2.0;
            let at = (f64::from(x) / UNIT + away, f64::from(y) / UNIT - away);
            self.page.text(name, at, (HPos::Left, VPos::Bottom), Role::Axis, false)?;
        }
        let diameter = (size.clamp(0.3, 40.0) * UNIT).round() as i32;
        // Shapes tell small series apart; of many marks they would only blur the pattern.
        let marker = if places.len().max(marks.among) > 300 { Marker::Disc } else { marks.style.marker };
        let kind = Kind::Marks(marker, diameter, marks.style.role);
        let Some(name) = marks.tracked else { return self.shape(points, kind) };
        for (index, point) in points.into_iter().enumerate() {
            let key = format!("{}-{name}-{index}", self.plot.index);
            self.shape(vec![point], Kind::Tracked(key, Box::new(kind.clone())))?;
        }
        Ok(())
    }

    fn disks(&mut self, disks: &Disks) -> Result<(), ChartError> {
        let (panel, rect, window) = (self.plot.panel, self.plot.rect, self.plot.window);
        let centres: Vec<_> = positions(&disks.points, panel.x.scale, panel.y.scale).into_iter().flatten().collect();
        let length = |(low, high): (f64, f64), pixels: i32| {
            let length = disks.radius * f64::from(pixels) / (high - low);
            if length.is_finite() { length.clamp(0.0, 1e7).round() as i32 } else { 0 }
        };
        let radii = (length(window.x, rect.right - rect.left), length(window.y, rect.bottom - rect.top));
        let Style { role, dash, .. } = disks.style;
        let ink = Ink::new(role, 1.0).dash(dash);
        let filled = (disks.opacity.clamp(0.0, 1.0) * 100.0).round() as u8;
        self.shape(centres, Kind::Disks { radii, rect, ink, filled })
    }

    fn segments(&mut self, segments: &Segments) -> Result<(), ChartError> {
        let panel = self.plot.panel;
        let line = segments.pairs.iter().flat_map(|ends| {
            let places = positions(ends, panel.x.scale, panel.y.scale);
            std::iter::once(None).chain(places)
        });
        let lines = Lines::clipped(line, &self.plot.window);
        let Style { role, dash, .. } = segments.style;
        let ink = Ink::new(role, segments.width).dash(dash).opacity(segments.opacity);
        let Some(name) = segments.tracked else { return self.shape(lines.points, Kind::Stroke(lines.ends, ink)) };
        let starts = std::iter::once(0).chain(lines.ends.iter().copied()).zip(&lines.ends).map(|(start, _)| start);
        for (index, point) in starts.filter_map(|start| lines.points.get(start)).enumerate() {
            let key = format!("{}-{name}-{index}", self.plot.index);
            self.shape(vec![*point], Kind::Tracked(key, Box::new(Kind::Stroke(vec![1], ink))))?;
        }
        Ok(())
    }

    fn boxes(&mut self, boxes: &Boxes) -> Result<(), ChartError> {
        let (panel, window) = (self.plot.panel, self.plot.window);
        let inside = |v: f64, (low, high): (f64, f64)| v.clamp(low, high);
        let body = |corners: &[(f64, f64); 2]| {
            let places = positions(corners, panel.x.scale, panel.y.scale);
            let [Some(a), Some(b)] = places[..] else { return None };
            let [a, b] = [a, b].map(|p| (inside(p.0, window.x), inside(p.1, window.y)));
            (a.0 != b.0 && a.1 != b.1).then_some([a, (b.0, a.1), b, (a.0, b.1)])
        };
        let bodies: Vec<[(f64, f64); 4]> = boxes.corners.iter().filter_map(body).collect();
        let ends: Vec<usize> = (1..=bodies.len()).map(|index| index * 4).collect();
        let points = bodies.into_flattened();
        let ink = Ink::new(boxes.style.role, 1.25).dash(boxes.style.dash);
        if boxes.outlined {
            let filled = (boxes.opacity.clamp(0.0, 1.0) * 100.0).round() as u8;
            self.shape(points, Kind::Body(ends, ink, filled))
        } else {
            self.shape(points, Kind::Fill(ends, ink.opacity(boxes.opacity)))
        }
    }

    /// The points of a unit square where they are strictly inside their strata as written.
    fn inside(&self, points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
        let (rect, panel) = (self.plot.rect, self.plot.panel);
        let (width, height) = (rect.right - rect.left, rect.bottom - rect.top);
        let all = || panel.strata.iter().chain(&panel.kept);
        let place = |value: f64, length: i32, count: fn(&Strata) -> u32| {
            // Half a hundredth more, so that plotters' rounding finds just this hundredth.
            (f64::from(strata::written(value, length, all().map(count))) + 0.5) / f64::from(length)
        };
        let place = |(x, y)| (place(x, width, |s| s.columns), place(y, height, |s| s.rows));
        points.into_iter().map(place).collect()
    }

    /// The shorter side of the plot, in units.
    fn side(&self) -> f64 {
        let rect = self.plot.rect;
        f64::from((rect.right - rect.left).min(rect.bottom - rect.top)) / UNIT
    }

    fn error_bars(&mut self, bars: &ErrorBars) -> Result<(), ChartError> {
        let (sx, sy) = (self.plot.panel.x.scale, self.plot.panel.y.scale);
        let window = self.plot.window;
        let cap = (window.x.1 - window.x.0) * 3.0 * UNIT / f64::from(self.plot.rect.right - self.plot.rect.left);
        let mut line = Vec::new();
        for &(x, low, high) in &bars.points {
            let (Some(x), Some(low), Some(high)) =
                (sx.position(x), sy.position_or_below(low), sy.position_or_below(high))
            else {
                continue;
            };
            let spans = [[(x, low), (x, high)], [(x - cap, low), (x + cap, low)], [(x - cap, high), (x + cap, high)]];
            for [from, to] in spans {
                line.extend([None, Some(from), Some(to)]);
            }
        }
        let lines = Lines::clipped(line.into_iter(), &window);
        self.shape(lines.points, Kind::Stroke(lines.ends, Ink::new(bars.style.role, 1.25)))
    }

    /// Fills polygons as one path.
    fn fill(&mut self, bodies: Vec<Vec<(f64, f64)>>, role: Role, opacity: f64) -> Result<(), ChartError> {
        let (points, ends) = self.cut(bodies);
        self.shape(points, Kind::Fill(ends, Ink::new(role, 1.0).opacity(opacity)))
    }

    /// Separates bars by lines in the page's colour.
    fn outlines(&mut self, bodies: &[Vec<(f64, f64)>]) -> Result<(), ChartError> {
        let (mut points, mut ends) = (Vec::new(), Vec::new());
        let window = self.plot.window;
        for body in bodies {
            if let [foot, head, ..] = body[..] {
                let line = Lines::clipped([Some(foot), Some(head)].into_iter(), &window);
                points.extend(line.points);
                ends.push(points.len());
            }
        }
        self.shape(points, Kind::Stroke(ends, Ink::new(Role::Page, 1.0)))
    }

    /// The polygons within the window, in one list.
    fn cut(&self, bodies: Vec<Vec<(f64, f64)>>) -> (Vec<(f64, f64)>, Vec<usize>) {
        let (mut points, mut ends) = (Vec::new(), Vec::new());
        for body in bodies {
            points.extend(polygon(body, &self.plot.window));
            if points.len() > ends.last().copied().unwrap_or(0) {
                ends.push(points.len());
            }
        }
        (points, ends)
    }

    fn rule(&mut self, rule: &'p Rule) -> Result<(), ChartError> {
        let (panel, window) = (self.plot.panel, self.plot.window);
        let scale = if rule.vertical { panel.x.scale } else { panel.y.scale };
        let Some(at) = scale.position(rule.at) else { return Ok(()) };
        let ends =
            if rule.vertical { [(at, window.y.0), (at, window.y.1)] } else { [(window.x.0, at), (window.x.1, at)] };
        if !ends.iter().all(|&end| window.contains(end)) {
            return Ok(());
        }
        let ink = Ink::new(rule.style.role, 1.25).dash(rule.style.dash);
        self.drawn += 1;
        self.axes.draw(&PathElement::new(ends, ink.style(false))).map_err(failed)?;
        let Some(label) = &rule.label else { return Ok(()) };
        let end = self.axes.map_coordinate(&ends[1]);
        if self.plot.ruled && !rule.vertical {
            self.ends.push((end, rule.style.role, label));
            return Ok(());
        }
        let (x, y) = (f64::from(end.0) / UNIT, f64::from(end.1) / UNIT);
        let right = f64::from(self.plot.rect.right) / UNIT;
        let (at, anchor) = match rule.vertical {
            true if x + 6.0 + label.width() > right => ((x - 6.0, y + 2.0), (HPos::Right, VPos::Top)),
            true => ((x + 6.0, y + 2.0), (HPos::Left, VPos::Top)),
            false => ((x - 2.0, y - 5.0), (HPos::Right, VPos::Bottom)),
        };
        self.page.text(label, at, anchor, Role::Ink, false)
    }

    fn region(&mut self, region: &Region) -> Result<(), ChartError> {
        let (sx, sy, window) = (self.plot.panel.x.scale, self.plot.panel.y.scale, self.plot.window);
        let corners = positions(&[region.from, region.to], sx, sy);
        let [Some(a), Some(b)] = corners[..] else { return Ok(()) };
        let inside = |v: f64, (low, high): (f64, f64)| v.clamp(low, high);
        let corners = [a, b].map(|p| (inside(p.0, window.x), inside(p.1, window.y)));
        if corners[0].0 == corners[1].0 || corners[0].1 == corners[1].1 {
            return Ok(());
        }
        self.drawn += 1;
        let Style { role, dash, .. } = region.style;
        let ink = Ink::new(role, 1.25).dash(dash);
        self.axes.draw(&Rectangle::new(corners, ink.opacity(0.16).style(true))).map_err(failed)?;
        self.axes.draw(&Rectangle::new(corners, ink.style(false))).map_err(failed)?;
        let Some(label) = &region.label else { return Ok(()) };
        let (one, two) = (self.axes.map_coordinate(&corners[0]), self.axes.map_coordinate(&corners[1]));
        let at = (f64::from(one.0.min(two.0)) / UNIT + 5.0, f64::from(one.1.min(two.1)) / UNIT + 5.0);
        self.page.text(label, at, (HPos::Left, VPos::Top), Role::Ink, false)
    }

    /// A picture is drawn whole or, where it reaches beyond the axes, not at all: it cannot be cut.
    fn image(&mut self, image: &Image) -> Result<(), ChartError> {
        let corners = positions(&[image.from, image.to], self.plot.panel.x.scale, self.plot.panel.y.scale);
        let [Some(a), Some(b)] = corners[..] else { return Ok(()) };
        if !(self.plot.window.contains(a) && self.plot.window.contains(b)) {
            return Err(ChartError::Drawing("a picture reaches beyond the axes".to_owned()));
        }
        self.shape(vec![a, b], Kind::Image(image.png.base64()))
    }

    fn note(&mut self, note: &Note) -> Result<(), ChartError> {
        let place = positions(&[note.at], self.plot.panel.x.scale, self.plot.panel.y.scale);
        let Some(Some(place)) = place.first().filter(|p| p.is_some_and(|p| self.plot.window.contains(p))) else {
            return Ok(());
        };
        let (x, y) = self.axes.map_coordinate(place);
        let (x, y) = (f64::from(x) / UNIT, f64::from(y) / UNIT);
        let (at, anchor) = match note.corner {
            Corner::AboveRight => ((x + 5.0, y - 5.0), (HPos::Left, VPos::Bottom)),
            Corner::AboveLeft => ((x - 5.0, y - 5.0), (HPos::Right, VPos::Bottom)),
            Corner::BelowRight => ((x + 5.0, y + 6.0), (HPos::Left, VPos::Top)),
            Corner::BelowLeft => ((x - 5.0, y + 6.0), (HPos::Right, VPos::Top)),
            Corner::Above => ((x, y - 5.0), (HPos::Center, VPos::Bottom)),
            Corner::Below => ((x, y + 6.0), (HPos::Center, VPos::Top)),
            Corner::Centre => ((x, y), (HPos::Center, VPos::Center)),
        };
        self.drawn += 1;
        let kind = Kind::Text { text: note.text.clone(), anchor, role: note.role, bold: note.bold };
        self.page.shape(
            &[at],
            match &note.tracked {
                Some(name) => Kind::Tracked(format!("{}-{name}", self.plot.index), Box::new(kind)),
                None => kind,
            },
        )
    }

    /// The names at the ends of lines, with leaders where they had to move.
    fn names(&mut self) -> Result<(), ChartError> {
        let ends = std::mem::take(&mut self.ends);
        let unit = |hundredths: i32| f64::from(hundredths) / UNIT;
        let rect = self.plot.rect;
        let wanted: Vec<f64> = ends.iter().map(|end| unit(end.0.1)).collect();
        let (low, high) = (unit(rect.top), unit(rect.bottom));
        let line = if self.plot.direct { LINE } else { TAIL };
        let Some(places) = spread(&wanted, line, low, high) else {
            return Err(ChartError::Drawing("more names than the height of the chart has room for".to_owned()));
        };
        for (((x, y), role, name), place) in ends.into_iter().zip(places) {
            let (from, right) = (unit(x) + 5.0, unit(rect.right));
            let turn = (right + 6.0).max(from);
            if turn - from > NEAR {
                // Where the line ends long before the axes do, what leads on to its name must not look like more of it.
                let ink = Ink::new(Role::Muted, 0.75).dash(Dash::Dotted);
                self.page.shape(&[(from, unit(y)), (turn, unit(y))], Kind::Stroke(vec![2], ink))?;
            }
            let from = if turn - from > NEAR { turn } else { from };
            let leader = [(from, unit(y)), (turn, unit(y)), (right + 16.0, place)];
            self.page.shape(&leader, Kind::Stroke(vec![3], Ink::new(role, 1.0).dash(Dash::Solid).opacity(0.7)))?;
            self.page.text(name, (right + 20.0, place), (HPos::Left, VPos::Center), Role::Ink, false)?;
        }
        Ok(())
    }
}

/// The longest leader that is one with its line, in units.
const NEAR: f64 = 24.0;

/// The diameter of marks that suits their number on a plot of this side.
fn size(count: usize, side: f64) -> f64 {
    let room = side / (count.max(1) as f64).sqrt();
    (room * 0.28).clamp(1.1, 6.5)
}
