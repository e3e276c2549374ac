//! Diagnostics: what is wrong, where, and what to do about it.
//!
//! Every stage returns its value *and* its diagnostics, so that one run reports every mistake. Only `cli` prints them.

use std::ops::Range;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Severity {
    /// Worth knowing; the book is built.
    Warning,
    /// The book is not built.
    Error,
}

/// A place in a file of the course.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// The file, from the course's root, with `/` between folders.
    #[serde(with = "shared_text")]
    pub file: Arc<str>,
    /// The bytes in that file.
    pub range: Range<usize>,
}

/// A shared text is written as the text that it is.
mod shared_text {
    use std::sync::Arc;

    use serde::{Deserialize, Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(text: &Arc<str>, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(text)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Arc<str>, D::Error> {
        String::deserialize(deserializer).map(Arc::from)
    }
}

/// One mistake, with its place and what to do.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Diagnostic {
    /// Which kind of mistake.
    pub code: Code,
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// Where, if it is in a file.
    pub place: Option<Place>,
    /// What the marked place is, shown beside the mark.
    pub label: Option<String>,
    /// What to do, one line each.
    pub help: Vec<String>,
}

impl Diagnostic {
    /// An error of kind `code`.
    pub fn error(code: Code, message: impl Into<String>) -> Self {
        Self { code, severity: Severity::Error, message: message.into(), place: None, label: None, help: Vec::new() }
    }

    /// A warning of kind `code`.
    pub fn warning(code: Code, message: impl Into<String>) -> Self {
        Self { severity: Severity::Warning, ..Self::error(code, message) }
    }

    /// At the bytes `range` of `file`.
    #[must_use]
    pub fn at(mut self, file: &Arc<str>, range: Range<usize>) -> Self {
        self.place = Some(Place { file: Arc::clone(file), range });
        self
    }

    /// At `place`.
    #[must_use]
    pub fn at_place(mut self, place: &Place) -> Self {
        self.place = Some(place.clone());
        self
    }

    /// With a few words beside the mark.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = Some(label.into());
        self
    }

    /// With a line that says what to do.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help.push(help.into());
        self
    }

    /// With a line that says what to do, if there is one.
    #[must_use]
    pub fn help_if(self, help: Option<String>) -> Self {
        match help {
            Some(help) => self.help(help),
            None => self,
        }
    }
}

/// Whether any of `diagnostics` keeps the book from being built.
pub fn any_error(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}

macro_rules! codes {
    ($($(#[doc = $doc:literal])+ $name:ident = $id:literal;)+) => {
        /// The kinds of mistake. A code's number never changes its meaning.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
        pub enum Code { $($(#[doc = $doc])+ $name,)+ }

        impl Code {
            /// Every code, in the order of the numbers.
            pub const ALL: &'static [Code] = &[$(Code::$name,)+];

            /// The code as printed, e.g. `W0101`.
            pub fn id(self) -> &'static str {
                match self { $(Code::$name => $id,)+ }
            }

            /// What the code means.
            pub fn meaning(self) -> &'static str {
                match self { $(Code::$name => concat!($($doc,)+).trim_ascii(),)+ }
            }
        }
    };
}

codes! {
    // The course as files.
    /// The folder holds no course.
    NoCourse = "W0001";
    /// A file is not UTF-8.
    NotUtf8 = "W0002";
    /// A file cannot be read.
    Unreadable = "W0003";
    /// A file that a chapter includes is missing.
    MissingInclude = "W0004";
    /// A file or folder cannot be written.
    Unwritable = "W0009";
    /// The folder to build into holds something else.
    NotABook = "W0010";
    /// A preview cannot be served at an address.
    Address = "W0013";
    /// `workbook.toml` is broken.
    Configuration = "W0005";
    /// A chapter is listed but missing, or there but not listed.
    ChapterOrder = "W0006";
    /// The bibliography is broken.
    Bibliography = "W0007";
    /// A template is broken.
    Template = "W0008";
    /// A file that would be written is there already.
    Exists = "W0012";
    /// Git was asked, and could not tell.
    History = "W0011";
    // What authors write.
    /// TOML that cannot be read.
    Toml = "W0101";
    /// A key that nothing knows.
    UnknownKey = "W0102";
    /// A key that must be there is missing.
    MissingKey = "W0103";
    /// A value of the wrong type.
    WrongType = "W0104";
    /// A value outside of its range.
    OutOfRange = "W0105";
    /// A name that no catalogue has.
    UnknownName = "W0106";
    /// A count that the sampler cannot give.
    Count = "W0107";
    /// A combination that cannot be.
    Combination = "W0108";
    /// An expression that cannot be read.
    Expression = "W0109";
    /// An id that is malformed.
    BadId = "W0110";
    /// An id that is used twice.
    DuplicateId = "W0111";
    /// A reference to nothing.
    MissingTarget = "W0112";
    /// A citation of a work that the bibliography does not have.
    UnknownCitation = "W0113";
    /// Math that cannot be read.
    Math = "W0114";
    /// A figure without words for those who cannot see it.
    MissingAlt = "W0115";
    /// A value in the prose that no experiment gives.
    UnknownValue = "W0116";
    /// A number format that cannot be read.
    Format = "W0117";
    /// A claim that is malformed.
    BadClaim = "W0118";
    /// A listing of an item that the library does not have.
    UnknownItem = "W0119";
    /// Markup that the course does not allow.
    Markup = "W0120";
    /// A number in the prose that could be computed.
    TypedNumber = "W0121";
    /// An entry of `[given]` that nothing uses.
    UnusedGiven = "W0122";
    /// A reference to what students do not get.
    Withheld = "W0123";
    // What was computed.
    /// An experiment that failed.
    Failed = "W0201";
    /// A claim that is false.
    FalseClaim = "W0202";
    /// A result that drifted from the lock.
    Drift = "W0203";
    /// The lock is missing or broken.
    Lock = "W0204";
    /// A file of points that cannot be read or measured.
    Points = "W0205";
    // The book as a reader meets it.
    /// A link to nothing.
    BrokenLink = "W0301";
    /// An id that stands twice on a page.
    RepeatedId = "W0302";
    /// A page that asks another host for something.
    ForeignRequest = "W0303";
    /// A page, a file or a site that is heavier than its budget.
    Heavy = "W0304";
}
