//! Rich text: italics, superscripts, subscripts; and how wide it will be.
//!
//! The fonts of a reader are unknown, so widths are those of a common sans serif (Helvetica's metrics) with some slack.

use super::number::THIN;
use std::fmt::Write;

/// The size of ordinary labels, in units.
pub(super) const SIZE: f64 = 14.0;
/// The size of raised and lowered text, as a share of the label's.
const SMALL: f64 = 0.74;
/// Room for wider fonts, and for the larger text of narrow screens.
const SLACK: f64 = 1.1;

/// Where a run of text stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Level {
    Base,
    Raised,
    Lowered,
}

/// Text of one shape on one level.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Run {
    pub text: String,
    pub italic: bool,
    pub level: Level,
}

/// A label: `*N*` is italic, `^{..}` raised, `_{..}` lowered; a backslash takes the next character as it is.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Rich {
    pub(super) runs: Vec<Run>,
}

impl Rich {
    /// Reads markup. What is not markup stays as it is.
    pub fn new(markup: &str) -> Self {
        let mut rich = Self::default();
        let (mut italic, mut level) = (false, Level::Base);
        let mut rest = markup.chars().peekable();
        while let Some(c) = rest.next() {
            match c {
                '\\' => rich.push(rest.next().unwrap_or('\\'), italic, level),
                '*' => italic = !italic,
                '^' | '_' if rest.peek() == Some(&'{') => {
                    rest.next();
                    level = if c == '^' { Level::Raised } else { Level::Lowered };
                }
                '}' if level != Level::Base => level = Level::Base,
                '-' if level != Level::Base => rich.push('\u{2212}', italic, level),
                c if c.is_control() => rich.push(' ', italic, level),
                c => rich.push(c, italic, level),
            }
        }
        rich
    }

    /// Text without markup, as an author wrote it.
    pub fn plain(text: &str) -> Self {
        let mut rich = Self::default();
        for c in text.chars() {
            rich.push(if c.is_control() { ' ' } else { c }, false, Level::Base);
        }
        rich
    }

    /// A power, as on a logarithmic axis.
    pub(super) fn power(base: &str, exponent: i32) -> Self {
        Self::new(&format!("{base}^{{{exponent}}}"))
    }

    /// Whether there is nothing to show.
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// The width at the size of ordinary labels, in units: an estimate that is rather too wide.
    pub fn width(&self) -> f64 {
        let run = |run: &Run| {
            let size = if run.level == Level::Base { SIZE } else { SIZE * SMALL };
            run.text.chars().map(advance).sum::<f64>() * size / 1000.0
        };
        self.runs.iter().map(run).sum::<f64>() * SLACK
    }

    /// The label in lines no wider than `width`, broken at spaces; a single word may be wider.
    pub(super) fn wrapped(&self, width: f64) -> Vec<Self> {
        let mut lines = vec![Self::default()];
        let mut word = Self::default();
        let place = |word: &mut Self, lines: &mut Vec<Self>| {
            let word = std::mem::take(word);
            if let Some(line) = lines.last_mut() {
                let joined = line.joined(&word);
                if line.is_empty() || joined.clone().trimmed().width() <= width {
                    *line = joined;
                } else {
                    lines.push(word);
                }
            }
        };
        for run in &self.runs {
            for c in run.text.chars() {
                word.push(c, run.italic, run.level);
                if c == ' ' {
                    place(&mut word, &mut lines);
                }
            }
        }
        place(&mut word, &mut lines);
        lines.into_iter().map(Self::trimmed).collect()
    }

    /// This and `other` behind it.
    fn joined(&self, other: &Self) -> Self {
        let mut joined = self.clone();
        other.runs.iter().for_each(|run| run.text.chars().for_each(|c| joined.push(c, run.italic, run.level)));
        joined
    }

    /// Without the spaces at the end.
    fn trimmed(mut self) -> Self {
        if let Some(last) = self.runs.last_mut() {
            last.text.truncate(last.text.trim_end().len());
        }
        self
    }

