//! How long an author waits: the program on the first course, and the stages that a build repeats.
//!
//! The course is copied, so that neither its book nor its cache is touched. Sizes are printed before the times.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a benchmark that cannot run should say so")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use divan::Bencher;
use workbook::chart::{Drawing, Sheet};
use workbook::compose::{Composed, Request, check, compose};
use workbook::kinds::Outcome;
use workbook::plan::Plan;
use workbook::seed::Seed;
use workbook::sources::Sources;
use workbook::{parse, render, workspace};

/// The first course.
const CHAPTERS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/chapters");

/// A chapter that draws 4,096 points.
const POINTS: &str = r#"+++
title = "Points"
summary = "Many of them."
+++

```experiment
id = "fig-points"
kind = "points"
samplers = ["independent"]
n = 4096
strata = "none"
caption = "Independent points."
```
"#;

fn main() {
    sizes();
    divan::main();
}

/// Prints how large the book is, and the drawing of 4,096 points.
fn sizes() {
    let composed = composed(&course("sizes"));
    let book = &composed.book.files;
    let pages = book.iter().filter(|(path, _)| workspace::extension(path) == Some("html"));
    let largest = pages.clone().max_by_key(|(_, bytes)| bytes.len()).expect("a book has pages");
    let drawings = composed.shown.iter().filter_map(|shown| match &*shown.drawing {
        Drawing::Figure(figure) => Some(figure.svg.len()),
        Drawing::Stepper(stepper) => Some(stepper.text().len()),
        Drawing::Table(_) | Drawing::Pictures(_) => None,
    });
    let (plan, outcome) = many_points();
    let Drawing::Figure(points) = draw(&plan, &outcome) else { panic!("points are drawn as a figure") };
    println!("the book         {:>8} kB in {} files", kilobytes(book.values().map(Vec::len).sum()), book.len());
    println!("its pages        {:>8} kB", kilobytes(pages.map(|(_, bytes)| bytes.len()).sum()));
    println!("the largest page {:>8} kB: {}", kilobytes(largest.1.len()), largest.0);
    println!("its drawings     {:>8} kB", kilobytes(drawings.sum()));
    println!("4,096 points     {:>8} kB", kilobytes(points.svg.len()));
}

fn kilobytes(bytes: usize) -> String {
    format!("{:.1}", bytes as f64 / 1e3)
}

/// The program: what an author waits for, the start of the process included.
mod program {
    use super::{Bencher, course, edit_prose, workbook};

    #[divan::bench(sample_count = 50)]
    fn build_with_nothing_to_do(bencher: Bencher) {
        let root = course("nothing-to-do");
        workbook(&root, &["build"]);
        bencher.bench(|| workbook(&root, &["build"]));
    }

    #[divan::bench(sample_count = 50)]
    fn build_after_an_edit_of_prose(bencher: Bencher) {
        let root = course("prose");
        workbook(&root, &["build"]);
        bencher.with_inputs(|| edit_prose(&root)).bench_values(|()| workbook(&root, &["build"]));
    }

    #[divan::bench(sample_count = 50)]
    fn check(bencher: Bencher) {
        let root = course("check");
        bencher.bench(|| workbook(&root, &["check"]));
    }

    #[divan::bench(sample_count = 5)]
    fn build_cold(bencher: Bencher) {
        let root = course("cold");
        let clean = || drop(std::fs::remove_dir_all(root.join("book")));
        bencher.with_inputs(clean).bench_values(|()| workbook(&root, &["build", "--no-cache"]));
    }
}

/// The stages that every build repeats.
mod stages {
    use super::{
        Bencher, Sources, check, composed, course, draw, library, many_points, parse, render, request, workspace,
    };

    #[divan::bench]
    fn digest_the_library(bencher: Bencher) {
        let files = library();
        bencher.bench(|| Sources::new(files.iter().map(|(path, bytes)| (path.as_str(), bytes.as_slice())), ""));
    }

    #[divan::bench]
    fn parse_the_course(bencher: Bencher) {
        let (workspace, _) = workspace::load(&course("parse"));
        bencher.bench(|| parse::course(parse::configuration(&workspace).0, &workspace, &[]));
    }

