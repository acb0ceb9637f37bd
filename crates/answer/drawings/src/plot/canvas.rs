//! Axes, and shapes that are clipped to their frame.
//!
//! The library's own function for several plots brings the code of every kind of plot that it knows, a tenth of the page
//! for browsers. Figures here consist of lines and dots.

use kuva::plot::LinePlot;
use kuva::render::color::Color;
use kuva::render::layout::{ComputedLayout, Layout};
use kuva::render::render::{Primitive, Scene, render_line};

/// The radius of a line of one point.
const DOT_PX: f64 = 3.0;

/// The stroke of a line.
pub(super) struct Stroke<'a> {
    pub colour: &'a str,
    pub width_px: f64,
    pub dash: Option<String>,
}

/// Draws axes with their labels, and the shapes inside their frame. `id` is unique in the document.
pub(super) fn with_axes(
    layout: Layout,
    id: &str,
    shapes: impl FnOnce(&ComputedLayout) -> Vec<Primitive>,
) -> Scene {
    let computed = ComputedLayout::from_layout(&layout);
    let mut scene = render_line(&LinePlot::new(), layout);
    let [x, y, width, height] =
        [computed.margin_left, computed.margin_top, computed.plot_width(), computed.plot_height()];
    let id = format!("{id}-area");
    let [left, top, across, down] = [x, y, width, height].map(in_hundredths);
    scene.defs.push(format!(
        "<clipPath id=\"{id}\"><rect x=\"{left}\" y=\"{top}\" width=\"{across}\" height=\"{down}\"/></clipPath>"
    ));
    scene.add(Primitive::ClipStart { x, y, width, height, id });
    scene.elements.extend(shapes(&computed));
    scene.add(Primitive::ClipEnd);
    scene
}

/// A line through points in the units of the axes.
pub(super) fn line(computed: &ComputedLayout, points: &[(f64, f64)], stroke: Stroke<'_>) -> Primitive {
    Primitive::PolyLine {
        points: points.iter().map(|(x, y)| (computed.map_x(*x), computed.map_y(*y))).collect(),
        stroke: Color::from(stroke.colour),
        stroke_width: stroke.width_px,
        stroke_dasharray: stroke.dash,
    }
}

/// A dot at a point in the units of the axes.
pub(super) fn dot(computed: &ComputedLayout, (x, y): (f64, f64), colour: &str) -> Primitive {
    Primitive::Circle {
        cx: computed.map_x(x),
        cy: computed.map_y(y),
        r: DOT_PX,
        fill: Color::from(colour),
        fill_opacity: None,
        stroke: None,
        stroke_width: None,
    }
}

/// Rounds as the library does.
fn in_hundredths(px: f64) -> f64 {
    (100.0 * px).round() * 0.01
}
