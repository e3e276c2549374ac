//! The command line: one file per subcommand, and the only code that prints.

mod accept;
mod build;
mod check;
mod clean;
mod compare;
mod explain;
mod init;
mod list;
mod measure;
mod new;
mod points;
mod progress;
mod report;
mod run_one;
mod schema;
mod serve;
mod shell;
mod status;
mod timings;
mod verify;
mod why;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::compose::Request;
use crate::diag::{Code, Diagnostic, Severity};
use crate::parse::Audience;

/// A literate course workbook: every figure computed, every claim verified.
#[derive(Parser)]
#[command(version, about, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    options: Options,
}

/// What every subcommand understands.
#[derive(Args, Debug, Clone)]
struct Options {
    /// The course's folder
    #[arg(long, global = true, value_name = "DIR", default_value = ".")]
    root: PathBuf,
    /// The folder to write the book to [default: book, for students book-student, in the course's folder]
    #[arg(long, global = true, value_name = "DIR")]
    out: Option<PathBuf>,
    /// How many threads run experiments [default: all processors]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Compute every result, and keep none
    #[arg(long, global = true)]
    no_cache: bool,
    /// How diagnostics are written
    #[arg(long, global = true, default_value = "human",
        value_parser = among(&[Format::Human, Format::Json, Format::Github]))]
    format: Format,
    /// Write nothing but diagnostics
    #[arg(long, short, global = true)]
    quiet: bool,
    /// Tell how long each stage and each experiment took
    #[arg(long, global = true)]
    timings: bool,
}

/// How diagnostics are written, and what some commands print.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// With the source line and the place marked
    Human,
    /// As JSON: diagnostics one object a line
    Json,
    /// As annotations of a workflow on a forge
    Github,
    /// A row a line, with commas
    Csv,
    /// With the columns aligned
    Table,
    /// As a drawing
    Svg,
    /// A NumPy array, shape (n, d), 64-bit floats
    Npy,
}

/// Reads one of `formats`: not every command knows all.
fn among(formats: &[Format]) -> impl TypedValueParser<Value = Format> + use<> {
    let words: Vec<PossibleValue> = formats.iter().filter_map(ValueEnum::to_possible_value).collect();
    PossibleValuesParser::new(words).try_map(|word| Format::from_str(&word, false))
}

#[derive(Subcommand)]
enum Command {
    /// Write a small complete course to start from
    Init(init::Arguments),
    /// Add a chapter to the course
    New(new::Arguments),
    /// Make the book
    Build(Readers),
    /// Show the course in a browser, and follow its changes
    Serve(serve::Arguments),
    /// Tell every mistake that can be known without running
    Check(Readers),
    /// Compute everything anew and compare it with the lock
    Verify,
    /// Record reviewed exhibits in the lock: those named, or all
    Accept(accept::Arguments),
    /// Tell what differs between two books, or between revisions
    Compare(compare::Arguments),
    /// Run the experiment of one exhibit and print its values
    Run(run_one::Arguments),
    /// Tell whether an exhibit is fresh or stale, and why
    Why(why::Arguments),
    /// Tell what a diagnostic means, with a wrong and a right example
    Explain(explain::Arguments),
    /// Tell which exhibits are fresh, and which are stale and why
    Status(status::Arguments),
    /// List the entries of a catalogue
    List(list::Arguments),
    /// Write the points of a method
    Points(points::Arguments),
    /// Measure the points in a file
    Measure(measure::Arguments),
    /// Remove cached results
    Clean(clean::Arguments),
    /// Print the JSON schema of an experiment or of the settings, for editors
    Schema(schema::Arguments),
    /// Print what completes commands in a shell
    Completions(shell::Completions),
    /// Print the page of the manual: `workbook man | man -l -`
    Man(shell::Manual),
}

/// For whom a book is made.
#[derive(Args)]
struct Readers {
    /// For whom the book is: students get it without solutions [default: as the course says, or else instructor]
    #[arg(long, value_name = "AUDIENCE", value_parser = PossibleValuesParser::new(Audience::words()).map(|word| Audience::named(&word).unwrap_or_default()))]
    audience: Option<Audience>,
}

/// How a command ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Exit {
    /// Nothing is wrong.
    Fine = 0,
    /// The course is wrong, or the file that was to be measured.
    Course = 1,
    /// The call is wrong.
    Call = 2,
    /// The system failed.
    System = 3,
}

/// Runs the command that the arguments ask for.
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    let exit = match cli.command {
        Command::Init(arguments) => init::run(&arguments, &cli.options),
        Command::New(arguments) => new::run(&arguments, &cli.options),
        Command::Build(readers) => build::run(&readers, &cli.options),
        Command::Serve(arguments) => serve::run(arguments, &cli.options),
        Command::Check(readers) => check::run(&readers, &cli.options),
        Command::Verify => verify::run(&cli.options),
        Command::Accept(arguments) => accept::run(&arguments, &cli.options),
        Command::Compare(arguments) => compare::run(&arguments, &cli.options),
        Command::Run(arguments) => run_one::run(&arguments, &cli.options),
        Command::Why(arguments) => why::run(&arguments, &cli.options),
        Command::Explain(arguments) => explain::run(&arguments, &cli.options),
        Command::Status(arguments) => status::run(&arguments, &cli.options),
        Command::List(arguments) => list::run(&arguments, &cli.options),
        Command::Points(arguments) => points::run(&arguments, &cli.options),
        Command::Measure(arguments) => measure::run(&arguments, &cli.options),
        Command::Clean(arguments) => clean::run(&arguments, &cli.options),
        Command::Schema(arguments) => schema::run(&arguments),
        Command::Completions(arguments) => shell::completions(&arguments, &cli.options),
        Command::Man(arguments) => shell::manual(&arguments, &cli.options),
    };
    ExitCode::from(exit as u8)
}

impl Options {
    /// What a book is made from.
    fn request(&self) -> Request {
        let processors = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Request {
            root: self.root.clone(),
            threads: self.jobs.map_or(processors, usize::from),
            cached: !self.no_cache,
            // The lock, and whatever is asked of single exhibits, are of the whole course.
            audience: Some(Audience::Instructor),
        }
    }

    /// Where the book for this audience goes.
    fn out(&self, audience: Audience) -> PathBuf {
        let name = if audience == Audience::Student { "book-student" } else { "book" };
        self.out.clone().unwrap_or_else(|| self.root.join(name))
    }
}

impl Exit {
    /// How a command with these diagnostics ends: as badly as the worst of them.
    fn of(diagnostics: &[Diagnostic]) -> Self {
        let errors = diagnostics.iter().filter(|diagnostic| diagnostic.severity == Severity::Error);
        errors.map(|error| Self::of_code(error.code)).max().unwrap_or(Self::Fine)
    }

    fn of_code(code: Code) -> Self {
        match code {
            Code::Unreadable | Code::Unwritable | Code::Address => Self::System,
            Code::NoCourse | Code::NotABook | Code::Exists => Self::Call,
            _ => Self::Course,
        }
    }
}
