//! What the kinds that are stepped through share: point sets that change from step to step, and their drawing.

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

/// The rows of a set of the unit square.
pub fn places(points: &Points) -> Vec<Place> {
    points.rows().filter_map(|row| Some((*row.first()?, *row.get(1)?))).collect()
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
