//! Elements for plotters: series of lines, of fills and of marks, each one path; and rich text.

use super::backend::{Backend, Drawn, pair, polyline};
use super::disk::outline as disk;
use super::layout::Rect;
use super::palette::{Dash, Marker, Role};
use super::text::Rich;
use plotters::element::{Drawable, PointCollection};
use plotters::style::{Color, RGBAColor, ShapeStyle};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{BackendColor, BackendCoord};
use std::fmt::Write;

/// How something is stroked or filled: by role, so that the theme decides on the colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Ink {
    pub role: Role,
    pub dash: Dash,
    /// In hundredths of a unit.
    pub width: u32,
    /// In per cent.
    pub opacity: u8,
}

impl Ink {
    pub fn new(role: Role, width: f64) -> Self {
        Self { role, dash: Dash::Solid, width: (width * 100.0).round() as u32, opacity: 100 }
    }

    pub fn dash(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    pub fn opacity(self, opacity: f64) -> Self {
        Self { opacity: (opacity.clamp(0.0, 1.0) * 100.0).round() as u8, ..self }
    }

    /// The style for plotters' own elements: role and dash travel as red and green.
    pub fn style(self, filled: bool) -> ShapeStyle {
        let color = RGBAColor(self.role as u8, self.dash as u8, 0, f64::from(self.opacity) / 100.0);
        ShapeStyle { color: color.to_rgba(), filled, stroke_width: self.width }
    }

    /// What [`Ink::style`] made.
    pub fn decode(color: BackendColor, width: u32) -> Self {
        const DASHES: [Dash; 6] =
            [Dash::Solid, Dash::Dashed, Dash::Dotted, Dash::DashDot, Dash::Long, Dash::DashDotDot];
        let role = Role::all().nth(usize::from(color.rgb.0)).unwrap_or(Role::Ink);
        let dash = DASHES.get(usize::from(color.rgb.1)).copied().unwrap_or(Dash::Solid);
        Self { role, dash, width, opacity: (color.alpha * 100.0).round() as u8 }
    }
}

/// What a shape is.
#[derive(Clone)]
pub(super) enum Kind {
    /// Lines that end at these indices.
    Stroke(Vec<usize>, Ink),
    /// Polygons that end at these indices.
    Fill(Vec<usize>, Ink),
    /// Marks of a diameter in hundredths.
    Marks(Marker, i32, Role),
    /// A PNG in Base64 between two opposite corners.
    Image(String),
    /// Closed polygons that end at these indices, outlined, and filled with this opacity in per cent.
    Body(Vec<usize>, Ink, u8),
    /// Disks of these radii in hundredths, cut off at a panel's border, outlined, and filled with this opacity in per cent.
    Disks { radii: (i32, i32), rect: Rect, ink: Ink, filled: u8 },
    /// Another kind that moves in a stepper as the element of this key: written at the origin and then moved to each point.
    Tracked(String, Box<Kind>),
    /// Text at each point: one.
    Text { text: Rich, anchor: (HPos, VPos), role: Role, bold: bool },
}

/// A shape on coordinates of type `C`: hundredths on the sheet, or positions on a panel's axes.
#[derive(Clone)]
pub(super) struct Shape<C> {
    pub points: Vec<(C, C)>,
    pub kind: Kind,
}

impl<'a, C: 'a> PointCollection<'a, (C, C)> for &'a Shape<C> {
    type Point = &'a (C, C);
    type IntoIter = &'a [(C, C)];

    fn point_iter(self) -> Self::IntoIter {
        &self.points
    }
}

impl<C> Drawable<Backend<'_>> for Shape<C> {
    fn draw<I: Iterator<Item = BackendCoord>>(&self, at: I, backend: &mut Backend<'_>, _: (u32, u32)) -> Drawn {
        self.kind.draw(&mut { at }, backend)
    }
}

impl Kind {
    /// Draws the kind at places in hundredths.
    fn draw(&self, at: &mut dyn Iterator<Item = BackendCoord>, backend: &mut Backend<'_>) -> Drawn {
        match self {
            Self::Stroke(ends, ink) => backend.stroke(&pieces(at, ends, false), *ink),
            Self::Fill(ends, ink) => backend.fill(&pieces(at, ends, true), ink.role, ink.opacity, false),
            Self::Marks(marker, size, role) => marks(at, *marker, *size, *role, backend),
            Self::Image(data) => {
                let at: Vec<BackendCoord> = at.collect();
                if let [from, to] = at[..] { backend.image(data, from, to) } else { Ok(()) }
            }
            Self::Body(ends, ink, filled) => backend.body(&pieces(at, ends, true), *ink, *filled),
            Self::Disks { radii, rect, ink, filled } => {
                // What lies within the panel has the same outline as its fill; what is cut off has not.
                let (mut whole, mut closed, mut open) = (String::new(), String::new(), String::new());
                at.for_each(|at| {
                    let (mut fill, mut line) = (String::new(), String::new());
                    disk(at, *radii, *rect, true, &mut fill);
                    disk(at, *radii, *rect, false, &mut line);
                    if *filled > 0 && fill == line {
                        whole.push_str(&fill);
                    } else {
                        closed.push_str(&fill);
                        open.push_str(&line);
                    }
                });
                if !whole.is_empty() {
                    backend.body(&whole, *ink, *filled)?;
                }
                if *filled > 0 && !closed.is_empty() {
                    backend.fill(&closed, ink.role, *filled, false)?;
                }
                if open.is_empty() { Ok(()) } else { backend.stroke(&open, *ink) }
            }
            Self::Tracked(key, kind) => {
                for place in at {
                    backend.tracked = Some((key.clone(), place));
                    kind.draw(&mut [(0, 0)].into_iter(), backend)?;
                    backend.tracked = None;
                }
                Ok(())
            }
            Self::Text { text, anchor, role, bold } => {
                for at in at {
                    backend.text(text, at, *anchor, *role, *bold)?;
                }
                Ok(())
            }
        }
    }
}

