//! From text to a tree, with the place of the first mistake.

use super::{BINARIES, CONSTANTS, ExpressionError, MOST_VARIABLES, Node, Operator, SIGN, UNARIES};
use crate::catalogue::nearest;
use std::ops::Range;

/// The deepest nesting: it bounds the recursion here, and the stack of the compiled form.
const DEEPEST: usize = 64;

/// The most words: a long sum makes a tree as deep as it has terms.
const LONGEST: usize = 1000;

/// A word of the text.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Token<'a> {
    Number(f64),
    Name(&'a str),
    /// A name in square brackets, by its place among them.
    Bracketed(usize),
    Operator(Operator),
    Open,
    Close,
    Comma,
    End,
}

/// What stands for the numbers that are known only when the expression is evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Variables {
    /// The coordinates `x`, `y`, `z`, `x1`, ...
    Coordinates,
    /// Names in square brackets, each a variable of its own in the order of the text.
    Bracketed,
}

/// Reads `text`, an expression in the coordinates.
pub(super) fn parse(text: &str) -> Result<Node, ExpressionError> {
    read(text, Variables::Coordinates).map(|(node, _)| node)
}

/// Reads `text`, an expression in bracketed names: the n-th of them is the n-th variable, and stands where is told.
pub(super) fn parse_bracketed(text: &str) -> Result<(Node, Vec<Range<usize>>), ExpressionError> {
    read(text, Variables::Bracketed)
}

fn read(text: &str, variables: Variables) -> Result<(Node, Vec<Range<usize>>), ExpressionError> {
    let mut names = Vec::new();
    let tokens = tokens(text, variables, &mut names)?;
    if tokens.len() > LONGEST {
        return Err(error(0..text.len(), format!("the expression has more than {LONGEST} words")));
    }
    let mut parser = Parser { text, tokens, variables, at: 0 };
    if parser.token() == Token::End {
        return Err(error(0..text.len(), "the expression is empty"));
    }
    let node = parser.expression(0, 0)?;
    match parser.token() {
        Token::End => Ok((node, names)),
        Token::Close => Err(error(parser.range(), "this parenthesis closes nothing")),
        Token::Comma => Err(error(parser.range(), "a comma stands only between the arguments of a function")),
        _ => Err(parser.missing_operator()),
    }
}

fn error(range: Range<usize>, message: impl Into<String>) -> ExpressionError {
    ExpressionError { range, message: message.into(), suggestion: None }
}

/// The words of `text` with their places; the last is the end. The places of bracketed names are added to `names`.
fn tokens<'t>(
    text: &'t str,
    variables: Variables,
    names: &mut Vec<Range<usize>>,
) -> Result<Vec<(Token<'t>, Range<usize>)>, ExpressionError> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let (token, length) = match first {
            _ if first.is_whitespace() => {
                at += first.len_utf8();
                continue;
            }
            '0'..='9' | '.' => number(rest, at)?,
            'a'..='z' | 'A'..='Z' => {
                let length = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
                (Token::Name(&rest[..length]), length)
            }
            '[' if variables == Variables::Bracketed => {
                names.push(bracketed(rest, at)?);
                (Token::Bracketed(names.len() - 1), rest.find(']').map_or(rest.len(), |close| close + 1))
            }
            '(' => (Token::Open, 1),
            ')' => (Token::Close, 1),
            ',' => (Token::Comma, 1),
            _ => operator(rest).ok_or_else(|| unknown_character(first, at))?,
        };
        tokens.push((token, at..at + length));
        at += length;
    }
    tokens.push((Token::End, text.trim_end().len()..text.trim_end().len()));
    Ok(tokens)
}

/// The place of the name in the brackets that open at the start of `rest`, without the space around it.
fn bracketed(rest: &str, at: usize) -> Result<Range<usize>, ExpressionError> {
    let close = rest.find(']').ok_or_else(|| error(at..at + 1, "this bracket is not closed"))?;
    let inside = &rest[1..close];
    let name = inside.trim();
    if name.is_empty() || name.contains('[') {
        return Err(error(at..at + close + 1, "there is no name of a value in these brackets"));
    }
    let start = at + 1 + (inside.len() - inside.trim_start().len());
    Ok(start..start + name.len())
}

