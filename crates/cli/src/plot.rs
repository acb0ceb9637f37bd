//! Figures as SVG, with logarithmic axes, fit to print: the one module that knows the plotting library.

use std::sync::Arc;

use kuva::TickFormat;
use kuva::backend::svg::SvgBackend;
use kuva::plot::legend::{LegendEntry, LegendPosition, LegendShape};
use kuva::plot::line::LineStyle;
use kuva::plot::{LinePlot, ScatterPlot};
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::render_multiple;

use crate::figure::{FigureData, Series};

/// Width of the plot, with its axes and without its legend.
const WIDTH_PX: f64 = 520.0;
/// What a legend needs beside the plot: the line samples, and a little more than the average letter.
const LEGEND_LINE_PX: f64 = 45.0;
const LEGEND_LETTER_PX: f64 = 7.0;
const MOST_TITLE_LETTERS: usize = 58;
const HEIGHT_PX: f64 = 420.0;
const MOST_TICKS: f64 = 9.0;

/// Colours that people with any colour vision tell apart, dark enough for thin lines (Okabe & Ito), and a tint of each.
const COLOURS: [(&str, &str); 6] = [
    ("#0072b2", "#99c7e0"),
    ("#d55e00", "#eebf99"),
    ("#009e73", "#99d8c7"),
    ("#b0568a", "#e4c3d6"),
    ("#c28400", "#f2d599"),
    ("#000000", "#b3b3b3"),
];

/// The figure as an SVG document. `subject` stands under its title; `provenance` is kept in it as a comment.
pub fn svg(figure: &FigureData, subject: &str, provenance: &[String]) -> String {
    // The library's own logarithmic axes end at 1e-10, and spectra reach 1e-40: decades are drawn as plain numbers.
    let points = || figure.series.iter().flat_map(|series| series.points.iter());
    let x = Decades::around(points().map(|(x, _)| *x));
    let y = Decades::around(points().map(|(_, y)| *y));
    let compared = figure.series.iter().any(|series| series.dash > 0);
    // Lines that coincide have to be seen: solid ones are broad and pale, and dashed ones lie dark on top of them.
    let (solid, dashed): (Vec<_>, Vec<_>) = figure.series.iter().partition(|series| series.dash == 0);
    let lines: Vec<Plot> = solid.into_iter().chain(dashed).map(|series| line(series, compared)).collect();
    let mut layout = Layout::auto_from_plots(&lines)
        .with_x_axis_min(x.first)
        .with_x_axis_max(x.last)
        .with_x_tick_step(x.step)
        .with_x_tick_format(powers_of_ten())
        .with_y_axis_min(y.first)
        .with_y_axis_max(y.last)
        .with_y_tick_step(y.step)
        .with_y_tick_format(powers_of_ten())
        .with_height(HEIGHT_PX)
        .with_box_axes()
        .with_title(figure.title.clone())
        .with_title_size(14)
        .with_title_wrap(MOST_TITLE_LETTERS)
        .with_subtitle(subject.to_owned())
        .with_subtitle_wrap(MOST_TITLE_LETTERS)
        .with_x_label(figure.x.label)
        .with_y_label(figure.y_label)
        .with_legend_box(false);
    let legend = legend(figure, compared);
    layout = layout.with_width(WIDTH_PX + legend_width_px(&legend));
    if !legend.is_empty() {
        layout = layout.with_legend_position(LegendPosition::OutsideRightTop).with_legend_entries(legend);
    }
    let svg = SvgBackend::default().render_scene(&render_multiple(lines, layout));
    with_comment(&with_plain_clip_name(&svg), provenance)
}

/// The library numbers its clip regions through the whole program; one picture has one of them.
fn with_plain_clip_name(svg: &str) -> String {
    let numbered = svg.split('"').find(|text| text.starts_with("kuva-clip-"));
    numbered.map_or_else(|| svg.to_owned(), |numbered| svg.replace(numbered, "plot-area"))
}

fn line(series: &Series, compared: bool) -> Plot {
    let drawn = series.points.iter().filter(|(_, y)| *y > 0.0);
    let points: Vec<(f64, f64)> = drawn.map(|(x, y)| (x.log10(), y.log10())).collect();
    let (dark, pale) = COLOURS[series.colour % COLOURS.len()];
    if points.len() == 1 {
        return Plot::Scatter(ScatterPlot::new().with_data(points).with_color(dark).with_size(3.0));
    }
    let (colour, width_px) = if compared && series.dash == 0 { (pale, 3.5) } else { (dark, 1.6) };
    let line = LinePlot::new().with_data(points).with_color(colour).with_stroke_width(width_px);
    Plot::Line(line.with_line_style(dash(series.dash)))
}

