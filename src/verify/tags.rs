//! The tags of a page: enough of HTML to see what a page links to and loads.

/// The start of an element.
pub(super) struct Tag<'p> {
    /// Its name, as written.
    pub name: &'p str,
    /// Its attributes in order; one without a value has an empty one.
    pub attributes: Vec<(&'p str, &'p str)>,
    /// Where it starts on the page.
    pub start: usize,
    /// The text of a style or a script; empty for any other element.
    pub text: &'p str,
}

impl<'p> Tag<'p> {
    /// The value of an attribute.
    pub fn get(&self, name: &str) -> Option<&'p str> {
        self.attributes.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|&(_, value)| value)
    }
}

/// The tags that start elements, in order. What stands in comments, styles and scripts is no tag.
pub(super) fn tags(page: &str) -> impl Iterator<Item = Tag<'_>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        loop {
            at += page.get(at..)?.find('<')?;
            let rest = &page[at + 1..];
            if rest.starts_with("!--") {
                at += rest.find("-->").map_or(rest.len(), |end| end + "-->".len());
            } else if rest.starts_with(|c: char| c.is_ascii_alphabetic()) {
                let (tag, length) = tag(rest, at);
                at += 1 + length;
                return Some(tag);
            }
            at += 1;
        }
    })
}

/// The tag that `rest`, a page behind a `<` at `start`, begins with, and how much of it that is.
fn tag(rest: &str, start: usize) -> (Tag<'_>, usize) {
    let end = rest.find(|c: char| c.is_ascii_whitespace() || "/>".contains(c)).unwrap_or(rest.len());
    let name = &rest[..end];
    let mut attributes = Vec::new();
    let mut left = &rest[end..];
    loop {
        left = left.trim_start_matches(|c: char| c.is_ascii_whitespace() || c == '/');
        if left.is_empty() || left.starts_with('>') {
            break;
        }
        let (attribute, behind) = attribute(left);
        attributes.push(attribute);
        left = behind;
    }
    left = left.strip_prefix('>').unwrap_or(left);
    let mut text = "";
    if ["style", "script"].iter().any(|raw| name.eq_ignore_ascii_case(raw)) {
        text = left.find("</").map_or(left, |_| &left[..closing(left, name)]);
        left = &left[text.len()..];
    }
    (Tag { name, attributes, start, text }, rest.len() - left.len())
}

/// Where `</name` stands in `text`; its end if it does not.
fn closing(text: &str, name: &str) -> usize {
    let closes = |(at, _): &(usize, &str)| {
        text[at + 2..].get(..name.len()).is_some_and(|found| found.eq_ignore_ascii_case(name))
    };
    text.match_indices("</").find(closes).map_or(text.len(), |(at, _)| at)
}

/// The attribute that `text` begins with, and what stands behind it.
fn attribute(text: &str) -> ((&str, &str), &str) {
    // A sign that can begin no name is taken as one, so that something is taken.
    let first = text.chars().next().map_or(0, char::len_utf8);
    let end = text[first..].find(|c: char| c.is_ascii_whitespace() || "=/>".contains(c));
    let (name, rest) = text.split_at(end.map_or(text.len(), |end| first + end));
    let Some(rest) = rest.trim_ascii_start().strip_prefix('=').map(str::trim_ascii_start) else {
        return ((name, ""), rest);
    };
    for quote in ['"', '\''] {
        if let Some(rest) = rest.strip_prefix(quote) {
            let (value, behind) = rest.split_once(quote).unwrap_or((rest, ""));
            return ((name, value), behind);
        }
    }
    let (value, behind) = rest.split_at(rest.find(|c: char| c.is_ascii_whitespace() || c == '>').unwrap_or(rest.len()));
    ((name, value), behind)
}

#[cfg(test)]
mod tests {
    use super::tags;

    #[test]
    fn attributes_are_read_however_they_are_quoted() {
        let page = "<!doctype html><!-- <a id=no> --><p id=\"x\" title='a > \"b\"' hidden>1 < 2 <br/><a href=c.html#d>c</a><img src = 'e'/>";
        let found: Vec<(&str, Vec<(&str, &str)>)> = tags(page).map(|tag| (tag.name, tag.attributes)).collect();
        let expected = [
            ("p", vec![("id", "x"), ("title", "a > \"b\""), ("hidden", "")]),
            ("br", vec![]),
            ("a", vec![("href", "c.html#d")]),
            ("img", vec![("src", "e")]),
        ];
        assert_eq!(found, expected);
        assert_eq!(&page[tags(page).last().unwrap().start..][..4], "<img");
    }

    #[test]
    fn styles_and_scripts_are_text() {
        let page = "<style>a > b { c: url(d) }</style><script>if (a </b/) '<i id=no>'</script><p>";
        let found: Vec<(&str, &str)> = tags(page).map(|tag| (tag.name, tag.text)).collect();
        assert_eq!(found, [("style", "a > b { c: url(d) }"), ("script", "if (a </b/) '<i id=no>'"), ("p", "")]);
    }

    #[test]
    fn a_cut_page_ends() {
        let page = "<!-- ä --><p id=\"ü\" a='b' c=d ><style>x</style><script src=e>ö</script><a =\"\" / = >";
        for (at, _) in page.char_indices() {
            assert!(tags(&page[..at]).count() < 10);
            assert!(tags(&page[at..]).count() < 10);
        }
    }
}