    #[divan::bench]
    fn read_parse_and_plan(bencher: Bencher) {
        let root = course("plan");
        bencher.bench(|| check(&request(&root)));
    }

    #[divan::bench]
    fn render_the_book(bencher: Bencher) {
        let all = composed(&course("render"));
        bencher.bench(|| render::render(&all.course, &all.plan, &all.shown, &all.workspace));
    }

    #[divan::bench]
    fn draw_4096_points(bencher: Bencher) {
        let (plan, outcome) = many_points();
        bencher.bench(|| draw(&plan, &outcome));
    }
}

/// Every file of the library by its path from `src`.
fn library() -> BTreeMap<String, Vec<u8>> {
    let top = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut files, mut folders) = (BTreeMap::new(), vec![top.clone()]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder is there") {
            let path = entry.expect("the folder can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let name = path.strip_prefix(&top).expect("it lies below").to_string_lossy().replace('\\', "/");
                files.insert(name, fs::read(&path).expect("a file can be read"));
            }
        }
    }
    files
}

/// A copy of the first course in a folder called `name`, with neither a book nor results.
fn course(name: &str) -> PathBuf {
    let root = empty(name);
    copy(Path::new(CHAPTERS), &root.join("chapters"));
    root
}

/// An empty folder.
fn empty(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pipeline").join(name);
    drop(fs::remove_dir_all(&root));
    fs::create_dir_all(&root).expect("a folder can be made");
    root
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder can be made");
    for entry in fs::read_dir(from).expect("the folder is there") {
        let path = entry.expect("the folder can be read").path();
        let target = to.join(path.file_name().expect("an entry has a name"));
        if path.is_dir() {
            copy(&path, &target);
        } else {
            fs::copy(&path, &target).expect("a file can be copied");
        }
    }
}

/// Runs the program on the course at `root`, quietly; it must end well.
fn workbook(root: &Path, arguments: &[&str]) {
    let output = Command::new(env!("CARGO_BIN_EXE_workbook"))
        .args(arguments)
        .arg("--quiet")
        .current_dir(root)
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// Adds a sentence to the first chapter, or takes it away again.
fn edit_prose(root: &Path) {
    const SENTENCE: &str = "\nOne sentence more.\n";
    let path = root.join("chapters/01-history.md");
    let text = fs::read_to_string(&path).expect("the chapter is there");
    let edited = text.strip_suffix(SENTENCE).map_or_else(|| format!("{text}{SENTENCE}"), str::to_owned);
    fs::write(&path, edited).expect("the chapter can be written");
}

fn request(root: &Path) -> Request {
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    Request { root: root.to_owned(), threads, cached: false, audience: None }
}

/// The book of the course at `root`.
fn composed(root: &Path) -> Composed {
    let composed = compose(&request(root), &());
    assert!(!composed.book.files.is_empty(), "{:#?}", composed.diagnostics);
    composed
}

/// The plan of a course that draws 4,096 points, and what its one experiment gives.
fn many_points() -> (Plan, Outcome) {
    let root = empty("points");
    fs::create_dir_all(root.join("chapters")).expect("a folder can be made");
    fs::write(root.join("chapters/workbook.toml"), "title = \"Points\"\nauthors = \"A\"\norder = [\"01-points\"]\n")
        .expect("a file can be written");
    fs::write(root.join("chapters/01-points.md"), POINTS).expect("a file can be written");
    let planned = check(&request(&root));
    let Some(exhibit) = planned.plan.exhibits.first() else { panic!("{:#?}", planned.diagnostics) };
    let outcome = exhibit.experiment.run(Seed::new(exhibit.seed)).expect("points can be drawn");
    (planned.plan, outcome)
}

fn draw(plan: &Plan, outcome: &Outcome) -> Drawing {
    let exhibit = &plan.exhibits[0];
    exhibit.experiment.draw(outcome, &Sheet::new("fig-points", "Points", "")).expect("points can be drawn")
}
