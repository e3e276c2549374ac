//! Guarantees: which sampler keeps which stratum, counted over many seeds beside what it declares.
//!
//! Every property is looked at for every seed. A method that no seed changes is looked at once.

use serde::{Deserialize, Serialize};

use super::placing::Placing;
use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::metrics::{dispersion, nets, occupancy};
use crate::parameters::{choices, parameters};
use crate::points::{Points, slab};
use crate::samplers::digits::root;
use crate::samplers::{Guarantee, Method, poisson};
use crate::seed::Seed;

/// The kind `guarantees`.
pub static GUARANTEES: GuaranteesKind = GuaranteesKind;

/// The kind of experiment that holds samplers to their guarantees.
pub struct GuaranteesKind;

static ABOUT: About = About {
    key: "guarantees",
    title: "Guarantees of samplers",
    summary: "Which sampler keeps which stratum, counted over many seeds beside what it declares.",
    file: "kinds/guarantees.rs",
    source: include_str!("guarantees.rs"),
    papers: &[],
};

choices! {
    /// What can be looked at.
    pub enum Property {
        /// One point in each of the n slabs of every axis.
        Latin = "latin",
        /// One point in each cell of the grid of n equal cells.
        Cells = "cells",
        /// Both: Latin and one point per cell.
        Both = "both",
        /// One point in each cell of the square grid of the axes 2p and 2p + 1.
        Pairs = "pairs",
        /// One point in every elementary interval of volume 1/n.
        Net = "net",
        /// The first half of the points are the points of half the count.
        Prefix = "prefix",
        /// No two points nearer than the asked share of the largest possible distance.
        Separated = "separated",
        /// The same points for every seed.
        Fixed = "fixed",
    }
}

parameters! {
    /// What a matrix of guarantees can choose.
    pub struct Guarantees {
        /// The samplers, each with an optional scramble: one row each.
        samplers: Vec<Method> [or sampler],
        /// What is looked at: one column each.
        properties: Vec<Property> = ["latin", "cells", "both", "net", "prefix", "separated"],
        /// How many points each set has.
        n: usize [in 2..=16_384] = 16,
        /// The dimensions of the unit cube.
        dimensions: usize [in 1..=16] = 2,
        /// The base of the elementary intervals.
        base: usize [in 2..=64] = 2,
        /// The share of the largest possible distance, in the plane.
        radius: f64 [in 0.0..=1.0] = 0.6,
        /// Over how many seeds.
        seeds: usize [in 1..=100_000] = 100,
    }
}

/// The rows of the matrix.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    rows: Vec<Row>,
}

/// One method.
#[derive(Debug, Serialize, Deserialize)]
struct Row {
    method: String,
    title: String,
    seeds: u32,
    cells: Vec<Held>,
}

/// One property of one method.
#[derive(Debug, Serialize, Deserialize)]
struct Held {
    /// For how many seeds it held; `None` where it is not defined for these n and d.
    count: Option<u32>,
    declared: bool,
}

