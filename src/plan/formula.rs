//! Formulas: LaTeX to MathML, in one place, so that a malformed one is told before anything runs.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::{Mutex, MutexGuard, PoisonError};

use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

use crate::diag::{Code, Diagnostic};
use crate::workspace::CONFIGURATION;

/// Turns LaTeX into MathML Core with the course's macros.
pub struct Converter {
    converter: LatexToMathML,
    /// What has been converted, if it is to be remembered: lately, and before that; each by formula, for a line and for itself.
    memory: Option<Mutex<[Formulas; 2]>>,
}

/// Formulas with what became of them.
type Formulas = BTreeMap<(bool, String), Result<String, FormulaError>>;

/// Why a formula cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FormulaError {
    /// The bytes of the formula that are wrong; may be empty.
    pub range: Range<usize>,
    /// What is wrong.
    pub message: String,
}

impl Converter {
    /// A converter with the course's macros; one that cannot be read is told, and then none are known.
    pub fn new(macros: &BTreeMap<String, String>, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let macros = macros.iter().map(|(name, text)| (name.clone(), text.clone())).collect();
        let converter = LatexToMathML::new(MathCoreConfig { macros, ..MathCoreConfig::default() });
        let converter = converter.unwrap_or_else(|(error, _, text)| {
            let message = format!("the macro `{text}` cannot be read: {}", error.error_message());
            diagnostics.push(Diagnostic::error(Code::Configuration, message).at(&CONFIGURATION.into(), 0..0));
            LatexToMathML::default()
        });
        Self { converter, memory: None }
    }

    /// With a memory of what it has converted.
    #[must_use]
    pub fn remembering(self) -> Self {
        Self { memory: Some(Mutex::default()), ..self }
    }

    /// Forgets what nobody has asked for since the last call.
    pub fn forget(&self) {
        if let Some(memory) = &self.memory {
            let [now, before] = &mut *lock(memory);
            *before = std::mem::take(now);
        }
    }

    /// The MathML of a formula; `display` if it stands on lines of its own.
    pub fn convert(&self, tex: &str, display: bool) -> Result<String, FormulaError> {
        let Some(memory) = &self.memory else { return self.anew(tex, display) };
        self.remembered(memory, tex, display, Clone::clone)
    }

    /// What is wrong with a formula, if anything is.
    pub fn error(&self, tex: &str, display: bool) -> Option<FormulaError> {
        let Some(memory) = &self.memory else { return self.anew(tex, display).err() };
        self.remembered(memory, tex, display, |known| known.as_ref().err().cloned())
    }

    /// What `take` takes of a formula that has been converted before, or is now.
    fn remembered<T>(
        &self,
        memory: &Mutex<[Formulas; 2]>,
        tex: &str,
        display: bool,
        take: impl FnOnce(&Result<String, FormulaError>) -> T,
    ) -> T {
        let key = (display, tex.to_owned());
        let [now, before] = &mut *lock(memory);
        if let Some(known) = now.get(&key) {
            return take(known);
        }
        let converted = before.remove(&key).unwrap_or_else(|| self.anew(tex, display));
        let taken = take(&converted);
        now.insert(key, converted);
        taken
    }

    fn anew(&self, tex: &str, display: bool) -> Result<String, FormulaError> {
        let display = if display { MathDisplay::Block } else { MathDisplay::Inline };
        match self.converter.convert_with_local_state(tex, display) {
            Ok(result) => Ok(with_integrals(result.mathml)),
            Err(error) => Err(FormulaError { range: within(tex, &error.0), message: error.error_message() }),
        }
    }
}

/// The formula with a class for each integral over a domain: browsers lead what follows away from the domain by the slant of the sign.
fn with_integrals(mathml: String) -> String {
    if !mathml.contains("∫</mo>") {
        return mathml;
    }
    let mut out = String::with_capacity(mathml.len() + 32);
    let mut rest = mathml.as_str();
    while let Some(at) = rest.find("∫</mo>") {
        let sign = rest[..at].rfind("<mo").unwrap_or(at);
        match rest[..sign].strip_suffix("<msub>") {
            Some(before) => out.extend([before, "<msub class=\"integral\">", &rest[sign..at]]),
            None => out.push_str(&rest[..at]),
        }
        out.push('∫');
        rest = &rest[at + '∫'.len_utf8()..];
    }
    out + rest
}

/// The memory, whole even if a thread that held it broke off.
fn lock(memory: &Mutex<[Formulas; 2]>) -> MutexGuard<'_, [Formulas; 2]> {
    memory.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The range cut to the formula and to whole characters; an empty one at the end marks the last character.
fn within(tex: &str, range: &Range<usize>) -> Range<usize> {
    let start = tex.floor_char_boundary(range.start.min(tex.len()));
    let end = tex.ceil_char_boundary(range.end.clamp(start, tex.len()));
    if start == end && !tex.is_empty() {
        tex.floor_char_boundary(start.min(tex.len() - 1))..tex.len().min(start + 1)
    } else {
        start..end
    }
}

#[cfg(test)]
mod tests {
    use super::{Converter, within};
    use std::collections::BTreeMap;

    #[test]
    fn a_macro_is_known_and_a_malformed_formula_is_placed() {
        let macros = BTreeMap::from([("E".to_owned(), r"\operatorname{E}".to_owned())]);
        let mut diagnostics = Vec::new();
        let converter = Converter::new(&macros, &mut diagnostics);
        assert!(diagnostics.is_empty());
        assert!(converter.convert(r"\E[Y] = \int f\,p", false).is_ok_and(|mathml| mathml.contains("<math")));
        let error = converter.convert(r"a + \fraq{1}{2}", false).expect_err("no such command");
        assert_eq!(&r"a + \fraq{1}{2}"[error.range], r"\fraq");
    }

    #[test]
    fn integrals_over_a_domain_are_marked_and_no_other_sign() {
        let converter = Converter::new(&BTreeMap::new(), &mut Vec::new());
        let found = converter.convert(r"\int_D f + \int_0^1 g + \int h + \log_2 N", true).expect("a formula");
        assert_eq!(found.matches("class=\"integral\"").count(), 1, "{found}");
        assert!(found.contains("<msub class=\"integral\"><mo") && found.matches('∫').count() == 3, "{found}");
    }

    #[test]
    fn a_range_behind_the_end_marks_the_last_character() {
        assert_eq!(within("ab", &(2..2)), 1..2);
        assert_eq!(within("aé", &(3..9)), 1..3);
        assert_eq!(within("", &(0..1)), 0..0);
    }
}
