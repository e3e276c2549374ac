//! Best candidate, point by point: of k random candidates for the k-th point the farthest from all before, on the torus.
//!
//! The candidates are those of the sampler for the same stream; `agrees` compares the winners with what it gives.

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::samplers::poisson::{squared_distance, uniform};
use crate::seed::Seed;

/// The kind `candidate-steps`.
pub static CANDIDATE_STEPS: CandidateStepsKind = CandidateStepsKind;

/// The kind of experiment `candidate-steps`.
pub struct CandidateStepsKind;

static ABOUT: About = About {
    key: "candidate-steps",
    title: "Best candidate, point by point",
    summary: "Each point as the farthest of several random candidates: the candidates, their distances on the torus, and the winner.",
    file: "kinds/candidate_steps.rs",
    source: include_str!("candidate_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through best candidates can choose.
    pub struct CandidateSteps {
        /// How many points, one step each.
        n: usize [in 2..=40] = 10,
    }
}

/// The points with their candidates.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    choices: Vec<Choice>,
    /// Whether the winners are the points of the sampler.
    agrees: bool,
}

/// The candidates for one point.
#[derive(Debug, Serialize, Deserialize)]
struct Choice {
    /// Each candidate with the nearest point before and the distance to it; none for the first point.
    candidates: Vec<(Place, Option<(Place, f64)>)>,
    winner: u32,
}

impl Kind for CandidateStepsKind {
    type Parameters = CandidateSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &CandidateSteps, _: &mut Problems<'_, '_>) {}

    fn uses(&self, _: &CandidateSteps) -> Vec<&'static About> {
        Method::parse("best-candidate").map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, p: &CandidateSteps) -> u64 {
        (p.n * p.n * p.n) as u64
    }

    fn run(&self, p: &CandidateSteps, seed: Seed) -> Result<Data, Failure> {
        let stream = seed.named(ABOUT.key);
        // What a method gives for a seed, its sampler makes from the stream of its own name.
        let mut random = stream.named("best-candidate").generator();
        let (mut points, mut choices): (Vec<[f64; 2]>, Vec<Choice>) = (Vec::new(), Vec::new());
        for count in 1..=p.n {
            let (mut candidates, mut winner, mut farthest) = (Vec::new(), 0, f64::NEG_INFINITY);
            let mut best = [0.0; 2];
            for index in 0..count {
                let candidate = uniform(&mut random);
                let near = points.iter().map(|&other| (squared_distance(candidate, other), other));
                let nearest = near.min_by(|a, b| a.0.total_cmp(&b.0));
                let own = nearest.map_or(f64::INFINITY, |(squared, _)| squared);
                if own > farthest {
                    (winner, farthest, best) = (index as u32, own, candidate);
                }
                let nearest = nearest.map(|(squared, [x, y])| ((x, y), squared.sqrt()));
                candidates.push(((candidate[0], candidate[1]), nearest));
            }
            points.push(best);
            choices.push(Choice { candidates, winner });
        }
        let drawn = Method::parse("best-candidate").ok().and_then(|method| method.points(p.n, 2, stream).ok());
        let agrees = drawn.is_some_and(|drawn| drawn.coordinates() == points.as_flattened());
        Ok(Data { choices, agrees })
    }

    fn values(&self, p: &CandidateSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("steps", p.n as i64);
        values.integer("candidates", data.choices.iter().map(|choice| choice.candidates.len() as i64).sum());
        let distances = data.choices.iter().filter_map(|choice| Some(choice.won()?.1?.1));
        values.number("distance", distances.fold(f64::INFINITY, f64::min));
        values.boolean("agrees", data.agrees);
        values
    }

    fn tables(&self, _: &CandidateSteps, data: &Data) -> Vec<Frame> {
        let rows = || {
            let numbered = data.choices.iter().enumerate();
            numbered
                .flat_map(|(index, choice)| choice.candidates.iter().map(move |candidate| (index, choice, candidate)))
        };
        let frame = Frame::new("candidates")
            .counts("point", rows().map(|(index, ..)| index))
            .numbers("x", rows().map(|(.., candidate)| candidate.0.0))
            .numbers("y", rows().map(|(.., candidate)| candidate.0.1))
            .numbers("distance", rows().map(|(.., candidate)| candidate.1.map_or(f64::NAN, |near| near.1)));
        let frame = frame.text(
            "verdict",
            rows().map(|(_, choice, candidate)| {
                let won = choice.won().is_some_and(|winner| winner.0 == candidate.0);
                if won { "taken".to_owned() } else { "dropped".to_owned() }
            }),
        );
        vec![frame]
    }

    fn draw(&self, p: &CandidateSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &CandidateSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Choice {
    /// The winner, with the nearest point before.
    fn won(&self) -> Option<(Place, Option<(Place, f64)>)> {
        self.candidates.get(self.winner as usize).copied()
    }
}

mod drawing {
    //! The candidates, and their words.

    use super::{CandidateSteps, Choice, Data, steps};
    use crate::chart::number::{fixed, significant};
    use crate::chart::{
        Chart, ChartError, Disks, Drawing, Key, Marker, Marks, Panel, Role, Segments, Sheet, Steps, Style,
    };

    pub(super) fn draw(_: &CandidateSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new();
        for (index, choice) in data.choices.iter().enumerate() {
            steps.push(Chart::new(panel(&data.choices[..=index])).key(Key::Hidden), caption(index + 1, choice));
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn panel(choices: &[Choice]) -> Panel {
        let mut panel = Panel::unit_square();
        let Some((choice, before)) = choices.split_last() else { return panel };
        if let Some((at, Some((_, distance)))) = choice.won() {
            panel = panel.with(Disks::new(steps::copies(at, distance), distance).style(Style::ACCENT));
        }
        let ways = choice.candidates.iter().filter_map(|(at, near)| Some((*at, near.as_ref()?.0)));
        let ways = ways.flat_map(|(at, near)| steps::shortest(at, near)).collect();
        panel = panel.with(Segments::new(ways).style(Style::new(Role::Muted)).width(0.9));
        let style = Style::of("best-candidate").marker(Marker::Disc);
        for (at, _) in before.iter().filter_map(Choice::won) {
            panel = panel.with(Marks::new(vec![at]).style(style).size(8.0));
        }
        let others = choice.candidates.iter().enumerate().filter(|(index, _)| *index != choice.winner as usize);
        let others = others.map(|(_, candidate)| candidate.0).collect();
        panel = panel.with(Marks::new(others).style(Style::new(Role::Muted)).size(5.0));
        panel.with(Marks::new(choice.won().map(|won| won.0).into_iter().collect()).style(Style::ACCENT).size(9.0))
    }

    fn caption(number: usize, choice: &Choice) -> String {
        match choice.won().and_then(|won| won.1) {
            Some((_, distance)) => format!(
                "Point {number}: of {} candidates the one is taken that is farthest from all points, {} from the nearest.",
                choice.candidates.len(),
                fixed(distance, 3)
            ),
            None => "Point 1: a single candidate, taken as it comes.".to_owned(),
        }
    }

    pub(super) fn alt(p: &CandidateSteps, data: &Data) -> String {
        let last = data.choices.last().and_then(Choice::won).and_then(|won| won.1).map_or(f64::NAN, |near| near.1);
        format!(
            "{} steps, a point each, in the unit square: for the k-th point k random candidates, each with the shortest way \
             on the torus to the nearest point before; the farthest is taken, and a disk shows its distance. That of the \
             last is {}.",
            p.n,
            significant(last, 3)
        )
    }
}
