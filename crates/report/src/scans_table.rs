//! The scans of a composite in a table for people.

use topography::{CompositeSpectrum, ScanSpectrum};
use units::display::{length, three_digits};

use crate::scan_words::band_end;
use crate::summary::aligned;

/// A line for each scan: the wavelengths it is used at and what ends them, its rms slopes along and across its lines, and
/// whether anything about it is doubtful.
#[must_use]
pub fn scans_table(found: &CompositeSpectrum) -> String {
    let head = ["scan", "used from", "down to", "limit", "slope along", "slope across", "verdict"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(found.scans.iter().zip(found.series_names()).map(|(scan, name)| row(scan, name)));
    aligned(&rows)
}

fn row(scan: &ScanSpectrum, name: String) -> Vec<String> {
    vec![
        name,
        length(scan.reliable.longest_wavelength_m()),
        length(scan.reliable.shortest_wavelength_m()),
        band_end(&scan.band_end),
        three_digits(scan.checks.real_slope),
        scan.checks.slope_across.map_or("-".to_owned(), three_digits),
        if scan.is_doubtful() { "doubtful" } else { "ok" }.to_owned(),
    ]
}
