//! What an author starts from: the files of a small complete course, and a chapter that is added to a course.

mod chapter;
mod order;

pub use chapter::{Addition, addition};

/// The files of the small course.
mod embedded {
    include!(concat!(env!("OUT_DIR"), "/starter.rs"));
}

/// Files and folders whose names begin with a dot in the course, and have none here, where they would be hidden.
const HIDDEN: [&str; 2] = ["gitignore", "github"];

/// The title and the author that stand in the small course, as TOML.
const TITLE: &str = "title = \"A small course\"";
const AUTHORS: &str = "authors = [\"Your name\"]";

/// The files of a small complete course by their paths in its folder, sorted.
pub fn course(title: Option<&str>, author: Option<&str>) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<(String, Vec<u8>)> = embedded::STARTER
        .iter()
        .map(|&(path, bytes)| {
            let first = path.split('/').next().unwrap_or_default();
            let path = if HIDDEN.contains(&first) { format!(".{path}") } else { path.to_owned() };
            let bytes = match std::str::from_utf8(bytes) {
                Ok(text) => named(&path, text, title, author).into_bytes(),
                Err(_) => bytes.to_vec(),
            };
            (path, bytes)
        })
        .collect();
    files.sort();
    files
}

/// The text of a file with the course's own title and author.
fn named(path: &str, text: &str, title: Option<&str>, author: Option<&str>) -> String {
    let mut text = text.to_owned();
    if let Some(title) = title {
        text = match path {
            "README.md" => text.replacen("# A small course", &format!("# {title}"), 1),
            _ => text.replacen(TITLE, &format!("title = {}", quoted(title)), 1),
        };
    }
    match author {
        Some(author) => text.replacen(AUTHORS, &format!("authors = [{}]", quoted(author)), 1),
        None => text,
    }
}

/// A text as TOML writes it.
fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(files: &[(String, Vec<u8>)], path: &str) -> String {
        let found = files.iter().find(|(name, _)| name == path).unwrap();
        String::from_utf8(found.1.clone()).unwrap()
    }

    #[test]
    fn the_course_has_its_own_title_and_author() {
        let files = course(Some("Points & \"lines\""), Some("A. Author"));
        let configuration = text(&files, "chapters/workbook.toml");
        let read: toml::Table = configuration.parse().unwrap();
        assert_eq!(read["title"].as_str(), Some("Points & \"lines\""));
        assert_eq!(read["authors"][0].as_str(), Some("A. Author"));
        assert!(text(&files, "README.md").starts_with("# Points & \"lines\"\n"));
        let plain = course(None, None);
        assert!(text(&plain, "chapters/workbook.toml").contains(TITLE), "the title is what is replaced");
        assert!(text(&plain, "chapters/workbook.toml").contains(AUTHORS));
    }

    #[test]
    fn hidden_files_get_their_dots() {
        let files = course(None, None);
        for path in [".gitignore", ".github/workflows/book.yml", "README.md", "chapters/01-estimate.md"] {
            assert!(files.iter().any(|(name, _)| name == path), "{path}");
        }
    }
}
