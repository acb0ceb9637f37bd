//! Quantities as people type them: a number and its unit, `463 GPa`, `5um`, `1e-3 H`.
//!
//! No unit crate serves here: uom's parser wants a blank before the unit, knows no `um`, and turns 5 µm into
//! 4.9999999999999996e-6 m because it multiplies. A unit here is a power of ten, perhaps times a whole number, by which the
//! decimal text is multiplied before the one rounding to a double.

use std::str::FromStr;

use crate::length_unit::LengthUnit;
use crate::unit_scale::UnitScale;

/// What is wrong with a typed quantity.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// No number at its start.
    #[error("'{text}' does not start with a number; a {what} reads like '{example}'")]
    NoNumber {
        /// What was typed.
        text: String,
        /// The kind of quantity.
        what: &'static str,
        /// A good one.
        example: &'static str,
    },
    /// A number without a unit.
    #[error("'{text}' has no unit; a {what} needs one of {units}, as in '{example}'")]
    NoUnit {
        /// What was typed.
        text: String,
        /// The kind of quantity.
        what: &'static str,
        /// The accepted units.
        units: String,
        /// A good one.
        example: &'static str,
    },
    /// A unit of something else, or of nothing.
    #[error("'{text}' has the unit '{unit}'; a {what} needs one of {units}")]
    WrongUnit {
        /// What was typed.
        text: String,
        /// Its unit.
        unit: String,
        /// The kind of quantity.
        what: &'static str,
        /// The accepted units.
        units: String,
    },
    /// Not a usable magnitude.
    #[error("'{text}' is out of range; a {what} must be greater than 0 and finite")]
    NotPositive {
        /// What was typed.
        text: String,
        /// The kind of quantity.
        what: &'static str,
    },
    /// Beyond the largest double.
    #[error("'{text}' is out of range; it must be finite")]
    NotFinite {
        /// What was typed.
        text: String,
    },
}

/// A length > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Length {
    /// In metres.
    pub m: f64,
}

/// A length of either sign, or zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignedLength {
    /// In metres.
    pub m: f64,
}

/// A force > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// In newtons.
    pub n: f64,
}

/// An area > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Area {
    /// In square metres.
    pub m2: f64,
}

/// A modulus > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Modulus {
    /// In pascals.
    pub pa: f64,
}

/// A pressure > 0, in Pa or as a multiple of the hardness H = 3 S0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pressure {
    /// In pascals.
    Pascals(f64),
    /// In units of the hardness.
    Hardnesses(f64),
}

impl Pressure {
    /// The pressure \[Pa\], given the hardness \[Pa\] where there is one.
    #[must_use]
    pub fn pascals(self, hardness_pa: Option<f64>) -> Option<f64> {
        match self {
            Pressure::Pascals(pa) => Some(pa),
            Pressure::Hardnesses(share) => hardness_pa.map(|hardness_pa| share * hardness_pa),
        }
    }
}

/// A kind of quantity: its name, its units, and an example.
struct Kind {
    what: &'static str,
    units: Units,
    example: &'static str,
}

