//! A surface given only by roughness parameters.

use spectrum::{RoughnessParameters, SelfAffineProfile};
use units::display::{length, three_digits};

/// The default Hurst exponent, common among measured surfaces.
pub const ASSUMED_HURST: f64 = 0.8;

/// The spectrum of roughness parameters, and what of it was assumed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GivenRoughness {
    /// The spectrum.
    pub profile: SelfAffineProfile,
    /// Origin of the roll-off wavelength.
    pub rolloff_from: RollOffFrom,
    /// True if the Hurst exponent was assumed, not given.
    pub hurst_is_assumed: bool,
}

/// Origin of a roll-off wavelength.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RollOffFrom {
    /// It was given.
    Given,
    /// The mean width of profile elements, RSm, was taken for it.
    MeanWidth,
}

impl GivenRoughness {
    /// The surface by its parameters, in short.
    #[must_use]
    pub fn name(&self) -> String {
        let RoughnessParameters { rms_height_m, rms_slope, rolloff_m, hurst_exponent } =
            self.profile.parameters();
        let width = match self.rolloff_from {
            RollOffFrom::Given => "roll-off",
            RollOffFrom::MeanWidth => "RSm",
        };
        format!(
            "Rq {}, Rdq {}, {width} {}, H {}",
            length(rms_height_m),
            three_digits(rms_slope),
            length(rolloff_m),
            three_digits(hurst_exponent)
        )
    }
}
