//! The plotters backend: it reports its size in hundredths of a unit and writes them with a point, so that plotters' whole
//! pixels become coordinates of fixed precision. Roles travel as sentinel colours and come out as classes.

use super::palette::{Dash, Role};
use super::shape::Ink;
use super::text::{Rich, SIZE, escape};
use super::{ADJUST, Sheet};
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontTransform,
};
use std::fmt::{Error, Write};

/// What drawing gives: writing to a string does not fail.
pub(super) type Drawn = Result<(), DrawingErrorKind<Error>>;

/// Hundredths in a unit.
pub(super) const UNIT: f64 = 100.0;

/// Writes SVG elements to a string.
pub(super) struct Backend<'a> {
    out: &'a mut String,
    size: (u32, u32),
    /// What is being drawn is the element of this key, at this place.
    pub(super) tracked: Option<(String, BackendCoord)>,
}

/// What stands between an element's name and its attributes where the element moves in a stepper: its key, then its place.
pub(super) const TRACK: [&str; 3] = [" data-key=\"", "\" transform=\"translate(", ")\""];

impl<'a> Backend<'a> {
    /// A backend of `size` hundredths that appends to `out`.
    pub fn new(out: &'a mut String, size: (u32, u32)) -> Self {
        Self { out, size, tracked: None }
    }

    /// Writes the beginning of an element.
    fn open(&mut self, name: &str) {
        self.out.push('<');
        self.out.push_str(name);
        if let Some((key, place)) = &self.tracked {
            let [before, between, after] = TRACK;
            self.out.push_str(before);
            escape(key, self.out);
            self.out.push_str(between);
            pair(*place, self.out);
            self.out.push_str(after);
        }
    }

    /// Writes a path's data as a stroked path.
    pub fn stroke(&mut self, data: &str, ink: Ink) -> Drawn {
        let Ink { role, dash, width, opacity } = ink;
        self.open("path");
        let out = &mut *self.out;
        write!(out, " class=\"s-{}\" stroke=\"{}\" stroke-width=\"", role.name(), role.light()).map_err(wrong)?;
        hundredths(width as i32, out);
        out.push('"');
        if dash != Dash::Solid {
            write!(out, " stroke-dasharray=\"{}\"", dash.lengths()).map_err(wrong)?;
        }
        if opacity < 100 {
            write!(out, " stroke-opacity=\"{}\"", f64::from(opacity) / 100.0).map_err(wrong)?;
        }
        writeln!(out, " d=\"{data}\"/>").map_err(wrong)
    }

    /// Writes a closed path's data as a path that is stroked, and filled with this opacity in per cent.
    pub fn body(&mut self, data: &str, ink: Ink, filled: u8) -> Drawn {
        let Ink { role, dash, width, .. } = ink;
        let (name, colour) = (role.name(), role.light());
        self.open("path");
        let out = &mut *self.out;
        write!(out, " class=\"s-{name} f-{name}\" stroke=\"{colour}\" stroke-width=\"").map_err(wrong)?;
        hundredths(width as i32, out);
        if dash != Dash::Solid {
            write!(out, "\" stroke-dasharray=\"{}", dash.lengths()).map_err(wrong)?;
        }
        let filled = f64::from(filled) / 100.0;
        writeln!(out, "\" fill=\"{colour}\" fill-opacity=\"{filled}\" d=\"{data}\"/>").map_err(wrong)
    }

    /// Writes a path's data as a filled path; `halo` is a border in the page's colour.
    pub fn fill(&mut self, data: &str, role: Role, opacity: u8, halo: bool) -> Drawn {
        self.open("path");
        let out = &mut *self.out;
        write!(out, " class=\"f-{}", role.name()).map_err(wrong)?;
        if halo {
            write!(out, " s-page\" stroke=\"{}\" stroke-width=\".8", Role::Page.light()).map_err(wrong)?;
        }
        write!(out, "\" fill=\"{}\"", role.light()).map_err(wrong)?;
        if opacity < 100 {
            write!(out, " fill-opacity=\"{}\"", f64::from(opacity) / 100.0).map_err(wrong)?;
        }
        writeln!(out, " d=\"{data}\"/>").map_err(wrong)
    }

