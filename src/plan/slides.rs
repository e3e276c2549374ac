//! Marks for a lecture, `[!SLIDE]` and `[!NOTES]`: they stand by themselves, and hold nothing that readers would be led to.

use std::ops::Range;
use std::sync::Arc;

use pulldown_cmark::{Event, Tag, TagEnd};

use crate::diag::{Code, Diagnostic};
use crate::parse::{CalloutKind, Chapter, Node, What};

/// Tells every mark of a chapter that is misplaced, empty, or holds what has a number or an id.
pub(super) fn check(chapter: &Chapter, diagnostics: &mut Vec<Diagnostic>) {
    let mut walk = Walk { chapter, depth: 0, mark: None, said: false, diagnostics };
    chapter.content.nodes.iter().for_each(|node| walk.node(node));
}

/// A walk through a chapter.
struct Walk<'a> {
    chapter: &'a Chapter,
    /// How many callouts, lists, quotations and footnotes are open.
    depth: usize,
    /// The mark that is open, with its first bytes.
    mark: Option<(CalloutKind, Range<usize>)>,
    /// Whether the open mark holds anything.
    said: bool,
    diagnostics: &'a mut Vec<Diagnostic>,
}

impl Walk<'_> {
    fn node(&mut self, node: &Node) {
        match &node.what {
            What::CalloutStart(callout) => {
                self.start(callout.kind, &node.range);
                self.depth += 1;
            }
            What::CalloutEnd(kind) => {
                self.depth = self.depth.saturating_sub(1);
                if self.depth == 0 {
                    self.end(*kind);
                }
            }
            What::Markdown(Event::Start(tag)) => {
                self.depth += usize::from(holds(tag.to_end()));
                if matches!(tag, Tag::Heading { .. }) {
                    self.refuse("a heading", &node.range);
                }
            }
            What::Markdown(Event::End(tag)) => self.depth = self.depth.saturating_sub(usize::from(holds(*tag))),
            What::Experiment(_) => self.refuse("an exhibit", &node.range),
            What::Listing(_) => self.refuse("a listing", &node.range),
            What::Equation { label: Some(_), .. } => self.refuse("a numbered equation", &node.range),
            What::Term(term) if term.defines => self.refuse("the definition of a term", &node.range),
            _ => self.said = true,
        }
    }

    fn start(&mut self, kind: CalloutKind, range: &Range<usize>) {
        if !kind.is_for_lectures() {
            if kind.prefix().is_some() {
                self.refuse("a callout with a number", range);
            }
        } else if self.depth > 0 {
            let message = format!("a mark `[!{}]` stands by itself", kind.name());
            self.tell(&message, range, "take it out of the callout, list, quotation or footnote that it stands in");
        } else {
            self.mark = Some((kind, range.clone()));
            self.said = false;
        }
    }

    /// The end of what stood by itself.
    fn end(&mut self, kind: CalloutKind) {
        if let Some((CalloutKind::Notes, range)) = self.mark.take()
            && kind == CalloutKind::Notes
            && !self.said
        {
            self.tell("these notes are empty", &range, "say what the speaker should, or take the mark away");
        }
    }

    /// Complains of `what` if a mark is open.
    fn refuse(&mut self, what: &str, range: &Range<usize>) {
        self.said = true;
        if let Some((kind, _)) = self.mark {
            let message = format!("{what} stands within a mark `[!{}]`, which readers do not see", kind.name());
            self.tell(&message, range, "put it into the text: slides are made of the text too");
        }
    }

    fn tell(&mut self, message: &str, range: &Range<usize>, help: &str) {
        let file: &Arc<str> = &self.chapter.file;
        self.diagnostics.push(Diagnostic::error(Code::Markup, message).at(file, range.clone()).help(help));
    }
}

/// Whether marks must not stand within this.
fn holds(tag: TagEnd) -> bool {
    matches!(tag, TagEnd::BlockQuote(_) | TagEnd::List(_) | TagEnd::FootnoteDefinition)
}
