//! JSON schemas (2020-12) of what authors write, made from the declarations that read it: editors complete and check with them.

use serde_json::{Map, Value as Json, json};

use crate::integrands::{Function, INTEGRANDS};
use crate::kinds::{AnyKind, KINDS};
use crate::parameters::{ParameterDoc, ParameterType};
use crate::parse::documented;
use crate::plan::listing_docs;
use crate::samplers::{Method, SAMPLERS};

/// The dialect of all schemas.
const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The largest whole number that every reader of JSON keeps.
const LARGEST: u64 = 9_007_199_254_740_991;

/// The schema of an `experiment` fence: what all kinds have, and for each kind its parameters.
pub fn fence() -> Json {
    let keys: Vec<&str> = KINDS.iter().map(|kind| kind.about().key).collect();
    let branch = |key: &&str| {
        json!({
            "if": { "properties": { "kind": { "const": key } }, "required": ["kind"] },
            "then": { "$ref": format!("#/$defs/{key}") },
        })
    };
    let mut definitions: Map<String, Json> =
        KINDS.iter().map(|kind| (kind.about().key.to_owned(), of_kind(*kind))).collect();
    definitions.insert("claims".to_owned(), claims());
    definitions.insert("claim".to_owned(), claim());
    json!({
        "$schema": DIALECT,
        "title": "An experiment fence of a workbook's chapter",
        "type": "object",
        "properties": { "kind": { "enum": keys, "description": "What is to be computed; `workbook list kinds` tells of each." } },
        "required": ["id", "kind", "caption"],
        "allOf": keys.iter().map(branch).collect::<Vec<_>>(),
        "$defs": definitions,
    })
}

/// The schema of a `listing` fence.
pub fn listing() -> Json {
    let mut schema = table("The listing fence of a workbook's chapter", &listing_docs());
    schema["properties"]["id"] = id("lst");
    schema["oneOf"] = json!([{ "required": ["item"] }, { "required": ["file"] }]);
    with_dialect(schema)
}

/// The schema of a chapter's front matter.
pub fn front_matter() -> Json {
    let mut schema = table("The front matter of a workbook's chapter", &documented::front_matter());
    schema["properties"]["given"] = json!({
        "type": "object",
        "description": "Numbers that the text states and no experiment gives, each with the reason.",
    });
    with_dialect(schema)
}

/// The schema of `workbook.toml`.
pub fn configuration() -> Json {
    let settings = documented::settings();
    let mut schema = table("The settings of a workbook, chapters/workbook.toml", &settings.head);
    for (name, docs) in &settings.tables {
        schema["properties"][name] = table(&format!("The table [{name}]"), docs);
    }
    schema["properties"]["landing"] = json!({
        "type": "array",
        "description": "What the landing page says of the course, in passages of markdown.",
        "items": table("A passage of the landing page", &settings.landing),
    });
    let words = |description: &str| json!({ "type": "object", "description": description, "additionalProperties": { "type": "string" } });
    schema["properties"]["redirects"] =
        words("Pages that have moved: the old page, and the new one with an id or without.");
    schema["properties"]["math"] = json!({
        "type": "object",
        "properties": { "macros": words("LaTeX macros: the name, and what it stands for.") },
        "additionalProperties": false,
    });
    with_dialect(schema)
}

fn with_dialect(mut schema: Json) -> Json {
    schema["$schema"] = json!(DIALECT);
    schema
}

/// The schema of a table with these keys and no others.
fn table(title: &str, docs: &[ParameterDoc]) -> Json {
    let mut properties = Map::new();
    let mut all = Vec::new();
    let mut required = Vec::new();
    for doc in docs {
        let own = parameter(doc);
        if let Some(alias) = doc.alias {
            let mut other = own.clone();
            other["description"] = json!(format!("Another name for `{}`.", doc.name));
            properties.insert(alias.to_owned(), other);
            all.push(json!({ "not": { "required": [doc.name, alias] } }));
        }
        properties.insert(doc.name.to_owned(), own);
        match (doc.required, doc.alias) {
            (true, None) => required.push(doc.name),
            (true, Some(alias)) => all.push(json!({ "anyOf": [{ "required": [doc.name] }, { "required": [alias] }] })),
            (false, _) => {}
        }
    }
    let mut schema =
        json!({ "title": title, "type": "object", "properties": properties, "additionalProperties": false });
    if !required.is_empty() {
        schema["required"] = json!(required);
    }
    if !all.is_empty() {
        schema["allOf"] = json!(all);
    }
    schema
}

