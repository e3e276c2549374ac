//! `workbook measure`: a measure of the points in a file.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;
use serde_json::json;

use super::{Exit, Format, Options, report};
use crate::catalogue::{find, nearest};
use crate::diag::{Code, Diagnostic};
use crate::metrics::{METRICS, Measured, measure};
use crate::points::Points;
use crate::samplers::MOST_COORDINATES;
use crate::workspace::{self, Source, Workspace};

#[derive(Args)]
pub(super) struct Arguments {
    /// The measure, e.g. `star-discrepancy`; `workbook list metrics` names them all
    metric: String,
    /// The points: a point a line, coordinates from 0 to 1 with commas between them, no header; `-` is the standard input
    file: PathBuf,
    /// Write an object: the value, whether it is exact, the box where it is attained, the time
    #[arg(long)]
    json: bool,
}

/// Mistakes that are told before reading stops.
const MOST_TOLD: usize = 10;

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let Some(metric) = find(METRICS, &arguments.metric) else {
        let near = nearest(&arguments.metric, METRICS.iter().map(|metric| metric.about().key));
        let error = Diagnostic::error(Code::UnknownName, format!("unknown measure `{}`", arguments.metric))
            .help_if(near.map(|near| format!("did you mean `{near}`?")))
            .help("`workbook list metrics` shows all");
        return report::wrong(&error, Exit::Call, options);
    };
    let source = match workspace::read_points(&arguments.file) {
        Ok(source) => source,
        Err(error) => {
            let exit = match error.code {
                Code::Unreadable => Exit::System,
                Code::NotUtf8 => Exit::Course,
                _ => Exit::Call,
            };
            return report::wrong(&error, exit, options);
        }
    };
    let points = match read(&source) {
        Ok(points) => points,
        Err(errors) => {
            report::diagnostics(&errors, &Workspace::of(source), options);
            return Exit::Course;
        }
    };
    let start = Instant::now();
    match measure(metric, &points) {
        Ok(measured) => {
            let seconds = start.elapsed().as_secs_f64();
            tell(arguments, options, &points, &measured, seconds);
            Exit::Fine
        }
        Err(error) => {
            let message = format!("`{}` cannot be measured of `{}`: {error}", arguments.metric, source.path);
            report::wrong(&Diagnostic::error(Code::Points, message), Exit::Course, options)
        }
    }
}

fn tell(arguments: &Arguments, options: &Options, points: &Points, measured: &Measured, seconds: f64) {
    if !arguments.json && options.format != Format::Json {
        if measured.is_bound {
            report::say("a lower bound: the exact value is out of reach", options);
        }
        return report::to_stdout(&format!("{:?}\n", measured.value));
    }
    let corner = (!measured.extremal.is_empty()).then_some(&measured.extremal);
    let whole = json!({
        "metric": arguments.metric,
        "n": points.len(),
        "d": points.dimensions(),
        "value": measured.value,
        "exact": !measured.is_bound,
        "bounds": { "lower": measured.value, "upper": (!measured.is_bound).then_some(measured.value) },
        "extremal": corner,
        "seconds": seconds,
    });
    report::to_stdout_as_json(&whole);
}

/// The points of a text, a point a line; lines of nothing but blanks are passed over.
fn read(source: &Source) -> Result<Points, Vec<Diagnostic>> {
    let mut reader = Reader { file: &source.path, d: None, coordinates: Vec::new(), errors: Vec::new() };
    let mut start = 0;
    for line in source.text.split_inclusive('\n') {
        if !line.trim().is_empty() {
            reader.point(line.trim_end_matches(['\r', '\n']), start);
        }
        start += line.len();
        if reader.errors.len() >= MOST_TOLD {
            break;
        }
    }
    if reader.coordinates.is_empty() && reader.errors.is_empty() {
        let error = Diagnostic::error(Code::Points, "there is no point").at(&source.path, 0..0);
        reader.errors.push(error.help("write a point a line, its coordinates with commas between them"));
    }
    if !reader.errors.is_empty() {
        return Err(reader.errors);
    }
    let points = reader.d.and_then(|(d, _)| Points::from_rows(d, reader.coordinates));
    points.ok_or_else(|| vec![Diagnostic::error(Code::Points, "there is no point")])
}

struct Reader<'s> {
    file: &'s Arc<str>,
    /// The dimensions, and the line that says so.
    d: Option<(usize, usize)>,
    coordinates: Vec<f64>,
    errors: Vec<Diagnostic>,
}

impl Reader<'_> {
    /// Reads the line `line`, which begins at the byte `start`.
    fn point(&mut self, line: &str, start: usize) {
        let cells = line.split(',').count();
        let &mut (d, first) = self.d.get_or_insert((cells, start));
        if cells != d {
            let (one, many) = (report::counted(cells, "coordinate"), report::counted(d, "coordinate"));
            let place = start..start + line.len();
            let same = format!("a point has {one} here, and {many} in the first line");
            let error = Diagnostic::error(Code::Points, same).at(self.file, place);
            return self.errors.push(error.help("every point has as many coordinates"));
        }
        if self.coordinates.len() + cells > MOST_COORDINATES {
            let message = format!("these are more than {MOST_COORDINATES} coordinates");
            return self.errors.push(Diagnostic::error(Code::Points, message).at(self.file, start..start + 1));
        }
        let mut at = start;
        for cell in line.split(',') {
            let text = cell.trim();
            let place = at + (cell.len() - cell.trim_start().len());
            let place = place..place + text.len().max(1);
            at += cell.len() + 1;
            let message = match text.parse::<f64>() {
                Ok(x) if (0.0..=1.0).contains(&x) => {
                    self.coordinates.push(x);
                    continue;
                }
                Ok(_) => format!("the coordinate {text} is not a number from 0 to 1"),
                Err(_) => format!("`{text}` is not a number"),
            };
            let header = (start == first && text.parse::<f64>().is_err())
                .then(|| "the file begins with the first point: there is no header".to_owned());
            self.errors.push(Diagnostic::error(Code::Points, message).at(self.file, place).help_if(header));
        }
    }
}
