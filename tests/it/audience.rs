//! Audiences: the students' book has no byte of a solution, and the numbers of the whole book.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use pulldown_cmark::Event;
use workbook::compose::{Request, check};
use workbook::diag::Code;
use workbook::parse::{self, Audience, CalloutKind, Node, What};
use workbook::workspace;

use crate::course::{Course, PACKAGE, tree};

/// Words, ids and names of files that stand in solutions or in notes for the speaker only, in every way that something can stand there.
const SECRETS: [&str; 33] = [
    "bettong",
    "wallaby",
    "quokka",
    "platypus",
    "echidna",
    "kookaburra",
    "wombat",
    "numbat",
    "bandicoot",
    "dugong",
    "cassowary",
    "Bilby",
    "potoroo",
    "taipan",
    "galah",
    "currawong",
    "brolga",
    "boobook",
    "thylacine",
    "fig-secret",
    "tbl-secret",
    "fig-steps-secret",
    "fig-render-secret",
    "lst-secret",
    "eq-secret",
    "sec-secret",
    "exr-secret",
    "secret-work",
    "hidden-work",
    "Quoll",
    "secret.png",
    "van-der-corput",
    "3.142857",
];

const CONFIGURATION: &str = r#"title = "For two audiences"
authors = ["A. Author"]
bibliography = "works.bib"
typed_numbers = "allowed"
"#;

const WORKS: &str = "@book{open-work,\n author = {Open, A.},\n title = {On questions},\n year = {2001}\n}\n\
    @book{secret-work,\n author = {Bilby, B.},\n title = {On the potoroo},\n year = {2002}\n}\n\
    @book{hidden-work,\n author = {Quoll, Q.},\n title = {On the quoll},\n year = {2003}\n}\n";

const CHAPTER: &str = r#"+++
title = "One"
summary = "The only chapter."
+++

## First

Before, with a [*word*](define:), a note[^open] and a work [@open-work]. ![A dot](dot.png)

