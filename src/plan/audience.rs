//! The plan of the students' book: nothing that stands in solutions, and the numbers of the whole book.

use super::{Memo, Plan, planned};
use crate::diag::{Code, Diagnostic};
use crate::parse::Course;
use crate::workspace::Workspace;

/// The plan of `students`, the course without its solutions, whose `whole` plan gave `told`.
///
/// Figures, equations and exercises have the numbers of the whole book, so that everybody means the same by `Figure 2.7`; where
/// solutions have some of their own, students meet a gap. What the rest of the text takes from solutions is told.
pub fn for_students(
    students: &Course,
    workspace: &Workspace,
    whole: &Plan,
    told: &[Diagnostic],
) -> (Plan, Vec<Diagnostic>) {
    let (plan, diagnostics) = planned(students, Some(&whole.labels), workspace, &mut Memo::default());
    // What was right with the solutions and is wrong without them refers to them.
    let new = diagnostics.into_iter().filter(|diagnostic| !told.contains(diagnostic));
    let withheld = new.map(|diagnostic| Diagnostic {
        code: Code::Withheld,
        message: format!("for students: {}", diagnostic.message),
        label: Some("this needs a solution".to_owned()),
        help: vec![
            "it stands in a solution, which students do not get: move it out of there, or this text into a solution"
                .to_owned(),
        ],
        ..diagnostic
    });
    (plan, withheld.collect())
}
