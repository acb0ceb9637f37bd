//! The self-affine spectrum with given roughness parameters of a profile.
//!
//! Engineers' drawings and profilometers describe a surface by a few numbers of ISO 21920-2 (formerly ISO 4287): Rq,
//! the rms height, and Rdq, the rms slope, both of a profile, and RSm, the mean width of profile elements. They fix a
//! spectrum only if its form is assumed: here C1D is level down to the roll-off wavelength and falls as q^-(1 + 2 H)
//! from there to the shortest (Persson, Albohr, Tartaglino, Volokitin & Tosatti 2005, J. Phys.: Condens. Matter 17:R1,
//! section 2). The level gives Rq and the shortest wavelength Rdq, both exactly.
//!
//! For an isotropic surface, the parameters are those of any of its profiles: Sq of ISO 25178-2 is Rq, and Sdq is
//! sqrt(2) Rdq.
//!
//! **RSm is used as the roll-off wavelength.** If every crossing of the mean line counted, RSm of a Gaussian profile
//! would be 2 pi Rq/Rdq for any spectrum (Rice 1944) and add nothing. But the standard counts an element only if it
//! rises and falls by a tenth of Rz, which leaves the waves near the roll-off: for simulated Gaussian profiles with H
//! from 0.6 to 0.95 and one to three decades below the roll-off, RSm was 0.8 to 1.3 times the roll-off wavelength, and
//! 1.05 to 1.2 times at H = 0.8.

use std::f64::consts::{PI, TAU};

use numerics::zero_in_bracket;
use serde::Serialize;
use thiserror::Error;
use units::display::{length, three_digits};
use units::{Bound, OutOfBounds};

use crate::convention::Convention;
use crate::power_law::PowerLaw;
use crate::psd::Psd;

/// Roughness parameters of a profile and the form of its spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RoughnessParameters {
    /// Rq, the rms height \[m\].
    pub rms_height_m: f64,
    /// Rdq, the rms slope of the profile.
    pub rms_slope: f64,
    /// The wavelength \[m\] down to which the spectrum is level.
    pub rolloff_m: f64,
    /// Hurst exponent H, above 0 and at most 1.
    pub hurst_exponent: f64,
}

/// The spectrum of a profile: level from ten times the roll-off wavelength to the roll-off, then a power law.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SelfAffineProfile {
    parameters: RoughnessParameters,
    /// C1D of the level part \[m^3\].
    level_m3: f64,
    /// ln(q_s/q_r) for the wavevectors q_s of the shortest and q_r of the roll-off wavelength.
    ln_q_ratio: f64,
}

/// Errors of roughness parameters that no such spectrum has.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RoughnessError {
    /// A parameter outside its bound.
    #[error(transparent)]
    OutOfBounds(#[from] OutOfBounds),
    /// A slope smaller than that of the waves from the roll-off wavelength up.
    #[error(
        "the rms slope {} is too small for an rms height of {} and a roll-off wavelength of {}: waves from there up alone have \
         {}; give a longer roll-off wavelength or mean width, or a larger slope (dimensionless: 0.1 is 5.7 degrees)",
        three_digits(parameters.rms_slope),
        length(parameters.rms_height_m),
        length(parameters.rolloff_m),
        three_digits(*least)
    )]
    SlopeTooSmall {
        /// The parameters.
        parameters: RoughnessParameters,
        /// The smallest slope that such a spectrum has.
        least: f64,
    },
    /// A slope larger than waves down to atomic distances can make.
    #[error(
        "the rms slope {} is too large for an rms height of {}, a roll-off wavelength of {} and a Hurst exponent of {}: waves \
         down to {} make {}; give a shorter roll-off wavelength or mean width, a smaller Hurst exponent, or a smaller slope \
         (dimensionless: 0.1 is 5.7 degrees)",
        three_digits(parameters.rms_slope),
        length(parameters.rms_height_m),
        length(parameters.rolloff_m),
        three_digits(parameters.hurst_exponent),
        length(SHORTEST_M),
        three_digits(*largest)
    )]
    SlopeTooLarge {
        /// The parameters.
        parameters: RoughnessParameters,
        /// The largest slope that such a spectrum has.
        largest: f64,
    },
}

/// Ratio of the longest to the roll-off wavelength: profiles are evaluated over about ten of their widest features.
pub const LONGEST_OVER_ROLLOFF: f64 = 10.0;

