//! Expectation of a composite.

use spectrum::ProfilePsd;
use topography::CompositeSpectrum;

use super::surface::KnownSurface;
use crate::TrialError;

/// Returns the composite of scans without scatter: the known spectrum at the wavelengths of the measured one.
///
/// # Errors
/// [`TrialError::RandomSurface`] at wavelengths outside of the surface's band.
pub fn known_composite(
    surface: &KnownSurface,
    measured: &CompositeSpectrum,
) -> Result<ProfilePsd, TrialError> {
    let wavelengths_m: Vec<f64> = measured.composite.bins.iter().map(|bin| bin.wavelength_m).collect();
    surface.profile(&wavelengths_m)
}
