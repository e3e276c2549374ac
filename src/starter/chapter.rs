//! A chapter that is added to a course: its file, and its place in the order.

use super::{order, quoted};
use crate::diag::{Code, Diagnostic};
use crate::parse::{Course, OWN_PAGES};
use crate::plan::Plan;
use crate::workspace::{CHAPTERS, CONFIGURATION, Workspace, chapter_stem};

/// What adding a chapter writes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Addition {
    /// The chapter's file, from the course's root.
    pub path: String,
    /// Its text.
    pub text: String,
    /// The configuration with the chapter in its order, if it lists the chapters.
    pub configuration: Option<String>,
}

/// What adding a chapter with this title to a course writes, or why it cannot be added.
pub fn addition(title: &str, workspace: &Workspace, course: &Course, plan: &Plan) -> Result<Addition, Diagnostic> {
    let title = title.trim();
    let slug = slug(title);
    if slug.is_empty() {
        let error = Diagnostic::error(Code::BadId, format!("`{title}` gives a page no name"));
        return Err(error.help("a page is named by the letters a to z and the digits of its title"));
    }
    let taken =
        course.chapters.iter().find(|chapter| chapter.slug == slug).map(|chapter| format!("`{}`", chapter.file));
    let own = OWN_PAGES.contains(&slug.as_str()).then(|| "the book itself".to_owned());
    if let Some(other) = taken.or(own) {
        let message = format!("the page of this chapter would be `{slug}.html`, which is that of {other}");
        return Err(Diagnostic::error(Code::Exists, message).help("give the chapter another title"));
    }
    let stems = workspace.chapters().filter_map(|source| chapter_stem(&source.path));
    let numbers = stems.filter_map(|stem| stem.split('-').next()?.parse::<usize>().ok());
    let number = numbers.max().unwrap_or(0) + 1;
    let stem = format!("{number:02}-{slug}");
    let id = |prefix: &str| free(prefix, &slug, plan);
    let text = TEMPLATE
        .replace("%TITLE%", &quoted(title))
        .replace("%SECTION%", &id("sec"))
        .replace("%FIGURE%", &id("fig"))
        .replace("%EXERCISE%", &id("exr"));
    let configuration = workspace.text(CONFIGURATION).and_then(|source| order::with(&source.text, &stem));
    Ok(Addition { path: format!("{CHAPTERS}/{stem}.md"), text, configuration })
}

/// An id that nothing in the course has.
fn free(prefix: &str, slug: &str, plan: &Plan) -> String {
    let mut id = format!("{prefix}-{slug}");
    let mut count = 1;
    while plan.labels.target(&id).is_some() {
        count += 1;
        id = format!("{prefix}-{slug}-{count}");
    }
    id
}

/// The title as the name of a page: lower-case letters and digits, joined by hyphens.
fn slug(title: &str) -> String {
    let words = title.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let slug = words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("-");
    // A number at the start would be taken for the chapter's.
    slug.trim_start_matches(|c: char| c.is_ascii_digit() || c == '-').to_owned()
}

/// A chapter with the parts that most chapters have.
const TEMPLATE: &str = r#"+++
title = %TITLE%
summary = "What the chapter is about, in a sentence."
+++

> [!GOALS]
> After this chapter you can
>
> - do this;
> - and say why.

## A section {#%SECTION%}

What @%FIGURE% shows: the slope is `=%FIGURE%.slope.jittered:.2`, and no number here is typed.

```experiment
id = "%FIGURE%"
kind = "convergence"
integrand = "x*y"
samplers = ["independent", "jittered"]
n = [16, 64, 256, 1024]
caption = 'What to see in the figure.'

[claims]
"slope.independent" = { near = -0.5, within = 0.1 }
"slope.jittered" = { near = -1.0, within = 0.1 }
```

> [!EXERCISE] A question {#%EXERCISE%}
> Predict, then run `workbook run %FIGURE% -p integrand=disk`.
>
> > [!SOLUTION]
> > What is to be seen, and why.

> [!REMEMBER]
> - One sentence for each of the goals.
"#;

#[cfg(test)]
mod tests {
    use super::slug;

    #[test]
    fn titles_give_names_of_pages() {
        assert_eq!(slug("One point in each cell"), "one-point-in-each-cell");
        assert_eq!(slug("  Sobol’ & (t,m,d)-nets "), "sobol-t-m-d-nets");
        assert_eq!(slug("2024 — a year"), "a-year");
        assert_eq!(slug("积分"), "");
    }
}
