//! Tests of what is recorded and how.

use super::*;

fn values(count: i64) -> Values {
    let mut values = Values::new();
    for n in 0..count {
        values.number(format!("rmse.halton.{n}"), (n as f64) / 3.0);
    }
    values.number("exact", 0.1);
    values.text("best", "halton");
    values
}

#[test]
fn few_values_are_recorded_in_full() {
    let (full, series) = summarised(&values(62));
    assert_eq!((full.len(), series.len()), (64, 0));
}

#[test]
fn a_long_series_is_recorded_by_its_summary() {
    let (full, series) = summarised(&values(63));
    assert_eq!(full.keys().collect::<Vec<_>>(), ["best", "exact"]);
    let halton = &series["rmse.halton"];
    assert_eq!((halton.count, halton.minimum, halton.first), (63, 0.0, 0.0));
    assert_eq!((halton.maximum, halton.last), (62.0 / 3.0, 62.0 / 3.0));
}

#[test]
fn a_series_sees_every_number() {
    let digest = |values: &Values| summarised(values).1["rmse.halton"].digest;
    let mut other = values(100);
    other.number("rmse.halton.50", 0.5);
    assert_ne!(digest(&other), digest(&values(100)));
}

#[test]
fn short_series_stay_in_full_among_many_values() {
    let mut many = values(70);
    for n in 0..16 {
        many.number(format!("slope.{n}"), 1.0);
    }
    let (full, series) = summarised(&many);
    assert_eq!((full.len(), series.len()), (18, 1));
}

#[test]
fn numbers_order_names() {
    let mut values = Values::new();
    for n in [1024, 16, 2] {
        values.integer(format!("n.{n}"), n);
    }
    let (full, series) = summarised(&values);
    let record = Record {
        kind: "points".into(),
        chapter: "chapters/01.md".into(),
        key: Digest::of(b"k"),
        data: Digest::of(b"d"),
        drawing: Digest::of(b"g"),
        values: full,
        series,
        place: None,
    };
    let text = Lock { records: BTreeMap::from([("fig-a".into(), record)]) }.text();
    assert!(text.ends_with("[exhibit.fig-a.values]\n\"n.2\" = 2\n\"n.16\" = 16\n\"n.1024\" = 1024\n"), "{text}");
}