    /// Writes a PNG in Base64 between two opposite corners, each of its pixels sharp.
    pub fn image(&mut self, data: &str, from: BackendCoord, to: BackendCoord) -> Drawn {
        let out = &mut *self.out;
        let (x, y) = (from.0.min(to.0), from.1.min(to.1));
        out.push_str("<image preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\"");
        for (name, value) in [("x", x), ("y", y), ("width", from.0.max(to.0) - x), ("height", from.1.max(to.1) - y)] {
            write!(out, " {name}=\"").map_err(wrong)?;
            hundredths(value, out);
            out.push('"');
        }
        writeln!(out, " href=\"data:image/png;base64,{data}\"/>").map_err(wrong)
    }

    /// Writes text; `bold` for titles.
    pub fn text(&mut self, rich: &Rich, at: BackendCoord, anchor: (HPos, VPos), role: Role, bold: bool) -> Drawn {
        self.open("text");
        let out = &mut *self.out;
        write!(out, " class=\"f-{}\" fill=\"{}\"", role.name(), role.light()).map_err(wrong)?;
        if self.tracked.is_none() {
            out.push_str(" x=\"");
            hundredths(at.0, out);
            out.push_str("\" y=\"");
            hundredths(at.1, out);
            out.push('"');
        }
        out.push_str(match anchor.1 {
            VPos::Top => " dy=\".72em\"",
            VPos::Center => " dy=\".35em\"",
            VPos::Bottom => "",
        });
        out.push_str(match anchor.0 {
            HPos::Left => "",
            HPos::Center => " text-anchor=\"middle\"",
            HPos::Right => " text-anchor=\"end\"",
        });
        if bold {
            out.push_str(" font-weight=\"600\"");
        }
        out.push('>');
        rich.write(out);
        out.push_str("</text>\n");
        Ok(())
    }
}

fn wrong(error: Error) -> DrawingErrorKind<Error> {
    DrawingErrorKind::DrawingError(error)
}

/// Appends `value` hundredths as a decimal without needless zeros.
pub(super) fn hundredths(value: i32, out: &mut String) {
    let size = value.unsigned_abs();
    if value < 0 {
        out.push('-');
    }
    let (whole, rest) = (size / 100, size % 100);
    // Writing to a string cannot fail.
    let _ = match rest {
        0 => write!(out, "{whole}"),
        _ if rest % 10 == 0 => write!(out, "{whole}.{}", rest / 10),
        _ => write!(out, "{whole}.{rest:02}"),
    };
}

/// Appends a pair of coordinates.
pub(super) fn pair((x, y): BackendCoord, out: &mut String) {
    hundredths(x, out);
    out.push(' ');
    hundredths(y, out);
}

/// Appends a line through points.
pub(super) fn polyline(points: impl IntoIterator<Item = BackendCoord>, closed: bool, out: &mut String) {
    let mut last = None;
    let mut count = 0;
    for point in points {
        // Points that are written alike need no second stroke.
        if last == Some(point) {
            continue;
        }
        out.push(if count == 0 { 'M' } else { ' ' });
        pair(point, out);
        last = Some(point);
        count += 1;
    }
    if closed && count > 0 {
        out.push('z');
    } else if count == 1 {
        out.push_str("h0");
    }
}

