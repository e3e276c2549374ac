//! The lock: it gives back what was put in, refuses what is broken, and tells every kind of drift.

use std::collections::BTreeSet;
use std::sync::Arc;

use workbook::diag::{Code, Diagnostic, Place, Severity};
use workbook::kinds::{Measured, Value, Values};
use workbook::sources::Digest;
use workbook::verify::drift::{Drift, Now, accept, compare};
use workbook::verify::lock::Lock;

fn now(id: &str, values: &[(&str, f64)]) -> Now {
    let mut all = Values::new();
    for &(name, number) in values {
        all.number(name, number);
    }
    Now {
        id: id.to_owned(),
        kind: "convergence".into(),
        place: Place { file: Arc::from("chapters/03-convergence.md"), range: 10..20 },
        key: Digest::of(b"key"),
        data: Digest::of(format!("{values:?}").as_bytes()),
        drawing: Digest::of(b"drawing"),
        values: all,
    }
}

fn locked(now: &[Now]) -> Lock {
    accept(&Lock::default(), now, None).unwrap()
}

fn shown(drift: &Drift) -> Diagnostic {
    drift.diagnostic(Severity::Error)
}

#[test]
fn gives_back_what_was_put_in() {
    let mut lock =
        locked(&[now("fig-a", &[("slope.sobol+xor", 1e-310), ("exact", -0.0)]), now("fig-ß \"\\\n\u{7f}]", &[])]);
    let record = lock.records.get_mut("fig-a").unwrap();
    let mut put = |name: &str, value: Value, standard_error| {
        record.values.insert(name.to_owned(), Measured { value, standard_error });
    };
    put("not", Value::Number(f64::NAN), None);
    put("most", Value::Number(f64::INFINITY), Some(f64::NAN));
    put("least", Value::Number(f64::NEG_INFINITY), Some(0.1));
    put("small", Value::Number(f64::MIN_POSITIVE / 4.0), None);
    put("large", Value::Number(f64::MAX), None);
    put("whole", Value::Number(1e22), None);
    put("count", Value::Integer(i64::MIN), None);
    put("holds", Value::Boolean(true), Some(1.0));
    put("wörd.\"1\"", Value::Text("a\t\"b\"\\ \u{7f}\u{1}\r\n é".into()), None);
    let text = lock.text();
    let back = Lock::read(&text).unwrap();
    assert_eq!(back.text(), text);
    let values = &back.records["fig-a"].values;
    let bits = |name: &str| match values[name].value {
        Value::Number(number) => number.to_bits(),
        _ => 0,
    };
    assert_eq!(bits("exact"), (-0.0_f64).to_bits());
    assert_eq!(bits("slope.sobol+xor"), 1e-310_f64.to_bits());
    assert_eq!(bits("whole"), 1e22_f64.to_bits());
    assert_eq!(values["holds"], Measured { value: Value::Boolean(true), standard_error: Some(1.0) });
    assert_eq!(values["wörd.\"1\""].value, Value::Text("a\t\"b\"\\ \u{7f}\u{1}\r\n é".into()));
    assert!(back.records.contains_key("fig-ß \"\\\n\u{7f}]"));
}

#[test]
fn gives_back_long_series() {
    let names: Vec<String> = (0..100).map(|n| format!("rmse.halton.{n}")).collect();
    let values: Vec<(&str, f64)> = names.iter().map(|name| (name.as_str(), name.len() as f64)).collect();
    let text = locked(&[now("fig-a", &values)]).text();
    assert!(text.contains("[exhibit.fig-a.series.\"rmse.halton\"]\ncount = 100\n"), "{text}");
    assert_eq!(Lock::read(&text).unwrap().text(), text);
}

#[test]
fn is_text_that_people_can_read() {
    let text = locked(&[now("fig-b", &[("slope", -0.5)]), now("fig-a", &[])]).text();
    let (key, drawing) = (Digest::of(b"key"), Digest::of(b"drawing"));
    let data = Digest::of(b"[(\"slope\", -0.5)]");
    let block = format!(
        "\n[exhibit.fig-b]\nkind = \"convergence\"\nchapter = \"chapters/03-convergence.md\"\nkey = \"{key}\"\n\
         data = \"{data}\"\ndrawing = \"{drawing}\"\n\n[exhibit.fig-b.values]\nslope = -0.5\n"
    );
    assert!(text.ends_with(&block), "{text}");
    assert!(text.find("fig-a") < text.find("fig-b"));
}

