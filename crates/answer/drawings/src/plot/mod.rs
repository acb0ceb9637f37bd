//! Figures as SVG, with logarithmic or linear axes, fit to print. No other module uses the plotting library.

mod bands;
mod canvas;
mod decades;
mod heights;
mod labels;
mod legend;
mod marks;
mod ruler;
mod script;
mod shares;
mod steps;
mod style;
mod thinned;

use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
use kuva::render::layout::{ComputedLayout, Layout};
use kuva::render::render::{Primitive, Scene, TextAnchor};

pub(crate) use heights::Panel;
pub use script::script;
pub use shares::shares_of_decades;

use canvas::Stroke;
use labels::{Box, Track};
use ruler::{Ruler, Rulers};
use study::figure::{FigureData, FigureStyle, Series};
use style::{Ink, NEUTRAL, colour, colour_index};
use thinned::thinned;
use units::display::typeset;
use units::printable::printable;

/// Size of a picture, without the legend under it.
const WIDTH_PX: f64 = 480.0;
const HEIGHT_PX: f64 = 380.0;
/// Width of one that has a page to itself.
const WIDE_PX: f64 = 860.0;
/// The height that a picture without a title saves.
const TITLE_PX: f64 = 36.0;
const MAX_TITLE_LETTERS: usize = 54;
const MINOR_TICK_PX: f64 = 3.0;
/// The size of letters in print if only the width is given, and in a picture on average.
const FONT_SIZE_PT: f64 = 8.0;
const LETTERS_PX: f64 = 12.0;
const POINTS_PER_MM: f64 = 72.0 / 25.4;
/// The most lines that get labels. Labels of more lines find no place between them, and searching takes the square of
/// the number of lines.
const MAX_LABELLED: usize = 100;
/// The width of the label of the ordinate, with the tick and the distances beside them.
const AXIS_LABEL_PX: f64 = 36.0;
/// The size of the labels of ticks, at most.
const TICK_LETTERS_PX: f64 = 12.0;

/// Draws a figure as an SVG document, with `subject` under its title and `provenance` as a comment.
pub fn svg(figure: &FigureData, subject: &str, provenance: &[String]) -> String {
    styled_svg(figure, &FigureStyle::default(), subject, provenance)
}

/// Draws a figure like [`svg`], in a style: letters keep their size in print, so that a narrow figure has less room.
pub fn styled_svg(figure: &FigureData, style: &FigureStyle, subject: &str, provenance: &[String]) -> String {
    let font_size_pt = style.font_size_pt.unwrap_or(FONT_SIZE_PT);
    let px_of_mm = POINTS_PER_MM * LETTERS_PX / font_size_pt;
    let width_px = style.width_mm.map_or(WIDTH_PX, |width_mm| width_mm * px_of_mm);
    let axes_px = (HEIGHT_PX - TITLE_PX) * width_px / WIDTH_PX;
    let layout = Layout::new((0.0, 1.0), (0.0, 1.0)).with_width(width_px);
    let layout = if style.hides_title {
        layout.with_height(axes_px)
    } else {
        let letters = (MAX_TITLE_LETTERS as f64 * width_px / WIDTH_PX) as usize;
        layout
            .with_height(axes_px + TITLE_PX)
            .with_title(figure.title.clone())
            .with_title_size(14)
            .with_title_wrap(letters)
            .with_subtitle(subject.to_owned())
            .with_subtitle_wrap(letters)
    };
    let scene = drawn(figure, layout, &[figure], &figure.name);
    let (opening, inside) = split(&scene);
    let opening = match style.width_mm.or(style.font_size_pt) {
        Some(_) => in_print(&opening, &scene, px_of_mm),
        None => opening,
    };
    format!("{opening}>\n<!--\n{}\n-->\n{inside}", comment(provenance))
}

/// The opening tag with its size in millimetres.
fn in_print(opening: &str, scene: &Scene, px_of_mm: f64) -> String {
    let sizes = [("width", scene.width), ("height", scene.height)];
    sizes.iter().fold(opening.to_owned(), |opening, (name, px)| {
        let attribute = format!(" {name}=\"");
        match opening.split_once(&attribute).and_then(|(before, rest)| Some((before, rest.split_once('"')?)))
        {
            Some((before, (_, after))) => format!("{before}{attribute}{:.2}mm\"{after}", px / px_of_mm),
            None => opening,
        }
    })
}

