//! What the kinds that are stepped through share: point sets that change from step to step, and their drawing.

use super::{Frame, Problems};
use crate::chart::{Boxes, MOST_STEPS, Role, Style, number};
use crate::diag::Code;
use crate::metrics::occupancy;
use crate::points::Points;

/// Two coordinates.
pub type Place = (f64, f64);

/// The points as a set of the unit square.
pub fn set(places: &[Place]) -> Option<Points> {
    Points::from_rows(2, places.iter().flat_map(|&(x, y)| [x, y]).collect())
}

/// Whether each of the n slabs of both axes holds one of the n points.
pub fn is_latin(places: &[Place]) -> bool {
    set(places).is_some_and(|points| occupancy::is_latin(&points))
}

/// Whether each cell of a grid holds one point.
pub fn one_per_cell(places: &[Place], columns: usize, rows: usize) -> bool {
    let counts = set(places).and_then(|points| occupancy::cells(&points, &[columns, rows]));
    counts.is_some_and(|counts| counts.iter().all(|&count| count == 1))
}

/// The shapes of the elementary intervals of volume `base`^-`m`: how many boxes along x and along y, the highest first.
pub fn shapes(base: usize, m: u32) -> Vec<(usize, usize)> {
    (0..=m).map(|k| (base.pow(m - k), base.pow(k))).collect()
}

/// The boxes of a grid that do not hold exactly one point: column, row and how many they hold.
pub fn not_one(places: &[Place], (columns, rows): (usize, usize)) -> Vec<(u32, u32, u32)> {
    let counts = set(places).and_then(|points| occupancy::cells(&points, &[columns, rows])).unwrap_or_default();
    let odd = counts.into_iter().enumerate().filter(|&(_, count)| count != 1);
    odd.map(|(cell, count)| ((cell % columns) as u32, (cell / columns) as u32, count)).collect()
}

/// The rows of a set of the unit square.
pub fn places(points: &Points) -> Vec<Place> {
    points.rows().filter_map(|row| Some((*row.first()?, *row.get(1)?))).collect()
}

/// The boxes of a grid that do not hold one point, pale: those that are empty in one colour, the others in another.
pub fn marked(odd: &[(u32, u32, u32)], (columns, rows): (u32, u32)) -> Vec<Boxes> {
    let corner = |column: u32, row: u32| (f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
    let boxes = |empty: bool, role: Role| {
        let those = odd.iter().filter(|&&(_, _, count)| (count == 0) == empty);
        let boxes = those.map(|&(column, row, _)| [corner(column, row), corner(column + 1, row + 1)]).collect();
        Boxes::new(boxes).style(Style::new(role)).opacity(0.28).plain()
    };
    vec![boxes(true, Role::Accent), boxes(false, Role::Ochre)]
}

/// The points of every step as columns.
pub fn table<'a>(sets: impl IntoIterator<Item = &'a [Place]>) -> Frame {
    let rows: Vec<(usize, usize, Place)> = sets
        .into_iter()
        .enumerate()
        .flat_map(|(step, set)| set.iter().enumerate().map(move |(index, &at)| (step + 1, index, at)))
        .collect();
    Frame::new("points")
        .counts("step", rows.iter().map(|row| row.0))
        .counts("index", rows.iter().map(|row| row.1))
        .numbers("x", rows.iter().map(|row| row.2.0))
        .numbers("y", rows.iter().map(|row| row.2.1))
}

/// Complains of more steps than a stepper can have.
pub fn check_count(count: usize, name: &str, problems: &mut Problems<'_, '_>) {
    if count > MOST_STEPS {
        let message = format!("{count} steps are more than the {MOST_STEPS} that a reader can step through");
        problems.at(name, Code::OutOfRange, message, None);
    }
}

/// Complains of more panels than can be stepped through side by side.
pub fn check_panels(count: usize, name: &str, problems: &mut Problems<'_, '_>) {
    if count > 4 {
        let message = format!("{count} samplers are more than the 4 panels that a stepper can hold");
        problems.at(name, Code::OutOfRange, message, None);
    }
}

/// A point of the torus with its copies beyond the borders whose disks of this radius reach into the unit square.
pub fn copies((x, y): Place, radius: f64) -> Vec<Place> {
    let shifts = || [0.0, -1.0, 1.0].into_iter();
    let reaches = |at: f64| at + radius > 0.0 && at - radius < 1.0;
    let copies = shifts().flat_map(|dx| shifts().map(move |dy| (x + dx, y + dy)));
    copies.filter(|at| reaches(at.0) && reaches(at.1)).collect()
}

/// The shortest way on the torus from one point to another: a segment, or two where it crosses a border.
pub fn shortest(from: Place, to: Place) -> Vec<[Place; 2]> {
    let near = |from: f64, to: f64| to - (to - from).round();
    let (end, start) = ((near(from.0, to.0), near(from.1, to.1)), (near(to.0, from.0), near(to.1, from.1)));
    if end == to { vec![[from, to]] } else { vec![[from, end], [start, to]] }
}

/// A number in [0, 1] as a fraction where its denominator is a small power of two, else with four decimals.
pub fn fraction(x: f64) -> String {
    let denominator = (0..=10).map(|bits| 1_u32 << bits).find(|&by| (x * f64::from(by)).fract() == 0.0);
    match denominator {
        Some(1) => number::fixed(x, 0),
        Some(by) => format!("{}/{by}", (x * f64::from(by)) as u32),
        None => number::fixed(x, 4),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_in_lowest_terms() {
        assert_eq!([0.0, 0.5, 0.625, 0.75, 1.0].map(fraction), ["0", "1/2", "5/8", "3/4", "1"]);
        assert_eq!(fraction(1.0 / 3.0), "0.3333");
    }

    #[test]
    fn the_torus_has_no_border() {
        assert_eq!(copies((0.5, 0.5), 0.4), [(0.5, 0.5)]);
        assert_eq!(copies((0.1, 0.5), 0.2), [(0.1, 0.5), (1.1, 0.5)]);
        assert_eq!(copies((0.1, 0.9), 0.2).len(), 4);
        assert_eq!(shortest((0.1, 0.5), (0.3, 0.5)), [[(0.1, 0.5), (0.3, 0.5)]]);
        let [one, two] = shortest((0.125, 0.5), (0.875, 0.5))[..] else { panic!("two pieces") };
        assert_eq!((one, two), ([(0.125, 0.5), (-0.125, 0.5)], [(1.125, 0.5), (0.875, 0.5)]));
    }

    #[test]
    fn slabs_and_cells_are_counted() {
        let canonical = [(0.1, 0.1), (0.3, 0.6), (0.6, 0.3), (0.8, 0.8)];
        assert!(is_latin(&canonical) && one_per_cell(&canonical, 2, 2));
        assert!(!is_latin(&[(0.1, 0.1), (0.2, 0.9)]));
        assert!(!one_per_cell(&[(0.1, 0.1), (0.3, 0.3), (0.6, 0.3), (0.8, 0.8)], 2, 2));
    }
}