impl Kind for GuaranteesKind {
    type Parameters = Guarantees;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, p: &Guarantees, problems: &mut Problems<'_, '_>) {
        problems.admit("samplers", &p.samplers, &[p.n], p.dimensions);
    }

    fn weight(&self, p: &Guarantees) -> u64 {
        (p.n as u64 * p.seeds as u64).saturating_mul(8 * p.samplers.len() as u64)
    }

    fn run(&self, p: &Guarantees, seed: Seed) -> Result<Data, Failure> {
        let placing = Placing { kind: ABOUT.key, d: p.dimensions, seed };
        let firsts = p.samplers.iter().map(|method| placing.points(method, p.n, 0));
        let firsts: Vec<Points> = firsts.collect::<Result<_, _>>()?;
        let row = |(method, first): (&Method, &Points)| -> Result<Row, Failure> {
            let sets = placing.measured(std::slice::from_ref(method), &[p.n], p.seeds, |method, points| {
                let held = |&property: &Property| holds(p, property, method, points, first, seed);
                Ok(p.properties.iter().map(held).collect::<Vec<Option<bool>>>())
            })?;
            let sets = sets.into_iter().flatten().next().unwrap_or_default();
            let count = |index: usize| {
                let held: Option<Vec<bool>> = sets.iter().map(|set| set.get(index).copied().flatten()).collect();
                held.map(|held| held.iter().filter(|&&held| held).count() as u32)
            };
            let cells = p.properties.iter().enumerate();
            let cells = cells.map(|(i, &what)| Held { count: count(i), declared: declares(p, what, method) }).collect();
            Ok(Row { method: method.name(), title: method.title(), seeds: sets.len() as u32, cells })
        };
        Ok(Data { rows: p.samplers.iter().zip(&firsts).map(row).collect::<Result<_, _>>()? })
    }

    fn values(&self, p: &Guarantees, data: &Data) -> Values {
        let mut values = Values::new();
        for row in &data.rows {
            let name = &row.method;
            for (property, held) in p.properties.iter().zip(&row.cells) {
                let word = property.word();
                if let Some(count) = held.count {
                    values.boolean(format!("{word}.{name}"), count == row.seeds);
                    values.integer(format!("count.{word}.{name}"), i64::from(count));
                }
                values.boolean(format!("declared.{word}.{name}"), held.declared);
            }
            values.integer(format!("seeds.{name}"), i64::from(row.seeds));
            values.boolean(format!("consistent.{name}"), row.cells.iter().all(|held| held.is_consistent(row.seeds)));
        }
        let all = data.rows.iter().all(|row| row.cells.iter().all(|held| held.is_consistent(row.seeds)));
        values.boolean("consistent", all);
        values
    }

    fn tables(&self, p: &Guarantees, data: &Data) -> Vec<Frame> {
        let cells = || data.rows.iter().flat_map(|row| p.properties.iter().zip(&row.cells).map(move |one| (row, one)));
        let frame = Frame::new("guarantees")
            .text("sampler", cells().map(|(row, _)| row.method.clone()))
            .text("property", cells().map(|(_, (property, _))| property.word().to_owned()))
            .numbers("held", cells().map(|(_, (_, held))| held.count.map_or(f64::NAN, f64::from)))
            .counts("seeds", cells().map(|(row, _)| row.seeds as usize))
            .text("declared", cells().map(|(_, (_, held))| if held.declared { "yes" } else { "no" }.to_owned()));
        vec![frame]
    }

    fn draw(&self, p: &Guarantees, data: &Data, _: &Sheet) -> Result<Drawing, ChartError> {
        Ok(drawing::draw(p, data))
    }

    fn alt(&self, p: &Guarantees, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

impl Held {
    /// Whether what is declared was never seen to fail.
    fn is_consistent(&self, seeds: u32) -> bool {
        !self.declared || self.count.is_none_or(|count| count == seeds)
    }
}

/// Whether a property holds of one set; `None` where it is not defined. `first` is the set of the first seed.
fn holds(
    p: &Guarantees,
    property: Property,
    method: &Method,
    points: &Points,
    first: &Points,
    seed: Seed,
) -> Option<bool> {
    let (n, d) = (points.len(), points.dimensions());
    match property {
        Property::Latin => Some(occupancy::is_latin(points)),
        Property::Cells => {
            let side = root(n as u64, d as u32) as usize;
            let cells = (side.checked_pow(d as u32) == Some(n)).then(|| occupancy::cells(points, &vec![side; d]))??;
            Some(cells.iter().all(|&count| count == 1))
        }
        Property::Both => Some(holds(p, Property::Cells, method, points, first, seed)? && occupancy::is_latin(points)),
        Property::Pairs => pairs(points),
        Property::Net => nets::violations(points, p.base as u32, 0).map(|violations| violations == 0),
        Property::Prefix => {
            // Both from one stream: what counts is the count alone.
            let stream = seed.named(ABOUT.key).named(&method.name()).named("prefix");
            let half = (1..n).rev().find(|&m| m <= n.div_ceil(2) && method.admits(m, d).is_ok())?;
            let (all, part) = (method.points(n, d, stream).ok()?, method.points(half, d, stream).ok()?);
            Some(all.coordinates()[..half * d] == *part.coordinates())
        }
        Property::Separated => {
            let distance = dispersion::minimum_distance(points).filter(|_| d == 2)?;
            Some(distance >= p.radius * poisson::hexagonal(n))
        }
        Property::Fixed => Some(points == first),
    }
}

/// Whether each square grid of the axes 2p and 2p + 1 has one point per cell.
fn pairs(points: &Points) -> Option<bool> {
    let (n, d) = (points.len(), points.dimensions());
    let side = n.isqrt();
    if side * side != n || d < 2 {
        return None;
    }
    let kept = |axis: usize| {
        let mut seen = vec![0_u32; n];
        points.axis(axis).zip(points.axis(axis + 1)).for_each(|(x, y)| seen[slab(x, side) * side + slab(y, side)] += 1);
        seen.iter().all(|&count| count == 1)
    };
    Some((0..d - 1).step_by(2).all(kept))
}

/// Whether a method declares a property for these n and d.
fn declares(p: &Guarantees, property: Property, method: &Method) -> bool {
    let guarantees = method.guarantees();
    let has = |guarantee: Guarantee| guarantees.contains(&guarantee);
    let perfect = |net: Option<crate::samplers::Net>| net.is_some_and(|net| net.t == 0 && net.base as usize == p.base);
    match property {
        Property::Latin => has(Guarantee::Latin),
        Property::Cells => has(Guarantee::Strata),
        Property::Both => has(Guarantee::Latin) && has(Guarantee::Strata),
        Property::Pairs => has(Guarantee::Pairs),
        Property::Net => perfect(method.net(p.dimensions)) || perfect(method.whole_net(p.n, p.dimensions)),
        Property::Prefix => has(Guarantee::Prefix),
        Property::Separated => guarantees.iter().any(|guarantee| match guarantee {
            Guarantee::Separated { percent } => f64::from(*percent) / 100.0 >= p.radius,
            _ => false,
        }),
        Property::Fixed => has(Guarantee::Deterministic),
    }
}

mod drawing {
    //! The matrix, and its words.

    use std::fmt::Write as _;

    use super::{Data, Guarantees, Held, Property};
    use crate::chart::{Cell, Column, Drawing, Table};

    fn head(p: &Guarantees, property: Property) -> String {
        match property {
            Property::Latin => "Latin".to_owned(),
            Property::Cells => "One per cell".to_owned(),
            Property::Both => "Latin and cells".to_owned(),
            Property::Pairs => "Pairs of axes".to_owned(),
            Property::Net => format!("$(0, m, {})$-net", p.dimensions),
            Property::Prefix => "Prefix".to_owned(),
            Property::Separated => format!("$\\rho \\ge {}$", p.radius),
            Property::Fixed => "Same for every seed".to_owned(),
        }
    }

    pub(super) fn draw(p: &Guarantees, data: &Data) -> Drawing {
        let mut columns = vec![Column::left("Sampler")];
        columns.extend(p.properties.iter().map(|&property| Column::left(head(p, property))));
        let mut table = Table::new(columns);
        for row in &data.rows {
            let cells = row.cells.iter().map(|held| cell(held, row.seeds));
            table.push(std::iter::once(Cell::text(row.title.as_str())).chain(cells));
        }
        Drawing::Table(table)
    }

    /// What was counted, and whether it was to be expected.
    fn cell(held: &Held, seeds: u32) -> Cell {
        let Some(count) = held.count else { return Cell::Empty };
        let text = match (held.declared, count) {
            (true, count) if count == seeds => "as declared".to_owned(),
            (false, count) if count == seeds => "yes".to_owned(),
            (false, 0) => "no".to_owned(),
            (false, count) => format!("{count} of {seeds}"),
            (true, count) => format!("declared, but {count} of {seeds}"),
        };
        Cell::Holds { holds: count == seeds, text }
    }

    pub(super) fn alt(p: &Guarantees, data: &Data) -> String {
        let mut text = format!(
            "What {} samplers keep with {} points in {} dimensions, over {} seeds.",
            data.rows.len(),
            p.n,
            p.dimensions,
            p.seeds
        );
        for (index, property) in p.properties.iter().enumerate() {
            let keeps =
                data.rows.iter().filter(|row| row.cells.get(index).is_some_and(|held| held.count == Some(row.seeds)));
            let names: Vec<&str> = keeps.map(|row| row.title.as_str()).collect();
            let names = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
            let _ = write!(text, " {}: {names}.", property.word());
        }
        text
    }
}
