//! Pale bands around lines and beside them. An interval has edges in the dash pattern of its line; a yardstick has
//! none. The legend names both.

use kuva::render::color::Color;
use kuva::render::layout::ComputedLayout;
use kuva::render::render::{PathData, Primitive, Scene};

use super::labels::Box;
use super::style::{colour, colour_index, dash, dash_index};
use study::figure::{Band, BandKind, FigureData};

/// The opacity of a yardstick.
pub(super) const OPACITY: f64 = 0.18;
/// The opacity of an interval, of which several may overlap.
pub(super) const INTERVAL_OPACITY: f64 = 0.1;
/// The width of the edges of an interval, thinner than any line of a curve.
pub(super) const EDGE_PX: f64 = 0.75;

/// Draws the bands as far as they lie inside the frame.
pub(super) fn draw(scene: &mut Scene, computed: &ComputedLayout, frame: Box, figure: &FigureData) {
    for band in &figure.bands {
        let inside = visible(computed, frame, band);
        if inside.is_empty() {
            continue;
        }
        let dark = colour(colour_index(figure, band.load));
        let opacity = match band.kind {
            BandKind::Yardstick => OPACITY,
            BandKind::Interval => INTERVAL_OPACITY,
        };
        scene.add(Primitive::Path(std::boxed::Box::new(PathData {
            d: outline(&inside),
            fill: Some(Color::from(dark.as_str())),
            stroke: Color::from(dark.as_str()),
            stroke_width: 0.4,
            opacity: Some(opacity),
            stroke_dasharray: None,
        })));
        if band.kind == BandKind::Interval {
            for end in [0, 1] {
                scene.add(Primitive::Path(std::boxed::Box::new(PathData {
                    d: steps(inside.iter().map(|(x, ordinates)| (*x, ordinates[end]))),
                    fill: None,
                    stroke: Color::from(dark.as_str()),
                    stroke_width: EDGE_PX,
                    opacity: None,
                    stroke_dasharray: dash(dash_index(figure, band.curve_index)).dasharray(),
                })));
            }
        }
    }
}

/// Both ends of an interval at every abscissa, for the range of the axes; empty for a yardstick.
pub(super) fn ends(band: &Band) -> impl Iterator<Item = (f64, f64)> + '_ {
    let of_lines = band.kind == BandKind::Interval;
    band.points.iter().filter(move |_| of_lines).flat_map(|(x, ordinates)| ordinates.map(|y| (*x, y)))
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

/// A path along the lower ordinates and back along the upper ones.
fn outline(points: &[(f64, [f64; 2])]) -> String {
    let there = points.iter().map(|(x, [lower, _])| (*x, *lower));
    let back = points.iter().rev().map(|(x, [_, upper])| (*x, *upper));
    steps(there.chain(back)) + " Z"
}

/// A path from each point to the next.
fn steps(points: impl Iterator<Item = (f64, f64)>) -> String {
    let step =
        |(at, (x, y)): (usize, (f64, f64))| format!("{}{x:.2} {y:.2}", if at == 0 { "M" } else { " L" });
    points.enumerate().map(step).collect()
}
