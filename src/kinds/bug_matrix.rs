//! The matrix of bugs and tests: which test catches which planted bug, with random numbers and with quasi-random ones.
//!
//! The programs and the tests are those of the folder `bugs`. Every program runs in 64 pixels for N = 16, 32, ..., 1024, right and
//! with its bug; a test's false alarm has a probability of 10^-6 at most. In the table MC and QMC say with which numbers a test catches
//! the bug, and a star marks the test that is named for it.

use serde::{Deserialize, Serialize};

use super::bugs::{BUGS, Battery, Form, Numbers, Test, battery, check_sampler, weight};
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::{About, Paper};
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::{choices, parameters};
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `bug-matrix`.
pub static BUG_MATRIX: BugMatrixKind = BugMatrixKind;

/// The kind of experiment that sets bugs against tests.
pub struct BugMatrixKind;

static ABOUT: About = About {
    key: "bug-matrix",
    title: "Bugs and tests",
    summary: "Small programs with planted bugs, run on random and on quasi-random numbers: which test catches which bug.",
    file: "kinds/bug_matrix.rs",
    source: include_str!("bug_matrix.rs"),
    papers: &[Paper {
        authors: "A. B. Owen",
        year: 2022,
        title: "On Dropping the First Sobol' Point",
        venue: "Monte Carlo and Quasi-Monte Carlo Methods 2020, Springer, 71-86",
        doi: Some("10.1007/978-3-030-98319-2_4"),
    }],
};

choices! {
    /// What is drawn.
    pub enum Show {
        /// A table whose cells say with which numbers a test catches a bug.
        Table = "table",
        /// A figure with a mark for each.
        Figure = "figure",
    }
}

parameters! {
    /// What a matrix of bugs can choose.
    pub struct BugMatrix {
        /// The quasi-random numbers: a sequence that is randomised. The test of the rate expects that of nets with Owen's scrambling.
        sampler: Method = "sobol+owen",
        /// Whether a table or a figure is drawn.
        @drawn show: Show = "table",
    }
}

/// What was found out, in the order of the bugs.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    batteries: Vec<Battery>,
}

