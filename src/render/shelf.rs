//! The catalogue's place among the pages: its shelves, their members, and the way from one to the next.

use serde::Serialize;

use super::Rendering;
use super::matter;
use super::pages::{ChapterContext, line};
use crate::chart::Drawing;
use crate::parse::{Chapter, Shelf};
use crate::workspace::extension;

/// The style of these pages, which only a book with a catalogue has.
pub(super) const STYLE: &str = "catalogue.css";

/// A member of a shelf as the page of the shelf shows it.
#[derive(Serialize)]
pub(super) struct MemberContext<'a> {
    number: &'a str,
    title: &'a str,
    summary: &'a str,
    href: String,
    /// The drawing that stands for it, if there is one.
    image: Option<&'a str>,
    /// What the drawing is of, as a class.
    shelf: &'static str,
    /// Whether it is a square of four sets, of which one is enough.
    four: bool,
}

/// The pages of the shelves; the one that the page `current` belongs to is marked.
pub(super) fn shelves<'a>(
    rendering: &Rendering<'a>,
    current: Option<usize>,
) -> impl Iterator<Item = ChapterContext<'a>> {
    let chapters = &rendering.course.chapters;
    let here = current.and_then(|index| chapters.get(index)).and_then(|chapter| chapter.shelf);
    let shelves = chapters.iter().enumerate().filter(|(_, chapter)| chapter.shelf.is_some() && !chapter.member);
    shelves.map(move |(index, chapter)| line(rendering, index, chapter.shelf == here))
}

/// The pages before and behind a page: of a member its neighbours on the shelf, else the next that is no member.
pub(super) fn neighbours(chapters: &[Chapter], index: usize) -> (Option<usize>, Option<usize>) {
    let Some(chapter) = chapters.get(index) else { return (None, None) };
    let along = |other: &usize| {
        chapters
            .get(*other)
            .is_some_and(|other| if chapter.member { other.shelf == chapter.shelf } else { !other.member })
    };
    ((0..index).rev().find(along), (index + 1..chapters.len()).find(along))
}

/// The page of the shelf that a page is a member of.
pub(super) fn above(chapters: &[Chapter], index: usize) -> Option<usize> {
    let shelf: Shelf = chapters.get(index).filter(|chapter| chapter.member)?.shelf?;
    chapters.iter().position(|chapter| chapter.shelf == Some(shelf) && !chapter.member)
}

/// The members of the shelf that a page is of; none of any other page.
pub(super) fn members<'a>(rendering: &'a Rendering<'_>, index: usize) -> Vec<MemberContext<'a>> {
    let chapters = &rendering.course.chapters;
    let Some(shelf) = chapters.get(index).filter(|chapter| !chapter.member).and_then(|chapter| chapter.shelf) else {
        return Vec::new();
    };
    let own = chapters.iter().enumerate().filter(|(_, chapter)| chapter.member && chapter.shelf == Some(shelf));
    own.map(|(at, chapter)| {
        let exhibit = stands_for(rendering, at, chapter);
        MemberContext {
            number: &chapter.number,
            title: &chapter.front.title,
            summary: &chapter.front.summary,
            href: rendering.href(at),
            image: exhibit
                .and_then(|exhibit| matter::images(rendering, exhibit).find(|path| extension(path) == Some("svg"))),
            shelf: shelf.name(),
            four: shelf == Shelf::Samplers
                && exhibit.is_some_and(|exhibit| is_square(&rendering.shown[exhibit].drawing)),
        }
    })
    .collect()
}

/// The exhibit that stands for a page, as an index into the plan.
fn stands_for(rendering: &Rendering<'_>, index: usize, chapter: &Chapter) -> Option<usize> {
    let id = &chapter.front.picture.as_ref()?.id;
    rendering.plan.exhibits.iter().position(|exhibit| exhibit.chapter == index && exhibit.id == *id)
}

/// Whether a drawing is about as high as it is wide.
fn is_square(drawing: &Drawing) -> bool {
    drawing.figure().is_some_and(|figure| figure.height > 0.9 * figure.width)
}
