//! How much of the longest wavelength detrending leaves.

use std::f64::consts::TAU;

use crate::Preparation;
use crate::detrend::Detrend;
use crate::piecewise::nonuniform_line_spectrum_to;
use crate::rows::{Lines, Rows};
use crate::sums::dot;
use crate::window::Window;
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
    match Lines::of(scan) {
        Lines::Even(rows) => fundamental_of_rows(&rows, detrend),
        Lines::Uneven(line) => {
            let preparation = Preparation { detrend, window: Window::None };
            nonuniform_line_spectrum_to(line, preparation, 1).c1d_m3()[0]
        }
    }
}

/// The first bin alone, summed as it is defined: a whole transform would be thrown away but for it.
fn fundamental_of_rows(rows: &Rows, detrend: Detrend) -> f64 {
    let points = rows.points;
    let trend = rows.trend(detrend);
    let wave = |of: fn(f64) -> f64| -> Vec<f64> {
        (0..points).map(|i| of(TAU * i as f64 / points as f64)).collect()
    };
    let (cosine, sine) = (wave(f64::cos), wave(f64::sin));
    let (ones, mut rest_m) = (vec![1.0; points], vec![0.0; points]);
    let power_m2 = |(row, heights_m): (usize, &[f64])| {
        trend.subtract(row, heights_m, &ones, &mut rest_m);
        dot(&rest_m, &cosine).powi(2) + dot(&rest_m, &sine).powi(2)
    };
    let mean_m2 = rows.iter().enumerate().map(power_m2).sum::<f64>() / rows.count() as f64;
    mean_m2 * rows.spacing_m / points as f64
}
