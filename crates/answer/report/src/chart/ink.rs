//! The look of the lines, marks and bands of a figure: colours by model or condition, dashes by curve.

use study::figure::{BandKind, FigureBand, FigureData, Series};
use units::display::typeset;

use super::palette::{INTERVAL_OPACITY, ModelStyle, NEUTRAL, YARDSTICK_OPACITY, colour, dash, tint};

/// The width of lines: a point in print, where letters have the size of those of journals.
const LINE_PX: f64 = 1.5;
/// The width of a pale line that others lie on.
const BROAD_PX: f64 = 3.5;

/// The look of a line.
#[derive(Debug, Clone)]
pub(super) struct Ink {
    /// The colour, perhaps pale so that other lines show on top.
    pub colour: String,
    /// The colour of small things that go with the line.
    pub dark: String,
    pub width_px: f64,
    /// The dash pattern of SVG; empty for a solid line.
    pub dash: String,
}

impl Ink {
    /// Returns the look of a line: that of its model, else by condition and curve.
    pub fn new(figure: &FigureData, series: &Series) -> Self {
        if let Some(look) = series.look {
            let ModelStyle { colour, dash, .. } = ModelStyle::new(look);
            return Ink { dark: colour.to_owned(), colour: colour.to_owned(), width_px: LINE_PX, dash };
        }
        let index = colour_index(figure, series.condition_index);
        let pattern = dash_index(figure, series.curve_index);
        let is_broad = figure.compares_curves() && pattern == 0;
        let (pale, width_px) = if is_broad { (tint(index), BROAD_PX) } else { (colour(index), LINE_PX) };
        Ink { colour: pale, dark: colour(index), width_px, dash: dash(pattern) }
    }
}

/// Returns the colour of a band: that of its line, or black for a yardstick among lines of models.
pub(super) fn band_colour(figure: &FigureData, band: &FigureBand) -> String {
    let mut lines = figure.series.iter().filter(|series| series.look.is_some());
    let line = match band.kind {
        BandKind::Interval => lines.find(|series| series.curve_index == band.curve_index),
        BandKind::Yardstick => None,
    };
    line.map_or_else(|| mark_colour(figure, band.load), |line| Ink::new(figure, line).dark)
}

/// Returns the opacity of a band.
pub(super) fn opacity(kind: BandKind) -> f64 {
    match kind {
        BandKind::Yardstick => YARDSTICK_OPACITY,
        BandKind::Interval => INTERVAL_OPACITY,
    }
}

/// Returns the colour of what belongs to a condition: its own, or black where colours belong to models.
pub(super) fn mark_colour(figure: &FigureData, condition: Option<usize>) -> String {
    let has_models = figure.series.iter().any(|series| series.look.is_some());
    colour(if has_models { NEUTRAL } else { colour_index(figure, condition) })
}

/// Returns true if labels at lines name models: if all lines are of models, under one condition.
pub(super) fn labels_name_models(figure: &FigureData) -> bool {
    let mut series = figure.series.iter();
    series.all(|line| line.look.is_some() && line.condition_index == figure.series[0].condition_index)
}

/// Returns the label at a line: its model, or its condition.
pub(super) fn label(figure: &FigureData, series: &Series) -> String {
    typeset(if labels_name_models(figure) { &series.curve } else { &series.condition })
}

/// Returns the lines that share a label with the one at an index: those under its condition.
pub(super) fn label_group(figure: &FigureData, at: usize) -> usize {
    let series = &figure.series[at];
    match (series.look, series.condition_index) {
        (Some(_), _) if labels_name_models(figure) => at,
        (Some(_), Some(condition)) => condition,
        (_, condition) => colour_index(figure, condition),
    }
}

/// The colour index of lines under a condition. A line without a condition among others that have some is black, and none
/// of these is.
fn colour_index(figure: &FigureData, condition: Option<usize>) -> usize {
    let without = figure.series.iter().filter(|series| series.condition_index.is_none()).count();
    let is_mixed = (1..figure.series.len()).contains(&without);
    match condition {
        Some(index) => index + usize::from(is_mixed && index >= NEUTRAL),
        None if is_mixed => NEUTRAL,
        None => 0,
    }
}

/// The dash index of the lines of a curve. The first of several is the reference that the others are held against: dashed.
fn dash_index(figure: &FigureData, curve: usize) -> usize {
    match curve {
        _ if !figure.compares_curves() => 0,
        0 => 1,
        1 => 0,
        more => more,
    }
}
