//! Conversion of decimal text to SI units with a single rounding.

/// Size of a unit in SI units: `multiple`/`divisor` times a power of ten. All are whole numbers, so that scaled text is
/// rounded once, when it becomes a double.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct UnitScale {
    multiple: u64,
    divisor: u64,
    decimal_exponent: i32,
}

impl UnitScale {
    /// The SI unit itself.
    pub const ONE: Self = Self::power_of_ten(0);

    /// A unit of 10^`decimal_exponent` SI units.
    #[must_use]
    pub const fn power_of_ten(decimal_exponent: i32) -> Self {
        Self::decimal(1, decimal_exponent)
    }

    /// A unit of `multiple` x 10^`decimal_exponent` SI units.
    #[must_use]
    pub const fn decimal(multiple: u64, decimal_exponent: i32) -> Self {
        Self { multiple, divisor: 1, decimal_exponent }
    }

    /// Multiplies the unit by another.
    #[must_use]
    pub const fn times(self, other: Self) -> Self {
        Self {
            multiple: self.multiple.saturating_mul(other.multiple),
            divisor: self.divisor.saturating_mul(other.divisor),
            decimal_exponent: self.decimal_exponent.saturating_add(other.decimal_exponent),
        }
    }

    /// Raises the unit to a small whole power of either sign.
    #[must_use]
    pub const fn to_the(self, power: i32) -> Self {
        let raised = power.unsigned_abs();
        let (multiple, divisor) = (self.multiple.saturating_pow(raised), self.divisor.saturating_pow(raised));
        let decimal_exponent = self.decimal_exponent.saturating_mul(power);
        if power < 0 {
            Self { multiple: divisor, divisor: multiple, decimal_exponent }
        } else {
            Self { multiple, divisor, decimal_exponent }
        }
    }

    /// Parses a number in this unit into SI units; `None` if the text is not a number.
    ///
    /// Rounds once, and once more for a divisor, as for wavevectors per inch. NaN, infinities and overflow are returned
    /// unchanged.
    #[must_use]
    pub fn read(self, text: &str) -> Option<f64> {
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        // An exponent too long for an integer turns any number into zero or infinity.
        let exponent = exponent.parse().map_or_else(
            |_| exponent.to_owned(),
            |exponent: i64| exponent.saturating_add(i64::from(self.decimal_exponent)).to_string(),
        );
        let mantissa =
            if self.multiple == 1 { mantissa.to_owned() } else { product(mantissa, self.multiple) };
        let scaled = format!("{mantissa}e{exponent}").parse().ok();
        let not_finite = || text.parse().ok().filter(|value: &f64| !value.is_finite());
        Some(scaled.or_else(not_finite)? / self.divisor as f64)
    }

    /// Converts a number in this unit to SI units, with a single rounding for decimal units.
    #[must_use]
    pub fn to_si(self, value: f64) -> f64 {
        let ratio = value * self.multiple as f64 / self.divisor as f64;
        // Only whole powers of ten are exact.
        let power = 10f64.powi(self.decimal_exponent.abs());
        if self.decimal_exponent < 0 { ratio / power } else { ratio * power }
    }
}

/// Multiplies the digits of a decimal number by a whole number; sign, point and other characters stay in place.
fn product(mantissa: &str, multiple: u64) -> String {
    let start = mantissa.find(|c: char| c.is_ascii_digit() || c == '.').unwrap_or(mantissa.len());
    let (sign, digits) = mantissa.split_at(start);
    let mut carry = 0u128;
    let mut reversed = Vec::new();
    for character in digits.chars().rev() {
        match character.to_digit(10) {
            Some(digit) => {
                carry += u128::from(digit) * u128::from(multiple);
                reversed.push(char::from(b'0' + (carry % 10) as u8));
                carry /= 10;
            }
            None => reversed.push(character),
        }
    }
    let leading = if carry == 0 { String::new() } else { carry.to_string() };
    format!("{sign}{leading}{}", reversed.iter().rev().collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaling_by_a_unit_is_correctly_rounded() {
        let read = |text, exponent| UnitScale::power_of_ten(exponent).read(text);
        assert_eq!(read("5.65", -9), Some(5.65e-9));
        assert_ne!(5.65 * 1e-9, 5.65e-9);
        assert_eq!(read("+5.65E+3", -9), Some(5.65e-6));
        assert_eq!(read("-.5e-3", 6), Some(-500.0));
        assert_eq!(read("1e400", -200), Some(1e200));
        assert_eq!(read("1e-9", 0), Some(1e-9));
        assert_eq!(read("-inf", -9), Some(f64::NEG_INFINITY));
        assert!(read("NaN", -9).unwrap().is_nan());
        assert_eq!(read("1e99999999999999999999", -9), Some(f64::INFINITY));
        for text in ["1,5", "", "e3", "1e", "1e2e3", "0x10"] {
            assert_eq!(read(text, -9), None, "{text}");
        }
    }

    #[test]
    fn multiples_of_powers_of_ten_are_rounded_once_as_well() {
        let inch = UnitScale::decimal(254, -4);
        for (text, expected) in
            [("1", 0.0254), ("-0.1", -0.00254), ("39.37", 0.999998), (".5e3", 12.7), ("99", 2.5146)]
        {
            assert_eq!(inch.read(text), Some(expected), "{text}");
            let value: f64 = text.parse().unwrap();
            assert!((inch.to_si(value) / expected - 1.0).abs() < 3e-16, "{text}");
        }
        for text in ["", "-", ".", "1.2.3", "ten"] {
            assert_eq!(inch.read(text), None, "{text}");
        }
        assert_eq!(inch.read("inf"), Some(f64::INFINITY));
        assert_eq!(inch.to_the(3).read("1"), Some(1.6387064e-5));
        assert_eq!(inch.to_the(-1).read("254"), Some(1e4));
    }

    #[test]
    fn numbers_are_scaled_like_text() {
        assert_eq!(UnitScale::power_of_ten(-9).to_si(5.65), 5.65e-9);
        assert_eq!(UnitScale::power_of_ten(3).to_si(1.5), 1500.0);
        assert_eq!(UnitScale::decimal(254, -4).to_si(1.0), 0.0254);
    }
}
