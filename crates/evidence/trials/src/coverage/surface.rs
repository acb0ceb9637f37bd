//! Surface whose spectrum is known.

use std::f64::consts::TAU;

use spectrum::random_surfaces::{AreaSpectrum, SelfAffine, Size};
use spectrum::{Convention, ProfilePsd, Psd};
use statrs::distribution::{ContinuousCDF, Normal};

use super::random::Normals;
use crate::TrialError;

/// Longest wavelength of all surfaces \[m\].
pub const LONGEST_M: f64 = 400e-6;

/// Roll-off wavelength of all surfaces \[m\].
pub const ROLLOFF_M: f64 = 40e-6;

/// Rms gradient of all surfaces.
pub const RMS_GRADIENT: f64 = 0.05;

/// Form of a spectrum that is drawn at random.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Self-affine, with a roll-off at 10 to 100 µm, inside the scans of a stylus.
    RolloffInside,
    /// Self-affine, with a roll-off at 2 to 10 mm, beyond every scan.
    RolloffOutside,
    /// Roll-off inside, and a hump of 3 to 10 times the spectrum somewhere between 0.5 and 100 µm.
    Hump,
}

units::named!(Form, "form", {
    RolloffInside => "roll-off inside",
    RolloffOutside => "roll-off outside",
    Hump => "hump",
});

/// Surface of a known spectrum.
#[derive(Debug, Clone)]
pub struct KnownSurface {
    pub(crate) longest_m: f64,
    pub(crate) area: AreaSpectrum,
}

impl KnownSurface {
    /// Creates the surface of a Hurst exponent, down to a shortest wavelength \[m\].
    ///
    /// # Errors
    /// [`TrialError::RandomSurface`] for an exponent or a wavelength out of range.
    pub fn new(hurst_exponent: f64, shortest_m: f64) -> Result<Self, TrialError> {
        let area = AreaSpectrum::self_affine(&SelfAffine {
            hurst_exponent,
            longest_m: LONGEST_M,
            rolloff_m: ROLLOFF_M,
            shortest_m,
            size: Size::RmsGradient(RMS_GRADIENT),
        })?;
        Ok(KnownSurface { longest_m: LONGEST_M, area })
    }

    /// Draws a surface of a form: Hurst exponents from 0.2 to 0.95, rms gradients from 0.02 to 0.2, both evenly (the
    /// gradients in their logarithm).
    ///
    /// # Errors
    /// [`TrialError::RandomSurface`] for a shortest wavelength out of range.
    pub(crate) fn at_random(form: Form, normals: &mut Normals, shortest_m: f64) -> Result<Self, TrialError> {
        let mut between = |low: f64, high: f64| low + (high - low) * Normal::standard().cdf(normals.next());
        let mut log_between = |low: f64, high: f64| between(low.ln(), high.ln()).exp();
        let rolloff_m = match form {
            Form::RolloffOutside => log_between(2e-3, 10e-3),
            Form::RolloffInside | Form::Hump => log_between(10e-6, 100e-6),
        };
        let rms_gradient = log_between(0.02, 0.2);
        let (hump_m, hump_height) = (log_between(0.5e-6, 100e-6), log_between(3.0, 10.0));
        let hump_height = if form == Form::Hump { hump_height } else { 0.0 };
        let hump_width = between(0.3, 0.6);
        let hurst_exponent = between(0.2, 0.95);
        let longest_m = 4.0 * rolloff_m;
        let steps = (30.0 * (longest_m / shortest_m).log10()).ceil() as u32;
        let wavelengths_m: Vec<f64> = (0..=steps)
            .map(|step| longest_m * (shortest_m / longest_m).powf(f64::from(step) / f64::from(steps)))
            .collect();
        let ciso_m4 = |wavelength_m: &f64| {
            let q = TAU / wavelength_m;
            let smooth = (1.0 + (q * rolloff_m / TAU).powi(2)).powf(-1.0 - hurst_exponent);
            let off_hump = (wavelength_m / hump_m).ln() / hump_width;
            smooth * (1.0 + hump_height * (-0.5 * off_hump * off_hump).exp())
        };
        let values: Vec<f64> = wavelengths_m.iter().map(ciso_m4).collect();
        let of_values = |values: Vec<f64>| -> Result<AreaSpectrum, TrialError> {
            Ok(AreaSpectrum::from_psd(&Psd::new(wavelengths_m.clone(), values, Convention::Ciso)?)?)
        };
        let factor = rms_gradient.powi(2) / of_values(values.clone())?.mean_square_gradient();
        let area = of_values(values.into_iter().map(|value| factor * value).collect())?;
        Ok(KnownSurface { longest_m, area })
    }

    /// Returns the spectrum of its profiles at wavelengths \[m\] from long to short.
    ///
    /// # Errors
    /// [`TrialError::RandomSurface`] at wavelengths outside of the surface's band.
    pub fn profile(&self, wavelengths_m: &[f64]) -> Result<ProfilePsd, TrialError> {
        Ok(self.area.profile(wavelengths_m)?)
    }
}
