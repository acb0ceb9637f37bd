//! Fractions typed in percent or as plain numbers.

use std::str::FromStr;

use crate::number_text::without_comma;
use crate::unit_scale::UnitScale;

/// A fraction, typed as `3 %` or `0.03`. Finite; further bounds belong to its use.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// The fraction as a plain number: 0.03 for 3 %.
    pub fraction: f64,
}

/// A text that is not a fraction.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("'{text}' is not a fraction; write {meant}", text = .0, meant = without_comma(.0).unwrap_or_else(|| "'3 %' or '0.03'".to_owned()))]
pub struct ShareError(pub String);

impl FromStr for Share {
    type Err = ShareError;

    fn from_str(text: &str) -> Result<Self, ShareError> {
        let trimmed = text.trim();
        let fraction = match trimmed.strip_suffix('%') {
            Some(percent) => UnitScale::power_of_ten(-2).read(percent.trim_end()),
            None => trimmed.parse().ok(),
        };
        let fraction =
            fraction.filter(|share| share.is_finite()).ok_or_else(|| ShareError(text.to_owned()))?;
        Ok(Share { fraction })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_are_hundredths_and_rounded_once() {
        for (text, fraction) in
            [("3 %", 0.03), ("3%", 0.03), ("0.03", 0.03), ("2.5e1 %", 0.25), (" 1 ", 1.0), ("-3 %", -0.03)]
        {
            assert_eq!(text.parse(), Ok(Share { fraction }), "{text}");
        }
    }

    #[test]
    fn a_decimal_comma_is_refused_with_a_point() {
        assert_eq!(
            "3,5 %".parse::<Share>().unwrap_err().to_string(),
            "'3,5 %' is not a fraction; write 3.5 %"
        );
    }

    #[test]
    fn a_bad_fraction_is_refused_with_an_example() {
        for text in ["", "%", "3 nm", "three", "inf", "NaN %", "1e999", "3 % %"] {
            assert_eq!(
                text.parse::<Share>().unwrap_err().to_string(),
                format!("'{text}' is not a fraction; write '3 %' or '0.03'")
            );
        }
    }
}