#[test]
fn refuses_a_broken_lock_with_its_place() {
    let good = locked(&[now("fig-a", &[("slope", -0.5)])]).text();
    let key = Digest::of(b"key").to_string();
    let cases = [
        (good.replace("[exhibit.fig-a]", "[exhibit.fig-a"), "not TOML"),
        (format!("{good}\n[exhibit.fig-a]\n"), "not TOML"),
        (good.replace("format = 1", "format = 2"), "format 2"),
        (good.replace("format = 1\n", ""), "`format` is missing"),
        (good.replace(&key, &key.to_uppercase()), "`key` cannot be read"),
        (good.replace("kind = \"convergence\"\n", ""), "`kind` is missing"),
        (good.replace("kind =", "kinds ="), "no key `kinds`"),
        (good.replace("slope = -0.5", "slope = [1]"), "`slope` is no value"),
        (good.replace("slope = -0.5", "slope = { value = 1.0, error = 2 }"), "`slope` is no value"),
        (good.replace("slope = -0.5", "slope = { value = 1.0, error = 2.0, more = 3 }"), "no key `more`"),
        ("format = 1\nexhibit = 3\n".to_owned(), "`exhibit` must be a table"),
        ("format = 1\n[exhibit]\nfig-a = 3\n".to_owned(), "`fig-a` must be a table"),
        ("<<<<<<< ours\n".to_owned() + &good, "not TOML"),
        (String::new(), "`format` is missing"),
    ];
    for (text, message) in cases {
        let complaints = Lock::read(&text).unwrap_err();
        assert!(complaints.iter().any(|complaint| complaint.message.contains(message)), "{message}: {complaints:?}");
        for complaint in complaints {
            assert_eq!(complaint.code, Code::Lock);
            let place = complaint.place.unwrap();
            assert_eq!(&*place.file, "book/workbook.lock");
            assert!(place.range.end <= text.len(), "{message}");
        }
    }
}

#[test]
fn never_panics_on_a_cut_lock() {
    let text = locked(&[now("fig-ä", &[("slope", -0.5), ("exact", 1e-310)])]).text();
    for (at, _) in text.char_indices() {
        let _ = Lock::read(&text[..at]);
        let _ = Lock::read(&text[at..]);
    }
}

#[test]
fn the_same_book_does_not_drift() {
    let book = [now("fig-a", &[("slope", -0.5)]), now("tbl-b", &[])];
    assert_eq!(compare(&locked(&book), &book), []);
    let read = Lock::read(&locked(&book).text()).unwrap();
    assert_eq!(compare(&read, &book), []);
    let mut rewritten = book.clone();
    rewritten[0].key = Digest::of(b"other code, same numbers");
    rewritten[0].place.range = 100..200;
    assert_eq!(compare(&read, &rewritten), []);
}

#[test]
fn tells_changed_data_with_old_and_new_values() {
    let lock = locked(&[now("fig-a", &[("slope", -0.5), ("gone", 1.0), ("same", 2.0)])]);
    let mut after = now("fig-a", &[("slope", -0.25), ("same", 2.0)]);
    after.values.estimate("new", 0.1, 0.01);
    after.drawing = Digest::of(b"another");
    after.key = Digest::of(b"another");
    let found = compare(&lock, std::slice::from_ref(&after));
    assert_eq!(found.len(), 1, "{found:?}");
    let told = shown(&found[0]);
    assert_eq!((told.code, told.place), (Code::Drift, Some(after.place)));
    assert_eq!(told.message, "the data of `fig-a` changed since the lock; 3 values did");
    assert_eq!(
        told.help,
        [
            "gone: 1.0 -> absent",
            "new: absent -> 0.1 ± 0.01",
            "slope: -0.5 -> -0.25",
            "review it, then `workbook accept fig-a`"
        ]
    );
    assert_eq!(found[0].diagnostic(Severity::Warning).severity, Severity::Warning);
}