/// A colour for each condition and a dash pattern for each curve, rather than an entry for each pair of them.
fn legend(figure: &FigureData, compared: bool) -> Vec<LegendEntry> {
    let mut entries: Vec<LegendEntry> = Vec::new();
    let mut add = |label: &str, colour: &str, dasharray: Option<String>| {
        if !label.is_empty() && !entries.iter().any(|entry| entry.label == label) {
            let (label, color) = (label.to_owned(), colour.to_owned());
            entries.push(LegendEntry { label, color, shape: LegendShape::Line, dasharray });
        }
    };
    for series in &figure.series {
        add(&series.condition, COLOURS[series.colour % COLOURS.len()].0, None);
    }
    for series in figure.series.iter().filter(|_| compared) {
        let (dark, pale) = COLOURS[COLOURS.len() - 1];
        let colour = if series.dash == 0 { pale } else { dark };
        add(&series.curve, colour, dash(series.dash).dasharray());
    }
    entries
}

fn legend_width_px(entries: &[LegendEntry]) -> f64 {
    let letters = entries.iter().map(|entry| entry.label.chars().count()).max();
    letters.map_or(0.0, |letters| LEGEND_LINE_PX + LEGEND_LETTER_PX * letters as f64)
}

/// Dash patterns that stay apart in print.
fn dash(index: usize) -> LineStyle {
    [LineStyle::Solid, LineStyle::Custom("4 3".to_owned()), LineStyle::DashDot, LineStyle::Dotted][index % 4]
        .clone()
}

/// The range of an axis in powers of ten, and the step between its ticks.
struct Decades {
    first: f64,
    last: f64,
    step: f64,
}

impl Decades {
    fn around(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values
            .filter(|value| *value > 0.0)
            .map(f64::log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        if low > high {
            return Decades { first: 0.0, last: 1.0, step: 1.0 };
        }
        let span = (high.ceil() - low.floor()).max(1.0);
        let step = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0].into_iter().find(|step| span / step < MOST_TICKS);
        let step = step.unwrap_or(span);
        let first = (low / step).floor() * step;
        Decades { first, last: ((high / step).ceil() * step).max(first + step), step }
    }
}

/// Ticks labelled 10⁻⁸ and so on.
fn powers_of_ten() -> TickFormat {
    const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    TickFormat::Custom(Arc::new(|power| {
        let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| SUPERSCRIPTS[digit as usize]);
        format!("10{}", format!("{power:.0}").chars().map(raised).collect::<String>())
    }))
}

/// The document with a comment after its opening tag. Two hyphens would end the comment.
fn with_comment(svg: &str, lines: &[String]) -> String {
    let mut comment = lines.join("\n");
    while comment.contains("--") {
        comment = comment.replace("--", "- -");
    }
    match svg.find("<svg").and_then(|tag| svg[tag..].find('>').map(|end| tag + end + 1)) {
        Some(inside) => format!("{}\n<!--\n{comment}\n-->\n{}", &svg[..inside], &svg[inside..]),
        None => svg.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_figure_is_the_same_document_however_many_were_drawn_before() {
        let points = vec![(1.0, 1e-30), (10.0, 1e-20)];
        let series = Series {
            column: String::new(),
            curve: String::new(),
            condition: String::new(),
            colour: 0,
            dash: 0,
            points,
        };
        let axis = crate::figure::Axis { column: "x", label: "x" };
        let figure = FigureData {
            name: String::new(),
            title: String::new(),
            x: axis,
            y_label: "y",
            series: vec![series],
        };
        assert_eq!(svg(&figure, "", &[]), svg(&figure, "", &[]));
    }

    #[test]
    fn a_comment_never_ends_early() {
        let commented = with_comment("<svg a='b'></svg>", &["# -----".to_owned(), "--model".to_owned()]);
        let comment = commented.split("<!--").nth(1).unwrap().split("-->").next().unwrap();
        assert!(!comment.contains("--") && comment.contains("model"), "{commented}");
    }
}
