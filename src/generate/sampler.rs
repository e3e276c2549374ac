//! The page of a sampler: the same parts in the same order on every one, so that they compare.

use super::choice::{counts, dimensions, member, nearest_count};
use super::manual::Manual;
use super::page::{Fence, Page, plain};
use super::sampler_claims as claims;
use super::typeset::typeset;
use super::{choice, code};
use crate::parse::Shelf;
use crate::samplers::{Digits, Guarantee, Method, Sampler, Setting};
use crate::scenes::film::{Randomisation, Sampling};
use crate::scenes::{SCENES, Scene};

/// What the pages integrate in one and in two dimensions: smooth, a sum over the axes, with a kink, with a curved edge (on the line
/// another smooth one), with an edge across the first axis.
pub(super) const INTEGRANDS: [[&str; 5]; 2] = [
    ["exp-sin", "x", "genz-continuous", "genz-oscillatory", "step"],
    ["gaussian", "sum", "genz-continuous", "disk", "step"],
];

/// The counts that a page shows, or the nearest that the sampler admits.
const COUNTS: [usize; 4] = [16, 64, 256, 1024];
/// Over how many sets a random sampler is looked at.
pub(super) const SETS: usize = 64;
/// The key of the scene that is rendered, with its width and height.
const SCENE: (&str, usize, usize) = ("soft-shadows", 96, 72);

/// What a page knows of its sampler.
pub(super) struct Subject {
    /// Its key.
    pub(super) key: &'static str,
    /// It as a method.
    pub(super) method: Method,
    /// The dimensions that the page shows.
    pub(super) d: usize,
    /// The counts that the page shows.
    pub(super) counts: Vec<usize>,
}

impl Subject {
    fn new(sampler: &dyn Sampler) -> Option<Self> {
        let key = sampler.about().key;
        let method = Method::parse(key).ok()?;
        let d = dimensions(&method);
        Some(Self { key, method, d, counts: counts(&[method], &COUNTS, d) })
    }

    /// An id of the page.
    pub(super) fn id(&self, prefix: &str, what: &str) -> String {
        format!("{prefix}-sampler-{}-{what}", self.key)
    }

    /// Whether it promises this.
    pub(super) fn has(&self, guarantee: Guarantee) -> bool {
        self.method.guarantees().contains(&guarantee)
    }

    /// Whether many points take it long.
    pub(super) fn is_slow(&self) -> bool {
        self.method.sampler().searches()
    }

    /// What is integrated on the page.
    pub(super) fn integrands(&self) -> &'static [&'static str; 5] {
        &INTEGRANDS[usize::from(self.d > 1)]
    }

    /// How the page calls a set of such points.
    fn in_words(&self) -> &'static str {
        if self.d == 1 { "on the line" } else { "in the plane" }
    }
}

/// The page of `sampler`.
pub(super) fn page(sampler: &dyn Sampler, shelves: &[Shelf]) -> String {
    let about = sampler.about();
    let Some(subject) = Subject::new(sampler) else { return String::new() };
    let manual = Manual::read(about.source);
    let points = subject.id("fig", "points");
    let mut page = Page::new(about.title, about.summary, Some(&points), shelves);
    definition(&subject, sampler, &manual, &mut page);
    guarantees(&subject, &manual, &mut page);
    shown(&subject, &mut page);
    spectrum(&subject, &mut page);
    evenness(&subject, shelves, &mut page);
    convergence(&subject, &mut page);
    picture(&subject, &mut page);
    limits(&subject, sampler, &manual, &mut page);
    family(&subject, shelves, &mut page);
    page.papers(about);
    page.finish()
}

fn definition(subject: &Subject, sampler: &dyn Sampler, manual: &Manual, page: &mut Page<'_>) {
    page.section("Definition", "definition");
    page.told(manual, &["What", "Formula"]);
    if let Some(item) = code::item(sampler.about()) {
        let caption = "The code at the heart of it, as it ran for this page.";
        page.listing(&format!("lst-sampler-{}", subject.key), &item, caption);
    }
}

