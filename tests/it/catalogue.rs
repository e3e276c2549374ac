//! The pages that code writes: every entry of a catalogue has one, each with its parts, and they hold together as a part of the book.

use std::collections::BTreeMap;

use workbook::catalogue::About;
use workbook::compose::{Planned, Request, check};
use workbook::diag::Diagnostic;
use workbook::generate;
use workbook::integrands::INTEGRANDS;
use workbook::kinds::KINDS;
use workbook::metrics::METRICS;
use workbook::parse::Chapter;
use workbook::samplers::{Method, SAMPLERS};
use workbook::scrambles::SCRAMBLES;

use crate::course::Course;

/// A course with these lines in its configuration.
fn course(lines: &str) -> Course {
    let configuration = format!("title = \"A course\"\nauthors = [\"A. Author\"]\n{lines}");
    let chapter =
        "+++\ntitle = \"One\"\nsummary = \"The only chapter.\"\n+++\n\nSee [a sampler](sampler-sobol.md#points).\n";
    let chapter = if lines.contains("measures\"]") {
        chapter.replace("(sampler-sobol.md#points)", "(measures.md)")
    } else {
        chapter.to_owned()
    };
    Course::new(&[("chapters/workbook.toml", &configuration), ("chapters/01-one.md", &chapter)])
}

fn planned(course: &Course) -> Planned {
    let planned = check(&Request { root: course.root().to_owned(), threads: 1, cached: false, audience: None });
    assert!(planned.diagnostics.is_empty(), "{:#?}", planned.diagnostics);
    planned
}

/// The chapter whose page has this name.
fn page<'a>(planned: &'a Planned, name: &str) -> (usize, &'a Chapter) {
    let found = planned.course.chapters.iter().enumerate().find(|(_, chapter)| chapter.slug == name);
    found.unwrap_or_else(|| panic!("there is no page `{name}`"))
}

/// The kinds of the exhibits of a chapter.
fn kinds(planned: &Planned, chapter: usize) -> Vec<&'static str> {
    let own = planned.plan.exhibits.iter().filter(|exhibit| exhibit.chapter == chapter);
    own.map(|exhibit| exhibit.experiment.kind().about().key).collect()
}

/// The ids of the sections of a chapter.
fn sections(planned: &Planned, chapter: usize) -> Vec<&str> {
    planned.plan.labels.sections(chapter).iter().map(|section| section.id.as_str()).collect()
}

fn listings(planned: &Planned, chapter: usize) -> usize {
    planned.plan.listings.iter().filter(|listing| listing.chapter == chapter).count()
}

/// Every entry that has a page, with the word before its key in the page's name.
fn entries() -> Vec<(&'static str, &'static About)> {
    let samplers = SAMPLERS.iter().map(|entry| ("sampler", entry.about()));
    let scrambles = SCRAMBLES.iter().map(|entry| ("scramble", entry.about()));
    let integrands = INTEGRANDS.iter().map(|entry| ("integrand", entry.about()));
    let measures = METRICS.iter().map(|entry| ("measure", entry.about()));
    samplers.chain(scrambles).chain(integrands).chain(measures).collect()
}

#[test]
fn every_entry_of_every_catalogue_has_its_page() {
    let planned = planned(&course("[catalogue]\n"));
    for (word, about) in entries() {
        let (index, chapter) = page(&planned, &format!("{word}-{}", about.key));
        // Signs are printed ones; the words are the entry's own.
        let first = |text: &str| text.split([' ', '\'', '’', '(']).next().unwrap_or_default().to_lowercase();
        assert!(chapter.member && first(&chapter.front.title) == first(about.title), "{word} {}", about.key);
        assert_eq!(first(&chapter.front.summary), first(about.summary), "{word} {}", about.key);
        assert!(!chapter.front.summary.contains(['^', '_', '\'']), "{}", chapter.front.summary);
        let picture = chapter.front.picture.as_ref().map(|picture| picture.id.as_str());
        assert!(picture.is_some_and(|id| planned.plan.exhibit(id).is_some_and(|exhibit| exhibit.chapter == index)));
    }
    // And nothing else has one: the pages of the shelves, and the chapter.
    assert_eq!(planned.course.chapters.len(), entries().len() + 4 + 1);
}

#[test]
fn members_have_the_number_of_their_place() {
    let planned = planned(&course("[catalogue]\n"));
    let number = |name: &str| page(&planned, name).1.name();
    assert_eq!(number("samplers"), "Catalogue S");
    let sobol = SAMPLERS.iter().position(|sampler| sampler.about().key == "sobol").unwrap() + 1;
    assert_eq!(number("sampler-sobol"), format!("Sampler S{sobol}"));
    assert_eq!(number("scramble-xor"), "Scramble R1");
    assert_eq!(planned.plan.labels.target("fig-sampler-sobol-points").unwrap().number, format!("S{sobol}.1"));
}

