//! The legend under a plot: a colour for each condition and a dash pattern for each curve, rather than an entry for each
//! pair of them.

use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene, TextAnchor};

use super::bands::{EDGE_PX, INTERVAL_OPACITY, OPACITY};
use super::marks;
use super::style::{NEUTRAL, colour, colour_index, dash, dash_index, tint};
use super::text_width_px;
use study::figure::{BandKind, FigureData};

const SIZE_PX: f64 = 12.0;
const ROW_PX: f64 = 18.0;
/// The length of a sample, long enough to show its dash pattern.
const SAMPLE_PX: f64 = 34.0;
const GAP_PX: f64 = 6.0;
const BAND_PX: f64 = 8.0;

struct Entry<'a> {
    label: &'a str,
    colour: String,
    sample: Sample,
}

/// The sample before a label.
enum Sample {
    Line {
        dash: usize,
        width_px: f64,
    },
    Disc {
        is_ring: bool,
    },
    /// A pale stretch, for bands of any colour; those of intervals have edges.
    Band(BandKind),
}

/// Draws the legend below the picture, between two abscissas, and extends the picture.
pub(super) fn append(scene: &mut Scene, figure: &FigureData, left: f64, right: f64) {
    let mut baseline = scene.height;
    let groups = [conditions(figure), curves(figure), marked(figure), banded(figure)];
    let width = |entry: &Entry<'_>| SAMPLE_PX + GAP_PX + text_width_px(entry.label, SIZE_PX) + 2.0 * GAP_PX;
    // A name too long for the place under the axes begins further to the left, and all of them with it.
    let longest = groups.iter().flatten().map(width).fold(0.0, f64::max);
    let left = left.min(right - longest).max(GAP_PX);
    for group in groups {
        let mut x = left;
        for (i, entry) in group.iter().enumerate() {
            let width = width(entry);
            if i == 0 || x + width > right {
                x = left;
                baseline += ROW_PX;
            }
            draw(scene, entry, x, baseline - GAP_PX);
            x += width;
        }
    }
    scene.height = baseline + if baseline > scene.height { GAP_PX } else { 0.0 };
}

fn draw(scene: &mut Scene, entry: &Entry<'_>, x: f64, baseline: f64) {
    let y = baseline - 0.35 * SIZE_PX;
    match entry.sample {
        Sample::Line { dash: pattern, width_px } => scene.add(Primitive::Line {
            x1: x,
            y1: y,
            x2: x + SAMPLE_PX,
            y2: y,
            stroke: Color::from(entry.colour.as_str()),
            stroke_width: width_px,
            stroke_dasharray: dash(pattern).dasharray(),
        }),
        Sample::Disc { is_ring } => marks::disc(scene, x + 0.5 * SAMPLE_PX, y, &entry.colour, is_ring),
        Sample::Band(kind) => band(scene, kind, x, y, &entry.colour),
    }
    scene.add(Primitive::Text {
        x: x + SAMPLE_PX + GAP_PX,
        y: baseline,
        content: entry.label.to_owned(),
        size: SIZE_PX as u32,
        anchor: TextAnchor::Start,
        rotate: None,
        bold: false,
        color: None,
    });
}

/// A stretch of a band around the middle of a row.
fn band(scene: &mut Scene, kind: BandKind, x: f64, y: f64, colour: &str) {
    let opacity = match kind {
        BandKind::Yardstick => OPACITY,
        BandKind::Interval => INTERVAL_OPACITY,
    };
    let (top, bottom) = (y - 0.5 * BAND_PX, y + 0.5 * BAND_PX);
    scene.add(Primitive::Rect {
        x,
        y: top,
        width: SAMPLE_PX,
        height: BAND_PX,
        fill: Color::from(colour),
        stroke: None,
        stroke_width: None,
        opacity: Some(opacity),
    });
    if kind == BandKind::Interval {
        for edge in [top, bottom] {
            scene.add(Primitive::Line {
                x1: x,
                y1: edge,
                x2: x + SAMPLE_PX,
                y2: edge,
                stroke: Color::from(colour),
                stroke_width: EDGE_PX,
                stroke_dasharray: None,
            });
        }
    }
}

fn conditions(figure: &FigureData) -> Vec<Entry<'_>> {
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for series in figure.series.iter().filter(|series| !series.condition_in_full.is_empty()) {
        let label = series.condition_in_full.as_str();
        if !entries.iter().any(|entry| entry.label == label) {
            let sample = Sample::Line { dash: 0, width_px: 2.0 };
            let colour = colour(colour_index(figure, series.condition_index));
            entries.push(Entry { label, colour, sample });
        }
    }
    entries
}

/// Entries for the curves, if several share the figure; each is drawn in grey like its lines in colour.
fn curves(figure: &FigureData) -> Vec<Entry<'_>> {
    let compared = figure.compares_curves();
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for series in figure.series.iter().filter(|series| compared && !series.curve.is_empty()) {
        if !entries.iter().any(|entry| entry.label == series.curve) {
            let dash = dash_index(figure, series.curve_index);
            let (colour, width_px) = if dash == 0 { (tint(NEUTRAL), 3.5) } else { (colour(NEUTRAL), 1.6) };
            let sample = Sample::Line { dash, width_px };
            entries.push(Entry { label: &series.curve, colour, sample });
        }
    }
    entries
}

/// Entries for marks, in grey.
fn marked(figure: &FigureData) -> Vec<Entry<'_>> {
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for mark in &figure.marks {
        if !entries.iter().any(|entry| entry.label == mark.label) {
            entries.push(Entry {
                label: &mark.label,
                colour: colour(NEUTRAL),
                sample: Sample::Disc { is_ring: mark.is_ring },
            });
        }
    }
    entries
}

/// Entries for bands, one for each kind.
fn banded(figure: &FigureData) -> Vec<Entry<'_>> {
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for band in &figure.bands {
        if !entries.iter().any(|entry| entry.label == band.label) {
            entries.push(Entry {
                label: &band.label,
                colour: colour(NEUTRAL),
                sample: Sample::Band(band.kind),
            });
        }
    }
    entries
}
