//! Charts: every figure of reports, pages and print as SVG.
//!
//! `canvas` writes axes, lines, bands and marks, `ruler` lays out an axis, [`palette`] has all colours and dashes. A
//! drawing of a kind of its own, such as the curve of the first screen, uses these directly; figures as data
//! ([`FigureData`]) are drawn here.

pub(crate) mod canvas;
pub(crate) mod contact;
mod ink;
pub(crate) mod labels;
mod legend;
pub mod maps;
pub mod palette;
pub(crate) mod panel;
mod raster;
pub(crate) mod ruler;
mod script;

pub use script::script;

use study::figure::{AxisKind, AxisScale, BandKind, FigureBand, FigureData, FigureStyle, Mark, pieces};

use canvas::{Anchor, Canvas, LETTERS_PX, MOST_POINTS, Point, Rect, Stroke, path, thinned, wrapped};
use ink::{Ink, band_colour, label, label_group, mark_colour, opacity};
use labels::Track;
use palette::QUIET;
use panel::Panel;
use ruler::{Ruler, TickWords, floor_below};

/// Size of a figure, without its title and the legend under it.
const WIDTH_PX: f64 = 480.0;
const HEIGHT_PX: f64 = 344.0;
/// Width of one that has a page to itself.
const WIDE_PX: f64 = 860.0;
/// The distance of the frame from the upper edge, or from the title.
const TOP_PX: f64 = 12.0;
/// The letters of titles and of subjects under them, and the heights of their lines.
const TITLE_PX: [f64; 2] = [14.0, 18.0];
const SUBJECT_PX: [f64; 2] = [10.0, 13.0];
/// The size of letters in print if only the width is given.
const FONT_SIZE_PT: f64 = 8.0;
const POINTS_PER_MM: f64 = 72.0 / 25.4;
/// The most steps of linear axes, across and upwards.
const MOST_STEPS: [f64; 2] = [7.0, 8.0];
/// The least width of a narrow figure for each labelled tick.
const TICK_ROOM_PX: f64 = 65.0;
/// The most lines that get labels. Labels of more lines find no place between them, and searching takes the square of
/// the number of lines.
const MOST_LABELLED: usize = 100;

/// Draws a figure as an SVG document, with `subject` under its title and `provenance` as a comment.
#[must_use]
pub fn svg(figure: &FigureData, subject: &str, provenance: &[String]) -> String {
    styled_svg(figure, &FigureStyle::default(), subject, provenance)
}

/// Draws a figure like [`svg`], in a style: letters keep their size in print, so that a narrow figure has less room.
#[must_use]
pub fn styled_svg(figure: &FigureData, style: &FigureStyle, subject: &str, provenance: &[String]) -> String {
    let px_of_mm = POINTS_PER_MM * LETTERS_PX / style.font_size_pt.unwrap_or(FONT_SIZE_PT);
    let width = style.width_mm.map_or(WIDTH_PX, |width_mm| width_mm * px_of_mm);
    let header = (!style.hides_title).then_some([figure.title.as_str(), subject]);
    let is_in_print = style.width_mm.is_some() || style.font_size_pt.is_some();
    let size = [width, HEIGHT_PX * width / WIDTH_PX];
    drawn(figure, &[figure], size, header).document(provenance, is_in_print.then_some(px_of_mm))
}

/// Draws a figure as an element of a page that scales with its surroundings; `words` are for readers who cannot see it.
/// The figures of `beside`, including this one, share axes.
pub(crate) fn element(figure: &FigureData, beside: &[&FigureData], words: &str) -> String {
    let width = if beside.len() > 1 { WIDTH_PX } else { WIDE_PX };
    drawn(figure, beside, [width, HEIGHT_PX], None).element(words)
}

