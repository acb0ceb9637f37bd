//! Figures as SVG, with logarithmic axes, fit to print. No other module uses the plotting library.

mod bands;
mod decades;
mod heights;
mod labels;
mod legend;
mod marks;
mod shares;
mod style;
mod thinned;

use kuva::backend::svg::SvgBackend;
use kuva::plot::{LinePlot, ScatterPlot};
use kuva::render::color::Color;
use kuva::render::layout::{ComputedLayout, Layout};
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};

pub use heights::line_of_heights;
pub use shares::shares_of_decades;

use decades::{Decades, powers_of_ten};
use labels::{Box, Track};
use study::figure::{FigureData, Series};
use style::{colour, colour_index, dash, dash_index, tint};
use thinned::thinned;
use units::display::typeset;

/// Size of a picture, without the legend under it.
const WIDTH_PX: f64 = 480.0;
const HEIGHT_PX: f64 = 380.0;
/// Width of one that has a page to itself.
const WIDE_PX: f64 = 860.0;
/// The height that a picture without a title saves.
const TITLE_PX: f64 = 36.0;
const MAX_TITLE_LETTERS: usize = 54;
const MINOR_TICK_PX: f64 = 3.0;

/// Draws a figure as an SVG document, with `subject` under its title and `provenance` as a comment.
pub fn svg(figure: &FigureData, subject: &str, provenance: &[String]) -> String {
    let layout = Layout::new((0.0, 1.0), (0.0, 1.0))
        .with_height(HEIGHT_PX)
        .with_title(figure.title.clone())
        .with_title_size(14)
        .with_title_wrap(MAX_TITLE_LETTERS)
        .with_subtitle(subject.to_owned())
        .with_subtitle_wrap(MAX_TITLE_LETTERS);
    let scene = drawn(figure, layout.with_width(WIDTH_PX), &[figure]);
    let (opening, inside) = split(&scene, &figure.name);
    format!("{opening}>\n<!--\n{}\n-->\n{inside}", comment(provenance))
}

/// Draws a figure as an element of a page that scales with its surroundings. `id` is unique in the page; `words` is the
/// text for readers who cannot see it. The figures of `beside`, including this one, share axes.
pub fn element(figure: &FigureData, beside: &[&FigureData], id: &str, words: &str) -> String {
    let width_px = if beside.len() > 1 { WIDTH_PX } else { WIDE_PX };
    let layout = Layout::new((0.0, 1.0), (0.0, 1.0)).with_height(HEIGHT_PX - TITLE_PX).with_width(width_px);
    page_element(&drawn(figure, layout, beside), id, words)
}

/// A picture as an element of a page.
fn page_element(scene: &Scene, id: &str, words: &str) -> String {
    let (opening, inside) = split(scene, id);
    let opening = opening.replace(" xmlns=\"http://www.w3.org/2000/svg\"", "");
    format!("{opening} role=\"img\" aria-label=\"{}\">{inside}", escaped(words))
}

fn drawn(figure: &FigureData, layout: Layout, beside: &[&FigureData]) -> Scene {
    // The library's own logarithmic axes end at 1e-10, and spectra reach 1e-40: decades are drawn as plain numbers.
    let points = || {
        let lines =
            beside.iter().flat_map(|figure| &figure.series).flat_map(|series| series.points.iter().copied());
        let marks = beside.iter().flat_map(|figure| &figure.marks).flat_map(marks::ends);
        lines.chain(marks).chain(beside.iter().flat_map(|figure| &figure.bands).flat_map(bands::ends))
    };
    let x = Decades::around(points().map(|(x, _)| x));
    let y = Decades::around(points().map(|(_, y)| y));
    let compared = figure.compares_curves();
    let drawn = |series: &Series| {
        let pieces = figure.pieces(series).into_iter().map(|piece| thinned(logarithms(&piece)));
        pieces.filter(|piece| !piece.is_empty()).collect()
    };
    let traces: Vec<Trace> = figure
        .series
        .iter()
        .map(|series| Trace {
            label: typeset(&series.condition),
            colour: colour_index(figure, series.condition_index),
            dash: dash_index(figure, series.curve_index),
            runs: drawn(series),
        })
        .collect();
    // Lines that coincide have to be seen: solid ones are broad and pale, and dashed ones lie dark on top of them.
    let (solid, dashed): (Vec<_>, Vec<_>) = traces.iter().partition(|trace| trace.dash == 0);
    let traces: Vec<&Trace> = solid.into_iter().chain(dashed).collect();
    let line = |trace: &&Trace| trace.runs.iter().map(|run| line(trace, run, compared)).collect::<Vec<_>>();
    let lines: Vec<Plot> = traces.iter().flat_map(line).collect();
    let layout = layout
        .with_x_axis_min(x.first)
        .with_x_axis_max(x.last)
        .with_x_tick_step(x.step)
        .with_x_tick_format(powers_of_ten())
        .with_y_axis_min(y.first)
        .with_y_axis_max(y.last)
        .with_y_tick_step(y.step)
        .with_y_tick_format(powers_of_ten())
        .with_box_axes()
        .with_label_size(13)
        .with_x_label(figure.x_label.clone())
        .with_y_label(figure.y_label);
    let computed = ComputedLayout::from_layout(&layout);
    let mut scene = render_multiple(lines, layout);
    let frame = frame(&computed);
    ticks_below(&mut scene, &computed, frame, x);
    ticks_left(&mut scene, &computed, frame, y);
    for (from, to) in &figure.gaps {
        shade(&mut scene, &computed, frame, [from.log10(), to.log10()]);
    }
    bands::draw(&mut scene, &computed, frame, figure);
    for mark in &figure.marks {
        marks::draw(&mut scene, &computed, mark, &colour(colour_index(figure, mark.condition_index)));
    }
    let in_pixels = |points: &[(f64, f64)]| {
        points.iter().map(|(x, y)| (computed.map_x(*x), computed.map_y(*y))).collect()
    };
    let tracks: Vec<Track> = traces
        .iter()
        .flat_map(|trace| trace.runs.iter().map(move |run| (trace, run)))
        .map(|(trace, run)| Track {
            label: trace.label.clone(),
            colour: trace.colour,
            points: in_pixels(run),
        })
        .collect();
    for label in labels::place(&tracks, frame) {
        scene.add(Primitive::Text {
            x: label.place.left,
            y: label.place.bottom - 0.15 * labels::SIZE_PX,
            content: label.text,
            size: labels::SIZE_PX as u32,
            anchor: TextAnchor::Start,
            rotate: None,
            bold: false,
            color: Some(Color::from(colour(label.colour).as_str())),
        });
    }
    let width_px = scene.width;
    legend::append(&mut scene, figure, frame.left, width_px);
    scene
}

