//! Expectation of a composite.

use spectrum::ProfilePsd;
use topography::{BinMean, CompositeOptions, CompositeSpectrum, composite};

use super::surface::KnownSurface;
use crate::TrialError;

/// Returns the composite of scans without scatter: the known spectrum at the wavelengths of each scan, averaged in
/// the same bins.
///
/// # Errors
/// [`TrialError::RandomSurface`] at wavelengths outside of the surface's band.
pub fn known_composite(
    surface: &KnownSurface,
    measured: &CompositeSpectrum,
) -> Result<ProfilePsd, TrialError> {
    let known: Result<Vec<ProfilePsd>, TrialError> =
        measured.scans.iter().map(|scan| surface.profile(scan.reliable.wavelengths_m())).collect();
    let options = CompositeOptions {
        bins_per_decade: measured.recipe.bins_per_decade,
        inside: BinMean::Arithmetic,
        across: BinMean::Geometric,
    };
    Ok(composite(&known?, &options)?.profile())
}
