//! The distribution: a density and its distribution function side by side, a probability as an area and as a difference of
//! heights, and sampling by inversion.
//!
//! The histogram's samples are held against the law by the chi-square test, with the probabilities of the bins from quadrature of
//! the density where it was written: another way than the inversion that made the samples.

use serde::{Deserialize, Serialize};

use super::estimation::{Density, Law, Named, check_density, check_ends};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::integrands::Function;
use crate::parameters::{choices, parameters};
use crate::samplers::Method;
use crate::seed::Seed;
use crate::stats::histogram::Histogram;
use crate::stats::{inference, quadrature};

/// The kind `distribution`.
pub static DISTRIBUTION: DistributionKind = DistributionKind;

/// The kind of experiment that shows a law.
pub struct DistributionKind;

static ABOUT: About = About {
    key: "distribution",
    title: "Density and distribution",
    summary: "A density beside its distribution function: a probability as an area and as a difference, or sampling by inversion.",
    file: "kinds/distribution.rs",
    source: include_str!("distribution.rs"),
    papers: &[Paper {
        authors: "L. Devroye",
        year: 1986,
        title: "Non-Uniform Random Variate Generation",
        venue: "Springer",
        doi: Some("10.1007/978-1-4613-8643-8"),
    }],
};

/// Into how many steps the curves are cut.
const STEPS: usize = 400;

choices! {
    /// What is drawn beside the curves.
    pub enum Show {
        /// The probability between a and b, as an area and as a difference of heights.
        Probability = "probability",
        /// Sampling by inversion: arrows from u to x, and the histogram of the samples.
        Inversion = "inversion",
    }
}

parameters! {
    /// What the drawing of a law can choose.
    pub struct Distribution {
        /// The law, by its name; otherwise write its density.
        law: Option<Named>,
        /// The density as an expression in x, up to its factor: it is divided by its mass between the ends.
        density: Option<Function>,
        /// The left end of the axis, and of the support of a density that is written.
        from: Option<f64> [in -1e6..=1e6],
        /// The right end.
        to: Option<f64> [in -1e6..=1e6],
        /// Where the event begins whose probability is marked.
        a: Option<f64> [in -1e6..=1e6],
        /// Where it ends.
        b: Option<f64> [in -1e6..=1e6],
        /// Where the numbers u come from.
        sampler: Method = "independent",
        /// How many samples the histogram is made of.
        n: usize [in 100..=1_000_000] = 10_000,
        /// Into how many bins they fall.
        bins: usize [in 2..=200] = 32,
        /// How many arrows show the inversion; as many samples are drawn for them alone.
        arrows: usize [in 1..=64] = 16,
        /// What is shown beside the curves.
        @drawn show: Show = "probability",
    }
}

/// The law and its samples.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    densities: Vec<f64>,
    distribution: Vec<f64>,
    /// The mass of a written density before it is made 1, with a bound on its error.
    mass: Option<(f64, f64)>,
    /// P(a) and P(b).
    heights: (f64, f64),
    measured: f64,
    measured_error: f64,
    chi_square: Option<(f64, f64)>,
    counts: Vec<u64>,
    outside: u64,
    arrows: Vec<(f64, f64)>,
}

