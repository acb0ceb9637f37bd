//! Units in column headers and the exact scaling of decimal text to SI.

/// A unit that is a power of metres with a decimal prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unit {
    /// Power of metres, such as 1, -1, 3 or 4.
    pub(crate) metre_power: i32,
    /// The unit is 10^`decimal_exponent` of the SI unit.
    pub(crate) decimal_exponent: i32,
    /// Whether radians are stated, as in rad/m.
    pub(crate) angular: bool,
}

impl Unit {
    /// The unit of SI with this power of metres.
    pub(crate) const fn si(metre_power: i32) -> Self {
        Self { metre_power, decimal_exponent: 0, angular: false }
    }

    /// Whether one of it is as much as one of the other; radians do not count.
    pub(crate) fn is_same_size(self, other: Self) -> bool {
        (self.metre_power, self.decimal_exponent) == (other.metre_power, other.decimal_exponent)
    }

    /// Reads a unit as headers write it: `nm`, `1/µm`, `µm⁻¹`, `um^-1`, `rad/m`, `rad_per_m`, `m3`, `nm^3`,
    /// `µm³`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let text = plain(text);
        let (text, angular) = match text.strip_prefix("rad") {
            Some(rest) => (rest, true),
            None => (text.as_str(), false),
        };
        let text = text.trim_start_matches(['*', '·', '_']);
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
            digits => digits.parse().ok()?,
        };
        let metre_power = sign * power;
        if angular && metre_power != -1 {
            return None;
        }
        Some(Self { metre_power, decimal_exponent: metre_power * decimal_prefix(metre)?, angular })
    }
}

impl std::fmt::Display for Unit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let metre = match self.decimal_exponent.checked_div(self.metre_power).unwrap_or(0) {
            0 => "m",
            -2 => "cm",
            -3 => "mm",
            -6 => "um",
            -9 => "nm",
            -10 => "angstrom",
            _ => "pm",
        };
        match self.metre_power {
            1 => f.write_str(metre),
            -1 if self.angular => write!(f, "rad/{metre}"),
            -1 => write!(f, "1/{metre}"),
            power => write!(f, "{metre}^{power}"),
        }
    }
}

/// The text in lower case and ASCII, without spaces.
fn plain(text: &str) -> String {
    let mut plain = String::new();
    for character in text.chars().flat_map(char::to_lowercase) {
        match character {
            ' ' => {}
            'µ' | 'μ' => plain.push('u'),
            '⁻' | '−' => plain.push('-'),
            '¹' => plain.push('1'),
            '³' => plain.push('3'),
            '⁴' => plain.push('4'),
            other => plain.push(other),
        }
    }
    plain
}

fn decimal_prefix(metre: &str) -> Option<i32> {
    Some(match metre {
        "m" => 0,
        "cm" => -2,
        "mm" => -3,
        "um" => -6,
        "nm" => -9,
        "å" | "angstrom" | "ångström" => -10,
        "pm" => -12,
        _ => return None,
    })
}

/// The number `text` x 10^`decimal_exponent`, correctly rounded: the exponent is shifted in the text itself.
///
/// `None` where the text is no number. NaN, infinities and overflow come back as such.
pub(crate) fn parse_scaled(text: &str, decimal_exponent: i32) -> Option<f64> {
    if decimal_exponent == 0 {
        return text.parse().ok();
    }
    shifted(text, decimal_exponent).or_else(|| text.parse().ok().filter(|value: &f64| !value.is_finite()))
}

/// The scaled number; none for what has no digits, NaN and infinity included.
fn shifted(text: &str, decimal_exponent: i32) -> Option<f64> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse().ok()?),
        None => (text, 0i32),
    };
    format!("{mantissa}e{}", exponent.saturating_add(decimal_exponent)).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_in_every_spelling() {
        let unit =
            |metre_power, decimal_exponent| Some(Unit { metre_power, decimal_exponent, angular: false });
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
            ("m3", unit(3, 0)),
            ("m^3", unit(3, 0)),
            ("µm³", unit(3, -18)),
            ("nm3", unit(3, -27)),
            ("Å^3", unit(3, -30)),
            ("m⁴", unit(4, 0)),
            ("um^4", unit(4, -24)),
        ] {
            assert_eq!(Unit::parse(text), expected, "{text}");
        }
        for text in ["rad/m", "rad_per_m", "rad m^-1", "rad·m⁻¹", "rad per m"] {
            assert_eq!(Unit::parse(text), Some(Unit { angular: true, ..Unit::si(-1) }), "{text}");
        }
    }

    #[test]
    fn what_is_no_power_of_metres_is_no_unit() {
        for text in ["", "furlong", "Hz", "rad", "rad_m", "m^", "m^x", "3", "1/", "nmm", "m3m", "kg"] {
            assert_eq!(Unit::parse(text), None, "{text}");
        }
    }

    #[test]
    fn scaling_by_a_unit_is_correctly_rounded() {
        assert_eq!(parse_scaled("5.65", -9), Some(5.65e-9));
        assert_ne!(5.65 * 1e-9, 5.65e-9);
        assert_eq!(parse_scaled("+5.65E+3", -9), Some(5.65e-6));
        assert_eq!(parse_scaled("-.5e-3", 6), Some(-500.0));
        assert_eq!(parse_scaled("1e400", -200), Some(1e200));
        assert_eq!(parse_scaled("1e-9", 0), Some(1e-9));
        assert_eq!(parse_scaled("-inf", -9), Some(f64::NEG_INFINITY));
        assert!(parse_scaled("NaN", -9).unwrap().is_nan());
        assert_eq!(parse_scaled("1,5", -9), None);
        assert_eq!(parse_scaled("", -9), None);
    }
}
