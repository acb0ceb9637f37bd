//! Lines on plain axes, and panels that share a picture.

use std::fmt::Write;

use kuva::render::layout::Layout;

use super::canvas::{self, Stroke};
use super::split;
use super::style::colour;
use super::thinned::thinned;

/// SVG elements within a rectangle that begins at the origin.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel {
    /// Width and height in px.
    pub size: [f64; 2],
    /// The elements.
    pub elements: String,
}

impl Panel {
    /// Draws runs of positions and values, both in the units of their labels. Runs are not joined: missing points lie
    /// between them. The name is unique in the picture.
    pub fn lines(
        name: &str,
        title: &str,
        labels: [&str; 2],
        runs: &[Vec<(f64, f64)>],
        size: [f64; 2],
    ) -> Self {
        let runs: Vec<Vec<(f64, f64)>> =
            runs.iter().filter(|run| !run.is_empty()).map(|run| thinned(run.clone())).collect();
        let colour = colour(0);
        let layout = around(&runs)
            .with_width(size[0])
            .with_height(size[1])
            .with_title(title.to_owned())
            .with_title_size(14)
            .with_title_wrap((size[0] / 8.0) as usize)
            .with_box_axes()
            .with_label_size(13)
            .with_x_label(labels[0].to_owned())
            .with_y_label(labels[1].to_owned());
        let scene = canvas::with_axes(layout, name, |computed| {
            let stroke = || Stroke { colour: &colour, width_px: 1.2, dash: None };
            runs.iter().map(|run| canvas::line(computed, run, stroke())).collect()
        });
        let (_, inside) = split(&scene);
        let elements = inside.trim_end().trim_end_matches("</svg>").to_owned();
        Panel { size: [scene.width, scene.height], elements }
    }

    /// Puts another panel below this one.
    pub fn above(self, other: &Panel) -> Self {
        let [width, height] = self.size;
        self.with([0.0, height], other, [width.max(other.size[0]), height + other.size[1]])
    }

    /// Puts another panel to the right of this one.
    pub fn beside(self, other: &Panel) -> Self {
        let [width, height] = self.size;
        self.with([width, 0.0], other, [width + other.size[0], height.max(other.size[1])])
    }

    fn with(mut self, [x, y]: [f64; 2], other: &Panel, size: [f64; 2]) -> Self {
        let _ = writeln!(self.elements, "<g transform=\"translate({x},{y})\">\n{}</g>", other.elements);
        Panel { size, ..self }
    }

    /// The panel as an SVG document.
    pub fn document(&self) -> String {
        let [width, height] = self.size;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\" font-size=\"13\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{}</svg>\n",
            self.elements
        )
    }
}

/// Axes with a little room around all points.
fn around(runs: &[Vec<(f64, f64)>]) -> Layout {
    let range = |of: fn(&(f64, f64)) -> f64| {
        let values = || runs.iter().flatten().map(of);
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
    };
    let with_room = |(least, most): (f64, f64)| {
        let room = 0.01 * (most - least);
        (if least >= 0.0 { (least - room).max(0.0) } else { least - room }, most + room)
    };
    let [x, y] = [range(|point| point.0), range(|point| point.1)];
    let mut layout = Layout::new(with_room(x), with_room(y));
    layout.data_x_range = Some(x);
    layout.data_y_range = Some(y);
    layout.anchor_y_zero = false;
    layout
}
