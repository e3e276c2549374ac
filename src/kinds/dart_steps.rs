//! Dart throwing, dart by dart: a dart is rejected where another is nearer than the radius, on the torus.
//!
//! The darts are those of the sampler for the same stream; `agrees` compares what is accepted with what it gives.

use serde::{Deserialize, Serialize};

use super::steps::{self, Place};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::samplers::dart_throwing::throw;
use crate::samplers::poisson::{squared_distance, uniform};
use crate::seed::Seed;

/// The kind `dart-steps`.
pub static DART_STEPS: DartStepsKind = DartStepsKind;

/// The kind of experiment `dart-steps`.
pub struct DartStepsKind;

static ABOUT: About = About {
    key: "dart-steps",
    title: "Dart throwing, dart by dart",
    summary: "Darts thrown at the unit torus: those accepted with the disks that they keep free, those rejected, and how many are accepted over the tries.",
    file: "kinds/dart_steps.rs",
    source: include_str!("dart_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through dart throwing can choose.
    pub struct DartSteps {
        /// How many darts are thrown, one step each.
        tries: usize [in 2..=96] = 16,
        /// The least distance of two accepted darts.
        radius: f64 [in 0.02..=0.7] = 0.2,
    }
}

/// The darts.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    darts: Vec<Dart>,
    /// Whether the accepted darts are those of the sampler.
    agrees: bool,
}

/// One dart.
#[derive(Debug, Serialize, Deserialize)]
struct Dart {
    at: Place,
    /// The nearest dart accepted before, where it is nearer than the radius, and the distance to it.
    blocked: Option<(Place, f64)>,
    /// How many are accepted so far.
    accepted: u32,
}

impl Kind for DartStepsKind {
    type Parameters = DartSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &DartSteps, _: &mut Problems<'_, '_>) {}

    fn uses(&self, _: &DartSteps) -> Vec<&'static About> {
        Method::parse("dart-throwing").map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, p: &DartSteps) -> u64 {
        (p.tries * p.tries) as u64
    }

    fn run(&self, p: &DartSteps, seed: Seed) -> Result<Data, Failure> {
        let stream = seed.named(ABOUT.key);
        let mut random = stream.generator();
        let (mut accepted, mut darts): (Vec<[f64; 2]>, Vec<Dart>) = (Vec::new(), Vec::new());
        for _ in 0..p.tries {
            let dart = uniform(&mut random);
            let near = accepted.iter().map(|&other| (squared_distance(dart, other), other));
            let nearest = near.min_by(|a, b| a.0.total_cmp(&b.0));
            let blocked = nearest.filter(|(squared, _)| *squared < p.radius * p.radius);
            if blocked.is_none() {
                accepted.push(dart);
            }
            let blocked = blocked.map(|(squared, [x, y])| ((x, y), squared.sqrt()));
            darts.push(Dart { at: (dart[0], dart[1]), blocked, accepted: accepted.len() as u32 });
        }
        let agrees = throw(accepted.len(), p.radius, &mut stream.generator()) == Some(accepted);
        Ok(Data { darts, agrees })
    }

    fn values(&self, p: &DartSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("tries", p.tries as i64);
        values.integer("accepted", i64::from(data.accepted()));
        values.number("acceptance", f64::from(data.accepted()) / p.tries as f64);
        values.boolean("agrees", data.agrees);
        values
    }

    fn tables(&self, _: &DartSteps, data: &Data) -> Vec<Frame> {
        let darts = || data.darts.iter();
        let frame = Frame::new("darts")
            .numbers("x", darts().map(|dart| dart.at.0))
            .numbers("y", darts().map(|dart| dart.at.1))
            .text("verdict", darts().map(|dart| dart.verdict().to_owned()))
            .numbers("distance of the nearest", darts().map(|dart| dart.blocked.map_or(f64::NAN, |near| near.1)))
            .counts("accepted so far", darts().map(|dart| dart.accepted as usize));
        vec![frame]
    }

    fn draw(&self, p: &DartSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &DartSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Data {
    /// How many darts are accepted.
    fn accepted(&self) -> u32 {
        self.darts.last().map_or(0, |dart| dart.accepted)
    }
}

impl Dart {
    fn verdict(&self) -> &'static str {
        if self.blocked.is_some() { "rejected" } else { "accepted" }
    }
}

