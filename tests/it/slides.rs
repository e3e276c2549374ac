//! Marks for slides and speaker notes, and the scripts of the slides: readers meet neither, and only chapters have them.

use crate::course::Course;

fn page(name: &str) -> String {
    let composed = Course::case("slides").compose(2);
    assert!(composed.diagnostics.is_empty(), "{:?}", composed.diagnostics);
    String::from_utf8(composed.book.files[name].clone()).unwrap()
}

#[test]
fn marks_are_on_the_page_and_hidden() {
    let page = page("lecture.html");
    let marks: Vec<&str> = page.split("<aside ").skip(1).filter_map(|rest| rest.split('>').next()).collect();
    let expected = [
        "class=\"callout callout-notes\" hidden",
        "class=\"callout callout-slide\" hidden",
        "class=\"callout callout-slide\" hidden",
    ];
    assert_eq!(marks, expected);
    assert!(page.contains("<span class=\"callout-name\">In short</span>"));
    assert!(page.contains("Ask who has seen this before."));
}

#[test]
fn only_chapters_have_slides() {
    for name in ["present.js", "present.css"] {
        let link = format!("assets/{name}\"");
        assert!(page("lecture.html").contains(&link), "{name}");
        assert!(!page("index.html").contains(&link), "{name}");
        assert!(!page("exhibits.html").contains(&link), "{name}");
    }
    // What only a lecture needs is loaded when one begins.
    let page = page("lecture.html");
    let opener = String::from_utf8(Course::case("slides").compose(2).book.files["assets/present.js"].clone()).unwrap();
    for name in ["slides.js", "speaker.js", "deck.js", "deck.css"] {
        assert!(!page.contains(&format!("assets/{name}")), "{name}");
        assert!(opener.contains(&format!("\"{name}\"")), "{name}");
    }
}

#[test]
fn scripts_of_slides_are_classic_and_ask_nobody() {
    let composed = Course::case("slides").compose(2);
    for name in ["slides.js", "speaker.js", "deck.js", "present.js"] {
        let script = String::from_utf8(composed.book.files[&format!("assets/{name}")].clone()).unwrap();
        for word in ["fetch(", "import(", "import ", "export ", "XMLHttpRequest", "://", "eval("] {
            assert!(!script.contains(word), "{name} has `{word}`");
        }
        assert!(script.lines().count() < 400, "{name}");
    }
}

#[test]
fn misplaced_marks_are_told() {
    let composed = Course::case("wrong-slides").compose(2);
    let told: Vec<&str> = composed.diagnostics.iter().map(|diagnostic| diagnostic.message.as_str()).collect();
    for message in [
        "these notes are empty",
        "a callout `[!SLIDE]` has no number to refer to",
        "a numbered equation stands within a mark `[!NOTES]`, which readers do not see",
        "a callout with a number stands within a mark `[!NOTES]`, which readers do not see",
        "a mark `[!SLIDE]` stands by itself",
        "a mark `[!NOTES]` stands by itself",
        "there is no callout `[!SLIDES]`",
    ] {
        assert_eq!(told.iter().filter(|told| **told == message).count(), 1, "{message}: {told:?}");
    }
    assert_eq!(told.len(), 7, "{told:?}");
}
