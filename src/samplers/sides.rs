//! Grids of columns x rows cells in the plane: as nearly square as n allows, or as the settings
//! `rows` and `columns` say.

use super::digits::root;
use super::settings::{Preset, Setting, Values};
use super::{Refused, refused};

/// The settings of every sampler on such a grid.
pub const SETTINGS: &[Setting] = &[
    Setting {
        name: "rows",
        meaning: "how many rows of cells the square is cut into",
        least: 1,
        most: 1 << 24,
        is_prime: false,
        default: Preset::Rule("n / columns, or where both are left out as near to the square root of n as it goes"),
    },
    Setting {
        name: "columns",
        meaning: "how many columns of cells the square is cut into",
        least: 1,
        most: 1 << 24,
        is_prime: false,
        default: Preset::Rule("n / rows, or where both are left out as near to the square root of n as it goes"),
    },
];

/// The grid that is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Sides {
    rows: Option<usize>,
    columns: Option<usize>,
}

impl Sides {
    /// As n and d have it.
    pub const FREE: Self = Self { rows: None, columns: None };

    /// As the values of [`SETTINGS`] have it.
    pub fn told(values: Values) -> Self {
        let at = |index| values.at(index).map(|value| value as usize);
        Self { rows: at(0), columns: at(1) }
    }

    /// Whether nothing is set.
    pub fn is_free(self) -> bool {
        self.rows.is_none() && self.columns.is_none()
    }

    /// Whether n points of d dimensions fit: one or two dimensions if nothing is set, and then in
    /// two n must be that of a nearly square grid; exactly two otherwise.
    pub fn check(self, n: usize, d: usize) -> Result<(), Refused> {
        if self.is_free() {
            return nearly_square(n, d);
        }
        if d != 2 {
            return Err(Refused::Dimensions { d, least: 2, most: 2 });
        }
        refused::check(n, d, d)?;
        // What n must be, and the nearest such counts not above n and above.
        let (rule, low, high) = match (self.rows, self.columns) {
            (Some(rows), Some(columns)) => ("rows x columns", rows * columns, rows * columns),
            (Some(rows), None) => ("a multiple of the rows", n / rows * rows, (n / rows + 1) * rows),
            (None, columns) => {
                let columns = columns.unwrap_or(1);
                ("a multiple of the columns", n / columns * columns, (n / columns + 1) * columns)
            }
        };
        if low == n {
            return Ok(());
        }
        let below = Some(low).filter(|low| (1..n).contains(low));
        Err(Refused::Count { n, below, above: Some(high).filter(|&high| high > n), rule })
    }

    /// The slabs of each axis for admitted n and d: n in one dimension, columns and rows in two.
    pub fn cuts(self, n: usize, d: usize) -> Vec<usize> {
        match (self.columns, self.rows) {
            (Some(columns), _) => vec![columns, n / columns],
            (None, Some(rows)) => vec![n / rows, rows],
            (None, None) if d == 1 => vec![n],
            (None, None) => sides(n).map_or(vec![n, 1], |(columns, rows)| vec![columns, rows]),
        }
    }
}

/// Columns and rows of the grid of `n` cells nearest to a square, with rows <= columns <= 2 rows;
/// `None` where n has no such factors.
fn sides(n: usize) -> Option<(usize, usize)> {
    let rows = (1..=root(n as u64, 2) as usize)
        .rev()
        .take_while(|&rows| n <= 2 * rows * rows)
        .find(|&rows| n.is_multiple_of(rows))?;
    Some((n / rows, rows))
}

/// At most two dimensions; in two, n must be that of a grid that is nearly square.
fn nearly_square(n: usize, d: usize) -> Result<(), Refused> {
    refused::check(n, d, 2)?;
    let fits = |n: &usize| sides(*n).is_some();
    if d == 1 || fits(&n) {
        return Ok(());
    }
    let (below, above) = ((1..n).rev().find(fits), (n + 1..=2 * n).find(fits));
    Err(Refused::Count { n, below, above, rule: "columns x rows, with rows <= columns <= 2 rows" })
}
