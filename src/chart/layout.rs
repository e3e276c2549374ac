//! Where everything goes: the key, the panels in their grid, and the room for their labels.

use super::draw::{self, Page};
use super::geometry::Window;
use super::legend::{self, Entry};
use super::resolve::{self, Extent};
use super::ticks::Tick;
use super::{Chart, ChartError, Figure, Key, Layer, Panel, Rich, Sheet, backend, path};

/// Where a panel's axes stand, in hundredths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rect {
    pub left: i32,
    pub top: i32,
    pub right: i32,
    pub bottom: i32,
}

/// A panel with its place.
#[derive(Debug)]
pub(super) struct Plot<'a> {
    pub panel: &'a Panel,
    pub index: usize,
    pub rect: Rect,
    pub window: Window,
    pub x_ticks: Vec<Tick>,
    pub y_ticks: Vec<Tick>,
    /// Whether the labels of the axes are shown: in small multiples only at the outer edges.
    pub labelled: (bool, bool),
    /// The title in lines that fit.
    pub title: Vec<Rich>,
    /// The top of the title, and the left edge of the cell, in units.
    pub head: (f64, f64),
    pub extent: Extent,
    /// Whether names stand at the ends of lines.
    pub direct: bool,
    /// Whether the names of horizontal rules stand at their ends, beyond the axes.
    pub ruled: bool,
}

/// The least width of a plot that still says something, in units.
const NARROWEST: f64 = 56.0;
/// The space between columns, and below rows.
const GAP: f64 = 16.0;

/// Sizes common to all panels, in units.
struct Frame {
    columns: usize,
    /// Room for y labels: in the first column, in the others.
    left: (f64, f64),
    /// Room at the right of each column.
    right: f64,
    /// The width of a plot.
    width: f64,
    /// Lines of the longest title.
    lines: usize,
    /// Titles and the y axes' titles.
    head: f64,
    /// Room for x labels where they are shown.
    foot: f64,
}

/// The figure of `chart`.
pub(super) fn draw(chart: &Chart, sheet: &Sheet) -> Result<Figure, ChartError> {
    if chart.panels.is_empty() {
        return Err(ChartError::NoPanel);
    }
    if !(sheet.width >= 120.0 && sheet.width <= 4000.0) {
        return Err(ChartError::Narrow { width: sheet.width, needed: 120.0 });
    }
    let (extents, windows) = windows(chart)?;
    let (direct, room) = direct(chart, sheet.width);
    let frame = Frame::new(chart, &windows, sheet.width, room)?;
    let key = if direct || chart.key == Key::Hidden { Vec::new() } else { legend::entries(chart) };
    let left = frame.left.0;
    let cells = Cells { chart, frame, extents: &extents, windows: &windows, direct, ruled: room.is_some() };
    if let Some((keyed, plots, height)) = cells.keyed_in_hole(&key, sheet.width) {
        return write(sheet, &plots, &keyed, height);
    }
    let rows = legend::rows(key, sheet.width - left);
    let (plots, height) = cells.place(sheet.width, legend::height(&rows));
    let left = plots.first().map_or(0.0, |plot| f64::from(plot.rect.left) / backend::UNIT);
    write(sheet, &plots, &Keyed { rows, at: (left, 0.0), right: sheet.width }, height)
}

/// The key with its place.
struct Keyed {
    rows: Vec<Vec<Entry>>,
    /// Its left upper corner, in units.
    at: (f64, f64),
    /// How far it may reach.
    right: f64,
}

/// The extents and windows of the panels, shared where they should be.
fn windows(chart: &Chart) -> Result<(Vec<Extent>, Vec<Window>), ChartError> {
    let extents: Vec<Extent> = chart.panels.iter().map(Extent::of).collect();
    let all = extents.iter().copied().fold(Extent::default(), Extent::union);
    let mut windows = Vec::with_capacity(extents.len());
    for (index, (panel, extent)) in chart.panels.iter().zip(&extents).enumerate() {
        resolve::check(panel)?;
        if extent.drawable == 0 {
            return Err(ChartError::Empty { panel: index });
        }
        windows.push(if chart.shared { extent.union(all) } else { *extent }.window(panel, index)?);
    }
    Ok((extents, windows))
}

