//! Units in column headers.

use std::num::IntErrorKind;

use units::{LengthUnit, UnitScale};

/// A unit that is a power of a unit of length, or a product of two.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unit {
    /// Power of metres, such as 1, -1, 3 or 4.
    pub(crate) metre_power: i32,
    length: LengthUnit,
    /// The second factor with its power, as in nm^2 mm.
    by: Option<(LengthUnit, i32)>,
    /// True if radians are stated, as in rad/m.
    pub(crate) angular: bool,
}

impl Unit {
    /// Returns the SI unit with this power of metres.
    pub(crate) const fn si(metre_power: i32) -> Self {
        Self { metre_power, length: LengthUnit::METRE, by: None, angular: false }
    }

    /// Size in SI units.
    pub(crate) const fn scale(self) -> UnitScale {
        match self.by {
            None => self.length.scale().to_the(self.metre_power),
            Some((by, power)) => {
                self.length.scale().to_the(self.metre_power - power).times(by.scale().to_the(power))
            }
        }
    }

    /// Returns true if both units have the same size, ignoring radians.
    pub(crate) fn is_same_size(self, other: Self) -> bool {
        (self.metre_power, self.scale()) == (other.metre_power, other.scale())
    }

    /// Parses a unit as headers write it: `nm`, `1/µm`, `µm⁻¹`, `um^-1`, `rad/m`, `rad_per_m`, `m3`, `nm^3`, `µm³`, `nm² mm`,
    /// `nm^2/mm^-1`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        Self::power(text).or_else(|| Self::product(text.trim()))
    }

    /// Parses two factors, as in `nm^2 mm`.
    fn product(text: &str) -> Option<Self> {
        let (first, second) = text.split_at(text.find([' ', '*', '·', '/'])?);
        let sign = if second.trim_start().starts_with('/') { -1 } else { 1 };
        let first = Self::power(first)?;
        let second = second.trim_start_matches([' ', '*', '·', '/', '(']).trim_end_matches(')');
        let second = Self::power(second).filter(|_| !second.contains([' ', '*', '·']))?;
        let power = second.metre_power.saturating_mul(sign);
        let metre_power = first.metre_power.saturating_add(power);
        Some(Self { metre_power, by: Some((second.length, power)), ..first })
            .filter(|_| !first.angular && !second.angular)
    }

    fn power(text: &str) -> Option<Self> {
        let text = plain(text);
        let (text, angular) = match text.strip_prefix("rad") {
            Some(rest) => (rest, true),
            None => (text.as_str(), false),
        };
        let cycles = ["cycles", "cycle", "cyc"].iter().find_map(|word| text.strip_prefix(word));
        let text = cycles.unwrap_or(text).trim_start_matches(['*', '·', '_']);
        let (text, sign) = match ["1/", "/", "1_per_", "per_", "1per", "per"]
            .iter()
            .find_map(|per| text.strip_prefix(per))
        {
            Some(rest) => (rest, -1),
            None => (text, 1),
        };
        let power_at = text.find(['^', '-', '1', '2', '3', '4']).unwrap_or(text.len());
        let (metre, power) = text.split_at(power_at);
        let power: i32 = match power.strip_prefix('^').unwrap_or(power) {
            "" if power.is_empty() => 1,
            digits => whole(digits)?,
        };
        let metre_power = power.saturating_mul(sign);
        if (angular || cycles.is_some()) && metre_power != -1 {
            return None;
        }
        Some(Self { metre_power, length: LengthUnit::parse_any_case(metre)?, by: None, angular })
    }
}

impl std::fmt::Display for Unit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let metre = self.length.ascii();
        if let Some((by, power)) = self.by {
            return write!(f, "{metre}^{} {}^{power}", self.metre_power - power, by.ascii());
        }
        match self.metre_power {
            1 => f.write_str(metre),
            -1 if self.angular => write!(f, "rad/{metre}"),
            -1 => write!(f, "1/{metre}"),
            power => write!(f, "{metre}^{power}"),
        }
    }
}

