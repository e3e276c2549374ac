//! Settings of samplers: one canonical form, every slip told where it is.

use workbook::samplers::{Method, Preset, SAMPLERS, UnknownMethod, Values};
use workbook::seed::Seed;

/// Samplers with settings, of each kind of setting; each is tried alone and with every scramble.
pub const TOLD: &[&str] = &[
    "radical-inverse(base=3)",
    "radical-inverse(base=4)",
    "radical-inverse(base=7)",
    "faure(base=2)",
    "faure(base=3)",
    "faure(base=5)",
    "faure(base=7)",
    "hammersley(base=3)",
    "hammersley(base=5)",
    "korobov(generator=7)",
    "uniform-jitter(rows=2)",
    "uniform-jitter(rows=9,columns=3)",
    "jittered(rows=4,columns=2)",
    "multi-jittered(columns=3)",
    "multi-jittered(rows=16,columns=2)",
    "correlated-multi-jittered(rows=5)",
    "correlated-multi-jittered(rows=4,columns=8)",
    "orthogonal-array-bush(strength=2)",
    "orthogonal-array-bush(strength=4)",
    "bridson(tries=60)",
    "best-candidate(candidates=3)",
];

/// What is set in a sampler is read back in one form, and every slip is told where it is.
#[test]
fn settings_have_one_form_and_slips_are_placed() {
    let name = |written: &str| Method::parse(written).expect(written).name();
    assert_eq!(name(" correlated-multi-jittered( columns=8 , rows = 04)"), TOLD[16]);
    assert_eq!(name("faure ( base = 5 ) + owen"), "faure(base=5)+owen");
    assert_eq!(name("bridson(tries=30)"), "bridson");
    assert_eq!(Method::parse("bridson(tries=30)"), Method::parse("bridson"));
    assert_eq!(Method::parse("faure(base=5)+xor").expect("known").title(), "Faure (base 5) with XOR");
    let slips = [
        ("faure(bsae=5)", "bsae", "`faure`: it has no setting `bsae`, only `base`"),
        ("halton(base=5)", "base", "`halton`: it has no setting `base`, nor any other"),
        (
            "faure(base=4)+owen",
            "4",
            "`faure`: `base` cannot be `4`: it must be a prime from 2 to 257; the nearest are 3 and 5",
        ),
        (
            "faure(base=1000)",
            "1000",
            "`faure`: `base` cannot be `1000`: it must be a prime from 2 to 257; the nearest is 257",
        ),
        (
            "bridson(tries=0)",
            "0",
            "`bridson`: `tries` cannot be `0`: it must be a whole number from 10 to 1000; the nearest is 10",
        ),
        (
            "bridson(tries=many)",
            "many",
            "`bridson`: `tries` cannot be `many`: it must be a whole number from 10 to 1000",
        ),
        ("bridson(tries=99999999999)", "99999999999", "`bridson`: `tries` cannot be"),
        ("jittered(rows=2, rows=2)", "rows", "`jittered`: `rows` is set twice"),
        ("jittered(rows=2", "jittered(rows=2", "`jittered`: settings are written as in `faure(base=5)`"),
        ("jittered()", "", "`jittered`: settings are written as in"),
        ("jittered(2)", "2", "`jittered`: settings are written as in"),
    ];
    for (written, place, message) in slips {
        let error = Method::parse(written).expect_err(written);
        assert!(error.to_string().starts_with(message), "{written}: {error}");
        let UnknownMethod::Setting { range, .. } = error else { panic!("{written}") };
        assert_eq!(&written[range], place, "{written}");
    }
    assert_eq!(Method::parse("faure(bsae=5)").expect_err("a slip").suggestion(), Some("base"));
    // Settings that fit no other count or dimension are refused with the nearest.
    let refused =
        |name: &str, n, d| Method::parse(name).expect(name).points(n, d, Seed::new(1)).expect_err(name).to_string();
    assert_eq!(refused("faure(base=5)", 5, 6), "d = 6 is not possible: d must be from 1 to 5");
    assert_eq!(
        refused("jittered(rows=4,columns=8)", 31, 2),
        "n = 31 is not possible: it must be rows x columns; the nearest is 32"
    );
    assert_eq!(
        refused("jittered(rows=4)", 9, 2),
        "n = 9 is not possible: it must be a multiple of the rows; the nearest are 8 and 12"
    );
    assert_eq!(refused("jittered(rows=4)", 8, 3), "d = 3 is not possible: this method has 2 dimensions");
    assert_eq!(
        refused("korobov(generator=6)", 8, 2),
        "n = 8 is not possible: it must be without a common divisor with the generator; the nearest are 7 and 11"
    );
}

/// Settings are declared as they are used: names, limits that hold the default, and another sampler
/// for each value.
#[test]
fn settings_are_declared_soundly() {
    let mut settings = 0;
    for sampler in SAMPLERS {
        let key = sampler.about().key;
        assert_eq!(sampler.with(Values::default()).is_some(), !sampler.settings().is_empty(), "{key}");
        for setting in sampler.settings() {
            let plain = |c: char| c.is_ascii_lowercase() || c == '-';
            assert!(setting.name.chars().all(plain) && !setting.meaning.ends_with('.'), "{key}");
            if let Preset::Number(number) = setting.default {
                assert!((setting.least..=setting.most).contains(&number), "{key}");
            }
            for value in [setting.least, setting.most] {
                let name = format!("{key}({}={value})", setting.name);
                let method = Method::parse(&name);
                assert!(method.is_ok(), "{name}: {method:?}");
            }
            settings += 1;
        }
    }
    assert!(settings > 12, "only {settings} settings");
}
