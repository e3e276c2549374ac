//! The radical inverse, digit by digit: each digit of an index moves to its mirror place behind the point.
//!
//! The sums are exact fractions of whole numbers; `agrees` compares the last with what the samplers compute.

use serde::{Deserialize, Serialize};

use super::{Failure, Frame, Kind, Problems, Values};
use crate::catalogue::About;
use crate::chart::{ChartError, Drawing, Sheet};
use crate::parameters::parameters;
use crate::samplers::Method;
use crate::samplers::{halton, van_der_corput};
use crate::seed::Seed;

/// The kind `digit-steps`.
pub static DIGIT_STEPS: DigitStepsKind = DigitStepsKind;

/// The kind of experiment `digit-steps`.
pub struct DigitStepsKind;

static ABOUT: About = About {
    key: "digit-steps",
    title: "The radical inverse, digit by digit",
    summary: "The digits of an index in a base, reflected at the point one by one: the radical inverse by hand.",
    file: "kinds/digit_steps.rs",
    source: include_str!("digit_steps.rs"),
    papers: &[],
};

parameters! {
    /// What stepping through the digits of a radical inverse can choose.
    pub struct DigitSteps {
        /// The index whose radical inverse is taken.
        index: usize [in 1..=65_535] = 11,
        /// The base of the digits.
        base: usize [in 2..=16] = 2,
    }
}

/// The digits.
#[derive(Debug, Serialize, Deserialize)]
pub struct Data {
    /// The digits of the index, the least significant first.
    digits: Vec<u32>,
    /// The numerators over base^(number of digits) of the fraction after each digit.
    numerators: Vec<u64>,
    denominator: u64,
    agrees: bool,
}

impl Kind for DigitStepsKind {
    type Parameters = DigitSteps;
    type Data = Data;

    fn about(&self) -> &'static About {
        &ABOUT
    }

    fn check(&self, _: &DigitSteps, _: &mut Problems<'_, '_>) {}

    fn uses(&self, p: &DigitSteps) -> Vec<&'static About> {
        let sampler = if p.base == 2 { "van-der-corput" } else { "halton" };
        Method::parse(sampler).map(|method| method.abouts()).unwrap_or_default()
    }

    fn weight(&self, _: &DigitSteps) -> u64 {
        1
    }

    fn run(&self, p: &DigitSteps, _: Seed) -> Result<Data, Failure> {
        let (base, mut rest) = (p.base as u64, p.index as u64);
        let mut digits = Vec::new();
        while rest > 0 {
            digits.push((rest % base) as u32);
            rest /= base;
        }
        let denominator = base.pow(digits.len() as u32);
        let mut place = denominator;
        let mut numerator = 0;
        let add = |&digit: &u32| {
            place /= base;
            numerator += u64::from(digit) * place;
            numerator
        };
        let numerators: Vec<u64> = digits.iter().map(add).collect();
        let index = p.index as u64;
        let phi = match p.base {
            2 => van_der_corput::bit_reversal(index),
            _ => halton::radical_inverse(index, p.base as u32),
        };
        let agrees = numerators.last().is_some_and(|&last| last as f64 / denominator as f64 == phi);
        Ok(Data { digits, numerators, denominator, agrees })
    }

    fn values(&self, p: &DigitSteps, data: &Data) -> Values {
        let mut values = Values::new();
        values.integer("index", p.index as i64);
        values.integer("base", p.base as i64);
        values.integer("digits", data.digits.len() as i64);
        values.number("phi", data.numerators.last().map_or(0.0, |&last| last as f64 / data.denominator as f64));
        values.boolean("agrees", data.agrees);
        values
    }

    fn tables(&self, _: &DigitSteps, data: &Data) -> Vec<Frame> {
        let frame = Frame::new("digits")
            .counts("place", 0..data.digits.len())
            .counts("digit", data.digits.iter().map(|&digit| digit as usize))
            .counts("numerator so far", data.numerators.iter().map(|&numerator| numerator as usize));
        vec![frame]
    }

    fn draw(&self, p: &DigitSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        drawing::draw(p, data, sheet)
    }

    fn alt(&self, p: &DigitSteps, data: &Data) -> Option<String> {
        Some(drawing::alt(p, data))
    }
}

mod drawing {
    //! The digits, and their words.

    use super::{Data, DigitSteps};
    use crate::chart::{
        Axis, Boxes, Chart, ChartError, Corner, Drawing, Key, Marks, Note, Panel, Role, Sheet, Steps, Style,
    };