mod drawing {
    //! The darts with their disks, and their words.

    use super::{Dart, DartSteps, Data, steps};
    use crate::chart::number::fixed;
    use crate::chart::{
        Axis, Chart, ChartError, Corner, Dash, Disks, Drawing, Key, Line, Marker, Marks, Note, Panel, Role, Segments,
        Sheet, Steps, Style,
    };

    pub(super) fn draw(p: &DartSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new().small(290.0).key_steps([p.tries / 3 + 1, 2 * p.tries / 3 + 1]);
        for (index, dart) in data.darts.iter().enumerate() {
            let darts = &data.darts[..=index];
            let panels = vec![square(p, darts), tally(p, data, darts)];
            steps.push(Chart::grid(panels).key(Key::Hidden), caption(index + 1, dart));
        }
        Ok(steps.draw(sheet)?.into())
    }

    fn square(p: &DartSteps, darts: &[Dart]) -> Panel {
        let mut panel = Panel::unit_square();
        let style = Style::of("dart-throwing").marker(Marker::Disc).dash(Dash::Solid);
        for dart in darts.iter().filter(|dart| dart.blocked.is_none()) {
            panel = panel.with(Disks::new(steps::copies(dart.at, p.radius), p.radius).style(style));
        }
        for dart in darts.iter().filter(|dart| dart.blocked.is_none()) {
            panel = panel.with(Marks::new(vec![dart.at]).style(style).size(7.0));
        }
        for dart in darts.iter().filter(|dart| dart.blocked.is_some()) {
            panel =
                panel.with(Marks::new(vec![dart.at]).style(Style::new(Role::Muted).marker(Marker::Cross)).size(7.0));
        }
        if let Some(dart) = darts.last() {
            let way = dart.blocked.map_or_else(Vec::new, |(near, _)| steps::shortest(dart.at, near));
            panel = panel.with(Segments::new(way).style(Style::ACCENT)).with(Segments::spots([dart.at]).tracked("new"));
        }
        panel.title("darts")
    }

    /// How many are accepted over the tries.
    fn tally(p: &DartSteps, data: &Data, darts: &[Dart]) -> Panel {
        let most = f64::from(data.accepted()).max(1.0);
        let count = |index: usize, dart: &Dart| (index as f64 + 1.0, f64::from(dart.accepted));
        let points = darts.iter().enumerate().map(|(index, dart)| {
            let role = if dart.blocked.is_some() { Role::Muted } else { Role::Ink };
            Marks::new(vec![count(index, dart)]).style(Style::new(role)).size(5.0)
        });
        let all = Line::new(vec![(0.0, 0.0), (most, most)]).style(Style::THEORY).width(1.0);
        let x = Axis::linear("tries").range(0.0, p.tries as f64 + 1.0);
        let y = Axis::linear("").range(0.0, most * 1.06);
        let all = Panel::new(x, y).title("accepted").ratio(1.0).with(all);
        all.with(Note::new((most, most), "all").corner(Corner::BelowRight).role(Role::Axis)).with_all(points)
    }

    fn caption(number: usize, dart: &Dart) -> String {
        let so_far = format!("{} of {number} accepted", dart.accepted);
        match dart.blocked {
            Some((_, distance)) => {
                format!("Dart {number}: rejected, only {} from the nearest. {so_far}.", fixed(distance, 3))
            }
            None => format!("Dart {number}: accepted. {so_far}."),
        }
    }

    pub(super) fn alt(p: &DartSteps, data: &Data) -> String {
        format!(
            "{} steps, a dart each: left the unit square with the accepted darts, each within a disk of radius {} that keeps \
             others away, and the rejected ones as crosses; right the number of accepted darts over the tries, which \
             flattens. {} of {} darts are accepted.",
            p.tries,
            p.radius,
            data.accepted(),
            p.tries
        )
    }
}
