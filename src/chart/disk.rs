//! Disks of a radius in data units, line segments and boxes: their layers, and the outline of a disk within a panel.

use super::backend::pair;
use super::layout::Rect;
use super::palette::Style;
use super::text::Rich;

/// A disk of the same radius, in units of the x axis, around each point. What reaches beyond the panel is cut off.
#[derive(Debug, Clone, PartialEq)]
pub struct Disks {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) radius: f64,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
    pub(super) opacity: f64,
}

impl Disks {
    /// Disks filled pale and outlined.
    pub fn new(points: Vec<(f64, f64)>, radius: f64) -> Self {
        Self { points, radius, style: Style::INK, label: None, opacity: 0.14 }
    }

    /// Circles: outlined only.
    #[must_use]
    pub fn outlined(mut self) -> Self {
        self.opacity = 0.0;
        self
    }
}

/// Straight lines from point to point, each by itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Segments {
    pub(super) pairs: Vec<[(f64, f64); 2]>,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
    pub(super) width: f64,
    pub(super) opacity: f64,
    pub(super) tracked: Option<&'static str>,
}

impl Segments {
    /// Segments from the first to the second point of each pair.
    pub fn new(pairs: Vec<[(f64, f64); 2]>) -> Self {
        Self { pairs, style: Style::INK, label: None, width: 1.25, opacity: 1.0, tracked: None }
    }

    /// A pale spot behind each of these points, to point at them.
    pub fn spots(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let segments = points.into_iter().map(|at| [at, at]).collect();
        Self { style: Style::ACCENT, width: 20.0, opacity: 0.35, ..Self::new(segments) }
    }

    /// Of this width in units.
    #[must_use]
    pub fn width(mut self, width: f64) -> Self {
        self.width = width;
        self
    }

    /// The same spots in the frames of a stepper that have them: they move from place to place.
    #[must_use]
    pub fn tracked(mut self, name: &'static str) -> Self {
        self.tracked = Some(name);
        self
    }
}

/// Rectangles between two opposite corners each, filled pale and outlined, as one element.
#[derive(Debug, Clone, PartialEq)]
pub struct Boxes {
    pub(super) corners: Vec<[(f64, f64); 2]>,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
    pub(super) opacity: f64,
    pub(super) outlined: bool,
}

impl Boxes {
    /// Boxes between the first and the second corner of each pair.
    pub fn new(corners: Vec<[(f64, f64); 2]>) -> Self {
        Self { corners, style: Style::ACCENT, label: None, opacity: 0.16, outlined: true }
    }

    /// Without an outline.
    #[must_use]
    pub fn plain(mut self) -> Self {
        self.outlined = false;
        self
    }

    /// Filled this much, from 0 to 1.
    #[must_use]
    pub fn opacity(mut self, opacity: f64) -> Self {
        self.opacity = opacity;
        self
    }
}

/// A place in hundredths, before rounding.
type Place = (f64, f64);

/// Appends the outline of the part of a disk that lies in `rect`: closed for a fill, else only what is of the circle.
pub(super) fn outline(centre: (i32, i32), radii: (i32, i32), rect: Rect, closed: bool, out: &mut String) {
    let centre = (f64::from(centre.0), f64::from(centre.1));
    let r = (f64::from(radii.0.max(1)), f64::from(radii.1.max(1)));
    let mut cuts = crossings(centre, r, rect);
    if cuts.is_empty() {
        let (x, y) = (f64::from(rect.left), f64::from(rect.top));
        let (right, bottom) = (f64::from(rect.right), f64::from(rect.bottom));
        let held = centre.0 - r.0 >= x && centre.0 + r.0 <= right && centre.1 - r.1 >= y && centre.1 + r.1 <= bottom;
        if held {
            whole(centre, r, out);
        } else if closed && squared(((x - centre.0) / r.0, (y - centre.1) / r.1)) < 1.0 {
            // The disk covers the whole panel.
            let corners = [(x, y), (right, y), (right, bottom), (x, bottom)];
            corners.iter().enumerate().for_each(|(i, &at)| step(if i == 0 { "M" } else { "L" }, at, out));
            out.push('z');
        }
        return;
    }
    let direction = |&(x, y): &Place| ((x - centre.0) / r.0, (y - centre.1) / r.1);
    cuts.sort_by(|a, b| turn(direction(a)).total_cmp(&turn(direction(b))));
    let mut arcs: Vec<(Place, Place, bool)> = Vec::new();
    for (index, &from) in cuts.iter().enumerate() {
        let to = cuts[(index + 1) % cuts.len()];
        let (a, b) = (direction(&from), direction(&to));
        let large = cuts.len() == 1 || a.0 * b.1 - a.1 * b.0 < 0.0;
        let middle = middle(a, b, large);
        let at = (centre.0 + r.0 * middle.0, centre.1 + r.1 * middle.1);
        if inside(at, rect) {
            arcs.push((from, to, large));
        }
    }
    for (index, &(from, to, large)) in arcs.iter().enumerate() {
        step(if index == 0 || !closed { "M" } else { "L" }, from, out);
        out.push('A');
        pair((r.0.round() as i32, r.1.round() as i32), out);
        out.push_str(if large { " 0 1 1 " } else { " 0 0 1 " });
        pair(rounded(to), out);
        if closed {
            let next = arcs[(index + 1) % arcs.len()].0;
            for corner in corners(to, next, rect) {
                step("L", corner, out);
            }
        }
    }
    if closed && !arcs.is_empty() {
        out.push('z');
    }
}

