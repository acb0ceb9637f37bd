//! The end of a band, the mode of the full length, and bounds above which spectra of scans are doubtful.

use std::fmt;

use units::display::length;
use units::{Remark, RemarkCode};

/// Ratio of the slopes along and across the lines of a map from which a surface is not isotropic.
pub(crate) const SLOPES_DIFFER: f64 = 1.5;
/// Ratio of overlapping spectra above which instruments hardly show the same surface in the same units.
pub(crate) const SPECTRA_DIFFER: f64 = 3.0;

/// Limit of the band of a scan at its short end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BandEnd {
    /// Twice the distance of neighbouring points; the tip is unknown.
    PixelsWithoutTip,
    /// Twice the distance of neighbouring points; no other limit applies.
    Pixels,
    /// The tip radius.
    Tip {
        /// Radius \[m\].
        radius_m: f64,
    },
    /// The given shortest wavelength.
    Given,
    /// The resolution that the file states.
    Resolution,
}

impl fmt::Display for BandEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BandEnd::PixelsWithoutTip => f.write_str("2 pixels; no tip radius given"),
            BandEnd::Pixels => f.write_str("2 pixels"),
            BandEnd::Tip { radius_m } => write!(f, "tip radius {}", length(*radius_m)),
            BandEnd::Given => f.write_str("shortest given"),
            BandEnd::Resolution => f.write_str("resolution of the instrument"),
        }
    }
}

/// State of the mode whose wavelength is the length of the scan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FundamentalMode {
    /// The mode is absent.
    Absent,
    /// Detrending left part of the mode.
    Kept {
        /// Remaining share of its power.
        share: f64,
        /// True if its bin is part of the reliable spectrum.
        used: bool,
    },
    /// The mode comes from the window alone.
    MadeByWindow,
}

impl FundamentalMode {
    pub(crate) fn remark(self) -> Remark {
        match self {
            FundamentalMode::Absent => Remark::new(RemarkCode::FundamentalAbsent),
            FundamentalMode::Kept { share, used } => Remark::new(RemarkCode::FundamentalKept)
                .with("share", share)
                .with("used", if used { "used" } else { "not used" }),
            FundamentalMode::MadeByWindow => Remark::new(RemarkCode::FundamentalOfWindow),
        }
    }
}

/// Returns true if spectra of this ratio hardly show the same surface in the same units.
pub(crate) fn differ(ratio: f64) -> bool {
    ratio.ln().abs() > SPECTRA_DIFFER.ln()
}