/// Draws a figure as an element of a page that scales with its surroundings. `id` is unique in the page; `words` is the
/// text for readers who cannot see it. The figures of `beside`, including this one, share axes.
pub fn element(figure: &FigureData, beside: &[&FigureData], id: &str, words: &str) -> String {
    let width_px = if beside.len() > 1 { WIDTH_PX } else { WIDE_PX };
    let layout = Layout::new((0.0, 1.0), (0.0, 1.0)).with_height(HEIGHT_PX - TITLE_PX).with_width(width_px);
    page_element(&drawn(figure, layout, beside, id), words)
}

/// A picture as an element of a page.
fn page_element(scene: &Scene, words: &str) -> String {
    let (opening, inside) = split(scene);
    let opening = opening.replace(" xmlns=\"http://www.w3.org/2000/svg\"", "");
    format!("{opening} role=\"img\" aria-label=\"{}\">{inside}", escaped(words))
}

/// `id` is unique in the document.
fn drawn(figure: &FigureData, layout: Layout, beside: &[&FigureData], id: &str) -> Scene {
    // The library's own logarithmic axes end at 1e-10, and spectra reach 1e-40: it draws places, which are plain numbers.
    let rulers = Rulers::around(figure, &drawn_points(beside), layout.width);
    let drawn = |series: &Series| {
        let pieces = figure.pieces(series).into_iter().map(|piece| thinned(rulers.places(&piece)));
        pieces.filter(|piece| !piece.is_empty()).collect()
    };
    let series_count = figure.series.len();
    let traces: Vec<Trace> = figure
        .series
        .iter()
        .enumerate()
        .map(|(at, series)| {
            let label = if series_count > MAX_LABELLED { String::new() } else { typeset(&series.condition) };
            let ink = Ink::new(figure, series);
            Trace { label, group: label_group(figure, at), ink, runs: drawn(series) }
        })
        .collect();
    // Lines that coincide have to be seen: solid ones are broad and pale, and dashed ones lie dark on top of them.
    let (solid, dashed): (Vec<_>, Vec<_>) = traces.iter().partition(|trace| trace.ink.is_solid());
    let traces: Vec<&Trace> = solid.into_iter().chain(dashed).collect();
    let Rulers { x, y } = &rulers;
    let layout = layout
        .with_x_axis_min(x.first())
        .with_x_axis_max(x.last())
        .with_x_tick_step(x.step())
        .with_x_tick_format(rulers.x_ticks(figure))
        .with_y_axis_min(y.first())
        .with_y_axis_max(y.last())
        .with_y_tick_step(y.step())
        .with_y_tick_format(rulers.y_ticks(figure))
        .with_box_axes()
        .with_label_size(13)
        .with_x_label(rulers.x_label(figure))
        .with_y_label(rulers.y_label(figure));
    let layout = with_room_at_the_end(with_room_for_numbers(layout, y), x);
    let computed = ComputedLayout::from_layout(&layout);
    let mut scene = canvas::with_axes(layout, id, |computed| {
        let of_trace = |trace: &&Trace| {
            trace.runs.iter().map(|run| shape(computed, &trace.ink, run)).collect::<Vec<_>>()
        };
        zero_lines(computed, &rulers).into_iter().chain(traces.iter().flat_map(of_trace)).collect()
    });
    let frame = frame(&computed);
    ticks_below(&mut scene, &computed, frame, x);
    ticks_left(&mut scene, &computed, frame, y);
    for (from, to) in &figure.gaps {
        if let (Some(from), Some(to)) = (x.place(*from), x.place(*to)) {
            shade(&mut scene, &computed, frame, [from, to]);
        }
    }
    bands::draw(&mut scene, &computed, &rulers, frame, figure);
    for mark in &figure.marks {
        let dark = mark_colour(figure, colour_index(figure, mark.condition_index));
        marks::draw(&mut scene, &computed, &rulers, mark, &dark);
    }
    let in_pixels = |points: &[(f64, f64)]| {
        points.iter().map(|(x, y)| (computed.map_x(*x), computed.map_y(*y))).collect()
    };
    let tracks: Vec<Track> = traces
        .iter()
        .flat_map(|trace| trace.runs.iter().map(move |run| (trace, run)))
        .map(|(trace, run)| Track { label: trace.label.clone(), group: trace.group, points: in_pixels(run) })
        .collect();
    let placed = labels::place(&tracks, frame);
    let colour_of =
        |group: usize| traces.iter().find(|trace| trace.group == group).map(|trace| &trace.ink.dark);
    for label in &placed {
        scene.add(Primitive::Text {
            x: label.place.left,
            y: label.place.bottom - 0.15 * labels::SIZE_PX,
            content: label.text.clone(),
            size: labels::SIZE_PX as u32,
            anchor: TextAnchor::Start,
            rotate: None,
            bold: false,
            color: colour_of(label.group).map(|dark| Color::from(dark.as_str())),
        });
    }
    let width_px = scene.width;
    let is_labelled = |at: usize| placed.iter().any(|label| label.group == label_group(figure, at));
    legend::append(&mut scene, figure, is_labelled, [frame.left, width_px]);
    scene
}