/// Draws bars over stretches of a logarithmic abscissa with their heights in percent, as an element of a page; `None`
/// without a bar.
pub(crate) fn bars(bars: &[([f64; 2], f64)], y_label: &str, words: &str) -> Option<String> {
    const LOW_PX: f64 = 230.0;
    const STEP: f64 = 20.0;
    const LABEL_PX: f64 = 11.0;
    if bars.is_empty() {
        return None;
    }
    let edges = bars.iter().flat_map(|(edges, _)| *edges);
    let x = Ruler::decades(edges, TickWords::Length, "wavelength", f64::INFINITY);
    let highest = bars.iter().map(|(_, percent)| *percent).fold(STEP, f64::max);
    let top = ((highest + 0.5 * STEP) / STEP).ceil() * STEP;
    let y = Ruler::steps([0.0, top].into_iter(), TickWords::Number, y_label, 1.2 * top / STEP);
    let mut canvas = Canvas::in_picture(x, y, [WIDE_PX, LOW_PX], TOP_PX);
    canvas.grid();
    let (fill, stroke) = (palette::tint(0), palette::colour(0));
    for ([from, to], percent) in bars {
        let [left, right] = [canvas.x.px_or_first(*from), canvas.x.px_or_first(*to)];
        let place = Rect {
            left: left.min(right),
            right: left.max(right),
            top: canvas.y.px_or_first(*percent),
            bottom: canvas.frame.bottom,
        };
        canvas.rect(place, &format!("class=\"bar\" fill=\"{fill}\" stroke=\"{stroke}\""));
        let over = (0.5 * (left + right), place.top - 0.4 * LABEL_PX);
        canvas.text(over, Anchor::Middle, LABEL_PX, &format!("{percent:.0} %"));
    }
    canvas.axes();
    Some(Panel { size: [WIDE_PX, LOW_PX], elements: canvas.svg }.element(words))
}

/// Draws runs of points, both in the units of their labels, on plain axes. Runs are not joined: missing points lie between
/// them.
pub(crate) fn plain_lines(title: &str, labels: [&str; 2], runs: &[Vec<Point>], size: [f64; 2]) -> Panel {
    const LINE_PX: f64 = 1.2;
    let points = || runs.iter().flatten();
    let x = Ruler::around(points().map(|point| point.0), labels[0], size[0] / TICK_ROOM_PX);
    let y = Ruler::around(points().map(|point| point.1), labels[1], MOST_STEPS[1]);
    let header = Header::new(Some([title, ""]), size[0]);
    let mut canvas = Canvas::in_picture(x, y, size, header.top);
    header.draw(&mut canvas);
    canvas.grid();
    let colour = palette::colour(0);
    for run in runs {
        let places = places(&canvas, run);
        canvas.line(&thinned(places, MOST_POINTS), Stroke { colour: &colour, width_px: LINE_PX, dash: "" });
    }
    canvas.axes();
    Panel { size, elements: canvas.svg }
}

/// A title and a subject under it, broken into lines: for each the place, the look and the words.
struct Header {
    lines: Vec<(Point, String, String)>,
    /// The top of the frame below.
    top: f64,
}

impl Header {
    fn new(words: Option<[&str; 2]>, width: f64) -> Self {
        let Some([title, subject]) = words else { return Header { lines: Vec::new(), top: TOP_PX } };
        let mut header = Header { lines: Vec::new(), top: 8.0 };
        for (words, [size, line_px], fill) in [(title, TITLE_PX, "black"), (subject, SUBJECT_PX, QUIET)] {
            for line in wrapped(words, size, width - TOP_PX).into_iter().filter(|_| !words.is_empty()) {
                header.top += line_px;
                let look = format!("font-size=\"{size}\" fill=\"{fill}\"");
                header.lines.push(((0.5 * width, header.top - 0.2 * size), look, line));
            }
        }
        header.top += TOP_PX;
        header
    }

    fn draw(&self, canvas: &mut Canvas) {
        for (at, look, words) in &self.lines {
            canvas.styled_text(*at, Anchor::Middle, look, words);
        }
    }
}

/// The points that have a place, in pixels.
fn places(canvas: &Canvas, points: &[Point]) -> Vec<Point> {
    points.iter().filter_map(|(x, y)| Some((canvas.x.px(*x)?, canvas.y.px(*y)?))).collect()
}

