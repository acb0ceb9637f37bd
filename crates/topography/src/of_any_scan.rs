//! The spectrum of a line or a map, whichever it is.

use scans::Scan;

use crate::line::LineSpectrum;
use crate::lines::{map_line_spectrum, uniform_line_spectrum};
use crate::piecewise::nonuniform_line_spectrum;
use crate::preparation::Preparation;

/// The spectrum C1D of any scan: of a map, the mean of those of its rows.
pub fn line_spectrum(scan: &Scan, preparation: Preparation) -> LineSpectrum {
    match scan {
        Scan::UniformLine(line) => uniform_line_spectrum(line, preparation),
        Scan::NonuniformLine(line) => nonuniform_line_spectrum(line, preparation),
        Scan::Map(map) => map_line_spectrum(map, preparation),
    }
}
