//! Paths in fewer bytes: each place from the one before, and no character that a reader of SVG does not need.

use super::backend::hundredths;

/// The SVG with the data of its paths short: the same hundredths, the same strokes. A path stands on one line.
pub(super) fn short(svg: &str) -> String {
    let mut out = String::with_capacity(svg.len());
    for line in svg.split_inclusive('\n') {
        match line.split_once(" d=\"").and_then(|(head, rest)| Some((head, rest.split_once('"')?))) {
            Some((head, (data, tail))) => {
                out.push_str(head);
                out.push_str(" d=\"");
                match Pen::default().write(data) {
                    Some(short) => out.push_str(&short),
                    None => out.push_str(data),
                }
                out.push('"');
                out.push_str(tail);
            }
            None => out.push_str(line),
        }
    }
    out
}

/// What writes a path.
#[derive(Default)]
struct Pen {
    out: String,
    /// Where it is, in hundredths.
    at: (i32, i32),
    /// Where the part of the path began.
    start: (i32, i32),
    /// The command that numbers without a letter would continue.
    implied: Option<char>,
    /// What the last number was: none since a letter, a whole one, or one with a point.
    last: Last,
}

#[derive(Default, Clone, Copy, PartialEq, Eq)]
enum Last {
    #[default]
    Letter,
    Whole,
    Decimal,
}

impl Pen {
    /// The path `data`, short; `None` if it holds what charts do not draw.
    fn write(mut self, data: &str) -> Option<String> {
        self.out.reserve(data.len());
        let mut rest = data;
        let mut numbers = Vec::new();
        while let Some(command) = rest.chars().next() {
            let end = rest[1..].find(|c: char| c.is_ascii_alphabetic()).map_or(rest.len(), |at| at + 1);
            numbers.clear();
            for text in rest[1..end].split_ascii_whitespace() {
                numbers.push((text.parse::<f64>().ok()? * 100.0).round() as i32);
            }
            self.command(command, &numbers)?;
            rest = &rest[end..];
        }
        Some(self.out)
    }

    fn command(&mut self, command: char, numbers: &[i32]) -> Option<()> {
        match (command, numbers) {
            ('M', &[x, y, ref lines @ ..]) if lines.len() % 2 == 0 => {
                self.go((x, y));
                lines.chunks_exact(2).for_each(|to| self.line((to[0] - self.at.0, to[1] - self.at.1)));
            }
            ('L', &[x, y]) => self.line((x - self.at.0, y - self.at.1)),
            ('l', &[x, y]) => self.line((x, y)),
            ('h', &[x]) => self.line((x, 0)),
            ('v', &[y]) => self.line((0, y)),
            ('A', &[rx, ry, turn, large, sweep, x, y]) => {
                self.step('a', &[rx, ry, turn, large, sweep, x - self.at.0, y - self.at.1], (x, y));
            }
            ('a', &[.., x, y]) if numbers.len() == 7 => {
                self.step('a', numbers, (self.at.0 + x, self.at.1 + y));
            }
            ('z', []) => {
                self.step('z', &[], self.start);
                self.implied = None;
            }
            _ => return None,
        }
        Some(())
    }

    /// Begins a part of the path.
    fn go(&mut self, to: (i32, i32)) {
        if self.out.is_empty() {
            self.step('M', &[to.0, to.1], to);
            self.implied = None;
        } else {
            self.implied = None;
            self.step('m', &[to.0 - self.at.0, to.1 - self.at.1], to);
            self.implied = Some('l');
        }
        self.start = to;
    }

    fn line(&mut self, by: (i32, i32)) {
        let to = (self.at.0 + by.0, self.at.1 + by.1);
        match by {
            (x, 0) => self.step('h', &[x], to),
            (0, y) => self.step('v', &[y], to),
            (x, y) => self.step('l', &[x, y], to),
        }
    }

    /// Writes a command, with its letter if need be, and stands at `to`.
    fn step(&mut self, command: char, numbers: &[i32], to: (i32, i32)) {
        if self.implied != Some(command) {
            self.out.push(command);
            self.last = Last::Letter;
        }
        for &number in numbers {
            self.number(number);
        }
        self.implied = Some(command);
        self.at = to;
    }

