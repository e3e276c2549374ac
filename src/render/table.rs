//! Tables as HTML: heads with scopes, numerals aligned, formulas as MathML.

use std::fmt::Write as _;

use crate::chart::{Align, Cell, Table};
use crate::plan::{Converter, escape};

/// From so many columns on a table has less space between them.
const MANY: usize = 9;

/// How a cell opens and closes that heads nothing: an empty head would be read as one without a name.
const PLAIN: (&str, &str) = ("td", "td");

/// A table's HTML.
pub(super) fn html(table: &Table, converter: &Converter) -> String {
    // Many columns stand closer.
    let class_of_all = if table.columns.len() >= MANY { "data many" } else { "data" };
    let mut out = format!("<div class=\"table-wrap\"><table class=\"{class_of_all}\">\n<thead><tr>");
    for (index, column) in table.columns.iter().enumerate() {
        let words = prose(&column.head, converter);
        let (open, close) = if words.is_empty() { PLAIN } else { ("th scope=\"col\"", "th") };
        let _ = write!(out, "<{open}{}>{words}</{close}>", class(column.align, has_numbers(table, index)));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
    let body = table.rows.len().saturating_sub(table.footers);
    rows(&table.rows[..body], table, converter, &mut out);
    out.push_str("</tbody>\n");
    if table.footers > 0 {
        out.push_str("<tfoot>\n");
        rows(&table.rows[body..], table, converter, &mut out);
        out.push_str("</tfoot>\n");
    }
    out.push_str("</table></div>\n");
    out
}

fn rows(rows: &[Vec<Cell>], table: &Table, converter: &Converter, out: &mut String) {
    for row in rows {
        out.push_str("<tr>");
        for (index, (cell, column)) in row.iter().zip(&table.columns).enumerate() {
            let words = content(cell, converter);
            let heads = index < table.row_heads && !words.is_empty();
            let (open, close) = if heads { ("th scope=\"row\"", "th") } else { PLAIN };
            let _ = write!(out, "<{open}{}>{words}</{close}>", class(column.align, cell.is_number()));
        }
        out.push_str("</tr>\n");
    }
}

/// Whether a column has numbers and nothing else: its head stands above them.
fn has_numbers(table: &Table, index: usize) -> bool {
    let mut cells = table.rows.iter().filter_map(|row| row.get(index)).filter(|cell| !cell.printed().is_empty());
    let first = cells.next();
    first.is_some_and(Cell::is_number) && cells.all(Cell::is_number)
}

fn class(align: Align, number: bool) -> &'static str {
    match (align, number) {
        (Align::Right, _) | (_, true) => " class=\"number\"",
        (Align::Centre, _) => " class=\"center\"",
        (Align::Left, _) => "",
    }
}

fn content(cell: &Cell, converter: &Converter) -> String {
    match cell {
        Cell::Math(tex) => formula(tex, converter),
        Cell::Code(code) => format!("<code>{}</code>", escape(code)),
        Cell::Text(text) => prose(text, converter),
        Cell::Holds { holds, text } => {
            let class = if *holds { "holds" } else { "fails" };
            format!("<span class=\"{class}\">{}</span>", escape(text))
        }
        cell => escape(&cell.printed()),
    }
}

/// Plain words with LaTeX between dollars.
pub(super) fn prose(text: &str, converter: &Converter) -> String {
    let mut out = String::new();
    for (index, part) in text.split('$').enumerate() {
        // Apostrophes are printed; the primes of formulas are not theirs.
        let printed = || escape(&part.replace('\'', "’"));
        out.push_str(&if index % 2 == 0 { printed() } else { formula(part, converter) });
    }
    out
}

/// A formula of a kind's own; one that cannot be read is shown as it is written.
fn formula(tex: &str, converter: &Converter) -> String {
    converter.convert(tex, false).unwrap_or_else(|_| format!("<code>{}</code>", escape(tex)))
}
