//! Units of length as instruments write them.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// A decimal part of the metre.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LengthUnit {
    /// The unit is 10^`decimal_exponent` m.
    decimal_exponent: i32,
    name: &'static str,
}

/// A text that names no unit of length.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("'{text}' is no unit of length; write one of {}", LengthUnit::ACCEPTED)]
pub struct UnknownLengthUnit {
    /// What stands in the place of the unit.
    pub text: String,
}

impl LengthUnit {
    /// The metre.
    pub const METRE: Self = Self { decimal_exponent: 0, name: "m" };
    /// The millimetre.
    pub const MILLIMETRE: Self = Self { decimal_exponent: -3, name: "mm" };
    /// The micrometre.
    pub const MICROMETRE: Self = Self { decimal_exponent: -6, name: "µm" };
    /// The nanometre.
    pub const NANOMETRE: Self = Self { decimal_exponent: -9, name: "nm" };

    /// The names that messages offer.
    pub const ACCEPTED: &'static str = "m, cm, mm, µm, nm, Å, pm";

    /// Reads `nm`, `um`, `µm` with either micro sign, `~m` (Nanoscope), `A`, `Å`, `Angstrom`, `Micrometer`.
    ///
    /// Case counts in symbols, where M is mega, but not in words.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        Some(match text {
            "m" => Self::METRE,
            "cm" => Self { decimal_exponent: -2, name: "cm" },
            "mm" => Self::MILLIMETRE,
            "um" | "µm" | "μm" | "~m" => Self::MICROMETRE,
            "nm" => Self::NANOMETRE,
            "Å" | "\u{212b}" | "A" => Self { decimal_exponent: -10, name: "Å" },
            "pm" => Self { decimal_exponent: -12, name: "pm" },
            _ => return Self::parse_word(&text.to_lowercase()),
        })
    }

    fn parse_word(word: &str) -> Option<Self> {
        let singular = word.strip_suffix('s').unwrap_or(word);
        let stem = singular.strip_suffix("meter").or_else(|| singular.strip_suffix("metre"));
        Some(match (stem.map(|stem| stem.trim_end_matches(['_', ' '])), singular) {
            (Some(""), _) => Self::METRE,
            (Some("milli"), _) => Self::MILLIMETRE,
            (Some("micro"), _) | (_, "micron") => Self::MICROMETRE,
            (Some("nano"), _) => Self::NANOMETRE,
            (_, "angstrom" | "ångström" | "å") => Self { decimal_exponent: -10, name: "Å" },
            _ => return None,
        })
    }

    /// A length in this unit, in m. Dividing by a power of ten, which is exact, rounds once.
    pub fn to_m(self, value: f64) -> f64 {
        value / 10f64.powi(-self.decimal_exponent)
    }
}

impl FromStr for LengthUnit {
    type Err = UnknownLengthUnit;

    fn from_str(text: &str) -> Result<Self, UnknownLengthUnit> {
        Self::parse(text).ok_or_else(|| UnknownLengthUnit { text: text.to_owned() })
    }
}

impl fmt::Display for LengthUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_in_every_spelling() {
        for (text, metre) in [
            ("m", 1.0),
            ("Meters", 1.0),
            ("cm", 1e-2),
            ("mm", 1e-3),
            ("um", 1e-6),
            ("\u{b5}m", 1e-6),
            ("\u{3bc}m", 1e-6),
            ("~m", 1e-6),
            ("Micrometer", 1e-6),
            ("MICRO_METER", 1e-6),
            ("nm", 1e-9),
            ("NanoMeters", 1e-9),
            ("A", 1e-10),
            ("Å", 1e-10),
            ("\u{212b}", 1e-10),
            ("angstrom", 1e-10),
            (" pm ", 1e-12),
        ] {
            assert_eq!(text.parse::<LengthUnit>().map(|unit| unit.to_m(1.0)), Ok(metre), "{text}");
        }
        for text in ["", "V", "Mm", "NM", "furlong", "nm/V", "1/m", "parameters"] {
            assert!(text.parse::<LengthUnit>().is_err(), "{text}");
        }
        assert_eq!(LengthUnit::NANOMETRE.to_m(5.65), 5.65e-9);
        assert_eq!(
            "ft".parse::<LengthUnit>().unwrap_err().to_string(),
            "'ft' is no unit of length; write one of m, cm, mm, µm, nm, Å, pm"
        );
    }
}
