//! Errors of making spectra from heights.

use scans::{ScanAxis, ScanError};
use spectrum::PsdError;
use thiserror::Error;
use units::display::length;

/// Errors of making a spectrum from heights.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TransformError {
    /// A limit of the reliable band that is not finite and above 0.
    #[error("the {what} of a scan is {}; it must be finite and above 0", length(*.value))]
    BadLimit {
        /// Name of the limit.
        what: &'static str,
        /// Value \[m\].
        value: f64,
    },
    /// No bin lies in the reliable band.
    #[error(
        "no wave of the scan is reliable: the shortest that it resolves is {}, the longest that fits into it {}; use a longer \
         scan with more points, or a smaller tip radius or limit",
        length(*.shortest_m), length(*.longest_m)
    )]
    NothingReliable {
        /// Shortest reliable wavelength in m.
        shortest_m: f64,
        /// Wavelength in m of the first bin not flagged.
        longest_m: f64,
    },
    /// Heights so large that their squares overflow.
    #[error("cutting a spectrum to its reliable band: {0}")]
    Overflow(#[from] PsdError),
    /// Heights so large that their variance overflows.
    #[error("the variance of the heights exceeds the range of numbers; check their unit")]
    BeyondNumbers,
    /// Heights without roughness.
    #[error(
        "the scan is flat: after detrending its rms height is {}, within the rounding of heights up to {}; check the channel, or \
         export it with more digits",
        length(*.rms_m), length(*.largest_m)
    )]
    Flat {
        /// Root mean square of the detrended heights in m.
        rms_m: f64,
        /// The largest height as read in m.
        largest_m: f64,
    },
    /// A composite of a single bin.
    #[error(
        "averaging spectra: all samples lie in one bin near {}; use more bins per decade, a longer scan, or a smaller tip \
         radius or limit",
        length(*.centre_m)
    )]
    SingleBin {
        /// Wavelength in m of the centre of the bin.
        centre_m: f64,
    },
    /// Missing points are refused.
    #[error(transparent)]
    Gaps(#[from] ScanError),
    /// More missing points than can be filled.
    #[error(
        "{:.1} % of the points have no height, and at most {:.0} % can be filled; crop the scan, use only lines without \
         missing points (gaps = \"lines\"), press a map with them (bem, gaps = \"keep\"), or measure with an instrument that loses fewer points",
        100.0 * share, 100.0 * bound
    )]
    TooManyGaps {
        /// Share of missing points.
        share: f64,
        /// Largest share that is filled.
        bound: f64,
    },
    /// No point has a height.
    #[error("none of the {points} points has a height; check the channel, or export the scan again")]
    NoHeights {
        /// Number of points.
        points: usize,
    },
    /// No line, or stretch of one, without missing points.
    #[error(
        "no line along {} has {least} neighbouring points with heights; crop the scan to a part with fewer missing points, or \
         measure with an instrument that loses fewer points",
        match axis { ScanAxis::X => "x", ScanAxis::Y => "y" }
    )]
    NoLines {
        /// Smallest number of points of a stretch.
        least: usize,
        /// Axis of the lines.
        axis: ScanAxis,
    },
    /// An area is needed, but missing points left only lines.
    #[error(
        "an area is needed, but only lines without missing points are used; fill the missing points (gaps = \"harmonic\")"
    )]
    LinesHaveNoArea,
    /// A composite without measurements.
    #[error("averaging spectra: 0 measurements; give at least 1")]
    NoMeasurements,
}
