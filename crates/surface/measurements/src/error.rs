//! What can be wrong on the way from the files of scans to a spectrum.

use std::{fmt, io};

use scans::{Mend, ScanReadError};
use topography::{Direction, TransformError};
use units::number;

/// Why the scans of a file, or all of them together, yield no spectrum.
#[derive(Debug)]
pub struct TopographyError {
    /// The file to blame, as asked for; absent where it is all of them together.
    pub file: Option<String>,
    /// Which of the scans asked for is to blame, by index.
    pub request: Option<usize>,
    /// What is wrong.
    pub problem: ScanProblem,
}

/// What is wrong with scans.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScanProblem {
    /// The file cannot be had.
    #[error("{0}")]
    Reading(io::Error),
    /// A text that describes the scans beside it is none.
    #[error("line {line}: not UTF-8 text; save the metadata as UTF-8")]
    NotText {
        /// The first line that is none.
        line: usize,
    },
    /// The file holds a spectrum, which needs no transform.
    #[error("this file holds a power spectrum, not heights; give it as a PSD")]
    HoldsASpectrum,
    /// The file cannot be read as heights.
    #[error(transparent)]
    Format(Box<ScanReadError>),
    /// The heights cannot be transformed.
    #[error("{}{error}", scan.as_ref().map_or(String::new(), |scan| format!("{scan}: ")))]
    Transform {
        /// The scan, where it has another name than its file.
        scan: Option<String>,
        /// Why.
        error: TransformError,
    },
    /// A text that is neither heights nor a spectrum.
    #[error("as a scan: {as_scan}{}", as_spectrum.as_ref().map_or(String::new(), |why| format!("; as a spectrum: {why}")))]
    NeitherKind {
        /// Why it is no scan.
        as_scan: Box<ScanReadError>,
        /// Why it is no spectrum.
        as_spectrum: Option<String>,
    },
    /// Scans of one instrument say different things of it.
    #[error(
        "the {what} of {instrument} is {} here and {} with {other}; scans of one instrument share one",
        number(*here),
        number(*there)
    )]
    InstrumentDisagrees {
        /// The name of the instrument.
        instrument: String,
        /// What is said of it.
        what: &'static str,
        /// What this scan says.
        here: f64,
        /// What one before it says.
        there: f64,
        /// The file of that one.
        other: String,
    },
    /// A surface of none or several scans.
    #[error("{0} scans; boundary elements press one map, which a channel may choose")]
    NotOneSurface(usize),
    /// A surface of a line.
    #[error(
        "a line scan is no surface that boundary elements could press; make a spectrum of it and give that"
    )]
    LineIsNoSurface,
    /// An areal spectrum of none or several scans.
    #[error("{0} scans; an areal spectrum is that of one map")]
    NotOneMap(usize),
    /// An areal spectrum of a line.
    #[error("a line scan has no areal spectrum")]
    LineHasNoArea,
    /// An areal spectrum along an axis.
    #[error(
        "an areal spectrum is averaged over all directions of a map, and direction = \"{0}\" is asked for; leave it out"
    )]
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
    /// The option of a scan that mends it, where one does; whoever asked knows what it is called there.
    #[must_use]
    pub fn mend(&self) -> Option<Mend> {
        match &self.problem {
            ScanProblem::Format(error) => error.mend(),
            ScanProblem::NeitherKind { as_scan, .. } => as_scan.mend(),
            _ => None,
        }
    }

    /// The scans of one file are to blame.
    pub(crate) fn of_file(file: &str, problem: ScanProblem) -> Self {
        TopographyError { file: Some(file.to_owned()), request: None, problem }
    }

    /// All of the scans together are to blame.
    #[must_use]
    pub fn of_all(problem: ScanProblem) -> Self {
        TopographyError { file: None, request: None, problem }
    }
}
