//! Points and measures at the command line: what is written reads back, and what is wrong is told with its place.

use std::io::Write;
use std::process::Stdio;

use serde_json::Value;
use workbook::samplers::{Method, SAMPLERS};
use workbook::seed::Seed;

use crate::course::{Course, Said};

fn bits(method: &str, n: usize, d: usize, seed: u64) -> Vec<u64> {
    let points = Method::parse(method).unwrap().points(n, d, Seed::new(seed)).unwrap();
    points.coordinates().iter().map(|x| x.to_bits()).collect()
}

/// What the program says to `arguments` with `input` at its standard input.
fn piped(course: &Course, arguments: &[&str], input: &str) -> Said {
    let mut command = course.command(arguments);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
    Said::from(child.wait_with_output().unwrap())
}

/// Reads a NumPy file as its format's description says: magic, version, length, a header, and the array.
fn read_npy(bytes: &[u8]) -> ((usize, usize), Vec<f64>) {
    assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
    let length = usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
    assert_eq!((10 + length) % 64, 0, "the data are aligned");
    let header = std::str::from_utf8(&bytes[10..10 + length]).unwrap();
    assert!(header.is_ascii() && header.ends_with('\n') && header.starts_with('{'), "{header}");
    let field = |name: &str| header.split_once(&format!("'{name}': ")).unwrap().1;
    assert!(field("descr").starts_with("'<f8',") && field("fortran_order").starts_with("False,"), "{header}");
    let shape = field("shape").trim_start_matches('(').split_once(')').unwrap().0;
    let shape: Vec<usize> = shape.split(',').map(|side| side.trim().parse().unwrap()).collect();
    let data = bytes[10 + length..].chunks_exact(8).map(|word| f64::from_le_bytes(word.try_into().unwrap()));
    ((shape[0], shape[1]), data.collect())
}

#[test]
fn points_read_back_to_the_same_bits() {
    let course = Course::empty();
    for (method, n, d) in [("sobol+owen", 300, 5), ("kronecker", 64, 2), ("faure( base = 5 )", 25, 3), ("halton", 1, 1)]
    {
        let (count, dimensions) = (n.to_string(), d.to_string());
        let call = ["points", method, "-n", &count, "-d", &dimensions, "--seed", "7"];
        let expected = bits(method, n, d, 7);
        let csv = course.fine(&call).out;
        assert_eq!(csv.lines().count(), n);
        let read: Vec<u64> =
            csv.lines().flat_map(|line| line.split(',')).map(|cell| cell.parse::<f64>().unwrap().to_bits()).collect();
        assert_eq!(read, expected, "{method}");
        let json: Value = serde_json::from_str(&course.fine(&[&call[..], &["--format", "json"]].concat()).out).unwrap();
        let rows = json["points"].as_array().unwrap();
        assert!(rows.len() == n && rows.iter().all(|row| row.as_array().unwrap().len() == d));
        let read = rows.iter().flat_map(|row| row.as_array().unwrap()).map(|x| x.as_f64().unwrap().to_bits());
        assert_eq!(read.collect::<Vec<_>>(), expected, "{method}");
        assert_eq!((&json["n"], &json["seed"]), (&Value::from(n), &Value::from(7)));
        let npy = course.command(&[&call[..], &["--format", "npy"]].concat()).output().unwrap();
        let (shape, read) = read_npy(&npy.stdout);
        assert_eq!((shape, npy.status.code()), ((n, d), Some(0)));
        assert_eq!(read.iter().map(|x| x.to_bits()).collect::<Vec<_>>(), expected, "{method}");
    }
}

#[test]
fn exact_points_are_numerators_over_powers() {
    let course = Course::empty();
    let out = course.fine(&["points", "halton", "-n", "4", "-d", "2", "--exact"]).out;
    let rows: Vec<&str> = out.lines().collect();
    assert_eq!(rows[0], "# over 2^53,3^33");
    let third = 3_u64.pow(32);
    assert_eq!(rows[2], format!("{},{third}", 1_u64 << 52));
    assert_eq!(rows[4], format!("{},{}", 3_u64 << 51, third / 3));
    let out = course.fine(&["points", "faure", "-n", "7", "-d", "3", "--exact", "--format", "json"]).out;
    let json: Value = serde_json::from_str(&out).unwrap();
    let expected = Method::parse("faure").unwrap().points(7, 3, Seed::new(1)).unwrap();
    for (row, point) in json["numerators"].as_array().unwrap().iter().zip(expected.rows()) {
        for axis in 0..3 {
            let scale = json["scales"][axis].as_u64().unwrap();
            assert_eq!(scale, 3_u64.pow(33));
            assert_eq!(row[axis].as_u64().unwrap() as f64 / scale as f64, point[axis]);
        }
    }
    for (method, format, word) in [
        ("independent", "csv", "no digits of a base"),
        ("sobol+owen", "csv", "`owen` scrambles them"),
        ("sobol", "npy", "`npy` has no place"),
    ] {
        let said = course.say(&["points", method, "-n", "4", "-d", "2", "--exact", "--format", format]);
        assert!(said.exit == 2 && said.out.is_empty() && said.err.contains(word), "{method}: {}", said.err);
    }
}

