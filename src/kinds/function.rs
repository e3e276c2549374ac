//! The function: the curve of an integrand of one variable, the area under it, and its mean height.

use serde::{Deserialize, Serialize};

use super::estimation::undefined;
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function as Integrand;
use crate::parameters::parameters;
use crate::seed::Seed;
use crate::stats::quadrature;

/// The kind `function`.
pub static FUNCTION: FunctionKind = FunctionKind;

/// The kind of experiment that draws a curve.
pub struct FunctionKind;

static ABOUT: About = About {
    key: "function",
    title: "Function",
    summary: "The curve of an integrand of one variable, with the area under it and its mean height.",
    file: "kinds/function.rs",
    source: include_str!("function.rs"),
    papers: &[],
};

/// Into how many steps the curve is cut.
const STEPS: usize = 600;

parameters! {
    /// What the drawing of a function can choose.
    pub struct Function {
        /// The function of one variable.
        integrand: Integrand,
        /// Where the curve begins.
        from: f64 [in -1e9..=1e9] = 0.0,
        /// Where it ends.
        to: f64 [in -1e9..=1e9] = 1.0,
        /// Whether the area under the curve is filled.
        @drawn area: bool = true,
        /// Whether the mean height is marked.
        @drawn mean: bool = true,
    }
}

/// The curve and what is known of it.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    heights: Vec<f64>,
    /// The integral from end to end, with the error of the quadrature.
    integral: Option<(f64, f64)>,
    /// The variance of the function of a uniform variable.
    variance: Option<f64>,
    minimum: (f64, f64),
    maximum: (f64, f64),
}

