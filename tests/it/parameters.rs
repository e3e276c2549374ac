//! Reading a fence: every mistake is told, at its place, with what to do.

use toml::de::DeTable;
use workbook::diag::Code;
use workbook::kinds::{self, Experiment, KINDS};
use workbook::parameters::{Complaint, Fields};

/// The experiment that a fence asks for, or what is wrong with it.
pub fn plan(fence: &str) -> Result<Box<dyn Experiment>, Vec<Complaint>> {
    let table = DeTable::parse(fence).expect("the fence is TOML");
    let mut fields = Fields::new(table.get_ref());
    let key = fields.read::<String>("kind").expect("the fence has a kind");
    let planned = kinds::find(&key).expect("the kind is known").plan(&mut fields);
    planned.ok_or(fields.complaints)
}

/// Asserts that `fence` has exactly one mistake: its code, the text at its place, and words of the message and help.
fn complains(fence: &str, code: Code, place: &str, words: &[&str]) {
    let Err(complaints) = plan(fence) else { panic!("nothing is wrong with {fence}") };
    let [complaint] = complaints.as_slice() else { panic!("not one complaint: {complaints:#?}") };
    assert_eq!(complaint.code, code, "{complaint:#?}");
    assert_eq!(&fence[complaint.range.clone()], place, "{complaint:#?}");
    let told = format!("{} {}", complaint.message, complaint.help.join(" "));
    for word in words {
        assert!(told.contains(word), "{word:?} is not in {told:?}");
    }
}

const START: &str = "id = \"fig-a\"\nkind = \"convergence\"\n";

fn convergence(rest: &str) -> String {
    format!("{START}{rest}")
}

#[test]
fn unknown_keys_are_offered_the_nearest() {
    let fence = convergence("samplers = [\"sobol\"]\nintegrand = \"deck\"\nreplicats = 8");
    complains(&fence.replace("deck", "exp-sin"), Code::UnknownKey, "replicats", &["did you mean `replicates`?"]);
    let fence = "kind = \"van-der-corput-table\"\ncapton = \"x\"";
    complains(fence, Code::UnknownKey, "capton", &["did you mean `caption`?", "`n` and `base`"]);
}

#[test]
fn missing_keys_say_what_they_are() {
    let fence = convergence("integrand = \"exp-sin\"");
    complains(&fence, Code::MissingKey, "\"convergence\"", &["`samplers` is missing", "the name of a sampler"]);
}

#[test]
fn wrong_types_say_what_was_found() {
    let start = "samplers = \"independent\"\nintegrand = \"exp-sin\"\n";
    let fence = |line: &str| convergence(&format!("{start}{line}"));
    complains(&fence("replicates = \"64\""), Code::WrongType, "\"64\"", &["expected a whole number, found a string"]);
    complains(&fence("replicates = 6.5"), Code::WrongType, "6.5", &["found a number with a fraction"]);
    complains(&fence("n = [16, true]"), Code::WrongType, "true", &["expected counts", "found true or false"]);
    complains(&fence("slopes = \"steep\""), Code::WrongType, "\"steep\"", &["expected a number"]);
    complains(&fence("n = \"2^4..3^5\""), Code::WrongType, "\"2^4..3^5\"", &["powers of one base"]);
    complains(&fence("n = \"many\""), Code::WrongType, "\"many\"", &["`many` is not a whole number", "2^4..2^14"]);
    complains(&convergence("samplers = [\"sobol\"]\nintegrand = true"), Code::WrongType, "true", &["an integrand"]);
}

#[test]
fn numbers_stay_in_range() {
    let start = "samplers = \"independent\"\nintegrand = \"exp-sin\"\n";
    let fence = |line: &str| convergence(&format!("{start}{line}"));
    complains(&fence("replicates = 1"), Code::OutOfRange, "1", &["from 2 to 1000000"]);
    complains(&fence("replicates = -1"), Code::OutOfRange, "-1", &["from 2 to 1000000"]);
    complains(&fence("replicates = 99999999999999999999"), Code::OutOfRange, "99999999999999999999", &["out of range"]);
    complains(&fence("n = [16, 0]"), Code::OutOfRange, "0", &["from 1"]);
    complains(&fence("n = \"2^60\""), Code::OutOfRange, "\"2^60\"", &["16777216"]);
    complains(&fence("n = \"2^99\""), Code::WrongType, "\"2^99\"", &["too large"]);
    complains(&fence("n = []"), Code::OutOfRange, "[]", &["found 0"]);
    complains(&fence("slopes = [nan]"), Code::OutOfRange, "nan", &["finite"]);
    complains(&fence("n = \"2^9..2^4\""), Code::WrongType, "\"2^9..2^4\"", &["backwards"]);
}

