//! Automatic checks of a spectrum.

use std::f64::consts::TAU;

use scans::Scan;

use crate::piecewise::nonuniform_line_spectrum_to;
use crate::remark::{Derivative, FundamentalMode, ScanRemark};
use crate::rows::{Lines, Rows};
use crate::sums::dot;
use crate::{
    DerivativeOf, Detrend, LineSpectrum, Preparation, ScanBoundary, Window, real_space_derivatives,
    real_space_derivatives_across,
};

/// Results of the checks of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Checks {
    /// Variance from the spectrum over that of the prepared heights: 1 by Parseval's theorem; for unevenly spaced
    /// points the share at the wavelengths of the spectrum.
    pub parseval_share: f64,
    /// True if the points are evenly spaced, so that `parseval_share` must be 1.
    pub evenly_spaced: bool,
    /// Largest over median distance of neighbouring points; a straight line bridges it. 1 for evenly spaced points.
    pub largest_gap: f64,
    /// Root mean square slope along the scan lines from neighbouring points.
    pub real_slope: f64,
    /// Root mean square slope across the scan lines of a map from neighbouring points.
    pub slope_across: Option<f64>,
    /// Root mean square slope along the scan lines from the spectrum, of the heights as prepared for it.
    pub spectral_slope: Option<f64>,
    /// Root mean square curvature \[1/m\] from neighbouring points.
    pub real_curvature_per_m: Option<f64>,
    /// Root mean square curvature \[1/m\] from the spectrum.
    pub spectral_curvature_per_m: Option<f64>,
    /// State of the mode whose wavelength is the length of the scan.
    pub fundamental: FundamentalMode,
}

impl Checks {
    /// Checks the spectrum of a scan. Slopes between neighbouring points are compared with those from the spectrum,
    /// whose window gives more weight to the middle of a line.
    #[must_use]
    pub fn new(scan: &Scan, spectrum: &LineSpectrum, preparation: Preparation, is_periodic: bool) -> Self {
        let boundary = if is_periodic { ScanBoundary::Periodic } else { ScanBoundary::Open };
        let real = real_space_derivatives(scan, preparation.detrend, boundary);
        let spectral = spectrum.rms_derivatives(match scan {
            Scan::NonuniformLine(_) => DerivativeOf::Continuum,
            _ => DerivativeOf::Differences,
        });
        Checks {
            parseval_share: spectrum.parseval_share(),
            evenly_spaced: !matches!(scan, Scan::NonuniformLine(_)),
            largest_gap: largest_gap(scan),
            real_slope: real.slope,
            slope_across: real_space_derivatives_across(scan, preparation.detrend, boundary)
                .map(|across| across.slope),
            spectral_slope: spectral.map(|spectral| spectral.slope),
            real_curvature_per_m: real.curvature_per_m,
            spectral_curvature_per_m: spectral.and_then(|spectral| spectral.curvature_per_m),
            fundamental: match fundamental_kept(scan, preparation.detrend) {
                _ if !spectrum.holds_fundamental() => FundamentalMode::Absent,
                Some(share) => FundamentalMode::Kept { share, used: preparation.flagged_bins() == 0 },
                None => FundamentalMode::MadeByWindow,
            },
        }
    }

    /// Makes remarks on all checks, passed or not.
    #[must_use]
    pub fn remarks(&self) -> Vec<ScanRemark> {
        let evenly_spaced = self.evenly_spaced;
        let compared = |derivative, real, spectral: Option<f64>| {
            Some(ScanRemark::Derivative { derivative, real, spectral: spectral?, evenly_spaced })
        };
        let curvature = self.real_curvature_per_m.and_then(|real_per_m| {
            compared(Derivative::CurvaturePerM, real_per_m, self.spectral_curvature_per_m)
        });
        [
            Some(ScanRemark::Variance { share: self.parseval_share, evenly_spaced }),
            (!evenly_spaced).then_some(ScanRemark::Gap { over_median: self.largest_gap }),
            compared(Derivative::Slope, self.real_slope, self.spectral_slope),
            curvature,
            self.slope_across.map(|across| ScanRemark::Slopes { along: self.real_slope, across }),
            Some(ScanRemark::Fundamental(self.fundamental)),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

fn largest_gap(scan: &Scan) -> f64 {
    let Scan::NonuniformLine(line) = scan else { return 1.0 };
    let mut distances_m: Vec<f64> = line.positions_m().windows(2).map(|pair| pair[1] - pair[0]).collect();
    distances_m.sort_by(f64::total_cmp);
    distances_m[distances_m.len() - 1] / distances_m[distances_m.len() / 2]
}

/// Computes the share of the spectrum at q = 2 pi/L that detrending leaves, relative to subtracting only the mean, both
/// without a window; `None` if there is no such mode.
///
/// 1 for [`Detrend::Mean`]. A fitted slope removes part of the fundamental mode (85 % of the power of a sine wave of
/// length L) together with the tilt of the sample. A small share means that the first bin cannot show the surface: it
/// was removed, or it was all tilt.
pub fn fundamental_kept(scan: &Scan, detrend: Detrend) -> Option<f64> {
    let before = fundamental_m3(scan, Detrend::Mean);
    (before > 0.0).then(|| fundamental_m3(scan, detrend) / before)
}

fn fundamental_m3(scan: &Scan, detrend: Detrend) -> f64 {
    match Lines::from_scan(scan) {
        Lines::Even(rows) => fundamental_of_rows(&rows, detrend),
        Lines::Uneven(line) => {
            let preparation = Preparation { detrend, window: Window::None };
            nonuniform_line_spectrum_to(line, preparation, 1).c1d_m3()[0]
        }
    }
}

/// Computes the first bin alone by its defining sum, since a full transform would compute all others for nothing.
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
