//! An expression as LaTeX.

use super::{Node, Operator, SIGN};

/// How strongly the outermost operation of a node binds; operands that stand alone bind strongest.
const ATOM: u8 = 9;

/// The LaTeX of `node`.
pub(super) fn latex(node: &Node) -> String {
    match node {
        Node::Number(_, text) => number(text),
        Node::Variable(_, name) => name.clone(),
        Node::Negated(inner) => format!("-{}", grouped(inner, SIGN)),
        Node::Unary(function, inner) => call(function.name, function.latex, &latex(inner)),
        Node::Binary(function, first, second) if function.name == "pow" => power(first, second),
        Node::Binary(function, first, second) => {
            format!(r"{}\left({}, {}\right)", function.latex, latex(first), latex(second))
        }
        Node::Operation(operator, left, right) => operation(*operator, left, right),
    }
}

/// A number as written; an exponent of ten becomes a power.
fn number(text: &str) -> String {
    match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) if !mantissa.is_empty() => {
            format!(r"{mantissa} \cdot 10^{{{}}}", exponent.trim_start_matches('+'))
        }
        _ => text.to_owned(),
    }
}

fn call(name: &str, latex: &str, argument: &str) -> String {
    match name {
        "sqrt" => format!(r"\sqrt{{{argument}}}"),
        "abs" => format!(r"\left|{argument}\right|"),
        "floor" => format!(r"\left\lfloor {argument}\right\rfloor"),
        "ceil" => format!(r"\left\lceil {argument}\right\rceil"),
        "factorial" => format!(r"\left({argument}\right)!"),
        _ => format!(r"{latex}\left({argument}\right)"),
    }
}

fn operation(operator: Operator, left: &Node, right: &Node) -> String {
    let strength = operator.strength();
    let sign = match operator {
        Operator::Divide => return format!(r"\frac{{{}}}{{{}}}", latex(left), latex(right)),
        Operator::Power => return power(left, right),
        Operator::Multiply => return product(&grouped(left, strength), &grouped(right, strength + 1)),
        Operator::Add => "+",
        Operator::Subtract => "-",
        Operator::Less => "<",
        Operator::AtMost => r"\le",
        Operator::Greater => ">",
        Operator::AtLeast => r"\ge",
    };
    let comparison = strength == Operator::Less.strength();
    let both = format!("{} {sign} {}", grouped(left, strength), grouped(right, strength + 1));
    // A comparison is 1 or 0: Iverson's bracket says so.
    if comparison { format!(r"\left[{both}\right]") } else { both }
}

/// A product: factors side by side, with a dot where two numbers would run together.
fn product(left: &str, right: &str) -> String {
    let dot = if right.starts_with(|c: char| c.is_ascii_digit() || c == '.') { r" \cdot " } else { r" \, " };
    let plain = left.ends_with(|c: char| c.is_ascii_digit()) && !left.contains(['\\', '_']);
    if plain && dot == r" \, " { format!("{left} {right}") } else { format!("{left}{dot}{right}") }
}

fn power(base: &Node, exponent: &Node) -> String {
    format!("{}^{{{}}}", grouped(base, Operator::Power.strength() + 1), latex(exponent))
}

/// `node`, in parentheses if it binds weaker than `strength`.
fn grouped(node: &Node, strength: u8) -> String {
    let own = match node {
        Node::Negated(_) => SIGN - 2,
        // A fraction and a bracketed comparison stand alone, except under a power.
        Node::Operation(Operator::Divide, ..) => Operator::Power.strength(),
        Node::Operation(Operator::Less | Operator::AtMost | Operator::Greater | Operator::AtLeast, ..) => ATOM,
        Node::Operation(operator, ..) => operator.strength(),
        Node::Binary(function, ..) if function.name == "pow" => Operator::Power.strength(),
        _ => ATOM,
    };
    if own < strength { format!(r"\left({}\right)", latex(node)) } else { latex(node) }
}