    /// Appends the elements and text of SVG.
    pub(super) fn write(&self, out: &mut String) {
        let mut lowered = 0.0;
        for run in &self.runs {
            let target = match run.level {
                Level::Base => 0.0,
                Level::Raised => -0.36,
                Level::Lowered => 0.22,
            };
            let shift: f64 = target - lowered;
            lowered = target;
            let small = run.level != Level::Base;
            if !run.italic && !small && shift == 0.0 {
                escape(&run.text, out);
                continue;
            }
            out.push_str("<tspan");
            if run.italic {
                out.push_str(" class=\"m\" font-family=\"Georgia,'Times New Roman',serif\" font-style=\"italic\"");
            }
            if small {
                out.push_str(" font-size=\".74em\"");
            }
            if shift != 0.0 {
                // The shift is in the run's own size.
                let own = if small { shift / SMALL } else { shift };
                // Writing to a string cannot fail.
                let _ = write!(out, " dy=\"{own:.2}em\"");
            }
            out.push('>');
            escape(&run.text, out);
            out.push_str("</tspan>");
        }
    }

    /// Adds a character; a straight apostrophe is printed as one.
    fn push(&mut self, c: char, italic: bool, level: Level) {
        let c = if c == '\'' { '\u{2019}' } else { c };
        match self.runs.last_mut() {
            Some(run) if run.italic == italic && run.level == level => run.text.push(c),
            _ => self.runs.push(Run { text: c.into(), italic, level }),
        }
    }
}

impl From<&str> for Rich {
    fn from(markup: &str) -> Self {
        Self::new(markup)
    }
}

impl From<String> for Rich {
    fn from(markup: String) -> Self {
        Self::new(&markup)
    }
}

impl From<&String> for Rich {
    fn from(markup: &String) -> Self {
        Self::new(markup)
    }
}

/// Appends `text` as XML allows it in content and in attributes.
pub(super) fn escape(text: &str, out: &mut String) {
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
}

/// How far a character moves the pen, in thousandths of the size.
fn advance(c: char) -> f64 {
    /// Space to tilde.
    const ASCII: [u16; 95] = [
        278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278, 556, 556, 556, 556, 556, 556,
        556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667,
        556, 833, 722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, 333, 556,
        556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722,
        500, 500, 500, 334, 260, 334, 584,
    ];
    let index = (c as usize).wrapping_sub(32);
    match (ASCII.get(index), c) {
        (Some(&width), _) => f64::from(width),
        (None, THIN | '\u{200a}') => 200.0,
        (None, '\u{2212}' | '×' | '±' | '≤' | '≥' | '≈') => 584.0,
        (None, '∞' | '√' | '—' | '…' | '∑' | '∫') => 900.0,
        (None, c) if (c as u32) < 0x0600 => 580.0,
        (None, '\u{2000}'..='\u{20ff}') => 500.0,
        (None, _) => 1000.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn svg(markup: &str) -> String {
        let mut out = String::new();
        Rich::new(markup).write(&mut out);
        out
    }

    #[test]
    fn powers_are_raised_and_come_down_again() {
        assert_eq!(
            svg("10^{-3} m"),
            "10<tspan font-size=\".74em\" dy=\"-0.49em\">−3</tspan><tspan dy=\"0.36em\"> m</tspan>"
        );
    }

    #[test]
    fn text_is_escaped() {
        assert_eq!(svg("a<b & \"c\"\u{7}"), "a&lt;b &amp; &quot;c&quot; ");
        let mut out = String::new();
        Rich::plain("3*x^{2}_").write(&mut out);
        assert_eq!(out, "3*x^{2}_");
        assert_eq!(svg("3\\*x^2"), "3*x^2");
    }

    #[test]
    fn long_titles_are_broken_at_spaces() {
        let title = Rich::new("Halton with random permutations, *N* = 16");
        let lines = title.wrapped(120.0);
        assert!(lines.len() > 1 && lines.iter().all(|line| line.width() <= 120.0));
        let text = |line: &Rich| line.runs.iter().map(|run| run.text.as_str()).collect::<String>();
        let words: Vec<String> = lines.iter().map(text).collect();
        assert_eq!(words.join(" "), "Halton with random permutations, N = 16");
        assert_eq!(title.wrapped(1000.0), vec![title]);
        assert_eq!(Rich::new("unbreakable").wrapped(1.0).len(), 1);
    }

    #[test]
    fn widths_grow_with_the_text() {
        assert!(Rich::new("").width() == 0.0);
        assert!(Rich::new("10^{-3}").width() < Rich::new("10-3").width());
        assert!((Rich::plain("0.0").width() - 1390.0 * SIZE / 1000.0 * SLACK).abs() < 1e-9);
    }
}
