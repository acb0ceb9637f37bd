//! Units of length, in one table for typed lengths, headers of spectra and files of instruments.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use crate::unit_scale::UnitScale;

/// A unit of length, one of [`LengthUnit::ALL`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LengthUnit {
    scale: UnitScale,
    name: &'static str,
    ascii: &'static str,
    /// Case-sensitive signs besides `name` and `ascii`: M is mega, A is ampere.
    signs: &'static [&'static str],
    /// Case-insensitive words, singular and in lower case.
    words: &'static [&'static str],
}

/// A text that is not a unit of length.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("'{text}' is not a unit of length; use {}", meant(text))]
pub struct UnknownLengthUnit {
    /// The text in the place of the unit.
    pub text: String,
}

/// The unit that a text in another case means, or all units.
fn meant(text: &str) -> String {
    let in_other_case = LengthUnit::parse_any_case(text).map(|unit| unit.ascii.to_owned());
    in_other_case.unwrap_or_else(|| format!("one of {}", LengthUnit::accepted()))
}

impl LengthUnit {
    /// The metre.
    pub const METRE: Self = Self::new(UnitScale::power_of_ten(0), "m", "m", &[], &["meter", "metre"]);
    /// The centimetre.
    pub const CENTIMETRE: Self =
        Self::new(UnitScale::power_of_ten(-2), "cm", "cm", &[], &["centimeter", "centimetre"]);
    /// The millimetre.
    pub const MILLIMETRE: Self =
        Self::new(UnitScale::power_of_ten(-3), "mm", "mm", &[], &["millimeter", "millimetre"]);
    /// The micrometre; both micro signs are in use.
    pub const MICROMETRE: Self = Self::new(
        UnitScale::power_of_ten(-6),
        "\u{b5}m",
        "um",
        &["\u{3bc}m"],
        &["micrometer", "micrometre", "micron"],
    );
    /// The nanometre.
    pub const NANOMETRE: Self =
        Self::new(UnitScale::power_of_ten(-9), "nm", "nm", &[], &["nanometer", "nanometre"]);
    /// The angstrom, with the letter or the sign of its own.
    pub const ANGSTROM: Self =
        Self::new(UnitScale::power_of_ten(-10), "\u{c5}", "angstrom", &["\u{212b}"], &["ångström", "å"]);
    /// The kilo-angstrom of profilers, 100 nm.
    pub const KILOANGSTROM: Self = Self::new(
        UnitScale::power_of_ten(-7),
        "k\u{c5}",
        "kangstrom",
        &["k\u{212b}"],
        &["kiloangstrom", "kiloångström"],
    );
    /// The picometre.
    pub const PICOMETRE: Self =
        Self::new(UnitScale::power_of_ten(-12), "pm", "pm", &[], &["picometer", "picometre"]);
    /// The kilometre.
    pub const KILOMETRE: Self =
        Self::new(UnitScale::power_of_ten(3), "km", "km", &[], &["kilometer", "kilometre"]);
    /// The inch, 25.4 mm.
    pub const INCH: Self = Self::new(UnitScale::decimal(254, -4), "inch", "inch", &["in"], &["inche"]);
    /// The microinch, 25.4 nm.
    pub const MICROINCH: Self = Self::new(
        UnitScale::decimal(254, -10),
        "uin",
        "uin",
        &["\u{b5}in", "\u{3bc}in"],
        &["microinch", "microinche"],
    );

    /// The thousandth of an inch, 25.4 um.
    pub const MIL: Self = Self::new(UnitScale::decimal(254, -7), "mil", "mil", &["mils"], &[]);

    /// All units.
    pub const ALL: [Self; 12] = [
        Self::METRE,
        Self::CENTIMETRE,
        Self::MILLIMETRE,
        Self::MICROMETRE,
        Self::NANOMETRE,
        Self::ANGSTROM,
        Self::KILOANGSTROM,
        Self::PICOMETRE,
        Self::KILOMETRE,
        Self::INCH,
        Self::MICROINCH,
        Self::MIL,
    ];

