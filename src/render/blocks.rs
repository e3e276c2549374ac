//! Where blocks begin and end among the nodes of a chapter.

use pulldown_cmark::{Event, Tag};

use crate::parse::{CalloutKind, Node, What};

/// The end of what begins at the node `start`: the index of its last node.
pub(super) fn end(nodes: &[Node], start: usize) -> usize {
    let mut depth = 0_usize;
    for (at, node) in nodes.iter().enumerate().skip(start) {
        match &node.what {
            What::Markdown(Event::Start(_)) | What::CalloutStart(_) => depth += 1,
            What::Markdown(Event::End(_)) | What::CalloutEnd(_) => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return at;
        }
    }
    nodes.len().saturating_sub(1)
}

/// Where the definition begins that the node `at` stands in, or else the paragraph, item or cell. A callout's title stands in its start.
pub(super) fn around(nodes: &[Node], at: usize) -> Option<usize> {
    if matches!(&nodes.get(at)?.what, What::CalloutStart(_)) {
        return Some(at);
    }
    let definition =
        |node: &Node| matches!(&node.what, What::CalloutStart(callout) if callout.kind == CalloutKind::Definition);
    let line =
        |node: &Node| matches!(&node.what, What::Markdown(Event::Start(Tag::Paragraph | Tag::Item | Tag::TableCell)));
    let open = |start: &usize| end(nodes, *start) >= at;
    let find = |is: &dyn Fn(&Node) -> bool| (0..at).rev().filter(|&start| is(&nodes[start])).find(open);
    find(&definition).or_else(|| find(&line))
}
