//! Plain formulas as LaTeX: `x_j = (c_j + u_j) / k_j` in an entry's own text, which is also read as documentation of the code, becomes a
//! formula of the page.
//!
//! A letter that stands alone is a variable, and so is what has a script. Variables join to one formula over signs, numbers and
//! brackets that close again. Everything else stays as it is.

use super::choice::link;
use crate::parse::Shelf;

/// A piece of a text.
#[derive(Debug, Clone, PartialEq)]
enum Piece {
    /// Words and signs.
    Text(String),
    /// A variable as LaTeX; whether it has a script or is an operator, so that a space before what follows multiplies.
    Math(String, bool),
    /// What must stay as it is.
    Fixed(String),
}

/// Functions and operators whose names are LaTeX commands.
const FUNCTIONS: &[&str] = &["log", "exp", "sin", "cos", "min", "max"];
/// Operators that act on what follows.
const OPERATORS: &[&str] = &["sum", "prod", "sup"];
/// Products of two letters.
const PRODUCTS: &[&str] = &["xy"];
/// Greek letters by their names.
const GREEK: &[&str] = &["pi", "Phi", "sigma", "rho", "alpha", "phi"];

/// The text with its formulas as LaTeX and its links as those of the book, which has the `shelves`.
pub(super) fn typeset(text: &str, shelves: &[Shelf]) -> String {
    let pieces = joined(&pieces(text, shelves));
    let piece = |piece: &Piece| match piece {
        Piece::Text(text) => signs(text),
        Piece::Math(tex, _) => format!("${}$", tex.trim()),
        Piece::Fixed(text) => text.clone(),
    };
    pieces.iter().map(piece).collect()
}

/// Signs as print has them.
fn signs(text: &str) -> String {
    text.replace("<=", "≤").replace(">=", "≥").replace(" - ", " − ").replace("...", "…")
}

/// Cuts a text into pieces.
fn pieces(text: &str, shelves: &[Shelf]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut plain = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let before = plain.chars().next_back().or_else(|| pieces.last().map(|_| ' '));
        let taken = fixed(rest, shelves).map(|(fixed, length)| (Piece::Fixed(fixed), length));
        let taken = taken
            .or_else(|| variable(rest, before, &plain).map(|(tex, script, length)| (Piece::Math(tex, script), length)));
        if let Some((piece, length)) = taken {
            if !plain.is_empty() {
                pieces.push(Piece::Text(std::mem::take(&mut plain)));
            }
            pieces.push(piece);
            rest = &rest[length..];
            continue;
        }
        // A word or a number as a whole, else a sign.
        let word = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len()).max(first.len_utf8());
        plain.push_str(&rest[..word]);
        rest = &rest[word..];
    }
    if !plain.is_empty() {
        pieces.push(Piece::Text(plain));
    }
    pieces
}

/// Code, a link or an escape at the beginning of `rest`, with its length.
fn fixed(rest: &str, shelves: &[Shelf]) -> Option<(String, usize)> {
    if let Some(escaped) = rest.strip_prefix('\\') {
        let length = 1 + escaped.chars().next()?.len_utf8();
        return Some((rest[..length].to_owned(), length));
    }
    if let Some(code) = rest.strip_prefix('`') {
        let length = code.find('`')? + 2;
        return Some((rest[..length].to_owned(), length));
    }
    if rest.starts_with("<http") {
        let length = rest.find('>')? + 1;
        return Some((rest[..length].to_owned(), length));
    }
    let inside = rest.strip_prefix('[')?;
    let (words, behind) = inside.split_once("](")?;
    let (target, _) = behind.split_once(')')?;
    let length = words.len() + target.len() + 4;
    (!words.contains(['[', ']'])).then(|| (link(words, target, shelves), length))
}