/// Units with their spellings.
enum Units {
    /// Those of [`LengthUnit`].
    Lengths,
    /// Spellings, the first of which is the name, and sizes.
    Listed(&'static [(&'static [&'static str], UnitScale)]),
}

const LENGTH: Kind = Kind { what: "length", units: Units::Lengths, example: "5 um" };

/// 0.45359237 kg x 9.80665 m/s^2 / (25.4 mm)^2, to sixteen digits.
const PSI: (u64, i32) = (6_894_757_293_168_361, -12);

const fn ten(decimal_exponent: i32) -> UnitScale {
    UnitScale::power_of_ten(decimal_exponent)
}

const PRESSURE: Kind = Kind {
    what: "pressure",
    units: Units::Listed(&[
        (&["Pa", "N/m^2", "N/m2", "N/m²"], ten(0)),
        (&["hPa"], ten(2)),
        (&["kPa"], ten(3)),
        (&["bar"], ten(5)),
        (&["MPa", "N/mm^2", "N/mm2", "N/mm²"], ten(6)),
        (&["GPa"], ten(9)),
        (&["TPa"], ten(12)),
        (&["psi"], UnitScale::decimal(PSI.0, PSI.1)),
        (&["ksi"], UnitScale::decimal(PSI.0, PSI.1 + 3)),
    ]),
    example: "5.4 MPa",
};

const MODULUS: Kind = Kind { what: "modulus", example: "210 GPa", ..PRESSURE };

/// The unit of pressure that is the material's own.
const HARDNESS_UNIT: &str = "H";

const FORCE: Kind = Kind {
    what: "force",
    units: Units::Listed(&[
        (&["N"], ten(0)),
        (&["mN"], ten(-3)),
        (&["uN", "µN", "μN"], ten(-6)),
        (&["nN"], ten(-9)),
        (&["kN"], ten(3)),
        (&["MN"], ten(6)),
    ]),
    example: "10 N",
};

const AREA: Kind = Kind {
    what: "area",
    units: Units::Listed(&[
        (&["m^2", "m2", "m²"], ten(0)),
        (&["cm^2", "cm2", "cm²"], ten(-4)),
        (&["mm^2", "mm2", "mm²"], ten(-6)),
        (&["um^2", "um2", "um²", "µm^2", "µm2", "µm²", "μm^2", "μm2", "μm²"], ten(-12)),
    ]),
    example: "1 cm^2",
};

impl Kind {
    /// Every unit under its first spelling.
    fn unit_list(&self) -> String {
        let mut names: Vec<&str> = match self.units {
            Units::Lengths => LengthUnit::ALL.map(LengthUnit::ascii).to_vec(),
            Units::Listed(units) => units.iter().map(|(spellings, _)| spellings[0]).collect(),
        };
        if self.what == PRESSURE.what {
            names.push(HARDNESS_UNIT);
        }
        names.join(", ")
    }

    /// The value in SI units, which must be positive.
    fn parse(&self, text: &str) -> Result<f64, QuantityError> {
        self.positive(text, self.parse_signed(text)?)
    }

    /// The value in SI units, whatever its sign.
    fn parse_signed(&self, text: &str) -> Result<f64, QuantityError> {
        let (number, unit) = self.split(text)?;
        let scale = match self.units {
            Units::Lengths => LengthUnit::parse(unit).map(LengthUnit::scale),
            Units::Listed(units) => {
                units.iter().find(|(spellings, _)| spellings.contains(&unit)).map(|(_, scale)| *scale)
            }
        };
        Ok(scaled(number, scale.ok_or_else(|| self.wrong_unit(text, unit))?))
    }

    /// The number's text and the unit's, both there.
    fn split<'t>(&self, text: &'t str) -> Result<(&'t str, &'t str), QuantityError> {
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

    fn positive(&self, text: &str, value: f64) -> Result<f64, QuantityError> {
        if value > 0.0 && value.is_finite() {
            Ok(value)
        } else {
            Err(QuantityError::NotPositive { text: text.to_owned(), what: self.what })
        }
    }

    fn wrong_unit(&self, text: &str, unit: &str) -> QuantityError {
        QuantityError::WrongUnit {
            text: text.to_owned(),
            unit: unit.to_owned(),
            what: self.what,
            units: self.unit_list(),
        }
    }
}

/// The longest prefix that reads as a decimal number, and the rest without blanks around it.
fn split_number(text: &str) -> Option<(&str, &str)> {
    let numeric = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    let longest = text.find(|c| !numeric(c)).unwrap_or(text.len());
    (1..=longest)
        .rev()
        .find(|&end| text[..end].parse::<f64>().is_ok())
        .map(|end| (&text[..end], text[end..].trim_start()))
}

/// The value in SI units of what [`split_number`] found.
fn scaled(number: &str, scale: UnitScale) -> f64 {
    scale.read(number).expect("it reads as a number")
}

impl FromStr for Length {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Ok(Length { m: LENGTH.parse(text)? })
    }
}

impl FromStr for SignedLength {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let m = LENGTH.parse_signed(text)?;
        if m.is_finite() {
            Ok(SignedLength { m })
        } else {
            Err(QuantityError::NotFinite { text: text.to_owned() })
        }
    }
}

