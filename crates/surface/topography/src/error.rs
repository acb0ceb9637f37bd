//! What can be asked of a spectrum that it does not hold.

use scans::{Axis, ScanError};
use spectrum::PsdError;
use thiserror::Error;
use units::display::length;

/// A request no spectrum can be made from.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum TransformError {
    /// A limit of the reliable band that is no finite length above 0.
    #[error("limiting the band of a scan: the {what} is {}, it must be finite and above 0", length(*.value))]
    BadLimit {
        /// Which limit.
        what: &'static str,
        /// Its value in m.
        value: f64,
    },
    /// No bin between the flagged ones and the shortest reliable wavelength.
    #[error(
        "taking the reliable part of a spectrum: none of its bins with a value above 0 lies between {}, the \
         shortest reliable wavelength, and {}, the longest; take a longer scan, or a smaller tip radius or \
         limit",
        length(*.shortest_m), length(*.longest_m)
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
    /// A composite of one bin, which is no spectrum yet.
    #[error(
        "averaging spectra: all samples lie in one bin about {}, there must be at least 2; take more bins per \
         decade, or a longer scan, or a smaller tip radius or limit",
        length(*.centre_m)
    )]
    SingleBin {
        /// Wavelength in m of the centre of the bin.
        centre_m: f64,
    },
    /// A scan with gaps where none are wanted.
    #[error(transparent)]
    Gaps(#[from] ScanError),
    /// More gaps than can be filled.
    #[error(
        "filling gaps: {:.1} % of the points have no height, at most {:.0} % are filled; crop the scan to a part with fewer \
         gaps, use only its lines without gaps (gaps = \"lines\"), or measure with an instrument that loses fewer points",
        100.0 * share, 100.0 * bound
    )]
    TooManyGaps {
        /// Share of the points that have no height.
        share: f64,
        /// The largest share that is filled.
        bound: f64,
    },
    /// No height at all.
    #[error(
        "filling gaps: none of the {points} points has a height; check the channel, or export the scan again"
    )]
    NoHeights {
        /// Number of points.
        points: usize,
    },
    /// No line, or stretch of one, without gaps.
    #[error(
        "cutting lines without gaps: along {} no stretch without a gap has {least} points or more; crop the scan to a part \
         with fewer gaps, or measure with an instrument that loses fewer points",
        match axis { Axis::X => "x", Axis::Y => "y" }
    )]
    NoLines {
        /// Fewest points that a stretch must have.
        least: usize,
        /// The axis along which they would run.
        axis: Axis,
    },
    /// An area is asked for where gaps left lines.
    #[error(
        "taking the heights of an area: only lines without gaps take part, which are no map; have the gaps filled \
         (gaps = \"harmonic\")"
    )]
    LinesHaveNoArea,
    /// A composite of nothing.
    #[error("averaging spectra: the number of measurements is 0, it must be at least 1")]
    NoMeasurements,
}
