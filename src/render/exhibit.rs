//! Exhibits and listings as the templates show them.

use serde::Serialize;

use super::inline::inline_code;
use super::markdown::Writer;
use super::{Rendering, code, pictures, site, stepper, table};
use crate::chart::{Drawing, Stepper};
use crate::diag::Diagnostic;
use crate::exhibits::Verdict;
use crate::plan::{Exhibit, Listing, escape};

#[derive(Serialize)]
struct ExhibitPart<'a> {
    exhibit: ExhibitContext<'a>,
}

#[derive(Serialize)]
struct ExhibitContext<'a> {
    #[serde(flatten)]
    provenance: Provenance<'a>,
    class: &'static str,
    caption: String,
    body: String,
    below: String,
    width: Option<f64>,
    alt: &'a str,
}

/// How an exhibit was made, and what is claimed of it.
#[derive(Serialize)]
pub(super) struct Provenance<'a> {
    id: &'a str,
    label: String,
    kind: &'static str,
    parameters: Vec<ParameterContext>,
    seed: u64,
    key: &'a str,
    short_key: &'a str,
    claims: Vec<ClaimContext>,
    /// How many statements were verified; where they are many, a line of `claims` tells of several.
    pub(super) verdicts: usize,
    downloads: Vec<DownloadContext<'a>>,
}

#[derive(Serialize)]
struct DownloadContext<'a> {
    href: &'a str,
    label: &'a str,
}

#[derive(Serialize)]
struct ClaimContext {
    statement: String,
    holds: bool,
}

#[derive(Serialize)]
struct ParameterContext {
    name: String,
    value: String,
}

#[derive(Serialize)]
struct ListingPart<'a> {
    listing: ListingContext<'a>,
}

#[derive(Serialize)]
struct ListingContext<'a> {
    id: &'a str,
    label: String,
    caption: String,
    code: String,
    language: &'a str,
    source: &'a str,
    /// The page of the code, if the course says where that is.
    source_page: Option<String>,
}

/// How many characters of a key a reader sees.
const SHORT_KEY: usize = 12;

/// The exhibit with this index in the plan.
pub(super) fn render(rendering: &Rendering<'_>, index: usize) -> (String, Vec<Diagnostic>) {
    let exhibit = &rendering.plan.exhibits[index];
    let shown = &rendering.shown[index];
    let (caption, mut diagnostics) = Writer::new(rendering, exhibit.chapter).inline(&exhibit.caption);
    let (class, body, width) = match &*shown.drawing {
        Drawing::Figure(figure) | Drawing::Stepper(Stepper { figure, .. }) => {
            ("figure", figure.in_a_page(), Some(figure.width))
        }
        Drawing::Table(drawn) => ("table", table::html(drawn, rendering.converter), None),
        Drawing::Pictures(drawn) => ("pictures", pictures::html(&exhibit.id, drawn, rendering.converter), None),
    };
    let below = match &*shown.drawing {
        Drawing::Stepper(drawn) => stepper::html(&exhibit.id, drawn, rendering, &mut diagnostics),
        _ => String::new(),
    };
    let provenance = provenance(rendering, index);
    let context = ExhibitContext { provenance, class, caption, body, below, width, alt: &shown.alt };
    let html = rendering.templates.fill("exhibit.html", &ExhibitPart { exhibit: context }, &mut diagnostics);
    (html, diagnostics)
}

/// How the exhibit with this index in the plan was made.
pub(super) fn provenance<'a>(rendering: &'a Rendering<'_>, index: usize) -> Provenance<'a> {
    let exhibit = &rendering.plan.exhibits[index];
    let shown = &rendering.shown[index];
    let downloads = rendering.files[index].iter();
    Provenance {
        id: &exhibit.id,
        label: label(rendering, &exhibit.id),
        kind: exhibit.experiment.kind().about().key,
        parameters: parameters(exhibit),
        seed: exhibit.seed,
        key: &shown.key,
        short_key: &shown.key[..SHORT_KEY.min(shown.key.len())],
        claims: claims(&shown.verdicts, exhibit),
        verdicts: shown.verdicts.len(),
        downloads: downloads.map(|file| DownloadContext { href: &file.path, label: &file.label }).collect(),
    }
}

/// A listing with its caption and where its code stands.
pub(super) fn listing(rendering: &Rendering<'_>, listing: &Listing) -> (String, Vec<Diagnostic>) {
    let (caption, mut diagnostics) = Writer::new(rendering, listing.chapter).inline(&listing.caption);
    let context = ListingContext {
        id: &listing.id,
        label: label(rendering, &listing.id),
        caption,
        code: code::html(&listing.code, &listing.language, &listing.emphasis, true),
        language: &listing.language,
        source: &listing.source,
        source_page: site::source_of(rendering, &listing.source),
    };
    let html = rendering.templates.fill("listing.html", &ListingPart { listing: context }, &mut diagnostics);
    (html, diagnostics)
}

