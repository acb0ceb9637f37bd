//! Remarks on spectra made from scans, as data.

use crate::direction::Direction;
use crate::noise_floor::NoiseFloor;
use crate::overlap::DirectionRatio;
use crate::tip_indication::TipIndication;
use crate::tip_words::TipWords;
use serde::Serialize;
use spectrum::Hole;

/// Severity of a remark.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
pub enum Severity {
    /// A passed check, for the record.
    Passed,
    /// An assumption.
    Note,
    /// A doubt about the result.
    Warning,
}

/// Deviation from Parseval's theorem that exceeds rounding.
const LARGE_PARSEVAL: f64 = 1e-9;
/// Largest relative difference of rms slopes and curvatures that a window and nonuniform roughness explain.
const LARGE_DERIVATIVE: f64 = 0.1;
/// Largest such difference for uneven points, whose straight lines have slopes beyond the last wavelength.
const LARGE_DERIVATIVE_UNEVEN: f64 = 0.5;
/// Share of the variance below which a trace of uneven points is doubtful.
const LEAST_SHARE: f64 = 0.9;
/// Largest over median distance of neighbouring points above which a trace is doubtful.
const LARGE_GAP: f64 = 10.0;
/// Ratio of the slopes along and across the lines of a map from which a surface is not isotropic.
pub const SLOPES_DIFFER: f64 = 1.5;
/// Ratio of overlapping spectra above which instruments hardly show the same surface in the same units.
pub const SPECTRA_DIFFER: f64 = 3.0;

/// A remark on the spectrum of one scan. Deliberately not `#[non_exhaustive]`: every front end must word every variant.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum ScanRemark {
    /// An assumption of the reader of the file, in its words.
    Reading(String),
    /// The band of wavelengths in use.
    Band {
        /// Longest wavelength \[m\].
        longest_m: f64,
        /// Shortest wavelength \[m\].
        shortest_m: f64,
        /// Limit at the short end.
        end: BandEnd,
    },
    /// The tip radius is unknown, and the instrument may have a tip.
    TipUnknown {
        /// Shortest wavelength in use \[m\]: twice the distance of the points.
        shortest_m: f64,
    },
    /// Indication of the tip radius by the scan itself.
    TipIndicated(TipIndication),
    /// A tip radius in the free text of the file.
    TipWords {
        /// The radius with its words.
        words: TipWords,
        /// True if the radius is used, which `tip_radius_auto` requests.
        is_used: bool,
    },
    /// The noise floor of the instrument at wavelengths in use.
    NoiseFloor(NoiseFloor),
    /// Ratio of the variance of the spectrum to that of the heights.
    Variance {
        /// 1 by Parseval's theorem; for unevenly spaced points the share at the wavelengths of the spectrum.
        share: f64,
        /// True if the points are evenly spaced and the theorem holds to rounding.
        evenly_spaced: bool,
    },
    /// The largest distance of neighbouring uneven points, bridged by a straight line.
    Gap {
        /// Ratio to the median distance.
        over_median: f64,
    },
    /// A root mean square derivative along the scan lines.
    Derivative {
        /// Order of the derivative.
        derivative: Derivative,
        /// Value from neighbouring points.
        real: f64,
        /// Value from the spectrum.
        spectral: f64,
        /// True if the points are evenly spaced, so that the two agree more closely.
        evenly_spaced: bool,
    },
    /// Root mean square slopes of a map.
    Slopes {
        /// Slope along the lines.
        along: f64,
        /// Slope across the lines.
        across: f64,
    },
    /// The mode whose wavelength is the length of the scan.
    Fundamental(FundamentalMode),
}

/// Limit of the band of a scan at its short end.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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

/// A derivative of heights along the scan lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub enum Derivative {
    /// The slope.
    Slope,
    /// The curvature \[1/m\].
    CurvaturePerM,
}

/// State of the mode whose wavelength is the length of the scan.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
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