/// Shortest wavelength of any spectrum \[m\]: atoms are farther apart.
const SHORTEST_M: f64 = 1e-10;

const SAMPLES_PER_DECADE: f64 = 20.0;

/// Standard uncertainty of the Hurst exponent, which drawings do not state; measured surfaces mostly have H from 0.7 to
/// 0.9.
pub const HURST_UNCERTAINTY: f64 = 0.1;
/// Standard uncertainty, as a factor, of a roll-off wavelength read off RSm or a drawing.
pub const ROLLOFF_UNCERTAINTY_FACTOR: f64 = 2.0;

/// Smallest Hurst exponent of a variation.
const LEAST_HURST: f64 = 0.01;

impl RoughnessParameters {
    fn check(self) -> Result<Self, OutOfBounds> {
        Bound::Magnitude.check("the rms height in m", self.rms_height_m)?;
        Bound::Magnitude.check("the rms slope", self.rms_slope)?;
        Bound::AtLeast(SHORTEST_M).check("the roll-off wavelength in m", self.rolloff_m)?;
        Bound::Magnitude.check("the roll-off wavelength in m", self.rolloff_m)?;
        Bound::LeftOpen { above: 0.0, at_most: 1.0 }.check("the Hurst exponent", self.hurst_exponent)?;
        Ok(self)
    }

    /// Mean square slope over mean square height in units of q_r^2, which determines q_s/q_r.
    fn mean_square_ratio(&self) -> f64 {
        (self.rms_slope * self.rolloff_m / (TAU * self.rms_height_m)).powi(2)
    }

    fn slope_of(&self, mean_square_ratio: f64) -> f64 {
        mean_square_ratio.sqrt() * TAU * self.rms_height_m / self.rolloff_m
    }

    /// ln(q_s/q_r) of a spectrum down to [`SHORTEST_M`].
    fn largest_ln_q_ratio(&self) -> f64 {
        (self.rolloff_m / SHORTEST_M).ln()
    }
}

/// Integrates x^k C over x = q/q_r for the spectrum with level 1.
fn integral(hurst_exponent: f64, ln_q_ratio: f64, k: i32) -> f64 {
    let level = PowerLaw {
        start_rad_per_m: 1.0 / LONGEST_OVER_ROLLOFF,
        end_rad_per_m: 1.0,
        at_start: 1.0,
        exponent: 0.0,
    };
    let exponent = -(1.0 + 2.0 * hurst_exponent);
    let fall = PowerLaw { start_rad_per_m: 1.0, end_rad_per_m: ln_q_ratio.exp(), at_start: 1.0, exponent };
    level.integral(k) + fall.integral(k)
}

impl SelfAffineProfile {
    /// Finds the spectrum with these parameters.
    ///
    /// # Errors
    /// [`RoughnessError`] for parameters out of bounds, and for a slope that no such spectrum has with the other
    /// parameters.
    pub fn new(parameters: RoughnessParameters) -> Result<Self, RoughnessError> {
        parameters.check()?;
        let wanted = parameters.mean_square_ratio();
        let [least, largest] = [0.0, parameters.largest_ln_q_ratio()]
            .map(|ln_q_ratio| mean_square_ratio(parameters.hurst_exponent, ln_q_ratio));
        // Rounding must not refuse the spectrum that ends at its roll-off.
        if wanted < least * (1.0 - 1e-12) {
            return Err(RoughnessError::SlopeTooSmall { parameters, least: parameters.slope_of(least) });
        }
        if wanted > largest {
            return Err(RoughnessError::SlopeTooLarge { parameters, largest: parameters.slope_of(largest) });
        }
        Ok(Self::nearest(parameters))
    }

    /// Finds the spectrum with these parameters, its slope limited to what it can have.
    fn nearest(parameters: RoughnessParameters) -> Self {
        let RoughnessParameters { rms_height_m, rolloff_m, hurst_exponent, .. } = parameters;
        let wanted = parameters.mean_square_ratio();
        let too_steep = |ln_q_ratio: f64| (mean_square_ratio(hurst_exponent, ln_q_ratio) / wanted).ln();
        let largest = parameters.largest_ln_q_ratio();
        let ln_q_ratio = if too_steep(0.0) >= 0.0 {
            0.0
        } else if too_steep(largest) <= 0.0 {
            largest
        } else {
            zero_in_bracket(0.0, largest, too_steep)
        };
        let rolloff_rad_per_m = TAU / rolloff_m;
        let of_level_1 = integral(hurst_exponent, ln_q_ratio, 0) * rolloff_rad_per_m / PI;
        SelfAffineProfile { parameters, level_m3: rms_height_m * rms_height_m / of_level_1, ln_q_ratio }
    }

