//! The JSON schemas: every fence and every configuration that is right satisfies them, and what is wrong does not.

use std::path::Path;

use serde_json::{Value as Json, json};
use workbook::compose::{Request, check};
use workbook::kinds::KINDS;
use workbook::schema;

use crate::course::{Course, PACKAGE, small};

/// What is wrong with `value` by `schema`: as much of JSON schema as the schemas use, and no keyword that is not understood.
fn wrong(value: &Json, schema: &Json, root: &Json) -> Option<String> {
    let of = |schema: &Json| wrong(value, schema, root);
    let fitting = |rule: &Json| rule.as_array().unwrap().iter().filter(|one| of(one).is_none()).count();
    schema.as_object().unwrap().iter().find_map(|(keyword, rule)| {
        let holds = match keyword.as_str() {
            "$schema" | "$defs" | "title" | "description" | "default" | "then" => true,
            "$ref" => return of(&root["$defs"][rule.as_str().unwrap().strip_prefix("#/$defs/").unwrap()]),
            "properties" | "additionalProperties" => return property_wrong(value, schema, root),
            "allOf" => return rule.as_array().unwrap().iter().find_map(of),
            "if" => return if of(rule).is_none() { of(&schema["then"]) } else { None },
            "anyOf" => fitting(rule) > 0,
            "oneOf" => fitting(rule) == 1,
            "not" => of(rule).is_some(),
            "items" => value.as_array().is_none_or(|items| items.iter().all(|item| wrong(item, rule, root).is_none())),
            plain => holds(value, plain, rule),
        };
        (!holds).then(|| format!("{value} against {keyword}: {rule}"))
    })
}

/// Whether `value` satisfies a keyword that needs no other schema.
fn holds(value: &Json, keyword: &str, rule: &Json) -> bool {
    let (number, size) = (rule.as_f64(), rule.as_u64().unwrap_or_default() as usize);
    let (text, items, object) = (value.as_str(), value.as_array(), value.as_object());
    let every = |keys: &Json| {
        object
            .is_none_or(|object| keys.as_array().unwrap().iter().all(|key| object.contains_key(key.as_str().unwrap())))
    };
    match keyword {
        "type" => match rule {
            Json::Array(names) => names.iter().any(|name| is(value, name.as_str().unwrap())),
            name => is(value, name.as_str().unwrap()),
        },
        "enum" => rule.as_array().unwrap().contains(value),
        "const" => value == rule,
        "pattern" => text.is_none_or(|text| regex_lite::Regex::new(rule.as_str().unwrap()).unwrap().is_match(text)),
        "minimum" => value.as_f64().is_none_or(|value| value >= number.unwrap()),
        "maximum" => value.as_f64().is_none_or(|value| value <= number.unwrap()),
        "minLength" => text.is_none_or(|text| text.chars().count() >= size),
        "minItems" => items.is_none_or(|items| items.len() >= size),
        "maxItems" => items.is_none_or(|items| items.len() <= size),
        "uniqueItems" => {
            items.is_none_or(|items| items.iter().enumerate().all(|(at, item)| !items[..at].contains(item)))
        }
        "minProperties" => object.is_none_or(|object| object.len() >= size),
        "required" => every(rule),
        "dependentRequired" => object.is_none_or(|object| {
            rule.as_object().unwrap().iter().all(|(key, needed)| !object.contains_key(key) || every(needed))
        }),
        unknown => panic!("the keyword `{unknown}` is not understood"),
    }
}

fn is(value: &Json, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        other => panic!("there is no type `{other}`"),
    }
}

fn property_wrong(value: &Json, schema: &Json, root: &Json) -> Option<String> {
    for (key, inner) in value.as_object()? {
        let told = match (schema["properties"].get(key), schema.get("additionalProperties")) {
            (Some(own), _) => wrong(inner, own, root),
            (None, Some(Json::Bool(false))) => Some("an unknown key".to_owned()),
            (None, Some(rest)) => wrong(inner, rest, root),
            (None, None) => None,
        };
        if told.is_some() {
            return told.map(|told| format!("{key}: {told}"));
        }
    }
    None
}

fn table(text: &str) -> Json {
    serde_json::to_value(text.parse::<toml::Table>().unwrap()).unwrap()
}

/// The folders of courses that are right.
const COURSES: [&str; 7] = [
    "",
    "starter",
    "tests/books/gallery",
    "tests/books/everything",
    "tests/books/steppers",
    "tests/books/site",
    "tests/books/appendices",
];

#[test]
fn all_that_is_written_in_the_courses_satisfies_the_schemas() {
    let (fence, listing) = (schema::fence(), schema::listing());
    let (front, configuration) = (schema::front_matter(), schema::configuration());
    let (mut fences, mut told) = (0, Vec::new());
    for folder in COURSES {
        let root = Path::new(PACKAGE).join(folder);
        let planned = check(&Request { root: root.clone(), threads: 1, cached: false, audience: None });
        let mut hold = |text: &str, schema: &Json, what: &str| {
            told.extend(wrong(&table(text), schema, schema).map(|why| format!("{folder}: {what}: {why}")));
        };
        hold(&std::fs::read_to_string(root.join("chapters/workbook.toml")).unwrap(), &configuration, "workbook.toml");
        for chapter in &planned.course.chapters {
            for found in &chapter.content.experiments {
                fences += 1;
                hold(&found.text, &fence, &chapter.file);
            }
            for found in &chapter.content.listings {
                hold(&found.text, &listing, &chapter.file);
            }
            let text = planned.workspace.excerpt(&chapter.file).unwrap();
            hold(text.split("+++").nth(1).unwrap(), &front, &chapter.file);
        }
    }
    assert!(told.is_empty(), "{told:#?}");
    assert!(fences > 200, "only {fences} fences were found");
}

