//! The page of a shelf: how its members compare. The members themselves stand above it, with a picture each.

use super::choice::{dimensions, member, nearest_count};
use super::page::Page;
use crate::integrands::INTEGRANDS;
use crate::metrics::METRICS;
use crate::parse::Shelf;
use crate::samplers::{Feature, Guarantee, Method, SAMPLERS, Sampler};
use crate::scrambles::{SCRAMBLES, Scramble};

/// The page of `shelf`, in a book that has the `shelves`.
pub(super) fn page(shelf: Shelf, shelves: &[Shelf]) -> String {
    let summary = match shelf {
        Shelf::Samplers => {
            "Every way to place points that the program knows: what each promises, what was measured of it, and a page for each."
        }
        Shelf::Scrambles => {
            "Every way to randomise the digits of points: what it keeps of what makes them good, and a page for each."
        }
        Shelf::Integrands => "Every function whose integral is known: what is known of it, and a page for each.",
        Shelf::Measures => "Every number that says how even points are: what it is, and a page for each.",
    };
    let mut page = Page::new(shelf.title(), summary, None, shelves);
    match shelf {
        Shelf::Samplers => samplers(&mut page, shelves),
        Shelf::Scrambles => scrambles(&mut page, shelves),
        Shelf::Integrands => integrands(&mut page, shelves),
        Shelf::Measures => measures(&mut page, shelves),
    }
    page.finish()
}

/// A table of markdown: its heads, with how they are aligned, and its rows.
fn table(heads: &[(&str, &str)], rows: impl Iterator<Item = Vec<String>>) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = line(heads.iter().map(|(head, _)| (*head).to_owned()).collect());
    text += &line(heads.iter().map(|(_, align)| (*align).to_owned()).collect());
    rows.for_each(|row| text += &line(row));
    text
}

/// The signs of a table of what is promised.
fn sign(yes: bool) -> String {
    if yes { "yes" } else { "" }.to_owned()
}

fn samplers(page: &mut Page<'_>, shelves: &[Shelf]) {
    page.section("What they promise", "promises");
    page.block("Each promise is proven by tests over many counts, dimensions and seeds, and counted again on the sampler's own page.");
    let heads = [
        ("Sampler", ":--"),
        ("Latin", ":-:"),
        ("Cells", ":-:"),
        ("Net", ":-:"),
        ("Prefix", ":-:"),
        ("Apart", ":-:"),
        ("Unbiased", ":-:"),
        ("Rate, smooth", "--:"),
        ("Rate, edge", "--:"),
    ];
    page.block(&table(&heads, SAMPLERS.iter().map(|sampler| promises(*sampler, shelves))));
    page.block("Latin: one point in each slab of every axis. Cells: one in each cell of a grid of as many cells. Net: nets or boxes in elementary intervals. Prefix: the first points are those of fewer. Apart: no two nearer than a bound. The rates are the exponents of $N$ in the error in the plane, or on the line where there is no more, up to logarithms; where nothing stands, theory promises nothing for all.");
    page.section("What was measured", "measured");
    page.block("Of about 64 points in the plane, or on the line; of a random sampler the mean over several sets. The errors are of about a thousand points, of about 256 where points are searched for.");
    let heads = [
        ("Sampler", ":--"),
        ("$N$", "--:"),
        ("$t$", "--:"),
        ("$D^*$", "--:"),
        ("$L_2^*$", "--:"),
        (r"$\rho$", "--:"),
        ("Slope, smooth", "--:"),
        ("Slope, edge", "--:"),
    ];
    page.block(&table(&heads, SAMPLERS.iter().filter_map(|sampler| measured(*sampler, shelves))));
}

fn promises(sampler: &dyn Sampler, shelves: &[Shelf]) -> Vec<String> {
    let about = sampler.about();
    let has = |guarantee: Guarantee| sampler.guarantees().contains(&guarantee);
    let some = |what: fn(&Guarantee) -> bool| sign(sampler.guarantees().iter().any(what));
    let d = Method::parse(about.key).map_or(2, |method| dimensions(&method));
    let rate = |feature| sampler.rate(feature, d).map_or_else(String::new, |rate| format!("${}$", fraction(rate)));
    vec![
        member(Shelf::Samplers, about, shelves),
        sign(has(Guarantee::Latin)),
        some(|guarantee| matches!(guarantee, Guarantee::Strata | Guarantee::Pairs | Guarantee::Strength { .. })),
        some(|guarantee| matches!(guarantee, Guarantee::Net | Guarantee::Whole | Guarantee::Boxes)),
        sign(has(Guarantee::Prefix)),
        some(|guarantee| matches!(guarantee, Guarantee::Separated { .. })),
        sign(has(Guarantee::Unbiased)),
        rate(Feature::Smooth),
        rate(Feature::Edge),
    ]
}

