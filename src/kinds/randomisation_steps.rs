//! Randomisation by randomisation: the points of a scrambled sampler for one seed after the other, with the elementary
//! intervals in base 2 that no longer hold exactly one point.
//!
//! The first step is the sampler without its scramble. Of each later step that shape of interval is shown which has the most
//! violations.

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::samplers::digits::logarithm;
use crate::seed::Seed;

/// The kind `randomisation-steps`.
pub static RANDOMISATION_STEPS: RandomisationStepsKind = RandomisationStepsKind;

/// The kind of experiment `randomisation-steps`.
pub struct RandomisationStepsKind;

static ABOUT: About = About {
    key: "randomisation-steps",
    title: "Randomisation by randomisation",
    summary: "A sampler with a random scramble, seed by seed: how its points move, and which elementary intervals lose or gain points.",
    file: "kinds/randomisation_steps.rs",
    source: include_str!("randomisation_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through randomisations can choose.
    pub struct RandomisationSteps {
        /// The samplers, each with its scramble, one panel each.
        samplers: Vec<Method> [or sampler] = "sobol+cranley-patterson",
        /// How many points: a power of 2.
        n: usize [in 2..=64] = 16,
        /// How many randomisations.
        randomisations: usize [in 1..=40] = 8,
    }
}

/// The sets.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    methods: Vec<(String, String)>,
    /// Of each step the set of each method.
    steps: Vec<Vec<Set>>,
    /// How many elementary intervals there are of volume 1/n.
    intervals: u32,
}

/// The points of one method in one step.
#[derive(Debug, Serialize, Deserialize)]
struct Set {
    places: Vec<Place>,
    /// How many elementary intervals do not hold one point.
    violations: u32,
    /// The shape with the most of them, and those: column, row, points.
    shape: (u32, u32),
    violated: Vec<(u32, u32, u32)>,
}

impl Kind for RandomisationStepsKind {
    type Parameters = RandomisationSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &RandomisationSteps, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, &[p.n], 2);
        if !p.n.is_power_of_two() {
            let message = format!("{} is no power of 2", p.n);
            problems.at("n", Code::Count, message, Some("take 4, 16 or 64".to_owned()));
        }
        for (index, method) in p.samplers.iter().enumerate().filter(|(_, method)| method.scramble().is_none()) {
            let message = format!("`{}` has no scramble to step through", method.name());
            let help = format!("add one, as in `{}+owen`", method.name());
            problems.element("samplers", index, Code::OutOfRange, message, Some(help));
        }
        steps::check_panels(p.samplers.len(), "samplers", problems);
    }

    fn weight(&self, p: &RandomisationSteps) -> u64 {
        (p.n * p.samplers.len() * (p.randomisations + 1)) as u64
    }

    fn run(&self, p: &RandomisationSteps, seed: Seed) -> Result<Data, Failure> {
        let m = logarithm(p.n as u64, 2).unwrap_or(0);
        let shapes = steps::shapes(2, m);
        let step = |number: usize| -> Result<Vec<Set>, Failure> {
            let set = |method: &Method| {
                let stream = seed.named(ABOUT.key).named(&method.name()).at(number as u64);
                let points = match number {
                    0 => method.sampler().points(p.n, 2, stream),
                    _ => method.points(p.n, 2, stream),
                };
                let points = points.map_err(|refused| Failure::of("samplers", refused.to_string()))?;
                Ok(set(steps::places(&points), &shapes))
            };
            p.samplers.iter().map(set).collect()
        };
        let steps = (0..=p.randomisations).map(step).collect::<Result<_, Failure>>()?;
        let methods = p.samplers.iter().map(|method| (method.name(), method.title())).collect();
        Ok(Data { methods, steps, intervals: (shapes.len() * p.n) as u32 })
    }

    fn values(&self, _: &RandomisationSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("intervals", i64::from(data.intervals));
        for (index, (name, _)) in data.methods.iter().enumerate() {
            let counts: Vec<i64> = data.violations(index).collect();
            values.integer(format!("violations.unscrambled.{name}"), counts.first().copied().unwrap_or(0));
            values.integer(format!("violations.max.{name}"), counts.iter().skip(1).copied().max().unwrap_or(0));
            values.integer(format!("violations.min.{name}"), counts.iter().skip(1).copied().min().unwrap_or(0));
        }
        values
    }

    fn tables(&self, _: &RandomisationSteps, data: &Data) -> Vec<Frame> {
        let mut frame = Frame::new("violations").counts("randomisation", 0..data.steps.len());
        for (index, (name, _)) in data.methods.iter().enumerate() {
            frame = frame.counts(name, data.violations(index).map(|count| count as usize));
        }
        vec![frame]
    }

    fn draw(&self, p: &RandomisationSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &RandomisationSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Data {
    /// The violations of a method, step by step.
    fn violations(&self, method: usize) -> impl Iterator<Item = i64> + '_ {
        self.steps.iter().map(move |sets| sets.get(method).map_or(0, |set| i64::from(set.violations)))
    }
}

