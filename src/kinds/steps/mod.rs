//! What the kinds that are stepped through share: point sets that change from step to step, and their drawing.

use super::{Frame, Problems};
use crate::chart::{MOST_STEPS, Region, Role, Style};
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
pub fn marked(odd: &[(u32, u32, u32)], (columns, rows): (u32, u32)) -> impl Iterator<Item = Region> + '_ {
    odd.iter().map(move |&(column, row, count)| {
        let corner = |column: u32, row: u32| (f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
        let role = if count == 0 { Role::Accent } else { Role::Ochre };
        Region::new(corner(column, row), corner(column + 1, row + 1)).style(Style::new(role))
    })
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

/// At most `most` of the numbers from 1 to `n`, evenly spread, with 1 and `n` among them.
pub fn spread(n: usize, most: usize) -> Vec<usize> {
    let count = most.min(n).max(1);
    if count == 1 {
        return vec![n];
    }
    (0..count).map(|k| 1 + k * (n - 1) / (count - 1)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_spread_from_the_first_to_the_last() {
        assert_eq!(spread(5, 9), [1, 2, 3, 4, 5]);
        assert_eq!(spread(100, 3), [1, 50, 100]);
        assert_eq!(spread(1, 5), [1]);
        assert_eq!(spread(7, 1), [7]);
    }

    #[test]
    fn slabs_and_cells_are_counted() {
        let canonical = [(0.1, 0.1), (0.3, 0.6), (0.6, 0.3), (0.8, 0.8)];
        assert!(is_latin(&canonical) && one_per_cell(&canonical, 2, 2));
        assert!(!is_latin(&[(0.1, 0.1), (0.2, 0.9)]));
        assert!(!one_per_cell(&[(0.1, 0.1), (0.3, 0.3), (0.6, 0.3), (0.8, 0.8)], 2, 2));
    }
}