/// A line and its drawn parts between holes, in powers of ten.
struct Trace {
    label: String,
    colour: usize,
    dash: usize,
    runs: Vec<Vec<(f64, f64)>>,
}

/// A stretch of the abscissa that was not measured.
fn shade(scene: &mut Scene, computed: &ComputedLayout, frame: Box, gap: [f64; 2]) {
    let [one, other] = gap.map(|power| computed.map_x(power).clamp(frame.left, frame.right));
    scene.add(Primitive::Rect {
        x: one.min(other),
        y: frame.top,
        width: (one - other).abs(),
        height: frame.bottom - frame.top,
        fill: Color::from("#808080"),
        stroke: None,
        stroke_width: None,
        opacity: Some(0.15),
    });
}

fn frame(computed: &ComputedLayout) -> Box {
    Box {
        left: computed.margin_left,
        top: computed.margin_top,
        right: computed.width - computed.margin_right,
        bottom: computed.height - computed.margin_bottom,
    }
}

/// Draws minor ticks below the axis. Those of the library are evenly spaced, which is wrong for a logarithmic axis.
fn ticks_below(scene: &mut Scene, computed: &ComputedLayout, frame: Box, x: Decades) {
    for power in x.minor_ticks() {
        let at = computed.map_x(power);
        tick(scene, [at, frame.bottom], [at, frame.bottom + MINOR_TICK_PX]);
    }
}

/// Draws minor ticks on the left.
fn ticks_left(scene: &mut Scene, computed: &ComputedLayout, frame: Box, y: Decades) {
    for power in y.minor_ticks() {
        let at = computed.map_y(power);
        tick(scene, [frame.left - MINOR_TICK_PX, at], [frame.left, at]);
    }
}

fn tick(scene: &mut Scene, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
    let stroke = Color::from("black");
    scene.add(Primitive::Line { x1, y1, x2, y2, stroke, stroke_width: 0.7, stroke_dasharray: None });
}

fn logarithms(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    points.iter().filter(|(_, y)| *y > 0.0).map(|(x, y)| (x.log10(), y.log10())).collect()
}

fn line(trace: &Trace, points: &[(f64, f64)], compared: bool) -> Plot {
    let points = points.to_vec();
    let dark = colour(trace.colour);
    if points.len() == 1 {
        return Plot::Scatter(ScatterPlot::new().with_data(points).with_color(dark).with_size(3.0));
    }
    let (colour, width_px) =
        if compared && trace.dash == 0 { (tint(trace.colour), 3.5) } else { (dark, 1.6) };
    let line = LinePlot::new().with_data(points).with_color(colour).with_stroke_width(width_px);
    Plot::Line(line.with_line_style(dash(trace.dash)))
}

/// An upper estimate of the width of a text in the usual fonts.
fn text_width_px(text: &str, size_px: f64) -> f64 {
    let width = |c: char| match c {
        'm' | 'M' | 'W' => 0.98,
        ' ' => 0.35,
        c if c.is_ascii() || c == '×' => 0.62,
        _ => 0.48,
    };
    size_px * text.chars().map(width).sum::<f64>()
}

