//! A digital shift converted to single precision: of the 2^32 random words 128 give exactly 1.
//!
//! A `f32` has 24 bits, and the conversion of 32 rounds to the nearest. Whatever the index is, XOR with all words gives all words, so that
//! only the conversion counts; it never falls as the word grows, and its first 1 is found by bisection.

use super::{Asked, Bug, Count, Facts, Found, Side};
use crate::kinds::Failure;
use crate::seed::Seed;
use crate::stats::portable;

/// The XOR-scrambled radical inverse in base 2.
pub static BUG: Bug = Bug {
    key: "rounded-shift",
    title: "32 bits rounded to single precision",
    n: Some(Count::new(1 << 24, 1, 1 << 30)),
    replicates: None,
    uses: &["van-der-corput+xor"],
    weight: |_| 10_000,
    run,
    draw: drawing::draw,
    alt: drawing::alt,
};

/// The radical inverse in base 2, its bits XORed with a random word; all 32 bits are converted.
fn wrong(index: u32, word: u32) -> f32 {
    (index.reverse_bits() ^ word) as f32 / 4_294_967_296.0
}

/// The same, but only the 24 bits are kept that a `f32` can hold.
fn right(index: u32, word: u32) -> f32 {
    ((index.reverse_bits() ^ word) >> 8) as f32 / 16_777_216.0
}

/// How many words there are.
const WORDS: f64 = 4_294_967_296.0;

/// How many of the last words are shown.
const SHOWN: u32 = 1024;

fn run(asked: &Asked, _: Seed) -> Result<Found, Failure> {
    let facts = Facts::default().integer("samples", asked.n as i64);
    Ok(Found { wrong: measure(asked, wrong), right: measure(asked, right), facts })
}

/// The test: no word gives 1.
fn measure(asked: &Asked, convert: fn(u32, u32) -> f32) -> Side {
    let ones = ones(convert);
    let share = ones as f64 / WORDS;
    let facts = Facts::default()
        .integer("words", ones as i64)
        .number("share", share)
        .number("largest", f64::from(convert(0, u32::MAX)))
        .number("chance", at_least_once(share, asked.n as f64));
    let words = || {
        (u32::MAX - SHOWN + 1..=u32::MAX).filter(|word| {
            // The first word of each step of the staircase, and the last of all.
            *word == u32::MAX - SHOWN + 1 || *word == u32::MAX || convert(0, *word) > convert(0, *word - 1)
        })
    };
    let counts = || (0..=30).map(|exponent| f64::from(1_u32 << exponent));
    Side::new(ones == 0, facts)
        .column("words to the end", words().map(|word| f64::from(word) - WORDS))
        .column("value less 1", words().map(|word| f64::from(convert(0, word)) - 1.0))
        .list("samples", counts())
        .list("chance", counts().map(|count| at_least_once(share, count)))
}

/// How many words give 1.
fn ones(convert: fn(u32, u32) -> f32) -> u64 {
    let (mut low, mut high) = (0, 1_u64 << 32);
    while low < high {
        let middle = u64::midpoint(low, high);
        if convert(0, middle as u32) < 1.0 {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    (1 << 32) - low
}

/// The probability that what happens with the small probability `share` happens in `count` samples: 1 - (1 - share)^count.
fn at_least_once(share: f64, count: f64) -> f64 {
    1.0 - portable::exp(-count * (share + share * share / 2.0))
}

mod drawing {
    //! The end of the staircase and the chance of a 1, and their words.

    use super::super::drawing::{RIGHT, WRONG};
    use super::{Asked, Found, SHOWN, Side};
    use crate::chart::number::{fixed, integer, scientific};
    use crate::chart::{Axis, Chart, ChartError, Drawing, Key, Line, Panel, Rule, Sheet, Style};

    /// The distance of neighbours among single-precision numbers below 1.
    const GRAIN: f64 = 1.0 / 16_777_216.0;

    pub(super) fn draw(_: &Asked, found: &Found, sheet: &Sheet) -> Result<Drawing, ChartError> {
        Ok(Chart::grid(vec![steps(found), chances(found)]).columns(2).key(Key::Above).draw(sheet)?.into())
    }

    fn steps(found: &Found) -> Panel {
        let ticks = [896, 640, 384, 128].into_iter().map(|k| (f64::from(-k), format!("\u{2212}{k}").into()));
        let along = Axis::linear("word, less 2^{32}").range(-f64::from(SHOWN), 0.0).ticks_at(ticks.collect());
        let heights = (0..=4).map(|k| {
            let label = if k == 0 { "1".to_owned() } else { format!("1\u{2009}\u{2212}\u{2009}{k}·2^{{-24}}") };
            (-f64::from(k) * GRAIN, label.replace("1·", "").as_str().into())
        });
        let up = Axis::linear("number").range(-4.3 * GRAIN, 0.4 * GRAIN).ticks_at(heights.collect());
        let line = |side: &Side, style: Style, label: &str| {
            Line::new(side.pairs("words to the end", "value less 1")).stepped().style(style).label(label)
        };
        Panel::new(along, up)
            .title("The last words")
            .ratio(0.95)
            .with(Rule::horizontal(0.0))
            .with(line(&found.wrong, WRONG, "wrong: 32 bits rounded"))
            .with(line(&found.right, RIGHT, "right: 24 bits kept"))
    }

    fn chances(found: &Found) -> Panel {
        let line = |side: &Side, style: Style| Line::new(side.pairs("samples", "chance")).style(style);
        Panel::new(Axis::log2("samples"), Axis::linear("chance of a 1").range(0.0, 1.0))
            .title("At least one 1")
            .ratio(0.95)
            .with(line(&found.right, RIGHT))
            .with(line(&found.wrong, WRONG))
            .with(Rule::vertical(found.facts.get("samples")))
    }

    pub(super) fn alt(asked: &Asked, found: &Found) -> String {
        let facts = &found.wrong.facts;
        format!(
            "Left, the last {SHOWN} of the 2^32 words and the number that each becomes: rounded, the staircase reaches 1 and {} words give \
             exactly 1, a share of {}; with 24 bits kept {} words do, and the top step stays below. Right, the chance that at least one of \
             many samples is 1: rounded {} for {} samples; with 24 bits kept {}.",
            facts.count("words"),
            scientific(facts.get("share"), 3),
            found.right.facts.count("words"),
            fixed(facts.get("chance"), 3),
            integer(asked.n as i64),
            fixed(found.right.facts.get("chance"), 0),
        )
    }
}
