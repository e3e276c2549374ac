//! The listing of a page: which item of an entry's file shows best how it works.

use crate::catalogue::About;
use crate::sources;

/// The methods that compute, the best first, each with the fewest lines that are worth showing.
const METHODS: &[(&str, usize)] = &[("numerator", 4), ("points", 9), ("action", 3), ("evaluate", 1)];

/// The most lines that a page shows.
const MOST: usize = 45;

/// The path of the item that shows best how an entry works: the method that computes, unless it only calls a function of the file.
pub(super) fn item(about: &About) -> Option<String> {
    let module = about.file.strip_suffix(".rs")?.replace('/', "::");
    let types: Vec<&str> = about.source.lines().filter_map(implemented).collect();
    let methods =
        METHODS.iter().flat_map(|(method, least)| types.iter().map(move |kind| (format!("{kind}::{method}"), *least)));
    let long = functions(about).map(|name| (name.to_owned(), 5));
    let functions = functions(about).map(|name| (name.to_owned(), 2));
    // Where nothing is long enough, something short will do.
    let short = METHODS.iter().flat_map(|(method, _)| types.iter().map(move |kind| (format!("{kind}::{method}"), 1)));
    let all =
        methods.chain(long).chain(functions).chain(short).map(|(name, least)| (format!("{module}::{name}"), least));
    first(all)
}

/// The same of a measure: the function that is called as the measure is, its method, or the first function of the file.
pub(super) fn item_of_measure(about: &About) -> Option<String> {
    let module = about.file.strip_suffix(".rs")?.replace('/', "::");
    let key = about.key.replace('-', "_");
    let called = functions(about).filter(|name| key.contains(name)).map(str::to_owned);
    let camel: String = about.key.split('-').map(capitalised).collect();
    let all = called.chain([format!("{camel}::measure")]).chain(functions(about).map(str::to_owned));
    first(all.map(|name| (format!("{module}::{name}"), 2)))
}

/// The first of these paths that is an item of at least so many lines, and not too many.
fn first(all: impl Iterator<Item = (String, usize)>) -> Option<String> {
    let lines = |path: &str| sources::item(path).map_or(0, |item| item.text.lines().count());
    all.into_iter().find(|(path, least)| (*least..=MOST).contains(&lines(path))).map(|(path, _)| path)
}

/// The public functions of an entry's file.
fn functions(about: &About) -> impl Iterator<Item = &'static str> + use<> {
    let functions = about.source.lines().filter_map(|line| line.strip_prefix("pub fn "));
    functions.filter_map(|rest| rest.split(['(', '<']).next())
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// The type of a line `impl Trait for Type {`.
fn implemented(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("impl ")?.strip_suffix(" {")?;
    let kind = rest.split_once(" for ").map_or(rest, |(_, kind)| kind);
    kind.split(['<', ' ']).next()
}
