//! The preview: a course is served, follows its files, tells its mistakes, and answers nobody else.

use std::fs;
use std::net::{TcpListener, TcpStream};
use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::course::{Course, small};
use crate::preview::{PATIENCE, Served, edition, replace};

const CHAPTER: &str = "chapters/01-one.md";
const PAGE: &str = "/one.html";

#[test]
fn a_page_follows_its_file() {
    let course = small();
    let served = Served::new(&course);
    let (mut one, mut other) = (served.events(), served.events());
    let before = one.settled();
    other.settled();
    let page = served.get(PAGE);
    assert!(page.contains("Some prose.") && page.contains("/live.js") && page.contains("id=\"fig-points\""));
    assert!(served.get("/").contains("one.html"));
    replace(&course, CHAPTER, &course.read(CHAPTER).replace("Some prose.", "Other words."));
    // Two pages that are open are both told.
    assert!(one.after(before) > before && other.after(before) > before);
    assert!(served.get(PAGE).contains("Other words."));
    // Only the paragraph is sent again: the figure and the table are where they were.
    let parts = served.patch("one.html", &page);
    let new: Vec<&str> = parts.iter().filter_map(Value::as_str).collect();
    assert_eq!(new, ["<p>Other words.</p>\n"], "{parts:?}");
    assert!(parts.len() > 3);
}

#[test]
fn every_file_of_the_book_is_there_and_the_book_has_none_of_the_preview() {
    let course = Course::case("everything");
    course.fine(&["build", "--quiet"]);
    let served = Served::new(&course);
    served.events().settled();
    let book = course.book();
    assert!(book.len() > 40);
    for (path, bytes) in &book {
        let text = String::from_utf8_lossy(bytes);
        assert!(!text.contains("live.js") && !text.contains("<!--block-->"), "{path}");
        if ["sitemap.xml", "assets/card.png"].contains(&path.as_str()) || path.starts_with("assets/previews/") {
            continue;
        }
        let answer = served.get(&format!("/{path}"));
        if let Some(start) = answer.find(".workbook/live.css") {
            // A page is the book's, but for what follows it and tells its blocks apart.
            let start = answer[..start].rfind("<link").unwrap();
            let end = start + answer[start..].find("</script>").unwrap() + "</script>".len();
            let plain = format!("{}{}", &answer[..start], &answer[end..]).replace("<!--block-->", "");
            assert!(plain == text, "{path}");
        } else {
            assert!(answer == text, "{path}");
        }
    }
    // Cards of previews are there for whatever a page can be referred to by.
    for path in book.keys().filter(|path| path.starts_with("assets/previews/")) {
        let (_, targets) =
            served.get(&format!("/{path}")).split_once(", {").map(|(a, b)| (a.to_owned(), b.to_owned())).unwrap();
        let wanted: Value = {
            let text = String::from_utf8_lossy(&book[path]).into_owned();
            serde_json::from_str(&text[text.find(", {").unwrap() + 2..text.rfind(')').unwrap()]).unwrap()
        };
        for (id, html) in wanted.as_object().unwrap() {
            let entry = format!("{}:{}", serde_json::json!(id), html);
            assert!(format!("{{{targets}").contains(&entry), "{path}: {id}");
        }
    }
}

#[test]
fn a_mistake_is_told_with_its_place_and_the_last_good_page_stays() {
    let course = small();
    let served = Served::with(&course, &["--port", "0", "--editor", "edit:{path}?{line},{column}"]);
    let mut events = served.events();
    events.settled();
    let right = course.read(CHAPTER);
    replace(
        &course,
        CHAPTER,
        &right.replace("\"jittered\"\nn", "\"jitered\"\nn").replace("Some prose.", "Other words."),
    );
    let mistakes = events.mistakes();
    assert_eq!(mistakes.len(), 1);
    let mistake = &mistakes[0];
    assert_eq!(
        (mistake["code"].as_str(), mistake["place"]["text"].as_str()),
        (Some("W0106"), Some("chapters/01-one.md:11:11"))
    );
    let text = mistake["text"].as_str().unwrap();
    assert!(
        text.contains("error[W0106]")
            && text.contains("sampler = \"jitered\"")
            && text.contains("did you mean `jittered`?"),
        "{text}"
    );
    let link = mistake["place"]["link"].as_str().unwrap();
    assert!(link.starts_with("edit:/") && link.ends_with("/chapters/01-one.md?11,11"), "{link}");
    assert!(served.get(PAGE).contains("Some prose."));
    assert!(served.get("/exhibits.html").contains("fig-points"));
    replace(&course, CHAPTER, &right.replace("Some prose.", "Mended."));
    events.mended();
    assert!(served.get(PAGE).contains("Mended."));
}