$$ a = b $$ {#eq-before}

> [!EXERCISE] Easy {#exr-easy}
> A question.
>
> > [!HINT]
> > A hint.
>
> > [!SOLUTION] The wallaby
> > A quokka, [*platypus*](define:) as in [platypus](term:), by [@secret-work, p. 12], noted[^inner] and again[^outer].
> > ![The echidna](secret.png) ![A dot](dot.png)
> >
> > ## The kookaburra {#sec-secret}
> >
> > $$ \text{wombat} $$ {#eq-secret}
> >
> > > [!EXERCISE] A numbat {#exr-secret}
> > > > [!SOLUTION]
> > > > The bandicoot.
> >
> > | dugong |
> > | --- |
> > | `cassowary` |
> >
> > ```experiment
> > id = "fig-secret"
> > kind = "points"
> > sampler = "van-der-corput"
> > dimensions = 1
> > n = 16
> > caption = "A taipan."
> > alt = "A galah."
> > ```
> >
> > ```experiment
> > id = "tbl-secret"
> > kind = "estimate-table"
> > integrand = "x"
> > sampler = "centred-grid"
> > n = [4, 16]
> > caption = "A currawong."
> > ```
> >
> > ```experiment
> > id = "fig-steps-secret"
> > kind = "shuffle-steps"
> > n = 4
> > caption = "A brolga."
> > ```
> >
> > ```experiment
> > id = "fig-render-secret"
> > kind = "render"
> > scene = "soft-shadows"
> > samplers = ["independent"]
> > n = 4
> > width = 16
> > height = 12
> > reference = 16
> > caption = "Pictures, as in @eq-secret, by @fig-secret."
> > ```
> >
> > ```listing
> > id = "lst-secret"
> > file = "boobook.py"
> > caption = "Code of @sec-secret and @exr-secret."
> > ```
> >
> > Its value is `=(22/7):.6`.
> >
> > [^inner]: The inner thylacine.

## Second

> [!NOTES]
> Ask first what a *bettong* is.

> [!EXERCISE] Hard {#exr-hard}
> Another question.

$$ c = d $$ {#eq-after}

```experiment
id = "fig-after"
kind = "points"
sampler = "jittered"
n = 16
caption = "Points, after @eq-after."

[claims]
"cells.max.jittered" = { equals = 1 }
```

```experiment
id = "tbl-after"
kind = "estimate-table"
integrand = "x"
n = [4, 16]
caption = "Estimates of @exr-hard."
```

[^open]: An open note.
[^outer]: A thylacine[^further].
[^further]: The further thylacine, by [@hidden-work].
"#;

/// A picture of one pixel.
const DOT: &[u8] = &[
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00,
    0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00, 0x00, 0x00, 0x0a, 0x49,
    0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0x00, 0x00, 0x00, 0x02, 0x00, 0x01, 0x48, 0xaf, 0xa4, 0x71, 0x00, 0x00,
    0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
];

fn course() -> Course {
    let course = Course::new(&[
        ("chapters/workbook.toml", CONFIGURATION),
        ("chapters/works.bib", WORKS),
        ("chapters/01-one.md", CHAPTER),
        ("chapters/boobook.py", "print('boobook')\n"),
    ]);
    course.write("chapters/dot.png", DOT);
    course.write("chapters/secret.png", DOT);
    course
}

/// The names and the bytes of a book's files as one text.
fn everything(book: &BTreeMap<String, Vec<u8>>) -> String {
    let file = |(path, bytes): (&String, &Vec<u8>)| format!("{path}\n{}\n", String::from_utf8_lossy(bytes));
    book.iter().map(file).collect::<Vec<_>>().concat()
}

/// What stands between `open` and the next `close`, each time.
fn between<'t>(text: &'t str, open: &'t str, close: &'t str) -> Vec<&'t str> {
    text.split(open).skip(1).filter_map(|rest| rest.split(close).next()).collect()
}

#[test]
fn the_students_book_has_no_byte_of_a_solution() {
    let course = course();
    course.fine(&["build", "--quiet"]).silent();
    course.fine(&["build", "--quiet", "--audience", "student"]).silent();
    let whole = everything(&course.book());
    let students = tree(&course.path("book-student"));
    assert!(students.contains_key("dot.png") && students.contains_key("one.html"));
    let mut leaks = Vec::new();
    for secret in SECRETS {
        assert!(whole.contains(secret), "the test looks for `{secret}`, which stands nowhere");
        for (path, bytes) in &students {
            // The page of kinds and the index of the search tell what every course can ask for.
            let general =
                ["kinds.html", "assets/search-index.js"].contains(&path.as_str()) && secret == "van-der-corput";
            if !general && (path.contains(secret) || String::from_utf8_lossy(bytes).contains(secret)) {
                leaks.push(format!("`{secret}` stands in {path}"));
            }
        }
    }
    assert!(leaks.is_empty(), "{leaks:#?}");
    let students = everything(&students);
    for kept in ["A question.", "A hint.", "An open note.", "On questions", "term-word", "fig-after", "tbl-after"] {
        assert!(students.contains(kept), "`{kept}` is gone");
    }
    assert!(!students.contains("callout-solution\"") && whole.contains("callout-solution\""));
}

#[test]
fn numbers_are_those_of_the_whole_book() {
    let course = course();
    course.fine(&["build", "--quiet"]);
    course.fine(&["build", "--quiet", "--audience", "student"]);
    let (whole, students) = (course.read("book/one.html"), course.read("book-student/one.html"));
    let marks = [
        ("<a class=\"reference\" href=\"#", "</a>"),
        ("<a class=\"equation-number\" href=\"#", "</a>"),
        ("<a class=\"label\" href=\"#", "</a>"),
        ("<section class=\"callout callout-exercise\" id=\"", "</span>"),
        ("<h2 id=\"", "</h2>"),
    ];
    for (open, close) in marks {
        let (all, kept) = (between(&whole, open, close), between(&students, open, close));
        assert!(!kept.is_empty() && kept.len() < all.len(), "{open}");
        let all: BTreeSet<&str> = all.into_iter().collect();
        assert!(kept.iter().all(|kept| all.contains(kept)), "{kept:?} are not among {all:?}");
    }
    for label in ["Figure 1.4", "Table 1.2", "Exercise 1.3", "Equation 1.3"] {
        assert!(students.replace('\u{a0}', " ").contains(label), "{label}");
    }
}

#[test]
fn the_lock_is_of_the_whole_book() {
    let course = course();
    course.fine(&["accept", "--quiet"]);
    course.fine(&["build", "--quiet", "--audience", "student"]).silent();
    course.edit("chapters/01-one.md", "id = \"tbl-after\"", "id = \"tbl-later\"");
    let said = course.fine(&["build", "--quiet", "--audience", "student"]).err;
    assert_eq!(said.matches("W0203").count(), 2, "what students get drifts for them as well: {said}");
    assert!(said.contains("`tbl-after`") && said.contains("`tbl-later`") && !said.contains("secret"), "{said}");
    course.edit("chapters/01-one.md", "id = \"tbl-later\"", "id = \"tbl-after\"");
    course.fine(&["verify", "--quiet"]).silent();
    let said = course.say(&["build", "--quiet", "--audience", "student", "--out", "book"]);
    assert_eq!(said.exit, 2, "{}", said.err);
    assert!(said.err.contains("holds the lock"), "{}", said.err);
}

#[test]
fn the_course_says_for_whom_it_is_and_the_call_has_the_last_word() {
    let course = course();
    course.write("chapters/workbook.toml", format!("{CONFIGURATION}audience = \"student\"\n"));
    course.fine(&["build", "--quiet"]).silent();
    assert!(course.path("book-student/one.html").exists() && !course.path("book").exists());
    course.fine(&["build", "--quiet", "--audience", "instructor"]).silent();
    assert!(course.read("book/one.html").contains("wallaby"));
    // What is asked of single exhibits, and the lock, are of the whole course.
    course.fine(&["run", "fig-secret", "--quiet"]);
    course.fine(&["accept", "--quiet"]);
    assert!(course.read("book/workbook.lock").contains("fig-secret"));
    assert_eq!(course.say(&["build", "--audience", "teacher"]).exit, 2);
}

#[test]
fn mistakes_in_solutions_are_told_to_students_too() {
    let course = course();
    course.edit("chapters/01-one.md", "sampler = \"van-der-corput\"", "sampler = \"van-der-corputt\"");
    let said = course.say(&["check", "--audience", "student", "--quiet"]);
    assert_eq!((said.exit, said.err.matches("W0106").count()), (1, 1), "{}", said.err);
    assert!(!said.err.contains("W0123"), "one mistake is told once: {}", said.err);
}

/// The texts within nodes, with those in titles and terms.
fn texts(nodes: &[Node], into: &mut Vec<String>) {
    for node in nodes {
        match &node.what {
            What::Markdown(Event::Text(text) | Event::Code(text)) => into.push(text.to_string()),
            What::CalloutStart(callout) => texts(&callout.title, into),
            What::Term(term) => texts(&term.words, into),
            What::Equation { formula, .. } | What::Formula(formula) => into.push(formula.tex.clone()),
            _ => {}
        }
    }
}

#[test]
fn nothing_of_this_courses_solutions_reaches_the_students_pages() {
    let request = |audience| Request { root: PACKAGE.into(), threads: 1, cached: false, audience: Some(audience) };
    let whole = check(&request(Audience::Instructor));
    let students = check(&request(Audience::Student));
    let needs: Vec<_> = students.diagnostics.iter().filter(|told| told.code == Code::Withheld).collect();
    assert!(needs.is_empty(), "the text needs what stands in solutions: {needs:#?}");
    // All that rendering is given of chapters, and what it is given of fences.
    let given = format!("{:?}", students.course.chapters.iter().map(|chapter| &chapter.content).collect::<Vec<_>>());
    let mut solutions = 0;
    let (mut secrets, mut open) = (Vec::new(), Vec::new());
    for chapter in &whole.course.chapters {
        let mut depth = 0;
        for node in &chapter.content.nodes {
            let starts =
                matches!(&node.what, What::CalloutStart(callout) if depth > 0 || callout.kind == CalloutKind::Solution);
            solutions += usize::from(starts && depth == 0);
            depth += usize::from(starts);
            texts(std::slice::from_ref(node), if depth > 0 { &mut secrets } else { &mut open });
            depth -= usize::from(depth > 0 && matches!(node.what, What::CalloutEnd(_)));
        }
    }
    // Short words stand in many places, and a few words of a solution in its question.
    secrets.retain(|secret| secret.trim().len() > 24 && !open.iter().any(|open| open.contains(secret.as_str())));
    assert!(solutions > 30 && secrets.len() > 10 * solutions / 2, "{solutions} solutions, {} texts", secrets.len());
    let shown = |secret: &&String| given.contains(format!("{secret:?}").trim_matches('"'));
    let leaked: Vec<_> = secrets.iter().filter(shown).collect();
    assert!(leaked.is_empty(), "{leaked:#?}");
    let kept: BTreeSet<&str> = students.plan.exhibits.iter().map(|exhibit| exhibit.id.as_str()).collect();
    let all: BTreeSet<&str> = whole.plan.exhibits.iter().map(|exhibit| exhibit.id.as_str()).collect();
    let withheld: BTreeSet<&str> = students.withheld.iter().map(String::as_str).collect();
    assert_eq!(all.difference(&kept).copied().collect::<BTreeSet<_>>(), withheld);
    assert!(!withheld.is_empty() && withheld.iter().all(|id| students.plan.labels.target(id).is_none()));
    for id in kept {
        assert_eq!(students.plan.labels.target(id), whole.plan.labels.target(id));
    }
}

#[test]
fn a_course_without_solutions_is_the_same_for_everybody() {
    for case in ["minimal", "steppers", "appendices"] {
        let (loaded, _) = workspace::load(&Path::new(PACKAGE).join("tests/books").join(case));
        let (course, _) = parse::course(parse::configuration(&loaded).0, &loaded, &[]);
        let (students, told) = parse::without_solutions(&course);
        assert!(told.is_empty() && !course.chapters.is_empty());
        for (whole, kept) in course.chapters.iter().zip(&students.chapters) {
            assert_eq!(whole.content.nodes, kept.content.nodes, "{}", whole.file);
            assert_eq!(whole.content.experiments, kept.content.experiments, "{}", whole.file);
        }
    }
}
