//! The palette: colours and dashes of lines, marks and maps in every figure, page and picture.

use study::figure::{CurveLook, Variant};

/// Colours of lines on white and on a dark page, for any colour vision and dark enough for letters (after Okabe & Ito). The
/// last one is neutral.
const COLOURS: [[&str; 2]; 6] = [
    ["#0072b2", "#5aa9e6"],
    ["#b4530a", "#f0883e"],
    ["#0b7a5a", "#3fbf8f"],
    ["#a6438c", "#e58ac8"],
    ["#7a6200", "#d4b833"],
    ["#000000", "#e8eaed"],
];

/// The index of the colour of lines without a meaning of their colour.
pub(crate) const NEUTRAL: usize = COLOURS.len() - 1;

/// Families of models, each in the colour of its index; the first model of a family is dashed.
const FAMILIES: [&[&str]; NEUTRAL] = [
    &["persson", "persson-plastic"],
    &["elastic", "elastic-plastic"],
    &["elastic-sine", "ep-sine"],
    &["hertz", "ep-sphere"],
    &["bgt"],
];

/// The colours of a model that is in no family.
const OTHER: [&str; 2] = ["#555555", "#bbbbbb"];

/// Greys of grids, lines at zero, subjects, and of stretches without a measurement, which cover a share of what is below.
pub(crate) const GRID: &str = "#eeeeee";
pub(crate) const ZERO: &str = "#999999";
pub(crate) const QUIET: &str = "#666666";
pub(crate) const HOLE: (&str, f64) = ("#808080", 0.15);

/// The opacity of a band to hold lines against, and of an interval, of which several may overlap.
pub(crate) const YARDSTICK_OPACITY: f64 = 0.18;
pub(crate) const INTERVAL_OPACITY: f64 = 0.15;

/// The colour of missing points of a map.
pub(crate) const MISSING: [u8; 3] = [150; 3];

/// The colour of points in contact, on the greys of a relief.
pub(crate) const CONTACT: [u8; 3] = [208, 32, 0];

/// The greys of a relief, from its lowest point to its highest.
const RELIEF: [f64; 2] = [120.0, 245.0];

/// Returns the grey of a share of the range of heights.
pub(crate) fn relief_grey(share: f64) -> u8 {
    (RELIEF[0] + share.clamp(0.0, 1.0) * (RELIEF[1] - RELIEF[0])).round() as u8
}

/// Nine colours of viridis from dark to light, evenly spaced to the eye (Smith & van der Walt 2015, matplotlib).
const VIRIDIS: [[u8; 3]; 9] = [
    [68, 1, 84],
    [71, 44, 122],
    [59, 81, 139],
    [44, 113, 142],
    [33, 144, 141],
    [39, 173, 129],
    [92, 200, 99],
    [170, 220, 50],
    [253, 231, 37],
];

/// The look of a model's lines.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModelStyle {
    /// The colour on white.
    pub colour: &'static str,
    /// The colour on a dark page.
    pub dark_colour: &'static str,
    /// The dash pattern of SVG; empty for a solid line.
    pub dash: String,
}

impl ModelStyle {
    /// Returns the look of a curve's lines.
    #[must_use]
    pub fn new(look: CurveLook) -> Self {
        let family = FAMILIES.iter().position(|models| models.contains(&look.model));
        let is_first = family.is_some_and(|family| FAMILIES[family][0] == look.model);
        let dash = match (look.repeat, look.variant) {
            (0, Variant::Hardening) => "2 2.5".to_owned(),
            (0, Variant::Corrected) => "8 3 2 3".to_owned(),
            (0, Variant::Plain) if is_first => "6 3".to_owned(),
            (0, Variant::Plain) => String::new(),
            (repeat, _) => long_dash(repeat),
        };
        let [colour, dark_colour] = family.map_or(OTHER, |family| COLOURS[family]);
        ModelStyle { colour, dark_colour, dash }
    }
}

/// Returns the colour of an index: one of six, greyer each time they are reused.
pub(crate) fn colour(index: usize) -> String {
    let left = 0.6f64.powi((index / COLOURS.len()) as i32);
    mixed(COLOURS[index % COLOURS.len()][0], left, 128.0)
}