#[test]
fn a_false_claim_is_told_and_the_page_shows_it() {
    let course = small();
    let served = Served::new(&course);
    let mut events = served.events();
    events.settled();
    course.edit(CHAPTER, "equals = 1", "equals = 2");
    assert_eq!(events.mistakes()[0]["code"], "W0202");
    assert!(served.get(PAGE).contains("claimed: = 2") || served.get(PAGE).contains("2)"));
    course.edit(CHAPTER, "equals = 2", "equals = 1");
    events.mended();
}

#[test]
fn a_course_that_is_wrong_from_the_start_is_served_when_it_is_mended() {
    let course = small();
    let right = course.read(CHAPTER);
    course.write(CHAPTER, b"\xff\xfe not text");
    let served = Served::new(&course);
    let mut events = served.events();
    assert_eq!(events.mistakes()[0]["code"], "W0002");
    assert!(served.get("/").contains("live-blank"));
    course.write(CHAPTER, right);
    events.mended();
    assert!(served.get(PAGE).contains("Some prose."));
}

#[test]
fn prose_does_not_wait_for_experiments() {
    let course = small();
    let slow = "```experiment\nid = \"fig-slow\"\nkind = \"convergence\"\nintegrand = \"exp(sin(3*x^2))\"\nsamplers = [\"independent\"]\nn = [65536, 131072]\nreplicates = 400\ncaption = \"Slow.\"\n```\n";
    course.write(CHAPTER, course.read(CHAPTER) + "\n" + slow);
    let served = Served::new(&course);
    let mut events = served.events();
    let waiting = |told: &Value| told["news"]["stale"] == serde_json::json!(["fig-slow"]);
    events.until(waiting);
    let page = served.get(PAGE);
    assert!(
        page.contains("Some prose.") && page.contains("id=\"fig-slow\"") && page.contains("This is being computed.")
    );
    // While it runs, words change; and what is asked for changes too, so that the first need not be had.
    let before = edition(&events.last);
    replace(
        &course,
        CHAPTER,
        &course.read(CHAPTER).replace("Some prose.", "Other words.").replace("replicates = 400", "replicates = 4"),
    );
    let mut before = before;
    while !served.get(PAGE).contains("Other words.") {
        before = events.after(before);
    }
    events.settled();
    let page = served.get(PAGE);
    assert!(!page.contains("This is being computed.") && page.contains("<svg"));
    // What is computed anew is shown as it was until then.
    let before = edition(&events.last);
    replace(
        &course,
        CHAPTER,
        &course.read(CHAPTER).replace("n = [65536, 131072]\nreplicates = 4", "n = [65536, 131072]\nreplicates = 401"),
    );
    let told = events.until(|told| edition(told) > before);
    if waiting(&told) {
        assert!(!served.get(PAGE).contains("This is being computed."));
    }
}

#[test]
fn a_burst_of_changes_is_taken_as_one() {
    let course = small();
    let served = Served::new(&course);
    let mut events = served.events();
    let before = events.settled();
    let text = course.read(CHAPTER);
    for count in 0..1000 {
        course.write(&format!("chapters/data/{}.csv", count % 50), format!("{count}\n"));
        if count % 10 == 0 {
            replace(&course, CHAPTER, &text.replace("Some prose.", &format!("Change {count}.")));
        }
    }
    replace(&course, CHAPTER, &text.replace("Some prose.", "The last change."));
    let mut last = before;
    while !served.get(PAGE).contains("The last change.") {
        last = events.after(last);
    }
    assert!(last - before < 200, "{} editions of a thousand changes", last - before);
    assert_eq!(served.get("/data/49.csv"), "999\n");
}

