//! A surface given only by roughness parameters.

use spectrum::{HURST_UNCERTAINTY, ROLLOFF_UNCERTAINTY_FACTOR, RoughnessParameters, SelfAffineProfile};
use units::display::{length, three_digits};
use units::{Remark, RemarkCode};

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
    /// The remark on what was given and what was assumed.
    #[must_use]
    pub fn remark(&self) -> Remark {
        let RoughnessParameters { rms_height_m, rms_slope, rolloff_m, hurst_exponent } =
            self.profile.parameters();
        let rolloff = match self.rolloff_from {
            RollOffFrom::Given => "given",
            RollOffFrom::MeanWidth => "the mean width RSm",
        };
        Remark::new(RemarkCode::OfParameters)
            .with("rms_height_m", rms_height_m)
            .with("rms_slope", rms_slope)
            .with("longest_m", self.profile.longest_m())
            .with("rolloff_m", rolloff_m)
            .with("rolloff", rolloff)
            .with("hurst_exponent", hurst_exponent)
            .with("hurst", if self.hurst_is_assumed { "assumed" } else { "given" })
            .with("shortest_m", self.profile.shortest_m())
            .with("hurst_uncertainty", HURST_UNCERTAINTY)
            .with("rolloff_factor", ROLLOFF_UNCERTAINTY_FACTOR)
    }

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
