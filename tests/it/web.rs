//! What the web expects: addresses, a map, signs where pages have moved, a page for what is not there; and what git tells.

use std::process::Command;

use workbook::workspace::extension;

use crate::course::{Course, small};

/// The pages of a book whose names end in `.html`, with their texts.
fn pages(course: &Course) -> Vec<(String, String)> {
    let book = course.book().into_iter().filter(|(path, _)| extension(path) == Some("html"));
    book.map(|(path, bytes)| (path, String::from_utf8(bytes).unwrap())).collect()
}

#[test]
fn a_site_with_an_address_has_canonical_links_a_map_and_a_card() {
    let course = Course::case("site");
    course.fine(&["build", "--quiet"]).silent();
    let base = "https://example.org/courses/sampling/";
    let map = course.read("book/sitemap.xml");
    let mut listed = 0;
    for (path, text) in pages(&course) {
        let address = if path == "index.html" { base.to_owned() } else { format!("{base}{path}") };
        let entry = map.matches(&format!("<loc>{address}</loc>")).count();
        let canonical = format!("<link rel=\"canonical\" href=\"{address}\">");
        if ["404.html", "first.html", "parts/old/two.html"].contains(&path.as_str()) {
            assert!(entry == 0 && !text.contains(&canonical), "{path}");
            continue;
        }
        listed += 1;
        assert!(entry == 1 && text.contains(&canonical), "{path}");
        assert!(text.contains(&format!("<meta property=\"og:url\" content=\"{address}\">")), "{path}");
        assert!(text.contains(&format!("<meta property=\"og:image\" content=\"{base}assets/card.png\">")), "{path}");
    }
    assert_eq!((listed, map.matches("<url>").count()), (6, 6));
    assert!(course.book()["assets/card.png"].starts_with(b"\x89PNG"));
    assert!(!map.contains("lastmod"), "no day stands on a page unless it is asked for");
}

#[test]
fn a_site_without_an_address_names_none() {
    let course = small();
    course.fine(&["build", "--quiet"]);
    let book = course.book();
    assert!(!book.contains_key("sitemap.xml") && !book.contains_key("assets/card.png"));
    for (path, text) in pages(&course) {
        for absent in
            ["rel=\"canonical\"", "og:url", "og:image", "Edit this page", "Last changed", "Source of the book"]
        {
            assert!(!text.contains(absent), "{path}: {absent}");
        }
        let lost = path == "404.html";
        assert!(text.contains("assets/favicon.svg"), "{path}");
        for described in ["<meta property=\"og:title\"", "<meta property=\"og:type\""] {
            assert_eq!(text.contains(described), !lost, "{path}");
        }
        assert_eq!(text.contains("<meta name=\"robots\" content=\"noindex\">"), lost, "{path}");
    }
    // From a folder, all links of all pages are relative.
    assert!(book["404.html"].windows(19).any(|text| text == b"href=\"one.html\"><sp"));
}

#[test]
fn a_page_that_has_moved_leads_to_its_new_place() {
    let course = Course::case("site");
    course.fine(&["build", "--quiet"]);
    let first = course.read("book/first.html");
    for part in ["content=\"0; url=one.html#sec-points\"", "<a href=\"one.html#sec-points\">One &lt; two</a>"] {
        assert!(first.contains(part), "{first}");
    }
    assert!(first.contains("rel=\"canonical\" href=\"https://example.org/courses/sampling/one.html\""));
    assert!(
        course.read("book/parts/old/two.html").contains("<a href=\"../../index.html\">A site &amp; its address</a>")
    );
    course.edit("chapters/workbook.toml", "one.html#sec-points", "one.html#sec-none");
    let said = course.say(&["build", "--quiet"]);
    assert!(said.exit == 1 && said.err.contains("`one.html` has no such id"), "{}", said.err);
}

