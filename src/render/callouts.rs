//! Callouts, and the one button that opens all that are folded.

use std::fmt::Write as _;

use super::markdown::Writer;
use crate::parse::{Callout, CalloutKind, Node, What};

impl Writer<'_> {
    pub(super) fn callout(&mut self, callout: &Callout) {
        let kind = callout.kind;
        if kind == CalloutKind::Exercise {
            self.fold_all();
        }
        let anchor = self
            .at
            .and_then(|at| self.rendering.plan.labels.anchor(self.chapter, at))
            .filter(|_| kind.prefix().is_some());
        let label = match anchor {
            Some(anchor) => {
                let (id, title, number) = (&anchor.id, kind.title(), &anchor.number);
                format!("<a class=\"callout-label\" href=\"#{id}\">{title} {number}</a>")
            }
            None => format!("<span class=\"callout-label\">{}</span>", kind.title()),
        };
        let (title, diagnostics) = Writer::new(self.rendering, self.chapter).inline(&callout.title);
        self.diagnostics.extend(diagnostics);
        let title =
            if title.is_empty() { String::new() } else { format!(" <span class=\"callout-name\">{title}</span>") };
        let head = format!("{label}{title}");
        let class = format!("callout callout-{}", kind.name().to_lowercase());
        let _ = match (kind, anchor) {
            (kind, _) if kind.folded() => writeln!(self.out, "<details class=\"{class}\"><summary>{head}</summary>"),
            (_, Some(anchor)) => writeln!(
                self.out,
                "<section class=\"{class}\" id=\"{}\"><p class=\"callout-title\">{head}</p>",
                anchor.id
            ),
            (CalloutKind::Definition | CalloutKind::Exercise, None) => {
                writeln!(self.out, "<section class=\"{class}\"><p class=\"callout-title\">{head}</p>")
            }
            // Slides and their notes are there for the script that presents the page.
            (kind, _) if kind.is_for_lectures() => {
                writeln!(self.out, "<aside class=\"{class}\" hidden><p class=\"callout-title\">{head}</p>")
            }
            _ => writeln!(self.out, "<aside class=\"{class}\"><p class=\"callout-title\">{head}</p>"),
        };
    }

    pub(super) fn callout_end(&mut self, kind: CalloutKind) {
        self.out.push_str(match kind {
            kind if kind.folded() => "</details>\n",
            kind if kind.prefix().is_some() => "</section>\n",
            _ => "</aside>\n",
        });
    }

    /// Before the first exercise of a chapter: the button for all that is folded in it.
    fn fold_all(&mut self) {
        let (Some(at), nodes) = (self.at, self.nodes()) else { return };
        let first =
            |node: &Node| matches!(&node.what, What::CalloutStart(other) if other.kind == CalloutKind::Exercise);
        if nodes[..at].iter().any(first) {
            return;
        }
        let count = |kind| {
            let of = |node: &&Node| matches!(&node.what, What::CalloutStart(other) if other.kind == kind);
            nodes.iter().filter(of).count()
        };
        let what = match (count(CalloutKind::Hint), count(CalloutKind::Solution)) {
            (hints, solutions) if hints + solutions < 2 => return,
            (_, 0) => "hints",
            (0, _) => "solutions",
            _ => "hints and solutions",
        };
        let _ = writeln!(
            self.out,
            "<p class=\"fold-all\"><button type=\"button\" aria-pressed=\"false\">Unfold all {what}</button></p>"
        );
    }
}