#[test]
fn tells_data_that_changed_below_the_values() {
    let lock = locked(&[now("fig-a", &[("slope", -0.5)])]);
    let mut after = now("fig-a", &[("slope", -0.5)]);
    after.data = Digest::of(b"another");
    let told = shown(&compare(&lock, &[after])[0]);
    assert_eq!(told.message, "the data of `fig-a` changed since the lock; none of its values did");
    assert!(told.help[0].starts_with("the key is that of the lock"), "{told:?}");
}

#[test]
fn lists_eight_changes_and_counts_the_rest() {
    let names: Vec<String> = (0..12).map(|n| format!("rmse.{n:02}")).collect();
    let book = |factor: f64| {
        let values: Vec<(&str, f64)> = names.iter().map(|name| (name.as_str(), factor)).collect();
        now("fig-a", &values)
    };
    let told = shown(&compare(&locked(&[book(1.0)]), &[book(2.0)])[0]);
    assert_eq!(told.help.len(), 8 + 3, "{told:?}");
    assert_eq!(told.help[8], "and 4 more");
}

#[test]
fn tells_what_changed_in_a_long_series() {
    let names: Vec<String> = (0..100).map(|n| format!("rmse.{n}")).collect();
    let book = |fifty: f64| {
        let value = |name: &str| if name == "rmse.50" { fifty } else { 1.0 };
        now("fig-a", &names.iter().map(|name| (name.as_str(), value(name))).collect::<Vec<_>>())
    };
    let told = shown(&compare(&locked(&[book(1.0)]), &[book(3.0)])[0]);
    assert_eq!(told.help[0], "rmse.* (maximum): 1.0 -> 3.0");
    assert!(told.help[1].starts_with("rmse.* (digest): "), "{told:?}");
}

#[test]
fn tells_a_drawing_apart_from_data() {
    let lock = locked(&[now("fig-a", &[("slope", -0.5)])]);
    let mut after = now("fig-a", &[("slope", -0.5)]);
    after.drawing = Digest::of(b"another colour");
    let found = compare(&lock, &[after]);
    assert!(matches!(&found[..], [Drift::Drawing { id, .. }] if id == "fig-a"), "{found:?}");
    assert!(shown(&found[0]).message.contains("its data did not"));
}

#[test]
fn tells_what_only_one_of_them_has() {
    let lock = Lock::read(&locked(&[now("fig-a", &[]), now("fig-old", &[])]).text()).unwrap();
    let found = compare(&lock, &[now("fig-new", &[]), now("fig-a", &[])]);
    assert!(matches!(&found[..], [Drift::New { .. }, Drift::Missing { .. }]), "{found:?}");
    assert_eq!(found.iter().map(Drift::id).collect::<Vec<_>>(), ["fig-new", "fig-old"]);
    let missing = shown(&found[1]);
    let place = missing.place.unwrap();
    assert_eq!(&locked(&[now("fig-a", &[]), now("fig-old", &[])]).text()[place.range], "fig-old");
    assert!(missing.message.contains("chapters/03-convergence.md"));
}

#[test]
fn accepts_what_was_reviewed_and_nothing_else() {
    let lock = locked(&[now("fig-a", &[("x", 1.0)]), now("fig-b", &[("x", 1.0)]), now("fig-old", &[])]);
    let book = [now("fig-a", &[("x", 2.0)]), now("fig-b", &[("x", 2.0)]), now("fig-new", &[])];
    let ids = |ids: &[&str]| Some(ids.iter().map(|&id| id.to_owned()).collect::<BTreeSet<_>>());
    let drifted = |lock: &Lock| compare(lock, &book).iter().map(|drift| drift.id().to_owned()).collect::<Vec<_>>();
    assert_eq!(drifted(&lock), ["fig-a", "fig-b", "fig-new", "fig-old"]);
    let some = accept(&lock, &book, ids(&["fig-a", "fig-old"]).as_ref()).unwrap();
    assert_eq!(drifted(&some), ["fig-b", "fig-new"]);
    assert!(drifted(&accept(&lock, &book, None).unwrap()).is_empty());
    assert_eq!(accept(&lock, &book, ids(&["fig-a", "fig-x"]).as_ref()), Err(vec!["fig-x".to_owned()]));
}
