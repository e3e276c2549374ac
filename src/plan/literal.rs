//! Numbers in a text that look like results: decimals, powers of ten with a factor, percentages, and how many times.
//!
//! Whole numbers, fractions of whole numbers and powers such as 10^4 are parameters of the text, and stand free.

use std::ops::Range;

/// Stands in a text where a formula begins.
pub(super) const MATH: char = '\u{e000}';
/// Stands in a text where a formula ends.
pub(super) const END: char = '\u{e001}';
/// Stands in a text for what is no text, such as a value.
pub(super) const HOLE: char = '\u{e002}';

/// What can stand between digits, or between a number and its unit, in LaTeX and in text.
const SPACES: &[&str] =
    &["\\,", "\\;", "\\:", "\\!", "\\ ", "~", "\u{2009}", "\u{202f}", "\u{a0}", "&nbsp;", "&thinsp;"];

/// What makes something else of a decimal of a formula: a base, as in `0.011_2`, or a length of LaTeX.
const AFTER_NO_DECIMAL: &[&str] = &["_", ")_", "em", "ex", "pt", "mu", "cm", "mm"];

/// The bytes of every number in `text` that looks like a result.
pub(super) fn find(text: &str) -> Vec<Range<usize>> {
    let mut scan = Scan { text, at: 0, math: false };
    let mut found = Vec::new();
    while let Some(c) = scan.rest().chars().next() {
        match c {
            MATH | END => scan.math = c == MATH,
            '0'..='9' => {
                found.extend(scan.number());
                continue;
            }
            '.' if scan.begins_fraction() => {
                found.extend(scan.number());
                continue;
            }
            _ => {}
        }
        scan.at += c.len_utf8();
    }
    found
}

/// The literal as it is compared: without the spaces that typography puts into it.
pub(super) fn normal(literal: &str) -> String {
    let literal = SPACES.iter().fold(literal.replace("\\%", "%"), |text, space| text.replace(space, ""));
    literal.chars().filter(|c| !c.is_whitespace() && ![MATH, END].contains(c)).collect()
}

/// A place in a text.
#[derive(Clone)]
struct Scan<'a> {
    text: &'a str,
    at: usize,
    /// Whether it is within a formula.
    math: bool,
}

impl<'a> Scan<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn before(&self) -> Option<char> {
        self.text[..self.at].chars().next_back()
    }

    /// Goes past `word` if it is next.
    fn eat(&mut self, word: &str) -> bool {
        let found = self.rest().starts_with(word);
        self.at += if found { word.len() } else { 0 };
        found
    }

    fn eat_any(&mut self, words: &[&str]) -> bool {
        words.iter().any(|word| self.eat(word))
    }

    /// Goes past digits; whether there were any.
    fn digits(&mut self) -> bool {
        let length = self.rest().bytes().take_while(u8::is_ascii_digit).count();
        self.at += length;
        length > 0
    }

    /// Goes past spaces, and past the end of a formula; whether there were any.
    fn spaces(&mut self) -> bool {
        let start = self.at;
        while self.eat(" ") || self.eat("-") || self.eat_any(SPACES) || (self.math && self.eat_end()) {}
        self.at > start
    }

    fn eat_end(&mut self) -> bool {
        let found = self.rest().starts_with(END);
        if found {
            self.at += END.len_utf8();
            self.math = false;
        }
        found
    }

    /// Whether the point that is next begins a number such as `.5`.
    fn begins_fraction(&self) -> bool {
        let digit = self.rest()[1..].starts_with(|c: char| c.is_ascii_digit());
        digit && !self.before().is_some_and(|c| c.is_alphanumeric() || c == '.')
    }

    /// Goes past the number that begins here; its bytes if it looks like a result.
    fn number(&mut self) -> Option<Range<usize>> {
        let start = self.at;
        let before = self.before();
        let decimal = self.mantissa();
        if !self.math && (before.is_some_and(|c| c.is_alphabetic() || c == '_') || self.is_version()) {
            return None;
        }
        if self.math && decimal && AFTER_NO_DECIMAL.iter().any(|after| self.rest().starts_with(after)) {
            return None;
        }
        let raised = matches!(before, Some('^' | '_'));
        let powered = !raised && self.power_of_ten();
        // What follows may belong to it: only if it does, it is gone past.
        let mut ahead = self.clone();
        let counted = !raised && (powered || ahead.exponent()) && ahead.unit() || !raised && ahead.unit();
        if counted {
            *self = ahead;
        }
        (decimal || powered || counted).then_some(start..self.at)
    }

    /// Goes past digits in groups and a fraction; whether there was a fraction.
    fn mantissa(&mut self) -> bool {
        self.digits();
        while self.group(3) {}
        let mut ahead = self.clone();
        if !((ahead.eat(".") || ahead.math && ahead.eat("{.}")) && ahead.digits()) {
            return false;
        }
        *self = ahead;
        while self.group(1) {}
        true
    }

    /// Goes past a thin space and the digits behind it, if they are at least so many, or exactly three.
    fn group(&mut self, least: usize) -> bool {
        let mut ahead = self.clone();
        let separated = ahead.eat_any(SPACES) || ahead.math && ahead.eat("{,}");
        let start = ahead.at;
        let found = separated && ahead.digits() && (ahead.at - start >= least) && (ahead.at - start <= 3);
        if found {
            *self = ahead;
        }
        found
    }

    /// Goes past the rest of `1.2.3`, which is no number.
    fn is_version(&mut self) -> bool {
        let start = self.at;
        while self.rest().starts_with('.') && self.rest()[1..].starts_with(|c: char| c.is_ascii_digit()) {
            self.at += 1;
            self.digits();
        }
        self.at > start
    }

    /// Goes past `e-5`, or past a sign of multiplication and a power of ten.
    fn power_of_ten(&mut self) -> bool {
        let mut ahead = self.clone();
        if !ahead.math && ahead.eat_any(&["e", "E"]) {
            ahead.eat_any(&["-", "+", "\u{2212}"]);
            if ahead.digits() && !ahead.rest().starts_with(char::is_alphabetic) {
                *self = ahead;
                return true;
            }
            ahead = self.clone();
        }
        ahead.spaces();
        let product = ahead.eat_any(&["\\cdot", "\\times", "\u{d7}", "\u{b7}", "\u{22c5}"]);
        ahead.spaces();
        let found = product && ahead.eat("10") && ahead.exponent();
        if found {
            *self = ahead;
        }
        found
    }

    /// Goes past an exponent: `^4`, `^{-5}`, or superscript digits.
    fn exponent(&mut self) -> bool {
        let raised = self.rest().chars().take_while(|&c| "⁰¹²³⁴⁵⁶⁷⁸⁹⁻".contains(c)).map(char::len_utf8).sum::<usize>();
        if raised > 0 {
            self.at += raised;
            return true;
        }
        let mut ahead = self.clone();
        if !ahead.eat("^") {
            return false;
        }
        let found = if ahead.eat("{") {
            let length = ahead.rest().find('}').map(|close| close + 1);
            ahead.at += length.unwrap_or(0);
            length.is_some()
        } else {
            ahead.eat_any(&["-", "\u{2212}"]);
            ahead.digits()
        };
        if found {
            *self = ahead;
        }
        found
    }

    /// Goes past `%`, `per cent` or `times`.
    fn unit(&mut self) -> bool {
        let spaced = self.spaces();
        if self.eat_any(&["%", "\\%"]) {
            return true;
        }
        let word = spaced && !self.math && self.eat_any(&["per cent", "percent", "times"]);
        word && !self.rest().starts_with(char::is_alphanumeric)
    }
}

