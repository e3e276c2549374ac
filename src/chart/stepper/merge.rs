//! Merging of frames: each element once, with the steps that show it and the places to which it moves; and paths that look alike joined.

use crate::chart::backend::TRACK;
use std::fmt::Write;

/// An element of a frame: one line of its SVG.
struct Element<'a> {
    /// The line up to where a place would stand, and from there on.
    parts: (&'a str, &'a str),
    /// What it is tracked as, and where it is.
    tracked: Option<(&'a str, &'a str)>,
}

/// An element of several frames.
struct Merged<'a> {
    parts: (&'a str, &'a str),
    key: Option<&'a str>,
    /// Whether each step shows it.
    seen: Vec<bool>,
    /// Where it is from which step on, counted from 0.
    places: Vec<(usize, &'a str)>,
}

impl<'a> Element<'a> {
    /// Reads a line.
    fn read(line: &'a str) -> Self {
        let [before, between, after] = TRACK;
        let tracked = line.split_once(before).and_then(|(head, rest)| {
            let (key, rest) = rest.split_once(between)?;
            let (place, tail) = rest.split_once(after)?;
            Some(Self { parts: (head, tail), tracked: Some((key, place)) })
        });
        tracked.unwrap_or(Self { parts: (line, ""), tracked: None })
    }

    fn is(&self, other: &Merged<'_>) -> bool {
        self.parts == other.parts && self.tracked.map(|(key, _)| key) == other.key
    }

    /// How many bytes it saves to store it once.
    fn weight(&self) -> usize {
        self.parts.0.len() + self.parts.1.len()
    }
}

/// The SVG with neighbouring paths that look alike joined into one; what is translucent stays apart, as it may overlap.
pub(super) fn joined(svg: &str) -> String {
    let mut out = String::with_capacity(svg.len());
    let mut before = "";
    for line in svg.lines() {
        let path = line.strip_suffix("\"/>").and_then(|line| line.split_once(" d=\""));
        let path = path.filter(|(head, _)| head.starts_with("<path") && !head.contains("opacity"));
        match path {
            Some((head, data)) if head == before => {
                out.truncate(out.len() - "\"/>\n".len());
                out.push_str(data);
                out.push_str("\"/>\n");
            }
            _ => {
                out.push_str(line);
                out.push('\n');
            }
        }
        before = path.map_or("", |(head, _)| head);
    }
    out
}

/// The frames as one SVG. All begin with the same lines, and end with `</svg>`.
pub(super) fn merged(frames: &[&str]) -> String {
    let mut merged: Vec<Merged<'_>> = Vec::new();
    for (step, frame) in frames.iter().enumerate() {
        let elements: Vec<Element<'_>> = frame.lines().filter(|line| *line != "</svg>").map(Element::read).collect();
        merged = add(merged, &elements, step);
    }
    let mut out = String::new();
    for run in merged.chunk_by(|a, b| seen(a, frames.len()).eq(seen(b, frames.len()))) {
        let all = run.first().is_some_and(|element| seen(element, frames.len()).all(|seen| seen));
        if !all {
            group(run, frames.len(), &mut out);
        }
        for element in run {
            write(element, &mut out);
        }
        if !all {
            out.push_str("</g>\n");
        }
    }
    out.push_str("</svg>\n");
    out
}

/// Whether each of `count` steps shows the element.
fn seen<'m>(element: &'m Merged<'_>, count: usize) -> impl Iterator<Item = bool> + 'm {
    (0..count).map(|step| element.seen.get(step).copied().unwrap_or(false))
}

/// Adds the frame `step`: what it has in common with the frames before, by the heaviest common subsequence, is marked as seen;
/// the rest is put in its place between.
fn add<'a>(merged: Vec<Merged<'a>>, elements: &[Element<'a>], step: usize) -> Vec<Merged<'a>> {
    let width = elements.len() + 1;
    // `best[i * width + j]`: the most bytes that the merged from i on and the elements from j on have in common.
    let mut best = vec![0_usize; (merged.len() + 1) * width];
    for (i, known) in merged.iter().enumerate().rev() {
        for (j, element) in elements.iter().enumerate().rev() {
            let apart = best[(i + 1) * width + j].max(best[i * width + j + 1]);
            let joint = if element.is(known) { best[(i + 1) * width + j + 1] + element.weight() } else { 0 };
            best[i * width + j] = apart.max(joint);
        }
    }
    let joint = |i: usize, j: usize, known: &Merged<'_>| {
        elements.get(j).is_some_and(|element| {
            element.is(known) && best[i * width + j] == best[(i + 1) * width + j + 1] + element.weight()
        })
    };
    let mut out = Vec::with_capacity(merged.len() + elements.len());
    let mut j = 0;
    for (i, mut known) in merged.into_iter().enumerate() {
        // Elements of this frame alone stand before what it has in common with others only where that saves more.
        while j < elements.len() && !joint(i, j, &known) && best[i * width + j + 1] > best[(i + 1) * width + j] {
            out.push(fresh(&elements[j], step));
            j += 1;
        }
        if let Some(element) = elements.get(j).filter(|_| joint(i, j, &known)) {
            show(&mut known, element, step);
            j += 1;
        }
        out.push(known);
    }
    out.extend(elements[j..].iter().map(|element| fresh(element, step)));
    out
}

fn fresh<'a>(element: &Element<'a>, step: usize) -> Merged<'a> {
    let key = element.tracked.map(|(key, _)| key);
    let mut merged = Merged { parts: element.parts, key, seen: Vec::new(), places: Vec::new() };
    show(&mut merged, element, step);
    merged
}

/// Marks an element as seen at `step`.
fn show<'a>(merged: &mut Merged<'a>, element: &Element<'a>, step: usize) {
    merged.seen.resize(step, false);
    merged.seen.push(true);
    if let Some((_, place)) = element.tracked
        && merged.places.last().is_none_or(|last| last.1 != place)
    {
        merged.places.push((step, place));
    }
}

/// Opens the group of elements that the same steps show.
fn group(run: &[Merged<'_>], count: usize, out: &mut String) {
    let Some(first) = run.first() else { return };
    let steps: Vec<usize> =
        seen(first, count).enumerate().filter(|(_, seen)| *seen).map(|(step, _)| step + 1).collect();
    out.push_str("<g data-steps=\"");
    for (index, range) in steps.chunk_by(|a, b| a + 1 == *b).enumerate() {
        let comma = if index > 0 { "," } else { "" };
        // Writing to a string cannot fail.
        let _ = match range {
            [from, .., to] => write!(out, "{comma}{from}-{to}"),
            [one] => write!(out, "{comma}{one}"),
            [] => Ok(()),
        };
    }
    out.push_str(if steps.last() == Some(&count) { "\">\n" } else { "\" display=\"none\">\n" });
}

/// Writes an element at its last place.
fn write(element: &Merged<'_>, out: &mut String) {
    out.push_str(element.parts.0);
    if let Some((_, last)) = element.places.last() {
        if element.places.len() > 1 {
            let places: Vec<String> = element.places.iter().map(|(step, at)| format!("{} {at}", step + 1)).collect();
            // Writing to a string cannot fail.
            let _ = write!(out, " data-at=\"{}\"", places.join(","));
        }
        let _ = write!(out, " transform=\"translate({last})\"");
    }
    out.push_str(element.parts.1);
    out.push('\n');
}