    const fn new(
        scale: UnitScale,
        name: &'static str,
        ascii: &'static str,
        signs: &'static [&'static str],
        words: &'static [&'static str],
    ) -> Self {
        Self { scale, name, ascii, signs, words }
    }

    /// Lists the names of all units for messages.
    #[must_use]
    pub fn accepted() -> String {
        Self::ALL.map(|unit| unit.name).join(", ")
    }

    /// Parses a typed unit: `nm`, `um`, `µm` with either micro sign, `Å`, `Angstrom`, `microns`, `inch`.
    ///
    /// Signs are case-sensitive (M is mega), words are not.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        Self::ALL
            .into_iter()
            .find(|unit| unit.signs().any(|sign| sign == text))
            .or_else(|| Self::parse_word(text))
    }

    /// Parses a unit from an instrument's file, where `A` is the angstrom, `kA` a thousand of them, and `~m` (Nanoscope) the micrometre.
    #[must_use]
    pub fn parse_instrument(text: &str) -> Option<Self> {
        match text.trim() {
            "~m" => Some(Self::MICROMETRE),
            "A" => Some(Self::ANGSTROM),
            "kA" => Some(Self::KILOANGSTROM),
            text => Self::parse(text),
        }
    }

    /// Parses a unit with signs in any case, such as `NM` in the header of a spectrum.
    #[must_use]
    pub fn parse_any_case(text: &str) -> Option<Self> {
        let lower = text.trim().to_lowercase();
        let is_sign = |unit: &Self| unit.signs().any(|sign| sign.to_lowercase() == lower);
        Self::ALL.into_iter().find(is_sign).or_else(|| Self::parse_word(&lower))
    }

    fn signs(&self) -> impl Iterator<Item = &'static str> {
        [self.name, self.ascii].into_iter().chain(self.signs.iter().copied())
    }

    /// Parses words such as `Micrometers`, `MICRO_METER`, `angstrom`.
    fn parse_word(text: &str) -> Option<Self> {
        let lower = text.to_lowercase().replace(['_', ' '], "");
        let singular = lower.strip_suffix('s').unwrap_or(&lower);
        // Names as short as a sign have neither plural nor another case.
        let is_word =
            |unit: &Self| unit.words.contains(&singular) || (unit.ascii.len() > 3 && unit.ascii == singular);
        Self::ALL.into_iter().find(is_word)
    }

    /// Size of the unit in metres.
    #[must_use]
    pub const fn scale(self) -> UnitScale {
        self.scale
    }

    /// Converts a length in this unit to metres, with a single rounding for decimal units.
    #[must_use]
    pub fn to_m(self, value: f64) -> f64 {
        self.scale.to_si(value)
    }

    /// The name in ASCII: `um`, `angstrom`.
    #[must_use]
    pub const fn ascii(self) -> &'static str {
        self.ascii
    }
}

impl FromStr for LengthUnit {
    type Err = UnknownLengthUnit;

    /// Parses as [`LengthUnit::parse_instrument`] does: users type the unit that a file lacks as instruments write it.
    fn from_str(text: &str) -> Result<Self, UnknownLengthUnit> {
        Self::parse_instrument(text).ok_or_else(|| UnknownLengthUnit { text: text.to_owned() })
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
            ("microns", 1e-6),
            ("nm", 1e-9),
            ("NanoMeters", 1e-9),
            ("A", 1e-10),
            ("Å", 1e-10),
            ("å", 1e-10),
            ("\u{212b}", 1e-10),
            ("angstrom", 1e-10),
            ("Ångström", 1e-10),
            (" pm ", 1e-12),
            ("km", 1e3),
            ("in", 0.0254),
            ("inch", 0.0254),
            ("Inches", 0.0254),
            ("uin", 2.54e-8),
            ("\u{b5}in", 2.54e-8),
            ("microinches", 2.54e-8),
            ("k\u{c5}", 1e-7),
            ("kA", 1e-7),
            ("KiloAngstroms", 1e-7),
            ("mil", 2.54e-5),
            ("mils", 2.54e-5),
        ] {
            assert_eq!(text.parse::<LengthUnit>().map(|unit| unit.to_m(1.0)), Ok(metre), "{text}");
        }
        for text in ["", "V", "Mm", "NM", "furlong", "nm/V", "1/m", "parameters", "s", "In", "UIN", "a"] {
            assert!(text.parse::<LengthUnit>().is_err(), "{text}");
        }
        assert_eq!(LengthUnit::NANOMETRE.to_m(5.65), 5.65e-9);
        assert!("UM".parse::<LengthUnit>().unwrap_err().to_string().ends_with("; use um"));
        assert_eq!(
            "ft".parse::<LengthUnit>().unwrap_err().to_string(),
            "'ft' is not a unit of length; use one of m, cm, mm, µm, nm, Å, kÅ, pm, km, inch, uin, mil"
        );
    }

    #[test]
    fn letters_that_mean_something_else_are_units_only_where_instruments_write_them() {
        assert_eq!(LengthUnit::parse("A"), None);
        assert_eq!(LengthUnit::parse("~m"), None);
        assert_eq!(LengthUnit::parse_any_case("A"), None);
        assert_eq!(LengthUnit::parse_any_case("NM"), Some(LengthUnit::NANOMETRE));
        assert_eq!(LengthUnit::parse_any_case("Å"), Some(LengthUnit::ANGSTROM));
    }

    #[test]
    fn no_spelling_names_two_units() {
        for unit in LengthUnit::ALL {
            for text in unit.signs().chain(unit.words.iter().copied()) {
                assert_eq!(LengthUnit::parse(text), Some(unit), "{text}");
                assert_eq!(LengthUnit::parse_any_case(text), Some(unit), "{text}");
            }
        }
    }
}
