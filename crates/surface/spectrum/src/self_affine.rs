//! A self-affine spectrum with its roll-off, as fitted.

use serde::Serialize;
use thiserror::Error;
use units::display::counted;

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
