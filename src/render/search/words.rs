//! Text for the search: words as they are compared, and what a title says without its marks.

use pulldown_cmark::Event;

use crate::parse::{Node, What};

/// The words of a text: runs of letters and digits in lower case, without accents.
pub(super) fn of(text: &str) -> impl Iterator<Item = String> {
    // An apostrophe within a word is none of its letters: Sobol’s is found by sobol.
    let words = text.split(|c: char| !c.is_alphanumeric());
    words.filter(|word| !word.is_empty()).map(folded)
}

fn folded(word: &str) -> String {
    let mut out = String::with_capacity(word.len());
    for c in word.chars().flat_map(char::to_lowercase) {
        match c {
            'à'..='å' | 'ā' | 'ă' | 'ą' => out.push('a'),
            'æ' => out.push_str("ae"),
            'ç' | 'ć' | 'č' => out.push('c'),
            'ď' | 'đ' => out.push('d'),
            'è'..='ë' | 'ē' | 'ė' | 'ę' | 'ě' => out.push('e'),
            'ğ' => out.push('g'),
            'ì'..='ï' | 'ī' | 'ı' => out.push('i'),
            'ł' => out.push('l'),
            'ñ' | 'ń' | 'ň' => out.push('n'),
            'ò'..='ö' | 'ø' | 'ō' | 'ő' => out.push('o'),
            'œ' => out.push_str("oe"),
            'ř' => out.push('r'),
            'ś' | 'š' | 'ş' => out.push('s'),
            'ß' => out.push_str("ss"),
            'ť' | 'ţ' => out.push('t'),
            'ù'..='ü' | 'ū' | 'ů' | 'ű' => out.push('u'),
            'ý' | 'ÿ' => out.push('y'),
            'ź' | 'ż' | 'ž' => out.push('z'),
            // What stands over a letter, written as a character of its own.
            '\u{300}'..='\u{36f}' => {}
            c => out.push(c),
        }
    }
    out
}

/// What nodes say, on one line: formulas in plain characters, all else as `html` writes it, without tags.
pub(super) fn plain(nodes: &[Node], html: &dyn Fn(&Node) -> String) -> String {
    let mut text = String::new();
    for node in nodes {
        match &node.what {
            What::Markdown(Event::Text(words) | Event::Code(words)) => text.push_str(words),
            What::Markdown(Event::SoftBreak | Event::HardBreak | Event::End(_)) => text.push(' '),
            What::Markdown(_) => {}
            What::Formula(formula) | What::Equation { formula, .. } => text.push_str(&spoken(&formula.tex)),
            What::Term(term) => text.push_str(&plain(&term.words, html)),
            _ => text.push_str(&without_tags(&html(node))),
        }
    }
    // The end of an emphasis is no space before a comma.
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    [" ,", " .", " ;", " :", " )", " ’"].iter().fold(text, |text, mark| text.replace(mark, mark.trim_start()))
}

/// The text cut after a word, with dots, if it has more characters than `most`.
pub(super) fn shortened(text: &str, most: usize) -> String {
    let Some((end, _)) = text.char_indices().nth(most) else { return text.to_owned() };
    let cut = text[..end].rfind(' ').unwrap_or(end);
    format!("{}…", text[..cut].trim_end_matches([',', ';', ':', '.', ' ']))
}

fn without_tags(html: &str) -> String {
    let mut text = String::new();
    let mut rest = html;
    while let Some((before, tag)) = rest.split_once('<') {
        text.push_str(before);
        rest = tag.split_once('>').map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

/// Commands of LaTeX that are one character.
const SIGNS: &[(&str, &str)] = &[
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("varepsilon", "ε"),
    ("eta", "η"),
    ("theta", "θ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("varphi", "φ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("Delta", "Δ"),
    ("le", "≤"),
    ("leq", "≤"),
    ("ge", "≥"),
    ("geq", "≥"),
    ("ne", "≠"),
    ("approx", "≈"),
    ("sim", "~"),
    ("to", "→"),
    ("infty", "∞"),
    ("in", "∈"),
    ("cdot", "·"),
    ("times", "×"),
    ("dots", "…"),
    ("ldots", "…"),
    ("cdots", "…"),
    ("pm", "±"),
    ("sqrt", "√"),
    ("sum", "∑"),
    ("int", "∫"),
    ("prod", "∏"),
    ("ast", "*"),
    ("lVert", "‖"),
    ("rVert", "‖"),
];
/// Commands that say how something looks.
const SILENT: &[&str] = &[
    "left",
    "right",
    "quad",
    "qquad",
    "mathrm",
    "text",
    "operatorname",
    "mathbb",
    "mathcal",
    "mathbf",
    "displaystyle",
    "frac",
    "tfrac",
    "dfrac",
    "big",
    "Big",
    "bar",
    "hat",
    "tilde",
    "overline",
];

/// A formula in plain characters, to be recognised rather than read.
fn spoken(tex: &str) -> String {
    let mut out = String::new();
    let mut rest = tex;
    let mut fractions = 0_usize;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        match c {
            '\\' => {
                let length = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
                let (name, after) = rest.split_at(length);
                // Spaces and the like are one character.
                rest = if name.is_empty() { &rest[rest.chars().next().map_or(0, char::len_utf8)..] } else { after };
                fractions += usize::from(name.ends_with("frac"));
                match SIGNS.iter().find(|(known, _)| *known == name) {
                    Some((_, sign)) => out.push_str(sign),
                    None if SILENT.contains(&name) => {}
                    None => out.push_str(name),
                }
            }
            '}' if fractions > 0 && rest.starts_with('{') => {
                fractions -= 1;
                out.push('/');
            }
            '{' | '}' | '_' | '&' => {}
            '^' if rest.starts_with(['*', '\'']) => {}
            '~' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_folded() {
        let found: Vec<String> = of("Sobol’s Poincaré–Grünschloß, (0,2)-nets L2* ΦB").collect();
        assert_eq!(found, ["sobol", "s", "poincare", "grunschloss", "0", "2", "nets", "l2", "φb"]);
    }

    #[test]
    fn formulas_are_recognised() {
        for (tex, text) in [
            (r"N^{-3/2}", "N^-3/2"),
            (r"D^*_N \le \frac{1}{2}", "D*N ≤ 1/2"),
            (r"e^{\sin 3x^2}", "e^sin 3x^2"),
            (r"O(1/\sqrt{N})", "O(1/√N)"),
            (r"\left[a,\,b\right)", "[a,b)"),
            ("\\", ""),
        ] {
            assert_eq!(spoken(tex), text);
        }
    }

    #[test]
    fn tags_go_and_long_texts_are_cut_after_a_word() {
        assert_eq!(without_tags("a <b class=\"x\">c</b> &amp;lt; d<"), "a c &lt; d");
        assert_eq!(shortened("one two, three", 9), "one two…");
        assert_eq!(shortened("one", 9), "one");
        assert_eq!(shortened("éééééééééééé", 3), "ééé…");
    }
}