#[test]
fn a_lost_reader_is_led_back_from_any_depth() {
    let course = Course::case("site");
    course.fine(&["build", "--quiet"]);
    let page = course.read("book/404.html");
    for link in page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        let whole = ["/courses/sampling/", "#", "data:", "https://example.org/repository"];
        assert!(whole.iter().any(|start| link.starts_with(start)), "`{link}` is lost at another depth");
    }
    assert!(page.contains("src=\"/courses/sampling/assets/site.js\""));
    assert!(
        page.contains("href=\"/courses/sampling/one.html\"") && page.contains("href=\"/courses/sampling/index.html\"")
    );
}

#[test]
fn readers_find_the_source_of_text_and_code() {
    let course = Course::case("site");
    course.fine(&["build", "--quiet"]);
    let page = course.read("book/one.html");
    assert!(
        page.contains("<a href=\"https://example.org/repository/edit/main/chapters/01-one.md\">Edit this page</a>")
    );
    let code = "<a href=\"https://example.org/repository/blob/v1.0/src/samplers/independent.rs#L";
    assert!(page.contains(code), "{page}");
    assert!(!course.read("book/index.html").contains("Edit this page"), "only chapters have a file to edit");
    assert!(
        course.read("book/index.html").contains("<a href=\"https://example.org/repository\">Source of the book</a>")
    );
}

/// The course with its settings of the repository, so that git is asked.
fn asking() -> Course {
    let course = small();
    let settings = "[repository]\nsource_url = \"https://example.org/{commit}/{path}#L{line}\"\ncommit = \"git\"\nlast_change = true\n";
    course.write("chapters/workbook.toml", format!("{}{settings}", course.read("chapters/workbook.toml")));
    let listing = "\n```listing\nid = \"lst-fill\"\nitem = \"samplers::independent::fill\"\ncaption = \"Code.\"\n```\n";
    course.write("chapters/01-one.md", format!("{}{listing}", course.read("chapters/01-one.md")));
    course
}

#[test]
fn git_is_asked_and_may_be_absent() {
    let course = asking();
    let said = course.fine(&["build", "--quiet"]);
    assert_eq!(said.err.matches("warning[W0011]").count(), 2, "{}", said.err);
    assert!(!course.read("book/one.html").contains("Last changed"));
    let git = |arguments: &[&str]| {
        let output = Command::new("git")
            .current_dir(course.root())
            .args(["-c", "user.name=A", "-c", "user.email=a@example.org", "-c", "commit.gpgsign=false"])
            .args(arguments)
            .env("GIT_COMMITTER_DATE", "2020-02-03T04:05:06+00:00")
            .output()
            .unwrap();
        assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    git(&["init", "--quiet"]);
    git(&["add", "chapters"]);
    git(&["commit", "--quiet", "--message", "One"]);
    course.fine(&["build", "--quiet"]).silent();
    let page = course.read("book/one.html");
    assert!(page.contains("Last changed on <time datetime=\"2020-02-03\">2020-02-03</time>"), "{page}");
    let commit = git(&["rev-parse", "HEAD"]);
    assert!(page.contains(&format!("https://example.org/{}/src/samplers/independent.rs#L", commit.trim())));
}

#[test]
fn a_budget_is_kept_to_the_byte() {
    let course = small();
    course.fine(&["build", "--quiet"]);
    let total: usize = course.book().values().map(Vec::len).sum();
    let with = |budget: usize| {
        let settings = course.read("chapters/workbook.toml");
        let settings = settings.split("[budgets]").next().unwrap();
        course.write("chapters/workbook.toml", format!("{settings}[budgets]\nsite = {budget}\n"));
        course.say(&["build", "--quiet"])
    };
    assert_eq!(with(total / 1000 + 1).exit, 0);
    let said = with(total / 1000);
    assert!(
        said.exit == 1 && said.err.contains("W0304") && said.err.contains("its heaviest files are"),
        "{}",
        said.err
    );
}
