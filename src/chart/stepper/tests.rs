//! Steppers: replaying the stored changes gives each frame, byte by byte; the last is shown; small; refusals.

use super::*;
use crate::chart::{Axis, Disks, Marks, Note, Panel, Region, Strata};

fn sheet() -> Sheet {
    Sheet::new("fig-test", "Steps", "A test")
}

/// The frame `step`, counted from 1, found again from a merged SVG as a reader's browser finds it.
fn replay(svg: &str, step: usize) -> String {
    let mut out = String::new();
    let mut shown = true;
    for line in svg.lines() {
        if let Some(group) = line.strip_prefix("<g data-steps=\"") {
            let steps = group.split_once('"').unwrap().0;
            shown = steps.split(',').any(|range| {
                let (from, to) = range.split_once('-').unwrap_or((range, range));
                (from.parse().unwrap()..=to.parse().unwrap()).contains(&step)
            });
        } else if line == "</g>" {
            shown = true;
        } else if shown {
            out.push_str(&placed(line, step));
            out.push('\n');
        }
    }
    out
}

/// A line with its element where it is at `step`.
fn placed(line: &str, step: usize) -> String {
    let Some((head, rest)) = line.split_once(" data-at=\"") else { return line.to_owned() };
    let (places, rest) = rest.split_once("\" transform=\"translate(").unwrap();
    let tail = rest.split_once(")\"").unwrap().1;
    let mut place = places.split(',').map(|place| place.split_once(' ').unwrap());
    let place = place.rfind(|(from, _)| from.parse::<usize>().unwrap() <= step).map_or("", |place| place.1);
    format!("{head} transform=\"translate({place})\"{tail}")
}

/// A frame without what only merging needs.
fn untracked(svg: &str) -> String {
    let line = |line: &str| match line.split_once(" data-key=\"") {
        Some((head, rest)) => format!("{head}{}\n", rest.split_once('"').unwrap().1),
        None => format!("{line}\n"),
    };
    svg.lines().map(line).collect()
}

/// Points that are sorted by swaps, with a region that walks along and notes that come and go.
fn charts(n: usize) -> Vec<Chart> {
    let mut order: Vec<usize> = (0..n).map(|i| (i * 5 + 3) % n).collect();
    let mut charts = Vec::new();
    for step in 0..n {
        let at = order.iter().position(|&value| value == step).unwrap();
        order.swap(step, at);
        let centre = |value: usize| (value as f64 + 0.5) / n as f64;
        let points = order.iter().enumerate().map(|(i, &value)| (centre(i), centre(value))).collect();
        let low = step as f64 / n as f64;
        let mut panel = Panel::unit_square()
            .strata(Strata::slabs(n as u32))
            .with(Region::new((low, 0.0), (low + 1.0 / n as f64, 1.0)))
            .with(Marks::new(points).tracked("points"))
            .with(Note::new((centre(step), 0.5), "here").tracked("here"));
        if step % 3 == 1 {
            panel = panel.with(Note::new((0.5, 0.5), format!("*n* = {step}"))).with(Disks::new(vec![(0.5, 0.5)], 0.6));
        }
        charts.push(Chart::new(panel));
    }
    charts
}

fn stepper(charts: &[Chart]) -> Stepper {
    let mut steps = Steps::new();
    charts.iter().enumerate().for_each(|(i, chart)| steps.push(chart.clone(), format!("step {i}")));
    steps.draw(&sheet()).unwrap()
}

#[test]
fn replaying_the_changes_gives_each_frame() {
    let charts = charts(16);
    let stepper = stepper(&charts);
    assert_eq!(stepper.captions.len(), 16);
    for (index, chart) in charts.iter().enumerate() {
        let frame = untracked(&chart.draw(&sheet()).unwrap().svg);
        assert!(!frame.contains("data-key"));
        assert_eq!(replay(&stepper.figure.svg, index + 1), frame, "step {}", index + 1);
    }
    assert!(stepper.figure.svg.len() < 20_000, "{}", stepper.figure.svg.len());
}

#[test]
fn the_file_by_itself_shows_the_last_frame() {
    let charts = charts(8);
    let stepper = stepper(&charts);
    let (mut shown, mut hidden) = (String::new(), false);
    for line in stepper.figure.svg.lines() {
        hidden = if line.starts_with("<g ") { line.contains("display=\"none\"") } else { hidden };
        if !hidden && !line.starts_with("<g ") && line != "</g>" {
            shown.push_str(&placed(line, 8));
            shown.push('\n');
            // A tracked element stands where the last step puts it.
            let place = |line: &str| line.split_once("translate(").map(|(_, rest)| rest.to_owned());
            assert_eq!(place(line), place(&placed(line, 8)));
        }
        hidden &= line != "</g>";
    }
    assert_eq!(shown, replay(&stepper.figure.svg, 8));
}

#[test]
fn elements_that_all_frames_have_stand_once() {
    let charts = charts(16);
    let stepper = stepper(&charts);
    let count = |part: &str| stepper.figure.svg.matches(part).count();
    assert_eq!((count("<title"), count("</svg>"), count(">here<")), (1, 1, 1));
    // One mark for each point.
    assert_eq!(count("d=\"M0 0h0\""), 16);
}

#[test]
fn key_steps_are_before_the_last() {
    let charts = charts(9);
    let drawn = stepper(&charts);
    assert_eq!(drawn.strip.iter().map(|key| key.step).collect::<Vec<_>>(), [1, 4, 7]);
    assert!(drawn.strip.iter().all(|key| !key.figure.svg.contains("data-") && key.figure.width == 190.0));
    let mut steps = Steps::new().key_steps([9, 0, 3, 3, 99]);
    for chart in &charts {
        steps.push(chart.clone(), "");
    }
    assert_eq!(steps.draw(&sheet()).unwrap().strip.iter().map(|key| key.step).collect::<Vec<_>>(), [3]);
    assert!(stepper(&charts[..1]).strip.is_empty());
}

#[test]
fn what_is_no_stepper_is_refused() {
    assert_eq!(Steps::new().draw(&sheet()), Err(ChartError::NoPanel));
    let mut many = Steps::new();
    let charts = charts(2);
    (0..=MOST_STEPS).for_each(|_| many.push(charts[0].clone(), ""));
    assert!(matches!(many.draw(&sheet()), Err(ChartError::Drawing(_))));
    let mut uneven = Steps::new();
    uneven.push(charts[0].clone(), "");
    let high = Panel::new(Axis::linear(""), Axis::linear("")).ratio(2.0).with(Marks::new(vec![(0.0, 0.0)]));
    uneven.push(Chart::new(high), "");
    assert!(matches!(uneven.draw(&sheet()), Err(ChartError::Drawing(_))));
}
