//! XOR scrambling, bit by bit: each set bit of the mask exchanges the two halves of every interval of its level.
//!
//! The mask is that of the scramble `xor` for the same stream: the image of the point 0. `agrees` compares the points after the
//! last bit with those of the scrambled sampler.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::seed::Seed;

/// The kind `xor-steps`.
pub static XOR_STEPS: XorStepsKind = XorStepsKind;

/// The kind of experiment `xor-steps`.
pub struct XorStepsKind;

static ABOUT: About = About {
    key: "xor-steps",
    title: "XOR scrambling, bit by bit",
    summary: "The bits of a random mask applied one by one to the first points of the van der Corput sequence: halves, quarters, eighths change places.",
    file: "kinds/xor_steps.rs",
    source: include_str!("xor_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through the bits of a mask can choose.
    pub struct XorSteps {
        /// How many bits: there are 2^bits points.
        bits: usize [in 1..=5] = 3,
    }
}

/// The bits and the points.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// The mask's bits, the most significant first.
    mask: Vec<bool>,
    /// Of each step the whole number whose bits place each point.
    steps: Vec<Vec<u32>>,
    agrees: bool,
}

impl Kind for XorStepsKind {
    type Parameters = XorSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &XorSteps, _: &mut Problems<'_, '_>) {}

    fn uses(&self, _: &XorSteps) -> Vec<&'static About> {
        Method::parse(METHOD).map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, p: &XorSteps) -> u64 {
        1 << p.bits
    }

    fn run(&self, p: &XorSteps, seed: Seed) -> Result<Data, Failure> {
        let count = 1_u32 << p.bits;
        let method = Method::parse(METHOD).map_err(|error| Failure::of("bits", error.to_string()))?;
        let drawn = method.points(count as usize, 1, seed.named(ABOUT.key));
        let drawn = drawn.map_err(|refused| Failure::of("bits", refused.to_string()))?;
        let scrambled: Vec<u32> = drawn.axis(0).map(|x| (x * f64::from(count)) as u32).collect();
        // Point 0 has no bit of its own.
        let whole = scrambled.first().copied().unwrap_or(0);
        let reversed = |index: u32| index.reverse_bits() >> (32 - p.bits);
        let mut steps: Vec<Vec<u32>> = vec![(0..count).map(reversed).collect()];
        let mask: Vec<bool> = (0..p.bits).rev().map(|bit| whole >> bit & 1 == 1).collect();
        let mut done = 0;
        for (bit, &set) in (0..p.bits).rev().zip(&mask) {
            done |= u32::from(set) << bit;
            steps.push((0..count).map(|index| reversed(index) ^ done).collect());
        }
        let agrees = steps.last() == Some(&scrambled);
        Ok(Data { mask, steps, agrees })
    }

    fn values(&self, _: &XorSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("steps", data.steps.len() as i64);
        values.text("mask", bits(&data.mask));
        let even = |step: &Vec<u32>| {
            let mut sorted = step.clone();
            sorted.sort_unstable();
            sorted.iter().enumerate().all(|(index, &place)| index as u32 == place)
        };
        values.boolean("one-per-slab.every-step", data.steps.iter().all(even));
        values.boolean("agrees", data.agrees);
        values
    }

    fn tables(&self, _: &XorSteps, data: &Data) -> Vec<Frame> {
        let rows = || data.steps.iter().enumerate().flat_map(|(step, places)| places.iter().map(move |at| (step, *at)));
        let count = data.steps.first().map_or(1, Vec::len);
        let frame = Frame::new("points")
            .counts("step", rows().map(|(step, _)| step + 1))
            .counts("index", rows().enumerate().map(|(row, _)| row % count))
            .numbers("x", rows().map(|(_, at)| f64::from(at) / count as f64));
        vec![frame]
    }

    fn draw(&self, p: &XorSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &XorSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

/// The scrambled sampler that is taken apart.
const METHOD: &str = "van-der-corput+xor";

/// Bits as they are written.
fn bits(bits: &[bool]) -> String {
    bits.iter().map(|&bit| if bit { '1' } else { '0' }).collect()
}

mod drawing {
    //! The bits over the points, and their words.

    use super::{Data, METHOD, XorSteps, bits};
    use crate::chart::{
        Axis, Boxes, Chart, ChartError, Corner, Drawing, Key, Marker, Marks, Note, Panel, Role, Segments, Sheet, Steps,
        Style,
    };

    pub(super) fn draw(p: &XorSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new().small(290.0).key_steps([1]);
        for step in 0..data.steps.len() {
            let panels = vec![table(p, data, step), line(p, data, step)];
            steps.push(Chart::grid(panels).columns(1).key(Key::Hidden), caption(data, step));
        }
        Ok(steps.draw(sheet)?.into())
    }

    /// The bits of every point over the mask and over what the two make.
    fn table(p: &XorSteps, data: &Data, step: usize) -> Panel {
        let (first, now) = (data.steps.first(), data.steps.get(step));
        let count = 1_usize << p.bits;
        let y = Axis::linear("").range(-0.6, 3.5).hidden();
        let mut panel = Panel::new(Axis::linear("").range(-0.14, 1.0).hidden(), y).ratio(0.2);
        let mid = |index: usize| (index as f64 + 0.5) / count as f64;
        // The mask as far as it is applied.
        let mask: Vec<bool> = data.mask.iter().enumerate().map(|(bit, &set)| set && bit < step).collect();
        let words = [(3.0, "*i*"), (2.0, "Φ(*i*)"), (1.0, "mask"), (0.0, "XOR")];
        let word = |(y, word): (f64, &str)| Note::new((-0.07, y), word).corner(Corner::Centre).role(Role::Axis);
        panel = panel.with_all(words.map(word));
        panel = panel.with(Segments::new(vec![[(-0.13, 0.5), (1.0, 0.5)]]).style(Style::MUTED).width(0.8));
        let note = |index: usize, y: f64, text: String| Note::new((mid(index), y), text).corner(Corner::Centre);
        let written = |index: usize, places: Option<&Vec<u32>>| {
            let place = places.and_then(|places| places.get(index)).copied().unwrap_or(0);
            format!("{place:0width$b}", width = p.bits)
        };
        panel = panel.with_all((0..count).map(|index| note(index, 3.0, index.to_string()).role(Role::Axis)));
        panel = panel.with_all((0..count).map(|index| note(index, 2.0, written(index, first))));
        panel = panel.with(
            Note::new((0.5, 1.0), format!("{} for every point", bits(&mask))).corner(Corner::Centre).role(Role::Violet),
        );
        panel.with_all((0..count).map(|index| note(index, 0.0, written(index, now)).bold()))
    }

    /// The points on the unit interval, with the halves that the last bit exchanged.
    fn line(p: &XorSteps, data: &Data, step: usize) -> Panel {
        let count = f64::from(1_u32 << p.bits);
        let ticks = [(0.0, "0"), (0.25, "1/4"), (0.5, "1/2"), (0.75, "3/4"), (1.0, "1")];
        let ticks = ticks.into_iter().map(|(at, label)| (at, label.into())).collect();
        let y = Axis::linear("").range(0.0, 1.0).hidden();
        // As wide as the table above it, whose rows have names; the axis is that of the interval alone.
        let x = Axis::linear("").range(-0.14, 1.0).ticks_at(ticks).from(0.0);
        let mut panel = Panel::new(x, y).ratio(0.13);
        panel = panel.with(Segments::new(vec![[(0.0, 0.3), (1.0, 0.3)]]).style(Style::new(Role::Axis)));
        if let Some(level) = step.checked_sub(1).filter(|&bit| data.mask.get(bit) == Some(&true)) {
            let parts = 1_u32 << (level + 1);
            let part = |k: u32| [(f64::from(k) / f64::from(parts), 0.08), (f64::from(k + 1) / f64::from(parts), 0.95)];
            let parts = |odd: u32| (0..parts).filter(|k| k % 2 == odd).map(part).collect();
            panel = panel.with(Boxes::new(parts(0)).style(Style::new(Role::Violet)).opacity(0.08));
            panel = panel.with(Boxes::new(parts(1)).style(Style::new(Role::Ochre)).opacity(0.08));
        }
        let places = data.steps.get(step).map(Vec::as_slice).unwrap_or_default();
        let at = |place: u32| (f64::from(place) + 0.5) / count;
        let marks = Marks::new(places.iter().map(|&place| (at(place), 0.3)).collect());
        panel = panel.with(marks.style(Style::of(METHOD).marker(Marker::Disc)).size(9.0).tracked("p"));
        panel.with_all(places.iter().enumerate().map(|(index, &place)| {
            Note::new((at(place), 0.42), index.to_string()).corner(Corner::Above).tracked(format!("n{index}"))
        }))
    }

    fn caption(data: &Data, step: usize) -> String {
        let Some(bit) = step.checked_sub(1) else {
            return "The points as they are: point $i$ at the reversed bits of $i$.".to_owned();
        };
        let what = match (bit, 1_u32 << bit) {
            (0, _) => "the two halves of the interval".to_owned(),
            (1, _) => "the two halves of each half".to_owned(),
            (_, parts) => format!("the two halves of each of the {parts} parts"),
        };
        if data.mask.get(bit) == Some(&true) {
            format!("Bit {} of the mask is 1: {what} change places.", bit + 1)
        } else {
            format!("Bit {} of the mask is 0: {what} stay where they are.", bit + 1)
        }
    }

    pub(super) fn alt(p: &XorSteps, data: &Data) -> String {
        format!(
            "{} steps: the first {} points of the van der Corput sequence on the unit interval, above them their bits, those of \
             the mask and their exclusive or. The mask is {}; each of its bits that is 1 exchanges the halves of all \
             intervals of its level, and in every step each of the {} slabs holds one point.",
            data.steps.len(),
            1 << p.bits,
            bits(&data.mask),
            1 << p.bits
        )
    }
}
