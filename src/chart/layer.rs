//! The layers of a panel: lines, points, bars, bands, rules, error bars, regions and notes.

use super::disk::{Boxes, Disks, Segments};
use super::palette::{Dash, Role, Style};
use super::text::Rich;
use crate::raster::Png;
use crate::stats::portable;

/// Something drawn on a panel's axes.
#[derive(Debug, Clone, PartialEq)]
pub enum Layer {
    /// A line through points.
    Line(Line),
    /// A mark at each point.
    Marks(Marks),
    /// Bars between edges.
    Bars(Bars),
    /// The space between two lines.
    Band(Band),
    /// The space between a line and a base.
    Area(Area),
    /// A straight line across the whole panel.
    Rule(Rule),
    /// An interval at each point.
    ErrorBars(ErrorBars),
    /// A rectangle.
    Region(Region),
    /// A picture made of pixels.
    Image(Image),
    /// A few words at a place.
    Note(Note),
    /// A disk around each point.
    Disks(Disks),
    /// Straight lines from point to point.
    Segments(Segments),
    /// Rectangles.
    Boxes(Boxes),
}

macro_rules! layers {
    ($($name:ident)+) => { $(impl From<$name> for Layer {
        fn from(layer: $name) -> Self { Self::$name(layer) }
    })+ };
}
layers! { Line Marks Bars Band Area Rule ErrorBars Region Image Note Disks Segments Boxes }

macro_rules! labelled {
    ($($name:ident)+) => { $(impl $name {
        /// In this style.
        #[must_use]
        pub fn style(mut self, style: Style) -> Self {
            self.style = style;
            self
        }

        /// With a name, shown at its end or in the key.
        #[must_use]
        pub fn label(mut self, label: impl Into<Rich>) -> Self {
            self.label = Some(label.into());
            self
        }
    })+ };
}
labelled! { Line Marks Bars Band Area Rule ErrorBars Region Disks Segments Boxes }

/// A line through points in their order. It breaks where a value cannot be drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
    pub(super) tail: Option<Rich>,
    pub(super) marked: bool,
    pub(super) stepped: bool,
    pub(super) width: f64,
    pub(super) opacity: f64,
}

impl Line {
    /// A plain line.
    pub fn new(points: Vec<(f64, f64)>) -> Self {
        let (marked, stepped) = (false, false);
        Self { points, style: Style::INK, label: None, tail: None, marked, stepped, width: 1.75, opacity: 1.0 }
    }

    /// The line y = `y0` (x / `x0`)^`exponent` from `x0` to `x1`: a reference slope, straight where both axes are logarithmic.
    pub fn power(x0: f64, y0: f64, exponent: f64, x1: f64) -> Self {
        let end = y0 * portable::pow(x1 / x0, exponent);
        Self::new(vec![(x0, y0), (x1, end)]).style(Style::THEORY)
    }

    /// With a few words at its end, beyond the axes, such as its slope; its name may stand in the key all the same. A line whose
    /// name stands at its end has no other words there.
    #[must_use]
    pub fn tail(mut self, words: impl Into<Rich>) -> Self {
        self.tail = Some(words.into());
        self
    }

    /// With a mark at each point, in the shape of the style.
    #[must_use]
    pub fn marked(mut self) -> Self {
        self.marked = true;
        self
    }

    /// As a staircase: each value holds until the next x.
    #[must_use]
    pub fn stepped(mut self) -> Self {
        self.stepped = true;
        self
    }

    /// Thin and pale: one of many runs.
    #[must_use]
    pub fn faint(mut self) -> Self {
        self.width = 1.0;
        self.opacity = 0.55;
        self
    }

    /// Of this width in units.
    #[must_use]
    pub fn width(mut self, width: f64) -> Self {
        self.width = width;
        self
    }
}

/// A mark at each point, in the shape of the style.
#[derive(Debug, Clone, PartialEq)]
pub struct Marks {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
    pub(super) names: Vec<Rich>,
    pub(super) size: Option<f64>,
    pub(super) tracked: Option<&'static str>,
    pub(super) among: usize,
}

impl Marks {
    /// Marks in the style's shape, of a size that suits their number.
    pub fn new(points: Vec<(f64, f64)>) -> Self {
        Self { points, style: Style::INK, label: None, names: Vec::new(), size: None, tracked: None, among: 0 }
    }

    /// With a name beside each point, in the order of the points.
    #[must_use]
    pub fn names<T: Into<Rich>>(mut self, names: impl IntoIterator<Item = T>) -> Self {
        self.names = names.into_iter().map(Into::into).collect();
        self
    }

    /// As some of `count` marks, of a size that suits all of them.
    #[must_use]
    pub fn among(mut self, count: usize) -> Self {
        self.among = count;
        self
    }

    /// Of this diameter in units.
    #[must_use]
    pub fn size(mut self, size: f64) -> Self {
        self.size = Some(size);
        self
    }

