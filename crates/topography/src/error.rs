//! What can be asked of a spectrum that it does not hold.

use spectrum::PsdError;
use thiserror::Error;

/// A request no spectrum can be made from.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TransformError {
    /// A limit of the reliable band that is no finite length above 0.
    #[error("limiting the band of a scan: the {what} is {value} m, it must be finite and above 0")]
    BadLimit {
        /// Which limit.
        what: &'static str,
        /// Its value in m.
        value: f64,
    },
    /// No bin between the flagged ones and the shortest reliable wavelength.
    #[error(
        "taking the reliable part of a spectrum: none of its bins with a value above 0 lies between {shortest_m} m, the \
         shortest reliable wavelength, and {longest_m} m, the longest; take a longer scan, or a smaller tip radius or \
         limit"
    )]
    NothingReliable {
        /// Shortest reliable wavelength in m.
        shortest_m: f64,
        /// Wavelength in m of the first bin not flagged.
        longest_m: f64,
    },
    /// Heights so large that their squares overflow.
    #[error("taking the reliable part of a spectrum: {0}")]
    Overflow(#[from] PsdError),
    /// Heights so large that their variance overflows.
    #[error("transforming heights: their variance is beyond the range of numbers; check their unit")]
    BeyondNumbers,
    /// Heights without roughness.
    #[error(
        "transforming heights: the scan is flat: after detrending its rms height is {rms_m:e} m, no more than the rounding \
         of heights up to {largest_m:e} m; check the channel, and export it with more digits"
    )]
    Flat {
        /// Root mean square of the detrended heights in m.
        rms_m: f64,
        /// The largest height as read in m.
        largest_m: f64,
    },
    /// Bins too few to be a spectrum.
    #[error(
        "averaging spectra: the scans fill {bins} {} in all, a spectrum has at least 2; give more or larger scans, or more \
         bins per decade",
        if *.bins == 1 { "bin" } else { "bins" }
    )]
    TooFewBins {
        /// The bins.
        bins: usize,
    },
    /// A composite of nothing.
    #[error("averaging spectra: the number of measurements is 0, it must be at least 1")]
    NoMeasurements,
}
