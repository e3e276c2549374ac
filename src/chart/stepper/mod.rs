//! Figures that a reader steps through: frames drawn by the same kit, merged into one SVG that stores changes, not frames.
//!
//! Every frame is drawn by itself; an element that is the same in several frames is written once. What is not in all of them
//! stands in a group `<g data-steps="1-3,7">` that names the steps, counted from 1, in which it is seen. A tracked element
//! (`Marks::tracked`, `Note::tracked`) is written once with the places to which it moves: `data-at="1 10 20,5 30 20"` is
//! (10, 20) from step 1 and (30, 20) from step 5 on. The SVG by itself shows the last frame, and a script any other.

mod merge;

use super::{Chart, ChartError, Figure, Sheet};

/// A frame of a stepper that is not yet drawn.
#[derive(Debug, Clone)]
struct Step {
    chart: Chart,
    caption: String,
}

/// The frames of a stepper, in order. All charts must have the same layout: fixed ranges, the same titles.
#[derive(Debug, Clone)]
pub struct Steps {
    frames: Vec<Step>,
    key: Vec<usize>,
    small: f64,
}

/// A stepper as it is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Stepper {
    /// All frames in one SVG, which shows the last.
    pub figure: Figure,
    /// What each step shows: plain words, with LaTeX between dollars.
    pub captions: Vec<String>,
    /// Small drawings of key steps before the last, for paper and for readers without a script.
    pub strip: Vec<KeyStep>,
}

/// A key step.
#[derive(Debug, Clone, PartialEq)]
pub struct KeyStep {
    /// The step, counted from 1.
    pub step: usize,
    /// The frame as a small drawing.
    pub figure: Figure,
}

/// The most steps: more would be a film.
pub const MOST_STEPS: usize = 128;

impl Default for Steps {
    fn default() -> Self {
        Self::new()
    }
}

impl Steps {
    /// No step yet.
    pub fn new() -> Self {
        Self { frames: Vec::new(), key: Vec::new(), small: 190.0 }
    }

    /// Adds a step with its caption: plain words, with LaTeX between dollars.
    pub fn push(&mut self, chart: Chart, caption: impl Into<String>) {
        self.frames.push(Step { chart, caption: caption.into() });
    }

    /// The number of steps so far.
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    /// Whether there is no step.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// With these key steps, counted from 1; otherwise the first, one after a third and one after two thirds.
    #[must_use]
    pub fn key_steps(mut self, key: impl IntoIterator<Item = usize>) -> Self {
        self.key = key.into_iter().collect();
        self
    }

    /// With key steps drawn this wide, in units.
    #[must_use]
    pub fn small(mut self, width: f64) -> Self {
        self.small = width;
        self
    }

    /// The stepper on `sheet`.
    pub fn draw(&self, sheet: &Sheet) -> Result<Stepper, ChartError> {
        if self.frames.len() > MOST_STEPS {
            let message = format!("{} steps are more than a stepper's {MOST_STEPS}", self.frames.len());
            return Err(ChartError::Drawing(message));
        }
        let frames: Vec<Figure> =
            self.frames.iter().map(|step| step.chart.draw(sheet)).collect::<Result<_, ChartError>>()?;
        let Some(last) = frames.last() else { return Err(ChartError::NoPanel) };
        if let Some(at) = frames.iter().position(|frame| (frame.width, frame.height) != (last.width, last.height)) {
            return Err(ChartError::Drawing(format!("step {} has another size than the last", at + 1)));
        }
        let svgs: Vec<&str> = frames.iter().map(|frame| frame.svg.as_str()).collect();
        let figure = Figure { svg: merge::merged(&svgs), width: last.width, height: last.height };
        let captions = self.frames.iter().map(|step| step.caption.clone()).collect();
        Ok(Stepper { figure, captions, strip: self.strip(sheet)? })
    }

    fn strip(&self, sheet: &Sheet) -> Result<Vec<KeyStep>, ChartError> {
        let count = self.frames.len();
        let thirds = [1, count / 3 + 1, 2 * count / 3 + 1];
        let mut key = if self.key.is_empty() { thirds.to_vec() } else { self.key.clone() };
        key.sort_unstable();
        key.dedup();
        let drawn = key.into_iter().filter_map(|step| {
            // The last step is the figure itself.
            let frame = self.frames.get(step.checked_sub(1)?).filter(|_| step < count)?;
            let sheet = Sheet {
                id: format!("{}-step-{step}", sheet.id),
                title: format!("Step {step} of {count}"),
                description: String::new(),
                width: self.small,
            };
            let figure = frame.chart.clone().still().draw(&sheet);
            let figure = figure.map(|figure| Figure { svg: merge::joined(&figure.svg), ..figure });
            Some(figure.map(|figure| KeyStep { step, figure }))
        });
        drawn.collect()
    }
}

impl Stepper {
    /// Everything of it that a reader can see, as text.
    pub fn text(&self) -> String {
        let strip = self.strip.iter().map(|key| key.figure.svg.as_str());
        let captions = self.captions.iter().map(String::as_str);
        std::iter::once(self.figure.svg.as_str()).chain(captions).chain(strip).collect::<Vec<_>>().join("\n")
    }
}

#[cfg(test)]
mod tests;
