//! Which sections have which words, in few bytes.
//!
//! Words are sorted; each is written as one letter for how many characters it shares with the one before, and the rest of it. The sections of
//! a word are written as differences of their numbers, each in letters that hold five bits, the smallest first; those of the upper half
//! of the alphabet say that another follows.

use std::collections::{BTreeMap, BTreeSet};

use super::words;

const LETTERS: &[u8; 62] = b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
/// What one letter holds.
const HALF: usize = 31;
/// From this many sections on, a word that most of them have says nothing.
const MANY: usize = 8;

/// The words of the text and the sections that have them.
#[derive(Default)]
pub(super) struct Posts {
    sections: usize,
    words: BTreeMap<String, BTreeSet<usize>>,
}

impl Posts {
    /// Begins a section; gives its number.
    pub(super) fn open(&mut self) -> usize {
        self.sections += 1;
        self.sections - 1
    }

    /// Adds the words of a text in a section.
    pub(super) fn add(&mut self, section: usize, text: &str) {
        for word in words::of(text).filter(|word| word.chars().count() > 1 && !word.chars().all(char::is_numeric)) {
            self.words.entry(word).or_default().insert(section);
        }
    }

    /// The words, their sections, and the words that most sections have, which are not among the others.
    pub(super) fn encoded(&self) -> (String, String, String) {
        let frequent = |sections: &BTreeSet<usize>| self.sections >= MANY && 2 * sections.len() > self.sections;
        let (mut words, mut posts, mut common) = (Vec::new(), Vec::new(), Vec::new());
        let mut before = "";
        for (word, sections) in &self.words {
            if frequent(sections) {
                common.push(word.as_str());
                continue;
            }
            let shared = before.chars().zip(word.chars()).take_while(|(a, b)| a == b).count().min(LETTERS.len() - 1);
            let rest: String = word.chars().skip(shared).collect();
            words.push(format!("{}{rest}", char::from(LETTERS[shared])));
            before = word;
            let mut last = 0;
            posts.push(sections.iter().fold(String::new(), |mut text, &section| {
                number(section - last, &mut text);
                last = section;
                text
            }));
        }
        (words.join(" "), posts.join(" "), common.join(" "))
    }
}

fn number(mut value: usize, text: &mut String) {
    while value >= HALF {
        text.push(char::from(LETTERS[HALF + value % HALF]));
        value /= HALF;
    }
    text.push(char::from(LETTERS[value]));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_share_beginnings_and_sections_are_differences() {
        let mut posts = Posts::default();
        for text in ["Strata, stratum", "", "stratum; a 12 Sobol’", "strata"] {
            let section = posts.open();
            posts.add(section, text);
        }
        assert_eq!(posts.encoded(), ("0sobol 1trata 5um".to_owned(), "2 03 02".to_owned(), String::new()));
    }

    #[test]
    fn large_differences_take_more_letters() {
        let mut text = String::new();
        for value in [0, 30, 31, 100, 1000] {
            number(value, &mut text);
        }
        assert_eq!(text, "0uv1C3Dw1");
    }

    #[test]
    fn what_most_sections_have_is_common() {
        let mut posts = Posts::default();
        for index in 0..8 {
            let section = posts.open();
            posts.add(section, if index < 5 { "the point" } else { "point rare" });
        }
        assert_eq!(posts.encoded(), ("0rare".to_owned(), "511".to_owned(), "point the".to_owned()));
    }
}
