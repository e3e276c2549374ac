//! The list `order` of `workbook.toml` with one chapter more, and every other byte as it was.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

/// The text of the configuration with `stem` at the end of `order`; none if it lists no chapters, so that all are read by name.
pub(super) fn with(text: &str, stem: &str) -> Option<String> {
    let table = DeTable::parse(text).ok()?;
    let value = table.get_ref().get("order")?;
    let span = value.span();
    let quoted = format!("\"{stem}\"");
    let insertions = match value.get_ref() {
        DeValue::Array(elements) => match elements.iter().next_back() {
            Some(last) => behind(text, &last.span(), span.end, &quoted),
            None => vec![(span.start + 1, quoted)],
        },
        // A single chapter may stand without brackets.
        _ => vec![(span.start, "[".to_owned()), (span.end, format!(", {quoted}]"))],
    };
    let mut text = text.to_owned();
    for (at, insertion) in insertions.into_iter().rev() {
        text.insert_str(at, &insertion);
    }
    Some(text)
}

/// What is to be inserted where, so that `quoted` stands behind the element `last` of a list that ends at `end`.
fn behind(text: &str, last: &Range<usize>, end: usize, quoted: &str) -> Vec<(usize, String)> {
    let rest = &text[last.end..end];
    let comma = comma(rest);
    let line = text[..last.start].rfind('\n').map_or(0, |newline| newline + 1);
    let indent = &text[line..last.start];
    // An element with a line of its own is followed by one with a line of its own.
    let newline = rest.find('\n').filter(|_| line > 0 && indent.trim().is_empty());
    let Some(newline) = newline.filter(|newline| comma.is_none_or(|comma| comma < *newline)) else {
        return match comma {
            Some(comma) => vec![(last.end + comma + 1, format!(" {quoted}"))],
            None => vec![(last.end, format!(", {quoted}"))],
        };
    };
    let until = rest[..newline].trim_end_matches('\r').len();
    let ending = &rest[until..=newline];
    // A comment behind the last element stays with it.
    let next = format!("{ending}{indent}{quoted}");
    match comma {
        Some(_) => vec![(last.end + until, format!("{next},"))],
        None => vec![(last.end, ",".to_owned()), (last.end + until, next)],
    }
}

/// Where the comma behind an element is, if there is one outside of comments.
fn comma(rest: &str) -> Option<usize> {
    let mut comment = false;
    for (at, c) in rest.char_indices() {
        match c {
            '#' => comment = true,
            '\n' => comment = false,
            ',' if !comment => return Some(at),
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::with;

    #[test]
    fn a_chapter_is_added_and_nothing_else_changes() {
        let cases = [
            ("order = [\"a\"]\n", "order = [\"a\", \"b\"]\n"),
            ("order = [\"a\", ]\n", "order = [\"a\", \"b\" ]\n"),
            ("order = []\n", "order = [\"b\"]\n"),
            ("order = \"a\" # alone\n", "order = [\"a\", \"b\"] # alone\n"),
            ("order = [\n    \"a\",\n]\n", "order = [\n    \"a\",\n    \"b\",\n]\n"),
            ("order = [\n  \"a\"\n]\n", "order = [\n  \"a\",\n  \"b\"\n]\n"),
            ("order = [\n\t\"a\", # one, two\n]\nx = 1\n", "order = [\n\t\"a\", # one, two\n\t\"b\",\n]\nx = 1\n"),
            ("order = [\n  \"a\" # first, yes\n]\n", "order = [\n  \"a\", # first, yes\n  \"b\"\n]\n"),
            ("order = [\r\n  \"a\",\r\n]\r\n", "order = [\r\n  \"a\",\r\n  \"b\",\r\n]\r\n"),
            ("order = [\n  \"a\"\n  , ]\n", "order = [\n  \"a\"\n  , \"b\" ]\n"),
        ];
        for (before, after) in cases {
            let given = with(before, "b").unwrap();
            assert_eq!(given, after);
            let read: toml::Table = given.parse().unwrap();
            assert_eq!(read["order"].as_array().unwrap().last().unwrap().as_str(), Some("b"), "{before}");
        }
    }

    #[test]
    fn a_course_that_lists_no_chapters_stays_as_it_is() {
        assert_eq!(with("title = \"x\"\n", "b"), None);
    }
}
