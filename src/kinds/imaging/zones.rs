//! Zones: rectangles of a picture whose errors are told by themselves, so that a chapter can say what is gained where.

use serde::{Deserialize, Serialize};

use super::Reference;
use crate::kinds::estimation::mean_with_error;
use crate::kinds::experiment::{Frame, Values};
use crate::parameters::Pair;

/// The colour of a zone's frame.
const FRAME: [u8; 3] = [40, 40, 40];

/// Rectangles of one size in a picture.
pub struct Zones<'a> {
    /// Their first columns and rows.
    pub corners: &'a [Pair],
    /// How many columns and rows each has.
    pub size: Pair,
    /// The columns of the picture.
    pub width: usize,
}

/// The error in one zone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ZoneError {
    /// The root mean square, without what the reference's own error there adds to it.
    pub rmse: f64,
    /// Its standard error, where pixels are independent.
    pub error: Option<f64>,
}

impl Zones<'_> {
    /// The first zone that does not lie in a picture of so many rows.
    pub fn outside(&self, height: usize) -> Option<Pair> {
        let Pair(columns, rows) = self.size;
        let is_outside = |&&Pair(left, top): &&Pair| left + columns > self.width || top + rows > height;
        self.corners.iter().find(is_outside).copied()
    }

    /// The error in each, from the differences of all pixels; `independent` tells whether the pixels have samples that are independent.
    pub fn errors(&self, differences: &[f64], reference: &Reference, independent: bool) -> Vec<ZoneError> {
        let squares = |values: &[f64], corner: Pair| -> Vec<f64> {
            self.pixels(corner).filter_map(|at| values.get(at)).map(|value| value * value).collect()
        };
        let zone = |&corner: &Pair| {
            let (square, error) = mean_with_error(&squares(differences, corner));
            // The mean of two images errs by half of their difference.
            let (floor, _) = mean_with_error(&squares(&reference.gaps, corner));
            let rmse = (square - 0.25 * floor).max(0.0).sqrt();
            ZoneError { rmse, error: error.filter(|_| independent && rmse > 0.0).map(|error| error / (2.0 * rmse)) }
        };
        self.corners.iter().map(zone).collect()
    }

    /// The bytes of a picture with the frame of each zone drawn into it.
    pub fn framed(&self, mut bytes: Vec<u8>) -> Vec<u8> {
        let Pair(columns, rows) = self.size;
        for &corner in self.corners {
            for (index, at) in self.pixels(corner).enumerate() {
                let (column, row) = (index % columns, index / columns);
                let border = column == 0 || row == 0 || column + 1 == columns || row + 1 == rows;
                if let Some(pixel) = bytes.get_mut(3 * at..3 * at + 3).filter(|_| border) {
                    pixel.copy_from_slice(&FRAME);
                }
            }
        }
        bytes
    }

    /// The places of a zone's pixels, row by row.
    fn pixels(&self, Pair(left, top): Pair) -> impl Iterator<Item = usize> {
        let (Pair(columns, rows), width) = (self.size, self.width);
        (0..rows).flat_map(move |row| (0..columns).map(move |column| (top + row) * width + left + column))
    }
}

/// Adds the errors in the zones of a picture to the values: `zone.1.NAME` and so on.
pub fn zone_values(values: &mut Values, name: &str, zones: &[ZoneError]) {
    for (index, zone) in zones.iter().enumerate() {
        values.estimate(format!("zone.{}.{name}", index + 1), zone.rmse, zone.error.unwrap_or(f64::NAN));
    }
}

/// Adds a column for each zone, a row for each picture.
pub fn zone_columns(mut frame: Frame, pictures: &[&[ZoneError]]) -> Frame {
    for index in 0..pictures.first().map_or(0, |zones| zones.len()) {
        let column = pictures.iter().filter_map(|zones| zones.get(index)).map(|zone| zone.rmse);
        frame = frame.numbers(format!("rmse in zone {}", index + 1), column);
    }
    frame
}
