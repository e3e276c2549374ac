//! The index of the search: what it holds, how large it is, and that it is the same each time. What a question finds in it is tested in
//! `tests/browser/search-match.mjs`.

use serde_json::Value;
use workbook::workspace::extension;

use crate::course::{Course, small};

/// The most bytes that the index of such a case may have.
const BUDGET: usize = 16_000;

fn script(course: &Course) -> String {
    let composed = course.compose(2);
    String::from_utf8(composed.book.files["assets/search-index.js"].clone()).unwrap()
}

/// The object that the script hands over.
fn index(script: &str) -> Value {
    let object = script.strip_prefix("workbook.search.load(").and_then(|rest| rest.strip_suffix(");\n")).unwrap();
    serde_json::from_str(object).unwrap()
}

/// The entries as `kind|page#id|number|title|more`.
fn entries(index: &Value) -> Vec<String> {
    let name = |list: &str, at: &Value| index[list][at.as_u64().unwrap() as usize].as_str().unwrap().to_owned();
    let entry = |row: &Value| {
        let text = |at: usize| row[at].as_str().unwrap_or_default();
        let (kind, page) = (name("kinds", &row[0]), name("pages", &row[1]));
        format!("{kind}|{page}#{}|{}|{}|{}", text(2), text(3), text(4), text(5))
    };
    index["entries"].as_array().unwrap().iter().map(entry).collect()
}

/// The words of the chapters' text.
fn words(index: &Value) -> Vec<String> {
    let mut before = String::new();
    let coded = index["words"].as_str().unwrap().split(' ').filter(|coded| !coded.is_empty());
    let mut found: Vec<String> = coded
        .map(|coded| {
            let shared = usize::from_str_radix(&coded[..1], 36).unwrap();
            before = before.chars().take(shared).chain(coded[1..].chars()).collect();
            before.clone()
        })
        .collect();
    found.extend(index["common"].as_str().unwrap().split_whitespace().map(str::to_owned));
    found
}

#[test]
fn everything_with_a_name_is_in_it() {
    let index = index(&script(&Course::case("everything")));
    let found = entries(&index);
    for expected in [
        "Chapter|experiments.html#|2|Experiments|Every kind, small.",
        "Section|experiments.html#sec-curves|2.1|Curves|",
        "Figure|experiments.html#fig-curve|2.1|The curve e^sin 3x^2 of Equation 1.1, as in [2].|exp-sin",
        "Table|experiments.html#tbl-inverses|2.2|Radical inverses in base 3.|",
        "Listing|experiments.html#lst-inverse|2.1|How an entry is found, for Table 2.2.|src/catalogue.rs",
        "Section|prose.html#sec-callouts|1.5|Callouts|",
        "Equation|prose.html#eq-estimator|1.1||",
        "Definition|prose.html#def-mean|1.1|Mean|",
        "Exercise|prose.html#exr-halve|1.1|Halve the error|",
        "Exercise|prose.html#exercise-1-2|1.2||One without a label.",
        "Sampler|experiments.html#fig-errors||Halton|halton: Radical inverses of the index in the first d primes.",
        "Page|exhibits.html#||Exhibits|Every figure and table of the book, with its place.",
    ] {
        assert!(found.iter().any(|entry| entry == expected), "{expected}\nis not in\n{}", found.join("\n"));
    }
    // A sampler stands with its name at the first exhibit that uses it; kinds are on their own page.
    assert!(found.iter().any(|entry| entry.starts_with("Kind of experiment|kinds.html#convergence|")));
    // The text of paragraphs, callouts and footnotes, without accents and in lower case; numbers alone are no words.
    let words = words(&index);
    for word in ["emphasis", "strength", "quotation", "samples", "important"] {
        assert!(words.iter().any(|known| known == word), "{word} is not in {words:?}");
    }
    assert!(!words.iter().any(|word| word.chars().all(char::is_numeric)), "{words:?}");
}

#[test]
fn terms_lead_to_their_definitions() {
    let found = entries(&index(&script(&Course::case("terms"))));
    assert!(
        found.iter().any(|entry| entry == "Term|words.html#term-stratum||stratum|"
            || entry == "Term|words.html#term-stratum||strata|"),
        "{}",
        found.join("\n")
    );
    assert!(
        found.iter().any(|entry| entry.starts_with("Term|words.html#term-owen||Owen’s scrambling|")),
        "{}",
        found.join("\n")
    );
    assert!(found.iter().any(|entry| entry.starts_with("Term|words.html#term-the-caption-s-strata|")), "in a caption");
    assert!(found.iter().any(|entry| entry == "Page|terms.html#||Index of terms|Every term, with the place of its definition and the sections that use it."));
}

#[test]
fn every_entry_leads_somewhere() {
    for case in ["everything", "terms", "folds", "appendices"] {
        let composed = Course::case(case).compose(2);
        let script = std::str::from_utf8(&composed.book.files["assets/search-index.js"]).unwrap();
        let found = entries(&index(script));
        assert!(found.len() > 20, "{case}");
        for entry in found {
            let address = entry.split('|').nth(1).unwrap();
            let (page, id) = address.split_once('#').unwrap();
            let html = std::str::from_utf8(&composed.book.files[page]).unwrap();
            assert!(id.is_empty() || html.contains(&format!("id=\"{id}\"")), "{case}: {entry}");
        }
    }
}

#[test]
fn it_has_the_same_bytes_each_time() {
    let course = Course::case("everything");
    let first = course.compose(1).book.files["assets/search-index.js"].clone();
    for threads in [2, 4] {
        assert!(course.compose(threads).book.files["assets/search-index.js"] == first, "on {threads} threads");
    }
}

#[test]
fn what_is_taken_out_of_the_course_is_not_in_it() {
    let course = small();
    course.edit(
        "chapters/01-one.md",
        "Some prose.",
        "Some prose.\n\n> [!EXERCISE] Try\n> Do it.\n>\n> > [!SOLUTION]\n> > The xylophone.",
    );
    let with = script(&course);
    assert!(with.contains("0xylophone") && entries(&index(&with)).iter().any(|entry| entry.starts_with("Exercise|")));
    course.edit("chapters/01-one.md", "> > The xylophone.", "> > Else.");
    assert!(!script(&course).contains("xylophone"));
}

#[test]
fn it_is_small() {
    let course = Course::case("everything");
    let composed = course.compose(2);
    let size = |path: &str| composed.book.files[path].len();
    let pages: usize =
        composed.book.files.keys().filter(|path| extension(path) == Some("html")).map(|path| size(path)).sum();
    let own = size("assets/search-index.js");
    assert!(own < BUDGET && 12 * own < pages, "{own} bytes for pages of {pages}");
}
