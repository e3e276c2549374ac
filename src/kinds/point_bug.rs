//! One mistake in placing points: what the wrong and the right program make, beside each other, and the test that tells them apart.

use serde::{Deserialize, Serialize};

use super::point_bugs::{Asked, BUGS, Bug, Count, Found, find};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, nearest};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::diag::Code;
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `point-bug`.
pub static POINT_BUG: PointBugKind = PointBugKind;

/// The kind of experiment that shows a mistake in placing points.
pub struct PointBugKind;

static ABOUT: About = About {
    key: "point-bug",
    title: "A mistake in placing points",
    summary: "What a program with a mistake places beside what the right one does, and the test that tells them apart.",
    file: "kinds/point_bug.rs",
    source: include_str!("point_bug.rs"),
    papers: &[],
};

parameters! {
    /// What the drawing of a mistake can choose.
    pub struct PointBug {
        /// The mistake, by its name: `integer-division`, `exclusive-shuffle`, ...
        bug: String,
        /// How many points, or samples, or items; each mistake has its own default and limits, and some have no such number.
        n: Option<usize> [in 1..=1_073_741_824],
        /// How often it is repeated with new random numbers, where it is.
        replicates: Option<usize> [in 1..=1_000_000],
    }
}

/// What was found out.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    found: Found,
}

impl Kind for PointBugKind {
    type Parameters = PointBug;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn settle(&self, p: &mut PointBug) {
        let Some(bug) = find(&p.bug) else { return };
        p.n = p.n.or(bug.n.map(|count| count.default));
        p.replicates = p.replicates.or(bug.replicates.map(|count| count.default));
    }

    fn check(&self, p: &PointBug, problems: &mut Problems<'_, '_>) {
        let Some(bug) = find(&p.bug) else {
            let keys: Vec<&str> = BUGS.iter().map(|bug| bug.key).collect();
            let help = nearest(&p.bug, keys.iter().copied()).map(|key| format!("did you mean `{key}`?"));
            let help = help.unwrap_or_else(|| format!("the mistakes are {}", keys.join(", ")));
            problems.at("bug", Code::UnknownName, format!("there is no mistake `{}`", p.bug), Some(help));
            return;
        };
        for (name, chosen, count) in [("n", p.n, bug.n), ("replicates", p.replicates, bug.replicates)] {
            if let Some((message, help)) = chosen.and_then(|chosen| refusal(bug, name, chosen, count)) {
                problems.at(name, Code::Count, message, Some(help));
            }
        }
    }

    fn uses(&self, p: &PointBug) -> Vec<&'static About> {
        let names = find(&p.bug).map_or(&[][..], |bug| bug.uses);
        names.iter().filter_map(|name| Method::parse(name).ok()).flat_map(|method| method.abouts()).collect()
    }

    fn weight(&self, p: &PointBug) -> u64 {
        find(&p.bug).map_or(0, |bug| (bug.weight)(&asked(p)))
    }

    fn run(&self, p: &PointBug, seed: Seed) -> Result<Data, Failure> {
        let missing =
            || Failure::of("bug", format!("there is no mistake `{}`", p.bug)).help("`workbook list kinds` tells more");
        Ok(Data { found: (find(&p.bug).ok_or_else(missing)?.run)(&asked(p), seed)? })
    }

    fn values(&self, _: &PointBug, data: &Data) -> Values {
        let mut values = Values::new();
        let Found { wrong, right, facts } = &data.found;
        for (name, side) in [("wrong", wrong), ("right", right)] {
            values.boolean(format!("{name}.passes"), side.passes);
            side.facts.tell(&format!("{name}."), &mut values);
        }
        values.boolean("caught", right.passes && !wrong.passes);
        facts.tell("", &mut values);
        values
    }

    fn tables(&self, _: &PointBug, data: &Data) -> Vec<Frame> {
        vec![data.found.wrong.frame("wrong"), data.found.right.frame("right")]
    }

    fn draw(&self, p: &PointBug, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &PointBug, data: &Data) -> Option<String> {
        drawing::alt(p, data)
    }
}

/// The numbers that were asked for.
fn asked(p: &PointBug) -> Asked {
    Asked { n: p.n.unwrap_or(1), replicates: p.replicates.unwrap_or(1) }
}

/// Why the parameter `name` cannot be `chosen`, and what to do; `None` if it can.
fn refusal(bug: &Bug, name: &str, chosen: usize, count: Option<Count>) -> Option<(String, String)> {
    let Some(count) = count else {
        return Some((format!("`{}` has no `{name}`", bug.key), format!("drop `{name}`")));
    };
    let message = format!("`{}` cannot have `{name} = {chosen}`", bug.key);
    (!count.admits(chosen)).then(|| (message, format!("choose {}", count.words())))
}

mod drawing {
    //! The drawing, which is the mistake's own, and its words.

    use super::{Data, PointBug, asked, find};
    use crate::chart::{Chart, ChartError, Drawing, Sheet};

    pub(super) fn draw(p: &PointBug, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match find(&p.bug) {
            Some(bug) => (bug.draw)(&asked(p), &data.found, sheet),
            None => Ok(Chart::default().draw(sheet)?.into()),
        }
    }

    pub(super) fn alt(p: &PointBug, data: &Data) -> Option<String> {
        let bug = find(&p.bug)?;
        let verdict = |passes: bool| if passes { "passes" } else { "fails" };
        let (wrong, right) = (verdict(data.found.wrong.passes), verdict(data.found.right.passes));
        let told = (bug.alt)(&asked(p), &data.found);
        Some(format!("Mistake: {}. {told} The wrong program {wrong} the test, the right one {right}.", bug.title))
    }
}
