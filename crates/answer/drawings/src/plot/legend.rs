//! The legend under a plot: a colour for each condition and a dash pattern for each curve, rather than an entry for each
//! pair of them.

use kuva::plot::line::LineStyle;
use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene, TextAnchor};

use super::bands::{EDGE_PX, INTERVAL_OPACITY, OPACITY};
use super::marks;
use super::style::{Ink, NEUTRAL, colour, colour_index, condition_width_px, tint};
use super::text_width_px;
use study::figure::{BandKind, FigureData, Series};
use units::display::typeset;

const SIZE_PX: f64 = 12.0;
pub(super) const ROW_PX: f64 = 18.0;
/// The length of a sample, long enough to show its dash pattern.
const SAMPLE_PX: f64 = 34.0;
const GAP_PX: f64 = 6.0;
const BAND_PX: f64 = 8.0;

pub(super) struct Entry<'a> {
    pub label: &'a str,
    pub colour: String,
    pub sample: Sample,
}

/// The sample before a label.
pub(super) enum Sample {
    Line {
        dash: Option<String>,
        width_px: f64,
    },
    /// Nothing, and no room for it.
    None,
    Disc {
        is_ring: bool,
    },
    /// A pale stretch, for bands of any colour; those of intervals have edges.
    Band(BandKind),
}

impl Sample {
    fn line(style: LineStyle, width_px: f64) -> Self {
        Sample::Line { dash: style.dasharray(), width_px }
    }

    /// The room that it takes before the label.
    fn room_px(&self) -> f64 {
        if matches!(self, Sample::None) { 0.0 } else { SAMPLE_PX + GAP_PX }
    }
}

/// Draws the legend below the picture, between two abscissas, and extends the picture. `is_labelled` tells which lines have
/// labels of their own.
pub(super) fn append(
    scene: &mut Scene,
    figure: &FigureData,
    is_labelled: impl Fn(usize) -> bool,
    [left, right]: [f64; 2],
) {
    let mut baseline = scene.height;
    let groups = entries(figure, is_labelled);
    let lines = |entry: &Entry<'_>| wrapped(entry.label, right - 2.0 * GAP_PX - entry.sample.room_px());
    let width = |entry: &Entry<'_>| {
        let text = lines(entry).iter().map(|line| text_width_px(line, SIZE_PX)).fold(0.0, f64::max);
        entry.sample.room_px() + text + 2.0 * GAP_PX
    };
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
            let lines = lines(entry);
            draw(scene, entry, &lines, [x, baseline - GAP_PX]);
            baseline += ROW_PX * (lines.len() - 1) as f64;
            x += width;
        }
    }
    scene.height = baseline + if baseline > scene.height { GAP_PX } else { 0.0 };
}

/// The entries of a legend, in groups that each begin a row.
pub(super) fn entries(figure: &FigureData, is_labelled: impl Fn(usize) -> bool) -> [Vec<Entry<'_>>; 4] {
    [conditions(figure, is_labelled), curves(figure), marked(figure), banded(figure)]
}

/// The lines of a label that is wider than its room.
fn wrapped(label: &str, room_px: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in label.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width_px(&format!("{line} {word}"), SIZE_PX) <= room_px => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn draw(scene: &mut Scene, entry: &Entry<'_>, lines: &[String], [x, baseline]: [f64; 2]) {
    let y = baseline - 0.35 * SIZE_PX;
    match &entry.sample {
        Sample::Line { dash, width_px } => scene.add(Primitive::Line {
            x1: x,
            y1: y,
            x2: x + SAMPLE_PX,
            y2: y,
            stroke: Color::from(entry.colour.as_str()),
            stroke_width: *width_px,
            stroke_dasharray: dash.clone(),
        }),
        Sample::Disc { is_ring } => marks::disc(scene, x + 0.5 * SAMPLE_PX, y, &entry.colour, *is_ring),
        Sample::Band(kind) => band(scene, *kind, x, y, &entry.colour),
        Sample::None => {}
    }
    for (at, line) in lines.iter().enumerate() {
        scene.add(Primitive::Text {
            x: x + entry.sample.room_px(),
            y: baseline + ROW_PX * at as f64,
            content: line.clone(),
            size: SIZE_PX as u32,
            anchor: TextAnchor::Start,
            rotate: None,
            bold: false,
            color: None,
        });
    }
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

/// Entries for conditions, with their colours, or, where colours belong to models, with the widths of their lines.
/// Conditions that labels at all of their lines spell out have none.
fn conditions(figure: &FigureData, is_labelled: impl Fn(usize) -> bool) -> Vec<Entry<'_>> {
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for (at, series) in figure.series.iter().enumerate() {
        let label = series.condition_in_full.as_str();
        let is_spelt_out = is_labelled(at) && label == typeset(&series.condition);
        if label.is_empty() || is_spelt_out || entries.iter().any(|entry| entry.label == label) {
            continue;
        }
        let (index, sample) = match series.look {
            Some(_) => (NEUTRAL, condition_width_px(figure, series.condition_index)),
            None => (colour_index(figure, series.condition_index), Some(2.0)),
        };
        let sample = sample.map_or(Sample::None, |width_px| Sample::line(LineStyle::Solid, width_px));
        entries.push(Entry { label, colour: colour(index), sample });
    }
    entries
}

/// Entries for the curves: of models always, of others if several share the figure, in grey like their lines in colour.
fn curves(figure: &FigureData) -> Vec<Entry<'_>> {
    let compared = figure.compares_curves();
    let named = figure.series.iter().filter(|series| !series.curve.is_empty());
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for series in named.filter(|series| compared || series.look.is_some()) {
        if !entries.iter().any(|entry| entry.label == series.curve) {
            let grey = Series { condition_index: None, ..series.clone() };
            let ink = Ink::new(figure, &grey);
            let colour = match (series.look, ink.is_solid()) {
                (Some(_), _) => ink.colour,
                (None, true) => tint(NEUTRAL),
                (None, false) => colour(NEUTRAL),
            };
            entries.push(Entry {
                label: &series.curve,
                colour,
                sample: Sample::line(ink.dash, ink.width_px),
            });
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_wider_than_its_room_is_wrapped_between_words() {
        let label = "Sinusoids, elastic-plastic, growing hardness";
        assert_eq!(wrapped(label, 1000.0), [label]);
        let lines = wrapped(label, 200.0);
        assert!(
            lines.len() > 1 && lines.iter().all(|line| text_width_px(line, SIZE_PX) <= 200.0),
            "{lines:?}"
        );
        assert_eq!(lines.join(" "), label);
    }
}
