//! Shares of a whole, as people type them.

use std::str::FromStr;

use crate::unit_scale::UnitScale;

/// A share, typed in percent or as a plain number: `3 %` or `0.03`. Finite; whoever takes one has its bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// As a plain number: 0.03 for 3 %.
    pub of_one: f64,
}

/// What is wrong with a typed share.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("'{0}' is no share; one reads '3 %' or '0.03'")]
pub struct ShareError(pub String);

impl FromStr for Share {
    type Err = ShareError;

    fn from_str(text: &str) -> Result<Self, ShareError> {
        let trimmed = text.trim();
        let of_one = match trimmed.strip_suffix('%') {
            Some(percent) => UnitScale::power_of_ten(-2).read(percent.trim_end()),
            None => trimmed.parse().ok(),
        };
        let of_one = of_one.filter(|share| share.is_finite()).ok_or_else(|| ShareError(text.to_owned()))?;
        Ok(Share { of_one })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percent_are_hundredths_and_rounded_once() {
        for (text, of_one) in
            [("3 %", 0.03), ("3%", 0.03), ("0.03", 0.03), ("2.5e1 %", 0.25), (" 1 ", 1.0), ("-3 %", -0.03)]
        {
            assert_eq!(text.parse(), Ok(Share { of_one }), "{text}");
        }
    }

    #[test]
    fn what_is_no_share_is_told_how_one_reads() {
        for text in ["", "%", "3 nm", "three", "inf", "NaN %", "1e999", "3 % %"] {
            assert_eq!(
                text.parse::<Share>().unwrap_err().to_string(),
                format!("'{text}' is no share; one reads '3 %' or '0.03'")
            );
        }
    }
}