fn unknown_character(character: char, at: usize) -> ExpressionError {
    let message = match character {
        '=' => "an expression compares with `<`, `<=`, `>` or `>=` only".to_owned(),
        _ => format!("`{character}` has no place in an expression"),
    };
    error(at..at + character.len_utf8(), message)
}

fn operator(rest: &str) -> Option<(Token<'_>, usize)> {
    let operator = match rest.as_bytes() {
        [b'<', b'=', ..] => return Some((Token::Operator(Operator::AtMost), 2)),
        [b'>', b'=', ..] => return Some((Token::Operator(Operator::AtLeast), 2)),
        // `**` is the power of many languages.
        [b'*', b'*', ..] => return Some((Token::Operator(Operator::Power), 2)),
        [b'+', ..] => Operator::Add,
        [b'-', ..] => Operator::Subtract,
        [b'*', ..] => Operator::Multiply,
        [b'/', ..] => Operator::Divide,
        [b'^', ..] => Operator::Power,
        [b'<', ..] => Operator::Less,
        [b'>', ..] => Operator::Greater,
        _ => return None,
    };
    Some((Token::Operator(operator), 1))
}

/// A number with an optional fraction and exponent; `2e` is 2 times the constant e, and a mistake
/// told later.
fn number(rest: &str, at: usize) -> Result<(Token<'_>, usize), ExpressionError> {
    let bytes = rest.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut length = digits(0);
    if bytes.get(length) == Some(&b'.') {
        length += 1 + digits(length + 1);
    }
    if matches!(bytes.get(length), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
        let exponent = digits((length + 1 + sign).min(bytes.len()));
        if exponent > 0 {
            length += 1 + sign + exponent;
        }
    }
    let value = rest[..length].parse().ok().filter(|value: &f64| value.is_finite());
    let value = value.ok_or_else(|| error(at..at + length, format!("`{}` is not a number", &rest[..length])))?;
    Ok((Token::Number(value), length))
}

struct Parser<'a> {
    text: &'a str,
    tokens: Vec<(Token<'a>, Range<usize>)>,
    variables: Variables,
    at: usize,
}