#[test]
fn wrong_calls_for_points_name_the_argument_and_its_limits() {
    let course = Course::empty();
    let calls: [(&[&str], &str); 14] = [
        (&["sobl", "-n", "4", "-d", "2"], "did you mean `sobol`?"),
        (&["sobol+xr", "-n", "4", "-d", "2"], "there is no scramble `xr`"),
        (&["independent+xor", "-n", "4", "-d", "2"], "cannot be combined"),
        (&["faure(base=6)", "-n", "4", "-d", "2"], "the nearest are 5 and 7"),
        (&["sobol", "-n", "0", "-d", "2"], "n = 0 is not possible: it must be at least 1"),
        (&["sobol", "-n", "4", "-d", "0"], "d = 0 is not possible: d must be from 1 to 256"),
        (&["sobol", "-n", "4", "-d", "257"], "d = 257 is not possible: d must be from 1 to 256"),
        (&["jittered", "-n", "15", "-d", "2"], "the nearest are 9 and 16"),
        (&["sobol", "-n", "18446744073709551615", "-d", "2"], "n x d must be at most 1073741824"),
        (&["sobol", "-n", "99999999999999999999", "-d", "2"], "from 1 to 1073741824"),
        (&["sobol", "-n", "4", "-d", "2", "--seed", "18446744073709551616"], "from 0 to 18446744073709551615"),
        (&["sobol", "-n", "4", "-d", "2", "--seed=-1"], "from 0 to 18446744073709551615"),
        (&["sobol", "-n", "four", "-d", "2"], "whole number"),
        (&["sobol", "-n", "4", "-d", "2", "--format", "github"], "csv, json, npy"),
    ];
    for (call, words) in calls {
        let said = course.say(&[&["points"], call].concat());
        assert!(said.exit == 2 && said.out.is_empty(), "{call:?}: {}{}", said.out, said.err);
        assert!(said.err.contains(words), "{call:?}: {}", said.err);
    }
}

#[test]
fn a_reader_that_goes_away_is_no_mistake() {
    let course = Course::empty();
    let mut command = course.command(&["points", "sobol", "-n", "200000", "-d", "2"]);
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
}

#[test]
fn measures_of_files_and_of_pipes() {
    let course = Course::empty();
    let hammersley = course.fine(&["points", "hammersley", "-n", "16", "-d", "2"]).out;
    course.write("points.csv", &hammersley);
    let exact = 11.0 / 64.0;
    let close = |text: &str| (text.trim().parse::<f64>().unwrap() - exact).abs() < 1e-15;
    let said = course.fine(&["measure", "star-discrepancy", "points.csv"]);
    assert!(close(&said.out) && said.err.is_empty(), "{}", said.out);
    assert!(close(&piped(&course, &["measure", "star-discrepancy", "-"], &hammersley).out));
    for json in [&["--json"][..], &["--format", "json"]] {
        let said = course.fine(&[&["measure", "star-discrepancy", "points.csv"][..], json].concat());
        let whole: Value = serde_json::from_str(&said.out).unwrap();
        assert!((whole["value"].as_f64().unwrap() - exact).abs() < 1e-15);
        assert_eq!((&whole["exact"], &whole["n"], &whole["d"]), (&true.into(), &16.into(), &2.into()));
        assert_eq!(whole["bounds"]["upper"], whole["value"]);
        assert!(whole["extremal"].as_array().unwrap().len() == 2 && whole["seconds"].as_f64().unwrap() >= 0.0);
    }
    // Blank lines, line ends of another system, blanks, exponents and the upper border are as good.
    let said = piped(&course, &["measure", "minimum-distance", "-"], "\u{feff}0.25, 2.5e-1\r\n\r\n1 , 0.25\r\n");
    assert_eq!((said.exit, said.out.as_str()), (0, "0.25\n"), "{}", said.err);
    let whole: Value =
        serde_json::from_str(&piped(&course, &["measure", "t-value", "--json", "-"], "0,0\n0.5,0.5\n").out).unwrap();
    assert_eq!((&whole["value"], &whole["extremal"]), (&Value::from(0.0), &Value::Null));
}

