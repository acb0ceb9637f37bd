//! How far a spectrum can be believed: checks that run by themselves.

use scans::Scan;

use crate::remark::{Derivative, FundamentalMode, ScanRemark};
use crate::{
    Boundary, DerivativeOf, LineSpectrum, Preparation, fundamental_kept, real_space_derivatives,
    real_space_derivatives_across,
};

/// What is known of a spectrum besides its values.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Checks {
    /// Variance from the spectrum over that of the prepared heights: 1 by Parseval's theorem, of unevenly spaced points the
    /// share at the wavelengths of the spectrum.
    pub parseval_share: f64,
    /// Whether the points are evenly spaced, so that the former has to be 1.
    pub evenly_spaced: bool,
    /// The largest distance of neighbouring points over their median, of unevenly spaced ones: what lies between is taken for
    /// a straight line.
    pub largest_gap: f64,
    /// Root mean square slope along the scan lines from neighbouring points.
    pub real_slope: f64,
    /// The same across the scan lines, of a map.
    pub slope_across: Option<f64>,
    /// Root mean square slope along the scan lines from the spectrum, of the heights as prepared for it.
    pub spectral_slope: Option<f64>,
    /// Root mean square curvature \[1/m\] from neighbouring points.
    pub real_curvature_per_m: Option<f64>,
    /// The same from the spectrum.
    pub spectral_curvature_per_m: Option<f64>,
    /// What became of the mode of the whole length.
    pub fundamental: FundamentalMode,
}

impl Checks {
    /// Checks the spectrum of a scan. Slopes are those of neighbouring points: of the detrended heights themselves, and of
    /// the spectrum, whose window weighs the middle of a line more.
    #[must_use]
    pub fn of(scan: &Scan, spectrum: &LineSpectrum, preparation: Preparation, is_periodic: bool) -> Self {
        let boundary = if is_periodic { Boundary::Periodic } else { Boundary::Open };
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

    /// What the checks say, passed or not.
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
    let mut gaps: Vec<f64> = line.positions_m().windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_by(f64::total_cmp);
    gaps[gaps.len() - 1] / gaps[gaps.len() / 2]
}
