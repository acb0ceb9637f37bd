//! The self-affine spectrum that has given roughness parameters of a profile.
//!
//! Engineers' drawings and profilometers give a surface by a few numbers of ISO 21920-2 (formerly ISO 4287): Rq, the rms height, Rdq,
//! the rms slope, both of a profile, and RSm, the mean width of profile elements. They fix a spectrum only with a form assumed:
//! here C1D is level down to the roll-off wavelength and falls as q^-(1 + 2 H) from there to the shortest (Persson, Albohr,
//! Tartaglino, Volokitin & Tosatti 2005, J. Phys.: Condens. Matter 17:R1, section 2). The level gives Rq and the shortest
//! wavelength Rdq, both exactly.
//!
//! Of an isotropic surface these are those of any of its profiles: Sq of ISO 25178-2 is Rq, and Sdq is sqrt(2) Rdq.
//!
//! **RSm is taken for the roll-off wavelength.** Every crossing of the mean line counted, RSm of a Gaussian profile were
//! 2 pi Rq/Rdq, whatever its spectrum (Rice 1944), and would tell nothing new beside both. But the standard counts an element only
//! where it rises and falls by a tenth of Rz, which leaves the waves near the roll-off: of simulated Gaussian profiles with H from
//! 0.6 to 0.95 and one to three decades below the roll-off it was 0.8 to 1.3 of the roll-off wavelength, at H = 0.8 1.05 to 1.2 of it.

use std::f64::consts::{PI, TAU};

use numerics::zero_in_bracket;
use serde::Serialize;
use thiserror::Error;
use units::display::{length, three_digits};
use units::{Bound, OutOfBounds};

use crate::convention::Convention;
use crate::power_law::PowerLaw;
use crate::psd::Psd;

/// Roughness parameters of a profile, and the form of its spectrum.
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

/// The spectrum of a profile: level from ten times the roll-off wavelength to it, then a power law.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SelfAffineProfile {
    parameters: RoughnessParameters,
    /// C1D of the level \[m^3\].
    level_m3: f64,
    /// ln(q_s/q_r) of the shortest wavelength.
    ln_q_ratio: f64,
}

/// Parameters that no such spectrum has.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RoughnessError {
    /// A number beyond its bound.
    #[error(transparent)]
    OutOfBounds(#[from] OutOfBounds),
    /// Heights that waves of the roll-off wavelength and above already make steeper.
    #[error(
        "an rms slope of {} is too small for an rms height of {} with a roll-off wavelength of {}: the waves from there on alone \
         have a slope of {}; give a longer roll-off wavelength or mean width, or a larger slope (a number: 0.1 is 5.7 degrees)",
        three_digits(parameters.rms_slope),
        length(parameters.rms_height_m),
        length(parameters.rolloff_m),
        three_digits(*least)
    )]
    SlopeTooSmall {
        /// What was asked for.
        parameters: RoughnessParameters,
        /// The smallest slope that such a spectrum has.
        least: f64,
    },
    /// A slope that waves down to the distance of atoms do not make.
    #[error(
        "an rms slope of {} is too large for an rms height of {} with a roll-off wavelength of {} and a Hurst exponent of {}: \
         with waves down to {} the slope is {}; give a shorter roll-off wavelength or mean width, a smaller Hurst exponent, or a \
         smaller slope (a number: 0.1 is 5.7 degrees)",
        three_digits(parameters.rms_slope),
        length(parameters.rms_height_m),
        length(parameters.rolloff_m),
        three_digits(parameters.hurst_exponent),
        length(SHORTEST_M),
        three_digits(*largest)
    )]
    SlopeTooLarge {
        /// What was asked for.
        parameters: RoughnessParameters,
        /// The largest slope that such a spectrum has.
        largest: f64,
    },
}

/// The longest wavelength over that of the roll-off: profiles are evaluated over some ten of their widest features.
pub const LONGEST_OVER_ROLLOFF: f64 = 10.0;

/// No spectrum goes on below this \[m\]: atoms are farther apart.
const SHORTEST_M: f64 = 1e-10;

const SAMPLES_PER_DECADE: f64 = 20.0;

