//! The self-affine spectrum with a roll-off, fitted to samples.

use std::ops::RangeBounds;

use crate::profile::ProfilePsd;
use crate::self_affine::{FitError, SelfAffineFit};

/// Fits a self-affine spectrum to the samples whose wavelength in m lies in `band`; `..` takes them all.
///
/// A roll-off is reported only if it is identifiable: three samples or more, q_r inside the sampled band, a regular
/// normal matrix, and a Bayesian information criterion more than 6 below that of the pure power law: n ln(RSS_2/RSS_3)
/// above ln n + 6 (strong evidence after Kass & Raftery, 1995). Sums of squares below those of deviations of 1e-12 count
/// as rounding, so exact power laws have no roll-off. Otherwise the pure power law is returned.
///
/// # Errors
/// [`FitError::TooFewSamples`] with fewer than two samples in the band, and [`FitError::NotBuilt`] without the feature `fit`.
pub fn fit_self_affine(psd: &ProfilePsd, band: impl RangeBounds<f64>) -> Result<SelfAffineFit, FitError> {
    #[cfg(feature = "fit")]
    return crate::least_squares::fit(psd, band);
    #[cfg(not(feature = "fit"))]
    {
        let _ = (psd, band);
        Err(FitError::NotBuilt)
    }
}