/// Whether names stand at the ends of lines, and the room that they and the names of rules need at the right.
fn direct(chart: &Chart, width: f64) -> (bool, Option<f64>) {
    let ([panel], false) = (&chart.panels[..], chart.key == Key::Hidden) else { return (false, None) };
    let (mut lines, mut rules) = (Vec::new(), Vec::new());
    let mut others = chart.key != Key::Auto;
    for layer in &panel.layers {
        match layer {
            Layer::Line(line) => lines.extend(line.label.as_ref().map(Rich::width)),
            Layer::Rule(rule) if !rule.vertical => rules.extend(rule.label.as_ref().map(Rich::width)),
            Layer::Marks(super::Marks { label: Some(_), .. })
            | Layer::Bars(super::Bars { label: Some(_), .. })
            | Layer::Band(super::Band { label: Some(_), .. })
            | Layer::Area(super::Area { label: Some(_), .. })
            | Layer::ErrorBars(super::ErrorBars { label: Some(_), .. })
            | Layer::Boxes(super::Boxes { label: Some(_), .. })
            | Layer::Disks(super::Disks { label: Some(_), .. })
            | Layer::Segments(super::Segments { label: Some(_), .. }) => others = true,
            _ => {}
        }
    }
    let fit = |widths: &[f64]| widths.len() <= 10 && widths.iter().all(|&name| name < 0.3 * width);
    let room = |widths: &[f64]| widths.iter().copied().reduce(f64::max).map(|widest| widest + 22.0);
    let all = [&lines[..], &rules].concat();
    if !others && !lines.is_empty() && fit(&all) {
        return (true, room(&all));
    }
    (false, if fit(&rules) { room(&rules) } else { None })
}

/// The room that the words at the ends of lines need at the right.
fn tails(chart: &Chart) -> f64 {
    let tail = |layer: &Layer| match layer {
        Layer::Line(line) => line.tail.as_ref().map(|words| words.width() + 22.0),
        _ => None,
    };
    chart.panels.iter().flat_map(|panel| &panel.layers).filter_map(tail).fold(0.0, f64::max)
}

/// About how many labels fit on `length` units.
fn label_count(length: f64, each: f64) -> usize {
    ((length / each).floor() as usize).clamp(2, 8)
}

impl Frame {
    fn new(chart: &Chart, windows: &[Window], sheet: f64, direct: Option<f64>) -> Result<Self, ChartError> {
        let panels = &chart.panels;
        let square = panels.iter().all(|panel| panel.square);
        let joined = chart.shared || square;
        let columns = chart.columns.unwrap_or(match (panels.len(), joined) {
            (1, _) => 1,
            (2 | 4, _) | (_, false) => 2,
            _ => 3,
        });
        let columns = columns.min(panels.len());
        let guess = (sheet / columns as f64 - 40.0).max(NARROWEST);
        let widest = |(panel, window): (&Panel, &Window)| {
            let ticks = panel.y.ticks(window.y, label_count(guess * ratio(panel, window, columns), 44.0));
            let labels = ticks.iter().filter_map(|tick| tick.label.as_ref());
            if panel.y.hidden { 0.0 } else { labels.map(|label| label.width() + 10.0).fold(0.0, f64::max) }
        };
        let left = panels.iter().zip(windows).map(widest).fold(2.0, f64::max);
        let left = (left, if joined { 2.0 } else { left });
        let rug = if panels.iter().any(|panel| panel.rug) { draw::RUG } else { 4.0 };
        let right = direct.unwrap_or(if square { rug } else { 14.0 }).max(tails(chart));
        let others = (columns - 1) as f64;
        let room = sheet - left.0 - left.1 * others - right * columns as f64 - GAP * others;
        let mut width = room / columns as f64;
        if width < NARROWEST {
            let needed = sheet + (NARROWEST - width) * columns as f64;
            return Err(ChartError::Narrow { width: sheet, needed: needed.ceil() });
        }
        for (panel, window) in panels.iter().zip(windows) {
            // No plot is higher than a hand, whatever its aspect.
            let tallest = if panel.equal && columns == 1 { 360.0 } else { 440.0 };
            width = width.min(tallest / ratio(panel, window, columns)).max(NARROWEST);
        }
        let any = |has: fn(&Panel) -> bool| panels.iter().any(has);
        let lines = panels.iter().map(|panel| titled(panel, width).len()).max().unwrap_or(0);
        let head = if lines > 0 { 22.0 + draw::TITLE * (lines - 1) as f64 } else { 0.0 }
            + if any(|p| p.rug) { draw::RUG - 2.0 } else { 0.0 }
            + if any(|p| !p.y.title.is_empty()) { 22.0 } else { 0.0 };
        let foot =
            if any(|p| !p.x.hidden) { 24.0 } else { 2.0 } + if any(|p| !p.x.title.is_empty()) { 20.0 } else { 0.0 };
        Ok(Self { columns, left, right, width, lines, head: head + 8.0, foot })
    }
}