/// A rate as LaTeX: a whole number, or a fraction of quarters.
fn fraction(rate: f64) -> String {
    let quarters = (rate * 4.0).round() as i64;
    let sign = if quarters < 0 { "-" } else { "" };
    match quarters.abs() {
        whole if whole % 4 == 0 => format!("{sign}{}", whole / 4),
        half if half % 2 == 0 => format!("{sign}{}/2", half / 2),
        odd => format!("{sign}{odd}/4"),
    }
}

/// The values of a sampler's own page.
fn measured(sampler: &dyn Sampler, shelves: &[Shelf]) -> Option<Vec<String>> {
    let about = sampler.about();
    let key = about.key;
    let method = Method::parse(key).ok()?;
    let d = dimensions(&method);
    let n = nearest_count(&method, 64, d)?;
    let table = |quantity: &str, format: &str| format!("`=tbl-sampler-{key}-measures.{quantity}.{key}.{n}:{format}`");
    let slope = |integrand: &str, known: bool| {
        if known { format!("`=fig-sampler-{key}-convergence.slope.{key}.{integrand}:.2`") } else { String::new() }
    };
    let smooth = super::sampler::INTEGRANDS[d - 1][0];
    let edge = if d == 1 { "step" } else { "disk" };
    Some(vec![
        member(Shelf::Samplers, about, shelves),
        n.to_string(),
        if n.is_power_of_two() { table("t", ".2g") } else { String::new() },
        table("dstar", ".3g"),
        table("l2star", ".3g"),
        if d == 1 { String::new() } else { table("radius", ".2") },
        slope(smooth, true),
        slope(edge, true),
    ])
}

fn scrambles(page: &mut Page<'_>, shelves: &[Shelf]) {
    page.section("What they keep", "keep");
    page.block("What stays true of a sampler behind whose name the scramble stands.");
    let heads = [
        ("Scramble", ":--"),
        ("Random", ":-:"),
        ("Latin", ":-:"),
        ("Cells", ":-:"),
        ("Net", ":-:"),
        ("Boxes", ":-:"),
        ("Prefix", ":-:"),
        ("Combines with", "--:"),
    ];
    let row = |scramble: &&'static dyn Scramble| {
        let keeps = |guarantee| sign(scramble.keeps(guarantee));
        let hosts = SAMPLERS.iter().filter(|sampler| scramble.combines(**sampler).is_ok()).count();
        vec![
            member(Shelf::Scrambles, scramble.about(), shelves),
            sign(scramble.is_random()),
            keeps(Guarantee::Latin),
            keeps(Guarantee::Strata),
            keeps(Guarantee::Net),
            keeps(Guarantee::Boxes),
            keeps(Guarantee::Prefix),
            format!("{hosts} sampler{}", if hosts == 1 { "" } else { "s" }),
        ]
    };
    page.block(&table(&heads, SCRAMBLES.iter().map(row)));
}

fn integrands(page: &mut Page<'_>, shelves: &[Shelf]) {
    page.section("What is known of them", "known");
    let heads = [
        ("Integrand", ":--"),
        ("Dimensions", "--:"),
        ("$F$", "--:"),
        (r"$\sigma$", "--:"),
        ("Slope, independent", "--:"),
        ("Slope, scrambled Sobol'", "--:"),
    ];
    let row = |integrand: &&'static dyn crate::integrands::Integrand| {
        let about = integrand.about();
        let rate = |value: &str| format!("`=fig-integrand-{}-convergence.{value}`", about.key);
        vec![
            member(Shelf::Integrands, about, shelves),
            integrand.dimensions().map_or_else(|| "any".to_owned(), |d| d.to_string()),
            rate("exact:.4g"),
            rate("sigma:.4g"),
            rate("slope.independent:.2"),
            rate("slope.sobol+owen:.2"),
        ]
    };
    page.block(&table(&heads, INTEGRANDS.iter().map(row)));
    page.block("Those that take any number of dimensions are shown in two.");
}

fn measures(page: &mut Page<'_>, shelves: &[Shelf]) {
    page.section("What they say", "say");
    let row = |metric: &&'static dyn crate::metrics::Metric| {
        let about = metric.about();
        vec![member(Shelf::Measures, about, shelves), super::typeset::typeset(about.summary, &[])]
    };
    page.block(&table(&[("Measure", ":--"), ("What it is", ":--")], METRICS.iter().map(row)));
}