#[test]
fn what_is_deleted_or_moved_away_is_told_and_may_come_back() {
    let course = small();
    course.write("chapters/02-two.md", "+++\ntitle = \"Two\"\nsummary = \"The second.\"\n+++\n\nText of two.\n");
    let served = Served::with(&course, &["--port", "0", "--root", course.root().to_str().unwrap()]);
    let mut events = served.events();
    let before = events.settled();
    fs::remove_file(course.path("chapters/02-two.md")).unwrap();
    let before = events.after(before);
    assert_eq!(served.status("/two.html"), 404);
    assert!(!served.get(PAGE).contains("two.html"));
    // The folder of chapters goes away, and another comes in its place; it is watched like the first.
    fs::rename(course.path("chapters"), course.path("aside")).unwrap();
    assert_eq!(events.mistakes()[0]["code"], "W0001");
    assert!(served.get(PAGE).contains("Some prose."), "the last good page is there");
    fs::rename(course.path("aside"), course.path("chapters")).unwrap();
    let back = events.mended();
    assert!(back >= before);
    course.edit(CHAPTER, "Some prose.", "After the move.");
    while !served.get(PAGE).contains("After the move.") {
        events.next();
    }
    // The same of the whole course.
    let (here, there) = (course.root().to_path_buf(), course.root().with_extension("away"));
    fs::rename(&here, &there).unwrap();
    events.mistakes();
    fs::rename(&there, &here).unwrap();
    events.mended();
    course.edit(CHAPTER, "After the move.", "After both.");
    while !served.get(PAGE).contains("After both.") {
        events.next();
    }
}

#[test]
fn its_own_output_changes_nothing() {
    let course = small();
    let served = Served::new(&course);
    let mut events = served.events();
    let before = events.settled();
    course.fine(&["build", "--quiet"]);
    course.fine(&["accept", "--quiet"]);
    course.write("chapters/.01-one.md.swp", "what an editor keeps");
    replace(&course, CHAPTER, &course.read(CHAPTER));
    replace(&course, CHAPTER, &course.read(CHAPTER).replace("Some prose.", "Other words."));
    assert_eq!(events.after(before), before + 1, "a change of the course is the only one");
}

#[test]
fn templates_and_styles_are_followed() {
    let course = small();
    let served = Served::new(&course);
    let mut events = served.events();
    let before = events.settled();
    let looks = |page: &str| page.split("data-assets=\"").nth(1).unwrap().split('"').next().unwrap().to_owned();
    let first = looks(&served.get(PAGE));
    course.write("templates/assets/text.css", "p { color: red }");
    let before = events.after(before);
    assert!(served.get("/assets/style.css").contains("p { color: red }"));
    assert_ne!(looks(&served.get(PAGE)), first, "pages know that they have to load it again");
    course.write("templates/404.html", "{% extends");
    assert_eq!(events.mistakes()[0]["code"], "W0008");
    fs::remove_file(course.path("templates/404.html")).unwrap();
    assert!(events.mended() >= before);
}

#[test]
fn only_this_machine_and_its_own_pages_are_answered() {
    let course = small();
    let served = Served::new(&course);
    served.events().settled();
    let port = served.port();
    let with = |host: &str, lines: &str| {
        served.raw(&format!("GET {PAGE} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n{lines}\r\n")).0
    };
    assert_eq!(with(&format!("localhost:{port}"), ""), 200);
    for host in [format!("evil.example:{port}"), "127.0.0.1".to_owned(), String::new()] {
        assert_eq!(with(&host, ""), 403, "{host}");
    }
    for target in [PAGE, "/.workbook/events", "/.workbook/page?path=one.html", "/figures.json"] {
        assert_eq!(served.ask(target, "Origin: https://evil.example\r\n").0, 403, "{target}");
        assert_eq!(served.ask(target, "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\n").0, 403, "{target}");
    }
    let (_, head, _) = served.ask(PAGE, "");
    assert!(!head.to_lowercase().contains("access-control"), "{head}");
    assert!(head.contains("Content-Type: text/html; charset=utf-8"), "{head}");
    let kind = |target: &str| {
        served.ask(target, "").1.split("Content-Type: ").nth(1).unwrap().lines().next().unwrap().to_owned()
    };
    assert_eq!(kind("/"), "text/html; charset=utf-8");
    assert_eq!(kind("/none.html"), "text/html; charset=utf-8");
    assert_eq!(kind("/.workbook/live.js"), "text/javascript; charset=utf-8");
    assert_eq!(kind("/.workbook/page?path=one.html"), "application/json");
    assert_eq!(kind("/assets/style.css"), "text/css; charset=utf-8");
    assert!(head.contains("X-Frame-Options: DENY") && head.contains("Cross-Origin-Resource-Policy: same-origin"));
    for method in ["POST", "PUT", "DELETE", "OPTIONS", "TRACE"] {
        let (status, ..) =
            served.raw(&format!("{method} {PAGE} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", served.address));
        assert_eq!(status, 405, "{method}");
    }
    let head = served.raw(&format!("HEAD {PAGE} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", served.address));
    assert_eq!((head.0, head.2.as_str()), (200, ""));
    assert_eq!(served.raw("nonsense\r\n\r\n").0, 400);
    assert_eq!(served.raw(&format!("GET /{} HTTP/1.1\r\n", "a".repeat(40_000))).0, 431);
}

