//! The page of an integrand: its formula, what is known of it exactly, its shape, and how fast samplers integrate it.

use super::choice::counts;
use super::code;
use super::manual::Manual;
use super::page::{Fence, Page};
use crate::integrands::Integrand;
use crate::parse::Shelf;
use crate::samplers::Method;

/// The samplers that integrate it: of each kind one.
const SAMPLERS: &[&str] = &["independent", "latin-hypercube", "jittered", "sobol", "sobol+owen"];
/// Over how many runs.
const RUNS: usize = 32;

/// The page of `integrand`.
pub(super) fn page(integrand: &dyn Integrand, shelves: &[Shelf]) -> String {
    let about = integrand.about();
    let manual = Manual::read(about.source);
    let d = integrand.dimensions().unwrap_or(2);
    let picture = format!("fig-integrand-{}", about.key);
    let mut page = Page::new(about.title, about.summary, Some(&picture), shelves);
    page.section("Definition", "definition");
    page.block(&format!("$$ f({}) = {} $$", variables(integrand.dimensions()), integrand.formula()));
    page.block(&match integrand.dimensions() {
        Some(1) => "It has one variable.".to_owned(),
        Some(d) => format!("It has {d} variables."),
        None => format!("It takes any number of dimensions; this page shows it in {d}."),
    });
    page.told(&manual, &["What"]);
    if let Some(item) = code::item(about) {
        page.listing(&format!("lst-integrand-{}", about.key), &item, "The code that ran for this page.");
    }
    shape(integrand, d, &mut page);
    page.section("Exact values", "exact");
    exact(integrand, d, &picture, &mut page);
    page.told(&manual, &["Integral and variance", "Variation"]);
    convergence(integrand, d, &mut page);
    page.papers(about);
    page.finish()
}

/// The variables that a formula has.
fn variables(d: Option<usize>) -> &'static str {
    match d {
        Some(1) => "x",
        Some(2) => "x, y",
        _ => r"x_1, \dots, x_d",
    }
}

fn shape(integrand: &dyn Integrand, d: usize, page: &mut Page<'_>) {
    page.section("Shape", "shape");
    let key = integrand.about().key;
    let id = format!("fig-integrand-{key}");
    let fence = if d == 1 {
        let fence = Fence::new("function", &id).word("integrand", key);
        fence.caption("The integrand over the unit interval, the area below it and its mean height.")
    } else {
        let fence = Fence::new("surface", &id).word("integrand", key);
        fence.caption("The integrand over the unit square, dark where it is low, light where it is high; beside it three cuts across the square.")
    };
    page.experiment(&fence.claims(claims(integrand, d)));
}

/// What a fine grid finds is what the catalogue states.
fn claims(integrand: &dyn Integrand, d: usize) -> Vec<(String, String)> {
    if d == 1 || integrand.integral(d).is_none() {
        return Vec::new();
    }
    // Midpoints of 128 x 128 cells; an edge crosses at most a few hundred of them.
    vec![("grid.mean".to_owned(), "near = \"[integral]\", within = \"2*([maximum] - [minimum])/128\"".to_owned())]
}

/// The integral and its kin, as the exhibit of the shape gives them.
fn exact(integrand: &dyn Integrand, d: usize, exhibit: &str, page: &mut Page<'_>) {
    let mut rows = vec!["| Quantity | Value |".to_owned(), "|:--|--:|".to_owned()];
    let mut add = |known: bool, words: &str, value: &str| {
        if known {
            rows.push(format!("| {words} | `={exhibit}.{value}` |"));
        }
    };
    add(integrand.integral(d).is_some(), "Integral $F$", "integral:.10g");
    add(integrand.variance(d).is_some(), r"Variance $\sigma^2$", "variance:.10g");
    add(d > 1 && integrand.variation(d).is_some(), "Variation $V(f)$", "variation:.10g");
    if rows.len() > 2 {
        page.block(&rows.join("\n"));
    }
}

fn convergence(integrand: &dyn Integrand, d: usize, page: &mut Page<'_>) {
    page.section("Convergence", "convergence");
    let key = integrand.about().key;
    let methods: Vec<Method> = SAMPLERS.iter().filter_map(|name| Method::parse(name).ok()).collect();
    let methods: Vec<Method> = methods.into_iter().filter(|method| method.admits(64, d).is_ok()).collect();
    let names: Vec<String> = methods.iter().map(Method::name).collect();
    let counts = counts(&methods, &[16, 64, 256, 1024, 4096], d);
    let caption = format!(
        "The root mean square error over {RUNS} runs in {d} dimension{}, with fitted slopes.",
        if d == 1 { "" } else { "s" }
    );
    let fence = Fence::new("convergence", &format!("fig-integrand-{key}-convergence")).words("samplers", &names);
    let fence = fence.word("integrand", key).numbers("n", &counts).with("dimensions", d).with("replicates", RUNS);
    let fence = fence.caption(&caption).claim("slope.independent", "near = -0.5, within = 0.15");
    let fence = fence.claim("mean.independent.*", "agrees = \"exact\", within = 5");
    page.experiment(&fence);
}
