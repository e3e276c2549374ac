//! Audiences: the course as students get it, which has no solutions, and the course as instructors get it, which has all.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use pulldown_cmark::{CowStr, Event, Tag, TagEnd};

use super::{Chapter, Content, Course};
use crate::diag::{Code, Diagnostic};
use crate::parameters::choices;
use crate::parse::{Callout, CalloutKind, Node, What};
use crate::workspace::{CHAPTERS, Workspace};

choices! {
    /// For whom a book is made.
    pub enum Audience {
        /// Those who try the exercises: the book has no byte of a solution, nor of a speaker's notes.
        Student = "student",
        /// Those who teach: the book has everything.
        Instructor = "instructor",
    }
}

#[allow(clippy::derivable_impls, reason = "the macro of choices writes the enum")]
impl Default for Audience {
    fn default() -> Self {
        Self::Instructor
    }
}

impl Audience {
    /// The audience that is called `word`.
    pub fn named(word: &str) -> Option<Self> {
        [Self::Student, Self::Instructor].into_iter().find(|audience| audience.word() == word)
    }

    /// Every word that names an audience.
    pub fn words() -> &'static [&'static str] {
        Self::WORDS
    }
}

/// What students do not get is gone from this course: later stages cannot show what they have never seen.
///
/// Solutions, and notes for the speaker, leave blank nodes behind, so that every other node keeps its place, and with it the number that it has in the
/// whole book. Footnotes that only solutions refer to go with them; a footnote that stands in a solution and is referred to
/// from elsewhere is told.
pub fn without_solutions(course: &Course) -> (Course, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let chapters = course.chapters.iter().map(|chapter| {
        let withheld = withheld(&chapter.content.nodes);
        diagnostics.extend(orphans(chapter, &withheld));
        Chapter { content: Arc::new(kept(&chapter.content, &withheld)), ..chapter.clone() }
    });
    let chapters = chapters.collect();
    (Course { configuration: course.configuration.clone(), chapters }, diagnostics)
}

/// Removes the files that solutions name and the rest of the course, `students`, does not.
pub fn without_files_of_solutions(workspace: &mut Workspace, whole: &Course, students: &Course) {
    let prefix = format!("{CHAPTERS}/");
    let (all, left) = (named(whole), named(students));
    let holds = |texts: &BTreeSet<String>, file: &str| texts.iter().any(|text| names(text, file));
    workspace.blobs.retain(|path, _| {
        let file = path.strip_prefix(&prefix).unwrap_or(path);
        !holds(&all, file) || holds(&left, file)
    });
}

/// Whether `file` stands in `text`, and not as the end of another file's name.
fn names(text: &str, file: &str) -> bool {
    text.match_indices(file).any(|(at, _)| {
        let before = text[..at].strip_suffix("./").unwrap_or(&text[..at]);
        !before.ends_with(|c: char| c.is_alphanumeric() || "-_./".contains(c))
    })
}

/// Every address of a course, and what it has of raw HTML, where there may be others.
fn named(course: &Course) -> BTreeSet<String> {
    let nodes = course.chapters.iter().map(|chapter| &chapter.content.nodes);
    let nodes = nodes.chain(course.configuration.landing.iter().map(|passage| &passage.nodes)).flatten();
    let mut texts = BTreeSet::new();
    walk(nodes, &mut |node| match &node.what {
        What::Markdown(Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. })) => {
            texts.insert(dest_url.to_string());
        }
        What::Markdown(Event::Html(html) | Event::InlineHtml(html)) => drop(texts.insert(html.to_string())),
        _ => {}
    });
    // Captions are text still.
    let fences = |content: &Content| content.experiments.iter().chain(&content.listings).cloned().collect::<Vec<_>>();
    texts.extend(course.chapters.iter().flat_map(|chapter| fences(&chapter.content)).map(|fence| fence.text));
    texts
}

/// Calls `see` for every node, those within titles and terms included.
fn walk<'n>(nodes: impl IntoIterator<Item = &'n Node>, see: &mut impl FnMut(&'n Node)) {
    for node in nodes {
        see(node);
        match &node.what {
            What::CalloutStart(Callout { title, .. }) => walk(title, see),
            What::Term(term) => walk(&term.words, see),
            _ => {}
        }
    }
}

