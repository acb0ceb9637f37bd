//! A roughness parameter by its symbol in the standards, with its dimension and convention.

use std::fmt;

use units::display::{length, percent, three_digits};

/// A roughness parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Symbol such as `Sa`.
    pub symbol: &'static str,
    /// Value, with its dimension.
    pub value: ParameterValue,
    /// Convention behind the value where there are several, such as `differences of neighbours`; empty where the standards
    /// leave no choice.
    pub convention: String,
    /// False for a further convention of a parameter that stands in the list already.
    pub is_first: bool,
}

/// Value of a roughness parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterValue {
    /// A length in m.
    LengthM(f64),
    /// A number without dimension.
    Number(f64),
    /// A share, 1 for all.
    Share(f64),
    /// A volume over an area, in m.
    VolumeM(f64),
    /// A value that the scan does not determine.
    NotDetermined,
}

impl ParameterValue {
    /// Returns the value in SI units, if the scan determines it.
    #[must_use]
    pub fn known(self) -> Option<f64> {
        match self {
            Self::LengthM(value) | Self::Number(value) | Self::Share(value) | Self::VolumeM(value) => {
                Some(value)
            }
            Self::NotDetermined => None,
        }
    }
}

impl fmt::Display for Parameter {
    /// `Sa 3.02 nm`, with three digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = match self.value {
            ParameterValue::LengthM(value_m) => length(value_m),
            ParameterValue::Number(value) => three_digits(value),
            ParameterValue::Share(share) => percent(share),
            ParameterValue::VolumeM(value_m) => format!("{} µm³/µm²", three_digits(1e6 * value_m)),
            ParameterValue::NotDetermined => "not determined".to_owned(),
        };
        write!(f, "{} {value}", self.symbol)
    }
}

impl Parameter {
    /// Makes a parameter whose convention the standards fix.
    pub(crate) fn new(symbol: &'static str, value: ParameterValue) -> Self {
        Parameter { symbol, value, convention: String::new(), is_first: true }
    }

    /// Names the convention.
    pub(crate) fn by(self, convention: impl Into<String>) -> Self {
        Parameter { convention: convention.into(), ..self }
    }

    /// Marks a further convention of a parameter that stands in the list already.
    pub(crate) fn further(self) -> Self {
        Parameter { is_first: false, ..self }
    }
}
