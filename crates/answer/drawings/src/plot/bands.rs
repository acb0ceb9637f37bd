//! Pale bands around lines and beside them. An interval has edges in the dash pattern of its line; a yardstick has
//! none. The legend names both.

use kuva::render::color::Color;
use kuva::render::layout::ComputedLayout;
use kuva::render::render::{PathData, Primitive, Scene};

use super::labels::Box;
use super::ruler::Rulers;
use super::style::{Ink, NEUTRAL, colour, colour_index, dash, dash_index};
use study::figure::{Band, BandKind, FigureData, pieces};

/// The opacity of a yardstick.
pub(super) const OPACITY: f64 = 0.18;
/// The opacity of an interval, of which several may overlap.
pub(super) const INTERVAL_OPACITY: f64 = 0.1;
/// The width of the edges of an interval, thinner than any line of a curve.
pub(super) const EDGE_PX: f64 = 0.75;

/// Draws the bands as far as they lie inside the frame. A yardstick breaks at holes of the spectrum; an interval does not,
/// since it tells what they leave open.
pub(super) fn draw(
    scene: &mut Scene,
    computed: &ComputedLayout,
    rulers: &Rulers,
    frame: Box,
    figure: &FigureData,
) {
    for band in &figure.bands {
        let drawn = match band.kind {
            BandKind::Yardstick => pieces(&band.points, &figure.gaps),
            BandKind::Interval => vec![band.points.clone()],
        };
        for points in drawn {
            draw_piece(scene, figure, band, &visible(computed, rulers, frame, &points));
        }
    }
}

fn draw_piece(scene: &mut Scene, figure: &FigureData, band: &Band, points: &[(f64, [f64; 2])]) {
    if points.is_empty() {
        return;
    }
    let ink = ink(figure, band);
    let dark = Color::from(ink.dark.as_str());
    let (opacity, stroke_width) = match band.kind {
        BandKind::Yardstick => (OPACITY, 0.0),
        BandKind::Interval => (INTERVAL_OPACITY, 0.4),
    };
    scene.add(Primitive::Path(std::boxed::Box::new(PathData {
        d: outline(points),
        fill: Some(dark.clone()),
        stroke: dark.clone(),
        stroke_width,
        opacity: Some(opacity),
        stroke_dasharray: None,
    })));
    let edges: &[usize] = if band.kind == BandKind::Interval { &[0, 1] } else { &[] };
    for &end in edges {
        scene.add(Primitive::Path(std::boxed::Box::new(PathData {
            d: steps(points.iter().map(|(x, ordinates)| (*x, ordinates[end]))),
            fill: None,
            stroke: dark.clone(),
            stroke_width: EDGE_PX,
            opacity: None,
            stroke_dasharray: ink.dash.dasharray(),
        })));
    }
}

/// The look of a band: that of its line, or black for a yardstick among lines of models.
pub(super) fn ink(figure: &FigureData, band: &Band) -> Ink {
    let mut lines = figure.series.iter().filter(|series| series.look.is_some());
    let line = match band.kind {
        BandKind::Interval => lines.find(|series| series.curve_index == band.curve_index),
        BandKind::Yardstick => None,
    };
    if let Some(line) = line {
        return Ink::new(figure, line);
    }
    let has_models = figure.series.iter().any(|series| series.look.is_some());
    let dark = colour(if has_models { NEUTRAL } else { colour_index(figure, band.load) });
    let pattern = dash(dash_index(figure, band.curve_index));
    Ink { colour: dark.clone(), dark, width_px: EDGE_PX, dash: pattern }
}

/// Both ends of an interval at every abscissa, for the range of the axes; empty for a yardstick.
pub(super) fn ends(band: &Band) -> impl Iterator<Item = (f64, f64)> + '_ {
    let of_lines = band.kind == BandKind::Interval;
    band.points.iter().filter(move |_| of_lines).flat_map(|(x, ordinates)| ordinates.map(|y| (*x, y)))
}

/// The points in pixels, lower ordinate first, both held inside the frame; those with neither inside are left out.
fn visible(
    computed: &ComputedLayout,
    rulers: &Rulers,
    frame: Box,
    points: &[(f64, [f64; 2])],
) -> Vec<(f64, [f64; 2])> {
    // An ordinate without a place, 0 on a logarithmic axis, lies below all others.
    let in_pixels = |(x, ordinates): &(f64, [f64; 2])| {
        let y_px = |y| rulers.y_px(computed, y).unwrap_or(f64::INFINITY);
        Some((rulers.x_px(computed, *x)?, ordinates.map(y_px)))
    };
    let is_inside = |(x, [lower, upper]): &(f64, [f64; 2])| {
        (frame.left..=frame.right).contains(x) && *upper <= frame.bottom && *lower >= frame.top
    };
    let held = |(x, ordinates): (f64, [f64; 2])| (x, ordinates.map(|y| y.clamp(frame.top, frame.bottom)));
    points.iter().filter_map(in_pixels).filter(is_inside).map(held).collect()
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
