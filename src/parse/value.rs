//! Code within a line that is no code: values of exhibits, and numbers that are computed from them.

use std::ops::Range;

use pulldown_cmark::{CowStr, Event};

use super::events::Reader;
use super::node::{Computed, ValueUse, What};
use crate::diag::Code;
use crate::integrands::{Calculation, ExpressionError};

impl<'a> Reader<'a, '_> {
    /// Code within a line; `` `=id.name:format` `` is a value, `` `=(expression):format` `` is computed.
    pub(super) fn code(&mut self, code: CowStr<'a>, range: Range<usize>) {
        let Some(written) = code.strip_prefix('=') else {
            return self.push(What::Markdown(Event::Code(code).into_static()), range);
        };
        if written.trim_start().starts_with('(') {
            return self.computed(&code, range);
        }
        let (path, format) = written.split_once(':').unwrap_or((written, ""));
        match path.split_once('.') {
            Some((exhibit, name)) if !exhibit.is_empty() && !name.is_empty() => {
                let value =
                    ValueUse { exhibit: exhibit.to_owned(), name: name.to_owned(), format: format.trim().to_owned() };
                self.push(What::Value(value), range);
            }
            _ => {
                let error = self.error(Code::UnknownValue, format!("`={written}` names no value"), range);
                self.diagnostics.push(
                    error
                        .help("write it as `=fig-id.value.name:.3`: an exhibit, a dot, the value's name")
                        .help("a number that is computed stands in parentheses: `=(1/sqrt([fig-id.value.name])):.3`"),
                );
            }
        }
    }

    /// `=(expression):format`: the format stands behind the last parenthesis or bracket.
    fn computed(&mut self, code: &str, range: Range<usize>) {
        let end = code.rfind([')', ']']).map_or(code.len(), |last| last + 1);
        let (text, format) = match code[end..].find(':') {
            Some(colon) => (&code[1..end + colon], &code[end + colon + 1..]),
            None => (&code[1..], ""),
        };
        // Markdown makes one space of a line's end; if it took more away than that, the place is the whole of it.
        let raw = self.parsed[range.clone()].replace('\n', " ");
        let start = raw.find(code).map(|inside| range.start + inside + 1);
        // The parentheses around the whole say that it is computed; they are no part of it.
        let inner = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
        let (parsed, outer) = match inner.map(Calculation::parse) {
            Some(Ok(calculation)) => (Ok(calculation), 1),
            _ => (Calculation::parse(text), 0),
        };
        match parsed {
            Ok(calculation) => {
                let start = start.map(|start| self.map.byte(start + outer));
                self.push(What::Computed(Computed { calculation, start, format: format.trim().to_owned() }), range);
            }
            Err(ExpressionError { range: wrong, message, suggestion }) => {
                // A place of no length, such as the end, marks the byte that stands there.
                let wrong = wrong.start..wrong.end.max(wrong.start + 1);
                let place = start.map_or(range, |start| start + wrong.start..start + wrong.end);
                let error = self.error(Code::Expression, message, place);
                self.diagnostics.push(error.help_if(suggestion.map(|name| format!("did you mean `{name}`?"))).help(
                    "an expression has numbers, pi, e, + - * / ^, functions such as sqrt, and values: `[fig-id.name]`",
                ));
            }
        }
    }
}