/// Converts a text to lower case and ASCII, without spaces.
fn plain(text: &str) -> String {
    let mut plain = String::new();
    for character in text.chars().flat_map(char::to_lowercase) {
        match character {
            ' ' => {}
            'µ' | 'μ' => plain.push('u'),
            '⁻' | '−' => plain.push('-'),
            '¹' => plain.push('1'),
            '²' => plain.push('2'),
            '³' => plain.push('3'),
            '⁴' => plain.push('4'),
            other => plain.push(other),
        }
    }
    plain
}

/// Parses a whole number; one too large for an integer saturates, which is not the power of any quantity.
fn whole(digits: &str) -> Option<i32> {
    digits.parse().map_or_else(
        |error: std::num::ParseIntError| match error.kind() {
            IntErrorKind::PosOverflow => Some(i32::MAX),
            IntErrorKind::NegOverflow => Some(i32::MIN),
            _ => None,
        },
        Some,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_in_every_spelling() {
        let unit =
            |metre_power, decimal_exponent| Some((metre_power, UnitScale::power_of_ten(decimal_exponent)));
        for (text, expected) in [
            ("m", unit(1, 0)),
            ("cm", unit(1, -2)),
            ("MM", unit(1, -3)),
            ("um", unit(1, -6)),
            ("\u{b5}m", unit(1, -6)),
            ("\u{3bc}m", unit(1, -6)),
            ("nm", unit(1, -9)),
            ("pm", unit(1, -12)),
            ("Å", unit(1, -10)),
            ("\u{212b}", unit(1, -10)),
            ("angstrom", unit(1, -10)),
            ("1/m", unit(-1, 0)),
            ("m^-1", unit(-1, 0)),
            ("m⁻¹", unit(-1, 0)),
            ("m-1", unit(-1, 0)),
            ("1/µm", unit(-1, 6)),
            ("µm⁻¹", unit(-1, 6)),
            ("um^-1", unit(-1, 6)),
            ("per_nm", unit(-1, 9)),
            ("1 / nm", unit(-1, 9)),
            ("cycles/mm", unit(-1, 3)),
            ("cyc per mm", unit(-1, 3)),
            ("m3", unit(3, 0)),
            ("m^3", unit(3, 0)),
            ("µm³", unit(3, -18)),
            ("nm3", unit(3, -27)),
            ("Å^3", unit(3, -30)),
            ("m⁴", unit(4, 0)),
            ("um^4", unit(4, -24)),
            ("microns", unit(1, -6)),
            ("uin", Some((1, UnitScale::decimal(254, -10)))),
            ("nm^2 mm", unit(3, -21)),
            ("nm² mm", unit(3, -21)),
            ("nm²·mm²", unit(4, -24)),
            ("mm nm^2", unit(3, -21)),
            ("nm2*um", unit(3, -24)),
            ("nm^2/mm^-1", unit(3, -21)),
            ("nm^2 / (1/mm)", unit(3, -21)),
            ("nm^2 * (1/mm)", unit(1, -15)),
            ("nm^2/mm", unit(1, -15)),
            ("inch^3", Some((3, UnitScale::decimal(16_387_064, -12)))),
        ] {
            let unit = Unit::parse(text).filter(|unit| !unit.angular);
            assert_eq!(unit.map(|unit| (unit.metre_power, unit.scale())), expected, "{text}");
        }
        for text in ["rad/m", "rad_per_m", "rad m^-1", "rad·m⁻¹", "rad per m"] {
            assert_eq!(Unit::parse(text), Some(Unit { angular: true, ..Unit::si(-1) }), "{text}");
        }
    }

    #[test]
    fn only_powers_of_metres_are_units() {
        for text in [
            "",
            "furlong",
            "Hz",
            "rad",
            "rad_m",
            "m^",
            "m^x",
            "3",
            "1/",
            "nmm",
            "m3m",
            "kg",
            "cycles",
            "cycles mm",
            "nm^2 kg",
            "nm^2 rad/mm",
            "m m m",
        ] {
            assert_eq!(Unit::parse(text), None, "{text}");
        }
    }
}
