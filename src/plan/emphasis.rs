//! The lines that plain fences emphasise: that they can be read, and that they are there.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Tag};

use crate::diag::{Code, Diagnostic};
use crate::parse::{Chapter, Emphasis, HELP, Node, What, fence};
use crate::workspace::Workspace;

/// Complains of the lines of a chapter's plain fences that cannot be read, or that the code does not have.
pub(super) fn check(chapter: &Chapter, workspace: &Workspace, diagnostics: &mut Vec<Diagnostic>) {
    let nodes = &chapter.content.nodes;
    for (at, node) in nodes.iter().enumerate() {
        let What::Markdown(Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info)))) = &node.what else {
            continue;
        };
        let Some(written) = fence(info).1 else { continue };
        let told = match Emphasis::read(written) {
            Ok(read) => read.beyond(lines(&nodes[at + 1..])).map(|message| (Code::OutOfRange, message)),
            Err(part) => Some((Code::WrongType, format!("`{part}` is no line of code"))),
        };
        let Some((code, message)) = told else { continue };
        let text = workspace.text(&chapter.file).map_or("", |source| &*source.text);
        let place = braces(text, &node.range);
        diagnostics.push(Diagnostic::error(code, message).at(&chapter.file, place).help(HELP));
    }
}

/// How many lines the code has that `nodes` begin with.
fn lines(nodes: &[Node]) -> usize {
    let texts = nodes.iter().map_while(|node| match &node.what {
        What::Markdown(Event::Text(text)) => Some(text.matches('\n').count()),
        _ => None,
    });
    texts.sum()
}

/// Where the braces of the fence at `range` stand in the file; the whole fence, if that cannot be said.
fn braces(text: &str, range: &Range<usize>) -> Range<usize> {
    let head = text.get(range.clone()).and_then(|text| text.lines().next()).unwrap_or_default();
    match head.find('{') {
        Some(open) => range.start + open..range.start + head.trim_end().len(),
        None => range.clone(),
    }
}