impl Kind for BugMatrixKind {
    type Parameters = BugMatrix;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &BugMatrix, problems: &mut Problems<'_, '_>) {
        check_sampler(&p.sampler, problems);
    }

    fn uses(&self, _: &BugMatrix) -> Vec<&'static About> {
        Method::parse("independent").map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, _: &BugMatrix) -> u64 {
        weight() * BUGS.len() as u64
    }

    fn run(&self, p: &BugMatrix, seed: Seed) -> Result<Data, Failure> {
        let batteries =
            BUGS.iter().map(|bug| battery(bug, &p.sampler, seed.named("bugs"))).collect::<Result<_, _>>()?;
        Ok(Data { batteries })
    }

    fn values(&self, _: &BugMatrix, data: &Data) -> Values {
        let mut values = Values::new();
        for (bug, battery) in BUGS.iter().zip(&data.batteries) {
            let name = bug.key;
            values.boolean(format!("caught.{name}"), battery.caught(bug));
            values.text(format!("test.{name}"), bug.caught_by.0.key());
            for test in Test::ALL {
                for (numbers, word) in [(Numbers::Random, "random"), (Numbers::Quasi, "qmc")] {
                    let caught = battery.catches(test, Form::Planted, numbers);
                    values.boolean(format!("caught.{name}.{}.{word}", test.key()), caught);
                }
            }
            values.boolean(format!("correct.{name}.passes"), battery.right_passes());
        }
        let pairs = || BUGS.iter().zip(&data.batteries);
        values.integer("bugs", BUGS.len() as i64);
        values.integer("caught", pairs().filter(|(bug, battery)| battery.caught(bug)).count() as i64);
        values.boolean("correct.passes", data.batteries.iter().all(Battery::right_passes));
        values
    }

    fn tables(&self, _: &BugMatrix, data: &Data) -> Vec<Frame> {
        let rows = || {
            BUGS.iter()
                .zip(&data.batteries)
                .flat_map(|(bug, battery)| battery.findings.iter().map(move |one| (bug, one)))
        };
        let frame = Frame::new("findings")
            .text("bug", rows().map(|(bug, _)| bug.key.to_owned()))
            .text("program", rows().map(|(_, one)| format!("{:?}", one.form).to_lowercase()))
            .text("numbers", rows().map(|(_, one)| format!("{:?}", one.numbers).to_lowercase()))
            .text("test", rows().map(|(_, one)| one.test.key().to_owned()))
            .counts("caught", rows().map(|(_, one)| usize::from(one.caught)));
        vec![frame]
    }

    fn draw(&self, p: &BugMatrix, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &BugMatrix, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

mod drawing {
    //! The matrix, and its words.

    use super::super::bugs::{BUGS, Battery, Form, Numbers, Test};
    use super::{BugMatrix, Data, Show};
    use crate::chart::{
        Axis, Cell, Chart, ChartError, Column, Drawing, Key, Marks, Panel, Region, Rich, Sheet, Style, Table,
    };

    /// The head of a test's column.
    fn head(test: Test) -> &'static str {
        match test {
            Test::Z => "$z$",
            Test::ChiSquare => "$\\chi^2$",
            Test::Kolmogorov => "KS",
            Test::Correlation => "pairs",
            Test::Rate => "rate",
            Test::Comparison => "means",
            Test::Strata => "strata",
            Test::Repeats => "twice",
            Test::Range => "range",
        }
    }

    /// With which numbers a test catches the program.
    fn verdict(battery: &Battery, test: Test, form: Form) -> &'static str {
        match (battery.catches(test, form, Numbers::Random), battery.catches(test, form, Numbers::Quasi)) {
            (true, true) => "both",
            (true, false) => "MC",
            (false, true) => "QMC",
            (false, false) => "–",
        }
    }

    pub(super) fn draw(p: &BugMatrix, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        match p.show {
            Show::Table => Ok(Drawing::Table(table(data))),
            Show::Figure => Ok(Chart::new(grid(p, data)).key(Key::Above).draw(sheet)?.into()),
        }
    }

    /// A row for each bug and a column for each test: a mark on the left for random numbers, on the right for quasi-random ones, and a
    /// frame about the test that is named for the bug.
    fn grid(p: &BugMatrix, data: &Data) -> Panel {
        let row = |index: usize| (BUGS.len() - index) as f64;
        let heads = ["*z*", "*χ*^{2}", "KS", "pairs", "rate", "means", "strata", "twice", "range"];
        let columns = heads.iter().enumerate().map(|(column, head)| (column as f64, Rich::new(head))).collect();
        let mut names: Vec<(f64, Rich)> =
            BUGS.iter().enumerate().map(|(index, bug)| (row(index), Rich::plain(bug.title))).collect();
        names.push((0.0, Rich::plain("right programs")));
        let marks = |numbers: Numbers, shift: f64| {
            let mut marks = Vec::new();
            for (column, test) in Test::ALL.into_iter().enumerate() {
                let x = column as f64 + shift;
                let caught = data.batteries.iter().enumerate();
                let caught = caught.filter(|(_, battery)| battery.catches(test, Form::Planted, numbers));
                marks.extend(caught.map(|(index, _)| (x, row(index))));
                if data.batteries.iter().any(|battery| battery.catches(test, Form::Right, numbers)) {
                    marks.push((x, 0.0));
                }
            }
            Marks::new(marks).size(8.0)
        };
        let frames = BUGS.iter().enumerate().filter_map(|(index, bug)| {
            let column = Test::ALL.iter().position(|test| *test == bug.caught_by.0)? as f64;
            let (x, y) = ((column - 0.42, row(index) - 0.4), (column + 0.42, row(index) + 0.4));
            Some(Region::new(x, y).style(Style::MUTED))
        });
        let x = Axis::linear("").range(-0.6, Test::ALL.len() as f64 - 0.4).ticks_at(columns);
        let y = Axis::linear("").range(-0.6, BUGS.len() as f64 + 0.6).ticks_at(names);
        Panel::new(x, y)
            .ratio(0.95)
            .with_all(frames)
            .with(marks(Numbers::Random, -0.18).style(Style::of("independent")).label("with random numbers"))
            .with(
                marks(Numbers::Quasi, 0.18)
                    .style(Style::of("sobol"))
                    .label(Rich::plain(&format!("with {}", p.sampler.title()))),
            )
    }

    fn table(data: &Data) -> Table {
        let mut columns = vec![Column::left("Planted bug")];
        columns.extend(Test::ALL.map(|test| Column::centre(head(test))));
        let mut table = Table::new(columns);
        for (bug, battery) in BUGS.iter().zip(&data.batteries) {
            let mut cells = vec![Cell::text(bug.title)];
            cells.extend(Test::ALL.map(|test| {
                // The test that is named for the bug has a star.
                let named = if test == bug.caught_by.0 { "*" } else { "" };
                Cell::text(format!("{}{named}", verdict(battery, test, Form::Planted)))
            }));
            table.push(cells);
        }
        let mut cells = vec![Cell::text("right programs")];
        cells.extend(Test::ALL.map(|test| {
            let failing = data.batteries.iter().filter(|battery| verdict(battery, test, Form::Right) != "–").count();
            Cell::text(if failing == 0 { "–".to_owned() } else { format!("{failing} fail") })
        }));
        table.push(cells);
        table.footers = 1;
        table
    }

    pub(super) fn alt(p: &BugMatrix, data: &Data) -> String {
        let told = BUGS.iter().zip(&data.batteries).map(|(bug, battery)| {
            let by: Vec<&str> = Test::ALL
                .into_iter()
                .filter(|&test| verdict(battery, test, Form::Planted) != "–")
                .map(Test::key)
                .collect();
            let by = if by.is_empty() { "no test".to_owned() } else { by.join(", ") };
            format!("{}: {by}", bug.title)
        });
        let passes = data.batteries.iter().all(Battery::right_passes);
        format!(
            "A matrix of {} planted bugs and {} tests, with random numbers and with {}. Caught by: {}. The right programs {}.",
            BUGS.len(),
            Test::ALL.len(),
            p.sampler.title(),
            told.collect::<Vec<_>>().join("; "),
            if passes { "pass every test" } else { "do not all pass" },
        )
    }
}
