//! One bug of the gallery: the error over N of the right program and of the one with the bug, with random and with quasi-random
//! numbers, and the tests that catch it.

use serde::{Deserialize, Serialize};

use super::bugs::{BUGS, Battery, Bug as Program, Form, Numbers, Test, battery, check_sampler, find, rate_of, weight};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, nearest};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `bug`.
pub static BUG: BugKind = BugKind;

/// The kind of experiment that shows what a bug does.
pub struct BugKind;

static ABOUT: About = About {
    key: "bug",
    title: "A planted bug",
    summary: "The error over N of a right program and of the same with a bug, with random and with quasi-random numbers.",
    file: "kinds/bug.rs",
    source: include_str!("bug.rs"),
    papers: &[],
};

parameters! {
    /// What the drawing of a bug can choose.
    pub struct Bug {
        /// The bug, by the name that the values of the matrix of bugs use: `missing-density`, `rejection`, ...
        bug: String,
        /// The quasi-random numbers, as in the matrix of bugs.
        sampler: Method = "sobol+owen",
    }
}

/// What was found out.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    battery: Battery,
}

impl Kind for BugKind {
    type Parameters = Bug;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Bug, problems: &mut Problems<'_, '_>) {
        check_sampler(&p.sampler, problems);
        if find(&p.bug).is_none() {
            let keys: Vec<&str> = BUGS.iter().map(|bug| bug.key).collect();
            let help = nearest(&p.bug, keys.iter().copied()).map(|key| format!("did you mean `{key}`?"));
            let help = help.unwrap_or_else(|| format!("the bugs are {}", keys.join(", ")));
            problems.at("bug", Code::UnknownName, format!("there is no bug `{}`", p.bug), Some(help));
        }
    }

    fn uses(&self, _: &Bug) -> Vec<&'static About> {
        Method::parse("independent").map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, _: &Bug) -> u64 {
        weight()
    }

    fn run(&self, p: &Bug, seed: Seed) -> Result<Data, Failure> {
        // The same stream as that of the matrix: with one seed both show the same numbers.
        Ok(Data { battery: battery(program(p)?, &p.sampler, seed.named("bugs"))? })
    }

    fn values(&self, p: &Bug, data: &Data) -> Values {
        let mut values = Values::new();
        let battery = &data.battery;
        let Ok(bug) = program(p) else { return values };
        values.number("exact", bug.exact);
        values.boolean("caught", battery.caught(bug));
        values.boolean("correct.passes", battery.right_passes());
        for (form, numbers, marks) in &battery.errors {
            let name = name(*form, *numbers);
            for mark in marks {
                let (n, error) = (mark.n, mark.error.unwrap_or(f64::NAN));
                values.estimate(format!("rmse.{name}.{n}"), mark.rmse, error);
            }
            if let Some(rate) = rate_of(marks) {
                values.estimate(format!("slope.{name}"), rate.slope, rate.error.unwrap_or(f64::NAN));
            }
        }
        for (form, numbers, mean, error) in &battery.means {
            values.estimate(format!("mean.{}", name(*form, *numbers)), *mean, *error);
        }
        for test in Test::ALL {
            let caught = |numbers| battery.catches(test, Form::Planted, numbers);
            values.boolean(format!("caught.{}.random", test.key()), caught(Numbers::Random));
            values.boolean(format!("caught.{}.qmc", test.key()), caught(Numbers::Quasi));
        }
        values
    }

    fn tables(&self, _: &Bug, data: &Data) -> Vec<Frame> {
        let rows = || {
            let errors = data.battery.errors.iter();
            errors.flat_map(|(form, numbers, marks)| marks.iter().map(move |mark| (name(*form, *numbers), mark)))
        };
        let errors = Frame::new("errors")
            .text("program", rows().map(|(name, _)| name))
            .counts("n", rows().map(|(_, mark)| mark.n as usize))
            .numbers("rmse", rows().map(|(_, mark)| mark.rmse))
            .numbers("rmse standard error", rows().map(|(_, mark)| mark.error.unwrap_or(f64::NAN)));
        vec![errors]
    }

    fn draw(&self, p: &Bug, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &Bug, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The program that was asked for.
fn program(p: &Bug) -> Result<&'static Program, Failure> {
    let missing =
        || Failure::of("bug", format!("there is no bug `{}`", p.bug)).help("`workbook list kinds` tells more");
    find(&p.bug).ok_or_else(missing)
}

