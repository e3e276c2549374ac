//! Expressions that chapters write, such as `exp(sin(3*x^2))`: read once, compiled, evaluated for
//! every sample.
//!
//! **Grammar.** Numbers (`3`, `.5`, `1e-3`); variables `x`, `y`, `z` or `x1` to `x256` (x = x1, y =
//! x2, z = x3); the constants `pi`, `tau`, `e`; `+ - * / ^`, where `^` binds strongest and to the
//! right, and a sign binds weaker than it, as in print: `-x^2` is -(x^2); the comparisons `<`,
//! `<=`, `>`, `>=`, which give 1 or 0; functions of one argument (`sin`, `exp`, `sqrt`, ...) and of
//! two (`min`, `max`, `pow`).
//!
//! A [`Calculation`] is of the same grammar with other variables: names in square brackets, such as
//! `[fig-a.rmse.16]`, which stand for values of results.
//!
//! **Why not a crate.** The expression crates that were tried bind a sign stronger than `^`, so
//! that `exp(-x^2-y^2)` would silently be another function, and tell no place of a mistake. Every
//! function is from [`crate::stats::portable`].
//!
//! **Cost.** The tree becomes a list of steps on a stack of numbers; a whole exponent becomes
//! multiplications.

mod calculation;
mod formula;
mod parser;
mod program;

use crate::stats::{normal, portable};
pub use calculation::Calculation;
pub(super) use program::Expression;
use std::fmt::{Display, Formatter};
use std::ops::Range;

/// The highest variable, `x256`.
pub const MOST_VARIABLES: usize = 256;

/// A mistake in an expression, with its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExpressionError {
    /// Where in the text, in bytes; it may be empty, at the place where something is missing.
    pub range: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// The name most likely meant, where a name is unknown.
    pub suggestion: Option<String>,
}

impl Display for ExpressionError {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.message)?;
        self.suggestion.as_ref().map_or(Ok(()), |name| write!(f, "; did you mean `{name}`?"))
    }
}

impl std::error::Error for ExpressionError {}

/// A function of one argument: its name, its LaTeX, its code.
pub(crate) struct Unary {
    name: &'static str,
    latex: &'static str,
    apply: fn(f64) -> f64,
}

/// A function of two arguments.
pub(crate) struct Binary {
    name: &'static str,
    latex: &'static str,
    apply: fn(f64, f64) -> f64,
}

const fn unary(name: &'static str, latex: &'static str, apply: fn(f64) -> f64) -> Unary {
    Unary { name, latex, apply }
}

/// The functions of one argument.
static UNARIES: &[Unary] = &[
    unary("sin", r"\sin", portable::sin),
    unary("cos", r"\cos", portable::cos),
    unary("tan", r"\tan", portable::tan),
    unary("asin", r"\arcsin", portable::asin),
    unary("acos", r"\arccos", portable::acos),
    unary("atan", r"\arctan", portable::atan),
    unary("sinh", r"\sinh", portable::sinh),
    unary("cosh", r"\cosh", portable::cosh),
    unary("tanh", r"\tanh", portable::tanh),
    unary("exp", r"\exp", portable::exp),
    unary("ln", r"\ln", portable::ln),
    unary("log2", r"\log_2", portable::log2),
    unary("log10", r"\log_{10}", portable::log10),
    unary("erf", r"\operatorname{erf}", portable::erf),
    unary("erfc", r"\operatorname{erfc}", portable::erfc),
    unary("gamma", r"\Gamma", portable::gamma),
    unary("lgamma", r"\ln\Gamma", portable::ln_gamma),
    unary("normal_cdf", r"\Phi", normal::distribution),
    unary("normal_quantile", r"\Phi^{-1}", normal::quantile),
    unary("factorial", "!", factorial),
    unary("sqrt", r"\sqrt", f64::sqrt),
    unary("abs", "|", f64::abs),
    unary("floor", r"\lfloor", f64::floor),
    unary("ceil", r"\lceil", f64::ceil),
    unary("round", r"\operatorname{round}", f64::round),
];

/// The functions of two arguments.
static BINARIES: &[Binary] = &[
    Binary { name: "min", latex: r"\min", apply: f64::min },
    Binary { name: "max", latex: r"\max", apply: f64::max },
    Binary { name: "pow", latex: "^", apply: portable::pow },
];

/// The constants, with their LaTeX.
static CONSTANTS: &[(&str, &str, f64)] =
    &[("pi", r"\pi", std::f64::consts::PI), ("tau", r"\tau", std::f64::consts::TAU), ("e", "e", std::f64::consts::E)];

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Less,
    AtMost,
    Greater,
    AtLeast,
}

impl Operator {
    /// How strongly it binds; the sign stands between `*` and `^`.
    const fn strength(self) -> u8 {
        match self {
            Self::Less | Self::AtMost | Self::Greater | Self::AtLeast => 1,
            Self::Add | Self::Subtract => 2,
            Self::Multiply | Self::Divide => 3,
            Self::Power => 5,
        }
    }

    #[inline]
    fn apply(self, left: f64, right: f64) -> f64 {
        match self {
            Self::Add => left + right,
            Self::Subtract => left - right,
            Self::Multiply => left * right,
            Self::Divide => left / right,
            Self::Power => portable::pow(left, right),
            Self::Less => f64::from(left < right),
            Self::AtMost => f64::from(left <= right),
            Self::Greater => f64::from(left > right),
            Self::AtLeast => f64::from(left >= right),
        }
    }
}

/// The product of the whole numbers up to `n`; NaN if that is not a whole number, or negative.
fn factorial(n: f64) -> f64 {
    if n < 0.0 || n.fract() != 0.0 {
        return f64::NAN;
    }
    // Beyond 170! there is no finite product.
    (1..=n.min(171.0) as u32).map(f64::from).product()
}

/// How strongly a sign binds: weaker than `^`, stronger than `*`.
const SIGN: u8 = 4;

/// An expression as a tree.
#[derive(Clone)]
enum Node {
    Number(f64, String),
    Variable(usize, String),
    Negated(Box<Node>),
    Operation(Operator, Box<Node>, Box<Node>),
    Unary(&'static Unary, Box<Node>),
    Binary(&'static Binary, Box<Node>, Box<Node>),
}

#[cfg(test)]
mod tests {
    use super::{BINARIES, CONSTANTS, UNARIES};

    #[test]
    fn the_guide_names_every_function() {
        let guide = include_str!("../../../guide/chapters/03-experiments.md");
        let functions =
            UNARIES.iter().map(|function| function.name).chain(BINARIES.iter().map(|function| function.name));
        for name in functions.chain(CONSTANTS.iter().map(|(name, ..)| *name)) {
            assert!(guide.contains(&format!("`{name}`")), "{name}");
        }
    }
}