/// Returns the pale tint of a colour, for broad lines that others lie on.
pub(crate) fn tint(index: usize) -> String {
    mixed(&colour(index), if index % COLOURS.len() == NEUTRAL { 0.3 } else { 0.4 }, 255.0)
}

/// Returns the colours of an index as variables of the style sheet, for light and dark pages.
pub(crate) fn of_page(index: usize) -> String {
    let [light, dark] = COLOURS[index % NEUTRAL];
    variables(light, dark)
}

/// Returns colours as variables of the style sheet.
pub(crate) fn variables(light: &str, dark: &str) -> String {
    format!("--light:{light};--dark:{dark}")
}

/// Mixes a share of a colour with a grey.
fn mixed(colour: &str, share: f64, grey: f64) -> String {
    let part = |at: usize| f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap_or_default());
    let [red, green, blue] = [1, 3, 5].map(|at| (grey + share * (part(at) - grey)).round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// Returns the dash pattern of an index; empty for a solid line. Patterns can be distinguished in print.
pub(crate) fn dash(index: usize) -> String {
    match index {
        0 => String::new(),
        1 => "4 3".to_owned(),
        2 => "8 4 2 4".to_owned(),
        3 => "2 4".to_owned(),
        4 => "12 3".to_owned(),
        5 => "8 3 2 3 2 3".to_owned(),
        6 => "4 3 1.5 3".to_owned(),
        7 => "12 3 4 3".to_owned(),
        more => long_dash(more - 5),
    }
}

/// A long dash and more and more dots.
fn long_dash(dots: usize) -> String {
    format!("16 3{}", " 2 3".repeat(dots))
}

/// Returns the colour of a map for a share of its largest value.
#[must_use]
pub fn map_colour(share: f64) -> [u8; 3] {
    let last = VIRIDIS.len() - 1;
    let at = share.clamp(0.0, 1.0) * last as f64;
    let below = (at as usize).min(last - 1);
    let part = at - below as f64;
    std::array::from_fn(|i| {
        let [from, to] = [VIRIDIS[below][i], VIRIDIS[below + 1][i]].map(f64::from);
        (from + part * (to - from)).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use study::models::MODELS;

    /// The luminance of a colour by WCAG.
    fn luminance(colour: &str) -> f64 {
        let part = |at: usize| {
            let value = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
            if value <= 0.03928 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
    }

    fn contrast(one: &str, other: &str) -> f64 {
        let (a, b) = (luminance(one), luminance(other));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn every_model_has_a_family_and_a_look_of_its_own() {
        let plain = |model| CurveLook { model, variant: Variant::Plain, repeat: 0 };
        let styles: Vec<ModelStyle> = MODELS.iter().map(|entry| ModelStyle::new(plain(entry.name))).collect();
        for (at, style) in styles.iter().enumerate() {
            assert!(!styles[..at].contains(style) && style.colour != OTHER[0], "{style:?}");
        }
        for look in MODELS.iter().map(|entry| plain(entry.name)) {
            let others = [
                CurveLook { variant: Variant::Hardening, ..look },
                CurveLook { variant: Variant::Corrected, ..look },
                CurveLook { repeat: 1, ..look },
            ];
            assert!(others.iter().all(|other| ModelStyle::new(*other).dash != ModelStyle::new(look).dash));
        }
    }

    #[test]
    fn names_in_these_colours_are_read_on_white_and_on_dark_pages() {
        for [colour, dark_colour] in COLOURS.into_iter().chain([OTHER]) {
            assert!(
                contrast(colour, "#ffffff") >= 4.5 && contrast(dark_colour, "#1e1e1e") >= 4.5,
                "{colour}"
            );
        }
    }

    #[test]
    fn no_dash_pattern_and_no_colour_repeats() {
        for of in [dash, colour, tint] {
            let mut all: Vec<String> = (0..20).map(of).collect();
            all.sort();
            all.dedup();
            assert_eq!(all.len(), 20, "{all:?}");
        }
        assert_eq!([colour(0), tint(0), tint(5)], ["#0072b2", "#99c7e0", "#b3b3b3"]);
    }
}
