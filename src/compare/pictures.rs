//! Drawings next to each other, and where pictures of pixels differ.

use base64::Engine as _;
use image::{ImageFormat, RgbaImage};
use serde::Serialize;

use super::record::Record;
use super::{Side, differing};
use crate::raster::Raster;
use crate::workspace::extension;

/// The most drawings of one exhibit that are shown: those of steps are many.
const MOST: usize = 6;

/// A drawing in the one book and in the other, each as an address that holds it.
#[derive(Debug, Clone, Serialize)]
pub struct Picture {
    /// The file.
    pub path: String,
    /// Whether it is of lines, so that one can be laid over the other.
    pub vector: bool,
    /// The old drawing, if there is one.
    pub old: Option<String>,
    /// The new drawing, if there is one.
    pub new: Option<String>,
    /// Where the pixels differ, made as bright as can be.
    pub difference: Option<String>,
    /// How much they differ, in words; may be empty.
    pub note: String,
}

/// The drawings of an exhibit that differ, and how many more do.
pub(super) fn differing_of((was, old): (&Record, &Side), (is, new): (&Record, &Side)) -> (Vec<Picture>, usize) {
    let paths = differing(was, is, old, new, &["svg", "png"]);
    let shown = paths.iter().take(MOST).map(|path| picture(path, Some(old), Some(new)));
    (shown.collect(), paths.len().saturating_sub(MOST))
}

/// The drawings of an exhibit that only one book has, and how many more there are.
pub(super) fn of_one(record: &Record, side: &Side, new: bool) -> (Vec<Picture>, usize) {
    let drawn = |path: &&String| matches!(extension(path), Some("svg" | "png"));
    let paths: Vec<&String> = record.files.iter().filter(drawn).collect();
    let sides = if new { (None, Some(side)) } else { (Some(side), None) };
    let shown = paths.iter().take(MOST).map(|path| picture(path, sides.0, sides.1));
    (shown.collect(), paths.len().saturating_sub(MOST))
}

fn picture(path: &str, old: Option<&Side>, new: Option<&Side>) -> Picture {
    let vector = extension(path) == Some("svg");
    let bytes = |side: Option<&Side>| side.and_then(|side| side.files.get(path)).cloned();
    let (old, new) = (bytes(old), bytes(new));
    let (difference, note) = match (&old, &new) {
        (Some(old), Some(new)) if !vector => compared(old, new),
        _ => (None, String::new()),
    };
    let kind = if vector { "svg+xml" } else { "png" };
    let address =
        |bytes: Vec<u8>| format!("data:image/{kind};base64,{}", base64::prelude::BASE64_STANDARD.encode(bytes));
    Picture {
        path: path.to_owned(),
        vector,
        old: old.map(address),
        new: new.map(address),
        difference: difference
            .map(|bytes| format!("data:image/png;base64,{}", base64::prelude::BASE64_STANDARD.encode(bytes))),
        note,
    }
}

/// Where two pictures differ, as a picture, and how much.
fn compared(old: &[u8], new: &[u8]) -> (Option<Vec<u8>>, String) {
    let read =
        |bytes: &[u8]| image::load_from_memory_with_format(bytes, ImageFormat::Png).map(|image| image.to_rgba8());
    let (Ok(old), Ok(new)) = (read(old), read(new)) else { return (None, "a picture cannot be read".to_owned()) };
    if old.dimensions() != new.dimensions() {
        let size = |image: &RgbaImage| format!("{} x {}", image.width(), image.height());
        return (None, format!("the sizes differ: {} and {} pixels", size(&old), size(&new)));
    }
    let apart: Vec<[u8; 3]> =
        old.pixels().zip(new.pixels()).map(|(old, new)| [0, 1, 2].map(|at| old.0[at].abs_diff(new.0[at]))).collect();
    let largest = apart.iter().flatten().copied().max().unwrap_or(0);
    let count = apart.iter().filter(|pixel| pixel.iter().any(|channel| *channel > 0)).count();
    if largest == 0 {
        return (None, "the pixels are the same; only the files differ".to_owned());
    }
    let bright = |channel: &u8| (u32::from(*channel) * 255 / u32::from(largest)) as u8;
    let pixels = apart.iter().flatten().map(bright).collect();
    let share = 100.0 * count as f64 / apart.len() as f64;
    let note = format!("{count} of {} pixels differ ({share:.2} %), by at most {largest} of 255", apart.len());
    (Raster::colour(old.width(), old.height(), pixels).png().ok().map(|png| png.bytes), note)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_that_differ_are_counted_and_made_bright() {
        let png = |pixels: Vec<u8>| Raster::grey(2, 2, pixels).png().unwrap().bytes;
        let (difference, note) = compared(&png(vec![0, 10, 20, 30]), &png(vec![0, 10, 25, 40]));
        assert_eq!(note, "2 of 4 pixels differ (50.00 %), by at most 10 of 255");
        let shown = image::load_from_memory(&difference.unwrap()).unwrap().to_luma8().into_raw();
        assert_eq!(shown, [0, 0, 127, 255]);
        assert!(compared(&png(vec![1; 4]), &png(vec![1; 4])).1.contains("only the files differ"));
        assert!(compared(b"no picture", &png(vec![1; 4])).1.contains("cannot be read"));
        let other = Raster::grey(4, 1, vec![0; 4]).png().unwrap().bytes;
        assert_eq!(compared(&png(vec![0; 4]), &other).1, "the sizes differ: 2 x 2 and 4 x 1 pixels");
    }
}
