//! The self-affine spectrum with a roll-off, fitted to samples.

use std::ops::RangeBounds;

use serde::Serialize;
use thiserror::Error;
use units::display::counted;

use crate::profile::ProfilePsd;

/// A self-affine spectrum fitted with equal weights to ln C1D: with a roll-off
/// ln C1D = ln C_0 - (H + 1/2) ln(1 + (q/q_r)^2), without one ln C1D = const - (2 H + 1) ln q.
///
/// Standard errors follow from s^2 (J^T J)^-1 to first order; they are absent if there are as many parameters as
/// samples.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SelfAffineFit {
    /// Hurst exponent H; 0 to 1 for a self-affine surface, but reported as fitted.
    pub hurst_exponent: f64,
    /// Standard error of the Hurst exponent.
    pub hurst_exponent_se: Option<f64>,
    /// The roll-off, if the samples show one.
    pub rolloff: Option<RollOff>,
    /// Root mean square deviation of log10 C1D from the fit.
    pub rms_log10_residual: f64,
    /// Number of samples fitted.
    pub points: usize,
}

/// The roll-off of a self-affine spectrum, where it levels off towards long wavelengths.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RollOff {
    /// Roll-off wavelength lambda_r = 2 pi/q_r in m, inside the fitted band.
    pub wavelength_m: f64,
    /// Standard error of the wavelength in m.
    pub wavelength_se_m: Option<f64>,
    /// The plateau C_0 of C1D in m^3.
    pub plateau_m3: f64,
    /// Standard error of the plateau in m^3.
    pub plateau_se_m3: Option<f64>,
}

/// Errors of fitting a self-affine spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum FitError {
    /// Fewer than two samples in the band.
    #[error(
        "fitting a self-affine spectrum: {}; widen the band to hold at least 2", counted(*.points, "sample")
    )]
    TooFewSamples {
        /// Number of samples in the band.
        points: usize,
    },
    /// The feature `fit` is off.
    #[error(
        "fitting a self-affine spectrum: this build has no fit; compile it with the feature `fit` of truearea-spectrum"
    )]
    NotBuilt,
}

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