impl Kind for DistributionKind {
    type Parameters = Distribution;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut Distribution) {
        let (from, to) = p.law.map_or((0.0, 1.0), Named::ends);
        let (from, to) = (*p.from.get_or_insert(from), *p.to.get_or_insert(to));
        p.a.get_or_insert(from + 0.25 * (to - from));
        p.b.get_or_insert(from + 0.5 * (to - from));
    }

    fn check(&self, p: &Distribution, problems: &mut Problems<'_, '_>) {
        if p.law.is_some() == p.density.is_some() {
            let (name, message) = match p.law {
                Some(_) => ("density", "both `law` and `density` are given"),
                None => ("law", "there is neither a `law` nor a `density`"),
            };
            let help = "write `law = \"normal\"`, or `density = \"x*(1-x)\"` with `from` and `to`".to_owned();
            problems.at(name, Code::Combination, message, Some(help));
        }
        if let Some(density) = &p.density {
            check_density(density, "density", None, problems);
        }
        let (from, to, a, b) = p.ends();
        check_ends(from, to, "to", problems);
        check_ends(a, b, "b", problems);
        problems.admit("sampler", std::slice::from_ref(&p.sampler), &[p.n], 1);
    }

    fn weight(&self, p: &Distribution) -> u64 {
        40 * p.n as u64 + 100_000
    }

    fn run(&self, p: &Distribution, seed: Seed) -> Result<Data, Failure> {
        let (from, to, a, b) = p.ends();
        let law = p.chosen()?;
        let at = |step: usize| from + (to - from) * (step as f64 / STEPS as f64);
        let points = |n: usize, name: &str| {
            let stream = seed.named(ABOUT.key).named(name).named(&p.sampler.name());
            p.sampler.points(n, 1, stream).map_err(|refused| Failure::of("sampler", refused.to_string()))
        };
        let samples: Vec<f64> = points(p.n, "samples")?.axis(0).map(|u| law.inverse(u)).collect();
        let none =
            || Failure::of("bins", "the samples fall in no bins").help("choose ends between which there is mass");
        let bins = Histogram::new(&samples, from, to, p.bins).ok_or_else(none)?;
        let inside = samples.iter().filter(|x| (a..=b).contains(*x)).count() as f64 / p.n as f64;
        let heights = (law.distribution(a), law.distribution(b));
        let exact = heights.1 - heights.0;
        // Where a sampler cannot give so few points, the arrows are independent.
        let arrows = points(p.arrows, "arrows").map_or_else(|_| scattered(seed, p.arrows), |few| few.axis(0).collect());
        Ok(Data {
            densities: (0..=STEPS).map(|step| law.density(at(step))).collect(),
            distribution: (0..=STEPS).map(|step| law.distribution(at(step))).collect(),
            mass: if let Law::Written(density) = &law { Some(density.mass) } else { None },
            heights,
            measured: inside,
            measured_error: (exact * (1.0 - exact) / p.n as f64).sqrt(),
            chi_square: chi_square(&law, &bins),
            outside: bins.below + bins.above,
            counts: bins.counts,
            arrows: arrows.into_iter().map(|u| (u, law.inverse(u))).collect(),
        })
    }

    fn values(&self, _: &Distribution, data: &Data) -> Values {
        let mut values = Values::new();
        values.number("probability", data.heights.1 - data.heights.0);
        values.number("distribution.a", data.heights.0);
        values.number("distribution.b", data.heights.1);
        values.estimate("measured", data.measured, data.measured_error);
        if let Some((statistic, probability)) = data.chi_square {
            values.number("chi-square", statistic);
            values.number("chi-square.p", probability);
        }
        if let Some((mass, error)) = data.mass {
            values.number("mass", mass);
            values.number("mass.error", error);
        }
        values
    }

    fn tables(&self, p: &Distribution, data: &Data) -> Vec<Frame> {
        let (from, to, ..) = p.ends();
        let at = |part: usize, parts: usize| from + (to - from) * (part as f64 / parts as f64);
        let curves = Frame::new("curves")
            .numbers("x", (0..=STEPS).map(|step| at(step, STEPS)))
            .numbers("density", data.densities.iter().copied())
            .numbers("distribution", data.distribution.iter().copied());
        let histogram = Frame::new("histogram")
            .numbers("from", (0..p.bins).map(|bin| at(bin, p.bins)))
            .numbers("to", (1..=p.bins).map(|bin| at(bin, p.bins)))
            .counts("count", data.counts.iter().map(|&count| count as usize));
        let arrows = Frame::new("arrows")
            .numbers("u", data.arrows.iter().map(|arrow| arrow.0))
            .numbers("x", data.arrows.iter().map(|arrow| arrow.1));
        vec![curves, histogram, arrows]
    }

    fn draw(&self, p: &Distribution, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Distribution, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Distribution {
    /// From, to, a and b.
    fn ends(&self) -> (f64, f64, f64, f64) {
        let (from, to) = (self.from.unwrap_or(0.0), self.to.unwrap_or(1.0));
        (from, to, self.a.unwrap_or(from), self.b.unwrap_or(to))
    }

    /// The law that was asked for.
    fn chosen(&self) -> Result<Law, Failure> {
        let (from, to, ..) = self.ends();
        match (self.law, &self.density) {
            (Some(named), _) => Ok(Law::Named(named, (from, to))),
            (None, Some(density)) => Ok(Law::Written(Density::new(density, from, to, "density")?)),
            (None, None) => Err(Failure::of("law", "there is no law to show").help("write `law` or `density`")),
        }
    }
}

/// Independent numbers for the arrows.
fn scattered(seed: Seed, count: usize) -> Vec<f64> {
    let mut random = seed.named(ABOUT.key).named("scattered").generator();
    (0..count).map(|_| random.uniform()).collect()
}

/// The statistic and the probability of counts at least as far off the law.
fn chi_square(law: &Law, bins: &Histogram) -> Option<(f64, f64)> {
    let probability = |(from, to): (f64, f64)| match law {
        Law::Named(..) => Some(law.distribution(to) - law.distribution(from)),
        Law::Written(density) => {
            let mass = quadrature::integrate(1, |u| density.height(from + (to - from) * u[0]))?;
            Some(mass.value * (to - from))
        }
    };
    let mut expected =
        bins.densities().into_iter().map(|(from, to, _)| probability((from, to))).collect::<Option<Vec<f64>>>()?;
    let mut counts = bins.counts.clone();
    counts.push(bins.below + bins.above);
    expected.push((1.0 - expected.iter().sum::<f64>()).max(0.0));
    let verdict = inference::chi_square_against(&counts, &expected)?;
    Some((verdict.statistic, verdict.probability))
}

mod drawing {
    //! The drawing of a law, and its words.

    use std::fmt::Write as _;

    use super::{Data, Distribution, STEPS, Show};
    use crate::chart::number::{fixed, integer, significant};
    use crate::chart::{
        Area, Axis, Bars, Chart, ChartError, Corner, Dash, Drawing, Key, Line, Marker, Marks, Note, Panel, Role, Sheet,
        Style,
    };

    type Curve = Vec<(f64, f64)>;

    pub(super) fn draw(p: &Distribution, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let (from, to, ..) = p.ends();
        let curve = |heights: &[f64]| -> Curve {
            let at = |step: usize| from + (to - from) * (step as f64 / STEPS as f64);
            heights.iter().enumerate().map(|(step, height)| (at(step), *height)).collect()
        };
        let (density, distribution) = (curve(&data.densities), curve(&data.distribution));
        let panels = match p.show {
            Show::Probability => vec![area(p, data, &density), difference(p, data, distribution)],
            Show::Inversion => vec![arrows(p, data, distribution), histogram(p, data, density)],
        };
        Ok(Chart::grid(panels).columns(2).key(Key::Hidden).draw(sheet)?.into())
    }

    fn axes(p: &Distribution, y: Axis) -> Panel {
        let (from, to, ..) = p.ends();
        Panel::new(Axis::linear("*x*").range(from, to), y).ratio(0.8)
    }

    fn height(curve: &[(f64, f64)]) -> f64 {
        curve.iter().map(|point| point.1).fold(0.0, f64::max)
    }

    /// The density with the probability as an area.
    fn area(p: &Distribution, data: &Data, density: &[(f64, f64)]) -> Panel {
        let (_, _, a, b) = p.ends();
        let at = |x: f64| {
            let after = density.partition_point(|point| point.0 < x).clamp(1, density.len() - 1);
            let (left, right) = (density[after - 1], density[after]);
            (x, left.1 + (right.1 - left.1) * ((x - left.0) / (right.0 - left.0)).clamp(0.0, 1.0))
        };
        let within = density.iter().copied().filter(|point| (a..=b).contains(&point.0));
        let below: Curve = std::iter::once(at(a)).chain(within).chain(std::iter::once(at(b))).collect();
        let probability = fixed(data.heights.1 - data.heights.0, 4);
        let middle = f64::midpoint(a, b);
        axes(p, Axis::linear("density *p*(*x*)").range(0.0, 1.18 * height(density)))
            .title(format!("Area = {probability}"))
            .with(Area::new(below))
            .with(Line::new(density.to_vec()).style(Style::new(Role::Blue)))
            .with(Note::new((middle, 0.3 * at(middle).1), "Prob").corner(Corner::Centre))
            .with(Note::new((a, 0.0), "*a*").corner(Corner::AboveLeft))
            .with(Note::new((b, 0.0), "*b*").corner(Corner::AboveRight))
    }

    /// The distribution function with the probability as a difference of heights.
    fn difference(p: &Distribution, data: &Data, distribution: Curve) -> Panel {
        let (from, _, a, b) = p.ends();
        let (low, high) = data.heights;
        let guide = |x: f64, y: f64| {
            Line::new(vec![(from, y), (x, y), (x, 0.0)]).style(Style::MUTED.dash(Dash::Dashed)).width(1.0)
        };
        let difference = Line::new(vec![(from, low), (from, high)]).style(Style::ACCENT).width(5.0);
        axes(p, Axis::linear("distribution *P*(*x*)").range(0.0, 1.04))
            .title(format!("{} − {} = {}", fixed(high, 4), fixed(low, 4), fixed(high - low, 4)))
            .with(guide(a, low))
            .with(guide(b, high))
            .with(Line::new(distribution).style(Style::new(Role::Blue)))
            .with(difference)
            .with(Note::new((from, low), " *P*(*a*)").corner(Corner::BelowRight))
            .with(Note::new((from, high), " *P*(*b*)").corner(Corner::AboveRight))
    }

    /// The distribution function with arrows from ξ to x.
    fn arrows(p: &Distribution, data: &Data, distribution: Curve) -> Panel {
        let (from, to, ..) = p.ends();
        let shown = || data.arrows.iter().filter(|arrow| (from..=to).contains(&arrow.1));
        let arrow = |&(u, x): &(f64, f64)| Line::new(vec![(from, u), (x, u), (x, 0.0)]).style(Style::ACCENT).faint();
        let tips: Curve = shown().map(|&(_, x)| (x, 0.018)).collect();
        axes(p, Axis::linear("ξ = *P*(*x*)").range(0.0, 1.04))
            .title(format!("{} numbers ξ become samples *x*", p.arrows))
            .with_all(shown().map(arrow))
            .with(Line::new(distribution).style(Style::new(Role::Blue)))
            .with(Marks::new(tips).style(Style::ACCENT.marker(Marker::Down)).size(7.0))
    }

    /// The histogram of the samples with the density.
    fn histogram(p: &Distribution, data: &Data, density: Curve) -> Panel {
        let (from, to, ..) = p.ends();
        let bins = data.counts.len();
        let edges: Vec<f64> = (0..=bins).map(|bin| from + (to - from) * (bin as f64 / bins as f64)).collect();
        let width = (to - from) / bins as f64;
        let heights: Vec<f64> = data.counts.iter().map(|&count| count as f64 / p.n as f64 / width).collect();
        let top = heights.iter().copied().fold(height(&density), f64::max);
        axes(p, Axis::linear("density").range(0.0, 1.06 * top))
            .title(format!("{} samples", integer(p.n as i64)))
            .with(Bars::new(edges, heights))
            .with(Line::new(density).style(Style::new(Role::Blue)))
    }

    pub(super) fn alt(p: &Distribution, data: &Data) -> String {
        let (from, to, a, b) = p.ends();
        let law = p.density.as_ref().map_or_else(
            || p.law.map_or_else(String::new, |law| format!("of the {} law", law.name())),
            |density| format!("proportional to {}", density.text()),
        );
        let exact = data.heights.1 - data.heights.0;
        let mut text = format!("The density {law} from {from} to {to}, beside its distribution function.");
        match p.show {
            Show::Probability => {
                let _ = write!(
                    text,
                    " The probability of x between {a} and {b} is the shaded area {} below the density, and the difference of the heights {} and {}.",
                    fixed(exact, 4),
                    fixed(data.heights.1, 4),
                    fixed(data.heights.0, 4),
                );
            }
            Show::Inversion => {
                let _ = write!(
                    text,
                    " Arrows lead from {} numbers ξ across to the distribution function and down to x. The histogram of {} samples follows the density",
                    p.arrows,
                    integer(p.n as i64),
                );
                match data.chi_square {
                    Some((_, probability)) => {
                        let _ = write!(text, " (chi-square probability {}).", significant(probability, 2));
                    }
                    None => text.push('.'),
                }
            }
        }
        text
    }
}