/// For each node, whether it is withheld from students.
fn withheld(nodes: &[Node]) -> Vec<bool> {
    let mut withheld = solutions(nodes);
    let notes = footnotes(nodes);
    // A footnote may be the only one that refers to another.
    loop {
        let named = |hidden: bool| references(nodes.iter().zip(&withheld).filter(move |(_, is)| **is == hidden));
        let (inside, outside) = (named(true), named(false));
        let only = |(name, range): &(&&str, &std::ops::Range<usize>)| {
            inside.contains(**name) && !outside.contains(**name) && !withheld[range.start]
        };
        let Some(range) = notes.iter().find(only).map(|(_, range)| range.clone()) else { return withheld };
        withheld[range].fill(true);
    }
}

/// For each node, whether it stands in a solution or in a speaker's notes.
fn solutions(nodes: &[Node]) -> Vec<bool> {
    let mut depth = 0_usize;
    let mut inside = Vec::with_capacity(nodes.len());
    for node in nodes {
        match &node.what {
            What::CalloutStart(callout) if depth > 0 || for_instructors(callout.kind) => depth += 1,
            What::CalloutEnd(_) if depth > 0 => {
                depth -= 1;
                inside.push(true);
                continue;
            }
            _ => {}
        }
        inside.push(depth > 0);
    }
    inside
}

/// Whether students do not get a callout of this kind.
fn for_instructors(kind: CalloutKind) -> bool {
    matches!(kind, CalloutKind::Solution | CalloutKind::Notes)
}

/// The nodes of each footnote by its name.
fn footnotes(nodes: &[Node]) -> BTreeMap<&str, std::ops::Range<usize>> {
    let mut notes = BTreeMap::new();
    let mut open = None;
    for (at, node) in nodes.iter().enumerate() {
        match &node.what {
            What::Markdown(Event::Start(Tag::FootnoteDefinition(name))) => open = Some((&**name, at)),
            What::Markdown(Event::End(TagEnd::FootnoteDefinition)) => {
                notes.extend(open.take().map(|(name, start)| (name, start..at + 1)));
            }
            _ => {}
        }
    }
    notes
}

/// The names of the footnotes that nodes refer to.
fn references<'n>(nodes: impl Iterator<Item = (&'n Node, &'n bool)>) -> BTreeSet<&'n str> {
    let mut names = BTreeSet::new();
    walk(nodes.map(|(node, _)| node), &mut |node| {
        if let What::Markdown(Event::FootnoteReference(name)) = &node.what {
            names.insert(&**name);
        }
    });
    names
}

/// Complaints of references that are kept, to footnotes that are not.
fn orphans(chapter: &Chapter, withheld: &[bool]) -> Vec<Diagnostic> {
    let nodes = &chapter.content.nodes;
    let gone: BTreeSet<&str> =
        footnotes(nodes).into_iter().filter(|(_, range)| withheld[range.start]).map(|(name, _)| name).collect();
    let mut orphans = Vec::new();
    walk(nodes.iter().zip(withheld).filter(|(_, is)| !**is).map(|(node, _)| node), &mut |node| {
        if let What::Markdown(Event::FootnoteReference(name)) = &node.what
            && gone.contains(&**name)
        {
            let message = format!("for students: the footnote `{name}` stands in a solution");
            let error = Diagnostic::error(Code::Withheld, message).at(&chapter.file, node.range.clone());
            orphans.push(error.help("write the footnote outside of the solution"));
        }
    });
    orphans
}

/// What is left of a chapter's content.
fn kept(content: &Content, withheld: &[bool]) -> Content {
    let mut kept = Content::default();
    for (node, withheld) in content.nodes.iter().zip(withheld) {
        let move_fence = |from: &[super::Fence], to: &mut Vec<super::Fence>, fence: usize| {
            to.extend(from.get(fence).cloned());
            to.len().saturating_sub(1)
        };
        let what = match &node.what {
            _ if *withheld => What::Markdown(Event::Text(CowStr::Borrowed(""))),
            What::Experiment(fence) => {
                What::Experiment(move_fence(&content.experiments, &mut kept.experiments, *fence))
            }
            What::Listing(fence) => What::Listing(move_fence(&content.listings, &mut kept.listings, *fence)),
            what => what.clone(),
        };
        kept.nodes.push(Node { what, range: if *withheld { 0..0 } else { node.range.clone() } });
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::names;

    #[test]
    fn a_file_is_named_by_its_whole_name() {
        assert!(names("dot.png", "dot.png") && names("./dot.png", "dot.png") && names("<img src=dot.png>", "dot.png"));
        assert!(names("a/dot.png#x", "a/dot.png"));
        assert!(!names("polka-dot.png", "dot.png") && !names("a/dot.png", "dot.png") && !names("dot.pn", "dot.png"));
    }
}
