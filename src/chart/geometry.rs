//! Clipping to a window, and thinning of what is denser than print.

/// The part of the plane that a panel shows, in positions along its axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Window {
    pub x: (f64, f64),
    pub y: (f64, f64),
}

impl Window {
    pub fn contains(&self, (x, y): (f64, f64)) -> bool {
        let within = |v: f64, (low, high): (f64, f64)| {
            let slack = 1e-9 * (high - low);
            v >= low - slack && v <= high + slack
        };
        within(x, self.x) && within(y, self.y)
    }
}

/// Several lines in one list: `ends[i]` is where line `i` ends.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Lines {
    pub points: Vec<(f64, f64)>,
    pub ends: Vec<usize>,
}

impl Lines {
    /// The pieces of a line, broken at `None`, that lie in the window.
    pub fn clipped(line: impl Iterator<Item = Option<(f64, f64)>>, window: &Window) -> Self {
        let mut lines = Self::default();
        let mut before: Option<(f64, f64)> = None;
        for point in line {
            match (before, point) {
                (Some(a), Some(b)) => {
                    if let Some((from, to)) = segment(a, b, window) {
                        lines.extend(from, to);
                    }
                }
                // A point without neighbours is still a dot.
                (None, Some(b)) if window.contains(b) => {
                    lines.close();
                    lines.points.push(b);
                }
                _ => {}
            }
            before = point;
        }
        lines.close();
        lines
    }

    fn extend(&mut self, from: (f64, f64), to: (f64, f64)) {
        let open = self.points.len() > self.ends.last().copied().unwrap_or(0);
        if !(open && self.points.last() == Some(&from)) {
            self.close();
            self.points.push(from);
        }
        if from != to || self.points.len() == self.ends.last().copied().unwrap_or(0) + 1 {
            self.points.push(to);
        }
    }

    fn close(&mut self) {
        if self.points.len() > self.ends.last().copied().unwrap_or(0) {
            self.ends.push(self.points.len());
        }
    }
}

/// The part of a segment in the window (Liang and Barsky 1984).
fn segment(a: (f64, f64), b: (f64, f64), window: &Window) -> Option<((f64, f64), (f64, f64))> {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let borders = [(-dx, a.0 - window.x.0), (dx, window.x.1 - a.0), (-dy, a.1 - window.y.0), (dy, window.y.1 - a.1)];
    for (direction, distance) in borders {
        if direction == 0.0 {
            if distance < 0.0 {
                return None;
            }
        } else if direction < 0.0 {
            enter = enter.max(distance / direction);
        } else {
            leave = leave.min(distance / direction);
        }
    }
    if enter > leave {
        return None;
    }
    // The ends themselves, where they are inside, so that neighbouring pieces meet in the same point.
    let at = |t: f64| (a.0 + t * dx, a.1 + t * dy);
    Some((if enter == 0.0 { a } else { at(enter) }, if leave == 1.0 { b } else { at(leave) }))
}

/// The part of a polygon in the window (Sutherland and Hodgman 1974).
pub(super) fn polygon(mut points: Vec<(f64, f64)>, window: &Window) -> Vec<(f64, f64)> {
    type Side = fn((f64, f64), &Window) -> f64;
    // Distances to the borders: positive inside.
    let sides: [Side; 4] = [|p, w| p.0 - w.x.0, |p, w| w.x.1 - p.0, |p, w| p.1 - w.y.0, |p, w| w.y.1 - p.1];
    for side in sides {
        let mut kept = Vec::with_capacity(points.len() + 4);
        for (index, &b) in points.iter().enumerate() {
            let a = points[(index + points.len() - 1) % points.len()];
            let (from, to) = (side(a, window), side(b, window));
            if (from < 0.0) != (to < 0.0) {
                let t = from / (from - to);
                kept.push((a.0 + t * (b.0 - a.0), a.1 + t * (b.1 - a.1)));
            }
            if to >= 0.0 {
                kept.push(b);
            }
        }
        points = kept;
    }
    points
}

