//! Charts and panels: what is to be drawn, before it is laid out.

use super::{Axis, ChartError, Figure, Layer, Rich, Sheet, Strata, layout};

/// Where the names of series go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Key {
    /// At the ends of the lines where there is one panel and they fit, else above.
    #[default]
    Auto,
    /// Above the panels, once for all of them.
    Above,
    /// Nowhere: titles or the caption tell.
    Hidden,
}

/// One or several panels that belong together.
#[derive(Debug, Clone, Default)]
pub struct Chart {
    pub(super) panels: Vec<Panel>,
    pub(super) columns: Option<usize>,
    pub(super) key: Key,
    pub(super) shared: bool,
}

impl Chart {
    /// A chart of one panel.
    pub fn new(panel: Panel) -> Self {
        Self::grid(vec![panel])
    }

    /// Small multiples, row by row.
    pub fn grid(panels: Vec<Panel>) -> Self {
        Self { panels, ..Self::default() }
    }

    /// In so many columns; otherwise as many as are readable.
    #[must_use]
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = Some(columns.max(1));
        self
    }

    /// With the names of series at this place.
    #[must_use]
    pub fn key(mut self, key: Key) -> Self {
        self.key = key;
        self
    }

    /// With the same ranges in all panels, so that they can be compared; labels stand only at the outer edges.
    #[must_use]
    pub fn shared(mut self) -> Self {
        self.shared = true;
        self
    }

    /// Without what marks and notes are tracked as: a frame that stands by itself.
    #[must_use]
    pub(super) fn still(mut self) -> Self {
        for layer in self.panels.iter_mut().flat_map(|panel| &mut panel.layers) {
            match layer {
                Layer::Marks(marks) => marks.tracked = None,
                Layer::Note(note) => note.tracked = None,
                Layer::Segments(segments) => segments.tracked = None,
                _ => {}
            }
        }
        self
    }

    /// The figure on `sheet`.
    pub fn draw(&self, sheet: &Sheet) -> Result<Figure, ChartError> {
        layout::draw(self, sheet)
    }
}

/// Two axes and what is drawn on them, the first layer undermost.
#[derive(Debug, Clone)]
pub struct Panel {
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) title: Option<Rich>,
    pub(super) layers: Vec<Layer>,
    pub(super) strata: Vec<Strata>,
    pub(super) kept: Vec<Strata>,
    pub(super) ratio: Option<f64>,
    pub(super) equal: bool,
    pub(super) square: bool,
    pub(super) rug: bool,
}

impl Panel {
    /// An empty panel on two axes.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self {
            x,
            y,
            title: None,
            layers: Vec::new(),
            strata: Vec::new(),
            kept: Vec::new(),
            ratio: None,
            equal: false,
            square: false,
            rug: false,
        }
    }

    /// The unit square, framed, with equal aspect: for point sets.
    pub fn unit_square() -> Self {
        let side = || Axis::linear("").range(0.0, 1.0).ticks_at(vec![(0.0, "0".into()), (1.0, "1".into())]);
        Self { equal: true, square: true, ..Self::new(side(), side()) }
    }

    /// With a title above it.
    #[must_use]
    pub fn title(mut self, title: impl Into<Rich>) -> Self {
        self.title = Some(title.into());
        self
    }

    /// With one more layer on top.
    #[must_use]
    pub fn with(mut self, layer: impl Into<Layer>) -> Self {
        self.layers.push(layer.into());
        self
    }

    /// With more layers on top.
    #[must_use]
    pub fn with_all<L: Into<Layer>>(mut self, layers: impl IntoIterator<Item = L>) -> Self {
        self.layers.extend(layers.into_iter().map(Into::into));
        self
    }

    /// With the borders of equal strata drawn on a unit square; points stay strictly inside theirs as written.
    #[must_use]
    pub fn strata(mut self, strata: Strata) -> Self {
        self.strata.push(strata);
        self
    }

    /// Points stay strictly inside these strata as written, though their borders are not drawn.
    #[must_use]
    pub fn keeping(mut self, strata: Strata) -> Self {
        self.kept.push(strata);
        self
    }

    /// With a tick above and at the right of the frame for each mark's coordinates: the projections of a point set.
    #[must_use]
    pub fn rug(mut self) -> Self {
        self.rug = true;
        self
    }

    /// So many times as high as wide.
    #[must_use]
    pub fn ratio(mut self, ratio: f64) -> Self {
        self.ratio = Some(ratio);
        self
    }

    /// With a unit of x as long as a unit of y.
    #[must_use]
    pub fn equal(mut self) -> Self {
        self.equal = true;
        self
    }
}
