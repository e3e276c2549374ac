//! Listings and plain fences: lines, emphasis, classes for the parts of code; and the colours that the style sheet gives them.

use std::fs;
use std::path::Path;

use workbook::compose::Composed;
use workbook::stats::portable;

use crate::course::{Course, PACKAGE, small};

const CONFIGURATION: &str = "title = \"A course\"\nauthors = [\"A. Author\"]\n";

fn chapter(body: &str) -> Composed {
    let text = format!("+++\ntitle = \"One\"\nsummary = \"The only chapter.\"\n+++\n\n{body}\n");
    Course::new(&[("chapters/workbook.toml", CONFIGURATION), ("chapters/01-one.md", &text)]).compose(1)
}

fn page(body: &str) -> String {
    let composed = chapter(body);
    assert!(composed.diagnostics.is_empty(), "{:?}", composed.diagnostics);
    String::from_utf8(composed.book.files["one.html"].clone()).unwrap()
}

#[test]
fn a_listing_has_numbered_lines_and_classes() {
    let html =
        page("```listing\nid = \"lst-find\"\nitem = \"catalogue::find\"\nemphasis = \"1\"\ncaption = \"How.\"\n```");
    let code = html.split("<pre").nth(1).unwrap().split("</pre>").next().unwrap();
    assert!(
        code.starts_with(" class=\"code numbered\" tabindex=\"0\"><code class=\"language-rust\"><mark class=\"line\">"),
        "{code}"
    );
    assert!(
        code.contains("<span class=\"k\">pub</span> <span class=\"k\">fn</span> <span class=\"f\">find</span>"),
        "{code}"
    );
    assert_eq!(code.matches("class=\"line").count(), code.matches('\n').count(), "a line each");
    assert!(!code.contains("style="), "classes, no colours");
    // The text is the very code: nothing is added for the eye.
    let item = workbook::sources::item("catalogue::find").unwrap().text;
    assert_eq!(text(code.split_once('>').unwrap().1), format!("{item}\n"));
}

/// What a reader copies: the text without tags.
fn text(html: &str) -> String {
    let text: String = html.split('<').map(|part| part.split_once('>').map_or(part, |(_, text)| text)).collect();
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

#[test]
fn plain_fences_have_the_same_form() {
    let html = page("```c {2}\nint a;\nreturn a & 1;\n```\n\n> ```unknown\n> let <x>\n> ```\n\n    indented");
    let first = "<pre class=\"code\" tabindex=\"0\"><code class=\"language-c\"><span class=\"line\"><span class=\"t\">int</span> a;\n</span>\
                 <mark class=\"line\"><span class=\"k\">return</span> a &amp; <span class=\"n\">1</span>;\n</mark></code></pre>";
    assert!(html.contains(first), "{html}");
    assert!(
        html.contains("<code class=\"language-unknown\"><span class=\"line\">let &lt;x&gt;\n</span></code>"),
        "{html}"
    );
    assert!(
        html.contains("<pre class=\"code\" tabindex=\"0\"><code><span class=\"line\">indented\n</span></code>"),
        "{html}"
    );
}

#[test]
fn lines_that_are_not_there_are_told_at_their_place() {
    let told = |body: &str| {
        let composed = chapter(body);
        let found: Vec<(String, String)> = composed
            .diagnostics
            .iter()
            .map(|told| {
                let place = told.place.clone().unwrap();
                let text = composed.workspace.text(&place.file).unwrap().text[place.range].to_owned();
                (text, told.message.clone())
            })
            .collect();
        found
    };
    let one = |text: &str, message: &str| vec![(text.to_owned(), message.to_owned())];
    let beyond = "line 3 is to stand out, and there are 2 lines";
    assert_eq!(told("```c {1,3}\nint a;\nint b;\n```"), one("{1,3}", beyond));
    assert_eq!(told("> ```c {x}\n> int a;\n> ```"), one("{x}", "`x` is no line of code"));
    let listing = |lines: &str| {
        told(&format!("```listing\nid = \"lst-a\"\nfile = \"a.c\"\nemphasis = \"{lines}\"\ncaption = \"How.\"\n```"))
    };
    assert!(
        listing("7-5").contains(&("\"7-5\"".to_owned(), "`7-5` is no line of code".to_owned())),
        "{:?}",
        listing("7-5")
    );
    let item = "```listing\nid = \"lst-a\"\nitem = \"catalogue::find\"\nemphasis = \"999\"\ncaption = \"How.\"\n```";
    let found = told(item);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].0 == "\"999\"" && found[0].1.starts_with("line 999 is to stand out, and there are "), "{found:?}");
}

