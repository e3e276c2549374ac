//! Diagnostics as people, programs and forges read them.

use std::io::{self, BufWriter, IsTerminal, Write, stderr, stdout};

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use serde::Serialize;
use serde_json::json;

use super::{Exit, Format, Options};
use crate::catalogue::nearest;
use crate::compose::Planned;
use crate::diag::{Code, Diagnostic, Place, Severity};
use crate::workspace::Workspace;

/// Writes the diagnostics, ordered by place, in the format that the options ask for: to the error stream for people, else to the output.
pub(super) fn diagnostics(found: &[Diagnostic], workspace: &Workspace, options: &Options) {
    let mut sorted: Vec<&Diagnostic> = found.iter().collect();
    sorted.sort_by_key(|diagnostic| diagnostic.place.as_ref().map(|place| (place.file.clone(), place.range.start)));
    let mut text = String::new();
    for diagnostic in sorted {
        text.push_str(&match options.format {
            Format::Json => json_line(diagnostic, workspace),
            Format::Github => github(diagnostic, workspace),
            _ => human(diagnostic, workspace),
        });
        text.push('\n');
    }
    if matches!(options.format, Format::Json | Format::Github) {
        to_stdout(&text);
    } else {
        text.push_str(&count(found));
        to_stderr(&text);
        if let Some(error) = found.iter().find(|diagnostic| diagnostic.severity == Severity::Error) {
            say(&format!("`workbook explain {}` tells more of such a mistake", error.code.id()), options);
        }
    }
}

/// Tells one mistake that is in no file, and ends as `exit` says.
pub(super) fn wrong(error: &Diagnostic, exit: Exit, options: &Options) -> Exit {
    diagnostics(std::slice::from_ref(error), &Workspace::default(), options);
    exit
}

