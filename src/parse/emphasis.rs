//! Which lines of a piece of code are to be looked at first: `3,5-7`.

use std::ops::RangeInclusive;

/// The lines of a piece of code that stand out, counted from 1.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Emphasis {
    ranges: Vec<RangeInclusive<usize>>,
}

impl Emphasis {
    /// Reads lines and ranges of lines with commas between them. The error is the part that is neither.
    pub fn read(text: &str) -> Result<Self, &str> {
        let part = |part| {
            let (first, last) = str::split_once(part, '-').unwrap_or((part, part));
            match (first.trim().parse::<usize>(), last.trim().parse::<usize>()) {
                (Ok(first), Ok(last)) if 0 < first && first <= last => Ok(first..=last),
                _ => Err(part.trim()),
            }
        };
        Ok(Self { ranges: text.split(',').map(part).collect::<Result<_, _>>()? })
    }

    /// Whether the line `line` stands out.
    pub fn holds(&self, line: usize) -> bool {
        self.ranges.iter().any(|range| range.contains(&line))
    }

    /// The last line that stands out; 0 if none does.
    pub fn last(&self) -> usize {
        self.ranges.iter().map(|range| *range.end()).max().unwrap_or_default()
    }

    /// What is wrong with it for code of `lines` lines, in a sentence, if anything is.
    pub fn beyond(&self, lines: usize) -> Option<String> {
        let count = if lines == 1 { "is one line".to_owned() } else { format!("are {lines} lines") };
        (self.last() > lines).then(|| format!("line {} is to stand out, and there {count}", self.last()))
    }
}

/// What to do about lines that cannot be read.
pub const HELP: &str = "write lines and ranges, from 1: `3,5-7`";

/// The words behind a plain fence: the language, and what stands between braces, if there are any.
pub fn fence(info: &str) -> (&str, Option<&str>) {
    let (language, rest) = info.find('{').map_or((info, ""), |at| info.split_at(at));
    let language = language.split_whitespace().next().unwrap_or_default();
    let inner = rest.strip_prefix('{').map(|rest| rest.trim_end().strip_suffix('}').unwrap_or(rest));
    (language, inner)
}

#[cfg(test)]
mod tests {
    use super::{Emphasis, fence};

    #[test]
    fn lines_and_ranges_are_read() {
        let read = Emphasis::read("3, 5-7").expect("two parts");
        let held: Vec<usize> = (0..10).filter(|&line| read.holds(line)).collect();
        assert_eq!((held, read.last()), (vec![3, 5, 6, 7], 7));
        for (text, wrong) in [("", ""), ("0", "0"), ("3,x", "x"), ("7-5", "7-5"), ("1,,2", ""), ("-2", "-2")] {
            assert_eq!(Emphasis::read(text), Err(wrong), "{text}");
        }
        assert_eq!(read.beyond(7), None);
        assert_eq!(read.beyond(6).as_deref(), Some("line 7 is to stand out, and there are 6 lines"));
        assert!(read.beyond(1).is_some_and(|told| told.ends_with("there is one line")));
    }

    #[test]
    fn a_fence_has_a_language_and_braces() {
        assert_eq!(fence("c"), ("c", None));
        assert_eq!(fence("c {3,5-7}"), ("c", Some("3,5-7")));
        assert_eq!(fence("c{3}"), ("c", Some("3")));
        assert_eq!(fence(" {1} "), ("", Some("1")));
        assert_eq!(fence("c {3"), ("c", Some("3")));
        assert_eq!(fence(""), ("", None));
    }
}
