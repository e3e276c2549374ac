//! Quadrature against Monte Carlo at equal cost: the midpoint rule on a grid, whose rate falls with the dimension, and the mean of
//! independent samples, whose rate does not.
//!
//! The rule with m points an axis costs m^d evaluations and errs as m^-2 for a smooth integrand, which is N^(-2/d).

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::estimation::{Rate, Study, rate, reference, root_mean_square, undefined};
use super::{Failure, Frame, Kind, Problems, Values, piece};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::moments::Sum;

/// The kind `quadrature`.
pub static QUADRATURE: QuadratureKind = QuadratureKind;

/// The kind of experiment that compares a grid with random samples.
pub struct QuadratureKind;

static ABOUT: About = About {
    key: "quadrature",
    title: "Quadrature against Monte Carlo",
    summary: "The error of the midpoint rule and of Monte Carlo at equal cost, in several dimensions, with fitted slopes.",
    file: "kinds/quadrature.rs",
    source: include_str!("quadrature.rs"),
    papers: &[Paper {
        authors: "P. J. Davis and P. Rabinowitz",
        year: 1984,
        title: "Methods of Numerical Integration",
        venue: "Academic Press, 2nd edition",
        doi: Some("10.1016/C2013-0-10566-1"),
    }],
};

parameters! {
    /// What a comparison with quadrature can choose.
    pub struct Quadrature {
        /// What is integrated; it must take any number of dimensions.
        integrand: Function = "genz-gaussian",
        /// The dimensions, one panel each.
        dimensions: Vec<usize> [in 1..=20] = [1, 2, 4, 8],
        /// The most evaluations.
        most: usize [in 16..=4_194_304] = 65_536,
        /// What the rule is compared with.
        sampler: Method = "independent",
        /// Over how many independent estimates the error of random samples is measured.
        replicates: usize [in 2..=10_000] = 32,
    }
}

/// The errors in every dimension.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    panels: Vec<Errors>,
}

/// The errors in one dimension: of N, and the absolute or root mean square error.
#[derive(Debug, Serialize, Deserialize)]
struct Errors {
    d: u32,
    midpoint: Vec<(u64, f64)>,
    sampled: Vec<(u64, f64)>,
    midpoint_rate: Option<Rate>,
    sampled_rate: Option<Rate>,
}

