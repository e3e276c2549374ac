//! What the drawings of several mistakes share: the styles of the two programs, and panels of points.

use super::Side;
use crate::chart::number::integer;
use crate::chart::{Boxes, Chart, Key, Marker, Marks, Panel, Role, Strata, Style};

/// The program with the mistake.
pub const WRONG: Style = Style::new(Role::Accent).marker(Marker::Diamond);

/// The right program.
pub const RIGHT: Style = Style::new(Role::Blue);

/// The points of a side in the unit square, with its boxes shaded and these strata drawn.
pub fn square(side: &Side, style: Style, title: &str, strata: &[Strata]) -> Panel {
    let corners: Vec<_> = side.boxes.iter().map(|&[left, bottom, right, top]| [(left, bottom), (right, top)]).collect();
    let panel = Panel::unit_square().title(title);
    let panel = if corners.is_empty() { panel } else { panel.with(Boxes::new(corners).plain().opacity(0.14)) };
    let panel = strata.iter().fold(panel, |panel, strata| panel.strata(*strata));
    panel.with(Marks::new(side.pairs("x", "y")).style(style))
}

/// Two panels beside each other, whose titles say which is which.
pub fn pair(wrong: Panel, right: Panel) -> Chart {
    Chart::grid(vec![wrong, right]).columns(2).key(Key::Hidden)
}

/// A count with its noun: `1 cell`, `12 cells`, `no cell`.
pub fn counted(count: i64, noun: &str) -> String {
    match count {
        0 => format!("no {noun}"),
        1 => format!("1 {noun}"),
        _ => format!("{} {noun}s", integer(count)),
    }
}