/// What it declares, and what was counted.
fn guarantees(subject: &Subject, manual: &Manual, page: &mut Page<'_>) {
    page.section("Guarantees", "guarantees");
    page.block("Proven by tests over many counts, dimensions and seeds:");
    page.list(subject.method.guarantees().iter().map(|guarantee| typeset(&upper(&guarantee.to_string()), &[])));
    page.words(manual, "Guarantees");
    let Some(n) = nearest_count(&subject.method, 64, subject.d) else { return };
    let base =
        subject.method.net(subject.d).or_else(|| subject.method.whole_net(n, subject.d)).map_or(2, |net| net.base);
    let family: Vec<String> = subject.method.family().map(|method| method.name()).collect();
    let caption = format!(
        "What the sampler declares, alone and with each scramble, and what was counted over {SETS} seeds with {n} points {}. A method that no seed changes was looked at once.",
        subject.in_words()
    );
    let fence = Fence::new("guarantees", &subject.id("tbl", "guarantees")).words("samplers", &family);
    let fence = fence.words("properties", properties(subject.d)).with("n", n).with("dimensions", subject.d);
    let fence = fence.with("base", base).with("seeds", SETS).caption(&caption);
    page.experiment(&fence.claims(claims::guarantees(subject, n)));
}

/// What is looked at in so many dimensions.
fn properties(d: usize) -> &'static [&'static str] {
    if d == 1 {
        &["latin", "net", "prefix", "fixed"]
    } else {
        &["latin", "cells", "net", "prefix", "separated", "fixed"]
    }
}

fn shown(subject: &Subject, page: &mut Page<'_>) {
    page.section("Points", "points");
    let several = told(&subject.counts);
    if subject.counts != COUNTS {
        page.block(&format!("The counts nearest to {} that the sampler admits are {several}.", told(&COUNTS)));
    }
    let squares = subject.d == 1 || subject.counts.iter().all(|n| n.isqrt().pow(2) == *n);
    let lines = if subject.d == 1 { "slabs" } else { "cells" };
    let strata = if squares { format!(", with as many equal {lines}") } else { String::new() };
    let caption = format!("{several} points {}{strata}.", subject.in_words());
    let fence = Fence::new("points", &subject.id("fig", "points")).words("samplers", &[subject.key]);
    let fence = fence.numbers("n", &subject.counts).with("dimensions", subject.d);
    let fence = if squares { fence.word("strata", "cells") } else { fence };
    page.experiment(&fence.caption(&caption).claims(claims::points(subject)));
}

fn spectrum(subject: &Subject, page: &mut Page<'_>) {
    page.section("Spectrum", "spectrum");
    if subject.d == 1 {
        return page.block("Spectra are shown of points in the plane; this sampler has one dimension.");
    }
    let Some(n) = nearest_count(&subject.method, 256, 2) else { return };
    let sets = if subject.method.is_random() {
        format!("averaged over {SETS} sets")
    } else {
        "of the one set that there is, since no seed changes it".to_owned()
    };
    let caption = format!(
        "The power spectrum of {n} points, {sets}: black for no power, white for twice that of independent points; the frequency zero is in the ring. Beside it the mean over all directions."
    );
    let fence = Fence::new("spectrum", &subject.id("fig", "spectrum")).words("samplers", &[subject.key]);
    let fence = fence.with("n", n).with("replicates", SETS).with("reach", 40).word("show", "both");
    page.experiment(&fence.caption(&caption).claims(claims::spectrum(subject)));
}

fn evenness(subject: &Subject, shelves: &[Shelf], page: &mut Page<'_>) {
    page.section("Evenness", "evenness");
    let about = |key: &str| crate::catalogue::find(crate::metrics::METRICS, key).map(crate::catalogue::Entry::about);
    let measures = measures(subject.d);
    let named = measures.iter().filter_map(|key| Some(member(Shelf::Measures, about(key)?, shelves)));
    page.block(&format!("Measured: {}.", named.collect::<Vec<_>>().join(", ")));
    let count = if subject.is_slow() { 4 } else { 16 };
    let sets = if subject.method.is_random() { format!(": means over {count} sets") } else { String::new() };
    let caption = format!("How even the sets are {}{sets}.", subject.in_words());
    let fence = Fence::new("measures", &subject.id("tbl", "measures")).words("samplers", &[subject.key]);
    let fence = fence.numbers("n", &subject.counts).with("dimensions", subject.d).words("measures", measures);
    let fence = fence.with("strata", false).with("replicates", count).caption(&caption);
    page.experiment(&fence.claims(claims::measures(subject)));
}

/// What is measured in so many dimensions.
pub(super) fn measures(d: usize) -> &'static [&'static str] {
    if d == 1 {
        &["t-value", "star-discrepancy", "l2-star", "minimum-distance"]
    } else {
        &["t-value", "star-discrepancy", "l2-star", "minimum-distance", "relative-radius"]
    }
}

