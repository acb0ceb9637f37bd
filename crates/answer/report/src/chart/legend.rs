//! The legend under a figure: a colour for each condition and a dash pattern for each curve, rather than an entry for each
//! pair of them.

use study::figure::{BandKind, FigureData, Mark, Series};
use units::display::typeset;

use super::canvas::{Anchor, Canvas, LETTERS_PX, Rect, Stroke, disc, text_width_px, wrapped};
use super::ink::{EDGE_PX, Ink, condition_width_px, opacity};
use super::palette::{NEUTRAL, colour, tint};

const ROW_PX: f64 = 18.0;
/// The length of a sample, long enough to show its dash pattern.
const SAMPLE_PX: f64 = 34.0;
const GAP_PX: f64 = 6.0;

struct Entry<'a> {
    label: &'a str,
    colour: String,
    sample: Sample,
}

/// The sample before a label.
enum Sample {
    Line {
        dash: String,
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

impl Entry<'_> {
    /// The room before the label.
    fn sample_px(&self) -> f64 {
        if matches!(self.sample, Sample::None) { 0.0 } else { SAMPLE_PX + GAP_PX }
    }

    fn lines(&self, right: f64) -> Vec<String> {
        wrapped(self.label, LETTERS_PX, right - 2.0 * GAP_PX - self.sample_px())
    }

    fn width_px(&self, right: f64) -> f64 {
        let text = self.lines(right).iter().map(|line| text_width_px(line, LETTERS_PX)).fold(0.0, f64::max);
        self.sample_px() + text + 2.0 * GAP_PX
    }
}

/// Draws the legend below a picture of a size, and returns the height with it. `is_labelled` tells which lines have labels
/// of their own.
pub(super) fn append(
    canvas: &mut Canvas,
    figure: &FigureData,
    is_labelled: impl Fn(usize) -> bool,
    [right, height]: [f64; 2],
) -> f64 {
    let disc = |mark: &'_ Mark| Sample::Disc { is_ring: mark.is_ring };
    let marks = kinds(figure.marks.iter().map(|mark| (mark.label.as_str(), disc(mark))));
    let bands = kinds(figure.bands.iter().map(|band| (band.label.as_str(), Sample::Band(band.kind))));
    let groups = [conditions(figure, is_labelled), curves(figure), marks, bands];
    // A name too long for the place under the axes begins further to the left, and all of them with it.
    let longest = groups.iter().flatten().map(|entry| entry.width_px(right)).fold(0.0, f64::max);
    let left = canvas.frame.left.min(right - longest).max(GAP_PX);
    let mut baseline = height;
    for group in groups {
        let mut x = left;
        for (i, entry) in group.iter().enumerate() {
            let width = entry.width_px(right);
            if i == 0 || x + width > right {
                x = left;
                baseline += ROW_PX;
            }
            let lines = entry.lines(right);
            draw(canvas, entry, &lines, [x, baseline - GAP_PX]);
            baseline += ROW_PX * (lines.len() - 1) as f64;
            x += width;
        }
    }
    baseline + if baseline > height { GAP_PX } else { 0.0 }
}

fn draw(canvas: &mut Canvas, entry: &Entry<'_>, lines: &[String], [x, baseline]: [f64; 2]) {
    let (y, colour) = (baseline - 0.35 * LETTERS_PX, entry.colour.as_str());
    let right = x + SAMPLE_PX;
    match &entry.sample {
        Sample::Line { dash, width_px } => {
            canvas.line(&[(x, y), (right, y)], Stroke { colour, width_px: *width_px, dash });
        }
        Sample::Disc { is_ring } => canvas.svg += &disc((x + 0.5 * SAMPLE_PX, y), colour, *is_ring),
        Sample::Band(kind) => {
            let place = Rect { left: x, top: y - 4.0, right, bottom: y + 4.0 };
            canvas.rect(place, &format!("fill=\"{colour}\" fill-opacity=\"{}\"", opacity(*kind)));
            let edges: &[f64] = if *kind == BandKind::Interval { &[place.top, place.bottom] } else { &[] };
            for edge in edges {
                canvas.line(&[(x, *edge), (right, *edge)], Stroke { colour, width_px: EDGE_PX, dash: "" });
            }
        }
        Sample::None => {}
    }
    for (at, line) in lines.iter().enumerate() {
        let place = (x + entry.sample_px(), baseline + ROW_PX * at as f64);
        canvas.text(place, Anchor::Start, LETTERS_PX, line);
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
        let (colour, width_px) = match series.look {
            Some(_) => (colour(NEUTRAL), condition_width_px(figure, series.condition_index)),
            None => (Ink::new(figure, series).dark, Some(2.0)),
        };
        let sample = width_px.map_or(Sample::None, |width_px| Sample::Line { dash: String::new(), width_px });
        entries.push(Entry { label, colour, sample });
    }
    entries
}

/// Entries for the curves: of models always, of others if several share the figure, in grey like their lines in colour.
fn curves(figure: &FigureData) -> Vec<Entry<'_>> {
    let compared = figure.compares_curves();
    let named = figure.series.iter().filter(|series| !series.curve.is_empty());
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for series in named.filter(|series| compared || series.look.is_some()) {
        if entries.iter().any(|entry| entry.label == series.curve) {
            continue;
        }
        let grey = Series { condition_index: None, ..series.clone() };
        let Ink { colour: of_line, dash, width_px, .. } = Ink::new(figure, &grey);
        let colour = match (series.look, dash.is_empty()) {
            (Some(_), _) => of_line,
            (None, true) => tint(NEUTRAL),
            (None, false) => colour(NEUTRAL),
        };
        entries.push(Entry { label: &series.curve, colour, sample: Sample::Line { dash, width_px } });
    }
    entries
}

/// An entry for each kind of marks or bands, in black.
fn kinds<'a>(samples: impl Iterator<Item = (&'a str, Sample)>) -> Vec<Entry<'a>> {
    let mut entries: Vec<Entry<'a>> = Vec::new();
    for (label, sample) in samples {
        if !entries.iter().any(|entry| entry.label == label) {
            entries.push(Entry { label, colour: colour(NEUTRAL), sample });
        }
    }
    entries
}