/// A variable at the beginning of `rest` as LaTeX: whether it has a script, and its length. `before` is the character that it
/// follows, `plain` the text.
fn variable(rest: &str, before: Option<char>, plain: &str) -> Option<(String, bool, usize)> {
    if before.is_some_and(|c| c.is_alphanumeric() || "'’_^".contains(c)) {
        return None;
    }
    if before == Some(')') && rest.starts_with('^') {
        let (script, length) = scripts(rest);
        return (length > 0).then(|| (format!("{{}}{script}"), true, length));
    }
    let length = rest.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(rest.len());
    let word = &rest[..length];
    let after = rest[length..].chars().next();
    let (script, scripts) = scripts(&rest[length..]);
    if rest.starts_with("D* ") || rest.starts_with("D*(") {
        return Some(("D^*".to_owned(), true, 2));
    }
    let scripted = scripts > 0;
    let tex = match word {
        "" => return None,
        _ if OPERATORS.contains(&word) => {
            let follows = rest[length + scripts..]
                .strip_prefix(' ')
                .is_some_and(|next| variable(next, None, "").is_some_and(|v| v.1));
            let article = plain.ends_with("the ") || plain.ends_with("a ") || plain.ends_with("The ");
            (scripted || follows && !article).then(|| format!("\\{word}{script} "))?
        }
        _ if GREEK.contains(&word) => format!("\\{word}{script}"),
        _ if FUNCTIONS.contains(&word) && (scripted || after == Some('(')) => format!("\\{word}{script}"),
        "log2" => format!("\\log_2{script}"),
        "L2" => format!("L_2{script}"),
        _ if PRODUCTS.contains(&word) => word.to_owned(),
        _ if word.bytes().all(|byte| byte.is_ascii_digit()) => scripted.then(|| format!("{word}{script}"))?,
        // A factor and a letter.
        _ if word.trim_start_matches(|c: char| c.is_ascii_digit()).len() == 1 && word.len() > 1 => {
            // But no decimal, and no power of ten.
            let number = before == Some('.') || word.ends_with('e') && rest[length..].starts_with('-');
            (!number && word.ends_with(|c: char| c.is_ascii_lowercase())).then(|| format!("{word}{script}"))?
        }
        _ => letter(word, &rest[length..], &script)?,
    };
    let operator = OPERATORS.contains(&word);
    Some((tex, scripted || operator, length + scripts))
}

/// A letter with its scripts as LaTeX, perhaps with an index of digits, or of a letter where a script follows; `after` stands behind it.
fn letter(word: &str, after: &str, script: &str) -> Option<String> {
    let (first, index) = word.split_at(1);
    let digits = !index.is_empty() && index.bytes().all(|byte| byte.is_ascii_digit());
    let scripted = !script.is_empty();
    // An article, a pronoun, initials and what ends in an apostrophe are words.
    let initial = after.starts_with('.') && first.chars().all(|c| c.is_ascii_uppercase());
    let article = word == "a" && !after.starts_with([',', ')']) && !after.starts_with(" +") && !after.starts_with(" =");
    let alone = !["A", "I"].contains(&word) && !article && !initial && !after.starts_with(['\'', '’']);
    match index {
        "" if scripted || alone => Some(format!("{first}{script}")),
        _ if digits && first.bytes().all(|byte| byte.is_ascii_lowercase()) => {
            Some(format!("{first}_{{{index}}}{script}"))
        }
        // As in `bd^kd`, where both letters have the same index.
        _ if scripted && index.len() == 1 => {
            Some(format!("{first}_{index}{}", script.replace(&format!("{{k{index}}}"), &format!("{{k_{index}}}"))))
        }
        _ => None,
    }
}

/// The scripts at the beginning of `rest` as LaTeX, with their length.
fn scripts(rest: &str) -> (String, usize) {
    let (mut tex, mut at) = (String::new(), 0);
    while let Some(sign) = rest[at..].chars().next().filter(|c| "_^".contains(*c)) {
        let Some((mut inside, mut length)) = script(&rest[at + 1..]) else { break };
        // An exponent with an index, as in `b^-k_j`.
        if let Some((index, more)) = rest[at + 1 + length..].strip_prefix('_').filter(|_| sign == '^').and_then(script)
        {
            inside = format!("{inside}_{{{index}}}");
            length += 1 + more;
        }
        tex.extend([sign.to_string(), format!("{{{inside}}}")]);
        at += 1 + length;
    }
    (tex, at)
}