#[test]
fn wrong_files_are_told_with_line_and_column() {
    let course = Course::empty();
    let files: [(&str, &str, &[&str]); 9] = [
        ("0.5,0.5\n0.25,x\n", "2:6", &["`x` is not a number"]),
        ("0.5,0.5\n0.25,  NaN\n", "2:8", &["the coordinate NaN is not a number from 0 to 1"]),
        ("0.5,1.5\n", "1:5", &["1.5"]),
        ("-0.1\n", "1:1", &["-0.1"]),
        ("0.5,inf\n", "1:5", &["inf"]),
        ("0.5,0.5\n0.5\n", "2:1", &["1 coordinate here, and 2 coordinates in the first line"]),
        ("0.5,\n", "1:5", &["`` is not a number"]),
        ("x,y\n0.5,0.5\n", "1:1", &["there is no header", "1:3"]),
        (" \n\n", "1:1", &["there is no point"]),
    ];
    for (text, place, words) in files {
        course.write("p.csv", text);
        let said = course.say(&["measure", "star-discrepancy", "p.csv"]);
        assert_eq!((said.exit, said.out.as_str()), (1, ""), "{text:?}: {}", said.err);
        for word in words.iter().chain([&format!("p.csv:{place}").as_str()]) {
            assert!(said.err.contains(word), "{text:?}: {word} is not in {}", said.err);
        }
    }
    let many = "0.5\n".to_owned() + &"x\n".repeat(1000);
    assert_eq!(piped(&course, &["measure", "t-value", "-"], &many).err.matches("error[W0205]").count(), 10);
    let said = piped(&course, &["measure", "t-value", "-"], "0.1\n0.2\n0.3\n");
    assert!(said.exit == 1 && said.err.contains("the quality t needs n = 2^m points"), "{}", said.err);
    let bytes = course.path("bytes.csv");
    std::fs::write(&bytes, b"0.5\n0.\xff\n").unwrap();
    let said = course.say(&["measure", "t-value", "bytes.csv"]);
    assert!(said.exit == 1 && said.err.contains("bytes.csv:2:3: the file is not UTF-8"), "{}", said.err);
    let calls =
        [(["t-vale", "bytes.csv"], 2, "did you mean `t-value`?"), (["t-value", "nowhere.csv"], 2, "there is no file")];
    for (call, exit, words) in calls {
        let said = course.say(&[&["measure"][..], &call].concat());
        assert!(said.exit == exit && said.err.contains(words), "{call:?}: {}", said.err);
    }
    assert_eq!(course.say(&["measure", "t-value", "."]).exit, 3, "a folder cannot be read");
}

#[test]
fn lists_tell_guarantees_settings_papers_and_limits() {
    let course = Course::empty();
    let list: Value = serde_json::from_str(&course.fine(&["list", "samplers", "--json"]).out).unwrap();
    let list = list.as_array().unwrap();
    assert_eq!(list.len(), SAMPLERS.len());
    for (told, sampler) in list.iter().zip(SAMPLERS) {
        let key = sampler.about().key;
        assert_eq!(told["key"], key);
        assert_eq!(told["guarantees"].as_array().unwrap().len(), sampler.guarantees().len(), "{key}");
        assert_eq!(told["settings"].as_array().unwrap().len(), sampler.settings().len(), "{key}");
        assert!(!told["papers"].as_array().unwrap().is_empty(), "{key}");
        let limits = told["limits"].as_str().unwrap();
        assert!(limits.len() > 10 && !limits.contains("**") && limits.ends_with('.'), "{key}: {limits}");
    }
    let faure = list.iter().find(|told| told["key"] == "faure").unwrap();
    assert_eq!((&faure["settings"][0]["name"], &faure["settings"][0]["most"]), (&"base".into(), &257.into()));
    let told = course.fine(&["list", "samplers", "faure"]).out;
    assert!(told.contains("setting base") && told.contains("a prime from 2 to 257"), "{told}");
    assert!(course.fine(&["list", "metrics"]).out.lines().any(|line| line.starts_with("star-discrepancy ")));
    assert_eq!(course.say(&["list", "samplers", "faur"]).exit, 2);
    assert_eq!(course.say(&["list", "metrics", "t-value"]).exit, 2);
}
