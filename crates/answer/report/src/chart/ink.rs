//! The look of the lines, marks and bands of a figure: colours by model or condition, dashes by curve.

use std::collections::BTreeSet;

use study::figure::{BandKind, FigureBand, FigureData, Series};

use super::palette::{INTERVAL_OPACITY, ModelStyle, NEUTRAL, YARDSTICK_OPACITY, colour, dash, tint};

/// The width of the edges of an interval, thinner than any line of a curve.
pub(super) const EDGE_PX: f64 = 0.75;
const LINE_PX: f64 = 1.6;
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
    /// Returns the look of a line: that of its model, as broad as its condition, else by condition and curve.
    pub fn new(figure: &FigureData, series: &Series) -> Self {
        if let Some(look) = series.look {
            let ModelStyle { colour, dash, .. } = ModelStyle::new(look);
            let width_px = condition_width_px(figure, series.condition_index).unwrap_or(LINE_PX);
            return Ink { dark: colour.to_owned(), colour: colour.to_owned(), width_px, dash };
        }
        let index = colour_index(figure, series.condition_index);
        let pattern = dash_index(figure, series.curve_index);
        let is_broad = figure.compares_curves() && pattern == 0;
        let (pale, width_px) = if is_broad { (tint(index), BROAD_PX) } else { (colour(index), LINE_PX) };
        Ink { colour: pale, dark: colour(index), width_px, dash: dash(pattern) }
    }

    /// Returns the look of a band: that of its line, or black for a yardstick among lines of models.
    pub fn of_band(figure: &FigureData, band: &FigureBand) -> Self {
        let mut lines = figure.series.iter().filter(|series| series.look.is_some());
        let line = match band.kind {
            BandKind::Interval => lines.find(|series| series.curve_index == band.curve_index),
            BandKind::Yardstick => None,
        };
        line.map_or_else(
            || {
                let dark = mark_colour(figure, band.load);
                let dash = dash(dash_index(figure, band.curve_index));
                Ink { colour: dark.clone(), dark, width_px: EDGE_PX, dash }
            },
            |line| Ink::new(figure, line),
        )
    }
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

/// Returns the lines that share a label with the one at an index: those of its colour. Lines of models have one each.
pub(super) fn label_group(figure: &FigureData, at: usize) -> usize {
    let series = &figure.series[at];
    series.look.map_or_else(|| colour_index(figure, series.condition_index), |_| at)
}

/// Returns the width of the lines of models under a condition, from the narrow first to the broad last; `None` if the
/// figure has no more than one condition.
pub(super) fn condition_width_px(figure: &FigureData, condition: Option<usize>) -> Option<f64> {
    const NARROWEST_PX: f64 = 0.9;
    const BROADEST_PX: f64 = 2.9;
    let conditions: BTreeSet<usize> =
        figure.series.iter().filter_map(|series| series.condition_index).collect();
    let last = conditions.len().checked_sub(1).filter(|last| *last > 0)?;
    let place = conditions.iter().position(|one| Some(*one) == condition)?;
    Some(NARROWEST_PX + (BROADEST_PX - NARROWEST_PX) * place as f64 / last as f64)
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
