//! Which scans are of one instrument: those that are said to be, and else those of one format and maker.

use scans::ScanFile;

use crate::request::ScanRequest;

/// The instrument of a scan, and what is known of its calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct InstrumentOfScan {
    /// Its name; scans of one name are of one instrument.
    pub name: String,
    /// Whether the name was guessed from the file.
    pub is_guessed: bool,
    /// One standard uncertainty of its height scale, as a share, where it is given.
    pub z_calibration: Option<f64>,
    /// One standard uncertainty of the exponent of its spectrum, where it is given.
    pub slope_uncertainty: Option<f64>,
}

impl InstrumentOfScan {
    pub(crate) fn of<S>(request: &ScanRequest, file: &ScanFile<S>) -> Self {
        InstrumentOfScan {
            name: request.instrument.clone().unwrap_or_else(|| guessed_name(file)),
            is_guessed: request.instrument.is_none(),
            z_calibration: request.z_calibration,
            slope_uncertainty: request.slope_uncertainty,
        }
    }
}

/// What people wrote down as the instrument, and else the format, which is that of a maker.
fn guessed_name<S>(file: &ScanFile<S>) -> String {
    let written = file.free_text.lines().find_map(|line| {
        let rest = line.trim().strip_prefix("Instrument")?.trim_start();
        let name = rest.strip_prefix(['-', '–', ':', '='])?.trim().trim_end_matches('.');
        (!name.is_empty()).then(|| name.to_owned())
    });
    written.unwrap_or_else(|| file.format.to_string())
}