/// The schema of the fences of one kind.
fn of_kind(kind: &dyn AnyKind) -> Json {
    let about = kind.about();
    let mut schema = table(about.title, &kind.parameters());
    schema["description"] = json!(about.summary);
    let common = [
        ("id", id("fig|tbl")),
        ("kind", json!({ "const": about.key })),
        ("caption", json!({ "type": "string", "description": "What to see in the exhibit, in markdown." })),
        (
            "alt",
            json!({ "type": "string", "minLength": 1, "description": "What it shows, for those who cannot see it; else it is derived from the data." }),
        ),
        (
            "seed",
            json!({ "type": "integer", "minimum": 0, "maximum": LARGEST, "description": "The seed, if it is not the course's." }),
        ),
        ("claims", json!({ "$ref": "#/$defs/claims" })),
    ];
    for (name, own) in common {
        schema["properties"][name] = own;
    }
    schema
}

/// The schema of an id that begins with one of `prefixes`.
fn id(prefixes: &str) -> Json {
    json!({ "type": "string", "pattern": format!("^({prefixes})-[a-z0-9-]*[a-z0-9]$"), "description": "What references name: @fig-name." })
}

/// The schema of `[claims]`: a name without quotes is a table in a table for each of its dots.
fn claims() -> Json {
    json!({
        "type": "object",
        "description": "What must hold of the exhibit's values: each by its name.",
        "additionalProperties": { "anyOf": [{ "$ref": "#/$defs/claim" }, { "$ref": "#/$defs/claims" }] },
    })
}

fn claim() -> Json {
    let amount = |meaning: &str| json!({ "type": ["number", "string"], "description": meaning });
    json!({
        "type": "object",
        "properties": {
            "near": amount("Not further from this than `within`."),
            "within": amount("How near, or within how many standard errors."),
            "below": amount("Less than this."),
            "above": amount("More than this."),
            "equals": { "type": ["number", "string", "boolean"], "description": "Exactly this." },
            "holds": { "type": "boolean", "description": "Whether it is true." },
            "agrees": amount("Another value, or a number: not further from it than `within` standard errors, or 4."),
        },
        "additionalProperties": false,
        "minProperties": 1,
        "dependentRequired": { "near": ["within"] },
    })
}

/// The schema of a parameter, with its meaning, its default and its limits.
fn parameter(doc: &ParameterDoc) -> Json {
    let mut schema = doc.schema.clone();
    if let Some((least, most)) = doc.limits.as_ref().and_then(|limits| limits.split_once(" to ")) {
        limit(&mut schema, &bound(least), &bound(most));
    }
    let mut schema = completed(schema);
    let limits = doc.limits.as_ref().map(|limits| format!(", {limits}")).unwrap_or_default();
    schema["description"] = json!(format!("{} ({}{limits})", doc.meaning, doc.type_name));
    if let Some(default) = doc.default.and_then(value) {
        schema["default"] = default;
    }
    schema
}

/// A limit as a number of JSON.
fn bound(text: &str) -> Json {
    serde_json::from_str(text).unwrap_or(Json::Null)
}

/// A value of TOML as one of JSON.
fn value(text: &str) -> Option<Json> {
    let table: toml::Table = format!("value = {text}").parse().ok()?;
    serde_json::to_value(table.get("value")?).ok()
}

/// Sets the limits of every number in a schema.
fn limit(schema: &mut Json, least: &Json, most: &Json) {
    match schema {
        Json::Object(object) if object.get("type").is_some_and(|kind| kind == "integer" || kind == "number") => {
            for (name, bound) in [("minimum", least), ("maximum", most)] {
                if !bound.is_null() {
                    object.insert(name.to_owned(), bound.clone());
                }
            }
        }
        Json::Object(object) => object.values_mut().for_each(|inner| limit(inner, least, most)),
        Json::Array(items) => items.iter_mut().for_each(|inner| limit(inner, least, most)),
        _ => {}
    }
}

/// A schema with the catalogued names beside the pattern of a method or an integrand, so that editors offer them.
fn completed(schema: Json) -> Json {
    let offered = |keys: Vec<&str>, schema: Json| json!({ "anyOf": [{ "enum": keys }, schema] });
    if schema == Method::schema() {
        return offered(SAMPLERS.iter().map(|sampler| sampler.about().key).collect(), schema);
    }
    if schema == Function::schema() {
        return offered(INTEGRANDS.iter().map(|integrand| integrand.about().key).collect(), schema);
    }
    match schema {
        Json::Object(object) => object.into_iter().map(|(name, inner)| (name, completed(inner))).collect(),
        Json::Array(items) => items.into_iter().map(completed).collect(),
        plain => plain,
    }
}
