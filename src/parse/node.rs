//! What a chapter consists of: markdown's own events, and what the workbook adds to them, each with its place.

use std::ops::Range;

use pulldown_cmark::Event;

use super::source_map::SourceMap;
use crate::integrands::Calculation;

/// A piece of a chapter and the bytes of the file that it was read from.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// What it is.
    pub what: What,
    /// Where it stands in the chapter's file.
    pub range: Range<usize>,
}

/// What a piece of a chapter is.
#[derive(Debug, Clone, PartialEq)]
pub enum What {
    /// An event of plain markdown.
    Markdown(Event<'static>),
    /// A formula within a line.
    Formula(Formula),
    /// A formula on lines of its own.
    Equation {
        /// The formula.
        formula: Formula,
        /// Its `eq-` label, if it is numbered.
        label: Option<Label>,
    },
    /// The experiment with this index in the chapter.
    Experiment(usize),
    /// The listing with this index in the chapter.
    Listing(usize),
    /// A number that an experiment gives.
    Value(ValueUse),
    /// A number that the build computes from such numbers.
    Computed(Computed),
    /// A reference to a label anywhere in the book.
    Reference(String),
    /// A term where it is defined, or where it is used.
    Term(Term),
    /// Citations in one pair of brackets.
    Citation(Vec<Cited>),
    /// The start of a callout.
    CalloutStart(Callout),
    /// The end of a callout.
    CalloutEnd(CalloutKind),
}

/// A formula in LaTeX.
#[derive(Debug, Clone, PartialEq)]
pub struct Formula {
    /// The LaTeX between the dollars.
    pub tex: String,
    /// Where each byte of it stands in the file.
    pub map: SourceMap,
}

/// An id that references can name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The id, e.g. `eq-estimator`.
    pub id: String,
    /// Where it stands in the chapter's file.
    pub range: Range<usize>,
}

/// A number in prose that is taken from a result: `` `=fig-rmse.slope.independent:.2` ``.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ValueUse {
    /// The exhibit's id.
    pub exhibit: String,
    /// The value's dotted name.
    pub name: String,
    /// How it is written, as the author gave it after the colon; empty for the default.
    pub format: String,
}

/// A number in prose that is computed: `` `=(sqrt([fig-a.variance]/16)):.3` ``.
#[derive(Debug, Clone, PartialEq)]
pub struct Computed {
    /// The expression; its names are those of values, `fig-a.variance`.
    pub calculation: Calculation,
    /// Where the expression starts in the file, if it stands there as it was read.
    pub start: Option<usize>,
    /// How the number is written, as in [`ValueUse`].
    pub format: String,
}

impl Computed {
    /// The bytes of the file where `range` of the expression stands; the whole piece, at `piece`, if that cannot be said.
    pub fn place(&self, range: &Range<usize>, piece: &Range<usize>) -> Range<usize> {
        self.start.map_or(piece.clone(), |start| start + range.start..start + range.end)
    }
}

/// A word of the subject: a link to `define:` or `term:`.
#[derive(Debug, Clone, PartialEq)]
pub struct Term {
    /// Whether it is defined here.
    pub defines: bool,
    /// What stands behind the colon of its address; may be empty.
    pub key: String,
    /// The title of its link, which then is the head-word; may be empty.
    pub title: String,
    /// What a reader sees.
    pub words: Vec<Node>,
}

/// One work of a citation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cited {
    /// Its key in the bibliography.
    pub key: String,
    /// Where in the work, e.g. `p. 12`; may be empty.
    pub locator: String,
    /// Where the key stands in the chapter's file.
    pub range: Range<usize>,
}

/// A callout's head.
#[derive(Debug, Clone, PartialEq)]
pub struct Callout {
    /// What kind it is.
    pub kind: CalloutKind,
    /// Its label, if it has one.
    pub label: Option<Label>,
    /// Its title within the line of the mark; may be empty.
    pub title: Vec<Node>,
}

macro_rules! callouts {
    ($($variant:ident $name:literal $title:literal $prefix:expr, $folded:literal;)+) => {
        /// The kinds of callout.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum CalloutKind { $(#[doc = concat!("`[!", $name, "]`.")] $variant,)+ }

        impl CalloutKind {
            /// Every kind.
            pub const ALL: &'static [CalloutKind] = &[$(CalloutKind::$variant,)+];

            /// The name between the brackets, e.g. `NOTE`.
            pub fn name(self) -> &'static str { match self { $(CalloutKind::$variant => $name,)+ } }

            /// The title that a reader sees, e.g. `Note`.
            pub fn title(self) -> &'static str { match self { $(CalloutKind::$variant => $title,)+ } }

            /// The prefix of its labels if it is numbered, e.g. `exr`.
            pub fn prefix(self) -> Option<&'static str> { match self { $(CalloutKind::$variant => $prefix,)+ } }

            /// Whether the reader opens it by choice.
            pub fn folded(self) -> bool { match self { $(CalloutKind::$variant => $folded,)+ } }
        }
    };
}

callouts! {
    Note "NOTE" "Note" None, false;
    Tip "TIP" "Tip" None, false;
    Important "IMPORTANT" "Important" None, false;
    Warning "WARNING" "Warning" None, false;
    Caution "CAUTION" "Caution" None, false;
    Goals "GOALS" "Learning goals" None, false;
    Remember "REMEMBER" "What to remember" None, false;
    Bug "BUG" "Spot the bug" None, false;
    Definition "DEFINITION" "Definition" Some("def"), false;
    Exercise "EXERCISE" "Exercise" Some("exr"), false;
    Hint "HINT" "Hint" None, true;
    Solution "SOLUTION" "Solution" None, true;
    Slide "SLIDE" "Slide" None, false;
    Notes "NOTES" "Speaker notes" None, false;
}

impl CalloutKind {
    /// Whether it is for lectures: readers of the page do not see it.
    pub fn is_for_lectures(self) -> bool {
        matches!(self, CalloutKind::Slide | CalloutKind::Notes)
    }
}
