//! Errors on the way from scan files to a spectrum.

use std::{fmt, io};

use roughness::ScaleLimitedSurfaceError;
use scans::{Mend, ScanReadError};
use topography::{Direction, TransformError};
use units::number;

/// Error of the scans of a file, or of all scans together.
#[derive(Debug)]
pub struct TopographyError {
    /// The file at fault, as typed; `None` if all scans together are.
    pub file: Option<String>,
    /// Index of the request at fault.
    pub request: Option<usize>,
    /// The problem.
    pub problem: ScanProblem,
}

/// Problems with scans.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScanProblem {
    /// The file cannot be opened or read.
    #[error("{0}")]
    Reading(io::Error),
    /// A metadata file is not UTF-8 text.
    #[error("line {line}: not UTF-8 text; save the metadata as UTF-8")]
    NotText {
        /// The first line that is not text.
        line: usize,
    },
    /// The file holds a spectrum, which needs no transform.
    #[error("this file holds a power spectrum, not heights")]
    HoldsASpectrum,
    /// No file in the folder is a scan.
    #[error("no file in this folder is a scan; name a scan")]
    NoScanInFolder,
    /// The file is a scene.
    #[error("this is a scene, not heights")]
    IsAScene,
    /// A tip radius is given for a map of a microscope.
    #[error("an optical map has no tip; give its shortest wavelength instead")]
    NoTip,
    /// The file cannot be read as heights.
    #[error(transparent)]
    Format(Box<ScanReadError>),
    /// The heights cannot be transformed.
    #[error("{}{error}", scan.as_ref().map_or(String::new(), |scan| format!("{scan}: ")))]
    Transform {
        /// Name of the scan if it differs from its file.
        scan: Option<String>,
        /// The error of the transform.
        error: TransformError,
    },
    /// The heights cannot be evaluated.
    #[error(transparent)]
    Relief(ScaleLimitedSurfaceError),
    /// The text is neither heights nor a spectrum.
    #[error("as a scan: {as_scan}{}", as_spectrum.as_ref().map_or(String::new(), |why| format!("; as a spectrum: {why}")))]
    NeitherKind {
        /// Error of reading it as a scan.
        as_scan: Box<ScanReadError>,
        /// Error of reading it as a spectrum.
        as_spectrum: Option<String>,
    },
    /// Scans of one instrument give different calibrations.
    #[error(
        "the {what} of {instrument} is {} here but {} for {other}; give all scans of an instrument the same",
        number(*here),
        number(*there)
    )]
    InstrumentDisagrees {
        /// The name of the instrument.
        instrument: String,
        /// The option.
        what: &'static str,
        /// Value of this scan.
        here: f64,
        /// Value of an earlier scan.
        there: f64,
        /// File of the earlier scan.
        other: String,
    },
    /// Boundary elements are given no scan or several.
    #[error("the file holds {0} scans, and boundary elements press one map; choose it by its channel")]
    NotOneSurface(usize),
    /// An option of the file that nothing depends on here.
    #[error("option {0} has no effect here; leave it out")]
    UnusedOption(&'static str),
    /// Boundary elements are given a line scan.
    #[error(
        "boundary elements press a line only if it repeats itself: choose the boundary periodic, or give its spectrum"
    )]
    LineIsNoSurface,
    /// A line and a map face each other.
    #[error(
        "this profile has no heights to add to those of the map {map}; give two maps, or press the sum of their spectra"
    )]
    LineFacesMap {
        /// The file of the map.
        map: String,
    },
    /// An areal spectrum was requested of no scan or of several.
    #[error("the file holds {0} scans, and an areal spectrum needs one map; choose it by its channel")]
    NotOneMap(usize),
    /// An areal spectrum was requested of a line.
    #[error("a line scan has no areal spectrum; give a map")]
    LineHasNoArea,
    /// An areal spectrum was requested along an axis.
    #[error("an areal spectrum averages over all directions of a map; leave out direction = \"{0}\"")]
    AreaHasNoDirection(Direction),
}

impl fmt::Display for TopographyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.file, &self.problem) {
            (Some(file), ScanProblem::Reading(error)) => write!(f, "reading {file}: {error}"),
            (Some(file), problem) => write!(f, "{file}: {problem}"),
            (None, problem) => problem.fmt(f),
        }
    }
}

impl std::error::Error for TopographyError {}

impl TopographyError {
    /// The scan option that fixes the error, if there is one; front ends name it in their own terms.
    #[must_use]
    pub fn mend(&self) -> Option<Mend> {
        match &self.problem {
            ScanProblem::Format(error) => error.mend(),
            ScanProblem::NeitherKind { as_scan, .. } => as_scan.mend(),
            _ => None,
        }
    }

    /// Blames the scans of one file.
    pub(crate) fn for_file(file: &str, problem: ScanProblem) -> Self {
        TopographyError { file: Some(file.to_owned()), request: None, problem }
    }

    /// Blames all scans together.
    #[must_use]
    pub fn for_all(problem: ScanProblem) -> Self {
        TopographyError { file: None, request: None, problem }
    }
}
