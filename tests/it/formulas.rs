//! The formulas of the case `formulas`, which has every formula of the lecture: the golden case holds the whole text, this what it must mean.

use crate::course::Course;

fn page(name: &str) -> String {
    let composed = Course::case("formulas").compose(2);
    assert!(composed.diagnostics.is_empty(), "{:?}", composed.diagnostics);
    String::from_utf8(composed.book.files[name].clone()).unwrap()
}

/// The formulas of a page, in order.
fn formulas(page: &str) -> Vec<&str> {
    page.split("<math").skip(1).map(|part| part.split("</math>").next().unwrap()).collect()
}

/// The formula with this label.
fn labelled<'a>(page: &'a str, id: &str) -> &'a str {
    let start = page.find(&format!("id=\"{id}\"")).unwrap_or_else(|| panic!("no {id}"));
    formulas(&page[start..])[0]
}

#[test]
fn every_formula_is_there_and_whole() {
    for (name, expected) in [("lecture.html", 51), ("more.html", 10)] {
        let page = page(name);
        let found = formulas(&page);
        assert_eq!(found.len(), expected, "{name}");
        for formula in found {
            for wrong in ["merror", "\\", "#1", "\u{fffd}"] {
                assert!(!formula.contains(wrong), "{name}: `{wrong}` in {formula}");
            }
            for element in ["mrow", "mfrac", "msup", "msub", "munderover", "mtable", "mtr", "mtd", "msqrt"] {
                let opened =
                    formula.matches(&format!("<{element}>")).count() + formula.matches(&format!("<{element} ")).count();
                assert_eq!(opened, formula.matches(&format!("</{element}>")).count(), "{element} in {formula}");
            }
        }
    }
}

#[test]
fn cases_sums_limits_and_matrices_have_their_structure() {
    let (lecture, more) = (page("lecture.html"), page("more.html"));
    let canonical = labelled(&lecture, "eq-canonical");
    assert!(canonical.contains(">{</mo>") && canonical.matches("<mtr>").count() == 2, "{canonical}");
    assert!(canonical.contains("<mtext>otherwise.</mtext>"), "words stay words: {canonical}");
    let law = labelled(&lecture, "eq-strong-law");
    // The limit and the sum have what stands below and above them there.
    assert!(law.contains("<munder><mo") || law.contains("<munder><mi"), "{law}");
    assert!(law.contains("<munderover><mo"), "{law}");
    assert_eq!(labelled(&lecture, "eq-properties").matches("<mtr>").count(), 3);
    let matrices = labelled(&more, "eq-matrix");
    assert_eq!((matrices.matches("<mtable").count(), matrices.matches("<mtr>").count()), (4, 9), "{matrices}");
    assert!(labelled(&more, "eq-star").contains("<munder>"));
}

#[test]
fn macros_stand_for_what_the_course_says() {
    let (lecture, more) = (page("lecture.html"), page("more.html"));
    let mean = labelled(&lecture, "eq-mean");
    assert!(mean.contains(">E</mo>"), "{mean}");
    assert!(labelled(&lecture, "eq-cdf").contains(">Prob</mo>"));
    // A macro with an argument.
    let star = labelled(&more, "eq-star");
    assert!(star.contains('‖') || star.contains('∥'), "{star}");
}

#[test]
fn equations_have_numbers_and_references_lead_to_them() {
    let (lecture, more) = (page("lecture.html"), page("more.html"));
    assert!(lecture.contains("id=\"eq-hammersley\"") && lecture.contains("href=\"#eq-hammersley\">(1.14)</a>"));
    assert!(lecture.contains("href=\"#eq-cdf\">Equation\u{a0}1.1</a>"));
    assert!(more.contains("href=\"lecture.html#eq-mean\">Equation\u{a0}1.6</a>"));
    // A formula without a label has no number.
    assert_eq!(lecture.matches("class=\"equation-number\"").count(), 14);
    assert_eq!(lecture.matches("<div class=\"equation").count(), 17);
}
