//! The scans of a composite in a table for people.

use tables::Table;
use topography::{CompositeSpectrum, ScanSpectrum};
use units::display::{length, three_digits};

use crate::listing::aligned;

/// A line for each scan: the wavelengths used and their limit, the rms slopes along and across its lines, and a
/// verdict.
#[must_use]
pub fn scans_table(found: &CompositeSpectrum) -> String {
    let head = ["scan", "used from", "down to", "limit", "slope along", "slope across", "verdict"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(found.scans.iter().zip(found.series_names()).map(|(scan, name)| row(scan, name)));
    aligned(&rows)
}

/// The table of scans as columns: `scan, used_from_m, used_to_m, limit, slope_along, slope_across, verdict`. A line has
/// no slope across.
#[must_use]
pub fn scans_columns(found: &CompositeSpectrum) -> Table {
    let number = |of: fn(&ScanSpectrum) -> f64| found.scans.iter().map(of);
    Table::default()
        .with_text("scan", found.series_names())
        .with_numbers("used_from_m", number(|scan| scan.reliable.longest_wavelength_m()))
        .with_numbers("used_to_m", number(|scan| scan.reliable.shortest_wavelength_m()))
        .with_text("limit", found.scans.iter().map(|scan| scan.band_end.to_string()))
        .with_numbers("slope_along", number(|scan| scan.checks.real_slope))
        .with_numbers("slope_across", found.scans.iter().map(|scan| scan.checks.slope_across))
        .with_words("verdict", found.scans.iter().map(verdict))
}

fn row(scan: &ScanSpectrum, name: String) -> Vec<String> {
    vec![
        name,
        length(scan.reliable.longest_wavelength_m()),
        length(scan.reliable.shortest_wavelength_m()),
        scan.band_end.to_string(),
        three_digits(scan.checks.real_slope),
        scan.checks.slope_across.map_or("-".to_owned(), three_digits),
        verdict(scan).to_owned(),
    ]
}

fn verdict(scan: &ScanSpectrum) -> &'static str {
    if scan.is_doubtful() { "doubtful" } else { "ok" }
}