impl Kind for QuadratureKind {
    type Parameters = Quadrature;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Quadrature, problems: &mut Problems<'_, '_>) {
        for (index, &d) in p.dimensions.iter().enumerate() {
            if p.integrand.dimensions().is_some_and(|has| has > d) {
                let message = format!("`{}` has more variables than {d}", p.integrand.text());
                problems.element("dimensions", index, Code::Combination, message, None);
            }
            if sides(d, p.most).len() < 2 {
                let message = format!("a grid in {d} dimensions costs more than {} evaluations", p.most);
                let help = Some(format!("let `most` be at least 3^{d}"));
                problems.element("dimensions", index, Code::OutOfRange, message, help);
            }
            problems.admit("sampler", std::slice::from_ref(&p.sampler), &counts(p.most), d);
        }
        if p.dimensions.len() > 6 {
            problems.at("dimensions", Code::OutOfRange, "more than 6 panels do not fit a figure", None);
        }
    }

    fn weight(&self, p: &Quadrature) -> u64 {
        let dimensions: usize = p.dimensions.iter().sum();
        (dimensions as u64).saturating_mul(p.most as u64).saturating_mul(2 * p.replicates as u64)
    }

    fn run(&self, p: &Quadrature, seed: Seed) -> Result<Data, Failure> {
        let panels = p.dimensions.iter().map(|&d| errors(p, d, seed)).collect::<Result<Vec<_>, _>>()?;
        Ok(Data { panels })
    }

    fn values(&self, p: &Quadrature, data: &Data) -> Values {
        let mut values = Values::new();
        let name = p.sampler.name();
        for panel in &data.panels {
            let d = panel.d;
            values.number(format!("theory.midpoint.d{d}"), -2.0 / f64::from(d));
            for (method, rate) in [("midpoint", panel.midpoint_rate), (name.as_str(), panel.sampled_rate)] {
                if let Some(rate) = rate {
                    values.estimate(format!("slope.{method}.d{d}"), rate.slope, rate.error.unwrap_or(f64::NAN));
                }
            }
            for (method, errors) in [("midpoint", &panel.midpoint), (name.as_str(), &panel.sampled)] {
                for (n, error) in errors {
                    values.number(format!("error.{method}.d{d}.{n}"), *error);
                }
            }
        }
        values
    }

    fn tables(&self, p: &Quadrature, data: &Data) -> Vec<Frame> {
        let name = p.sampler.name();
        let rows = || {
            data.panels.iter().flat_map(|panel| {
                let midpoint = panel.midpoint.iter().map(move |mark| (panel.d, "midpoint", mark));
                midpoint.chain(panel.sampled.iter().map(move |mark| (panel.d, "", mark)))
            })
        };
        let named = |method: &str| if method.is_empty() { name.clone() } else { method.to_owned() };
        let frame = Frame::new("errors")
            .counts("dimensions", rows().map(|row| row.0 as usize))
            .text("method", rows().map(|row| named(row.1)))
            .counts("n", rows().map(|row| row.2.0 as usize))
            .numbers("error", rows().map(|row| row.2.1));
        vec![frame]
    }

    fn draw(&self, p: &Quadrature, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Quadrature, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The points an axis that the rule is tried with: at least two, each about a half more than the one before, and the most that
/// can be paid for.
fn sides(d: usize, most: usize) -> Vec<usize> {
    let affordable = |side: usize| side.checked_pow(d as u32).is_some_and(|cost| cost <= most);
    let mut sides = Vec::new();
    let mut side = 2;
    while affordable(side) {
        sides.push(side);
        side = (side + 1).max(side * 3 / 2);
    }
    sides
}

/// The counts that the sampler is tried with: powers of two from 4.
fn counts(most: usize) -> Vec<usize> {
    (2..usize::BITS).map(|power| 1 << power).take_while(|&n| n <= most).collect()
}

/// The errors of both in d dimensions.
fn errors(p: &Quadrature, d: usize, seed: Seed) -> Result<Errors, Failure> {
    let exact = reference(&p.integrand, d)?;
    // An error below that of the reference, or of rounding, says nothing.
    let floor = exact.error.max(exact.value.abs() * 1e-14);
    let sides = sides(d, p.most);
    let rule: Vec<Result<(u64, f64), Failure>> = sides
        .par_iter()
        .map(piece(|&side: &usize| {
            Ok((side.pow(d as u32) as u64, (midpoint(&p.integrand, d, side)? - exact.value).abs()))
        }))
        .collect();
    let mut rule = rule.into_iter().collect::<Result<Vec<_>, _>>()?;
    rule.retain(|mark| mark.1 > floor);
    let study = Study { kind: ABOUT.key, integrand: &p.integrand, d, seed: seed.at(d as u64) };
    let all = study.estimates(std::slice::from_ref(&p.sampler), &counts(p.most), p.replicates)?;
    let error = |(n, estimates): (usize, &Vec<f64>)| {
        let errors: Vec<f64> = estimates.iter().map(|estimate| estimate - exact.value).collect();
        (n as u64, root_mean_square(&errors).0)
    };
    let sampled: Vec<(u64, f64)> =
        counts(p.most).into_iter().zip(all.iter().flatten()).map(error).filter(|mark| mark.1 > floor).collect();
    let fit = |marks: &[(u64, f64)]| rate(marks.iter().map(|&(n, error)| (n as f64, error)));
    if rule.len() < 2 || sampled.len() < 2 {
        let message = format!("`{}` in {d} dimensions is integrated exactly: no rate is seen", p.integrand.text());
        return Err(Failure::of("integrand", message).help("choose an integrand that is no polynomial of low degree"));
    }
    Ok(Errors { d: d as u32, midpoint_rate: fit(&rule), sampled_rate: fit(&sampled), midpoint: rule, sampled })
}

/// The midpoint rule with `side` points an axis.
pub fn midpoint(integrand: &Function, d: usize, side: usize) -> Result<f64, Failure> {
    let mut sum = Sum::default();
    let mut point = vec![0.0; d];
    let count = side.pow(d as u32);
    for cell in 0..count {
        let mut rest = cell;
        for coordinate in &mut point {
            *coordinate = ((rest % side) as f64 + 0.5) / side as f64;
            rest /= side;
        }
        sum.add(integrand.evaluate(&point));
    }
    let mean = sum.value() / count as f64;
    if mean.is_finite() { Ok(mean) } else { Err(undefined(integrand, &[])) }
}

mod drawing {
    //! The drawing of errors over the cost, one panel for each dimension, and its words.

    use std::fmt::Write as _;

    use super::{Data, Errors, Quadrature};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{Axis, Chart, ChartError, Dash, Drawing, Key, Line, Marker, Panel, Rich, Role, Sheet, Style};

    const RULE: Style = Style { role: Role::Blue, dash: Dash::Solid, marker: Marker::Square };

    pub(super) fn draw(p: &Quadrature, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let panels: Vec<Panel> = data.panels.iter().map(|errors| panel(p, errors)).collect();
        let columns = if panels.len() > 1 { 2 } else { 1 };
        Ok(Chart::grid(panels).columns(columns).key(Key::Above).draw(sheet)?.into())
    }

    fn panel(p: &Quadrature, errors: &Errors) -> Panel {
        let points = |marks: &[(u64, f64)]| marks.iter().map(|&(n, error)| (n as f64, error)).collect::<Vec<_>>();
        let theory = |marks: &[(u64, f64)], slope: f64| {
            let (first, last) = (marks.first()?, marks.last()?);
            Some(Line::power(first.0 as f64, first.1, slope, last.0 as f64).label("theory"))
        };
        let slope = |rate: Option<super::Rate>| rate.map_or_else(String::new, |rate| fixed(rate.slope, 2));
        Panel::new(Axis::log2("*N*"), Axis::log("error"))
            .title(format!(
                "*d* = {}: slopes {} and {}",
                errors.d,
                slope(errors.midpoint_rate),
                slope(errors.sampled_rate)
            ))
            .ratio(0.72)
            .with_all(theory(&errors.midpoint, -2.0 / f64::from(errors.d)))
            .with_all(theory(&errors.sampled, -0.5).filter(|_| p.sampler.name() == "independent"))
            .with(Line::new(points(&errors.midpoint)).style(RULE).marked().label("midpoint rule"))
            .with(
                Line::new(points(&errors.sampled))
                    .style(Style::of(&p.sampler.name()))
                    .marked()
                    .label(Rich::plain(&p.sampler.title())),
            )
    }

    pub(super) fn alt(p: &Quadrature, data: &Data) -> String {
        let mut text = format!(
            "The error of the midpoint rule and of {} for the integral of {} over the number of evaluations, up to {}, on logarithmic axes.",
            p.sampler.title(),
            p.integrand.text(),
            integer(p.most as i64),
        );
        for errors in &data.panels {
            let slope = |rate: Option<super::Rate>| rate.map_or(f64::NAN, |rate| rate.slope);
            let last = |marks: &[(u64, f64)]| marks.last().map_or(f64::NAN, |mark| mark.1);
            let _ = write!(
                text,
                " In {} dimension{}: slope {} (theory {}) and error {} for the rule, slope {} and error {} for the samples.",
                errors.d,
                if errors.d == 1 { "" } else { "s" },
                fixed(slope(errors.midpoint_rate), 2),
                fixed(-2.0 / f64::from(errors.d), 2),
                significant(last(&errors.midpoint), 2),
                fixed(slope(errors.sampled_rate), 2),
                significant(last(&errors.sampled), 2),
            );
        }
        text
    }
}
