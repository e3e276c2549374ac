//! `workbook points`: the points of a method, written as numbers that read back to the same bits.

use std::io::{self, Write};

use clap::Args;

use super::{Exit, Format, Options, among, report};
use crate::diag::{Code, Diagnostic};
use crate::points::Points;
use crate::samplers::{Digital, MOST_COORDINATES, Method, Refused, UnknownMethod};
use crate::seed::Seed;

#[derive(Args)]
pub(super) struct Arguments {
    /// The sampler, perhaps with settings and a scramble: `sobol+owen`, `faure(base=5)`
    method: String,
    /// How many points
    #[arg(short, value_name = "N", value_parser = count)]
    n: usize,
    /// How many dimensions
    #[arg(short, value_name = "D", value_parser = count)]
    d: usize,
    /// The seed of the random numbers
    #[arg(long, value_name = "SEED", default_value = "1", value_parser = seed)]
    seed: u64,
    /// Write whole numerators over powers of a base instead of fractions; only where there are such
    #[arg(long)]
    exact: bool,
    /// How the points are written
    #[arg(long, value_parser = among(&[Format::Csv, Format::Json, Format::Npy]), default_value = "csv")]
    format: Format,
}

fn count(text: &str) -> Result<usize, String> {
    text.parse().map_err(|_| format!("it must be a whole number from 1 to {MOST_COORDINATES}"))
}

fn seed(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("it must be a whole number from 0 to {}", u64::MAX))
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let method = match Method::parse(&arguments.method) {
        Ok(method) => method,
        Err(error) => return report::wrong(&unknown(&error), Exit::Call, options),
    };
    let refuse = |refused: &Refused| {
        let code = if matches!(refused, Refused::Count { .. }) { Code::Count } else { Code::OutOfRange };
        report::wrong(&Diagnostic::error(code, format!("`{method}`: {refused}")), Exit::Call, options)
    };
    if let Err(refused) = method.admits(arguments.n, arguments.d) {
        return refuse(&refused);
    }
    if arguments.exact {
        return exact(&method, arguments, options);
    }
    match method.points(arguments.n, arguments.d, Seed::new(arguments.seed)) {
        Ok(points) => report::stream(options, |out| match arguments.format {
            Format::Npy => npy(&points, out),
            Format::Json => json(&method, arguments, &points, out),
            _ => points.rows().try_for_each(|row| line(row, out)),
        }),
        // What was admitted fails for want of memory only.
        Err(refused) => {
            refuse(&refused);
            Exit::System
        }
    }
}

fn unknown(error: &UnknownMethod) -> Diagnostic {
    let (code, list) = match error {
        UnknownMethod::Scramble { .. } => (Code::UnknownName, "scrambles"),
        UnknownMethod::Combination { .. } => (Code::Combination, "scrambles"),
        UnknownMethod::Setting { .. } => (Code::OutOfRange, "samplers"),
        _ => (Code::UnknownName, "samplers"),
    };
    Diagnostic::error(code, error.to_string()).help(format!("`workbook list {list}` shows all"))
}

/// The numbers of one point, with commas; every `f64` is written with the fewest digits that tell it from its neighbours.
fn line<T: std::fmt::Debug>(row: &[T], out: &mut dyn Write) -> io::Result<()> {
    for (at, x) in row.iter().enumerate() {
        write!(out, "{}{x:?}", if at > 0 { "," } else { "" })?;
    }
    writeln!(out)
}

/// The rows as a JSON array of arrays, one point a line.
fn rows<T: std::fmt::Debug>(count: usize, row: impl Fn(usize) -> Vec<T>, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "[")?;
    for index in 0..count {
        write!(out, "{}{:?}", if index > 0 { ",\n" } else { "\n" }, row(index))?;
    }
    writeln!(out, "\n]}}")
}

/// What was asked for, as the start of a JSON object.
fn question(method: &Method, arguments: &Arguments, out: &mut dyn Write) -> io::Result<()> {
    let Arguments { n, d, seed, .. } = arguments;
    write!(out, "{{\"method\": \"{method}\", \"n\": {n}, \"d\": {d}, \"seed\": {seed}, ")
}

fn json(method: &Method, arguments: &Arguments, points: &Points, out: &mut dyn Write) -> io::Result<()> {
    question(method, arguments, out)?;
    write!(out, "\"points\": ")?;
    let d = points.dimensions();
    rows(points.len(), |index| points.coordinates()[index * d..(index + 1) * d].to_vec(), out)
}

/// A NumPy file of version 1.0: an array of shape (n, d) of little-endian 64-bit floats, row by row.
fn npy(points: &Points, out: &mut dyn Write) -> io::Result<()> {
    let shape = (points.len(), points.dimensions());
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape:?}, }}");
    // The data begin at a multiple of 64 bytes: 10 stand before the header, which ends with a line end.
    let length = (10 + header.len() + 1).next_multiple_of(64) - 10;
    header.extend(std::iter::repeat_n(' ', length - 1 - header.len()));
    out.write_all(b"\x93NUMPY\x01\x00")?;
    out.write_all(&(length as u16).to_le_bytes())?;
    writeln!(out, "{header}")?;
    points.coordinates().iter().try_for_each(|x| out.write_all(&x.to_le_bytes()))
}

/// The numerators of a digital sampler that no scramble has touched.
fn exact(method: &Method, arguments: &Arguments, options: &Options) -> Exit {
    let (n, d) = (arguments.n, arguments.d);
    let wrong = |message: String| {
        let error = Diagnostic::error(Code::Combination, message);
        report::wrong(&error.help("leave `--exact` out"), Exit::Call, options)
    };
    if arguments.format == Format::Npy {
        return wrong("`--exact` gives whole numbers and their bases, for which `npy` has no place".to_owned());
    }
    if let Some(scramble) = method.scramble() {
        let key = scramble.about().key;
        return wrong(format!("`--exact` is for digits as they are, and `{key}` scrambles them"));
    }
    let Some(digital) = method.sampler().digital(n, d) else {
        return wrong(format!("`{method}` has no numerators: its coordinates are no digits of a base"));
    };
    report::stream(options, |out| numerators(method, arguments, digital.as_ref(), out))
}

fn numerators(method: &Method, arguments: &Arguments, digital: &dyn Digital, out: &mut dyn Write) -> io::Result<()> {
    let (n, d) = (arguments.n, arguments.d);
    let row = |index: usize| -> Vec<u64> { (0..d).map(|axis| digital.numerator(index as u64, axis)).collect() };
    let radices: Vec<_> = (0..d).map(|axis| digital.radix(axis)).collect();
    if arguments.format == Format::Json {
        question(method, arguments, out)?;
        let bases: Vec<_> = radices.iter().map(|radix| radix.base).collect();
        let scales: Vec<_> = radices.iter().map(|radix| radix.scale).collect();
        write!(out, "\"bases\": {bases:?}, \"scales\": {scales:?}, \"numerators\": ")?;
        return rows(n, row, out);
    }
    let scales: Vec<String> = radices.iter().map(|radix| format!("{}^{}", radix.base, radix.digits)).collect();
    writeln!(out, "# over {}", scales.join(","))?;
    (0..n).try_for_each(|index| line(&row(index), out))
}
