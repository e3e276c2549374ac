//! From the layers' values to positions: what an axis must span, and what cannot be drawn on it.

use super::axis::Scale;
use super::geometry::{Window, stairs};
use super::{Area, Bars, ChartError, Layer, Panel};

/// The span of the drawable data, and what is not drawable.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Extent {
    x: Option<(f64, f64)>,
    y: Option<(f64, f64)>,
    /// Whether marks stand on the x axis's ends and need room.
    marked: bool,
    /// Whether something stands on the axis y = 0.
    standing: bool,
    /// How many values are not finite.
    pub not_finite: usize,
    /// How many values a logarithmic axis cannot show.
    pub not_positive: usize,
    /// How many values are drawable.
    pub drawable: usize,
}

impl Extent {
    /// The extent of a panel's layers.
    pub fn of(panel: &Panel) -> Self {
        let mut extent = Self::default();
        let (sx, sy) = (panel.x.scale, panel.y.scale);
        for layer in &panel.layers {
            extent.layer(layer, sx, sy);
        }
        extent
    }

    /// The extent of both.
    pub fn union(self, other: Self) -> Self {
        let join = |a: Option<(f64, f64)>, b: Option<(f64, f64)>| match (a, b) {
            (Some(a), Some(b)) => Some((a.0.min(b.0), a.1.max(b.1))),
            (a, b) => a.or(b),
        };
        Self {
            x: join(self.x, other.x),
            y: join(self.y, other.y),
            marked: self.marked || other.marked,
            standing: self.standing || other.standing,
            ..self
        }
    }

    /// The window of a panel whose data have this extent.
    pub fn window(&self, panel: &Panel, index: usize) -> Result<Window, ChartError> {
        let side = if self.marked && !self.standing { 0.03 } else { 0.0 };
        let x = panel.x.resolve(self.x, (side, side))?;
        let foot =
            if self.standing && self.y.is_some_and(|y| y.0 >= 0.0) && !panel.y.scale.is_log() { 0.0 } else { 0.06 };
        let y = panel.y.resolve(self.y, (foot, 0.06))?;
        let (Some(x), Some(y)) = (x, y) else { return Err(ChartError::Empty { panel: index }) };
        Ok(Window { x, y })
    }

    fn layer(&mut self, layer: &Layer, sx: Scale, sy: Scale) {
        match layer {
            Layer::Line(line) => {
                self.marked |= line.marked;
                line.points.iter().for_each(|&p| self.point(p, sx, sy));
            }
            Layer::Marks(marks) => {
                self.marked = true;
                marks.points.iter().for_each(|&p| self.point(p, sx, sy));
            }
            Layer::ErrorBars(bars) => {
                self.marked = true;
                bars.points.iter().for_each(|&p| self.interval(p, sx, sy));
            }
            Layer::Band(band) => band.points.iter().for_each(|&p| self.interval(p, sx, sy)),
            Layer::Area(area) => {
                self.standing = true;
                area.points.iter().for_each(|&(x, y)| self.interval((x, y.min(area.base), y.max(area.base)), sx, sy));
            }
            Layer::Bars(bars) => {
                self.standing = true;
                for (pair, &height) in bars.edges.windows(2).zip(&bars.heights) {
                    for &x in pair {
                        self.interval((x, height.min(0.0), height.max(0.0)), sx, sy);
                    }
                }
            }
            Layer::Region(region) => {
                self.point(region.from, sx, sy);
                self.point(region.to, sx, sy);
            }
            Layer::Image(image) => {
                self.point(image.from, sx, sy);
                self.point(image.to, sx, sy);
            }
            Layer::Rule(rule) => {
                let (scale, span) = if rule.vertical { (sx, &mut self.x) } else { (sy, &mut self.y) };
                match scale.position(rule.at) {
                    Some(at) => {
                        widen(span, at);
                        self.drawable += 1;
                    }
                    None => self.miss(rule.at),
                }
            }
            Layer::Disks(disks) => {
                let r = disks.radius;
                disks.points.iter().for_each(|&(x, y)| {
                    self.point((x - r, y - r), sx, sy);
                    self.point((x + r, y + r), sx, sy);
                });
            }
            Layer::Segments(lines) => lines.pairs.iter().flatten().for_each(|&p| self.point(p, sx, sy)),
            Layer::Boxes(boxes) => boxes.corners.iter().flatten().for_each(|&p| self.point(p, sx, sy)),
            Layer::Note(_) => {}
        }
    }

