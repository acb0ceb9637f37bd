//! How much of the longest wavelength detrending leaves.

use crate::detrend::Detrend;
use crate::lines::rows_spectrum;
use crate::piecewise::nonuniform_line_spectrum_to;
use crate::rows::Lines;
use crate::window::Window;
use crate::{LineSpectrum, Preparation};
use scans::Scan;

/// The spectrum at q = 2 pi/L after detrending over that with only the mean subtracted, both without a window; `None`
/// where there is none to begin with.
///
/// 1 for [`Detrend::Mean`]. A fitted slope takes part of the fundamental mode away (of a sine wave of length L, 85 % of its
/// power) together with the tilt of the sample, so a small value says that the first bin cannot show the surface, either
/// because it has gone or because it was all tilt.
pub fn fundamental_kept(scan: &Scan, detrend: Detrend) -> Option<f64> {
    let before = fundamental_m3(scan, Detrend::Mean);
    (before > 0.0).then(|| fundamental_m3(scan, detrend) / before)
}

fn fundamental_m3(scan: &Scan, detrend: Detrend) -> f64 {
    let preparation = Preparation { detrend, window: Window::None };
    let spectrum: LineSpectrum = match Lines::of(scan) {
        Lines::Even(rows) => rows_spectrum(rows, preparation),
        Lines::Uneven(line) => nonuniform_line_spectrum_to(line, preparation, 1),
    };
    spectrum.c1d_m3()[0]
}
