//! Pictures as HTML: side by side, at whole pixels, each a file of the book.

use std::fmt::Write as _;

use super::{data, table};
use crate::chart::Pictures;
use crate::plan::{Converter, escape};

/// The HTML of an exhibit's pictures. The script adds the view that flips between them.
pub(super) fn html(id: &str, pictures: &Pictures, converter: &Converter) -> String {
    let mut out = format!("<div class=\"pictures\" style=\"--zoom: {}\">\n", pictures.zoom);
    for (index, picture) in pictures.items.iter().enumerate() {
        let (path, png) = (data::png_path(id, index, &picture.name), &picture.png);
        let title = table::prose(&picture.title, converter);
        // Writing to a string cannot fail.
        let _ = write!(
            out,
            "<figure class=\"picture\" style=\"--pixels: {}px\"><img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" decoding=\"async\"><figcaption><span class=\"title\">{title}</span>",
            png.width,
            escape(&path),
            escape(&picture.alt),
            png.width,
            png.height,
        );
        if let Some(note) = &picture.note {
            let _ = write!(out, " <span class=\"note\">{}</span>", table::prose(note, converter));
        }
        out.push_str("</figcaption></figure>\n");
    }
    out.push_str("</div>\n");
    if let Some(chart) = &pictures.chart {
        out.push_str(&chart.svg);
    }
    out
}
