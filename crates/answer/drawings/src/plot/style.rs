//! Colours and dash patterns. All are different, however many lines a figure has.

use std::collections::BTreeSet;

use kuva::plot::line::LineStyle;
use study::figure::{FigureData, Series};

use crate::model_style::ModelStyle;

/// Colours for any colour vision, dark enough for thin lines (Okabe & Ito).
const COLOURS: [[u8; 3]; 6] = [
    [0x00, 0x72, 0xb2],
    [0xd5, 0x5e, 0x00],
    [0x00, 0x9e, 0x73],
    [0xb0, 0x56, 0x8a],
    [0xc2, 0x84, 0x00],
    [0x00, 0x00, 0x00],
];

/// The share of a colour that remains each time the six colours are reused; the rest is grey.
const LEFT: f64 = 0.6;
const GREY: f64 = 128.0;

/// The colour of lines without a meaning of their colour.
pub(super) const NEUTRAL: usize = COLOURS.len() - 1;

/// The drawn look of a line.
#[derive(Debug, Clone)]
pub(super) struct Ink {
    /// The colour, perhaps pale so that other lines show on top.
    pub colour: String,
    /// The colour of small things that go with the line.
    pub dark: String,
    pub width_px: f64,
    pub dash: LineStyle,
}

impl Ink {
    /// Returns the look of a line: that of its model, as broad as its condition, else by condition and curve.
    pub fn new(figure: &FigureData, series: &Series) -> Self {
        const WIDTH_PX: f64 = 1.6;
        if let Some(look) = series.look {
            let style = ModelStyle::new(look);
            let dash = if style.dash.is_empty() { LineStyle::Solid } else { LineStyle::Custom(style.dash) };
            let colour = style.colour.to_owned();
            let width_px = condition_width_px(figure, series.condition_index).unwrap_or(WIDTH_PX);
            return Ink { dark: colour.clone(), colour, width_px, dash };
        }
        let index = colour_index(figure, series.condition_index);
        let pattern = dash_index(figure, series.curve_index);
        let is_broad = figure.compares_curves() && pattern == 0;
        let (colour, width_px) = if is_broad { (tint(index), 3.5) } else { (colour(index), WIDTH_PX) };
        Ink { colour, dark: self::colour(index), width_px, dash: dash(pattern) }
    }

    /// Returns true for a line without gaps.
    pub fn is_solid(&self) -> bool {
        self.dash.dasharray().is_none()
    }
}

/// The width of the lines of models under a condition, from the narrow first to the broad last; `None` if the figure has
/// no more than one condition.
pub(super) fn condition_width_px(figure: &FigureData, condition: Option<usize>) -> Option<f64> {
    const NARROWEST_PX: f64 = 0.9;
    const BROADEST_PX: f64 = 2.9;
    let conditions: BTreeSet<usize> =
        figure.series.iter().filter_map(|series| series.condition_index).collect();
    let last = conditions.len().checked_sub(1).filter(|last| *last > 0)?;
    let place = conditions.iter().position(|one| Some(*one) == condition)?;
    Some(NARROWEST_PX + (BROADEST_PX - NARROWEST_PX) * place as f64 / last as f64)
}

/// The colour index of lines under a condition of a figure. A line without a condition among others that have some is
/// black, and none of these is.
pub(super) fn colour_index(figure: &FigureData, condition: Option<usize>) -> usize {
    let without = figure.series.iter().filter(|series| series.condition_index.is_none()).count();
    let is_mixed = (1..figure.series.len()).contains(&without);
    match condition {
        Some(index) => index + usize::from(is_mixed && index >= NEUTRAL),
        None if is_mixed => NEUTRAL,
        None => 0,
    }
}

/// The dash index of the lines of a curve. The first of several is the reference that the others are held against: dashed.
pub(super) fn dash_index(figure: &FigureData, curve: usize) -> usize {
    match curve {
        _ if !figure.compares_curves() => 0,
        0 => 1,
        1 => 0,
        more => more,
    }
}

/// The colour of an index: one of six, greyer each time they are reused.
pub(super) fn colour(index: usize) -> String {
    let left = LEFT.powi((index / COLOURS.len()) as i32);
    hexadecimal(COLOURS[index % COLOURS.len()].map(|part| GREY + left * (f64::from(part) - GREY)))
}

/// The pale tint of a colour, for broad lines that others lie on.
pub(super) fn tint(index: usize) -> String {
    const WHITE: f64 = 255.0;
    let left = LEFT.powi((index / COLOURS.len()) as i32);
    let of = if index % COLOURS.len() == NEUTRAL { 0.3 } else { 0.4 };
    hexadecimal(COLOURS[index % COLOURS.len()].map(|part| {
        let part = GREY + left * (f64::from(part) - GREY);
        WHITE + of * (part - WHITE)
    }))
}

fn hexadecimal(parts: [f64; 3]) -> String {
    let [red, green, blue] = parts.map(|part| part.round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Dash patterns that can be distinguished in print; from the eighth on a long dash and more and more dots.
pub(super) fn dash(index: usize) -> LineStyle {
    let custom = |pattern: &str| LineStyle::Custom(pattern.to_owned());
    match index {
        0 => LineStyle::Solid,
        1 => custom("4 3"),
        2 => LineStyle::DashDot,
        3 => LineStyle::Dotted,
        4 => custom("12 3"),
        5 => custom("8 3 2 3 2 3"),
        6 => custom("4 3 1.5 3"),
        7 => custom("12 3 4 3"),
        more => custom(&format!("16 3{}", " 2 3".repeat(more - 5))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all_differ(of: impl Fn(usize) -> Option<String>) -> bool {
        let mut all: Vec<_> = (0..20).map(of).collect();
        all.sort();
        all.dedup();
        all.len() == 20
    }

    #[test]
    fn no_dash_pattern_and_no_colour_repeats() {
        assert!(all_differ(|index| dash(index).dasharray()));
        assert!(all_differ(|index| Some(colour(index))));
        assert!(all_differ(|index| Some(tint(index))));
    }

    #[test]
    fn the_first_colours_are_those_of_okabe_and_ito_and_tints_are_pale() {
        assert_eq!([colour(0), colour(5)], ["#0072b2", "#000000"]);
        assert_eq!([tint(0), tint(5)], ["#99c7e0", "#b3b3b3"]);
    }
}
