//! What is worth knowing about spectra made from scans, as data.

use crate::direction::Direction;
use crate::direction_ratio::DirectionRatio;
use crate::noise_floor::NoiseFloor;
use crate::tip_indication::TipIndication;
use crate::tip_words::TipWords;
use serde::Serialize;
use spectrum::Hole;

/// How much it matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
pub enum Severity {
    /// A check that was passed, for the record.
    Passed,
    /// Something that was taken for granted.
    Note,
    /// A doubt about the result.
    Warning,
}

/// A deviation from Parseval's theorem beyond rounding.
const LARGE_PARSEVAL: f64 = 1e-9;
/// Relative differences of rms slopes and curvatures that are larger than what a window and the lie of the land make.
const LARGE_DERIVATIVE: f64 = 0.1;
/// The straight lines between uneven points have slopes beyond the last wavelength of the spectrum.
const LARGE_DERIVATIVE_UNEVEN: f64 = 0.5;
/// Share of the variance, and gap over the median distance, beyond which a trace of uneven points is doubtful.
const LEAST_SHARE: f64 = 0.9;
const LARGE_GAP: f64 = 10.0;
/// From this ratio on, the slopes along and across the lines of a map are not those of an isotropic surface.
pub const SLOPES_DIFFER: f64 = 1.5;
/// Instruments that differ by more than this factor where they overlap hardly show the same surface in the same units.
pub const SPECTRA_DIFFER: f64 = 3.0;

/// Something to know about the spectrum of one scan. Whoever has words has some for all of these: a match on them is whole.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum ScanRemark {
    /// What reading the file took for granted, in the reader's words.
    Reading(String),
    /// The wavelengths that are used.
    Band {
        /// The longest \[m\].
        longest_m: f64,
        /// The shortest \[m\].
        shortest_m: f64,
        /// What ends them.
        end: BandEnd,
    },
    /// Nobody tells the radius of the tip, and the instrument is not known to have none.
    TipUnknown {
        /// The wavelength \[m\] down to which the scan is used all the same: twice the distance of its points.
        shortest_m: f64,
    },
    /// What the scan itself tells of that tip.
    TipIndicated(TipIndication),
    /// People wrote down the radius of the tip.
    TipWords {
        /// What they wrote.
        words: TipWords,
        /// Whether it is used; it is only where that is asked for.
        is_used: bool,
    },
    /// The noise of the instrument, at wavelengths that are used.
    NoiseFloor(NoiseFloor),
    /// The variance of the spectrum over that of the heights.
    Variance {
        /// 1 by Parseval's theorem, of unevenly spaced points the part at the wavelengths of the spectrum.
        share: f64,
        /// Whether the theorem holds to rounding.
        evenly_spaced: bool,
    },
    /// The largest distance of neighbouring points, which a straight line bridges.
    Gap {
        /// Over the median distance.
        over_median: f64,
    },
    /// A root mean square derivative along the scan lines.
    Derivative {
        /// Which one.
        derivative: Derivative,
        /// From neighbouring points.
        real: f64,
        /// From the spectrum.
        spectral: f64,
        /// Whether the points are evenly spaced, so that the two agree more closely.
        evenly_spaced: bool,
    },
    /// Root mean square slopes of a map.
    Slopes {
        /// Along its lines.
        along: f64,
        /// Across them.
        across: f64,
    },
    /// The mode of the whole length.
    Fundamental(FundamentalMode),
}

/// What ends the band of a scan at its short end.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum BandEnd {
    /// Twice the distance of neighbouring points; the tip is unknown.
    PixelsWithoutTip,
    /// Twice the distance of neighbouring points, with nothing else that could end it sooner.
    Pixels,
    /// The tip.
    Tip {
        /// Its radius \[m\].
        radius_m: f64,
    },
    /// The shortest wavelength that was given.
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

/// What became of the mode whose wavelength is the length of the scan.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub enum FundamentalMode {
    /// It is not there.
    Absent,
    /// Detrending left a part of it.
    Kept {
        /// Share of its power that is left.
        share: f64,
        /// Whether its bin is part of the reliable spectrum.
        used: bool,
    },
    /// The window alone made it.
    MadeByWindow,
}

/// Something to know about the composite of scans. A match on them is whole, as of [`ScanRemark`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Remark {
    /// About one of its scans.
    Scan {
        /// Its name.
        name: String,
        /// What.
        remark: ScanRemark,
    },
    /// Two scans are the same data, which count once in standard errors.
    SameData {
        /// Their names.
        names: [String; 2],
    },
    /// Two scans where they overlap.
    Overlap {
        /// Their names.
        names: [String; 2],
        /// The spectrum of the first over that of the second, on average.
        ratio: f64,
        /// In how many bins.
        bins: usize,
        /// The longest wavelength they share \[m\].
        longest_m: f64,
        /// The shortest \[m\].
        shortest_m: f64,
    },
    /// The spectra of a map along both of its axes.
    Directions {
        /// The names of the two, that along x first.
        names: [String; 2],
        /// That along y over that along x, from long to short wavelengths, at least one.
        ratios: Vec<DirectionRatio>,
        /// Along which the instrument scanned, where the file says so.
        fast: Option<Direction>,
    },
    /// The mean of logarithms was freed from the bias that the logarithms of few lines and Fourier bins have.
    BiasRemoved {
        /// The largest factor that a scan was raised by in a bin.
        factor: f64,
        /// The wavelength \[m\] of that bin.
        wavelength_m: f64,
    },
    /// Wavelengths that no scan shows, from long to short, at least one.
    Holes(Vec<Hole>),
}

impl ScanRemark {
    /// How much it matters.
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
    /// How much it matters.
    #[must_use]
    pub fn severity(&self) -> Severity {
        match self {
            Remark::Scan { remark, .. } => remark.severity(),
            Remark::SameData { .. } | Remark::Holes(_) => Severity::Warning,
            Remark::Overlap { ratio, .. } if differ(*ratio) => Severity::Warning,
            Remark::Directions { ratios, .. } if ratios.iter().any(DirectionRatio::is_anisotropic) => {
                Severity::Warning
            }
            Remark::Overlap { .. } | Remark::Directions { .. } | Remark::BiasRemoved { .. } => Severity::Note,
        }
    }
}

/// Whether spectra of this ratio hardly show the same surface in the same units.
pub(crate) fn differ(ratio: f64) -> bool {
    ratio.ln().abs() > SPECTRA_DIFFER.ln()
}