/// One standard uncertainty of the Hurst exponent and of the logarithm of the roll-off wavelength, which no drawing tells: measured
/// surfaces have H from 0.7 to 0.9 mostly, and a roll-off that is read off RSm or off a drawing is known to a factor of 2.
pub const HURST_UNCERTAINTY: f64 = 0.1;
/// See [`HURST_UNCERTAINTY`].
pub const ROLLOFF_UNCERTAINTY_FACTOR: f64 = 2.0;

/// The least Hurst exponent that a variation goes down to.
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

    /// The square of the slope over that of heights 1/q_r, which q_s/q_r has to give.
    fn mean_square_ratio(&self) -> f64 {
        (self.rms_slope * self.rolloff_m / (TAU * self.rms_height_m)).powi(2)
    }

    fn slope_of(&self, mean_square_ratio: f64) -> f64 {
        mean_square_ratio.sqrt() * TAU * self.rms_height_m / self.rolloff_m
    }

    /// ln(q_s/q_r) where the spectrum would go on to [`SHORTEST_M`].
    fn largest_ln_q_ratio(&self) -> f64 {
        (self.rolloff_m / SHORTEST_M).ln()
    }
}

/// Int x^k C dx of the spectrum with level 1 over x = q/q_r.
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
    /// The spectrum with these parameters.
    ///
    /// # Errors
    /// [`RoughnessError`] for parameters out of bounds, and for a slope that no such spectrum has beside the other parameters.
    pub fn new(parameters: RoughnessParameters) -> Result<Self, RoughnessError> {
        parameters.check()?;
        let wanted = parameters.mean_square_ratio();
        let [least, largest] = [0.0, parameters.largest_ln_q_ratio()]
            .map(|ln_q_ratio| mean_square_ratio(parameters.hurst_exponent, ln_q_ratio));
        // The spectrum that ends at its roll-off is admitted in spite of rounding.
        if wanted < least * (1.0 - 1e-12) {
            return Err(RoughnessError::SlopeTooSmall { parameters, least: parameters.slope_of(least) });
        }
        if wanted > largest {
            return Err(RoughnessError::SlopeTooLarge { parameters, largest: parameters.slope_of(largest) });
        }
        Ok(Self::nearest(parameters))
    }

    /// The spectrum with these parameters, or with as much of the slope as it can have.
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

    /// What it was made from.
    #[must_use]
    pub fn parameters(&self) -> RoughnessParameters {
        self.parameters
    }

    /// The longest wavelength \[m\].
    #[must_use]
    pub fn longest_m(&self) -> f64 {
        LONGEST_OVER_ROLLOFF * self.parameters.rolloff_m
    }

    /// The shortest wavelength \[m\], with which the slope is that of the parameters.
    #[must_use]
    pub fn shortest_m(&self) -> f64 {
        self.parameters.rolloff_m * (-self.ln_q_ratio).exp()
    }

    /// ln C1D \[m^3\] at a wavelength \[m\], continued beyond both ends.
    fn ln_value_at(&self, wavelength_m: f64) -> f64 {
        let ln_q_ratio = (self.parameters.rolloff_m / wavelength_m).ln();
        self.level_m3.ln() - (1.0 + 2.0 * self.parameters.hurst_exponent) * ln_q_ratio.max(0.0)
    }

    /// The spectrum at 20 samples per decade, the roll-off among them, so that its moments are those of the parameters, with
    /// standard errors of what was assumed: H to 0.1 and the roll-off wavelength to a factor of 2, each varied with height and slope
    /// kept.
    #[must_use]
    pub fn psd(&self) -> Psd {
        let rolloff_m = self.parameters.rolloff_m;
        let decades = self.ln_q_ratio / 10f64.ln();
        // A fall of less than rounding has no samples of its own.
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

    /// What was assumed, varied by one standard uncertainty either way.
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

/// The mean square slope over the mean square height, in units of q_r^2; rises with the ratio.
fn mean_square_ratio(hurst_exponent: f64, ln_q_ratio: f64) -> f64 {
    integral(hurst_exponent, ln_q_ratio, 2) / integral(hurst_exponent, ln_q_ratio, 0)
}