/// A form and its numbers as part of a value's name: `right.random`, `planted.qmc`.
fn name(form: Form, numbers: Numbers) -> String {
    let form = if form == Form::Right { "right" } else { "planted" };
    let numbers = if numbers == Numbers::Random { "random" } else { "qmc" };
    format!("{form}.{numbers}")
}

mod drawing {
    //! The drawing of the errors of both forms, and its words.

    use std::fmt::Write as _;

    use super::super::bugs::{Form, Mark, Numbers, Test, rate_of};
    use super::{Bug, Data, program};
    use crate::chart::number::{fixed, significant};
    use crate::chart::{Axis, Chart, ChartError, Dash, Drawing, Key, Line, Marker, Panel, Rich, Role, Sheet, Style};

    const RIGHT: Style = Style { role: Role::Blue, dash: Dash::Solid, marker: Marker::Disc };
    const PLANTED: Style = Style { role: Role::Accent, dash: Dash::Long, marker: Marker::Diamond };

    pub(super) fn draw(p: &Bug, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let of = |numbers: Numbers, title: &str| {
            let axes = Panel::new(Axis::log2("*N*"), Axis::log("RMSE")).ratio(0.85).title(Rich::plain(title));
            let lines = data.battery.errors.iter().filter(|errors| errors.1 == numbers);
            axes.with_all(lines.map(|(form, _, marks)| line(*form, marks)))
        };
        let quasi = p.sampler.title();
        let panels = vec![of(Numbers::Random, "Random numbers"), of(Numbers::Quasi, &quasi)];
        Ok(Chart::grid(panels).columns(2).shared().key(Key::Above).draw(sheet)?.into())
    }

    fn line(form: Form, marks: &[Mark]) -> Line {
        let points = marks.iter().map(|mark| (mark.n as f64, mark.rmse)).collect();
        let (style, label) = if form == Form::Right { (RIGHT, "right") } else { (PLANTED, "with the bug") };
        Line::new(points).style(style).marked().label(label)
    }

    pub(super) fn alt(p: &Bug, data: &Data) -> String {
        let title = program(p).map_or(p.bug.as_str(), |bug| bug.title);
        let mut text = format!(
            "The error over N from 16 to 1024, on logarithmic axes, of a right program and of one with the bug \"{title}\"."
        );
        for (form, numbers, marks) in &data.battery.errors {
            let numbers = if *numbers == Numbers::Random { "random numbers".to_owned() } else { p.sampler.title() };
            let form = if *form == Form::Right { "Right" } else { "With the bug" };
            let last = marks.last().map_or(f64::NAN, |mark| mark.rmse);
            let _ = write!(text, " {form}, {numbers}: {} at N = 1024", significant(last, 2));
            if let Some(rate) = rate_of(marks) {
                let _ = write!(text, ", slope {}", fixed(rate.slope, 2));
            }
            text.push('.');
        }
        let catches = |test: &Test| {
            [Numbers::Random, Numbers::Quasi]
                .into_iter()
                .any(|numbers| data.battery.catches(*test, Form::Planted, numbers))
        };
        let by: Vec<&str> = Test::ALL.iter().filter(|test| catches(test)).map(|test| test.key()).collect();
        let by = if by.is_empty() { "no test".to_owned() } else { by.join(", ") };
        let _ = write!(text, " It is caught by {by}.");
        text
    }
}