#[test]
fn paths_never_leave_the_book() {
    let course = small();
    course.write("secret.txt", "secret");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("/etc/hostname", course.path("chapters/link.txt")).unwrap();
        std::os::unix::fs::symlink("/etc", course.path("chapters/folder")).unwrap();
    }
    course.write("chapters/.hidden.txt", "hidden");
    course.write("chapters/plain.txt", "plain");
    let served = Served::new(&course);
    served.events().settled();
    assert_eq!(served.get("/plain.txt"), "plain");
    for path in [
        "/../secret.txt",
        "/..%2fsecret.txt",
        "/%2e%2e/secret.txt",
        "/exhibits/../../secret.txt",
        "/..\\secret.txt",
        "/%5c..%5csecret.txt",
        "/plain.txt%00.html",
        "//etc/hostname",
        "/etc/hostname",
        "/link.txt",
        "/folder/hostname",
        "/.hidden.txt",
        "/01-one.md",
        "/workbook.toml",
        "/.workbook/cache",
        "/.workbook/../plain.txt",
        "http://other.example/",
    ] {
        assert_eq!(served.status(path), 404, "{path}");
    }
}

#[test]
fn a_port_that_is_taken_is_told_and_the_usual_one_has_others_behind_it() {
    let course = small();
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port().to_string();
    let said = course.say(&["serve", "--port", &port]);
    assert_eq!((said.exit, said.out.as_str()), (3, ""));
    assert!(said.err.contains("W0013") && said.err.contains("leave `--port` out"), "{}", said.err);
    let (one, other) = (Served::with(&course, &[]), Served::with(&course, &[]));
    assert_ne!(one.port(), other.port());
    assert_eq!((one.status(PAGE), other.status(PAGE)), (200, 200));
    let said = Course::empty().say(&["serve", "--port", "0"]);
    assert_eq!((said.exit, said.out.as_str()), (2, ""), "where there is no course, nothing is served");
    assert!(said.err.contains("W0001"), "{}", said.err);
}

#[cfg(unix)]
#[test]
fn it_ends_when_it_is_told_to() {
    let course = small();
    let mut served = Served::new(&course);
    let mut events = served.events();
    events.settled();
    let killed = Command::new("kill").args(["-INT", &served.child.id().to_string()]).status().unwrap();
    assert!(killed.success());
    let begun = Instant::now();
    let exit = loop {
        if let Some(exit) = served.child.try_wait().unwrap() {
            break exit;
        }
        assert!(begun.elapsed() < PATIENCE);
        std::thread::sleep(Duration::from_millis(5));
    };
    assert_eq!(exit.code(), Some(0));
    assert!(TcpStream::connect(&served.address).is_err());
}

#[test]
fn students_are_served_their_book() {
    let course = small();
    let solution = "\n> [!EXERCISE]\n> Why?\n\n> [!SOLUTION]\n> Because of the secret.\n";
    course.write(CHAPTER, course.read(CHAPTER) + solution);
    let served = Served::with(&course, &["--port", "0", "--audience", "student"]);
    served.events().settled();
    let page = served.get(PAGE);
    assert!(page.contains("Why?") && !page.contains("Because of the secret."));
    assert!(!served.get("/assets/search-index.js").contains("secret"));
}
