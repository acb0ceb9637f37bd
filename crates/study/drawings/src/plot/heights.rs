//! Heights along a line, on plain axes.

use kuva::plot::LinePlot;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;
use kuva::render::render::render_multiple;

use super::style::colour;
use super::thinned::thinned;
use super::{HEIGHT_PX, MAX_TITLE_LETTERS, WIDE_PX, split};

/// Draws runs of positions and heights, both in the units of their labels, as an SVG document. Runs are not joined:
/// missing points lie between them.
#[must_use]
pub fn line_of_heights(title: &str, labels: [&str; 2], runs: &[Vec<(f64, f64)>]) -> String {
    let line = |run: &Vec<(f64, f64)>| {
        Plot::Line(
            LinePlot::new().with_data(thinned(run.clone())).with_color(colour(0)).with_stroke_width(1.2),
        )
    };
    let lines: Vec<Plot> = runs.iter().filter(|run| !run.is_empty()).map(line).collect();
    let layout = Layout::auto_from_plots(&lines)
        .with_width(WIDE_PX)
        .with_height(HEIGHT_PX)
        .with_title(title.to_owned())
        .with_title_size(14)
        .with_title_wrap(2 * MAX_TITLE_LETTERS)
        .with_box_axes()
        .with_label_size(13)
        .with_x_label(labels[0].to_owned())
        .with_y_label(labels[1].to_owned());
    let (opening, inside) = split(&render_multiple(lines, layout), "heights");
    format!("{opening}>{inside}")
}
