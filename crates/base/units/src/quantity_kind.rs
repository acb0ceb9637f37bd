//! Kinds of quantities, their units, and the parser of typed quantities.
//!
//! No unit crate fits: uom's parser needs a blank before the unit, knows no `um`, and turns 5 µm into
//! 4.9999999999999996e-6 m because it multiplies. A unit here is a power of ten, perhaps times a whole number; the
//! decimal text is multiplied by it before the single rounding to a double.

use crate::length_unit::LengthUnit;
use crate::number_text::{without_comma, without_power};
use crate::quantity_error::QuantityError;
use crate::typed_spread::TypedSpread;
use crate::unit_scale::UnitScale;

/// A kind of quantity: its name, its units, further units of this kind alone, and an example.
pub(crate) struct Kind {
    what: &'static str,
    units: Units,
    own_units: &'static [&'static str],
    example: &'static str,
}

/// Units with their spellings.
enum Units {
    /// The units of [`LengthUnit`].
    Lengths,
    /// Spellings and size of each unit; the first spelling is its name.
    Listed(&'static [(&'static [&'static str], UnitScale)]),
}

pub(crate) const LENGTH: Kind =
    Kind { what: "length", units: Units::Lengths, own_units: &[], example: "5 um" };

/// 0.45359237 kg x 9.80665 m/s^2 / (25.4 mm)^2, to sixteen digits.
const PSI: (u64, i32) = (6_894_757_293_168_361, -12);

const fn ten(decimal_exponent: i32) -> UnitScale {
    UnitScale::power_of_ten(decimal_exponent)
}

pub(crate) const PRESSURE: Kind = Kind {
    what: "pressure",
    units: Units::Listed(&[
        (&["Pa", "N/m^2", "N/m2", "N/m²"], ten(0)),
        (&["hPa", "mbar"], ten(2)),
        (&["kPa"], ten(3)),
        (&["bar"], ten(5)),
        (&["MPa", "N/mm^2", "N/mm2", "N/mm²", "MN/m^2", "MN/m2", "MN/m²"], ten(6)),
        (&["GPa", "kN/mm^2", "kN/mm2", "kN/mm²"], ten(9)),
        (&["TPa"], ten(12)),
        (&["psi"], UnitScale::decimal(PSI.0, PSI.1)),
        (&["ksi"], UnitScale::decimal(PSI.0, PSI.1 + 3)),
    ]),
    own_units: &[HARDNESS_UNIT],
    example: "5.4 MPa",
};

/// The hardness of the material as a unit of pressure.
pub(crate) const HARDNESS_UNIT: &str = "H";

pub(crate) const MODULUS: Kind = Kind { what: "modulus", own_units: &[], example: "210 GPa", ..PRESSURE };

/// Hardness; its own units are the scales of [`HardnessScale`](crate::hardness_scale::HardnessScale).
pub(crate) const HARDNESS: Kind =
    Kind { what: "hardness", own_units: &["HV", "HBW", "HRC"], example: "3 GPa", ..PRESSURE };

pub(crate) const FORCE: Kind = Kind {
    what: "force",
    units: Units::Listed(&[
        (&["N"], ten(0)),
        (&["mN"], ten(-3)),
        (&["uN", "µN", "μN"], ten(-6)),
        (&["nN"], ten(-9)),
        (&["kN"], ten(3)),
        (&["MN"], ten(6)),
    ]),
    own_units: &[],
    example: "10 N",
};

pub(crate) const THERMAL_CONDUCTIVITY: Kind = Kind {
    what: "thermal conductivity",
    units: Units::Listed(&[
        (&["W/(m K)", "W/(mK)", "W/(m*K)", "W/(m·K)", "W/m/K", "W/mK", "W/m K", "W m^-1 K^-1"], ten(0)),
        (&["mW/(m K)", "mW/(m*K)", "mW/(m·K)", "mW/m/K", "mW/mK"], ten(-3)),
        (&["W/(cm K)", "W/(cm*K)", "W/(cm·K)", "W/cm/K", "W/cmK"], ten(2)),
    ]),
    own_units: &[],
    example: "46 W/(m K)",
};

/// Resistivity. The letter omega and the ohm sign look alike, so both are accepted.
pub(crate) const RESISTIVITY: Kind = Kind {
    what: "resistivity",
    units: Units::Listed(&[
        (&["ohm m", "ohm*m", "Ohm m", "Ω m", "Ω·m", "Ω*m", "Ωm", "\u{2126} m", "\u{2126}m"], ten(0)),
        (&["ohm cm", "ohm*cm", "Ohm cm", "Ω cm", "Ω·cm", "Ωcm", "\u{2126} cm"], ten(-2)),
        (&["mohm cm", "mOhm cm", "mΩ cm", "mΩ·cm", "m\u{2126} cm"], ten(-5)),
        (&["uohm m", "uOhm m", "µΩ m", "μΩ m", "µΩ·m", "μΩ·m", "ohm mm^2/m", "Ω mm²/m", "Ω·mm²/m"], ten(-6)),
        (&["uohm cm", "uOhm cm", "µΩ cm", "μΩ cm", "µΩ·cm", "μΩ·cm", "µ\u{2126} cm"], ten(-8)),
        (&["nohm m", "nOhm m", "nΩ m", "nΩ·m", "n\u{2126} m"], ten(-9)),
    ]),
    own_units: &[],
    example: "1.7e-8 ohm m",
};

pub(crate) const SPECIFIC_RESISTANCE: Kind = Kind {
    what: "specific resistance",
    units: Units::Listed(&[
        (&["ohm m^2", "ohm m²", "Ohm m^2", "Ω m^2", "Ω m²", "Ω·m²"], ten(0)),
        (&["ohm cm^2", "ohm cm²", "Ohm cm^2", "Ω cm^2", "Ω cm²", "Ω·cm²"], ten(-4)),
        (&["uohm cm^2", "µΩ cm²", "μΩ cm²"], ten(-10)),
        (&["uohm mm^2", "µΩ mm²", "μΩ mm²"], ten(-12)),
    ]),
    own_units: &[],
    example: "1e-12 ohm m^2",
};

pub(crate) const VISCOSITY: Kind = Kind {
    what: "viscosity",
    units: Units::Listed(&[
        (&["Pa s", "Pa*s", "Pa·s", "N s/m^2", "N s/m²"], ten(0)),
        (&["mPa s", "mPa*s", "mPa·s", "cP"], ten(-3)),
        (&["uPa s", "uPa*s", "µPa s", "μPa s", "µPa·s", "μPa·s"], ten(-6)),
        (&["P"], ten(-1)),
    ]),
    own_units: &[],
    example: "1 mPa s",
};

pub(crate) const WORK_OF_ADHESION: Kind = Kind {
    what: "work of adhesion",
    units: Units::Listed(&[
        (&["J/m^2", "J/m2", "J/m²", "N/m"], ten(0)),
        (&["mJ/m^2", "mJ/m2", "mJ/m²", "mN/m"], ten(-3)),
    ]),
    own_units: &[],
    example: "50 mJ/m^2",
};

pub(crate) const FORCE_PER_LENGTH: Kind = Kind {
    what: "force per length",
    units: Units::Listed(&[
        (&["N/m"], ten(0)),
        (&["mN/m"], ten(-3)),
        (&["kN/m"], ten(3)),
        (&["N/mm"], ten(3)),
        (&["kN/mm", "MN/m"], ten(6)),
    ]),
    own_units: &[],
    example: "10 N/mm",
};

pub(crate) const TEMPERATURE: Kind =
    Kind { what: "temperature", units: Units::Listed(&[(&["K"], ten(0))]), own_units: &[], example: "400 K" };

pub(crate) const AREA: Kind = Kind {
    what: "area",
    units: Units::Listed(&[
        (&["m^2", "m2", "m²"], ten(0)),
        (&["cm^2", "cm2", "cm²"], ten(-4)),
        (&["mm^2", "mm2", "mm²"], ten(-6)),
        (&["um^2", "um2", "um²", "µm^2", "µm2", "µm²", "μm^2", "μm2", "μm²"], ten(-12)),
    ]),
    own_units: &[],
    example: "1 cm^2",
};

impl Kind {
    /// Lists every unit by its first spelling.
    fn unit_list(&self) -> String {
        let mut names: Vec<&str> = match self.units {
            Units::Lengths => LengthUnit::ALL.map(LengthUnit::ascii).to_vec(),
            Units::Listed(units) => units.iter().map(|(spellings, _)| spellings[0]).collect(),
        };
        names.extend(self.own_units);
        names.join(", ")
    }

    /// Parses a positive value into SI units.
    pub(crate) fn parse(&self, text: &str) -> Result<f64, QuantityError> {
        self.positive(text, self.parse_signed(text)?)
    }

    /// Parses a value of either sign into SI units.
    pub(crate) fn parse_signed(&self, text: &str) -> Result<f64, QuantityError> {
        let (number, unit) = self.split(text)?;
        let scale = match self.units {
            Units::Lengths => LengthUnit::parse(unit).map(LengthUnit::scale),
            Units::Listed(units) => {
                units.iter().find(|(spellings, _)| spellings.contains(&unit)).map(|(_, scale)| *scale)
            }
        };
        Ok(scaled(number, scale.ok_or_else(|| self.wrong_unit(text, unit))?))
    }

    /// Splits a text into number and unit, neither of them empty.
    pub(crate) fn split<'t>(&self, text: &'t str) -> Result<(&'t str, &'t str), QuantityError> {
        if let Some(meant) = without_comma(text) {
            return Err(QuantityError::Comma { text: text.to_owned(), meant });
        }
        if let Some(meant) = without_power(text) {
            return Err(QuantityError::PowerOfTen { text: text.to_owned(), meant });
        }
        let (number, unit) = split_number(text.trim()).ok_or_else(|| QuantityError::NoNumber {
            text: text.to_owned(),
            what: self.what,
            example: self.example,
        })?;
        if unit.is_empty() {
            return Err(QuantityError::NoUnit {
                text: text.to_owned(),
                what: self.what,
                units: self.unit_list(),
                example: self.example,
            });
        }
        Ok((number, unit))
    }

    /// Returns the quantities that a unit in the wrong case may mean: those of this kind, and thousandths of the basic
    /// unit for a small `m`, which is refused where a slip from mega to milli would pass unnoticed.
    fn in_right_case(&self, text: &str, unit: &str) -> Vec<String> {
        let Some((number, _)) = split_number(text.trim()) else { return Vec::new() };
        let lower = unit.to_lowercase();
        let mut meant: Vec<String> = match self.units {
            Units::Lengths => LengthUnit::parse_any_case(unit)
                .map(LengthUnit::ascii)
                .into_iter()
                .map(str::to_owned)
                .collect(),
            Units::Listed(units) => units
                .iter()
                .filter_map(|(spellings, _)| spellings.iter().find(|known| known.to_lowercase() == lower))
                .map(|known| (*known).to_owned())
                .collect(),
        };
        meant.extend(
            self.own_units.iter().filter(|own| own.to_lowercase() == lower).map(|own| (*own).to_owned()),
        );
        meant.retain(|meant| meant != unit);
        if self.what == TEMPERATURE.what && ["c", "°c", "degc", "celsius"].contains(&lower.as_str()) {
            return number
                .parse::<f64>()
                .map(|celsius| format!("{} K", celsius + 273.15))
                .into_iter()
                .collect();
        }
        let milli = lower == "mpa" && !number.contains(['e', 'E']);
        let mut meant: Vec<String> = meant.into_iter().map(|unit| format!("{number} {unit}")).collect();
        meant.extend(milli.then(|| format!("{number}e-3 Pa")));
        meant
    }

    pub(crate) fn positive(&self, text: &str, value: f64) -> Result<f64, QuantityError> {
        if value > 0.0 && value.is_finite() {
            Ok(value)
        } else {
            Err(QuantityError::NotPositive { text: text.to_owned(), what: self.what })
        }
    }

    pub(crate) fn wrong_unit(&self, text: &str, unit: &str) -> QuantityError {
        if TypedSpread::parse(text).is_some() {
            return QuantityError::OneValueWanted { text: text.to_owned(), what: self.what };
        }
        if let Some(values) = several(text) {
            return QuantityError::Several { text: text.to_owned(), values };
        }
        if self.what == PRESSURE.what && FORCE.parse(text).is_ok() {
            return QuantityError::Force { text: text.to_owned() };
        }
        let meant = self.in_right_case(text, unit);
        let (text, unit) = (text.to_owned(), unit.to_owned());
        if !meant.is_empty() {
            return QuantityError::UnitCase { text, unit, meant };
        }
        QuantityError::WrongUnit { text, unit, what: self.what, units: self.unit_list() }
    }
}

/// The values of a list or of both ends of a range, those without a unit in that of the last.
fn several(text: &str) -> Option<Vec<String>> {
    let mut parts: Vec<&str> = text.split([',', ';']).collect();
    if let [range] = parts[..] {
        // The dash of an exponent separates nothing.
        let ends = range.rsplit_once(['-', '\u{2013}']).filter(|(from, _)| !from.ends_with(['e', 'E']));
        parts = ends.map(|(from, to)| vec![from, to])?;
    }
    let split: Vec<(&str, &str)> =
        parts.iter().map(|part| split_number(part.trim())).collect::<Option<_>>()?;
    let (_, last) = *split.last().filter(|(_, unit)| !unit.is_empty())?;
    let in_unit =
        |&(number, unit): &(&str, &str)| format!("{number} {}", if unit.is_empty() { last } else { unit });
    Some(split.iter().map(in_unit).collect())
}

/// Splits off the longest prefix that is a decimal number; the rest is trimmed.
fn split_number(text: &str) -> Option<(&str, &str)> {
    let numeric = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    let longest = text.find(|c| !numeric(c)).unwrap_or(text.len());
    (1..=longest)
        .rev()
        .find(|&end| text[..end].parse::<f64>().is_ok())
        .map(|end| (&text[..end], text[end..].trim_start()))
}

/// Returns true if the number at the start of a text is 0.
pub(crate) fn is_zero(text: &str) -> bool {
    split_number(text.trim()).is_some_and(|(number, _)| number.parse() == Ok(0.0))
}

/// Converts a number found by [`split_number`] to SI units.
pub(crate) fn scaled(number: &str, scale: UnitScale) -> f64 {
    scale.read(number).expect("it reads as a number")
}
