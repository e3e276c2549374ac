//! `figures.json`: every exhibit with its provenance, for machines.

use serde_json::{Value as Json, json};

use super::Rendering;
use crate::kinds::{Measured, Value};

/// The file's text: the exhibits in the book's order, a line each, numbers in full precision.
pub(super) fn figures(rendering: &Rendering<'_>) -> String {
    let exhibits = (0..rendering.plan.exhibits.len()).map(|index| exhibit(rendering, index).to_string());
    format!("{{\"exhibits\": [\n{}\n]}}\n", exhibits.collect::<Vec<_>>().join(",\n"))
}

fn exhibit(rendering: &Rendering<'_>, index: usize) -> Json {
    let exhibit = &rendering.plan.exhibits[index];
    let shown = &rendering.shown[index];
    let chapter = &rendering.course.chapters[exhibit.chapter];
    let text = rendering.workspace.text(&chapter.file).map(|source| &*source.text).unwrap_or_default();
    let line = text[..exhibit.place.range.start.min(text.len())].matches('\n').count() + 1;
    let values: serde_json::Map<String, Json> =
        shown.outcome.values.iter().map(|(name, measured)| (name.to_owned(), number(measured))).collect();
    let claims: Vec<Json> = shown
        .verdicts
        .iter()
        .map(|verdict| json!({ "value": verdict.value, "bound": verdict.bound_text(), "measured": number(&verdict.measured), "holds": verdict.holds }))
        .collect();
    let page = format!("{}#{}", rendering.href(exhibit.chapter), exhibit.id);
    let files: Vec<&str> = std::iter::once(&page)
        .chain(rendering.files[index].iter().map(|file| &file.path))
        .map(String::as_str)
        .collect();
    json!({
        "id": exhibit.id,
        "kind": exhibit.experiment.kind().about().key,
        "number": rendering.plan.labels.target(&exhibit.id).map(|target| target.number.clone()),
        "chapter": chapter.slug,
        "place": format!("{}:{line}", chapter.file),
        "key": shown.key,
        "parameters": exhibit.experiment.parameters(),
        "seed": exhibit.seed,
        "values": values,
        "claims": claims,
        "files": files,
    })
}

/// A value as JSON; what JSON's numbers cannot hold is written as text.
pub(crate) fn number(measured: &Measured) -> Json {
    match &measured.value {
        Value::Number(number) => {
            serde_json::Number::from_f64(*number).map_or_else(|| json!(number.to_string()), Json::Number)
        }
        Value::Integer(integer) => json!(integer),
        Value::Boolean(truth) => json!(truth),
        Value::Text(text) => json!(text),
    }
}
