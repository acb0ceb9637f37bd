//! Figures as SVG, with logarithmic axes, fit to print: the one module that knows the plotting library.

use std::sync::Arc;

use kuva::TickFormat;
use kuva::backend::svg::SvgBackend;
use kuva::plot::LinePlot;
use kuva::plot::legend::LegendPosition;
use kuva::plot::line::LineStyle;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::render_multiple;

use crate::figure::FigureData;

const WIDTH_PX: f64 = 560.0;
const HEIGHT_PX: f64 = 420.0;
const MOST_TICKS: f64 = 9.0;

/// Colours that people with any colour vision tell apart, dark enough for thin lines (Okabe & Ito).
const COLOURS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#000000"];

/// The figure as an SVG document. `subject` stands under its title; `provenance` is kept in it as a comment.
pub fn svg(figure: &FigureData, subject: &str, provenance: &[String]) -> String {
    // The library's own logarithmic axes end at 1e-10, and spectra reach 1e-40: decades are drawn as plain numbers.
    let x = Decades::around(figure.x.iter().copied());
    let y = Decades::around(figure.series.iter().flat_map(|series| series.values.iter().copied()));
    let lines: Vec<Plot> = figure
        .series
        .iter()
        .map(|series| {
            let points: Vec<(f64, f64)> =
                figure.x.iter().zip(&series.values).map(|(x, y)| (x.log10(), y.log10())).collect();
            let line = LinePlot::new()
                .with_data(points)
                .with_color(COLOURS[series.colour % COLOURS.len()])
                .with_line_style(dash(series.dash))
                .with_stroke_width(1.8);
            Plot::Line(match &series.legend {
                Some(legend) => line.with_legend(legend.clone()),
                None => line,
            })
        })
        .collect();
    let layout = Layout::auto_from_plots(&lines)
        .with_x_axis_min(x.first)
        .with_x_axis_max(x.last)
        .with_x_tick_step(x.step)
        .with_x_tick_format(powers_of_ten())
        .with_y_axis_min(y.first)
        .with_y_axis_max(y.last)
        .with_y_tick_step(y.step)
        .with_y_tick_format(powers_of_ten())
        .with_width(WIDTH_PX)
        .with_height(HEIGHT_PX)
        .with_box_axes()
        .with_title(figure.title.clone())
        .with_title_size(15)
        .with_subtitle(subject.to_owned())
        .with_x_label(figure.x_label)
        .with_y_label(figure.y_label)
        .with_legend_position(LegendPosition::OutsideRightTop)
        .with_legend_box(false);
    let svg = SvgBackend::default().render_scene(&render_multiple(lines, layout));
    with_comment(&svg, provenance)
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
    let comment = lines.join("\n").replace("--", "- -");
    match svg.find("<svg").and_then(|tag| svg[tag..].find('>').map(|end| tag + end + 1)) {
        Some(inside) => format!("{}\n<!--\n{comment}\n-->\n{}", &svg[..inside], &svg[inside..]),
        None => svg.to_owned(),
    }
}