#[test]
fn unknown_names_are_offered_the_nearest() {
    let fence = convergence("samplers = [\"independent\", \"sobl\"]\nintegrand = \"exp-sin\"");
    complains(&fence, Code::UnknownName, "\"sobl\"", &["unknown sampler `sobl`", "`sobol`", "workbook list samplers"]);
    let fence = convergence("samplers = [\"sobol+xorr\"]\nintegrand = \"exp-sin\"");
    complains(&fence, Code::UnknownName, "\"sobol+xorr\"", &["unknown scramble `xorr`", "`xor`"]);
    let fence = convergence("samplers = [\"independent+xor\"]\nintegrand = \"exp-sin\"");
    complains(&fence, Code::Combination, "\"independent+xor\"", &["cannot be combined"]);
    let fence = convergence("samplers = [\"sobol\"]\nintegrand = \"exp-sn\"");
    complains(&fence, Code::UnknownName, "\"exp-sn\"", &["`exp-sin`", "workbook list integrands"]);
    let fence = "kind = \"points\"\nsamplers = \"sobol\"\nstrata = \"cels\"";
    complains(fence, Code::UnknownName, "\"cels\"", &["`cells`", "`none`, `cells` and `slabs`"]);
}

#[test]
fn counts_that_a_sampler_cannot_give_are_marked_at_the_element() {
    let start = "samplers = [\"jittered\"]\nintegrand = \"xy\"\n";
    let fence = |line: &str| convergence(&format!("{start}{line}"));
    complains(&fence("n = [16, 20, 64]"), Code::Count, "20", &["`jittered` cannot give 20", "16 and 25"]);
    complains(&fence("n = [\"4^2\", \"2^7\"]"), Code::Count, "\"2^7\"", &["128", "121 and 144"]);
    let range = fence("n = \"2^4..2^7\"");
    complains(&range, Code::Count, "\"2^4..2^7\"", &["32 or 128", "25 and 36 for 32, 121 and 144 for 128"]);
    complains(&fence("").replace("jittered", "van-der-corput"), Code::Combination, "\"van-der-corput\"", &["d = 2"]);
}

#[test]
fn malformed_expressions_are_marked_inside_the_string() {
    let fence = |text: &str| convergence(&format!("samplers = \"sobol\"\nintegrand = {text}"));
    complains(&fence("\"exp(sine(3*x))\""), Code::Expression, "sine", &["did you mean `sin`?"]);
    complains(&fence("'exp(sine(3*x))'"), Code::Expression, "sine", &[]);
    complains(&fence("\"exp(\\u0073ine(3*x))\""), Code::Expression, "\"exp(\\u0073ine(3*x))\"", &[]);
    complains(&fence("\"exp(3*x\""), Code::Expression, "(", &["not closed"]);
    for broken in ["\"\"", "\" \"", "\"x +\"", "\")\"", "\"é*x\"", "\"x1 */ 2\""] {
        assert!(plan(&fence(broken)).is_err(), "{broken}");
    }
}

#[test]
fn every_mistake_is_told_in_one_pass() {
    let fence =
        convergence("samplers = [\"sobl\", 3]\nintegrand = \"exp(\"\nn = [0, \"q\"]\nreplicates = 0\nsamler = 1");
    let Err(complaints) = plan(&fence) else { panic!("much is wrong") };
    let codes: Vec<Code> = complaints.iter().map(|complaint| complaint.code).collect();
    let expected = [
        Code::UnknownName,
        Code::WrongType,
        Code::Expression,
        Code::OutOfRange,
        Code::WrongType,
        Code::OutOfRange,
        Code::UnknownKey,
    ];
    assert_eq!(codes, expected, "{complaints:#?}");
}

