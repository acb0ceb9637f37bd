//! Surface whose spectrum is known.

use gaussian_surfaces::{AreaSpectrum, SelfAffine, Size};
use spectrum::ProfilePsd;

use crate::error::StudyError;

/// Longest wavelength of all surfaces \[m\].
pub const LONGEST_M: f64 = 400e-6;

/// Roll-off wavelength of all surfaces \[m\].
pub const ROLLOFF_M: f64 = 40e-6;

/// Rms gradient of all surfaces.
pub const RMS_GRADIENT: f64 = 0.05;

/// Self-affine surface with a roll-off.
#[derive(Debug, Clone)]
pub struct KnownSurface {
    /// Hurst exponent.
    pub hurst_exponent: f64,
    pub(crate) area: AreaSpectrum,
}

impl KnownSurface {
    /// Creates the surface of a Hurst exponent, down to a shortest wavelength \[m\].
    ///
    /// # Errors
    /// [`StudyError::Surface`] for an exponent or a wavelength out of range.
    pub fn new(hurst_exponent: f64, shortest_m: f64) -> Result<Self, StudyError> {
        let area = AreaSpectrum::self_affine(&SelfAffine {
            hurst_exponent,
            longest_m: LONGEST_M,
            rolloff_m: ROLLOFF_M,
            shortest_m,
            size: Size::RmsGradient(RMS_GRADIENT),
        })?;
        Ok(KnownSurface { hurst_exponent, area })
    }

    /// Returns the spectrum of its profiles at wavelengths \[m\] from long to short.
    ///
    /// # Errors
    /// [`StudyError::Surface`] at wavelengths outside of the surface's band.
    pub fn profile(&self, wavelengths_m: &[f64]) -> Result<ProfilePsd, StudyError> {
        Ok(self.area.profile(wavelengths_m)?)
    }
}
