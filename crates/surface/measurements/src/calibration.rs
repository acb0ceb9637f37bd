//! Typed options about the calibration of an instrument.

use std::str::FromStr;

use units::{Bound, Share};

/// Relative standard uncertainty of a height scale, above 0 and at most 1, typed as `3 %` or `0.03`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZCalibration {
    /// The relative standard uncertainty.
    pub share: f64,
}

impl FromStr for ZCalibration {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let share: Share = text.parse().map_err(|error: units::ShareError| error.to_string())?;
        let bound = Bound::LeftOpen { above: 0.0, at_most: 1.0 };
        let checked = bound.check("the standard uncertainty of the height scale, as a share", share.fraction);
        checked.map(|share| ZCalibration { share }).map_err(|error| error.to_string())
    }
}

/// Standard uncertainty of the exponent of a spectrum, d ln C/d ln q, from 0 to 10.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlopeUncertainty {
    /// Standard uncertainty of the exponent, dimensionless.
    pub standard_uncertainty: f64,
}

impl FromStr for SlopeUncertainty {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let value: f64 =
            text.trim().parse().map_err(|_| format!("'{text}' is not a number; write one such as 0.05"))?;
        let bound = Bound::Within { at_least: 0.0, at_most: 10.0 };
        let checked = bound.check("the standard uncertainty of the spectrum's exponent", value);
        checked
            .map(|standard_uncertainty| SlopeUncertainty { standard_uncertainty })
            .map_err(|error| error.to_string())
    }
}

/// The name of an instrument, not empty.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Instrument(pub String);

impl FromStr for Instrument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "" => {
                Err("the name of an instrument is empty; give one, such as AFM, or leave it out".to_owned())
            }
            name => Ok(Instrument(name.to_owned())),
        }
    }
}
