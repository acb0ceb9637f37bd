//! Typed uncertain quantities: `210 GPa +- 5 GPa`, `0.8 GPa to 1.2 GPa`.

/// The two parts of a typed uncertain quantity, as text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TypedSpread<'t> {
    /// A value and its standard uncertainty, with `+-`, `+/-` or `±` between them.
    PlusMinus {
        /// The value.
        value: &'t str,
        /// The standard uncertainty, in a unit of the value or as a fraction of it.
        uncertainty: &'t str,
    },
    /// The ends of an interval, with `to` between them.
    Interval {
        /// The lower end.
        from: &'t str,
        /// The upper end.
        to: &'t str,
    },
}

impl<'t> TypedSpread<'t> {
    /// Splits the text of an uncertain quantity; `None` for a single quantity, valid or not.
    #[must_use]
    pub fn parse(text: &'t str) -> Option<Self> {
        let parts = |sign: &str| text.split_once(sign).map(|(first, last)| (first.trim(), last.trim()));
        if let Some((value, uncertainty)) = ["+-", "+/-", "±"].into_iter().find_map(parts) {
            return Some(TypedSpread::PlusMinus { value, uncertainty });
        }
        let (from, to) = parts(" to ")?;
        Some(TypedSpread::Interval { from, to })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{IndentationHardness, Length, Modulus, Pressure, QuantityError};

    #[test]
    fn an_uncertain_quantity_differs_from_a_single_one() {
        let plus_minus = Some(TypedSpread::PlusMinus { value: "210 GPa", uncertainty: "5 GPa" });
        for text in ["210 GPa +- 5 GPa", "210 GPa ± 5 GPa", "210 GPa+/-5 GPa", " 210 GPa  +-5 GPa "] {
            assert_eq!(TypedSpread::parse(text), plus_minus, "{text}");
        }
        let interval = Some(TypedSpread::Interval { from: "0.8GPa", to: "1.2 GPa" });
        assert_eq!(TypedSpread::parse("0.8GPa to 1.2 GPa"), interval);
        for text in ["210 GPa", "-5 GPa", "1e+9 Pa", "1e-9 m", "towards", "", "5 to", "1 ton"] {
            assert_eq!(TypedSpread::parse(text), None, "{text}");
        }
    }

    #[test]
    fn an_uncertainty_is_refused_where_a_single_value_is_expected() {
        for text in ["210 GPa +- 5 GPa", "210 +- 5 GPa", "210 GPa ± 2 %", "0.8 GPa to 1.2 GPa", "1 to 2 GPa"]
        {
            let expected = format!(
                "expected a single modulus, not '{text}'; uncertainties (+-, to) are allowed only for materials of scenes"
            );
            assert_eq!(text.parse::<Modulus>().unwrap_err().to_string(), expected);
        }
        let spread = |error: QuantityError| matches!(error, QuantityError::OneValueWanted { .. });
        assert!(spread("300 HV +- 10 HV".parse::<IndentationHardness>().unwrap_err()));
        assert!(spread("1e-3 H +- 1e-4 H".parse::<Pressure>().unwrap_err()));
        assert!(spread("5 um to 6 um".parse::<Length>().unwrap_err()));
        assert!(!spread("5 to".parse::<Length>().unwrap_err()));
    }
}