/// A long line with the same picture: of the points in each of `columns` columns the first, the extremes and the last.
pub(super) fn thinned(line: Vec<Option<(f64, f64)>>, window: &Window, columns: usize) -> Vec<Option<(f64, f64)>> {
    if line.len() <= columns * 2 {
        return line;
    }
    let column = |p: &Option<(f64, f64)>| {
        p.map(|(x, _)| ((x - window.x.0) / (window.x.1 - window.x.0) * columns as f64).floor() as i64)
    };
    let mut out = Vec::new();
    for run in line.chunk_by(|a, b| column(a) == column(b)) {
        let height = |&i: &usize| run.get(i).copied().flatten().map_or(0.0, |p| p.1);
        let indices = 0..run.len();
        let least = indices.clone().min_by(|a, b| height(a).total_cmp(&height(b))).unwrap_or(0);
        let most = indices.max_by(|a, b| height(a).total_cmp(&height(b))).unwrap_or(0);
        let mut chosen = [0, least, most, run.len() - 1];
        chosen.sort_unstable();
        let mut previous = None;
        for index in chosen {
            if previous != Some(index) {
                out.push(run[index]);
            }
            previous = Some(index);
        }
    }
    out
}

/// A staircase through points: each value holds until the next x.
pub(super) fn stairs(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut out: Vec<(f64, f64)> = Vec::with_capacity(points.len() * 2);
    for &(x, y) in points {
        if let Some(&(_, before)) = out.last() {
            out.push((x, before));
        }
        out.push((x, y));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Window = Window { x: (0.0, 1.0), y: (0.0, 1.0) };

    fn clip(points: &[(f64, f64)]) -> Lines {
        Lines::clipped(points.iter().copied().map(Some), &UNIT)
    }

    #[test]
    fn lines_are_cut_at_the_window() {
        let lines = clip(&[(-1.0, 0.5), (0.5, 0.5), (0.5, 3.0), (0.75, 3.0), (0.75, 0.25)]);
        assert_eq!(lines.points, [(0.0, 0.5), (0.5, 0.5), (0.5, 1.0), (0.75, 1.0), (0.75, 0.25)]);
        assert_eq!(lines.ends, [3, 5]);
        assert_eq!(clip(&[(2.0, 2.0), (3.0, 3.0)]), Lines::default());
    }

    #[test]
    fn gaps_stay_gaps() {
        let line = [Some((0.1, 0.1)), Some((0.2, 0.1)), None, Some((0.5, 0.5)), None, Some((0.9, 0.9))];
        assert_eq!(Lines::clipped(line.into_iter(), &UNIT).ends, [2, 3, 4]);
    }

    #[test]
    fn polygons_are_cut_at_the_window() {
        let square = vec![(-1.0, -1.0), (0.5, -1.0), (0.5, 0.5), (-1.0, 0.5)];
        let mut cut = polygon(square, &UNIT);
        cut.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        assert_eq!(cut, [(0.0, 0.0), (0.0, 0.5), (0.5, 0.0), (0.5, 0.5)]);
        assert!(polygon(vec![(2.0, 2.0), (3.0, 2.0), (3.0, 3.0)], &UNIT).is_empty());
        assert!(polygon(Vec::new(), &UNIT).is_empty());
    }

    #[test]
    fn long_lines_keep_their_extremes() {
        let line: Vec<_> =
            (0..100_000_u32).map(|i| Some((f64::from(i) / 1e5, f64::from((i * 37) % 101) / 100.0))).collect();
        let thin = thinned(line, &UNIT, 500);
        assert!(thin.len() <= 2000);
        assert!(
            thin.iter().any(|p| p.is_some_and(|p| p.1 == 1.0)) && thin.iter().any(|p| p.is_some_and(|p| p.1 == 0.0))
        );
    }

    #[test]
    fn stairs_hold_each_value() {
        assert_eq!(stairs(&[(0.0, 1.0), (1.0, 2.0)]), [(0.0, 1.0), (1.0, 1.0), (1.0, 2.0)]);
    }
}