fn squared((x, y): Place) -> f64 {
    x * x + y * y
}

fn rounded((x, y): Place) -> (i32, i32) {
    (x.round() as i32, y.round() as i32)
}

fn step(command: &str, at: Place, out: &mut String) {
    out.push_str(command);
    pair(rounded(at), out);
}

/// The whole circle, as two arcs.
fn whole(centre: Place, r: Place, out: &mut String) {
    let (rx, ry) = rounded(r);
    step("M", (centre.0 - r.0, centre.1), out);
    for side in [2 * rx, -2 * rx] {
        out.push('a');
        pair((rx, ry), out);
        out.push_str(" 0 1 1 ");
        pair((side, 0), out);
    }
    out.push('z');
}

fn inside((x, y): Place, rect: Rect) -> bool {
    x >= f64::from(rect.left) && x <= f64::from(rect.right) && y >= f64::from(rect.top) && y <= f64::from(rect.bottom)
}

/// Where the circle crosses the sides of the panel.
fn crossings(centre: Place, r: Place, rect: Rect) -> Vec<Place> {
    let mut cuts = Vec::new();
    for x in [rect.left, rect.right].map(f64::from) {
        let u = (x - centre.0) / r.0;
        if u.abs() < 1.0 {
            let v = (1.0 - u * u).sqrt() * r.1;
            cuts.extend([(x, centre.1 - v), (x, centre.1 + v)].into_iter().filter(|&at| inside(at, rect)));
        }
    }
    for y in [rect.top, rect.bottom].map(f64::from) {
        let v = (y - centre.1) / r.1;
        if v.abs() < 1.0 {
            let u = (1.0 - v * v).sqrt() * r.0;
            cuts.extend([(centre.0 - u, y), (centre.0 + u, y)].into_iter().filter(|&at| inside(at, rect)));
        }
    }
    cuts
}

/// A number in [0, 4) that grows with the angle of a direction, on a page whose y axis points down.
fn turn((x, y): Place) -> f64 {
    let share = y / (x.abs() + y.abs()).max(f64::MIN_POSITIVE);
    if x < 0.0 { 2.0 - share } else { (share + 4.0) % 4.0 }
}

/// The direction of the middle of the arc from `a` to `b`, on the unit circle.
fn middle(a: Place, b: Place, large: bool) -> Place {
    let sum = (a.0 + b.0, a.1 + b.1);
    let length = squared(sum).sqrt();
    if length < 1e-6 {
        return if a == b { (-a.0, -a.1) } else { (-a.1, a.0) };
    }
    let sign = if large { -1.0 } else { 1.0 };
    (sign * sum.0 / length, sign * sum.1 / length)
}

/// The corners of the panel between two places on its border, in the order of increasing angle.
fn corners(from: Place, to: Place, rect: Rect) -> Vec<Place> {
    let (left, top) = (f64::from(rect.left), f64::from(rect.top));
    let (right, bottom) = (f64::from(rect.right), f64::from(rect.bottom));
    let (width, height) = (right - left, bottom - top);
    let along = |(x, y): Place| {
        if y <= top {
            x - left
        } else if x >= right {
            width + y - top
        } else if y >= bottom {
            width + height + right - x
        } else {
            2.0 * width + height + bottom - y
        }
    };
    let (start, mut end) = (along(from), along(to));
    let round = 2.0 * (width + height);
    if end < start {
        end += round;
    }
    let places = [(0.0, (left, top)), (width, (right, top)), (width + height, (right, bottom))];
    let places = places.into_iter().chain([(2.0 * width + height, (left, bottom))]);
    let once: Vec<(f64, Place)> = places.collect();
    let twice = once.iter().copied().chain(once.iter().map(|&(at, corner)| (at + round, corner)));
    twice.filter(|&(at, _)| at > start && at < end).map(|(_, corner)| corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const RECT: Rect = Rect { left: 0, top: 0, right: 1000, bottom: 1000 };

    fn path(centre: (i32, i32), radius: i32, closed: bool) -> String {
        let mut out = String::new();
        outline(centre, (radius, radius), RECT, closed, &mut out);
        out
    }

    #[test]
    fn a_disk_within_is_a_circle_and_one_beyond_is_nothing() {
        assert_eq!(path((500, 500), 100, true), "M4 5a1 1 0 1 1 2 0a1 1 0 1 1 -2 0z");
        assert_eq!(path((-500, 500), 100, true), "");
        assert_eq!(path((500, 500), 9000, true), "M0 0L10 0L10 10L0 10z");
        assert_eq!(path((500, 500), 9000, false), "");
    }

    #[test]
    fn what_reaches_beyond_is_cut_off() {
        // Half a disk on the left side, a quarter in a corner.
        assert_eq!(path((0, 500), 100, false), "M0 4A1 1 0 0 1 0 6");
        assert_eq!(path((0, 0), 100, true), "M1 0A1 1 0 0 1 0 1L0 0z");
        assert_eq!(path((1000, 1000), 100, true), "M9 10A1 1 0 0 1 10 9L10 10z");
        // A little beyond one side: most of the circle remains.
        assert_eq!(path((60, 500), 100, false), "M0 4.2A1 1 0 1 1 0 5.8");
    }
}