    /// Writes hundredths without a zero before the point, and a space before where two numbers would run together.
    fn number(&mut self, value: i32) {
        let fraction = value % 100 != 0;
        let bare = fraction && value.unsigned_abs() < 100;
        let apart = value < 0 || (bare && self.last == Last::Decimal) || self.last == Last::Letter;
        if !apart {
            self.out.push(' ');
        }
        let from = self.out.len();
        hundredths(value, &mut self.out);
        if bare {
            self.out.remove(from + usize::from(value < 0));
        }
        self.last = if fraction { Last::Decimal } else { Last::Whole };
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Where each command of a path ends, in hundredths from the sheet's corner: SVG's grammar, read character by character.
    pub(in crate::chart) fn places(data: &str) -> Vec<(char, i64, i64)> {
        let mut chars = data.chars().peekable();
        let (mut at, mut start, mut command, mut out) = ((0, 0), (0, 0), ' ', Vec::new());
        while let Some(&c) = chars.peek() {
            if c.is_ascii_alphabetic() {
                command = c;
                chars.next();
            }
            let count = match command.to_ascii_lowercase() {
                'm' | 'l' => 2,
                'h' | 'v' => 1,
                'a' => 7,
                'z' => 0,
                other => panic!("{other} in {data}"),
            };
            let numbers: Vec<i64> = (0..count).map(|_| number(&mut chars)).collect();
            let origin = if command.is_ascii_lowercase() { at } else { (0, 0) };
            at = match (command.to_ascii_lowercase(), &numbers[..]) {
                ('h', &[x]) => (origin.0 + x, at.1),
                ('v', &[y]) => (at.0, origin.1 + y),
                ('z', _) => start,
                (_, &[.., x, y]) => (origin.0 + x, origin.1 + y),
                _ => unreachable!(),
            };
            let kind = match command.to_ascii_lowercase() {
                'h' | 'v' => 'l',
                other => other,
            };
            out.push((kind, at.0, at.1));
            match command {
                'm' | 'M' => {
                    start = at;
                    command = if command == 'm' { 'l' } else { 'L' };
                }
                _ => {}
            }
        }
        out
    }

    /// One number: a sign, digits, at most one point; the space before it is skipped.
    fn number(chars: &mut std::iter::Peekable<std::str::Chars<'_>>) -> i64 {
        while chars.next_if_eq(&' ').is_some() {}
        let mut text = String::new();
        text.extend(chars.next_if_eq(&'-'));
        while let Some(c) = chars.next_if(|&c| c.is_ascii_digit() || (c == '.' && !text.contains('.'))) {
            text.push(c);
        }
        (text.parse::<f64>().unwrap() * 100.0).round() as i64
    }

    fn shortened(data: &str) -> String {
        let svg = short(&format!("<path class=\"x\" d=\"{data}\"/>\n"));
        svg.split_once(" d=\"").unwrap().1.strip_suffix("\"/>\n").unwrap().to_owned()
    }

    #[test]
    fn a_path_is_written_from_place_to_place() {
        assert_eq!(shortened("M1 2h0M1.5 0.5h0"), "M1 2h0m.5-1.5h0");
        assert_eq!(shortened("M1 2 4 6 4 7 3 7z"), "M1 2l3 4v1h-1z");
        assert_eq!(shortened("M0 0 0.5 0.25 1 0.5 0.4 0"), "M0 0l.5.25.5.25-.6-.5");
        // After a closed part, places count from where it began; after a move that has no letter, lines need none.
        assert_eq!(shortened("M1 1 2 2 3 1zM1 1 2 2"), "M1 1l1 1 1-1zm0 0 1 1");
        assert_eq!(shortened("M4 5a1 1 0 1 1 2 0a1 1 0 1 1 -2 0z"), "M4 5a1 1 0 1 1 2 0 1 1 0 1 1-2 0z");
        assert_eq!(shortened("M0 4A1 0.5 0 0 1 0 6L0.5 0z"), "M0 4a1 .5 0 0 1 0 2l.5-6z");
    }

    #[test]
    fn what_charts_do_not_draw_stays() {
        for data in ["M0 0C1 1 2 2 3 3", "M0 x", "m1 1l2 2", "M1 2 3"] {
            assert_eq!(shortened(data), data);
        }
        let text = "<text x=\"1\">d=\n</text>";
        assert_eq!(short(text), text);
    }

    #[test]
    fn the_short_path_has_the_same_places() {
        // Every pair of small steps, so that every way in which two numbers can meet is there.
        let steps = [-250, -100, -7, 0, 3, 20, 100, 115];
        let mut data = String::new();
        let (mut x, mut y) = (5000, 5000);
        for (index, (&a, &b)) in steps.iter().flat_map(|a| steps.iter().map(move |b| (a, b))).enumerate() {
            (x, y) = (x + a, y + b);
            data.push(if index % 5 == 0 { 'M' } else { 'L' });
            super::super::backend::pair((x, y), &mut data);
            match index % 5 {
                2 => data.push_str("a0.37 0.37 0 1 1 0.74 0a0.37 0.37 0 1 1 -0.74 0"),
                3 => data.push_str("h0.25v-0.5l1 -1L4.5 4.25A2 3 0 0 1 -1 -1.5"),
                4 => data.push('z'),
                _ => {}
            }
        }
        let short = shortened(&data);
        assert_eq!(places(&short), places(&data));
        assert!(short.len() < data.len() * 7 / 8, "{} of {}", short.len(), data.len());
    }
}