/// The light and the dark colour of a custom property in a style sheet.
fn colours(css: &str, name: &str) -> [String; 2] {
    let value = css.split_once(&format!("{name}: light-dark(")).unwrap_or_else(|| panic!("no {name}")).1;
    let mut both = value.split(')').next().unwrap().split(',').map(|colour| colour.trim().to_owned());
    [both.next().unwrap(), both.next().unwrap()]
}

fn luminance(colour: &str) -> f64 {
    let channel = |at: usize| {
        let value = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
        if value <= 0.04045 { value / 12.92 } else { portable::pow((value + 0.055) / 1.055, 2.4) }
    };
    0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)
}

fn contrast(a: &str, b: &str) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[test]
fn code_can_be_read_in_both_themes() {
    let sheet = |name: &str| fs::read_to_string(Path::new(PACKAGE).join("templates/assets").join(name)).unwrap();
    let (style, listings) = (sheet("style.css"), sheet("listings.css"));
    let names = ["comment", "keyword", "type", "function", "text", "number", "attribute"];
    // Every colour that code is given is one of these.
    assert_eq!(listings.matches("color: var(--code-").count(), names.len());
    let mut lowest = f64::INFINITY;
    for theme in [0, 1] {
        let grounds = [colours(&style, "--panel"), colours(&style, "--page"), colours(&listings, "--code-mark")];
        let mut inks: Vec<(String, String)> =
            names.map(|name| (name.to_owned(), colours(&listings, &format!("--code-{name}"))[theme].clone())).to_vec();
        inks.push(("ink".to_owned(), colours(&style, "--ink")[theme].clone()));
        for (name, ink) in &inks {
            for ground in &grounds {
                let found = contrast(ink, &ground[theme]);
                lowest = lowest.min(found);
                assert!(found >= 4.5, "{name} {ink} on {}: {found:.2}", ground[theme]);
            }
        }
        // Numbers of lines stand on the ground of code, not of emphasised lines.
        for ground in &grounds[..2] {
            let found = contrast(&colours(&style, "--ink-soft")[theme], &ground[theme]);
            assert!(found >= 4.5, "numbers on {}: {found:.2}", ground[theme]);
        }
    }
    assert!(lowest < 21.0 && (contrast("#000000", "#ffffff") - 21.0).abs() < 1e-9);
}

#[test]
fn text_can_be_read_in_both_themes() {
    let style = fs::read_to_string(Path::new(PACKAGE).join("templates/assets/style.css")).unwrap();
    // With the least contrast of each; a line that tells something, such as the border of a button, needs less than text.
    let inks = [
        ("--ink", 7.0),
        ("--link", 7.0),
        ("--ink-soft", 4.5),
        ("--good", 4.5),
        ("--bad", 4.5),
        ("--caution", 4.5),
        ("--aside", 4.5),
        ("--rule-strong", 3.0),
    ];
    for theme in [0, 1] {
        for (ink, least) in inks {
            for ground in ["--page", "--panel"] {
                let found = contrast(&colours(&style, ink)[theme], &colours(&style, ground)[theme]);
                assert!(found >= least, "{ink} on {ground}, theme {theme}: {found:.2}");
            }
        }
    }
}

#[test]
fn what_stands_in_code_is_code() {
    let course = small();
    let written = "$a_1 @fig-points @fig-nowhere [@nobody] [^none] [x](define: \"y z\") [x](term:)";
    let prose = format!("```markdown\n{written}\n```\n\n    {written}\n\nAfter it @fig-points.");
    course.edit("chapters/01-one.md", "Some prose.", &prose);
    course.fine(&["build", "--quiet"]).silent();
    let page = course.read("book/one.html");
    assert_eq!(page.matches("@fig-nowhere").count(), 2, "in both blocks it stands as it was written");
    assert!(page.contains("After it <a"), "behind them references are read");
}