#[test]
fn every_page_of_a_sampler_has_the_same_parts() {
    let planned = planned(&course("[catalogue]\n"));
    let parts = [
        "definition",
        "guarantees",
        "points",
        "spectrum",
        "evenness",
        "convergence",
        "picture",
        "limits",
        "scrambles",
        "papers",
    ];
    for sampler in SAMPLERS {
        let key = sampler.about().key;
        let (index, _) = page(&planned, &format!("sampler-{key}"));
        assert_eq!(sections(&planned, index), parts, "{key}");
        assert_eq!(listings(&planned, index), 1, "{key}");
        let plane = (16..80).any(|n| Method::parse(key).unwrap().admits(n, 2).is_ok());
        let expected: &[&str] = if plane {
            &["guarantees", "points", "spectrum", "measures", "convergence", "render"]
        } else {
            &["guarantees", "points", "measures", "convergence"]
        };
        assert_eq!(kinds(&planned, index), expected, "{key}");
        let claimed = planned.plan.exhibits.iter().filter(|exhibit| exhibit.chapter == index);
        assert!(claimed.filter(|exhibit| !exhibit.claims.is_empty()).count() > 0, "{key} claims nothing");
    }
}

#[test]
fn every_other_page_has_its_parts() {
    let planned = planned(&course("[catalogue]\n"));
    for (word, about) in entries().into_iter().filter(|(word, _)| *word != "sampler") {
        let (index, _) = page(&planned, &format!("{word}-{}", about.key));
        let (sections, kinds) = (sections(&planned, index), kinds(&planned, index));
        let expected: (&[&str], &[&str]) = match word {
            "scramble" => (
                &["definition", "keeps", "points", "rate", "limits", "papers"],
                &["guarantees", "points", "convergence"],
            ),
            "integrand" => (
                &["definition", "shape", "exact", "convergence", "papers"],
                if kinds[0] == "function" { &["function", "convergence"] } else { &["surface", "convergence"] },
            ),
            _ => (&["definition", "exact", "over-n", "limits", "papers"], &kinds),
        };
        assert_eq!((sections.as_slice(), kinds.as_slice()), expected, "{word} {}", about.key);
        assert_eq!(listings(&planned, index), 1, "{word} {}", about.key);
        if word == "measure" {
            assert!(kinds.len() > 1 && kinds.last() == Some(&"discrepancy"), "{}: {kinds:?}", about.key);
        }
    }
}

#[test]
fn what_is_asked_for_is_there_and_no_more() {
    let off = planned(&Course::new(&[
        ("chapters/workbook.toml", "title = \"A course\"\nauthors = [\"A. Author\"]\n"),
        ("chapters/01-one.md", "+++\ntitle = \"One\"\nsummary = \"One.\"\n+++\n"),
    ]));
    assert_eq!(off.course.chapters.len(), 1);
    let some = planned(&course("[catalogue]\npages = [\"measures\"]\n"));
    assert_eq!(some.course.chapters.len(), METRICS.len() + 2);
}

#[test]
fn the_pages_of_a_shelf_hold_together() {
    let course = course("[catalogue]\npages = [\"measures\"]\n");
    let composed = course.compose(2);
    assert!(composed.diagnostics.is_empty(), "{:#?}", composed.diagnostics);
    let files: BTreeMap<&str, &str> = composed
        .book
        .files
        .iter()
        .filter_map(|(path, bytes)| Some((path.as_str(), std::str::from_utf8(bytes).ok()?)))
        .collect();
    let (shelf, star, l2) =
        (files["measures.html"], files["measure-star-discrepancy.html"], files["measure-l2-star.html"]);
    // The shelf shows every member with its drawing, and the way back is on each of them.
    for metric in METRICS {
        let key = metric.about().key;
        assert!(shelf.contains(&format!("href=\"measure-{key}.html\"")), "{key}");
        assert!(shelf.contains(&format!("src=\"exhibits/fig-measure-{key}.svg\"")), "{key}");
        let member = files[format!("measure-{key}.html").as_str()];
        assert!(member.contains("<li><a href=\"measures.html\">Measures</a></li>"), "{key}");
    }
    // One goes from member to member, and no list of chapters has them.
    assert!(
        star.contains("rel=\"next\" href=\"measure-l2-star.html\"")
            && l2.contains("rel=\"prev\" href=\"measure-star-discrepancy.html\"")
    );
    assert!(!star.contains("measure-l2-centred.html"), "only the neighbours are linked");
    let one = files["one.html"];
    assert!(one.contains("<a href=\"measures.html\">Measures</a>") && !one.contains("measure-star"));
    // A value that is known exactly is claimed, and holds.
    assert!(star.contains("dstar.hammersley"), "the exact values are claims");
    // A chapter's exhibit has all files, one of the catalogue only those that the page needs.
    assert!(!composed.book.files.contains_key("exhibits/fig-measure-l2-star.json"));
    assert!(composed.book.files.contains_key("exhibits/fig-measure-l2-star.csv"));
}

#[test]
fn a_diagnostic_of_such_a_page_says_where_it_comes_from() {
    let at = |file: &str| Diagnostic::error(workbook::diag::Code::Math, "wrong").at(&file.into(), 0..1);
    let mut told = [at("catalogue/sampler-sobol.md"), at("catalogues.md"), at("chapters/catalogue/x.md")];
    generate::explain(&mut told);
    generate::explain(&mut told);
    assert_eq!(told.each_ref().map(|diagnostic| diagnostic.help.len()), [1, 0, 0]);
    assert!(told[0].help[0].contains("writes it from the entry"), "{:?}", told[0].help);
}

#[test]
fn the_pages_use_only_kinds_that_there_are() {
    let planned = planned(&course("[catalogue]\n"));
    let used: Vec<&str> = (0..planned.course.chapters.len()).flat_map(|chapter| kinds(&planned, chapter)).collect();
    assert!(used.len() > 200 && used.iter().all(|used| KINDS.iter().any(|kind| kind.about().key == *used)));
}