/// The title of a panel in lines no wider than the plot and the space beside it.
fn titled(panel: &Panel, width: f64) -> Vec<Rich> {
    panel.title.iter().flat_map(|title| title.wrapped((width + GAP - 4.0) * BOLD)).collect()
}

/// Bold letters are wider than the widths of labels.
const BOLD: f64 = 0.95;

/// How many times a plot is as high as wide.
fn ratio(panel: &Panel, window: &Window, columns: usize) -> f64 {
    if panel.equal {
        return ((window.y.1 - window.y.0) / (window.x.1 - window.x.0)).clamp(0.05, 20.0);
    }
    panel.ratio.unwrap_or(if columns == 1 { 0.58 } else { 0.78 }).clamp(0.05, 20.0)
}

/// What is needed to place the panels.
struct Cells<'a> {
    chart: &'a Chart,
    frame: Frame,
    extents: &'a [Extent],
    windows: &'a [Window],
    direct: bool,
    ruled: bool,
}

impl<'a> Cells<'a> {
    /// Places the panels below a key of height `top`; also the height of the sheet.
    fn place(&self, sheet: f64, top: f64) -> (Vec<Plot<'a>>, f64) {
        let (frame, panels) = (&self.frame, &self.chart.panels);
        let others = (frame.columns - 1) as f64;
        let used = frame.left.0 + frame.left.1 * others + (frame.width + frame.right) * (others + 1.0) + GAP * others;
        let margin = ((sheet - used) / 2.0).max(0.0);
        let mut plots: Vec<Plot<'a>> = Vec::with_capacity(panels.len());
        let mut y = top;
        for row in panels.chunks(frame.columns) {
            let (mut bottom, mut foot) = (y, 4.0_f64);
            for _ in row {
                let plot = self.plot(plots.len(), margin, y);
                let shown = if plot.labelled.0 { frame.foot } else { 4.0 };
                foot = foot.max(shown + if plot.extent.told().is_some() { 20.0 } else { 0.0 });
                bottom = bottom.max(f64::from(plot.rect.bottom) / backend::UNIT);
                plots.push(plot);
            }
            y = bottom + foot + if plots.len() < panels.len() { GAP } else { 2.0 };
        }
        (plots, y)
    }