impl Kind for FunctionKind {
    type Parameters = Function;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Function, problems: &mut Problems<'_, '_>) {
        if p.from >= p.to {
            let message = format!("the curve ends at {}, not after its beginning at {}", p.to, p.from);
            problems.at("to", Code::OutOfRange, message, Some("`from` must be less than `to`".to_owned()));
        }
        if let Some(d) = p.integrand.dimensions().filter(|d| *d > 1) {
            let message = format!("`{}` has {d} variables; a curve has one", p.integrand.text());
            problems.at("integrand", Code::Combination, message, None);
        }
    }

    fn weight(&self, _: &Function) -> u64 {
        STEPS as u64 * 4
    }

    fn run(&self, p: &Function, _: Seed) -> Result<Data, Failure> {
        let (f, width) = (&p.integrand, p.to - p.from);
        let heights: Vec<f64> = (0..=STEPS).map(|step| f.evaluate(&[at(p, step)])).collect();
        if let Some(step) = heights.iter().position(|height| !height.is_finite()) {
            return Err(undefined(f, &[at(p, step)]).help("choose `from` and `to` such that it is finite between them"));
        }
        let unit = p.from == 0.0 && p.to == 1.0;
        let exact = f.integral(1).filter(|_| unit).map(|reference| (reference.value, reference.error));
        let by_rule = || quadrature::integrate(1, |u| f.evaluate(&[p.from + width * u[0]]));
        let integral = exact.or_else(|| by_rule().map(|integral| (integral.value * width, integral.error * width)));
        let variance = match integral {
            Some(_) if unit => f.variance(1),
            Some((integral, _)) => spread(f, p, integral / width),
            None => None,
        };
        let (minimum, maximum) = (extreme(p, &heights, -1.0), extreme(p, &heights, 1.0));
        Ok(Data { heights, integral, variance, minimum, maximum })
    }

    fn values(&self, p: &Function, data: &Data) -> Values {
        let mut values = Values::new();
        if let Some((integral, _)) = data.integral {
            values.number("integral", integral);
            values.number("mean", integral / (p.to - p.from));
        }
        if let Some(variance) = data.variance {
            values.number("variance", variance);
            values.number("sigma", variance.max(0.0).sqrt());
        }
        values.number("minimum", data.minimum.1);
        values.number("minimum.at", data.minimum.0);
        values.number("maximum", data.maximum.1);
        values.number("maximum.at", data.maximum.0);
        values
    }

    fn tables(&self, p: &Function, data: &Data) -> Vec<Frame> {
        let x = (0..data.heights.len()).map(|step| at(p, step));
        vec![Frame::new("curve").numbers("x", x).numbers("f", data.heights.iter().copied())]
    }

    fn draw(&self, p: &Function, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Function, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The abscissa of a step; the last is the end itself.
fn at(p: &Function, step: usize) -> f64 {
    if step >= STEPS { p.to } else { p.from + (p.to - p.from) * (step as f64 / STEPS as f64) }
}

/// The variance of the function of a uniform variable between the ends.
fn spread(f: &Integrand, p: &Function, mean: f64) -> Option<f64> {
    let square = |u: &[f64]| {
        let apart = f.evaluate(&[p.from + (p.to - p.from) * u.first().copied().unwrap_or(0.0)]) - mean;
        apart * apart
    };
    quadrature::integrate(1, square).map(|integral| integral.value)
}

/// Where the function is largest (`sign` 1) or smallest (-1), and how large: the best step, refined by golden sections.
fn extreme(p: &Function, heights: &[f64], sign: f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let height = |x: f64| sign * p.integrand.evaluate(&[x]);
    // The first of equals: where a plateau begins.
    let better = |a: &usize, b: &usize| (sign * heights[*a]).total_cmp(&(sign * heights[*b])).then(b.cmp(a));
    let best = (0..heights.len()).max_by(better).unwrap_or(0);
    let mut top = (at(p, best), sign * heights.get(best).copied().unwrap_or(f64::NAN));
    let (mut low, mut high) = (at(p, best.saturating_sub(1)), at(p, best + 1));
    for _ in 0..60 {
        let (left, right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
        if height(left) >= height(right) {
            high = right;
        } else {
            low = left;
        }
        for x in [left, right] {
            // Strictly better only: on a plateau the first step stays.
            if height(x) > top.1 {
                top = (x, height(x));
            }
        }
    }
    (top.0, sign * top.1)
}

mod drawing {
    //! The drawing of the curve, and its words.

    use std::fmt::Write as _;

    use super::{Data, Function, at};
    use crate::chart::number::significant;
    use crate::chart::{Area, Axis, Chart, ChartError, Corner, Drawing, Line, Note, Panel, Role, Rule, Sheet, Style};

    pub(super) fn draw(p: &Function, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let curve: Vec<(f64, f64)> =
            data.heights.iter().enumerate().map(|(step, height)| (at(p, step), *height)).collect();
        let mut panel = Panel::new(Axis::linear("*x*"), Axis::linear("*f*(*x*)").include(0.0)).ratio(0.5);
        if p.area {
            panel = panel.with(Area::new(curve.clone()));
        }
        if let Some((integral, _)) = data.integral.filter(|_| p.mean) {
            let mean = integral / (p.to - p.from);
            panel = panel.with(Rule::horizontal(mean)).with(label(p, data, mean));
        }
        let panel = panel.with(Line::new(curve).style(Style::new(Role::Accent)));
        Ok(Chart::new(panel).draw(sheet)?.into())
    }

    /// The name of the mean height, at the end where the curve is farther from it.
    fn label(p: &Function, data: &Data, mean: f64) -> Note {
        let apart = |height: Option<&f64>| height.map_or(0.0, |height| (height - mean).abs());
        let left = apart(data.heights.first()) >= apart(data.heights.last());
        let (x, corner) = if left { (p.from, Corner::AboveRight) } else { (p.to, Corner::AboveLeft) };
        Note::new((x, mean), format!("mean {}", significant(mean, 4))).corner(corner)
    }

    /// A number in at most four digits, without the zeros at its end.
    fn say(value: f64) -> String {
        let text = significant(value, 4);
        if !text.contains('.') || text.contains('×') {
            return text;
        }
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    }

    pub(super) fn alt(p: &Function, data: &Data) -> String {
        let mut text = format!(
            "The curve of {} from x = {} to {}: between {} (at x = {}) and {} (at x = {})",
            p.integrand.text(),
            p.from,
            p.to,
            say(data.minimum.1),
            say(data.minimum.0),
            say(data.maximum.1),
            say(data.maximum.0),
        );
        if let Some((integral, _)) = data.integral {
            let _ = write!(
                text,
                ", with an area of {} below it and the mean height {}",
                say(integral),
                say(integral / (p.to - p.from))
            );
        }
        text.push('.');
        text
    }
}