impl<'a> Parser<'a> {
    fn token(&self) -> Token<'a> {
        self.tokens.get(self.at).map_or(Token::End, |(token, _)| *token)
    }

    fn range(&self) -> Range<usize> {
        self.tokens.get(self.at).map_or(self.text.len()..self.text.len(), |(_, range)| range.clone())
    }

    fn written(&self) -> &'a str {
        self.text.get(self.range()).unwrap_or_default()
    }

    fn missing_operator(&self) -> ExpressionError {
        error(self.range(), format!("an operator is missing before `{}`", self.written()))
    }

    /// Operands joined by operators that bind at least as strongly as `strength`.
    fn expression(&mut self, strength: u8, depth: usize) -> Result<Node, ExpressionError> {
        if depth > DEEPEST {
            return Err(error(self.range(), format!("the expression is nested more than {DEEPEST} deep")));
        }
        let mut left = self.operand(depth)?;
        while let Token::Operator(operator) = self.token()
            && operator.strength() >= strength
        {
            self.at += 1;
            // Operators of equal strength group to the left, but powers to the right.
            let right = if operator == Operator::Power { SIGN } else { operator.strength() + 1 };
            let right = self.expression(right, depth + 1)?;
            left = Node::Operation(operator, Box::new(left), Box::new(right));
        }
        Ok(left)
    }

    /// A number, a variable, a constant, a call, a parenthesis, or one of them with a sign.
    fn operand(&mut self, depth: usize) -> Result<Node, ExpressionError> {
        let (token, range, written) = (self.token(), self.range(), self.written());
        if token == Token::End {
            return Err(error(range, "an operand is missing at the end"));
        }
        self.at += 1;
        match token {
            Token::Number(value) => Ok(Node::Number(value, written.to_owned())),
            Token::Name(name) => self.name(name, range, depth),
            Token::Bracketed(index) => Ok(Node::Variable(index, written.to_owned())),
            Token::Operator(Operator::Subtract) => Ok(Node::Negated(Box::new(self.expression(SIGN, depth + 1)?))),
            Token::Operator(Operator::Add) => self.expression(SIGN, depth + 1),
            Token::Open => {
                let node = self.expression(0, depth + 1)?;
                self.close(range)?;
                Ok(node)
            }
            _ => Err(error(range, format!("an operand is missing before `{written}`"))),
        }
    }

    /// The parenthesis that closes the one at `open`.
    fn close(&mut self, open: Range<usize>) -> Result<(), ExpressionError> {
        match self.token() {
            Token::Close => self.at += 1,
            Token::End => return Err(error(open, "this parenthesis is not closed")),
            Token::Comma => return Err(error(self.range(), "one argument too many")),
            _ => return Err(self.missing_operator()),
        }
        Ok(())
    }

    fn name(&mut self, name: &'a str, range: Range<usize>, depth: usize) -> Result<Node, ExpressionError> {
        if let Some(index) = variable(name).filter(|_| self.variables == Variables::Coordinates) {
            return Ok(Node::Variable(index, latex_variable(name)));
        }
        if let Some(&(_, latex, value)) = CONSTANTS.iter().find(|constant| constant.0 == name.to_lowercase()) {
            return Ok(Node::Number(value, latex.to_owned()));
        }
        if let Some(function) = UNARIES.iter().find(|function| function.name == name) {
            let open = self.open(name)?;
            let argument = self.expression(0, depth + 1)?;
            self.close(open)?;
            return Ok(Node::Unary(function, Box::new(argument)));
        }
        if let Some(function) = BINARIES.iter().find(|function| function.name == name) {
            let open = self.open(name)?;
            let first = self.expression(0, depth + 1)?;
            if self.token() != Token::Comma {
                return Err(error(self.range(), format!("`{name}` takes two arguments, with a comma between")));
            }
            self.at += 1;
            let second = self.expression(0, depth + 1)?;
            self.close(open)?;
            return Ok(Node::Binary(function, Box::new(first), Box::new(second)));
        }
        let mut unknown = error(range, format!("there is no `{name}`"));
        unknown.suggestion = suggestion(name, self.variables);
        Err(unknown)
    }

    fn open(&mut self, name: &str) -> Result<Range<usize>, ExpressionError> {
        let range = self.range();
        if self.token() != Token::Open {
            return Err(error(range, format!("`{name}` needs its argument in parentheses")));
        }
        self.at += 1;
        Ok(range)
    }
}

/// The index of the variable `name`, from 0.
fn variable(name: &str) -> Option<usize> {
    match name {
        "x" => Some(0),
        "y" => Some(1),
        "z" => Some(2),
        _ => {
            let index = name.strip_prefix('x')?.parse::<usize>().ok()?;
            (!name.starts_with("x0") && index <= MOST_VARIABLES).then(|| index - 1)
        }
    }
}

fn latex_variable(name: &str) -> String {
    if name.len() > 1 { format!("x_{{{}}}", &name[1..]) } else { name.to_owned() }
}

/// The known name nearest to `name`; other languages' names first, which no measure of likeness
/// finds.
fn suggestion(name: &str, variables: Variables) -> Option<String> {
    let alias = match name.to_lowercase().as_str() {
        "sine" => Some("sin"),
        "cosine" => Some("cos"),
        "log" => Some("ln"),
        "arctan" => Some("atan"),
        "arcsin" => Some("asin"),
        "arccos" => Some("acos"),
        "power" => Some("pow"),
        "phi" | "cdf" => Some("normal_cdf"),
        "fact" => Some("factorial"),
        _ => None,
    };
    let names = UNARIES.iter().map(|function| function.name).chain(BINARIES.iter().map(|function| function.name));
    let coordinates: &[&str] = if variables == Variables::Coordinates { &["x", "y", "z"] } else { &[] };
    let names = names.chain(CONSTANTS.iter().map(|constant| constant.0)).chain(coordinates.iter().copied());
    alias.or_else(|| nearest(name, names)).map(str::to_owned)
}
