//! The page of a measure: what it is, exact values that it has, and how it falls with the number of points.

use super::choice::{counts, nearest_count};
use super::code;
use super::manual::Manual;
use super::page::{Fence, Page};
use super::typeset::typeset;
use crate::metrics::{Known, Metric, measure};
use crate::parse::Shelf;
use crate::samplers::Method;
use crate::seed::Seed;

/// The samplers that are measured: of each kind one.
const SAMPLERS: &[&str] =
    &["independent", "jittered", "latin-hypercube", "dart-throwing", "halton", "sobol", "sobol+owen"];
/// Over how many sets those are averaged that are random.
const SETS: usize = 16;

/// The page of `metric`.
pub(super) fn page(metric: &dyn Metric, shelves: &[Shelf]) -> String {
    let about = metric.about();
    let manual = Manual::read(about.source);
    let picture = format!("fig-measure-{}", about.key);
    let mut page = Page::new(about.title, about.summary, Some(&picture), shelves);
    page.section("Definition", "definition");
    page.block(&typeset(&manual.title, shelves));
    let own = |head: &&(String, String)| !["Cost", "Limits", "Paper", "Papers", "Source"].contains(&head.0.as_str());
    for (head, words) in manual.parts.iter().filter(own) {
        let head = if head.is_empty() { String::new() } else { format!("**{head}.** ") };
        page.block(&format!("{head}{}", typeset(words, shelves)));
    }
    if let Some(item) = code::item_of_measure(about) {
        page.listing(
            &format!("lst-measure-{}", about.key),
            &item,
            "The code at the heart of it, as it ran for this page.",
        );
    }
    known(metric, &mut page);
    over_n(metric, &mut page);
    page.section("Cost and limits", "limits");
    page.told(&manual, &["Cost", "Limits"]);
    page.block(&format!(
        "**To use it.** A chapter writes `measure = \"{0}\"`, and the command line `workbook points sobol -n 64 -d 2 | workbook measure {0} -`.",
        about.key
    ));
    page.papers(about);
    page.finish()
}

/// The values that are known exactly, each as a claim.
fn known(metric: &dyn Metric, page: &mut Page<'_>) {
    page.section("Exact values", "exact");
    if metric.known().is_empty() {
        return page.block("No exact value is stated for it.");
    }
    let quantity = crate::kinds::quantity(metric.about().key);
    let mut sizes: Vec<(usize, usize)> = metric.known().iter().map(|known| (known.n, known.d)).collect();
    sizes.dedup();
    for (at, (n, d)) in sizes.into_iter().enumerate() {
        let here: Vec<&Known> = metric.known().iter().filter(|known| (known.n, known.d) == (n, d)).collect();
        let methods: Vec<&str> = here.iter().map(|known| known.method).collect();
        let sources: Vec<String> = here
            .iter()
            .map(|known| {
                let title = Method::parse(known.method).map(|method| method.title()).unwrap_or_default();
                format!("{title}: `{}`, {}", known.value, known.source)
            })
            .collect();
        let caption = format!("{n} points in {d} dimension{}. {}.", if d == 1 { "" } else { "s" }, sources.join(". "));
        let id = format!("tbl-measure-{}-exact-{}", metric.about().key, at + 1);
        let fence = Fence::new("measures", &id).words("samplers", &methods).with("n", n).with("dimensions", d);
        let fence = fence.words("measures", &[metric.about().key]).with("strata", false).caption(&caption);
        let claims = here.iter().map(|known| {
            (format!("{quantity}.{}", known.method), format!("near = \"{}\", within = 1e-12", known.value))
        });
        page.experiment(&fence.claims(claims));
    }
}

/// The measure over the number of points.
fn over_n(metric: &dyn Metric, page: &mut Page<'_>) {
    page.section("Over the number of points", "over-n");
    let methods: Vec<Method> = SAMPLERS.iter().filter_map(|name| Method::parse(name).ok()).collect();
    let fits = |method: &&Method| {
        let n = nearest_count(method, 16, 2);
        let points = n.and_then(|n| method.points(n, 2, Seed::new(1)).ok());
        points.is_some_and(|points| measure(metric, &points).is_ok())
    };
    let methods: Vec<Method> = methods.iter().filter(fits).copied().collect();
    let names: Vec<String> = methods.iter().map(crate::samplers::Method::name).collect();
    let counts = counts(&methods, &[16, 64, 256, 1024], 2);
    let caption = format!(
        "{} of sets in the plane; of random samplers the mean over {SETS} sets, with the range from the least to the greatest.",
        metric.about().title
    );
    let fence = Fence::new("discrepancy", &format!("fig-measure-{}", metric.about().key)).words("samplers", &names);
    let fence = fence.numbers("n", &counts).word("measure", metric.about().key).with("replicates", SETS);
    page.experiment(&fence.caption(&caption));
}
