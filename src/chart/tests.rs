//! Whole figures: well-formed, finite, small, the same every time; points within their strata as written; errors as values.

use super::path::tests::places;
use super::*;

fn sheet() -> Sheet {
    Sheet::new("fig-test", "Points & <lines>", "A \"test\"")
}

fn chart(layer: impl Into<Layer>) -> Chart {
    Chart::new(Panel::new(Axis::linear("*x*"), Axis::linear("*y*")).with(layer))
}

/// The radical inverse in base 2.
fn inverse(i: u32) -> f64 {
    f64::from(i.reverse_bits()) / 4_294_967_296.0
}

/// Checks that tags nest and that nothing was written that is no number.
fn well_formed(svg: &str) {
    let mut open = Vec::new();
    for part in svg.split('<').skip(1) {
        let (tag, text) = part.split_once('>').unwrap();
        assert!(!text.contains(['"', '>']) && tag.matches('"').count().is_multiple_of(2), "{tag}");
        let name = tag.split([' ', '/']).find(|part| !part.is_empty()).unwrap();
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty() && !svg.contains("NaN") && !svg.contains("\"inf"));
}

#[test]
fn figures_are_well_formed_and_repeat() {
    let line = Line::new((0..50).map(|i| (f64::from(i), f64::from(i * i))).collect()).label("a < b").marked();
    let figure = chart(line.clone()).draw(&sheet()).unwrap();
    well_formed(&figure.svg);
    assert_eq!(figure, chart(line).draw(&sheet()).unwrap());
    for part in ["role=\"img\"", "id=\"fig-test-title\"", "Points &amp; &lt;lines&gt;", "<desc", "a &lt; b"] {
        assert!(figure.svg.contains(part), "{part}");
    }
}

/// The centres of the discs of a figure, in hundredths.
fn discs(svg: &str) -> Vec<(i64, i64)> {
    let data = svg.lines().find(|line| line.matches("h0").count() > 3).unwrap();
    let data = data.split_once(" d=\"").unwrap().1.split_once('"').unwrap().0;
    places(data).into_iter().filter(|place| place.0 == 'm').map(|(_, x, y)| (x, y)).collect()
}

#[test]
fn points_are_in_their_strata_as_written() {
    let n = 64;
    let points: Vec<_> = (0..n).map(|i| (f64::from(i) / f64::from(n), inverse(i))).collect();
    let panel = Panel::unit_square().strata(Strata::slabs(n)).with(Marks::new(points.clone()));
    let figure = Chart::new(panel).draw(&sheet()).unwrap();
    let frame = figure.svg.lines().find(|line| line.ends_with("z\"/>")).unwrap();
    let corners = places(frame.split_once(" d=\"").unwrap().1.trim_end_matches("\"/>"));
    let (left, top, side) = (corners[0].1, corners[0].2, corners[1].1 - corners[0].1);
    for ((x, y), &(a, b)) in discs(&figure.svg).into_iter().zip(&points) {
        let inside = |at: i64, value: f64| {
            let k = (value * f64::from(n)).floor() as i64;
            at * i64::from(n) > k * side && at * i64::from(n) < (k + 1) * side
        };
        assert!(inside(x - left, a) && inside(top + side - y, b), "{a} {b}");
    }
}

#[test]
fn many_points_are_small() {
    let points = |n: u32| (0..n).map(|i| (f64::from(i) / f64::from(n), inverse(i))).collect::<Vec<_>>();
    let panel = |n| Panel::unit_square().with(Marks::new(points(n)).style(Style::of("sobol")));
    let figure = Chart::new(panel(4096)).draw(&sheet()).unwrap();
    assert!(figure.svg.len() < 100_000 && discs(&figure.svg).len() == 4096);
    let figure = Chart::new(panel(1_000_000)).draw(&sheet()).unwrap();
    assert!(figure.svg.len() < 200_000);
    well_formed(&figure.svg);
}

#[test]
fn what_cannot_be_drawn_is_told() {
    let values = vec![(1.0, 1.0), (2.0, 0.0), (3.0, f64::NAN), (4.0, 10.0)];
    let panel = Panel::new(Axis::linear("*x*"), Axis::log("*y*")).with(Line::new(values));
    let figure = Chart::new(panel).draw(&sheet()).unwrap();
    well_formed(&figure.svg);
    assert!(figure.svg.contains("Not shown: 1 not positive, 1 not finite"));
}

#[test]
fn nothing_is_an_error() {
    assert_eq!(Chart::grid(Vec::new()).draw(&sheet()), Err(ChartError::NoPanel));
    let empty = Err(ChartError::Empty { panel: 0 });
    assert_eq!(chart(Line::new(Vec::new())).draw(&sheet()), empty);
    assert_eq!(chart(Marks::new(vec![(f64::NAN, 1.0), (f64::INFINITY, 0.0)])).draw(&sheet()), empty);
    let far = Panel::unit_square().with(Marks::new(vec![(7.0, 7.0)]));
    assert_eq!(Chart::new(far).draw(&sheet()), empty);
    let bars = Bars::new(vec![0.0, 1.0], vec![1.0, 2.0]);
    assert!(matches!(chart(bars).draw(&sheet()), Err(ChartError::Lengths { .. })));
    let narrow = Sheet { width: f64::NAN, ..sheet() };
    assert!(matches!(chart(Marks::new(vec![(0.0, 0.0)])).draw(&narrow), Err(ChartError::Narrow { .. })));
}

