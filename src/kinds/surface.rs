//! The surface: an integrand over the unit square as a map in shades, and three cuts across it.
//!
//! An integrand of more variables is shown where the others are 1/2. The mean over the map's own grid is given beside what is known exactly.

use serde::{Deserialize, Serialize};

use super::estimation::{dimensions, undefined};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::parameters;
use crate::raster::{Png, Raster};
use crate::seed::Seed;
use crate::stats::moments;

/// The kind `surface`.
pub static SURFACE: SurfaceKind = SurfaceKind;

/// The kind of experiment that maps a function of several variables.
pub struct SurfaceKind;

static ABOUT: About = About {
    key: "surface",
    title: "Surface",
    summary: "An integrand over the unit square in shades, with cuts across it and what is known of it exactly.",
    file: "kinds/surface.rs",
    source: include_str!("surface.rs"),
    papers: &[],
};

/// The cells of the map along an axis.
const SIDE: usize = 128;

/// Where the cuts lie on the second axis.
const CUTS: [f64; 3] = [0.25, 0.5, 0.75];

/// Into how many steps a cut is cut.
const STEPS: usize = 96;

/// The shades of the map: enough to see, few enough to pack well.
const SHADES: f64 = 24.0;

parameters! {
    /// What the map of a function can choose.
    pub struct Surface {
        /// The function of two variables or more.
        integrand: Function,
        /// The dimensions of the unit cube, at least those of the integrand, which are the default.
        dimensions: Option<usize> [in 2..=64],
    }
}

/// The map and what is known of the function.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    map: Png,
    cuts: Vec<Vec<f64>>,
    mean: f64,
    minimum: f64,
    maximum: f64,
    integral: Option<f64>,
    variance: Option<f64>,
    variation: Option<f64>,
}