/// What one script holds: a bracket, or letters and digits, perhaps negative.
fn script(rest: &str) -> Option<(String, usize)> {
    if rest.starts_with('(') {
        let mut depth = 0_usize;
        let end = rest.find(|c| {
            depth = depth + usize::from(c == '(') - usize::from(c == ')');
            depth == 0
        })?;
        let inside = &rest[1..end];
        return Some((within(inside), end + 1));
    }
    let minus = usize::from(rest.starts_with('-'));
    if minus == 1 && rest[1..].starts_with('(') {
        let (inside, length) = script(&rest[1..])?;
        return Some((format!("-({inside})"), length + 1));
    }
    let word = rest[minus..].find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(rest.len() - minus);
    let starred = word == 0 && rest.starts_with('*');
    let length = if starred { 1 } else { minus + word };
    (starred || word > 0).then(|| (within(&rest[..length]), length))
}

/// A formula within a script: letters behind which digits stand have them as an index.
fn within(text: &str) -> String {
    let mut out = String::new();
    let mut letter = false;
    for c in text.chars() {
        if letter && c.is_ascii_digit() {
            out.push('_');
        }
        letter = c.is_ascii_lowercase();
        out.push(c);
    }
    out
}

/// Joins variables over signs, numbers and brackets that close again.
fn joined(pieces: &[Piece]) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::new();
    let mut at = 0;
    // What the last formula took from the text behind it.
    let mut skip = 0;
    while let Some(piece) = pieces.get(at) {
        match piece {
            Piece::Math(..) => {
                let (tex, next, taken) = longest(pieces, at);
                out.push(Piece::Math(tex, false));
                (at, skip) = (next, taken);
            }
            Piece::Text(text) => {
                if text.len() > skip {
                    out.push(Piece::Text(text[skip..].to_owned()));
                }
                (at, skip) = (at + 1, 0);
            }
            Piece::Fixed(_) => {
                out.push(piece.clone());
                at += 1;
            }
        }
    }
    out
}

/// The longest formula from the variable at `from`: its LaTeX, the piece behind it, and how much of that piece it has taken.
fn longest(pieces: &[Piece], from: usize) -> (String, usize, usize) {
    let mut tex = String::new();
    let mut best = (String::new(), from + 1, 0);
    let mut at = from;
    let mut before = false;
    while let Some(Piece::Math(own, script)) = pieces.get(at) {
        tex.push_str(own);
        let text = match pieces.get(at + 1) {
            Some(Piece::Text(text)) => text.as_str(),
            _ => "",
        };
        // Brackets that close right behind, or behind a sign and a number, belong to the formula.
        for first in [0, tail(text)] {
            let closing = text[first..].chars().take_while(|c| *c == ')' || *c == '|').count();
            let closed = |end: &usize| depth(&format!("{tex}{}", &text[..*end])) == 0 && bars(&tex, &text[..*end]);
            if let Some(end) = (first..=first + closing).find(closed) {
                let end = end + tail(&text[end..]);
                best = (format!("{tex}{}", math_signs(&text[..end])), at + 1, end);
                break;
            }
        }
        let next_script = matches!(pieces.get(at + 2), Some(Piece::Math(_, true)));
        let product = text == " " && (*script || next_script || before || tex.contains(['=', '+']));
        let sign = text != " "
            && !text.is_empty()
            && text.chars().all(|c| c.is_ascii_digit() || " +-=/()|<>!×".contains(c))
            && text.trim() != "";
        let next_is_math = matches!(pieces.get(at + 2), Some(Piece::Math(..)));
        if !(next_is_math && (product || sign)) {
            break;
        }
        before = product;
        tex.push_str(&math_signs(text));
        at += 2;
    }
    best
}

