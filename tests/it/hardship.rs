//! A machine that gives no room, no right or no end: it is told, nothing is lost, and a preview goes on.

use std::fs;
use std::io::Read;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::os::unix::process::CommandExt;
use std::process::{Command, Stdio};

use crate::course::{Course, Said, small};
use crate::preview::{Served, replace};

const CHAPTER: &str = "chapters/01-one.md";
const PAGE: &str = "/one.html";
/// A user who may do nothing in particular.
const NOBODY: u32 = 65534;

/// The program with `arguments` where no file can be written, as on a disk without room.
fn without_room(course: &Course, arguments: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", "trap '' XFSZ; ulimit -f 0; exec \"$0\" \"$@\"", env!("CARGO_BIN_EXE_workbook")]);
    command.args(arguments).current_dir(course.root());
    command
}

/// The program with `arguments` for somebody who is not the system's administrator, as whom the tests may run.
fn without_rights(course: &Course, arguments: &[&str]) -> Command {
    if fs::metadata("/proc/self").map_or(1, |me| me.uid()) != 0 {
        return course.command(arguments);
    }
    for path in ["", "chapters"] {
        fs::set_permissions(course.path(path), fs::Permissions::from_mode(0o777)).unwrap();
    }
    let program = course.path("program");
    if !program.exists() {
        fs::copy(env!("CARGO_BIN_EXE_workbook"), &program).unwrap();
    }
    let mut command = Command::new(program);
    command.args(arguments).current_dir(course.root()).uid(NOBODY).gid(NOBODY);
    command
}

#[test]
fn a_disk_without_room_keeps_the_last_book_and_the_preview_goes_on() {
    let course = small();
    course.fine(&["build", "--quiet"]);
    let book = course.book();
    course.edit(CHAPTER, "Some prose.", "Other words.");
    let said = Said::from(without_room(&course, &["build", "--no-cache"]).output().unwrap());
    assert_eq!(said.exit, 3, "{}", said.err);
    assert!(said.err.contains("error[W0009]") && said.err.contains("check the disk's space"), "{}", said.err);
    assert!(course.book() == book, "the last good book is there");
    course.fine(&["clean", "--quiet"]);
    let mut command = without_room(&course, &["serve", "--port", "0"]);
    command.stderr(Stdio::piped());
    let mut served = Served::of(command);
    let mut events = served.events();
    let before = events.settled();
    let page = served.get(PAGE);
    assert!(page.contains("Other words.") && page.contains("<svg"));
    replace(&course, CHAPTER, &course.read(CHAPTER).replace("Other words.", "Third words."));
    events.after(before);
    assert!(served.get(PAGE).contains("Third words."));
    served.child.kill().unwrap();
    let mut told = String::new();
    served.child.stderr.take().unwrap().read_to_string(&mut told).unwrap();
    assert!(told.contains("could not be kept"), "{told}");
}

#[test]
fn a_file_that_cannot_be_read_is_told_and_the_preview_goes_on() {
    let course = small();
    let served = {
        let mut command = without_rights(&course, &["serve", "--quiet", "--port", "0"]);
        command.stderr(Stdio::null());
        Served::of(command)
    };
    let mut events = served.events();
    events.settled();
    fs::set_permissions(course.path(CHAPTER), fs::Permissions::from_mode(0o000)).unwrap();
    let mistakes = events.mistakes();
    assert_eq!(mistakes[0]["code"], "W0003");
    let message = mistakes[0]["message"].as_str().unwrap();
    assert!(message.contains(CHAPTER) && message.contains("cannot be read"), "{message}");
    assert!(served.get(PAGE).contains("Some prose."), "the last good page is there");
    fs::set_permissions(course.path(CHAPTER), fs::Permissions::from_mode(0o644)).unwrap();
    events.mended();
    let said = Said::from(without_rights(&course, &["serve", "--port", "1"]).output().unwrap());
    let lowest = fs::read_to_string("/proc/sys/net/ipv4/ip_unprivileged_port_start").unwrap_or_default();
    if lowest.trim().parse::<u16>().is_ok_and(|lowest| lowest > 1) {
        assert_eq!(said.exit, 3, "{}", said.err);
        assert!(said.err.contains("W0013") && said.err.contains("ports below 1024 are for the system"), "{}", said.err);
    }
}

#[test]
fn what_is_no_file_is_told_instead_of_waited_for() {
    let course = small();
    assert!(Command::new("mkfifo").arg(course.path("chapters/02-two.md")).status().unwrap().success());
    let said = course.say(&["check"]);
    assert!(said.exit != 0 && said.err.contains("`chapters/02-two.md` cannot be read"), "{}", said.err);
}

#[test]
fn links_that_lead_nowhere_out_or_in_circles_are_left_out_and_told() {
    let course = small();
    symlink("/etc/hostname", course.path("chapters/out.txt")).unwrap();
    symlink("nothing", course.path("chapters/02-two.md")).unwrap();
    symlink("circle", course.path("chapters/circle")).unwrap();
    symlink("..", course.path("chapters/above")).unwrap();
    course.write("chapters/data/good.csv", "1\n");
    symlink("data/good.csv", course.path("chapters/good.csv")).unwrap();
    let said = course.fine(&["build"]);
    for link in ["out.txt", "02-two.md", "circle", "above"] {
        assert!(said.err.contains(&format!("`chapters/{link}` is left out")), "{link}: {}", said.err);
    }
    assert_eq!(said.err.matches("is left out").count(), 4, "{}", said.err);
    assert!(course.book().contains_key("good.csv"));
}
