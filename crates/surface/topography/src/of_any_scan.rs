//! The spectrum of a line or a map, whichever it is.

use scans::Scan;

use crate::line::LineSpectrum;
use crate::lines::rows_spectrum;
use crate::piecewise::nonuniform_line_spectrum;
use crate::preparation::Preparation;
use crate::rows::Lines;

/// The spectrum C1D of any scan: of a map, the mean of those of its rows.
pub fn line_spectrum(scan: &Scan, preparation: Preparation) -> LineSpectrum {
    match Lines::of(scan) {
        Lines::Even(rows) => rows_spectrum(rows, preparation),
        Lines::Uneven(line) => nonuniform_line_spectrum(line, preparation),
    }
}