/// Returns all points of figures that share axes, which have to lie on them.
fn drawn_points(figures: &[&FigureData]) -> Vec<(f64, f64)> {
    let lines =
        figures.iter().flat_map(|figure| &figure.series).flat_map(|series| series.points.iter().copied());
    let marks = figures.iter().flat_map(|figure| &figure.marks).flat_map(marks::ends);
    let bands = figures.iter().flat_map(|figure| &figure.bands).flat_map(bands::ends);
    lines.chain(marks).chain(bands).collect()
}

/// A line and its drawn parts between holes, as places.
struct Trace {
    label: String,
    group: usize,
    ink: Ink,
    runs: Vec<Vec<(f64, f64)>>,
}

/// The lines that share a label with the one at an index: those of its colour. Lines of models have one each.
fn label_group(figure: &FigureData, at: usize) -> usize {
    let series = &figure.series[at];
    series.look.map_or_else(|| colour_index(figure, series.condition_index), |_| at)
}

/// Widens the left margin for the labels of a linear ordinate, whose minus signs the library takes for narrow.
fn with_room_for_numbers(layout: Layout, y: &Ruler) -> Layout {
    let Ruler::Steps(steps) = y else { return layout };
    let computed = ComputedLayout::from_layout(&layout);
    let widest = [steps.first, steps.last]
        .map(|place| text_width_px(&layout.y_tick_format.format(place), TICK_LETTERS_PX));
    let left = widest[0].max(widest[1]) + AXIS_LABEL_PX;
    layout.with_force_margins(computed.margin_left.max(left), computed.margin_right)
}

/// Widens the right margin so that the last label of the abscissa ends inside the picture.
fn with_room_at_the_end(layout: Layout, x: &Ruler) -> Layout {
    let computed = ComputedLayout::from_layout(&layout);
    let label = layout.x_tick_format.format(x.last());
    let half_px = 0.5 * text_width_px(&label, TICK_LETTERS_PX) + 1.0;
    layout.with_force_margins(computed.margin_left, computed.margin_right.max(half_px))
}

/// The colour of marks under a condition: its own, or black where colours belong to models.
fn mark_colour(figure: &FigureData, condition: usize) -> String {
    let has_models = figure.series.iter().any(|series| series.look.is_some());
    colour(if has_models { NEUTRAL } else { condition })
}