/// The set of these points, with its violations; of equal shapes the squarest.
fn set(places: Vec<Place>, shapes: &[(usize, usize)]) -> Set {
    let violated: Vec<_> = shapes.iter().map(|&shape| (shape, steps::not_one(&places, shape))).collect();
    let violations = violated.iter().map(|(_, odd)| odd.len() as u32).sum();
    let slender = |&(x, y): &(usize, usize)| x.max(y) / x.min(y).max(1);
    let worst = violated.into_iter().max_by_key(|(shape, odd)| (odd.len(), std::cmp::Reverse(slender(shape))));
    let ((columns, rows), violated) = worst.unwrap_or(((1, 1), Vec::new()));
    Set { places, violations, shape: (columns as u32, rows as u32), violated }
}

mod drawing {
    //! The randomisations, and their words.

    use super::{Data, Method, RandomisationSteps, Set};
    use crate::chart::{Chart, ChartError, Drawing, Key, Marker, Marks, Panel, Sheet, Steps, Strata, Style};
    use crate::kinds::steps;
    use std::fmt::Write as _;

    pub(super) fn draw(p: &RandomisationSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new().small(if data.methods.len() > 1 { 290.0 } else { 190.0 }).key_steps([1, 2]);
        for (number, sets) in data.steps.iter().enumerate() {
            let panels = sets.iter().zip(&p.samplers).map(|(set, method)| panel(data, set, method)).collect();
            let what = if number == 0 { "Not scrambled".to_owned() } else { format!("Randomisation {number}") };
            let counts: Vec<String> = sets.iter().map(|set| set.violations.to_string()).collect();
            let are = if counts == ["1"] { "is" } else { "are" };
            let (all, counts) = (data.intervals, counts.join(" and "));
            let caption = format!("{what}: of {all} elementary intervals {counts} {are} violated.");
            steps.push(Chart::grid(panels).key(Key::Hidden), caption);
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(data: &Data, set: &Set, method: &Method) -> Panel {
        // The scramble alone: with the sampler's the titles would touch in small drawings.
        let title = method.scramble().map_or("", |scramble| scramble.about().title);
        let slabs = Strata::slabs(set.places.len() as u32);
        let panel = Panel::unit_square().strata(Strata::boxes(set.shape.0, set.shape.1)).keeping(slabs);
        let panel = if data.methods.len() > 1 { panel.title(title) } else { panel };
        let panel = panel.with_all(steps::marked(&set.violated, set.shape));
        let style = Style::of(&method.name()).marker(Marker::Disc);
        panel.with(Marks::new(set.places.clone()).style(style).size(8.0).tracked("p"))
    }

    pub(super) fn alt(p: &RandomisationSteps, data: &Data) -> String {
        let mut text = format!(
            "{} steps: {} points in the unit square, first as they are, then under {} randomisations.",
            data.steps.len(),
            p.n,
            p.randomisations
        );
        for (index, (_, title)) in data.methods.iter().enumerate() {
            let counts: Vec<i64> = data.violations(index).collect();
            let (least, most) = (counts.iter().skip(1).min().unwrap_or(&0), counts.iter().skip(1).max().unwrap_or(&0));
            let all = data.intervals;
            let _ = match (least, most) {
                (0, 0) => write!(text, " {title}: none of the {all} elementary intervals is violated in any of them."),
                (a, b) if a == b => {
                    write!(text, " {title}: {a} of the {all} elementary intervals are violated in each.")
                }
                (a, b) => write!(text, " {title}: between {a} and {b} of the {all} elementary intervals are violated."),
            };
        }
        text
    }
}