#[test]
fn what_cannot_go_together_is_told_before_anything_runs() {
    complains(
        "kind = \"running-mean\"\nsamplers = [\"independent\", \"latin-hypercube\"]\nintegrand = \"exp-sin\"",
        Code::Combination,
        "\"latin-hypercube\"",
        &["not a sequence"],
    );
    complains(
        "kind = \"histogram\"\nsampler = \"halton\"\nintegrand = \"exp-sin\"",
        Code::Combination,
        "\"halton\"",
        &["no distribution"],
    );
    complains("kind = \"function\"\nintegrand = \"xy\"", Code::Combination, "\"xy\"", &["2 variables"]);
    complains("kind = \"function\"\nintegrand = \"x\"\nto = -1", Code::OutOfRange, "-1", &["less than `to`"]);
    complains("kind = \"points\"\nsamplers = \"sobol\"\nn = 8\nstrata = \"cells\"", Code::Count, "8", &["4 and 9"]);
    complains(
        &convergence("samplers = \"sobol\"\nintegrand = \"xy\"\ndimensions = 1"),
        Code::Combination,
        "1",
        &["2 variables"],
    );
    let twice = convergence("samplers = [\"sobol\", \"sobol\"]\nintegrand = \"xy\"");
    complains(&twice, Code::Combination, "\"sobol\"", &["twice"]);
    let both = convergence("samplers = [\"sobol\"]\nsampler = \"halton\"\nintegrand = \"xy\"");
    complains(&both, Code::Combination, "\"halton\"", &["another name for `samplers`"]);
}

#[test]
fn equal_questions_have_equal_canonical_parameters() {
    let canonical = |fence: &str| plan(&convergence(fence)).map(|planned| planned.parameters()).expect("right");
    let short = canonical("sampler = \"sobol\"\nintegrand = \"xy\"\nn = \"2^4..2^6\"");
    let long = canonical(
        "samplers = [ \"sobol\" ]\nintegrand = \"xy\"\nn = [64, 16, \"2^5\", 16]\nreplicates = 64\ndimensions = 2\nslopes = -0.5",
    );
    assert_eq!(short, long);
    assert_eq!(short["n"], serde_json::json!([16, 32, 64]));
    assert_eq!(short["dimensions"], 2);
    assert_ne!(short, canonical("sampler = \"sobol\"\nintegrand = \"xy\"\nn = \"2^4..2^7\""));
}

#[test]
fn every_kind_documents_its_parameters_and_its_defaults_read() {
    for kind in KINDS {
        let about = kind.about();
        assert!(about.summary.ends_with('.') && !about.title.is_empty(), "{}", about.key);
        assert!(about.source.contains("\nmod drawing {\n"), "{}: computing and drawing are apart", about.key);
        for doc in kind.parameters() {
            assert!(doc.meaning.ends_with('.') && !doc.type_name.is_empty(), "{}.{}: {doc:?}", about.key, doc.name);
        }
    }
    // What must be written, as shortly as it can be; all else is read from the defaults.
    let least = |key: &str, name: &str| match (key, name) {
        ("koksma-hlawka", "integrand") => "\"unit-variation\"",
        ("bug", "bug") => "\"missing-density\"",
        ("point-bug", "bug") => "\"integer-division\"",
        ("coverage" | "averaging", "samplers") => "\"sobol+owen\"",
        (_, "samplers") => "\"independent\"",
        ("surface", "integrand") => "\"gaussian\"",
        (_, "densities") => "\"1\"",
        _ => "\"exp-sin\"",
    };
    for kind in KINDS {
        let key = kind.about().key;
        let parameters = kind.parameters();
        let written = parameters.iter().filter(|doc| doc.required);
        let mut written: Vec<String> = written.map(|doc| format!("{} = {}", doc.name, least(key, doc.name))).collect();
        // One of two must be given.
        written.extend((key == "distribution").then(|| "law = \"normal\"".to_owned()));
        written.extend((key == "averaging").then(|| "integrand = \"exp-sin\"".to_owned()));
        let planned = plan(&format!("kind = \"{key}\"\n{}", written.join("\n")));
        assert!(planned.is_ok(), "{key}: {:?}", planned.err());
    }
}