#[cfg(test)]
mod tests {
    use super::{END, MATH, find, normal};

    /// The numbers that are found in `text`, in which `$` stands around formulas.
    fn found(text: &str) -> Vec<String> {
        let mut text = text.to_owned();
        while text.contains('$') {
            text = text.replacen('$', &MATH.to_string(), 1).replacen('$', &END.to_string(), 1);
        }
        let ranges = find(&text);
        ranges.into_iter().map(|range| text[range].replace(END, "$")).collect()
    }

    #[test]
    fn what_looks_like_a_result_is_found_whole() {
        for (text, expected) in [
            ("an error of 0.0034, and 2.718.", &["0.0034", "2.718"][..]),
            ("(.5 and -0.5)", &[".5", "0.5"]),
            ("$F \\approx 2.75039$, $x \\in [0.25, 1)$", &["2.75039", "0.25"]),
            ("$0.003\\,45$ and 1\u{202f}234.5", &["0.003\\,45", "1\u{202f}234.5"]),
            (
                "$2 \\cdot 10^{-5}$, $2\\times10^4$, 2 × 10⁻⁵, 3e-7, 1.5e3",
                &["2 \\cdot 10^{-5}", "2\\times10^4", "2 × 10⁻⁵", "3e-7", "1.5e3"],
            ),
            (
                "4.4 per cent, 95 percent, 2.3 %, 5\\%, $50\\,\\%$, $7$ per cent",
                &["4.4 per cent", "95 percent", "2.3 %", "5\\%", "50\\,\\%", "7$ per cent"],
            ),
            (
                "1.9 times as many, 16 times, $4$ times, $10^4$ times, 2-times",
                &["1.9 times", "16 times", "4$ times", "10^4$ times", "2-times"],
            ),
            ("$N^{-1.47}$, $\\le0.5$, 3.5mm", &["1.47", "0.5", "3.5"]),
        ] {
            assert_eq!(found(text), expected, "{text}");
        }
    }

    #[test]
    fn parameters_fractions_and_exponents_are_free() {
        for text in [
            "64 samples in 8 dimensions, 1\u{2009}000 of them; in 1949.",
            "$N = 10^4$, $2^{10}$, $10^{-5}$, $1/2$, $-3/2$, $\\frac{1}{12}$, $4\\,096$, $1 + 4 \\cdot 10$",
            "$x_1 \\times 3$, $10^4 \\cdot 10^2$, $a \\cdot 10^{3}$, 2^4..2^14",
            "version 1.2.3 of v1.5 and f64, x2.5; three times, at times, 3 timescales",
            "$a\\hspace{0.5em}b$, $0.011_2 = (0.12)_{3}$",
            "five per cent",
        ] {
            assert_eq!(found(text), [""; 0], "{text}");
        }
    }

    #[test]
    fn typography_does_not_count() {
        assert_eq!(normal("1\\,234.5 \\%"), normal("1\u{2009}234.5\u{202f}%"));
        assert_eq!(normal("4.4 per cent"), "4.4percent");
        assert_ne!(normal("0.34"), normal("3.4"));
    }
}