fn convergence(subject: &Subject, page: &mut Page<'_>) {
    page.section("Convergence", "convergence");
    let (asked, sets): (&[usize], usize) =
        if subject.is_slow() { (&[16, 32, 64, 128, 256], SETS / 4) } else { (&[16, 64, 256, 1024, 4096], SETS / 2) };
    let counts = counts(&[subject.method], asked, subject.d);
    let error = if subject.method.is_random() {
        format!("The root mean square error over {sets} runs")
    } else {
        "The error, the same for every seed,".to_owned()
    };
    let caption = format!(
        "{error} for five integrands: smooth, a sum over the axes, with a kink, {}, and with an edge across the first axis. The reference lines are those of independent samples.",
        if subject.d == 1 { "a wave" } else { "with a curved edge" }
    );
    let fence = Fence::new("convergence", &subject.id("fig", "convergence")).words("samplers", &[subject.key]);
    let fence = fence.words("integrands", subject.integrands()).numbers("n", &counts).with("replicates", sets);
    let fence = fence.with("dimensions", subject.d).caption(&caption);
    page.experiment(&fence.claims(claims::convergence(subject, &counts)));
}

fn picture(subject: &Subject, page: &mut Page<'_>) {
    page.section("A picture", "picture");
    let (key, width, height) = SCENE;
    // Where points are searched for, a set for every pixel would take too long.
    let random = subject.method.is_random() && !subject.is_slow();
    let scene: Option<&'static dyn Scene> = crate::catalogue::find(SCENES, key);
    let randomisation = if random { Randomisation::Pixel } else { Randomisation::Shift };
    let fits = |n: &usize| {
        let sampling = Sampling { method: subject.method, looks: *n, lights: 1, randomisation, padded: false };
        scene.is_some_and(|scene| sampling.arrange(scene.parts()).is_ok())
    };
    let near = [4, 2].into_iter().filter_map(|d| nearest_count(&subject.method, 16, d));
    let Some(n) = near.into_iter().find(fits) else {
        return page.block("The scene has axes in pairs, for which this sampler has no points.");
    };
    let differ = if random {
        "Each pixel has points of its own."
    } else {
        "All pixels have the same points, each shifted at random."
    };
    let caption = format!("Soft shadows with {n} samples a pixel, and what differs from a reference. {differ}");
    let fence =
        Fence::new("render", &subject.id("fig", "picture")).word("scene", key).words("samplers", &[subject.key]);
    let fence = fence.with("n", n).word("randomisation", if random { "pixel" } else { "shift" });
    let fence =
        fence.with("width", width).with("height", height).words("show", &["pictures", "differences"]).with("zoom", 2);
    page.experiment(&fence.caption(&caption));
}

fn limits(subject: &Subject, sampler: &dyn Sampler, manual: &Manual, page: &mut Page<'_>) {
    page.section("Cost and limits", "limits");
    page.told(manual, &["Cost", "Limits"]);
    let setting = |setting: &Setting| {
        let default = typeset(&setting.default.to_string(), &[]);
        format!(
            "`{}`: {}; {}, {default} where it is not written",
            setting.name,
            typeset(setting.meaning, &[]),
            setting.limits()
        )
    };
    if !sampler.settings().is_empty() {
        let example = format!("{}({}={})", subject.key, sampler.settings()[0].name, sampler.settings()[0].least);
        page.block(&format!("**Settings.** It can be told by name, as in `{example}`:"));
        page.list(sampler.settings().iter().map(setting));
    }
    page.block(&format!(
        "**To use it.** A chapter writes `samplers = [\"{0}\"]`, and the command line `workbook points {0} -n {1} -d {2}`.",
        subject.key, subject.counts.first().copied().unwrap_or(16), subject.d
    ));
}

/// With what it can be combined.
fn family(subject: &Subject, shelves: &[Shelf], page: &mut Page<'_>) {
    let scrambles: Vec<String> = subject
        .method
        .family()
        .filter_map(|method| method.scramble())
        .map(|scramble| {
            let about = scramble.about();
            let link = choice::member(Shelf::Scrambles, about, shelves);
            format!("{link} (`{}+{}`)", subject.key, about.key)
        })
        .collect();
    let none = match subject.method.sampler().digits() {
        Digits::None => "Its coordinates are no digits, and no scramble combines with it.",
        _ => "No scramble combines with it.",
    };
    page.section("Scrambles", "scrambles");
    page.block(&match &scrambles[..] {
        [] => none.to_owned(),
        [one] => format!("One scramble combines with it: {one}."),
        many => format!("It combines with {}.", many.join(", ")),
    });
}

/// A sentence's beginning.
fn upper(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

/// Numbers in words: `16, 64 and 256`.
pub(super) fn told(numbers: &[usize]) -> String {
    let words: Vec<String> =
        numbers.iter().map(|number| plain(&crate::chart::number::integer(*number as i64))).collect();
    match words.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}
