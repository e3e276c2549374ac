//! Words as a part of an address: lower-case letters and digits, joined by hyphens.

/// The slug of pieces of text; empty if there is no letter and no digit in them.
pub(super) fn slug<'a>(pieces: impl IntoIterator<Item = &'a str>) -> String {
    let mut slug = String::new();
    for c in pieces.into_iter().flat_map(str::chars) {
        if c.is_alphanumeric() {
            slug.extend(c.to_lowercase());
        } else if !slug.ends_with('-') && !slug.is_empty() {
            slug.push('-');
        }
    }
    slug.truncate(slug.trim_end_matches('-').len());
    slug
}

#[cfg(test)]
mod tests {
    use super::slug;

    #[test]
    fn letters_and_digits_are_joined_by_single_hyphens() {
        assert_eq!(slug(["Sobol’ ", "sequence"]), "sobol-sequence");
        assert_eq!(slug(["(t,m,d)", "-net: "]), "t-m-d-net");
        assert_eq!(slug(["Énumération"]), "énumération");
        assert_eq!(slug(["— "]), "");
    }
}