/// Writes to the output piece by piece what `write` gives.
pub(super) fn stream(options: &Options, write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Exit {
    let mut out = BufWriter::with_capacity(1 << 16, stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Ok(()) => Exit::Fine,
        // A reader that has gone away is no mistake of ours.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Exit::Fine,
        Err(error) => {
            let error = Diagnostic::error(Code::Unwritable, format!("the output cannot be written: {error}"));
            wrong(&error, Exit::System, options)
        }
    }
}

/// Tells that no exhibit that is right has this id: what is wrong with the course may be why.
pub(super) fn no_exhibit(id: &str, planned: &Planned, options: &Options) -> Exit {
    let ids = planned.plan.exhibits.iter().map(|exhibit| exhibit.id.as_str());
    let near = nearest(id, ids).map(|near| format!("did you mean `{near}`?"));
    let error = Diagnostic::error(Code::MissingTarget, format!("no exhibit that is right has the id `{id}`"))
        .help_if(near)
        .help("`workbook list exhibits` names them all");
    let all: Vec<Diagnostic> = planned.diagnostics.iter().cloned().chain([error]).collect();
    diagnostics(&all, &planned.workspace, options);
    Exit::Call
}

/// Writes a line for people, unless they asked for quiet.
pub(super) fn say(line: &str, options: &Options) {
    if !options.quiet {
        to_stderr(&format!("{line}\n"));
    }
}

/// Writes what was asked for.
pub(super) fn to_stdout(text: &str) {
    // A reader that has gone away is no mistake of ours.
    let _ = stdout().lock().write_all(text.as_bytes());
}

/// Writes what was asked for as JSON, for people to read as well.
pub(super) fn to_stdout_as_json(value: &impl Serialize) {
    to_stdout(&format!("{}\n", serde_json::to_string_pretty(value).unwrap_or_default()));
}

fn to_stderr(text: &str) {
    let _ = stderr().lock().write_all(text.as_bytes());
}

/// Whether the error stream is a terminal that wants colours.
fn coloured() -> bool {
    stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

fn human(diagnostic: &Diagnostic, workspace: &Workspace) -> String {
    rendered(diagnostic, workspace, &if coloured() { Renderer::styled() } else { Renderer::plain() })
}

/// A diagnostic as people read it elsewhere than on a terminal.
pub(super) fn plain(diagnostic: &Diagnostic, workspace: &Workspace) -> String {
    rendered(diagnostic, workspace, &Renderer::plain())
}

fn rendered(diagnostic: &Diagnostic, workspace: &Workspace, renderer: &Renderer) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let title = level.primary_title(diagnostic.message.as_str()).id(diagnostic.code.id());
    let mut group = match diagnostic.place.as_ref().and_then(|place| Some((place, workspace.excerpt(&place.file)?))) {
        Some((place, text)) => {
            let start = place.range.start.min(text.len());
            let marked = text.get(start..place.range.end.clamp(start, text.len())).unwrap_or_default();
            let range = start..start + marked.trim_end().len();
            let mark = AnnotationKind::Primary.span(range).label(diagnostic.label.as_deref());
            title.element(Snippet::source(text).path(&*place.file).annotation(mark))
        }
        None => match &diagnostic.place {
            Some(place) => title.element(annotate_snippets::Origin::path(&*place.file)),
            None => Group::with_title(title),
        },
    };
    for help in &diagnostic.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    format!("{}\n", renderer.render(&[group]))
}

/// The file and the line of a place.
pub(super) fn line_of(place: &Place, workspace: &Workspace) -> String {
    format!("{}:{}", place.file, position(place, workspace).0)
}

/// The line and column of a place, both from 1, the column in characters; and the column of its end on that line.
pub(super) fn position(place: &Place, workspace: &Workspace) -> (usize, usize, usize) {
    let text = workspace.excerpt(&place.file).unwrap_or_default();
    let start = text.floor_char_boundary(place.range.start.min(text.len()));
    let end = text.floor_char_boundary(place.range.end.clamp(start, text.len()));
    let line_start = text[..start].rfind('\n').map_or(0, |newline| newline + 1);
    let line = text[..start].matches('\n').count() + 1;
    let column = text[line_start..start].chars().count() + 1;
    let width = text[start..end].lines().next().unwrap_or_default().chars().count();
    (line, column, column + width)
}

fn json_line(diagnostic: &Diagnostic, workspace: &Workspace) -> String {
    let place = diagnostic.place.as_ref().map(|place| {
        let (line, column, end) = position(place, workspace);
        json!({ "file": &*place.file, "line": line, "column": column, "end_column": end, "bytes": [place.range.start, place.range.end] })
    });
    json!({
        "code": diagnostic.code.id(),
        "severity": severity(diagnostic),
        "message": diagnostic.message,
        "label": diagnostic.label,
        "place": place,
        "help": diagnostic.help,
    })
    .to_string()
}

fn severity(diagnostic: &Diagnostic) -> &'static str {
    match diagnostic.severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
    }
}

fn github(diagnostic: &Diagnostic, workspace: &Workspace) -> String {
    let data = |text: &str| text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A");
    let property = |text: &str| data(text).replace(':', "%3A").replace(',', "%2C");
    let place = diagnostic.place.as_ref().map_or_else(String::new, |place| {
        let (line, column, end) = position(place, workspace);
        format!("file={},line={line},col={column},endColumn={end},", property(&place.file))
    });
    let label = diagnostic.label.iter().cloned();
    let text = std::iter::once(diagnostic.message.clone()).chain(label).chain(diagnostic.help.iter().cloned());
    let text = text.collect::<Vec<_>>().join("\n");
    format!("::{} {place}title={}::{}", severity(diagnostic), property(diagnostic.code.id()), data(&text))
}

/// So many of what `word` is the singular of.
pub(super) fn counted(count: usize, word: &str) -> String {
    if count == 1 { format!("1 {word}") } else { format!("{count} {word}s") }
}

/// How many errors and warnings there are, in words; nothing if there are none.
fn count(found: &[Diagnostic]) -> String {
    let errors = found.iter().filter(|diagnostic| diagnostic.severity == Severity::Error).count();
    let of = |count: usize, word: &str| (count > 0).then(|| counted(count, word));
    let parts: Vec<String> = of(errors, "error").into_iter().chain(of(found.len() - errors, "warning")).collect();
    if parts.is_empty() { String::new() } else { format!("{}\n", parts.join(" and ")) }
}
