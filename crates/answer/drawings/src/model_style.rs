//! Colour and dash of a model, alike in every figure and on every page: a colour per family, a dash per law.

use study::figure::{CurveLook, Variant};

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

/// The families of models: their names, and colours on white and on a dark page (after Okabe & Ito).
const FAMILIES: [(&[&str], [&str; 2]); 5] = [
    (&["persson", "persson-plastic"], ["#0072b2", "#5aa9e6"]),
    (&["elastic", "elastic-plastic"], ["#b4530a", "#f0883e"]),
    (&["elastic-sine", "ep-sine"], ["#0b7a5a", "#3fbf8f"]),
    (&["hertz", "ep-sphere"], ["#a6438c", "#e58ac8"]),
    (&["bgt"], ["#7a6200", "#d4b833"]),
];

/// The colours of a model that is in no family.
const OTHER: [&str; 2] = ["#555555", "#bbbbbb"];

impl ModelStyle {
    /// Returns the look of a curve's lines.
    #[must_use]
    pub fn new(look: CurveLook) -> Self {
        let family = FAMILIES.iter().find(|(models, _)| models.contains(&look.model));
        let place = family.and_then(|(models, _)| models.iter().position(|model| *model == look.model));
        let dash = match (look.repeat, look.variant) {
            (0, Variant::Hardening) => "2 2.5".to_owned(),
            (0, Variant::Corrected) => "8 3 2 3".to_owned(),
            (0, Variant::Plain) if place == Some(0) => "6 3".to_owned(),
            (0, Variant::Plain) => String::new(),
            (repeat, _) => format!("16 3{}", " 2 3".repeat(repeat)),
        };
        let [colour, dark_colour] = family.map_or(OTHER, |(_, colours)| *colours);
        ModelStyle { colour, dark_colour, dash }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use study::models::MODELS;

    fn plain(model: &'static str) -> CurveLook {
        CurveLook { model, variant: Variant::Plain, repeat: 0 }
    }

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
        for [colour, dark_colour] in FAMILIES.iter().map(|(_, colours)| *colours).chain([OTHER]) {
            assert!(
                contrast(colour, "#ffffff") >= 4.5 && contrast(dark_colour, "#1e1e1e") >= 4.5,
                "{colour}"
            );
        }
    }
}