/// A line and its drawn parts between holes, in pixels.
struct Trace {
    label: String,
    group: usize,
    ink: Ink,
    runs: Vec<Vec<Point>>,
}

/// Draws a figure in a picture of a size, without its header and the legend under it.
fn drawn(
    figure: &FigureData,
    beside: &[&FigureData],
    [width, height]: [f64; 2],
    header: Option<[&str; 2]>,
) -> Panel {
    let header = Header::new(header, width);
    let height = height + header.top - TOP_PX;
    let [x, y] = rulers(figure, beside, width);
    let mut canvas = Canvas::in_picture(x, y, [width, height], header.top);
    header.draw(&mut canvas);
    for (from, to) in &figure.gaps {
        canvas.hole(*from, *to);
    }
    canvas.grid();
    figure.bands.iter().for_each(|band| draw_band(&mut canvas, figure, band));
    canvas.zeros();
    let traces = traces(&canvas, figure);
    for Trace { ink, runs, .. } in &traces {
        for run in runs {
            let colour = if run.len() == 1 { &ink.dark } else { &ink.colour };
            canvas.line(run, Stroke { colour, width_px: ink.width_px, dash: &ink.dash });
        }
    }
    canvas.axes();
    for Mark { x, y, low, high, condition_index, is_ring, .. } in &figure.marks {
        let _ = canvas.mark(*x, [*low, *y, *high], &mark_colour(figure, *condition_index), *is_ring);
    }
    let labelled = label_lines(&mut canvas, figure, &traces);
    let is_labelled = |at: usize| labelled.contains(&label_group(figure, at));
    let height = legend::append(&mut canvas, figure, is_labelled, [width, height]);
    Panel { size: [width, height], elements: canvas.svg }
}

/// Returns the axes of a figure around all points of figures that share them.
fn rulers(figure: &FigureData, beside: &[&FigureData], width: f64) -> [Ruler; 2] {
    let lines =
        beside.iter().flat_map(|figure| &figure.series).flat_map(|series| series.points.iter().copied());
    let marks = beside.iter().flat_map(|figure| &figure.marks);
    let bands = beside.iter().flat_map(|figure| &figure.bands).filter(|band| band.kind == BandKind::Interval);
    let points: Vec<Point> = lines
        .chain(marks.flat_map(|mark| [(mark.x, mark.low), (mark.x, mark.high)]))
        .chain(bands.flat_map(|band| &band.points).flat_map(|(x, ends)| ends.map(|y| (*x, y))))
        .collect();
    let ruler =
        |values: &mut dyn Iterator<Item = f64>, scale, words, label: &str, most: f64, steps: f64| match scale
        {
            AxisScale::Logarithmic => Ruler::decades(values, words, label, most),
            AxisScale::Linear => Ruler::steps(values, words, label, most.min(steps)),
        };
    let most = if width < WIDTH_PX { width / TICK_ROOM_PX } else { f64::INFINITY };
    let x_words = if figure.x.kind() == AxisKind::Length { TickWords::Length } else { TickWords::Number };
    let y_words = match figure.shows {
        shows if shows.draws_areas() => TickWords::Share,
        _ if figure.y_label.ends_with(" (m)") => TickWords::Length,
        _ => TickWords::Number,
    };
    let [across, upwards] = MOST_STEPS;
    let x = &mut points.iter().map(|point| point.0);
    let y = &mut points.iter().map(|point| point.1);
    let x_ruler = ruler(x, figure.x_scale, x_words, &figure.x_label, most, across);
    let y_ruler = ruler(y, figure.y_scale, y_words, figure.y_label, f64::INFINITY, upwards);
    let y = points.iter().map(|point| point.1).filter(|y| *y > 0.0);
    let is_share = y_words == TickWords::Share;
    let y_ruler = if is_share { y_ruler.cut_to(y.flat_map(|y| [floor_below(y), y])) } else { y_ruler };
    [x_ruler.cut_to(points.iter().map(|point| point.0)), y_ruler]
}