    /// The same marks in every frame of a stepper, in the same order: they move from place to place.
    #[must_use]
    pub fn tracked(mut self, name: &'static str) -> Self {
        self.tracked = Some(name);
        self
    }
}

/// Bars from 0 up: `heights[i]` stands between `edges[i]` and `edges[i + 1]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Bars {
    pub(super) edges: Vec<f64>,
    pub(super) heights: Vec<f64>,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
}

impl Bars {
    /// Bars between n + 1 edges.
    pub fn new(edges: Vec<f64>, heights: Vec<f64>) -> Self {
        Self { edges, heights, style: Style::FILL, label: None }
    }
}

/// The space between two lines: `(x, low, high)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    pub(super) points: Vec<(f64, f64, f64)>,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
}

impl Band {
    /// A band through `(x, low, high)`.
    pub fn new(points: Vec<(f64, f64, f64)>) -> Self {
        Self { points, style: Style::MUTED, label: None }
    }
}

/// The space between a line and a base.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    pub(super) points: Vec<(f64, f64)>,
    pub(super) base: f64,
    pub(super) stepped: bool,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
}

impl Area {
    /// The area between a line and 0.
    pub fn new(points: Vec<(f64, f64)>) -> Self {
        Self { points, base: 0.0, stepped: false, style: Style::FILL, label: None }
    }

    /// Down, or up, to this base.
    #[must_use]
    pub fn base(mut self, base: f64) -> Self {
        self.base = base;
        self
    }

    /// Under a staircase: each value holds until the next x.
    #[must_use]
    pub fn stepped(mut self) -> Self {
        self.stepped = true;
        self
    }
}

/// A straight line across the whole panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Rule {
    pub(super) at: f64,
    pub(super) vertical: bool,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
}

impl Rule {
    /// At this y.
    pub fn horizontal(at: f64) -> Self {
        Self { at, vertical: false, style: Style::EXACT, label: None }
    }

    /// At this x.
    pub fn vertical(at: f64) -> Self {
        Self { vertical: true, ..Self::horizontal(at) }
    }
}

/// An interval at each point: `(x, low, high)`, drawn upright with caps.
#[derive(Debug, Clone, PartialEq)]
pub struct ErrorBars {
    pub(super) points: Vec<(f64, f64, f64)>,
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
}

impl ErrorBars {
    /// Intervals `(x, low, high)`.
    pub fn new(points: Vec<(f64, f64, f64)>) -> Self {
        Self { points, style: Style::INK, label: None }
    }
}

/// A rectangle between two corners, filled pale and outlined.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    pub(super) from: (f64, f64),
    pub(super) to: (f64, f64),
    pub(super) style: Style,
    pub(super) label: Option<Rich>,
}

impl Region {
    /// The rectangle between two opposite corners.
    pub fn new(from: (f64, f64), to: (f64, f64)) -> Self {
        Self { from, to, style: Style::new(Role::Accent).dash(Dash::Solid), label: None }
    }
}

/// A picture made of pixels that fills the rectangle between two corners.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    pub(super) from: (f64, f64),
    pub(super) to: (f64, f64),
    pub(super) png: Png,
}

impl Image {
    /// The picture, its top row at the larger y, between two opposite corners.
    pub fn new(from: (f64, f64), to: (f64, f64), png: Png) -> Self {
        Self { from, to, png }
    }
}

/// On which side of its place a note stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Corner {
    /// Above and to the right.
    #[default]
    AboveRight,
    /// Above and to the left.
    AboveLeft,
    /// Below and to the right.
    BelowRight,
    /// Below and to the left.
    BelowLeft,
    /// Above, in the middle.
    Above,
    /// Below, in the middle.
    Below,
    /// In the middle.
    Centre,
}

/// A few words at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    pub(super) at: (f64, f64),
    pub(super) text: Rich,
    pub(super) corner: Corner,
    pub(super) role: Role,
    pub(super) bold: bool,
    pub(super) tracked: Option<String>,
}

impl Note {
    /// Words at `(x, y)`.
    pub fn new(at: (f64, f64), text: impl Into<Rich>) -> Self {
        let corner = Corner::default();
        Self { at, text: text.into(), corner, role: Role::Ink, bold: false, tracked: None }
    }

    /// In the colour of this role.
    #[must_use]
    pub fn role(mut self, role: Role) -> Self {
        self.role = role;
        self
    }

    /// In bold letters.
    #[must_use]
    pub fn bold(mut self) -> Self {
        self.bold = true;
        self
    }

    /// The same note in every frame of a stepper: it moves from place to place. Each note needs a name of its own.
    #[must_use]
    pub fn tracked(mut self, name: impl Into<String>) -> Self {
        self.tracked = Some(name.into());
        self
    }

    /// On this side of the place.
    #[must_use]
    pub fn corner(mut self, corner: Corner) -> Self {
        self.corner = corner;
        self
    }
}
