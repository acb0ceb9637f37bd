//! Assignment of scans to instruments: by the given name, else by the file's own text or its format.

use scans::{Scan, ScanFile, ScanFormat};

use crate::request::ScanRequest;

/// The instrument of a scan and its calibration.
#[derive(Debug, Clone, PartialEq)]
pub struct InstrumentOfScan {
    /// Name; scans with equal names share the instrument.
    pub name: String,
    /// True if the name was guessed from the file.
    pub is_guessed: bool,
    /// Length and spacing of a text that names no instrument.
    pub layout: Option<String>,
    /// Relative standard uncertainty of the height scale, if given.
    pub z_calibration: Option<f64>,
    /// Standard uncertainty of the exponent of the spectrum, if given.
    pub slope_uncertainty: Option<f64>,
}

impl InstrumentOfScan {
    pub(crate) fn new(request: &ScanRequest, file: &ScanFile<Scan>) -> Self {
        let written = written_name(&file.free_text);
        let is_known = request.instrument.is_some() || written.is_some() || file.format != ScanFormat::Text;
        let layout = (!is_known).then(|| layout(&file.scan, request));
        InstrumentOfScan {
            name: request.instrument.clone().or(written).unwrap_or_else(|| file.format.to_string()),
            layout,
            is_guessed: request.instrument.is_none(),
            z_calibration: request.z_calibration,
            slope_uncertainty: request.slope_uncertainty,
        }
    }
}

/// Finds the instrument in a line `Instrument: ...` of a file's text.
fn written_name(free_text: &str) -> Option<String> {
    free_text.lines().find_map(|line| {
        let rest = line.trim().strip_prefix("Instrument")?.trim_start();
        let name = rest.strip_prefix(['-', '–', ':', '='])?.trim().trim_end_matches('.');
        (!name.is_empty()).then(|| name.to_owned())
    })
}

/// Describes length and spacing in three digits, and the calibration that was given.
fn layout(scan: &Scan, request: &ScanRequest) -> String {
    let (points, spacing_m) = match scan {
        Scan::UniformLine(line) => (line.heights_m().len().to_string(), line.spacing_m()),
        Scan::NonuniformLine(line) => (line.heights_m().len().to_string(), line.mean_spacing_m()),
        Scan::Map(map) => (format!("{} x {}", map.columns(), map.rows()), map.spacing_x_m()),
        Scan::Lines(lines) => (format!("lines of {}", lines.points()), lines.spacing_m()),
    };
    let of = |what, value: Option<f64>| value.map_or_else(String::new, |value| format!(", {what} {value}"));
    let calibration = of("z_calibration", request.z_calibration);
    let slope = of("slope_uncertainty", request.slope_uncertainty);
    format!("{points} points, {} apart{calibration}{slope}", units::display::length(spacing_m))
}