/// The opening tag without its end, and the rest. The library numbers its clip regions through the whole program; here
/// they are named after the figure, so that the document does not depend on earlier drawings and pages can hold many.
fn split(scene: &Scene, id: &str) -> (String, String) {
    let svg = SvgBackend::default().render_scene(scene);
    let numbered = svg.split('"').find(|text| text.starts_with("kuva-clip-")).map(str::to_owned);
    let svg = numbered.map_or_else(|| svg.clone(), |numbered| svg.replace(&numbered, &format!("{id}-area")));
    // A picture without a view box is cut off where it should shrink.
    match svg.split_once('>') {
        Some((opening, inside)) => {
            (format!("{opening} viewBox=\"0 0 {} {}\"", scene.width, scene.height), inside.to_owned())
        }
        None => (svg, String::new()),
    }
}

/// The lines as the text of a comment, without double hyphens.
fn comment(lines: &[String]) -> String {
    let mut comment = lines.join("\n");
    while comment.contains("--") {
        comment = comment.replace("--", "- -");
    }
    comment
}

/// A text within an element or an attribute.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use study::figure::{Band, BandKind, Shows};

    fn figure(name: &str) -> FigureData {
        let series = Series {
            condition_in_full: "10 MPa = 10⁻³ H".to_owned(),
            ..Series::under("1e-3 H", 0, vec![(1.0, 1e-30), (10.0, 1e-20)])
        };
        FigureData {
            name: name.to_owned(),
            shows: Shows::Psd,
            title: String::new(),
            x: study::figure::Axis { column: "x", label: "x" },
            x_label: "x".to_owned(),
            y_label: "y",
            series: vec![series],
            bands: Vec::new(),
            gaps: Vec::new(),
            marks: Vec::new(),
        }
    }

    #[test]
    fn the_same_figure_is_the_same_document_however_many_were_drawn_before() {
        assert_eq!(svg(&figure("a"), "", &[]), svg(&figure("a"), "", &[]));
    }

    #[test]
    fn figures_of_a_page_share_no_identifier() {
        let (a, b) = (figure("a"), figure("b"));
        let (first, second) = (element(&a, &[&a], "a", ""), element(&b, &[&b], "b", ""));
        assert!(first.contains("url(#a-area)") && second.contains("url(#b-area)"), "{first}");
    }

    #[test]
    fn a_load_is_labelled_at_its_line_and_spelt_out_in_the_legend() {
        let svg = svg(&figure("a"), "", &[]);
        assert!(svg.contains(">10⁻³ H</text>") && svg.contains(">10 MPa = 10⁻³ H</text>"), "{svg}");
    }

    #[test]
    fn what_was_not_measured_is_shaded_and_no_line_crosses_it() {
        let mut figure = figure("a");
        figure.series[0].points = vec![(1.0, 1.0), (2.0, 2.0), (20.0, 3.0), (40.0, 4.0)];
        let lines = |svg: &str| svg.matches("stroke-width=\"1.6\"").count();
        let whole = svg(&figure, "", &[]);
        figure.gaps = vec![(2.0, 20.0)];
        let broken = svg(&figure, "", &[]);
        assert_eq!(lines(&broken), lines(&whole) + 1, "{broken}");
        assert!(broken.contains("opacity=\"0.15\"") && !whole.contains("opacity=\"0.15\""), "{broken}");
    }

    #[test]
    fn a_band_is_drawn_inside_the_frame_and_named_once() {
        let mut figure = figure("a");
        let whole = svg(&figure, "", &[]);
        let band = |load, share: f64| Band {
            label: "linear laws".to_owned(),
            kind: BandKind::Yardstick,
            load: Some(load),
            curve_index: 0,
            points: [1.0, 3.0, 10.0].map(|x| (x, [1e-26 * share, 3e-26 * share])).to_vec(),
        };
        // The last lies beside the decades that are drawn.
        figure.bands = vec![band(0, 1.0), band(1, 100.0), band(2, 1e30)];
        let banded = svg(&figure, "", &[]);
        let count = |svg: &str, what: &str| svg.matches(what).count();
        // Two bands, and the sample of the legend.
        assert_eq!(count(&banded, "opacity=\"0.18\"") - count(&whole, "opacity=\"0.18\""), 3, "{banded}");
        assert_eq!(count(&banded, ">linear laws</text>"), 1);
    }

    #[test]
    fn an_interval_has_edges_in_the_dash_pattern_of_its_line_and_belongs_on_the_axes() {
        let mut figure = figure("a");
        let held_against = Series { curve_index: 1, ..figure.series[0].clone() };
        figure.series.push(held_against);
        figure.bands = vec![Band {
            label: "95 % coverage interval".to_owned(),
            kind: BandKind::Interval,
            load: None,
            curve_index: 0,
            points: vec![(1.0, [1e-33, 1e-29]), (10.0, [1e-21, 1e-19])],
        }];
        let banded = svg(&figure, "", &[]);
        assert_eq!(
            banded.matches("stroke-width=\"0.75\" fill=\"none\" stroke-dasharray=\"4 3\"").count(),
            2,
            "{banded}"
        );
        assert_eq!(banded.matches(">95 % coverage interval</text>").count(), 1);
        assert!(banded.contains(">10⁻³⁴</text>"), "{banded}");
    }

    #[test]
    fn a_comment_never_ends_early() {
        let comment = comment(&["# -----".to_owned(), "--model".to_owned()]);
        assert!(!comment.contains("--") && comment.contains("model"), "{comment}");
    }
}
