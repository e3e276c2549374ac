//! `workbook explain`: what a diagnostic means, with a wrong and a right example.

use clap::Args;
use serde_json::{Value as Json, json};

use super::{Exit, Format, Options, report};
use crate::catalogue::nearest;
use crate::diag::{Code, Diagnostic};
use crate::explain::{CHAPTER, Example, Part, explanation};

#[derive(Args)]
pub(super) struct Arguments {
    /// The code, such as W0107; all are listed if none is named
    code: Option<String>,
}

pub(super) fn run(arguments: &Arguments, options: &Options) -> Exit {
    let Some(written) = &arguments.code else {
        list(options);
        return Exit::Fine;
    };
    let id = normal(written);
    let Some(found) = Code::ALL.iter().find(|code| code.id() == id).and_then(|code| explanation(*code)) else {
        let near = nearest(&id, Code::ALL.iter().map(|code| code.id()));
        let error = Diagnostic::error(Code::UnknownName, format!("there is no diagnostic `{written}`"))
            .help_if(near.map(|near| format!("did you mean `{near}`?")))
            .help("`workbook explain` lists them all");
        return report::wrong(&error, Exit::Call, options);
    };
    if options.format == Format::Json {
        let json = json!({
            "code": found.code.id(),
            "meaning": found.code.meaning(),
            "text": found.text,
            "wrong": example(&found.wrong),
            "right": example(&found.right),
        });
        report::to_stdout_as_json(&json);
    } else {
        report::to_stdout(&found.for_terminals());
    }
    Exit::Fine
}

/// The code as it is printed: `w107` and `107` mean `W0107`.
fn normal(written: &str) -> String {
    let digits = written.trim_start_matches(['W', 'w']);
    match digits.parse::<u16>() {
        Ok(number) => format!("W{number:04}"),
        Err(_) => written.to_uppercase(),
    }
}

/// Lists all codes with their meanings.
fn list(options: &Options) {
    let mut codes = Code::ALL.to_vec();
    codes.sort_by_key(|code| code.id());
    if options.format == Format::Json {
        let json = codes.iter().map(|code| json!({ "code": code.id(), "meaning": code.meaning() }));
        return report::to_stdout_as_json(&json.collect::<Vec<_>>());
    }
    let lines: Vec<String> = codes.iter().map(|code| format!("{}  {}\n", code.id(), code.meaning())).collect();
    report::to_stdout(&lines.concat());
}

fn example(example: &Example) -> Json {
    let pieces = example.pieces.iter().map(|piece| match &piece.part {
        Part::Chapter => json!({ "file": CHAPTER, "text": piece.text }),
        Part::File(path, _) => json!({ "file": path, "text": piece.text }),
        Part::Commands => json!({ "commands": piece.text.lines().collect::<Vec<_>>() }),
    });
    json!({ "note": example.note, "pieces": pieces.collect::<Vec<_>>() })
}
