//! Pictures made of pixels: several of them beside each other, to be compared.

use crate::raster::Png;

/// A picture with its words.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Its part in the names of files, e.g. the method: unique among the pictures of one exhibit.
    pub name: String,
    /// Plain words, with LaTeX between dollars.
    pub title: String,
    /// What was measured of it, e.g. `RMSE 0.013`; plain words, with LaTeX between dollars.
    pub note: Option<String>,
    /// What there is to see, for who cannot see it.
    pub alt: String,
    /// The pixels.
    pub png: Png,
}

impl Picture {
    /// A picture without a note.
    pub fn new(name: impl Into<String>, title: impl Into<String>, alt: impl Into<String>, png: Png) -> Self {
        Self { name: name.into(), title: title.into(), note: None, alt: alt.into(), png }
    }

    /// With what was measured of it.
    #[must_use]
    pub fn note(self, note: impl Into<String>) -> Self {
        Self { note: Some(note.into()), ..self }
    }
}

/// Pictures side by side, which a reader can also flip between.
#[derive(Debug, Clone, PartialEq)]
pub struct Pictures {
    /// The pictures, in the order shown.
    pub items: Vec<Picture>,
    /// How many pixels of the screen each pixel of a picture takes along an axis.
    pub zoom: u32,
    /// A chart below the pictures, e.g. of what was measured.
    pub chart: Option<super::Figure>,
}

impl Pictures {
    /// Pictures at their own size.
    pub fn new(items: Vec<Picture>) -> Self {
        Self { items, zoom: 1, chart: None }
    }

    /// Everything of them that a reader can see, as text; the pixels in Base64.
    pub fn text(&self) -> String {
        let mut text = format!("zoom {}\n", self.zoom);
        for Picture { name, title, note, alt, png } in &self.items {
            let note = note.as_deref().unwrap_or_default();
            text.extend([name, "\t", title, "\t", note, "\t", alt, "\t", &png.base64(), "\n"]);
        }
        text + self.chart.as_ref().map_or("", |chart| &chart.svg)
    }

    /// With each pixel so many times as large.
    #[must_use]
    pub fn zoom(self, zoom: u32) -> Self {
        Self { zoom: zoom.max(1), ..self }
    }

    /// With a chart below.
    #[must_use]
    pub fn chart(self, chart: super::Figure) -> Self {
        Self { chart: Some(chart), ..self }
    }
}
