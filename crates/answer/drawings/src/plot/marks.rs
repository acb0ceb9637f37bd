//! Values with error bars.

use kuva::render::color::Color;
use kuva::render::layout::ComputedLayout;
use kuva::render::render::{Primitive, Scene};
use study::figure::Mark;

use super::ruler::Rulers;

const RADIUS_PX: f64 = 3.0;
const CAP_PX: f64 = 3.0;
const WIDTH_PX: f64 = 1.2;

/// Both ends of a mark, for the range of the axes.
pub(super) fn ends(mark: &Mark) -> [(f64, f64); 2] {
    [(mark.x, mark.low), (mark.x, mark.high)]
}

/// Draws a mark among the lines in their colour: a disc, and a bar with caps from the least to the largest value.
pub(super) fn draw(scene: &mut Scene, computed: &ComputedLayout, rulers: &Rulers, mark: &Mark, dark: &str) {
    let y_px = |value| rulers.y_px(computed, value);
    let (Some(x), Some(y), Some(low), Some(high)) =
        (rulers.x_px(computed, mark.x), y_px(mark.y), y_px(mark.low), y_px(mark.high))
    else {
        return;
    };
    let mut line = |x1: f64, y1: f64, x2: f64, y2: f64| {
        let stroke = Color::from(dark);
        scene.add(Primitive::Line { x1, y1, x2, y2, stroke, stroke_width: WIDTH_PX, stroke_dasharray: None });
    };
    line(x, low, x, high);
    line(x - CAP_PX, low, x + CAP_PX, low);
    line(x - CAP_PX, high, x + CAP_PX, high);
    disc(scene, x, y, dark, mark.is_ring);
}

/// A disc with a white rim, which is seen on top of lines, or a ring.
pub(super) fn disc(scene: &mut Scene, x: f64, y: f64, colour: &str, is_ring: bool) {
    let (fill, rim, rim_px) = if is_ring { ("white", colour, 1.4) } else { (colour, "white", 0.8) };
    scene.add(Primitive::Circle {
        cx: x,
        cy: y,
        r: RADIUS_PX,
        fill: Color::from(fill),
        fill_opacity: None,
        stroke: Some(Color::from(rim)),
        stroke_width: Some(rim_px),
    });
}