    fn point(&mut self, (x, y): (f64, f64), sx: Scale, sy: Scale) {
        match (sx.position(x), sy.position(y)) {
            (Some(x), Some(y)) => {
                widen(&mut self.x, x);
                widen(&mut self.y, y);
                self.drawable += 1;
            }
            (None, _) => self.miss(x),
            (_, None) => self.miss(y),
        }
    }

    /// An interval may reach below a logarithmic axis: only what lies on it is spanned.
    fn interval(&mut self, (x, low, high): (f64, f64, f64), sx: Scale, sy: Scale) {
        match (sx.position(x), low.is_finite() && high.is_finite(), sy.position(high)) {
            (Some(x), true, Some(high)) => {
                widen(&mut self.x, x);
                widen(&mut self.y, high);
                if let Some(low) = sy.position(low) {
                    widen(&mut self.y, low);
                }
                self.drawable += 1;
            }
            (None, ..) => self.miss(x),
            (_, _, None) => self.miss(high),
            _ => self.miss(low),
        }
    }

    fn miss(&mut self, value: f64) {
        if value.is_finite() { self.not_positive += 1 } else { self.not_finite += 1 }
    }

    /// What the figure says about values that it does not show.
    pub fn told(&self) -> Option<String> {
        let one = |count: usize, what: &str| (count > 0).then(|| format!("{count} {what}"));
        let parts: Vec<String> = [one(self.not_positive, "not positive"), one(self.not_finite, "not finite")]
            .into_iter()
            .flatten()
            .collect();
        (!parts.is_empty()).then(|| format!("Not shown: {}", parts.join(", ")))
    }
}

fn widen(span: &mut Option<(f64, f64)>, at: f64) {
    *span = Some(span.map_or((at, at), |(low, high)| (low.min(at), high.max(at))));
}

/// The positions of points, `None` where there is none.
pub(super) fn positions(points: &[(f64, f64)], sx: Scale, sy: Scale) -> Vec<Option<(f64, f64)>> {
    points.iter().map(|&(x, y)| sx.position(x).zip(sy.position(y))).collect()
}

/// The polygons between the lows and the highs of intervals, one for each unbroken run.
pub(super) fn between(points: &[(f64, f64, f64)], sx: Scale, sy: Scale) -> Vec<Vec<(f64, f64)>> {
    let place = |&(x, low, high): &(f64, f64, f64)| {
        Some((sx.position(x)?, sy.position_or_below(low)?, sy.position_or_below(high)?))
    };
    let placed: Vec<_> = points.iter().map(place).collect();
    let run = |run: &[Option<(f64, f64, f64)>]| -> Vec<(f64, f64)> {
        let highs = run.iter().flatten().map(|p| (p.0, p.2));
        highs.chain(run.iter().flatten().rev().map(|p| (p.0, p.1))).collect()
    };
    placed.split(Option::is_none).filter(|part| part.len() > 1).map(run).collect()
}

/// The polygons under an area's line.
pub(super) fn under(area: &Area, sx: Scale, sy: Scale) -> Vec<Vec<(f64, f64)>> {
    let line = if area.stepped { stairs(&area.points) } else { area.points.clone() };
    let points: Vec<_> = line.iter().map(|&(x, y)| (x, area.base, y)).collect();
    between(&points, sx, sy)
}

/// The rectangles of bars.
pub(super) fn rectangles(bars: &Bars, sx: Scale, sy: Scale) -> Vec<Vec<(f64, f64)>> {
    let bar = |(pair, &height): (&[f64], &f64)| {
        let (left, right) = (sx.position(*pair.first()?)?, sx.position(*pair.last()?)?);
        let (foot, head) = (sy.position_or_below(0.0)?, sy.position_or_below(height)?);
        (foot != head).then(|| vec![(left, foot), (left, head), (right, head), (right, foot)])
    };
    bars.edges.windows(2).zip(&bars.heights).filter_map(bar).collect()
}

/// Whether the columns of a panel's layers fit together.
pub(super) fn check(panel: &Panel) -> Result<(), ChartError> {
    for layer in &panel.layers {
        let (what, left, right) = match layer {
            Layer::Bars(bars) => {
                ("the edges of bars, one more than the bars", bars.edges.len(), bars.heights.len() + 1)
            }
            Layer::Marks(marks) if !marks.names.is_empty() => {
                ("points and their names", marks.points.len(), marks.names.len())
            }
            _ => continue,
        };
        if left != right {
            return Err(ChartError::Lengths { what, left, right });
        }
    }
    Ok(())
}