/// Opens the drawing; `named` if names stand beside its axes, so that it must not shrink as far as others.
pub(super) fn open(sheet: &Sheet, height: i32, named: bool, out: &mut String) {
    let width = (sheet.width * UNIT).round() as i32;
    let size = |out: &mut String, between: &str| {
        hundredths(width, out);
        out.push_str(between);
        hundredths(height, out);
    };
    let (mut id, mut title, mut description) = (String::new(), String::new(), String::new());
    escape(&sheet.id, &mut id);
    escape(&sheet.title, &mut title);
    escape(&sheet.description, &mut description);
    let class = if named && sheet.width > 480.0 { "chart named" } else { "chart" };
    let _ = write!(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{class}\" role=\"img\" viewBox=\"0 0 ");
    size(out, " ");
    out.push_str("\" width=\"");
    size(out, "\" height=\"");
    // Writing to a string cannot fail.
    let _ = write!(
        out,
        "\" aria-labelledby=\"{id}-title {id}-desc\" font-family=\"Helvetica,Arial,sans-serif\"{ADJUST} font-size=\"{SIZE}\" \
         fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
         <title id=\"{id}-title\">{title}</title>\n<desc id=\"{id}-desc\">{description}</desc>\n"
    );
}

impl DrawingBackend for Backend<'_> {
    type ErrorType = Error;

    fn get_size(&self) -> (u32, u32) {
        self.size
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        let mut data = String::new();
        polyline([point], false, &mut data);
        self.stroke(&data, Ink::decode(color, 100))
    }

    fn draw_line<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S) -> Drawn {
        self.draw_path([from, to], style)
    }

    fn draw_rect<S: BackendStyle>(&mut self, from: BackendCoord, to: BackendCoord, style: &S, fill: bool) -> Drawn {
        let corners = [from, (to.0, from.1), to, (from.0, to.1)];
        if fill {
            return self.fill_polygon(corners, style);
        }
        let mut data = String::new();
        polyline(corners, true, &mut data);
        self.stroke(&data, Ink::decode(style.color(), style.stroke_width()))
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, style: &S) -> Drawn {
        let mut data = String::new();
        polyline(path, false, &mut data);
        self.stroke(&data, Ink::decode(style.color(), style.stroke_width()))
    }

    fn draw_circle<S: BackendStyle>(&mut self, centre: BackendCoord, radius: u32, style: &S, fill: bool) -> Drawn {
        let r = radius.cast_signed();
        let mut data = String::from("M");
        pair((centre.0 - r, centre.1), &mut data);
        for side in [2 * r, -2 * r] {
            data.push('a');
            pair((r, r), &mut data);
            data.push_str(" 0 0 0 ");
            pair((side, 0), &mut data);
        }
        data.push('z');
        let ink = Ink::decode(style.color(), style.stroke_width());
        if fill { self.fill(&data, ink.role, ink.opacity, false) } else { self.stroke(&data, ink) }
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, points: I, style: &S) -> Drawn {
        let ink = Ink::decode(style.color(), style.stroke_width());
        let mut data = String::new();
        polyline(points, true, &mut data);
        self.fill(&data, ink.role, ink.opacity, false)
    }

    fn draw_text<T: BackendTextStyle>(&mut self, text: &str, style: &T, at: BackendCoord) -> Drawn {
        let anchor = style.anchor();
        self.text(&Rich::plain(text), at, (anchor.h_pos, anchor.v_pos), Ink::decode(style.color(), 100).role, false)
    }

    fn estimate_text_size<T: BackendTextStyle>(
        &self,
        text: &str,
        style: &T,
    ) -> Result<(u32, u32), DrawingErrorKind<Error>> {
        let (width, height) = (Rich::plain(text).width() * UNIT, SIZE * UNIT);
        Ok(match style.transform() {
            FontTransform::Rotate90 | FontTransform::Rotate270 => (height as u32, width as u32),
            _ => (width as u32, height as u32),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hundredths_are_written_short() {
        let write = |value| {
            let mut out = String::new();
            hundredths(value, &mut out);
            out
        };
        assert_eq!([0, 5, 50, 100, 123, -7, -250].map(write), ["0", "0.05", "0.5", "1", "1.23", "-0.07", "-2.5"]);
    }

    #[test]
    fn lines_skip_what_is_written_twice() {
        let mut out = String::new();
        polyline([(0, 0), (0, 0), (150, 20)], false, &mut out);
        polyline([(7, 7), (7, 7)], false, &mut out);
        assert_eq!(out, "M0 0 1.5 0.2M0.07 0.07h0");
    }
}