impl FromStr for Force {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Ok(Force { n: FORCE.parse(text)? })
    }
}

impl FromStr for Area {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Ok(Area { m2: AREA.parse(text)? })
    }
}

impl FromStr for Modulus {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        Ok(Modulus { pa: MODULUS.parse(text)? })
    }
}

impl FromStr for Pressure {
    type Err = QuantityError;

    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let (number, unit) = PRESSURE.split(text)?;
        if unit == HARDNESS_UNIT {
            return Ok(Pressure::Hardnesses(PRESSURE.positive(text, scaled(number, UnitScale::ONE))?));
        }
        Ok(Pressure::Pascals(PRESSURE.parse(text)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn metres(text: &str) -> f64 {
        text.parse::<Length>().unwrap().m
    }

    #[test]
    fn units_move_the_decimal_point_and_round_once() {
        for (text, expected) in [
            ("5um", 5e-6),
            ("5 µm", 5e-6),
            ("9.8 nm", 9.8e-9),
            ("5.65e0nm", 5.65e-9),
            ("3 Å", 3e-10),
            ("2e-3 mm", 2e-6),
            ("5 microns", 5e-6),
            ("1 inch", 0.0254),
            ("0.1 in", 2.54e-3),
            ("32 uin", 8.128e-7),
            ("3 Angstrom", 3e-10),
        ] {
            assert_eq!(metres(text), expected, "{text}");
        }
        assert_eq!("463 GPa".parse::<Pressure>(), Ok(Pressure::Pascals(463e9)));
        assert_eq!("1.8e9 Pa".parse::<Pressure>(), Ok(Pressure::Pascals(1.8e9)));
        assert_eq!("1e-3 H".parse::<Pressure>(), Ok(Pressure::Hardnesses(1e-3)));
        assert_eq!("1e-3H".parse::<Pressure>().unwrap().pascals(Some(5.4e9)), Some(1e-3 * 5.4e9));
        assert_eq!("1e-3H".parse::<Pressure>().unwrap().pascals(None), None);
        assert_eq!("1 psi".parse(), Ok(Pressure::Pascals(6_894.757293168361)));
        assert_eq!("50 ksi".parse::<Modulus>().unwrap().pa, 344_737_864.65841805);
        assert_eq!("2.5 cm^2".parse::<Area>().unwrap().m2, 2.5e-4);
        assert_eq!("10 mN".parse::<Force>().unwrap().n, 10e-3);
    }

    #[test]
    fn what_is_no_quantity_is_refused_with_the_mend() {
        let message = |text: &str| text.parse::<Pressure>().unwrap_err().to_string();
        assert_eq!(
            message("463e9"),
            "'463e9' has no unit; a pressure needs one of Pa, hPa, kPa, bar, MPa, GPa, TPa, psi, ksi, H, as in '5.4 MPa'"
        );
        assert_eq!(
            message("463 um"),
            "'463 um' has the unit 'um'; a pressure needs one of Pa, hPa, kPa, bar, MPa, GPa, TPa, psi, ksi, H"
        );
        assert_eq!(
            message("-5 MPa"),
            "'-5 MPa' is out of range; a pressure must be greater than 0 and finite"
        );
        assert_eq!(
            message("1e999 Pa"),
            "'1e999 Pa' is out of range; a pressure must be greater than 0 and finite"
        );
        assert_eq!(message("GPa"), "'GPa' does not start with a number; a pressure reads like '5.4 MPa'");
        assert!(message("inf Pa").starts_with("'inf Pa' does not start with a number"));
        assert!(message("1e99999999999999999999 Pa").contains("out of range"));
        assert_eq!(
            "5 A".parse::<Length>().unwrap_err().to_string(),
            "'5 A' has the unit 'A'; a length needs one of m, cm, mm, um, nm, angstrom, pm, km, inch, uin"
        );
        assert!("5".parse::<Length>().is_err());
        assert!("0 m".parse::<Length>().is_err());
    }
}
