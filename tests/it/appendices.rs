//! Appendices: chapters with letters, after those with numbers. The case `appendices` holds the whole text.

use crate::course::{Course, small};

fn page(course: &Course, name: &str) -> String {
    String::from_utf8(course.compose(2).book.files[name].clone()).unwrap()
}

#[test]
fn an_appendix_has_a_letter_wherever_a_chapter_has_a_number() {
    let course = Course::case("appendices");
    let notation = page(&course, "notation.html");
    assert!(notation.contains("<p class=\"chapter-number\">Appendix A</p>"));
    assert!(notation.contains("<h2 id=\"sec-notation\"><span class=\"number\">A.1</span> Symbols"));
    assert!(notation.contains("<span class=\"number\">A.1.1</span> And more"));
    assert!(notation.contains(">(A.1)</a>") && notation.contains(">Definition A.1</a>"));
    assert!(notation.contains(">Figure A.1</a>") && notation.contains("In this appendix"));
    let one = page(&course, "one.html");
    let references = [
        "notation.html#eq-a\">Equation\u{a0}A.1<",
        "#fig-points\">Figure\u{a0}A.1<",
        "#sec-notation\">Section\u{a0}A.1<",
    ];
    assert!(references.iter().all(|reference| one.contains(reference)), "{one}");
    assert!(page(&course, "terms.html").contains("\">Appendix A</a>; used in <a href=\"one.html#sec-one\">1.1</a>"));
}

#[test]
fn appendices_follow_the_chapters_in_every_list() {
    let course = Course::case("appendices");
    let index = page(&course, "index.html");
    let places: Vec<usize> = ["one.html", "two.html", "notation.html", "more.html"]
        .iter()
        .map(|page| index.find(&format!("<a class=\"card\" href=\"{page}\">")).unwrap())
        .collect();
    assert!(places.is_sorted(), "{places:?}");
    assert_eq!(index.matches("<li class=\"appendix\">").count(), 2);
    // Before the first appendix stands the last chapter.
    let notation = page(&course, "notation.html");
    assert!(notation.contains("<link rel=\"prev\" href=\"two.html\">"));
    assert!(notation.contains("<link rel=\"next\" href=\"more.html\">"));
    assert!(page(&course, "two.html").contains("<link rel=\"next\" href=\"notation.html\">"));
    assert!(!page(&course, "more.html").contains("rel=\"next\""));
    let exhibits = page(&course, "exhibits.html");
    assert!(exhibits.contains("<h2 id=\"chapter-A\"><span class=\"number\">A</span>"));
}

#[test]
fn an_appendix_that_is_missing_or_not_listed_is_told() {
    let course = small();
    course.write("chapters/notation.md", "+++\ntitle = \"Notation\"\nsummary = \"Symbols.\"\n+++\n");
    // Without an order every other file is a chapter.
    let configuration = course.read("chapters/workbook.toml");
    course.write("chapters/workbook.toml", format!("{configuration}appendices = [\"notation\"]\n"));
    course.fine(&["check", "--quiet"]).silent();
    assert!(page(&course, "notation.html").contains("Appendix A") && page(&course, "one.html").contains("Chapter 1"));
    course.write(
        "chapters/workbook.toml",
        format!("{configuration}order = [\"01-one\"]\nappendices = [\"notations\"]\n"),
    );
    let told = course.say(&["check"]).err;
    assert!(told.contains("there is no chapter `chapters/notations.md`") && told.contains("did you mean `notation`?"));
    assert!(told.contains("chapters/workbook.toml:4:15"), "{told}");
    assert!(told.contains("the chapter `chapters/notation.md` is not in the book"), "{told}");
}