#[test]
fn what_is_wrong_does_not_satisfy_them() {
    let schema = schema::fence();
    let good = json!({
        "id": "fig-a", "kind": "convergence", "integrand": "x*y", "samplers": ["independent", "sobol+owen"],
        "n": ["2^4..2^6", 100], "replicates": 16, "caption": "A.",
        "claims": { "slope.independent": { "near": -0.5, "within": 0.1 }, "best": { "equals": "jittered" }, "slope": { "jittered": { "below": 0 } } },
    });
    assert_eq!(wrong(&good, &schema, &schema), None);
    let changes: [(&str, Json); 13] = [
        ("id", json!("figure_a")),
        ("id", json!("lst-a")),
        ("kind", json!("convergance")),
        ("sampler", json!("independent")),
        ("unknown", json!(1)),
        ("replicates", json!("many")),
        ("replicates", json!(1)),
        ("n", json!("2^4...2^6")),
        ("samplers", json!([])),
        ("samplers", json!(["Not a name"])),
        ("alt", json!("")),
        ("claims", json!({ "best": { "near": 1 } })),
        ("claims", json!({ "best": { "beneath": 1 } })),
    ];
    for (key, value) in changes {
        let mut bad = good.clone();
        bad[key] = value.clone();
        assert!(wrong(&bad, &schema, &schema).is_some(), "{key} = {value}");
    }
    for key in ["id", "kind", "caption", "integrand"] {
        let mut bad = good.clone();
        bad.as_object_mut().unwrap().remove(key);
        assert!(wrong(&bad, &schema, &schema).is_some(), "without {key}");
    }
    let schema = schema::configuration();
    for text in [
        "title = \"A\"",
        "title = 1\nauthors = \"A\"",
        "title = \"A\"\nauthors = [\"B\"]\nlanguages = \"en\"",
        "title = \"A\"\nauthors = \"B\"\n[budgets]\npage = 0",
    ] {
        assert!(wrong(&table(text), &schema, &schema).is_some(), "{text}");
    }
    assert_eq!(wrong(&table("title = \"A\"\nauthors = \"B\"\n[budgets]\npage = 10"), &schema, &schema), None);
}

#[test]
fn the_command_prints_them_with_every_kind_and_its_meaning() {
    let course = Course::empty();
    for (word, schema) in [
        ("fence", schema::fence()),
        ("listing", schema::listing()),
        ("front-matter", schema::front_matter()),
        ("config", schema::configuration()),
    ] {
        let printed: Json = serde_json::from_str(&course.fine(&["schema", word]).out).unwrap();
        assert_eq!(printed, schema);
        assert_eq!(printed["$schema"], "https://json-schema.org/draft/2020-12/schema");
    }
    let fence = schema::fence();
    for kind in KINDS {
        for doc in kind.parameters() {
            let own = &fence["$defs"][kind.about().key]["properties"][doc.name];
            assert!(own["description"].as_str().is_some_and(|words| words.starts_with(doc.meaning)), "{}", doc.name);
        }
    }
    let replicates = &fence["$defs"]["convergence"]["properties"]["replicates"];
    assert!(replicates["minimum"].is_number() && replicates["default"].is_number(), "{replicates}");
}

#[test]
fn status_tells_of_every_exhibit() {
    let course = small();
    let said = course.fine(&["status"]);
    assert_eq!(said.out.lines().filter(|line| line.ends_with("stale: it has not run yet")).count(), 2, "{}", said.out);
    course.fine(&["build", "--quiet"]);
    assert!(course.fine(&["status"]).err.contains("2 exhibits, 2 fresh, 0 stale"));
    course.edit("chapters/01-one.md", "n = 16\n", "n = 25\n");
    let json: Json = serde_json::from_str(&course.fine(&["status", "--json"]).out).unwrap();
    let points = json!({ "id": "fig-points", "place": "chapters/01-one.md:8", "fresh": false, "why": "its key changed: parameters.n: [16] -> [25]" });
    assert_eq!(json[0], points);
    assert_eq!((&json[1]["id"], &json[1]["fresh"]), (&json!("tbl-estimates"), &json!(true)));
    let said = course.fine(&["status", "--no-cache", "--quiet"]);
    assert!(said.out.lines().all(|line| line.ends_with("the cache is not used")) && said.err.is_empty());
}

#[test]
fn shells_and_the_manual_know_every_command() {
    let course = Course::empty();
    let commands = ["build", "check", "explain", "init", "list", "new", "run", "schema", "status", "verify", "why"];
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let said = course.fine(&["completions", shell]);
        for word in commands.iter().chain(&["no-cache"]) {
            assert!(said.out.contains(word), "{shell} does not know {word}");
        }
        if ["bash", "zsh"].contains(&shell) {
            assert!(said.out.contains("scrambles"), "{shell} does not know the catalogues");
        }
    }
    let page = course.fine(&["man"]).out;
    assert!(page.starts_with(".ie") && page.contains(".TH workbook 1"), "{page}");
    assert!(commands.iter().all(|command| page.contains(command)), "{page}");
    let page = course.fine(&["man", "list"]).out;
    assert!(page.contains("workbook\\-list") && page.contains("scenes"), "{page}");
    let told = course.say(&["man", "biuld"]);
    assert!(told.exit == 2 && told.err.contains("did you mean `build`?"), "{}", told.err);
}
