//! Typed standard uncertainties: quantities that may be zero.

use std::str::FromStr;

use crate::quantity_error::QuantityError;
use crate::quantity_kind::is_zero;

/// Parses a standard uncertainty in a unit of its quantity; `None` if it is 0.
///
/// # Errors
/// [`QuantityError`] if the text is not such a quantity or is below 0.
pub fn standard_uncertainty<T: FromStr<Err = QuantityError>>(text: &str) -> Result<Option<T>, QuantityError> {
    match text.parse() {
        Err(QuantityError::NotPositive { text, .. }) if is_zero(&text) => Ok(None),
        Err(QuantityError::NotPositive { text, .. }) => Err(QuantityError::Uncertainty { text }),
        parsed => parsed.map(Some),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{IndentationHardness, Length, Modulus, Pressure};

    #[test]
    fn a_standard_uncertainty_may_be_zero_but_not_negative() {
        assert_eq!(standard_uncertainty("5 GPa"), Ok(Some(Modulus { pa: 5e9 })));
        assert_eq!(standard_uncertainty("10 HV"), Ok(Some(IndentationHardness { pa: 98_066_500.0 })));
        for text in ["0 GPa", "0.0GPa", "-0 Pa", "0e9 Pa"] {
            assert_eq!(standard_uncertainty::<Modulus>(text), Ok(None), "{text}");
        }
        assert_eq!(standard_uncertainty::<Pressure>("0 H"), Ok(None));
        for text in ["-5 um", "1e999 m"] {
            assert_eq!(
                standard_uncertainty::<Length>(text).unwrap_err().to_string(),
                format!("'{text}' is out of range; a standard uncertainty must be at least 0 and finite")
            );
        }
        assert!(standard_uncertainty::<Length>("5").unwrap_err().to_string().contains("has no unit"));
    }
}
