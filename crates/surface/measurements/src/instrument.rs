//! Assignment of scans to instruments: by the given name, else by the file's own text or its format.

use scans::{ScanFile, ScanFormat};

use crate::request::ScanRequest;

/// The instrument of a scan and its calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct InstrumentOfScan {
    /// Name; scans with equal names share the instrument.
    pub name: String,
    /// True if the name was guessed from the file.
    pub is_guessed: bool,
    /// Relative standard uncertainty of the height scale, if given.
    pub z_calibration: Option<f64>,
    /// Standard uncertainty of the exponent of the spectrum, if given.
    pub slope_uncertainty: Option<f64>,
}

impl InstrumentOfScan {
    pub(crate) fn new<S>(request: &ScanRequest, file: &ScanFile<S>) -> Self {
        InstrumentOfScan {
            name: request.instrument.clone().unwrap_or_else(|| guessed_name(request, file)),
            is_guessed: request.instrument.is_none(),
            z_calibration: request.z_calibration,
            slope_uncertainty: request.slope_uncertainty,
        }
    }
}

/// Guesses the instrument from a line `Instrument: ...` in the file's text, else from its format, which is a maker's. Any
/// instrument may have written plain text, so each such file has an instrument of its own.
fn guessed_name<S>(request: &ScanRequest, file: &ScanFile<S>) -> String {
    let written = file.free_text.lines().find_map(|line| {
        let rest = line.trim().strip_prefix("Instrument")?.trim_start();
        let name = rest.strip_prefix(['-', '–', ':', '='])?.trim().trim_end_matches('.');
        (!name.is_empty()).then(|| name.to_owned())
    });
    written.unwrap_or_else(|| match file.format {
        ScanFormat::Text => request.path.clone(),
        format => format.to_string(),
    })
}