/// What a reader calls the thing with this id, e.g. `Figure 2.3`.
pub(super) fn label(rendering: &Rendering<'_>, id: &str) -> String {
    rendering
        .plan
        .labels
        .target(id)
        .map_or_else(String::new, |target| format!("{} {}", target.kind.word(), target.number))
}

/// More verdicts than this on one claim are told in one line.
const LISTED: usize = 3;

/// The claims of an exhibit with their verdicts: one line each, or one for all values that a `*` stands for if they are many.
fn claims(verdicts: &[Verdict], exhibit: &Exhibit) -> Vec<ClaimContext> {
    let mut claims: Vec<(usize, usize)> = verdicts.iter().map(|verdict| verdict.claim).collect();
    claims.sort_unstable();
    claims.dedup();
    let of = |claim| verdicts.iter().filter(|verdict| verdict.claim == claim).collect::<Vec<_>>();
    claims
        .into_iter()
        .flat_map(|claim| match of(claim) {
            many if many.len() > LISTED => vec![summed_up(&many, &exhibit.claims[claim.0].value)],
            few => few.into_iter().map(stated).collect(),
        })
        .collect()
}

fn stated(verdict: &Verdict) -> ClaimContext {
    let (value, measured) = (inline_code(&verdict.value), verdict.measured_html());
    let statement =
        format!("{value} =\u{a0}{measured} <span class=\"bound\">(claimed: {})</span>", verdict.bound_html());
    ClaimContext { statement, holds: verdict.holds }
}

/// One line for all values of a claim: how many there are, and from where to where they reach.
fn summed_up(verdicts: &[&Verdict], pattern: &str) -> ClaimContext {
    let mut numbers: Vec<(f64, &Verdict)> =
        verdicts.iter().filter_map(|verdict| Some((verdict.measured.number()?, *verdict))).collect();
    numbers.sort_by(|a, b| a.0.total_cmp(&b.0));
    let range = match numbers.as_slice() {
        [(_, least), .., (_, greatest)] => format!(", from {} to {}", least.measured_html(), greatest.measured_html()),
        _ => String::new(),
    };
    let bound = verdicts.first().map(|verdict| verdict.bound_html()).unwrap_or_default();
    let (pattern, count) = (escape(pattern), verdicts.len());
    let statement = format!(
        "<code>{pattern}</code>: {count} values{range} <span class=\"bound\">(claimed of each: {bound})</span>"
    );
    ClaimContext { statement, holds: verdicts.iter().all(|verdict| verdict.holds) }
}

/// The items of a list; whole numbers that follow each other are a range, such as `1..256`, and so are powers that do: `2^4..2^14`.
fn listed(items: &[serde_json::Value]) -> String {
    let numbers: Option<Vec<u64>> = items.iter().map(serde_json::Value::as_u64).collect();
    let range = numbers.as_deref().and_then(|numbers| {
        let ([first, second, ..], last) = (numbers, *numbers.last()?) else { return None };
        if numbers.len() > 3 && numbers.windows(2).all(|two| two[0] + 1 == two[1]) {
            return Some(format!("{first}..{last}"));
        }
        let base = second.checked_div(*first).filter(|base| *base >= 2)?;
        let exponent = (0..64).find(|&exponent| base.checked_pow(exponent) == Some(*first))?;
        let powers = numbers.len() > 3 && numbers.windows(2).all(|two| two[0].checked_mul(base) == Some(two[1]));
        powers.then(|| format!("{base}^{exponent}..{base}^{}", exponent as usize + numbers.len() - 1))
    });
    let text = |item: &serde_json::Value| item.as_str().map_or_else(|| item.to_string(), str::to_owned);
    range.unwrap_or_else(|| items.iter().map(text).collect::<Vec<_>>().join(", "))
}

fn parameters(exhibit: &Exhibit) -> Vec<ParameterContext> {
    let serde_json::Value::Object(parameters) = exhibit.experiment.parameters() else { return Vec::new() };
    let text = |value: &serde_json::Value| match value {
        serde_json::Value::String(text) => text.clone(),
        serde_json::Value::Array(items) => listed(items),
        other => other.to_string(),
    };
    parameters
        .iter()
        .filter(|(_, value)| !value.is_null())
        .map(|(name, value)| ParameterContext { name: name.clone(), value: text(value) })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn ranges_are_as_a_chapter_writes_them() {
        let text = |numbers: Vec<u64>| listed(&numbers.into_iter().map(serde_json::Value::from).collect::<Vec<_>>());
        assert_eq!(text((1..=256).collect()), "1..256");
        assert_eq!(text(vec![16, 32, 64, 128]), "2^4..2^7");
        assert_eq!(text(vec![1, 3, 9, 27, 81]), "3^0..3^4");
        assert_eq!(text(vec![1, 2, 3]), "1, 2, 3");
        assert_eq!(text(vec![1, 2, 3, 5]), "1, 2, 3, 5");
        assert_eq!(text(vec![6, 12, 24, 48]), "6, 12, 24, 48");
        assert_eq!(listed(&["a".into(), "b".into()]), "a, b");
    }
}