/// A stretch of the abscissa that was not measured.
fn shade(scene: &mut Scene, computed: &ComputedLayout, frame: Box, gap: [f64; 2]) {
    let [one, other] = gap.map(|place| computed.map_x(place).clamp(frame.left, frame.right));
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
fn ticks_below(scene: &mut Scene, computed: &ComputedLayout, frame: Box, x: &Ruler) {
    for place in x.minor_ticks() {
        let at = computed.map_x(place);
        tick(scene, [at, frame.bottom], [at, frame.bottom + MINOR_TICK_PX]);
    }
}

/// Draws minor ticks on the left.
fn ticks_left(scene: &mut Scene, computed: &ComputedLayout, frame: Box, y: &Ruler) {
    for place in y.minor_ticks() {
        let at = computed.map_y(place);
        tick(scene, [frame.left - MINOR_TICK_PX, at], [frame.left, at]);
    }
}

fn tick(scene: &mut Scene, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
    let stroke = Color::from("black");
    scene.add(Primitive::Line { x1, y1, x2, y2, stroke, stroke_width: 0.7, stroke_dasharray: None });
}

/// The lines at zero of linear axes that cross it.
fn zero_lines(computed: &ComputedLayout, Rulers { x, y }: &Rulers) -> Vec<Primitive> {
    let stroke = || Stroke { colour: "#999999", width_px: 0.7, dash: None };
    let across = y.crosses_zero().then(|| [(x.first(), 0.0), (x.last(), 0.0)]);
    let upwards = x.crosses_zero().then(|| [(0.0, y.first()), (0.0, y.last())]);
    across.iter().chain(&upwards).map(|ends| canvas::line(computed, ends, stroke())).collect()
}

/// A line through points, or a dot where there is one.
fn shape(computed: &ComputedLayout, ink: &Ink, points: &[(f64, f64)]) -> Primitive {
    match points {
        [point] => canvas::dot(computed, *point, &ink.dark),
        _ => {
            let stroke = Stroke { colour: &ink.colour, width_px: ink.width_px, dash: ink.dash.dasharray() };
            canvas::line(computed, points, stroke)
        }
    }
}

/// An upper estimate of the width of a text in the usual fonts.
fn text_width_px(text: &str, size_px: f64) -> f64 {
    let width = |c: char| match c {
        'm' | 'M' | 'W' => 0.98,
        '\u{2212}' => 0.84,
        ' ' => 0.35,
        c if c.is_ascii() || c == '×' => 0.62,
        _ => 0.48,
    };
    size_px * text.chars().map(width).sum::<f64>()
}

/// The opening tag without its end, and the rest.
fn split(scene: &Scene) -> (String, String) {
    // The library leaves the end of a section of text as it is, which is none in a document of XML.
    let svg = printable(&SvgBackend::default().render_scene(scene)).replace("]]>", "]]&gt;");
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
    let mut comment = printable(&lines.join("\n")).into_owned();
    while comment.contains("--") {
        comment = comment.replace("--", "- -");
    }
    comment
}

/// A text within an element or an attribute.
pub(crate) fn escaped(text: &str) -> String {
    printable(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use study::figure::{Axis, Band, BandKind, CurveLook, Shows, Variant};

    fn figure(name: &str) -> FigureData {
        let series = Series {
            condition_in_full: "10 MPa = 10⁻³ H".to_owned(),
            ..Series::under("1e-3 H", 0, vec![(1.0, 1e-30), (10.0, 1e-20)])
        };
        let x = Axis { column: "x", label: "x" };
        FigureData { title: String::new(), ..FigureData::new(name, Shows::Psd, x, "y", vec![series]) }
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
        figure.gaps = vec![(1.0, 3.0)];
        assert_eq!(count(&svg(&figure, "", &[]), "opacity=\"0.18\""), 5, "each band in two pieces");
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
    fn a_model_has_its_colour_and_dash_in_any_figure_and_its_ticks_have_units() {
        let look = |model| Some(CurveLook { model, variant: Variant::Plain, repeat: 0 });
        let line = |model: &'static str, curve_index| Series {
            curve: model.to_owned(),
            curve_index,
            look: look(model),
            ..Series::under("1 MPa", 0, vec![(1e-9, 1e-5), (1e-6, 1e-2)])
        };
        let with = |series: Vec<Series>| {
            let x = Axis { column: "wavelength_m", label: "wavelength (m)" };
            let x_label = x.label.to_owned();
            let drawn = FigureData { shows: Shows::Area, series, x, x_label, ..figure("a") };
            svg(&drawn, "", &[])
        };
        let style = crate::model_style::ModelStyle::new(look("persson").unwrap());
        for drawn in [with(vec![line("persson", 0)]), with(vec![line("hertz", 0), line("persson", 1)])] {
            assert!(drawn.contains(style.colour) && drawn.contains(&style.dash), "{drawn}");
            for label in
                [">1 nm</text>", ">1 µm</text>", ">10 ppm</text>", ">1 %</text>", ">wavelength</text>"]
            {
                assert!(drawn.contains(label), "{label}: {drawn}");
            }
        }
    }

    #[test]
    fn each_line_of_a_model_is_labelled_with_its_load_or_as_broad_as_its_load_in_the_legend() {
        let look = Some(CurveLook { model: "persson", variant: Variant::Plain, repeat: 0 });
        let line = |condition: &str, index, y: f64| Series {
            curve: "persson".to_owned(),
            look,
            ..Series::under(condition, index, vec![(1e-9, y), (1e-6, 10.0 * y)])
        };
        let drawn = |second: f64| {
            let series = vec![line("1 MPa", 0, 1e-6), line("2 MPa", 1, second)];
            svg(&FigureData { series, ..figure("a") }, "", &[])
        };
        let count = |svg: &str, text: &str| svg.matches(text).count();
        let (apart, together) = (drawn(1e-4), drawn(1.01e-6));
        assert_eq!([">1 MPa</text>", ">2 MPa</text>"].map(|load| count(&apart, load)), [1, 1], "{apart}");
        // Lines on top of each other leave no room for labels beside them: the legend has both widths.
        for width in ["stroke-width=\"0.9\"", "stroke-width=\"2.9\""] {
            assert_eq!(count(&together, width), count(&apart, width) + 1, "{together}");
        }
    }

    #[test]
    fn the_last_label_of_the_abscissa_ends_inside_the_picture() {
        let x = Axis { column: "wavelength_m", label: "wavelength (m)" };
        let series = vec![Series::under("1 MPa", 0, vec![(1e-6, 1e-5), (1e-4, 1e-2)])];
        let drawn = svg(&FigureData { series, x, ..figure("a") }, "", &[]);
        let label = drawn.split("<text ").find(|text| text.contains(">100 µm</text>")).unwrap();
        let place: f64 = label.split_once("x=\"").unwrap().1.split('"').next().unwrap().parse().unwrap();
        assert!(place + 0.5 * text_width_px("100 µm", 12.0) <= WIDTH_PX, "{label}");
    }

    #[test]
    fn a_width_in_print_keeps_the_size_of_letters() {
        let drawn = |width_mm, font_size_pt, hides_title| {
            let style = FigureStyle { width_mm, font_size_pt, hides_title };
            styled_svg(&FigureData { title: "title".to_owned(), ..figure("a") }, &style, "", &[])
        };
        let units_wide = |svg: &str| -> f64 {
            svg.split_once("viewBox=\"0 0 ").unwrap().1.split(' ').next().unwrap().parse().unwrap()
        };
        let [narrow, wide] = [85.0, 170.0].map(|width_mm| drawn(Some(width_mm), Some(8.0), true));
        assert!(narrow.contains(" width=\"85.00mm\"") && !narrow.contains(">title</text>"), "{narrow}");
        // 12 units of the drawing are 8 points, a point is 1/72 inch.
        assert!((units_wide(&narrow) - 85.0 * 72.0 / 25.4 * 1.5).abs() < 1e-6, "{narrow}");
        assert!((units_wide(&wide) - 2.0 * units_wide(&narrow)).abs() < 1e-6, "{wide}");
        assert!((units_wide(&drawn(Some(85.0), Some(16.0), true)) - 0.5 * units_wide(&narrow)).abs() < 1e-6);
        assert_eq!(
            drawn(None, None, false),
            svg(&FigureData { title: "title".to_owned(), ..figure("a") }, "", &[])
        );
    }

    #[test]
    fn linear_axes_have_negative_values_prefixes_and_lines_at_zero() {
        let x = Axis { column: "shear_m", label: "shear (m)" };
        let line = |name, index, sign: f64| {
            Series::under(name, index, vec![(-3e-9, -sign * 2e6), (0.0, sign * 1e6), (3e-9, 2e6)])
        };
        let lines = vec![line("back", 0, -1.0), line("forth", 1, 1.0)];
        let figure = FigureData::new("a", Shows::Response, x, "stress (Pa)", lines).with_linear_axes();
        let drawn = svg(&figure, "", &[]);
        for label in [">shear (nm)</text>", ">stress (MPa)</text>", ">\u{2212}2</text>", ">0</text>"] {
            assert!(drawn.contains(label), "{label}: {drawn}");
        }
        // A line at zero of each axis.
        assert_eq!(drawn.matches("#999999").count(), 2, "{drawn}");
        assert_eq!(svg(&figure_of_decades(figure), "", &[]).matches("#999999").count(), 0);
    }

    fn figure_of_decades(figure: FigureData) -> FigureData {
        use study::figure::AxisScale::Logarithmic;
        FigureData { x_scale: Logarithmic, y_scale: Logarithmic, ..figure }
    }

    #[test]
    fn a_comment_never_ends_early() {
        let comment = comment(&["# -----".to_owned(), "--model".to_owned()]);
        assert!(!comment.contains("--") && comment.contains("model"), "{comment}");
    }
}