    pub(super) fn draw(p: &DigitSteps, data: &Data, sheet: &Sheet) -> Result<Drawing, ChartError> {
        let mut steps = Steps::new().small(290.0).key_steps([1, data.digits.len() / 2 + 1]);
        for moved in 0..=data.digits.len() {
            steps.push(Chart::new(panel(p, data, moved)).key(Key::Hidden), caption(p, data, moved));
        }
        Ok(steps.draw(sheet)?.into())
    }

    /// A digit as it is written.
    fn written(digit: u32) -> String {
        char::from_digit(digit, 36).map_or_else(String::new, |c| c.to_string())
    }

    /// The digits after `moved` of them were reflected: the point is at 0, a place is 1 wide.
    fn panel(p: &DigitSteps, data: &Data, moved: usize) -> Panel {
        let count = data.digits.len() as f64;
        let wide = (count + 0.5).max(4.0);
        let x = Axis::linear("").range(-wide, wide).hidden();
        let mut panel = Panel::new(x, Axis::linear("").range(-1.6, 1.5).hidden()).ratio(0.8 / wide.max(2.6));
        let at = |place: usize, right: bool| if right { place as f64 + 0.7 } else { -(place as f64) - 0.7 };
        let cell = |place: usize, right: bool| {
            let x = at(place, right);
            [(x - 0.44, -0.5), (x + 0.44, 0.5)]
        };
        let cells = |right: bool| (0..data.digits.len()).map(|place| cell(place, right)).collect();
        panel = panel.with(Boxes::new(cells(false)).style(Style::new(Role::Strata)).opacity(0.06));
        panel = panel.with(Boxes::new(cells(true)).style(Style::new(Role::Blue)).opacity(0.1));
        panel = panel.with(Marks::new(vec![(0.0, -0.42)]).size(6.0));
        for (place, &digit) in data.digits.iter().enumerate() {
            let base = p.base;
            let weight = |text: String, right: bool| {
                Note::new((at(place, right), -0.95), text).corner(Corner::Centre).role(Role::Axis)
            };
            panel = panel
                .with(weight(power(base, place as i32), false))
                .with(weight(power(base, -(place as i32) - 1), true));
            let note = Note::new((at(place, place < moved), 0.0), written(digit)).corner(Corner::Centre).bold();
            panel = panel.with(note.tracked(format!("d{place}")));
            if place + 1 == moved {
                panel = panel.with(Boxes::new(vec![cell(place, false), cell(place, true)]).opacity(0.0));
            }
        }
        let word = |x: f64, text: &str| Note::new((x, 1.15), text).corner(Corner::Centre).role(Role::Axis);
        panel.with(word(-wide / 2.0, "*i*")).with(word(wide / 2.0, "Φ(*i*)"))
    }

    fn power(base: usize, exponent: i32) -> String {
        format!("{base}^{{{exponent}}}")
    }

    fn caption(p: &DigitSteps, data: &Data, moved: usize) -> String {
        let (n, base) = (p.index, p.base);
        let digits: String = data.digits.iter().rev().map(|&digit| written(digit)).collect();
        let Some(last) = moved.checked_sub(1) else {
            return format!("$i = {n}$ in base {base} is {digits}. Its digits will be reflected at the point.");
        };
        let (digit, place) = (data.digits.get(last).copied().unwrap_or(0), base.pow(moved as u32));
        let sum = data.numerators.get(last).copied().unwrap_or(0);
        let common = data.denominator / place as u64;
        let so_far = format!("${} / {place}$", sum / common.max(1));
        let end = if moved == data.digits.len() { format!(": $\\Phi_{{{base}}}({n})$") } else { " so far".to_owned() };
        format!("$a_{{{moved}}} = {}$ adds ${}/{place}$. The sum is {so_far}{end}.", written(digit), digit)
    }

    pub(super) fn alt(p: &DigitSteps, data: &Data) -> String {
        let digits: String = data.digits.iter().rev().map(|&digit| written(digit)).collect();
        let mirrored: String = data.digits.iter().map(|&digit| written(digit)).collect();
        format!(
            "{} steps: the digits {digits} of {} in base {} move one by one to their mirror places behind the point, the last \
             first, and make .{mirrored}, which is {}/{}.",
            data.digits.len() + 1,
            p.index,
            p.base,
            data.numerators.last().copied().unwrap_or(0),
            data.denominator
        )
    }
}