/// Returns the lines. Those that coincide have to be seen: solid ones are broad and pale, and dashed ones lie dark on top
/// of them.
fn traces(canvas: &Canvas, figure: &FigureData) -> Vec<Trace> {
    let is_crowded = figure.series.len() > MOST_LABELLED;
    let trace = |(at, series): (usize, &study::figure::Series)| {
        let label = if is_crowded { String::new() } else { label(figure, series) };
        let runs =
            figure.pieces(series).into_iter().map(|piece| thinned(places(canvas, &piece), MOST_POINTS));
        let runs = runs.filter(|run| !run.is_empty()).collect();
        Trace { label, group: label_group(figure, at), ink: Ink::new(figure, series), runs }
    };
    let traces = figure.series.iter().enumerate().map(trace);
    let (solid, dashed): (Vec<_>, Vec<_>) = traces.partition(|trace| trace.ink.dash.is_empty());
    solid.into_iter().chain(dashed).collect()
}

/// Writes labels beside the lines where they find room, and returns the groups of lines that have one.
fn label_lines(canvas: &mut Canvas, figure: &FigureData, traces: &[Trace]) -> Vec<usize> {
    let track = |trace: &Trace, run: &Vec<Point>| Track {
        label: trace.label.clone(),
        group: trace.group,
        points: run.clone(),
    };
    // Marks are in the way of labels and have none.
    let of_mark = |mark: &Mark| Track {
        label: String::new(),
        group: usize::MAX,
        points: places(canvas, &[(mark.x, mark.low), (mark.x, mark.high)]),
    };
    let of_lines = traces.iter().flat_map(|trace| trace.runs.iter().map(move |run| track(trace, run)));
    let tracks: Vec<Track> = of_lines.chain(figure.marks.iter().map(of_mark)).collect();
    let placed = labels::place(&tracks, canvas.frame, labels::SIZE_PX);
    for label in &placed {
        let mut inks = traces.iter().filter(|trace| trace.group == label.group).map(|trace| &trace.ink.dark);
        let first = inks.next().map_or("black", String::as_str);
        let dark = if inks.all(|other| other == first) { first } else { "black" };
        let place = (label.place.left, label.place.bottom - 0.15 * labels::SIZE_PX);
        let look = format!("font-size=\"{}\" fill=\"{dark}\"", labels::SIZE_PX);
        canvas.styled_text(place, Anchor::Start, &look, &label.text);
    }
    placed.iter().map(|label| label.group).collect()
}

/// Draws a band as far as it lies inside the frame. A yardstick breaks at holes of the spectrum; an interval does not,
/// since it tells what they leave open.
fn draw_band(canvas: &mut Canvas, figure: &FigureData, band: &FigureBand) {
    let dark = band_colour(figure, band);
    let is_interval = band.kind == BandKind::Interval;
    let drawn = if is_interval { vec![band.points.clone()] } else { pieces(&band.points, &figure.gaps) };
    let frame = canvas.frame;
    for piece in drawn {
        let in_pixels = |(x, ordinates): &(f64, [f64; 2])| {
            Some((canvas.x.px(*x)?, ordinates.map(|y| canvas.y.px(y).unwrap_or(f64::INFINITY))))
        };
        let is_inside = |(x, [lower, upper]): &(f64, [f64; 2])| {
            (frame.left..=frame.right).contains(x) && *upper <= frame.bottom && *lower >= frame.top
        };
        let held = |(x, ordinates): (f64, [f64; 2])| (x, ordinates.map(|y| y.clamp(frame.top, frame.bottom)));
        let points: Vec<(f64, [f64; 2])> =
            piece.iter().filter_map(in_pixels).filter(is_inside).map(held).collect();
        if points.is_empty() {
            continue;
        }
        let edge = |end: usize| points.iter().map(move |(x, ordinates)| (*x, ordinates[end]));
        let outline: Vec<Point> = edge(0).chain(edge(1).rev()).collect();
        let opacity = opacity(band.kind);
        canvas.svg += &format!(
            "<path class=\"band\" d=\"{}Z\" fill=\"{dark}\" fill-opacity=\"{opacity}\"/>\n",
            path(&outline)
        );
    }
}

#[cfg(test)]
mod tests;