/// The path of several lines or polygons.
fn pieces(mut at: impl Iterator<Item = BackendCoord>, ends: &[usize], closed: bool) -> String {
    let mut data = String::new();
    let mut start = 0;
    for &end in ends {
        polyline(at.by_ref().take(end - start), closed, &mut data);
        start = end;
    }
    data
}

/// More marks than this are drawn as the area that they cover.
const DENSE: usize = 20_000;

/// Marks as one path.
fn marks(
    at: impl Iterator<Item = BackendCoord>,
    marker: Marker,
    size: i32,
    role: Role,
    backend: &mut Backend<'_>,
) -> Drawn {
    let mut at: Vec<BackendCoord> = at.collect();
    let mut data = String::with_capacity(at.len() * 18);
    if at.len() > DENSE {
        covered(&mut at, &mut data);
        return backend.stroke(&data, Ink { width: 100, ..Ink::new(role, 1.0) });
    }
    let stroke = Ink { width: size.unsigned_abs(), ..Ink::new(role, 1.0) };
    if marker == Marker::Disc {
        for at in at {
            data.push('M');
            pair(at, &mut data);
            data.push_str("h0");
        }
        return backend.stroke(&data, stroke);
    }
    for at in at {
        outline(marker, size, at, &mut data);
    }
    match marker {
        Marker::Plus | Marker::Cross | Marker::Ring => {
            backend.stroke(&data, Ink { width: (size / 4).unsigned_abs().max(80), ..stroke })
        }
        _ => backend.fill(&data, role, 100, true),
    }
}

/// The units that are covered by marks, as runs from left to right: the picture of more marks than can be told apart.
fn covered(at: &mut [BackendCoord], data: &mut String) {
    for point in at.iter_mut() {
        *point = (point.1.div_euclid(100), point.0.div_euclid(100));
    }
    at.sort_unstable();
    let joined = |a: &BackendCoord, b: &BackendCoord| a.0 == b.0 && b.1 - a.1 <= 1;
    for run in at.chunk_by(joined) {
        if let (Some(first), Some(last)) = (run.first(), run.last()) {
            // Writing to a string cannot fail.
            let _ = write!(data, "M{}.5 {}.5h{}", first.1, first.0, last.1 - first.1);
        }
    }
}

/// The outline of one mark; shapes of the same size look equally large.
fn outline(marker: Marker, size: i32, (x, y): BackendCoord, data: &mut String) {
    let part = |share: i32| size * share / 1000;
    let corners: &[(i32, i32)] = match marker {
        Marker::Square => &[(-455, -455), (455, -455), (455, 455), (-455, 455)],
        Marker::Diamond => &[(0, -640), (640, 0), (0, 640), (-640, 0)],
        Marker::Up => &[(0, -660), (620, 430), (-620, 430)],
        Marker::Down => &[(0, 660), (620, -430), (-620, -430)],
        Marker::Plus => &[(-560, 0), (560, 0), (0, -560), (0, 560)],
        Marker::Cross => &[(-440, -440), (440, 440), (-440, 440), (440, -440)],
        Marker::Disc | Marker::Ring => {
            let r = part(430);
            data.push('M');
            pair((x - r, y), data);
            for side in [2 * r, -2 * r] {
                data.push('a');
                pair((r, r), data);
                data.push_str(" 0 0 0 ");
                pair((side, 0), data);
            }
            data.push('z');
            return;
        }
    };
    let corner = |&(dx, dy): &(i32, i32)| (x + part(dx), y + part(dy));
    if matches!(marker, Marker::Plus | Marker::Cross) {
        for bar in corners.chunks(2) {
            polyline(bar.iter().map(corner), false, data);
        }
    } else {
        // The other corners from the one before: half as long as from the sheet's corner.
        let mut last = corner(&corners[0]);
        data.push('M');
        pair(last, data);
        for at in corners[1..].iter().map(corner) {
            data.push('l');
            pair((at.0 - last.0, at.1 - last.1), data);
            last = at;
        }
        data.push('z');
    }
}