#[test]
fn extremes_are_drawn_or_refused() {
    for value in [0.0, -3.0, 1e-300, 1e300, f64::MIN_POSITIVE, f64::MAX] {
        if let Ok(figure) = chart(Marks::new(vec![(value, value)])).draw(&sheet()) {
            well_formed(&figure.svg);
        }
        let panel =
            Panel::new(Axis::log("*x*"), Axis::log2("*y*")).with(Line::new(vec![(value, value), (1.0, 1.0)]).marked());
        well_formed(&Chart::new(panel).draw(&sheet()).unwrap().svg);
    }
    let wide = chart(Line::new(vec![(-f64::MAX, 0.0), (f64::MAX, 1.0)])).draw(&sheet());
    assert!(matches!(wide, Err(ChartError::Range { .. })));
}

/// Where the text `words` stands: its y, in units.
fn height_of(svg: &str, words: &str) -> f64 {
    let line = svg.lines().find(|line| line.starts_with("<text") && line.contains(&format!(">{words}<"))).unwrap();
    line.split_once(" y=\"").unwrap().1.split_once('"').unwrap().0.parse().unwrap()
}

/// A panel with a line for each height, which it says at its end.
fn tailed(heights: &[f64]) -> Panel {
    let line = |&height: &f64| {
        let name = format!("line {height}");
        Line::new(vec![(1.0, height), (2.0, height)]).label(name.as_str()).tail(format!("tail {height}").as_str())
    };
    Panel::new(Axis::linear("*x*"), Axis::linear("*y*").range(0.0, 10.0)).with_all(heights.iter().map(line))
}

#[test]
fn words_at_the_ends_of_lines_are_all_there_and_apart() {
    let heights = [5.0, 5.01, 5.02, 9.0];
    let figure = Chart::grid(vec![tailed(&heights), tailed(&heights[..1])]).draw(&sheet()).unwrap();
    well_formed(&figure.svg);
    let mut places: Vec<f64> = heights.iter().map(|h| height_of(&figure.svg, &format!("tail {h}"))).collect();
    places.sort_by(f64::total_cmp);
    assert!(places.windows(2).all(|two| two[1] - two[0] > 14.0), "{places:?}");
}

#[test]
fn the_key_takes_the_place_that_the_last_row_leaves_free() {
    let panels = || (0..3).map(|_| tailed(&[1.0, 2.0])).collect();
    let (held, above) = (Chart::grid(panels()), Chart::grid(panels()).key(Key::Above));
    let (held, above) = (held.draw(&sheet()).unwrap(), above.draw(&sheet()).unwrap());
    well_formed(&held.svg);
    assert!(held.height < above.height && height_of(&above.svg, "line 1") < 30.0);
    assert!(height_of(&held.svg, "line 1") > held.height / 2.0);
}

#[test]
fn what_leads_from_a_short_line_to_its_name_does_not_look_like_it() {
    let long = Line::new(vec![(0.0, 0.0), (10.0, 1.0)]).style(Style::of("sobol")).label("long");
    let short = Line::new(vec![(0.0, 1.0), (5.0, 2.0)]).style(Style::of("halton")).label("short");
    let dotted = |layers: Vec<Line>| {
        let panel = Panel::new(Axis::linear("*x*"), Axis::linear("*y*")).with_all(layers);
        let figure = Chart::new(panel).draw(&sheet()).unwrap();
        figure.svg.lines().filter(|line| line.contains("s-muted") && line.contains("dasharray")).count()
    };
    assert_eq!((dotted(vec![long.clone()]), dotted(vec![long, short])), (0, 1));
}

#[test]
fn the_line_of_an_axis_can_begin_later_than_its_panel() {
    let axis = || Axis::linear("").range(-1.0, 1.0);
    let first = |x: Axis| {
        let panel = Panel::new(x, axis().hidden()).with(Marks::new(vec![(0.5, 0.5)]));
        let svg = Chart::new(panel).draw(&sheet()).unwrap().svg;
        let line = svg.lines().find(|line| line.contains("s-axis")).unwrap();
        places(line.split_once(" d=\"").unwrap().1.split_once('"').unwrap().0)[0].1
    };
    assert!(first(axis().from(0.0)) > first(axis()) + 10_000);
}

#[test]
fn in_a_page_the_sheet_gives_the_colours() {
    let layer = Marks::new(vec![(0.2, 0.3)]).style(Style::of("sobol").marker(Marker::Square)).label("=\"#zz");
    let figure = chart(layer).draw(&sheet()).unwrap();
    let page = figure.in_a_page();
    assert!(figure.svg.contains(" fill=\"#") && figure.svg.contains(" stroke=\"#"));
    assert!(!page.contains(" fill=\"#") && !page.contains(" stroke=\"#"));
    // Every colour had a class beside it, and nothing else is gone.
    let coloured = |svg: &str| svg.matches("class=\"f-").count() + svg.matches("class=\"s-").count();
    assert_eq!(coloured(&page), coloured(&figure.svg));
    assert!(page.contains("fill=\"none\""));
    assert_eq!(page.matches("#zz").count(), figure.svg.matches("#zz").count());
}