/// A remark on the composite of scans. Deliberately not `#[non_exhaustive]`, like [`ScanRemark`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Remark {
    /// A remark on one of its scans, or on several of which the same holds.
    Scan {
        /// Names of the scans, at least one.
        names: Vec<String>,
        /// The remark.
        remark: ScanRemark,
    },
    /// Scans hold the same data, which count once in standard errors.
    SameData {
        /// Their names, at least two.
        names: Vec<String>,
    },
    /// Comparison of two scans where they overlap.
    Overlap {
        /// Their names.
        names: [String; 2],
        /// Mean ratio of the first to the second spectrum.
        ratio: f64,
        /// Number of shared bins.
        bins: usize,
        /// Longest shared wavelength \[m\].
        longest_m: f64,
        /// Shortest shared wavelength \[m\].
        shortest_m: f64,
    },
    /// The pairs of scans that differ less than those in remarks of their own.
    OtherOverlaps {
        /// Number of pairs.
        pairs: usize,
        /// Lowest and highest mean ratio of the first to the second spectrum.
        ratios: [f64; 2],
    },
    /// Comparison of the spectra of a map along both axes.
    Directions {
        /// Names of the two spectra, along x first.
        names: [String; 2],
        /// Ratios of y to x, from long to short wavelengths, at least one.
        ratios: Vec<DirectionRatio>,
        /// Fast axis of the instrument, if the file states it.
        fast: Option<Direction>,
    },
    /// The mean of logarithms was freed from the bias of few degrees of freedom.
    BiasRemoved {
        /// Largest factor applied to a scan in a bin.
        factor: f64,
        /// Wavelength of that bin \[m\].
        wavelength_m: f64,
    },
    /// Holes in the composite spectrum, from long to short wavelengths, at least one.
    Holes(Vec<Hole>),
}

impl ScanRemark {
    /// Returns the severity of the remark.
    #[must_use]
    pub fn severity(&self) -> Severity {
        // A comparison with NaN is false and must not pass a check.
        let passed = match *self {
            ScanRemark::Reading(_) | ScanRemark::TipIndicated(_) | ScanRemark::TipWords { .. } => {
                return Severity::Note;
            }
            ScanRemark::Band { .. } | ScanRemark::Fundamental(_) => true,
            ScanRemark::TipUnknown { .. } | ScanRemark::NoiseFloor(_) => false,
            ScanRemark::Variance { share, evenly_spaced: true } => (share - 1.0).abs() <= LARGE_PARSEVAL,
            ScanRemark::Variance { share, evenly_spaced: false } => share >= LEAST_SHARE,
            ScanRemark::Gap { over_median } => over_median <= LARGE_GAP,
            ScanRemark::Derivative { real, spectral, evenly_spaced, .. } => {
                let most = if evenly_spaced { LARGE_DERIVATIVE } else { LARGE_DERIVATIVE_UNEVEN };
                real == spectral || (spectral / real - 1.0).abs() <= most
            }
            ScanRemark::Slopes { along, across } => {
                along == across || (along / across).ln().abs() < SLOPES_DIFFER.ln()
            }
        };
        if passed { Severity::Passed } else { Severity::Warning }
    }
}

impl Remark {
    /// Returns the severity of the remark.
    #[must_use]
    pub fn severity(&self) -> Severity {
        match self {
            Remark::Scan { remark, .. } => remark.severity(),
            Remark::SameData { .. } | Remark::Holes(_) => Severity::Warning,
            Remark::Overlap { ratio, .. } if differ(*ratio) => Severity::Warning,
            Remark::OtherOverlaps { ratios, .. } if ratios.iter().any(|ratio| differ(*ratio)) => {
                Severity::Warning
            }
            Remark::Directions { ratios, .. } if ratios.iter().any(DirectionRatio::is_anisotropic) => {
                Severity::Warning
            }
            Remark::Overlap { .. }
            | Remark::OtherOverlaps { .. }
            | Remark::Directions { .. }
            | Remark::BiasRemoved { .. } => Severity::Note,
        }
    }
}

/// Returns true if spectra of this ratio hardly show the same surface in the same units.
pub(crate) fn differ(ratio: f64) -> bool {
    ratio.ln().abs() > SPECTRA_DIFFER.ln()
}