impl Kind for SurfaceKind {
    type Parameters = Surface;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Surface) {
        p.dimensions = Some(dimensions(&p.integrand, p.dimensions).max(2));
    }

    fn check(&self, p: &Surface, problems: &mut Problems<'_, '_>) {
        super::estimation::check_dimensions(&p.integrand, p.dimensions, problems);
        if p.integrand.dimensions() == Some(1) {
            let message = format!("`{}` has one variable", p.integrand.text());
            problems.at("integrand", Code::Combination, message, Some("draw it with `kind = \"function\"`".to_owned()));
        }
    }

    fn weight(&self, _: &Surface) -> u64 {
        (SIDE * SIDE) as u64
    }

    fn run(&self, p: &Surface, _: Seed) -> Result<Data, Failure> {
        let middle = |k: usize| (k as f64 + 0.5) / SIDE as f64;
        let cells = (0..SIDE).rev().flat_map(|row| (0..SIDE).map(move |column| (column, row)));
        let heights: Vec<f64> = cells.map(|(column, row)| height(p, middle(column), middle(row))).collect();
        let cut = |y: f64| (0..=STEPS).map(|step| height(p, along(step), y)).collect::<Vec<f64>>();
        let cuts: Vec<Vec<f64>> = CUTS.iter().map(|&y| cut(y)).collect();
        if heights.iter().chain(cuts.iter().flatten()).any(|height| !height.is_finite()) {
            return Err(undefined(&p.integrand, &[]));
        }
        let minimum = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let maximum = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let d = p.dimensions.unwrap_or(2);
        Ok(Data {
            map: map(&heights, minimum, maximum)?,
            cuts,
            mean: moments::mean(&heights),
            minimum,
            maximum,
            integral: p.integrand.integral(d).map(|reference| reference.value),
            variance: p.integrand.variance(d),
            variation: p.integrand.variation(d),
        })
    }

    fn values(&self, _: &Surface, data: &Data) -> Values {
        let mut values = Values::new();
        for (name, value) in [("integral", data.integral), ("variance", data.variance), ("variation", data.variation)] {
            if let Some(value) = value {
                values.number(name, value);
            }
        }
        values.number("grid.mean", data.mean);
        values.number("minimum", data.minimum);
        values.number("maximum", data.maximum);
        values
    }

    fn tables(&self, _: &Surface, data: &Data) -> Vec<Frame> {
        let frame = Frame::new("cuts").numbers("x", (0..=STEPS).map(along));
        vec![
            data.cuts
                .iter()
                .zip(CUTS)
                .fold(frame, |frame, (cut, y)| frame.numbers(format!("y = {y}"), cut.iter().copied())),
        ]
    }

    fn draw(&self, _: &Surface, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(data, sheet)
    }

    fn alt(&self, p: &Surface, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The abscissa of a step; the last is the end of the half-open axis.
fn along(step: usize) -> f64 {
    if step >= STEPS { 1.0 - f64::EPSILON } else { step as f64 / STEPS as f64 }
}

/// The function at a point of the square, its other variables at 1/2.
fn height(p: &Surface, x: f64, y: f64) -> f64 {
    let mut point = vec![0.5; p.dimensions.unwrap_or(2)];
    for (place, value) in point.iter_mut().zip([x, y]) {
        *place = value;
    }
    p.integrand.evaluate(&point)
}

/// The heights as shades, black for the least.
fn map(heights: &[f64], minimum: f64, maximum: f64) -> Result<Png, Failure> {
    let shade = |height: &f64| {
        let share = if maximum > minimum { (height - minimum) / (maximum - minimum) } else { 0.5 };
        ((share * (SHADES - 1.0)).round() * 255.0 / (SHADES - 1.0)).round() as u8
    };
    let raster = Raster::grey(SIDE as u32, SIDE as u32, heights.iter().map(shade).collect());
    raster.png().map_err(|error| Failure::of("integrand", error.to_string()))
}

mod drawing {
    //! The map, the cuts, and their words.

    use std::fmt::Write as _;

    use super::{CUTS, Data, Surface, along};
    use crate::chart::number::{shortest, significant};
    use crate::chart::{Axis, Chart, ChartError, Drawing, Image, Line, Panel, Role, Rule, Sheet, Style};

    /// The colours of the cuts.
    const ROLES: [Role; 3] = [Role::STEPS[0], Role::STEPS[2], Role::STEPS[4]];

    pub(super) fn draw(data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let side = |name: &str| Axis::linear(name).range(0.0, 1.0).ticks_at(vec![(0.0, "0".into()), (1.0, "1".into())]);
        let cut = |y: f64| Rule::horizontal(y).style(Style::new(Role::Accent));
        let map =
            Panel::new(side("*x*"), side("*y*")).equal().with(Image::new((0.0, 0.0), (1.0, 1.0), data.map.clone()));
        let map = map.with_all(CUTS.map(cut));
        let line = |((cut, y), role): ((&Vec<f64>, f64), Role)| {
            let points = cut.iter().enumerate().map(|(step, height)| (along(step), *height)).collect();
            Line::new(points).style(Style::new(role)).label(format!("*y* = {}", shortest(y)))
        };
        let cuts = data.cuts.iter().zip(CUTS).zip(ROLES).map(line);
        let panel = Panel::new(Axis::linear("*x*").range(0.0, 1.0), Axis::linear("*f*").include(0.0)).ratio(1.0);
        Ok(Chart::grid(vec![map, panel.with_all(cuts)]).columns(2).draw(sheet)?.into())
    }

    pub(super) fn alt(p: &Surface, data: &Data) -> String {
        let mut text = format!(
            "A map of {} over the unit square, from {} to {}",
            p.integrand.text(),
            significant(data.minimum, 3),
            significant(data.maximum, 3)
        );
        if let Some(integral) = data.integral {
            let _ = write!(text, ", with the integral {}", significant(integral, 4));
        }
        text.push_str("; and three cuts at fixed y.");
        text
    }
}