/// How much of the text behind a formula belongs to it: a sign and a number, as ` - 1` or ` = 0`.
fn tail(text: &str) -> usize {
    // The value at a number, as in `p(0)`.
    if let Some((inside, behind)) = text.strip_prefix('(').and_then(|rest| rest.split_once(')'))
        && !inside.is_empty()
        && inside.bytes().all(|byte| byte.is_ascii_digit())
    {
        return inside.len() + 2 + tail(behind);
    }
    let trimmed = text.trim_start_matches(' ');
    let Some(rest) = trimmed.strip_prefix(['+', '-', '=', '/', '<', '>']) else { return 0 };
    let rest = rest.strip_prefix('=').unwrap_or(rest);
    let number = rest.trim_start_matches(' ');
    let digits = number.find(|c: char| !c.is_ascii_digit()).unwrap_or(number.len());
    let behind = number[digits..].chars().next();
    let listed = |rest: &str| rest.trim_start().starts_with(|c: char| c.is_ascii_digit());
    let goes_on = behind.is_some_and(|c| "/([".contains(c) || c.is_alphanumeric())
        || number[digits..]
            .strip_prefix('.')
            .is_some_and(|rest| rest.is_empty() || rest.starts_with(|c: char| c.is_ascii_digit() || c == '.'))
        || number[digits..].strip_prefix(',').is_some_and(listed);
    if digits == 0 || goes_on { 0 } else { text.len() - number.len() + digits }
}

/// Whether every bar has its other.
fn bars(tex: &str, more: &str) -> bool {
    (tex.matches('|').count() + more.matches('|').count()).is_multiple_of(2)
}

/// How many brackets are open.
fn depth(tex: &str) -> isize {
    let mut depth = 0;
    for c in tex.chars() {
        depth += isize::from(c == '(') - isize::from(c == ')');
        if depth < 0 {
            return depth;
        }
    }
    depth
}

/// Signs as LaTeX has them.
fn math_signs(text: &str) -> String {
    text.replace("<=", r" \le ")
        .replace(">=", r" \ge ")
        .replace('<', r" \lt ")
        .replace('>', r" \gt ")
        .replace('×', r"\times")
}

#[cfg(test)]
mod tests {
    use super::typeset;

    #[test]
    fn formulas_are_found_in_words() {
        for (text, expected) in [
            ("x_j = (c_j + u_j) / k_j, with c_j in 0..k", "$x_{j} = (c_{j} + u_{j}) / k_{j}$, with $c_{j}$ in 0..$k$"),
            ("falls like n^(-1-2/d) for smooth f", "falls like $n^{-1-2/d}$ for smooth $f$"),
            ("n = k^d. A cell, a (t, m, d)-net of Sobol's", "$n = k^{d}$. A cell, a ($t$, $m$, $d$)-net of Sobol's"),
            ("J. H. Halton and I", "J. H. Halton and I"),
            ("of b1^k1 ... bd^kd points", "of $b_{1}^{k_1}$ … $b_d^{k_d}$ points"),
            ("at most n / (n - 1) times 2.68e-4", "at most $n / (n - 1)$ times 2.68e-4"),
            ("with p(0) = 0, the (1 - 1/k)^d", "with $p(0) = 0$, the (1 − 1/$k$)${}^{d}$"),
            ("exp(-sum a_j |x_j - u_j|), n = 0, 1", "$\\exp(-\\sum  a_{j} |x_{j} - u_{j}|)$, $n$ = 0, 1"),
            ("the sum of x, b^-k_j", "the sum of $x$, $b^{-k_{j}}$"),
            ("x = 0.d_1 d_2 and D* <= 1", "$x$ = 0.$d_{1} d_{2}$ and $D^*  \\le  1$"),
            ("Phi_2(i) is `x_j`", "$\\Phi_{2}(i)$ is `x_j`"),
        ] {
            assert_eq!(typeset(text, &[]), expected, "{text}");
        }
    }
}
