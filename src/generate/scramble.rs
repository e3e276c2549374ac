//! The page of a scramble: what it does to points, what it keeps, and what it gains.

use super::choice::{counts, member};
use super::code;
use super::manual::Manual;
use super::page::{Fence, Page};
use crate::parse::Shelf;
use crate::samplers::{Method, SAMPLERS};
use crate::scrambles::Scramble;

/// The samplers on which it is shown, the best first.
const HOSTS: &[&str] = &["sobol", "halton", "faure", "hammersley", "korobov"];
/// Over how many seeds or runs.
const RUNS: usize = 64;

/// The page of `scramble`.
pub(super) fn page(scramble: &'static dyn Scramble, shelves: &[Shelf]) -> String {
    let about = scramble.about();
    let manual = Manual::read(about.source);
    let hosts: Vec<&str> = HOSTS.iter().copied().filter(|host| combined(host, scramble).is_some()).collect();
    let picture = format!("fig-scramble-{}", about.key);
    let title = upper(about.title);
    let mut page = Page::new(&title, about.summary, Some(&picture), shelves);
    page.section("Definition", "definition");
    page.told(&manual, &["What", "Formula"]);
    if let Some(item) = code::item(about) {
        page.listing(
            &format!("lst-scramble-{}", about.key),
            &item,
            "The code at the heart of it, as it ran for this page.",
        );
    }
    page.section("What it keeps", "keeps");
    page.words(&manual, "Guarantees");
    kept(scramble, &hosts, &mut page);
    page.section("Points before and after", "points");
    points(scramble, &hosts, &mut page);
    page.section("Rate before and after", "rate");
    rate(scramble, &hosts, &mut page);
    page.section("Cost and limits", "limits");
    page.told(&manual, &["Cost", "Limits"]);
    let fits = SAMPLERS.iter().filter(|sampler| scramble.combines(**sampler).is_ok());
    let fits: Vec<String> = fits.map(|sampler| member(Shelf::Samplers, sampler.about(), shelves)).collect();
    page.block(&format!(
        "**To use it.** Behind a sampler, as in `{}+{}`. It combines with {}.",
        hosts.first().unwrap_or(&"sobol"),
        about.key,
        fits.join(", ")
    ));
    page.papers(about);
    page.finish()
}

/// The method of a sampler with the scramble, if they combine.
fn combined(host: &str, scramble: &dyn Scramble) -> Option<Method> {
    Method::parse(&format!("{host}+{}", scramble.about().key)).ok()
}

/// Each host before and after.
fn pairs(hosts: &[&str], scramble: &dyn Scramble) -> Vec<Method> {
    let both = |host: &&str| [Method::parse(host).ok(), combined(host, scramble)];
    hosts.iter().flat_map(both).flatten().collect()
}

fn names(methods: &[Method]) -> Vec<String> {
    methods.iter().map(Method::name).collect()
}

fn kept(scramble: &dyn Scramble, hosts: &[&str], page: &mut Page<'_>) {
    let pairs = pairs(hosts, scramble);
    let caption = format!(
        "Samplers before and after: what is declared, and what was counted over {RUNS} seeds of 64 points in the plane. A method that no seed changes was looked at once."
    );
    let fence =
        Fence::new("guarantees", &format!("tbl-scramble-{}", scramble.about().key)).words("samplers", &names(&pairs));
    let fence =
        fence.words("properties", &["latin", "cells", "net", "prefix", "fixed"]).with("n", 64).with("seeds", RUNS);
    page.experiment(&fence.caption(&caption).claim("consistent", "holds = true"));
}

fn points(scramble: &dyn Scramble, hosts: &[&str], page: &mut Page<'_>) {
    let Some(host) = hosts.first() else { return };
    let pair = pairs(&[host], scramble);
    let counts = counts(&pair, &[16, 64], 2);
    let fence =
        Fence::new("points", &format!("fig-scramble-{}", scramble.about().key)).words("samplers", &names(&pair));
    let fence = fence.numbers("n", &counts).word("strata", "cells").with("order", true);
    page.experiment(
        &fence.caption("The same points before and after, on as many equal cells. Colours follow their order."),
    );
}

fn rate(scramble: &dyn Scramble, hosts: &[&str], page: &mut Page<'_>) {
    let Some(host) = hosts.first() else { return };
    let pair = pairs(&[host], scramble);
    let counts = counts(&pair, &[16, 64, 256, 1024, 4096], 2);
    let name = format!("{host}+{}", scramble.about().key);
    let after =
        if scramble.is_random() { format!("the root mean square error over {RUNS} runs") } else { "that".to_owned() };
    let caption =
        format!("The error before, and {after} after, for a smooth integrand and for one with a curved edge.");
    let fence = Fence::new("convergence", &format!("fig-scramble-{}-rate", scramble.about().key))
        .words("samplers", &names(&pair));
    let fence = fence
        .words("integrands", &["gaussian", "disk"])
        .numbers("n", &counts)
        .with("replicates", RUNS)
        .caption(&caption);
    let fence = if scramble.is_random() {
        page.block("A scramble that draws at random makes every single point uniform, so that the mean is unbiased: the claim on the means below.");
        fence.claim(&format!("mean.{name}.*.gaussian"), "agrees = \"exact.gaussian\", within = 5")
    } else {
        page.block(
            "It is the same for every seed, so that there is no bias to speak of, and no error estimate either.",
        );
        fence
    };
    page.experiment(&fence);
}

/// A sentence's beginning.
fn upper(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}
