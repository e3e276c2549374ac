//! Terms: defined once, linked where they are used, listed in the index of terms. The cases `terms` and `wrong-term` hold the whole text.

use crate::course::{Course, small};

/// The pages of the case `terms`: a page's text by its name.
fn page(course: &Course, name: &str) -> String {
    String::from_utf8(course.compose(2).book.files[name].clone()).unwrap()
}

#[test]
fn a_use_leads_to_the_one_definition() {
    let course = Course::case("terms");
    let (words, uses) = (page(&course, "words.html"), page(&course, "uses.html"));
    assert_eq!(words.matches("<dfn id=\"term-stratum\"><em>strata</em></dfn>").count(), 1);
    assert!(words.contains("<a class=\"term\" href=\"#term-stratum\">a stratum</a>"));
    assert!(uses.contains("<a class=\"term\" href=\"words.html#term-stratum\">stratum</a>"));
    // A key of its own, a formula, a digit, and a definition in a caption.
    assert!(words.contains("<dfn id=\"term-owen\"><strong>Owen’s scrambling</strong></dfn>"));
    assert!(
        words.contains("<dfn id=\"term-t-m-d-net\"><span class=\"held\"><math>")
            && uses.contains("words.html#term-t-m-d-net")
    );
    assert!(words.contains("<dfn id=\"term-2-opt\">2-opt</dfn>"));
    assert!(words.contains("<dfn id=\"term-the-caption-s-strata\">"));
    // The caption stands in the index of exhibits again, without the definition.
    let exhibits = page(&course, "exhibits.html");
    assert!(exhibits.contains("Points in <em>the caption’s strata</em>, by jittered sampling."));
    // A place by hand leads there too; an escaped bracket makes no link.
    assert!(uses.contains("href=\"words.html#term-stratum\">a term</a>") && uses.contains("[x](define:y)"));
}

#[test]
fn the_index_is_in_the_order_of_the_alphabet() {
    let index = page(&Course::case("terms"), "terms.html");
    let heads = index.split("<dt>").skip(1).map(|entry| entry.split("</a>").next().unwrap());
    let heads: Vec<&str> = heads.map(|head| head.split_once("\">").unwrap().1).collect();
    assert_eq!(heads[0], "2-opt");
    assert_eq!(heads[1..6], ["a fold", "cell", "discrepancy", "estimator", "jittered sampling"]);
    assert_eq!((heads[6], heads[7]), ("Owen’s scrambling", "stratum"));
    assert!(
        heads[8].starts_with("<span class=\"held\"><math>")
            && heads[9..] == ["the caption’s strata", "variance", "Ähnliches"]
    );
    let letters = index.split("<h2 id=\"").skip(1).map(|letter| letter.split('"').next().unwrap());
    let letters: Vec<&str> = letters.collect();
    let expected = ["digits", "a", "c", "d", "e", "j", "o", "s", "t", "v", "ä"];
    assert_eq!(letters.len(), expected.len());
    assert!(letters.iter().zip(expected).all(|(id, letter)| id.trim_start_matches("letter-") == letter), "{letters:?}");
}

#[test]
fn the_index_names_the_sections_of_definition_and_use_once() {
    let index = page(&Course::case("terms"), "terms.html");
    let entry = |key: &str| {
        let start = index.find(&format!("<dt><a href=\"words.html#term-{key}\">")).unwrap();
        index[start..].split("</div>").next().unwrap().to_owned()
    };
    let estimator = entry("estimator");
    assert!(estimator.contains("href=\"words.html#term-estimator\">Chapter 1</a>; used in <a"), "{estimator}");
    // Used twice in 2.1, and in the definition of 1.1.1.
    let uses = "<a href=\"words.html#formulas\">1.1.1</a>, <a href=\"uses.html#a-section\">2.1</a></dd>";
    assert!(estimator.contains(uses), "{estimator}");
    // A use before the first section, and one in a caption in the section of the definition's subsection.
    let jittered = entry("jittered-sampling");
    assert!(jittered.contains(">Section 1.1</a>; used in <a href=\"words.html#formulas\">1.1.1</a>"), "{jittered}");
    assert!(jittered.contains("<a href=\"uses.html\">Chapter 2</a></dd>"), "{jittered}");
    // A note counts where it stands in the file, a title of a callout where the callout stands.
    assert!(entry("discrepancy").contains(">Section 1.1.1</a>") && entry("stratum").contains(">2.2</a>"));
}

#[test]
fn a_book_without_terms_has_no_index_of_them() {
    let course = small();
    let without = course.compose(2).book.files;
    assert!(!without.contains_key("terms.html"));
    assert!(without.values().all(|bytes| !String::from_utf8_lossy(bytes).contains("terms.html")));
    course.edit("chapters/01-one.md", "Some prose.", "Some [*prose*](define:).");
    let with = course.compose(2).book.files;
    assert!(with.contains_key("terms.html"));
    let linked = |page: &str| String::from_utf8_lossy(&with[page]).contains("<a href=\"terms.html\"");
    assert!(linked("index.html") && linked("one.html") && linked("exhibits.html"));
    course.write("chapters/02-terms.md", "+++\ntitle = \"Terms\"\nsummary = \"A page of that name.\"\n+++\n");
    assert!(course.say(&["check"]).err.contains("which is that of the book itself"));
}
