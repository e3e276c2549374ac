//! What was found of the two forms of a program: the test's verdict, measured numbers, and what is drawn.

use serde::{Deserialize, Serialize};

use crate::kinds::{Frame, Values};
use crate::metrics::occupancy;
use crate::points::Points;
use crate::stats::moments::Moments;

/// What was found of a mistake.
#[derive(Debug, Serialize, Deserialize)]
pub struct Found {
    /// The program with the mistake.
    pub wrong: Side,
    /// The right program.
    pub right: Side,
    /// What belongs to neither: expected values, borders.
    pub facts: Facts,
}

/// One of the two programs.
#[derive(Debug, Serialize, Deserialize)]
pub struct Side {
    /// Whether it passes the test.
    pub passes: bool,
    /// What was measured of it.
    pub facts: Facts,
    /// Named columns of equal length: its points, or the values of its curve.
    columns: Vec<(String, Vec<f64>)>,
    /// Named lists of their own lengths, which are no part of its frame.
    lists: Vec<(String, Vec<f64>)>,
    /// Boxes that the picture points at: left, bottom, right, top.
    pub boxes: Vec<[f64; 4]>,
}

/// Named numbers, in order.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Facts(Vec<(String, Fact)>);

/// A number.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
enum Fact {
    Integer(i64),
    Number(f64),
    /// With its standard error.
    Estimate(f64, f64),
}

impl Facts {
    /// With a count.
    #[must_use]
    pub fn integer(self, name: impl Into<String>, value: i64) -> Self {
        self.with(name.into(), Fact::Integer(value))
    }

    /// With a number.
    #[must_use]
    pub fn number(self, name: impl Into<String>, value: f64) -> Self {
        self.with(name.into(), Fact::Number(value))
    }

    /// With the mean of several repetitions and its standard error.
    #[must_use]
    pub fn estimate(self, name: impl Into<String>, moments: &Moments) -> Self {
        self.with(name.into(), Fact::Estimate(moments.mean(), moments.standard_error()))
    }

    fn with(mut self, name: String, fact: Fact) -> Self {
        self.0.push((name, fact));
        self
    }

    /// The number called `name`; NaN if there is none.
    pub fn get(&self, name: &str) -> f64 {
        let fact = self.0.iter().find(|fact| fact.0 == name).map(|fact| fact.1);
        fact.map_or(f64::NAN, |fact| match fact {
            Fact::Integer(value) => value as f64,
            Fact::Number(value) | Fact::Estimate(value, _) => value,
        })
    }

    /// The count called `name`; 0 if there is none.
    pub fn count(&self, name: &str) -> i64 {
        self.get(name) as i64
    }

    /// Adds them to `values`, each name behind `prefix`.
    pub fn tell(&self, prefix: &str, values: &mut Values) {
        for (name, fact) in &self.0 {
            let name = format!("{prefix}{name}");
            match *fact {
                Fact::Integer(value) => values.integer(name, value),
                Fact::Number(value) => values.number(name, value),
                Fact::Estimate(value, error) => values.estimate(name, value, error),
            }
        }
    }
}

impl Side {
    /// A program that passes the test or not, and what was measured of it.
    pub fn new(passes: bool, facts: Facts) -> Self {
        Self { passes, facts, columns: Vec::new(), lists: Vec::new(), boxes: Vec::new() }
    }

    /// With a column.
    #[must_use]
    pub fn column(mut self, name: impl Into<String>, numbers: impl IntoIterator<Item = f64>) -> Self {
        self.columns.push((name.into(), numbers.into_iter().collect()));
        self
    }

    /// With a list beside the columns.
    #[must_use]
    pub fn list(mut self, name: impl Into<String>, numbers: impl IntoIterator<Item = f64>) -> Self {
        self.lists.push((name.into(), numbers.into_iter().collect()));
        self
    }

    /// With the points that it placed.
    #[must_use]
    pub fn points(self, points: &[[f64; 2]]) -> Self {
        self.column("x", points.iter().map(|point| point[0])).column("y", points.iter().map(|point| point[1]))
    }

    /// With boxes to point at.
    #[must_use]
    pub fn boxes(mut self, boxes: Vec<[f64; 4]>) -> Self {
        self.boxes = boxes;
        self
    }

    /// The column or list called `name`; empty if there is none.
    pub fn get(&self, name: &str) -> &[f64] {
        self.columns.iter().chain(&self.lists).find(|column| column.0 == name).map_or(&[], |column| &column.1)
    }

    /// Two columns as pairs.
    pub fn pairs(&self, x: &str, y: &str) -> Vec<(f64, f64)> {
        self.get(x).iter().copied().zip(self.get(y).iter().copied()).collect()
    }

    /// Its columns as a frame.
    pub fn frame(&self, name: &'static str) -> Frame {
        let columns = self.columns.iter();
        columns.fold(Frame::new(name), |frame, (name, numbers)| frame.numbers(name, numbers.iter().copied()))
    }
}

/// Points of the plane as a point set; `None` of none.
pub fn placed(points: &[[f64; 2]]) -> Option<Points> {
    Points::from_rows(2, points.as_flattened().to_vec()).filter(|points| !points.is_empty())
}

/// The boxes without a point, of a grid of `columns` by `rows` equal boxes.
pub fn empty_boxes(points: &[[f64; 2]], [columns, rows]: [usize; 2]) -> Vec<[f64; 4]> {
    let counts = placed(points).and_then(|points| occupancy::cells(&points, &[columns, rows])).unwrap_or_default();
    let (width, height) = (1.0 / columns as f64, 1.0 / rows as f64);
    let place = |cell: usize| {
        let (x, y) = ((cell % columns) as f64, (cell / columns) as f64);
        [x * width, y * height, (x + 1.0) * width, (y + 1.0) * height]
    };
    let empty = counts.iter().enumerate().filter(|(_, count)| **count == 0);
    empty.map(|(cell, _)| place(cell)).collect()
}

/// The mean of some numbers with its spread.
pub fn mean_of(numbers: impl IntoIterator<Item = f64>) -> Moments {
    let mut moments = Moments::default();
    numbers.into_iter().for_each(|number| moments.push(number));
    moments
}