    /// The roughness parameters of the spectrum.
    #[must_use]
    pub fn parameters(&self) -> RoughnessParameters {
        self.parameters
    }

    /// The longest wavelength \[m\].
    #[must_use]
    pub fn longest_m(&self) -> f64 {
        LONGEST_OVER_ROLLOFF * self.parameters.rolloff_m
    }

    /// The shortest wavelength \[m\], which follows from the slope.
    #[must_use]
    pub fn shortest_m(&self) -> f64 {
        self.parameters.rolloff_m * (-self.ln_q_ratio).exp()
    }

    /// ln C1D \[m^3\] at a wavelength \[m\], continued beyond both ends.
    fn ln_value_at(&self, wavelength_m: f64) -> f64 {
        let ln_q_ratio = (self.parameters.rolloff_m / wavelength_m).ln();
        self.level_m3.ln() - (1.0 + 2.0 * self.parameters.hurst_exponent) * ln_q_ratio.max(0.0)
    }

    /// Samples the spectrum at 20 points per decade, including the roll-off, so that its moments are those of the
    /// parameters.
    ///
    /// Standard errors come from the assumed form: H within 0.1 and the roll-off wavelength within a factor of 2, each
    /// varied at constant height and slope.
    #[must_use]
    pub fn psd(&self) -> Psd {
        let rolloff_m = self.parameters.rolloff_m;
        let decades = self.ln_q_ratio / 10f64.ln();
        // A fall shorter than rounding gets no samples.
        let falling =
            if self.ln_q_ratio > 1e-12 { (SAMPLES_PER_DECADE * decades).ceil().max(1.0) } else { 0.0 };
        let level = SAMPLES_PER_DECADE * LONGEST_OVER_ROLLOFF.log10();
        let at_level =
            (0..=level as u32).map(|at| rolloff_m * LONGEST_OVER_ROLLOFF.powf(1.0 - f64::from(at) / level));
        let at_fall =
            (1..=falling as u32).map(|at| rolloff_m * (-self.ln_q_ratio * (f64::from(at) / falling)).exp());
        let wavelengths_m: Vec<f64> = at_level.chain(at_fall).collect();
        let values_m3: Vec<f64> = wavelengths_m.iter().map(|at| self.ln_value_at(*at).exp()).collect();
        let varied = self.varied();
        let errors = wavelengths_m.iter().zip(&values_m3).map(|(wavelength_m, value_m3)| {
            let variance: f64 = varied
                .iter()
                .map(|[less, more]| {
                    0.25 * (more.ln_value_at(*wavelength_m) - less.ln_value_at(*wavelength_m)).powi(2)
                })
                .sum();
            // The standard deviation of a log-normal value about this median: v (v - 1) with v = exp(variance).
            Some(value_m3 * (variance.exp() * variance.exp_m1()).sqrt())
        });
        let errors = errors.collect();
        Psd::from_samples(wavelengths_m, values_m3, Convention::C1D).with_checked_standard_errors(errors)
    }

    /// The spectra with H and the roll-off varied by one standard uncertainty either way.
    fn varied(&self) -> [[Self; 2]; 2] {
        let hurst = |off: f64| RoughnessParameters {
            hurst_exponent: (self.parameters.hurst_exponent + off).clamp(LEAST_HURST, 1.0),
            ..self.parameters
        };
        let rolloff = |factor: f64| RoughnessParameters {
            rolloff_m: (self.parameters.rolloff_m * factor).max(SHORTEST_M),
            ..self.parameters
        };
        [
            [hurst(-HURST_UNCERTAINTY), hurst(HURST_UNCERTAINTY)],
            [rolloff(1.0 / ROLLOFF_UNCERTAINTY_FACTOR), rolloff(ROLLOFF_UNCERTAINTY_FACTOR)],
        ]
        .map(|pair| pair.map(Self::nearest))
    }
}

/// Computes the mean square slope over the mean square height in units of q_r^2; rises with `ln_q_ratio`.
fn mean_square_ratio(hurst_exponent: f64, ln_q_ratio: f64) -> f64 {
    integral(hurst_exponent, ln_q_ratio, 2) / integral(hurst_exponent, ln_q_ratio, 0)
}
