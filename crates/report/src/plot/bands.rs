//! Bands that lines are held against: pale, between two thin lines. The legend names them.

use kuva::render::color::Color;
use kuva::render::layout::ComputedLayout;
use kuva::render::render::{PathData, Primitive, Scene};

use super::labels::Box;
use super::style::colour;
use study::figure::Band;

/// How much of its colour a band has.
pub(super) const OPACITY: f64 = 0.18;

/// Draws the bands as far as they lie inside the frame.
pub(super) fn draw(scene: &mut Scene, computed: &ComputedLayout, frame: Box, bands: &[Band]) {
    for band in bands {
        let inside = visible(computed, frame, band);
        if inside.is_empty() {
            continue;
        }
        scene.add(Primitive::Path(std::boxed::Box::new(PathData {
            d: outline(&inside),
            fill: Some(Color::from(colour(band.colour).as_str())),
            stroke: Color::from(colour(band.colour).as_str()),
            stroke_width: 0.4,
            opacity: Some(OPACITY),
            stroke_dasharray: None,
        })));
    }
}

/// The points in pixels, lower ordinate first, both held inside the frame; those with neither inside are left out.
fn visible(computed: &ComputedLayout, frame: Box, band: &Band) -> Vec<(f64, [f64; 2])> {
    let in_pixels = |(x, ordinates): &(f64, [f64; 2])| {
        (computed.map_x(x.log10()), ordinates.map(|y| computed.map_y(y.log10())))
    };
    let is_inside = |(x, [lower, upper]): &(f64, [f64; 2])| {
        (frame.left..=frame.right).contains(x) && *upper <= frame.bottom && *lower >= frame.top
    };
    let held = |(x, ordinates): (f64, [f64; 2])| (x, ordinates.map(|y| y.clamp(frame.top, frame.bottom)));
    band.points.iter().map(in_pixels).filter(is_inside).map(held).collect()
}

/// Along the lower ordinates, and back along the upper ones.
fn outline(points: &[(f64, [f64; 2])]) -> String {
    let there = points.iter().map(|(x, [lower, _])| (x, lower));
    let back = points.iter().rev().map(|(x, [_, upper])| (x, upper));
    let steps = there.chain(back).enumerate();
    let step =
        |(at, (x, y)): (usize, (&f64, &f64))| format!("{}{x:.2} {y:.2}", if at == 0 { "M" } else { " L" });
    steps.map(step).chain([" Z".to_owned()]).collect()
}
