//! Owen scrambling as a tree of swaps: every node of the binary tree exchanges its two branches or not, by a coin of its own.
//!
//! The coins are those of the scramble `owen` for the same stream: where the sampler puts its points tells which nodes swapped.
//! `agrees` tells that one tree of swaps explains the places of all points.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `owen-steps`.
pub static OWEN_STEPS: OwenStepsKind = OwenStepsKind;

/// The kind of experiment `owen-steps`.
pub struct OwenStepsKind;

static ABOUT: About = About {
    key: "owen-steps",
    title: "Owen scrambling as a tree of swaps",
    summary: "The binary tree over the first points of the van der Corput sequence: node by node its two branches are exchanged, or stay.",
    file: "kinds/owen_steps.rs",
    source: include_str!("owen_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through the tree can choose.
    pub struct OwenSteps {
        /// How many levels of nodes: there are 2^levels points.
        levels: usize [in 1..=5] = 3,
    }
}

/// The tree.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// Level by level, whether each node swaps, by its path from the root.
    swaps: Vec<Vec<bool>>,
    /// Of each step, the slab in which each leaf lies, by its path.
    steps: Vec<Vec<u32>>,
    agrees: bool,
}

impl Kind for OwenStepsKind {
    type Parameters = OwenSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &OwenSteps, _: &mut Problems<'_, '_>) {}

    fn uses(&self, _: &OwenSteps) -> Vec<&'static About> {
        Method::parse(METHOD).map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, p: &OwenSteps) -> u64 {
        1 << (2 * p.levels)
    }

    fn run(&self, p: &OwenSteps, seed: Seed) -> Result<Data, Failure> {
        let (levels, count) = (p.levels, 1_u32 << p.levels);
        let method = Method::parse(METHOD).map_err(|error| Failure::of("levels", error.to_string()))?;
        let drawn = method.points(count as usize, 1, seed.named(ABOUT.key));
        let drawn = drawn.map_err(|refused| Failure::of("levels", refused.to_string()))?;
        // The slab of each leaf: leaf k is the point whose index has the bits of k reversed.
        let reversed = |leaf: u32| leaf.reverse_bits() >> (32 - levels);
        let places: Vec<u32> = drawn.axis(0).map(|x| (x * f64::from(count)) as u32).collect();
        let slab = |leaf: u32| places.get(reversed(leaf) as usize).copied().unwrap_or(0);
        let swapped = |level: usize, node: u32| {
            let leaf = node << (levels - level);
            let bit = levels - level - 1;
            (slab(leaf) ^ leaf) >> bit & 1 == 1
        };
        let swaps: Vec<Vec<bool>> =
            (0..levels).map(|level| (0..1_u32 << level).map(|node| swapped(level, node)).collect()).collect();
        let mut now: Vec<u32> = (0..count).collect();
        let mut steps = vec![now.clone()];
        for (level, nodes) in swaps.iter().enumerate() {
            let below = levels - level;
            for (node, &swap) in nodes.iter().enumerate() {
                let leaves = now.iter_mut().enumerate().filter(|(leaf, _)| swap && leaf >> below == node);
                leaves.for_each(|(_, slab)| *slab ^= 1 << (below - 1));
                steps.push(now.clone());
            }
        }
        let agrees = now.iter().enumerate().all(|(leaf, &own)| own == slab(leaf as u32));
        Ok(Data { swaps, steps, agrees })
    }

    fn values(&self, _: &OwenSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("steps", data.steps.len() as i64);
        values.integer("nodes", data.swaps.iter().map(|level| level.len() as i64).sum());
        values.integer("swaps", data.swaps.iter().flatten().filter(|&&swap| swap).count() as i64);
        let even = |step: &Vec<u32>| {
            let mut sorted = step.clone();
            sorted.sort_unstable();
            sorted.iter().enumerate().all(|(index, &slab)| index as u32 == slab)
        };
        values.boolean("one-per-slab.every-step", data.steps.iter().all(even));
        values.boolean("agrees", data.agrees);
        values
    }

    fn tables(&self, _: &OwenSteps, data: &Data) -> Vec<Frame> {
        let nodes =
            || data.swaps.iter().enumerate().flat_map(|(level, nodes)| nodes.iter().map(move |swap| (level, *swap)));
        let frame = Frame::new("nodes")
            .counts("level", nodes().map(|(level, _)| level))
            .text("verdict", nodes().map(|(_, swap)| if swap { "swaps" } else { "stays" }.to_owned()));
        vec![frame]
    }

    fn draw(&self, p: &OwenSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &OwenSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The scrambled sampler whose coins are shown.
const METHOD: &str = "van-der-corput+owen";

mod drawing {
    //! The tree over the points, and its words.

    use super::{Data, METHOD, OwenSteps};
    use crate::chart::{
        Axis, Boxes, Chart, ChartError, Corner, Drawing, Key, Layer, Marker, Marks, Note, Panel, Role, Segments, Sheet,
        Steps, Style,
    };

    /// The node of a step, by its level and its path; none for the first.
    fn node(data: &Data, step: usize) -> Option<(usize, usize, bool)> {
        let nodes = data.swaps.iter().enumerate();
        let nodes =
            nodes.flat_map(|(level, nodes)| nodes.iter().enumerate().map(move |(node, swap)| (level, node, *swap)));
        nodes.collect::<Vec<_>>().get(step.checked_sub(1)?).copied()
    }

    pub(super) fn draw(p: &OwenSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new().small(290.0);
        for step in 0..data.steps.len() {
            steps.push(Chart::new(panel(p, data, step)).key(Key::Hidden), caption(p, data, step));
        }
        Ok(steps.draw(sheet)?.into())
    }

    /// Where a node stands, by its level and its slab there.
    fn place(p: &OwenSteps, level: usize, slab: usize) -> (f64, f64) {
        ((slab as f64 + 0.5) / f64::from(1_u32 << level), p.levels as f64 - level as f64)
    }

    /// The slab of a node: where the swaps above have put it.
    fn slab(p: &OwenSteps, slabs: &[u32], level: usize, node: usize) -> usize {
        let below = p.levels - level;
        slabs.get(node << below).map_or(0, |&slab| (slab >> below) as usize)
    }

    /// The node of a step with its two branches, in the colour of what was decided; lines and mark of these sizes.
    fn verdict(p: &OwenSteps, data: &Data, slabs: &[u32], step: usize, (width, size): (f64, f64)) -> Vec<Layer> {
        let Some((level, node, swap)) = node(data, step) else { return Vec::new() };
        let slab = slab(p, slabs, level, node);
        let own = place(p, level, slab);
        let branches = [0, 1].map(|right| [own, place(p, level + 1, 2 * slab + right)]).to_vec();
        let style = if swap { Style::ACCENT } else { Style::INK };
        let branches = Segments::new(branches).style(style).width(width);
        vec![branches.into(), Marks::new(vec![own]).style(style).size(size).into()]
    }

    /// The tree from its root at the top to the line with the points, a level one high.
    fn panel(p: &OwenSteps, data: &Data, step: usize) -> Panel {
        let (levels, count) = (p.levels, f64::from(1_u32 << p.levels));
        let ticks = [(0.0, "0"), (0.25, "1/4"), (0.5, "1/2"), (0.75, "3/4"), (1.0, "1")];
        let ticks = ticks.into_iter().map(|(at, label)| (at, label.into())).collect();
        let top = levels as f64;
        let y = Axis::linear("").range(-1.3, top + 0.25).hidden();
        let x = Axis::linear("").range(-0.02, 1.02).ticks_at(ticks);
        let mut panel = Panel::new(x, y).ratio(0.11 * (top + 1.8));
        let place = |level: usize, slab: usize| place(p, level, slab);
        let edges = (1..=levels).flat_map(|level| (0..1 << level).map(move |slab| (level, slab)));
        let edges = edges.map(|(level, slab)| [place(level, slab), place(level - 1, slab / 2)]).collect();
        panel = panel.with(Segments::new(edges).style(Style::new(Role::Strata)).width(1.5));
        let slabs = data.steps.get(step).map(Vec::as_slice).unwrap_or_default();
        // What was decided before stays to be seen, thinner.
        for earlier in 1..step {
            panel = panel.with_all(verdict(p, data, slabs, earlier, (1.5, 6.0)));
        }
        if let Some((level, node, swap)) = node(data, step) {
            let slab = slab(p, slabs, level, node);
            let width = 1.0 / f64::from(1_u32 << level);
            let half = |right: f64| {
                let from = (slab as f64 + 0.5 * right) * width;
                [(from, -1.12), (from + 0.5 * width, -0.05)]
            };
            let styles = [Style::new(Role::Violet), Style::new(Role::Ochre)];
            if swap {
                panel = panel.with_all(
                    [0.0, 1.0]
                        .iter()
                        .zip(styles)
                        .map(|(&right, style)| Boxes::new(vec![half(right)]).style(style).opacity(0.1)),
                );
            }
        }
        panel = panel.with_all(verdict(p, data, slabs, step, (2.4, 9.0)));
        let line = Segments::new(vec![[(0.0, -0.95), (1.0, -0.95)]]).style(Style::new(Role::Axis));
        let at = |slab: u32| (f64::from(slab) + 0.5) / count;
        let marks = Marks::new(slabs.iter().map(|&slab| (at(slab), -0.95)).collect());
        panel = panel.with(line).with(marks.style(Style::of(METHOD).marker(Marker::Disc)).size(9.0).tracked("p"));
        panel.with_all(slabs.iter().enumerate().map(|(leaf, &slab)| {
            let text = format!("{leaf:0levels$b}");
            let text = if levels > 4 { leaf.to_string() } else { text };
            Note::new((at(slab), -0.14), text).corner(Corner::Below).tracked(format!("n{leaf}"))
        }))
    }

    fn caption(p: &OwenSteps, data: &Data, step: usize) -> String {
        let Some((level, node, swap)) = node(data, step) else {
            return format!("The tree of {} levels over the points, each named by its bits.", p.levels);
        };
        let name = match level {
            0 => "The root".to_owned(),
            _ => format!("Node {node:0level$b}"),
        };
        if swap { format!("{name} swaps its two branches.") } else { format!("{name} stays as it is.") }
    }

    pub(super) fn alt(p: &OwenSteps, data: &Data) -> String {
        let nodes = data.swaps.iter().map(Vec::len).sum::<usize>();
        let swaps = data.swaps.iter().flatten().filter(|&&swap| swap).count();
        format!(
            "{} steps: a binary tree of {} levels over {} points on the unit interval. From the root down each of the {nodes} \
             nodes swaps its two branches or not; {swaps} do. In every step each of the {} slabs holds one point.",
            data.steps.len(),
            p.levels,
            1 << p.levels,
            1 << p.levels
        )
    }
}
