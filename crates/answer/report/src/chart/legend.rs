//! The legend under a figure: a colour for each condition and a dash pattern for each curve, rather than an entry for each
//! pair of them.

use study::figure::{BandKind, FigureData, Mark, Series};
use units::display::typeset;

use super::canvas::{Anchor, Canvas, LETTERS_PX, Rect, Stroke, disc, text_width_px, wrapped};
use super::ink::{Ink, labels_name_models, opacity};
use super::palette::{NEUTRAL, colour, tint};

const ROW_PX: f64 = 18.0;
/// The length of a sample, long enough to show its dash pattern.
const SAMPLE_PX: f64 = 26.0;
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
    /// A pale stretch, for bands of any colour.
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
    let groups = [conditions(figure, &is_labelled), curves(figure, &is_labelled), marks, bands];
    let entries: Vec<Entry<'_>> = groups.into_iter().flatten().collect();
    // Entries of more than a row take the whole width.
    let is_row = entries.iter().map(|entry| entry.width_px(right)).sum::<f64>() <= right - canvas.frame.left;
    let left = if is_row { canvas.frame.left } else { GAP_PX };
    let lowest = height + canvas.frame.bottom - canvas.frame.top;
    let (mut x, mut baseline) = (f64::INFINITY, height);
    for (at, entry) in entries.iter().enumerate() {
        let width = entry.width_px(right);
        if x + width > right {
            x = left;
            baseline += ROW_PX;
        }
        // A legend is no larger than its plot.
        if baseline > lowest {
            let words = format!("and {} more", entries.len() - at);
            canvas.text((x, baseline - GAP_PX), Anchor::Start, LETTERS_PX, &words);
            break;
        }
        let lines = entry.lines(right);
        draw(canvas, entry, &lines, [x, baseline - GAP_PX]);
        baseline += ROW_PX * (lines.len() - 1) as f64;
        x += width;
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
        }
        Sample::None => {}
    }
    for (at, line) in lines.iter().enumerate() {
        let place = (x + entry.sample_px(), baseline + ROW_PX * at as f64);
        canvas.text(place, Anchor::Start, LETTERS_PX, line);
    }
}

/// Entries for conditions, with their colours unless these belong to models. Conditions that labels at their lines spell
/// out have none.
fn conditions<'a>(figure: &'a FigureData, is_labelled: &impl Fn(usize) -> bool) -> Vec<Entry<'a>> {
    let labels_name_models = labels_name_models(figure);
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for (at, series) in figure.series.iter().enumerate() {
        let label = series.condition_in_full.as_str();
        let is_in_full = series.look.is_some() || label == typeset(&series.condition);
        let is_spelt_out = !labels_name_models && is_labelled(at) && is_in_full;
        if label.is_empty() || is_spelt_out || entries.iter().any(|entry| entry.label == label) {
            continue;
        }
        let sample = match series.look {
            Some(_) => Sample::None,
            None => Sample::Line { dash: String::new(), width_px: 2.0 },
        };
        entries.push(Entry { label, colour: Ink::new(figure, series).dark, sample });
    }
    entries
}

/// Entries for the curves: of models that no label at their line names, of others if several share the figure, in grey
/// like their lines in colour.
fn curves<'a>(figure: &'a FigureData, is_labelled: &impl Fn(usize) -> bool) -> Vec<Entry<'a>> {
    let compared = figure.compares_curves();
    let labels_name_models = labels_name_models(figure);
    let named = figure.series.iter().enumerate().filter(|(_, series)| !series.curve.is_empty());
    let mut entries: Vec<Entry<'_>> = Vec::new();
    for (at, series) in named.filter(|(_, series)| compared || series.look.is_some()) {
        if (labels_name_models && is_labelled(at)) || entries.iter().any(|entry| entry.label == series.curve)
        {
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