    /// The key in the place that the last of several rows of panels leaves free, if it fits there; it takes no room above then.
    fn keyed_in_hole(&self, key: &[Entry], sheet: f64) -> Option<(Keyed, Vec<Plot<'a>>, f64)> {
        let (columns, panels) = (self.frame.columns, self.chart.panels.len());
        if key.is_empty() || self.chart.key != Key::Auto || panels < columns || panels.is_multiple_of(columns) {
            return None;
        }
        let (plots, height) = self.place(sheet, 0.0);
        let last = plots.last()?;
        let unit = |hundredths: i32| f64::from(hundredths) / backend::UNIT;
        // Where the next panel would stand, up to the right edge of the last column.
        let left = unit(last.rect.right) + self.frame.right + GAP + self.frame.left.1.min(12.0);
        let width = unit(plots.iter().map(|plot| plot.rect.right).max()?) + self.frame.right - left;
        let rows = legend::rows(key.to_vec(), width);
        let fits = legend::fits(&rows, width) && legend::height(&rows) <= unit(last.rect.bottom - last.rect.top);
        let keyed = Keyed { rows, at: (left, unit(last.rect.top)), right: left + width };
        fits.then_some((keyed, plots, height))
    }

    /// The panel `index`, in a row that begins at `y`.
    fn plot(&self, index: usize, margin: f64, y: f64) -> Plot<'a> {
        let (frame, panels) = (&self.frame, &self.chart.panels);
        let joined = self.chart.shared || panels.iter().all(|panel| panel.square);
        let (panel, window, extent) = (&panels[index], self.windows[index], self.extents[index]);
        let column = index % frame.columns;
        let height = (frame.width * ratio(panel, &window, frame.columns)).max(24.0);
        let labelled = (!joined || index + frame.columns >= panels.len(), !joined || column == 0);
        let (cell, left) = if column == 0 {
            (margin, margin + frame.left.0)
        } else {
            let before = frame.left.0 + (frame.width + frame.right + GAP) * column as f64;
            let cell = margin + before + frame.left.1 * (column - 1) as f64;
            (cell, cell + frame.left.1)
        };
        let (left, top) = (hundredths(left), hundredths(y + frame.head));
        let rect = Rect { left, top, right: left + hundredths(frame.width), bottom: top + hundredths(height) };
        let x_ticks = fitting(panel, &window, frame.width);
        let y_ticks = panel.y.ticks(window.y, label_count(height, 44.0));
        let (direct, ruled) = (self.direct, self.ruled);
        let title = titled(panel, frame.width);
        // A title of fewer lines than its neighbours' stands right above its panel.
        let head = (y + draw::TITLE * (frame.lines - title.len()) as f64, cell);
        Plot { panel, index, rect, window, x_ticks, y_ticks, labelled, title, head, extent, direct, ruled }
    }
}

fn hundredths(units: f64) -> i32 {
    (units * backend::UNIT).round() as i32
}

/// As many ticks on the x axis as fit without their labels touching.
fn fitting(panel: &Panel, window: &Window, width: f64) -> Vec<Tick> {
    let span = window.x.1 - window.x.0;
    let collide = |ticks: &[Tick]| {
        let labelled: Vec<_> = ticks.iter().filter_map(|tick| Some((tick.at, tick.label.as_ref()?.width()))).collect();
        labelled.windows(2).any(|two| (two[1].0 - two[0].0) / span * width < f64::midpoint(two[0].1, two[1].1) + 8.0)
    };
    let mut count = label_count(width, 56.0);
    loop {
        let ticks = panel.x.ticks(window.x, count);
        if count <= 1 || !collide(&ticks) {
            return ticks;
        }
        count -= 1;
    }
}

/// Writes the SVG.
fn write(sheet: &Sheet, plots: &[Plot<'_>], key: &Keyed, height: f64) -> Result<Figure, ChartError> {
    let height = hundredths(height.ceil());
    let size = (hundredths(sheet.width).unsigned_abs(), height.unsigned_abs());
    let mut svg = String::new();
    backend::open(sheet, height, plots.iter().any(|plot| plot.direct || plot.ruled), &mut svg);
    {
        let page = Page::new(&mut svg, size);
        legend::draw(&key.rows, key.at, key.right, &page)?;
        for plot in plots {
            draw::plot(plot, &page)?;
        }
        page.finish()?;
    }
    svg.push_str("</svg>\n");
    Ok(Figure { svg: path::short(&svg), width: sheet.width, height: f64::from(height) / backend::UNIT })
}
