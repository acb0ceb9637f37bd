//! Automatic checks of a spectrum.

use std::f64::consts::TAU;

use scans::Scan;
use units::{Remark, RemarkCode};

use crate::narrow_lines::NarrowLine;
use crate::piecewise::nonuniform_line_spectrum_to;
use crate::plausibility::implausible;
use crate::remark::{FundamentalMode, SLOPES_DIFFER};
use crate::rows::{Lines, Rows};
use crate::skewness::clear_skewness;
use crate::spike::Spike;
use crate::sums::dot;
use crate::{
    DerivativeOf, Detrend, LineSpectrum, Preparation, ScanBoundary, Window, real_space_derivatives,
    real_space_derivatives_across,
};

/// Deviation from Parseval's theorem that exceeds rounding.
const LARGE_PARSEVAL: f64 = 1e-9;
/// The least relative error that double precision resolves.
const MIN_RELATIVE_ERROR: f64 = 1e-15;
/// Largest relative difference of rms slopes and curvatures that a window and nonuniform roughness explain.
const LARGE_DERIVATIVE: f64 = 0.1;
/// Largest such difference for uneven points, whose straight lines have slopes beyond the last wavelength.
const LARGE_DERIVATIVE_UNEVEN: f64 = 0.5;
/// Share of the variance below which a trace of uneven points is doubtful.
const LEAST_SHARE: f64 = 0.9;
/// Largest over median distance of neighbouring points above which a trace is doubtful.
const LARGE_GAP: f64 = 10.0;

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
    /// Skewness Rsk of a trace, where it is clearly not that of Gaussian heights, see [`clear_skewness`].
    pub skewness: Option<f64>,
    /// Length along the scan lines \[m\].
    pub length_m: f64,
    /// A point far off all others, as errors of an instrument leave.
    pub spike: Option<Spike>,
    /// Waves of one length that carry a large share of the variance.
    pub line: Option<NarrowLine>,
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
            skewness: clear_skewness(scan, preparation.detrend),
            length_m: length_m(scan),
            spike: Spike::find(scan),
            line: NarrowLine::find(scan, spectrum, preparation),
            fundamental: match fundamental_kept(scan, preparation.detrend) {
                _ if !spectrum.holds_fundamental() => FundamentalMode::Absent,
                Some(share) => FundamentalMode::Kept { share, used: preparation.flagged_bins() == 0 },
                None => FundamentalMode::MadeByWindow,
            },
        }
    }

    /// Makes remarks on all checks, passed or not.
    #[must_use]
    pub fn remarks(&self) -> Vec<Remark> {
        let slopes = self.spectral_slope.map(|spectral| (self.real_slope, spectral));
        let curvatures = self.real_curvature_per_m.zip(self.spectral_curvature_per_m);
        let gap = |code| Remark::new(code).with("over_median", self.largest_gap);
        let gap = if self.largest_gap <= LARGE_GAP {
            gap(RemarkCode::NarrowGaps)
        } else {
            gap(RemarkCode::WideGap)
        };
        [
            Some(self.variance()),
            (!self.evenly_spaced).then_some(gap),
            slopes.map(|found| self.compared(RemarkCode::SlopesCompared, found)),
            curvatures.map(|found| self.compared(RemarkCode::CurvaturesCompared, found)),
            self.slope_across.map(|across| slopes_of_map(self.real_slope, across)),
            self.skewness.map(|skewness| Remark::new(RemarkCode::TraceSkewed).with("skewness", skewness)),
            implausible(self.real_slope.max(self.slope_across.unwrap_or(0.0)), self.length_m),
            self.spike.map(Spike::remark),
            self.line.map(NarrowLine::remark),
            Some(self.fundamental.remark()),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    fn variance(&self) -> Remark {
        let share = self.parseval_share;
        // A comparison with NaN is false and must not pass a check.
        match self.evenly_spaced {
            true if (share - 1.0).abs() <= LARGE_PARSEVAL => {
                let power = (share - 1.0).abs().max(MIN_RELATIVE_ERROR).log10().ceil();
                // The logarithm of a power of ten may lie a rounding above it.
                let bound = 10f64.powi((power - 1e-9) as i32);
                Remark::new(RemarkCode::ParsevalHolds).with("bound", format!("{bound:.0e}"))
            }
            true => Remark::new(RemarkCode::ParsevalFails).with("share", share),
            false => {
                Remark::new(RemarkCode::VarianceOfTrace).with("share", share).passed_if(share >= LEAST_SHARE)
            }
        }
    }

    /// The remark on a root mean square derivative from neighbouring points and from the spectrum.
    fn compared(&self, code: RemarkCode, (real, spectral): (f64, f64)) -> Remark {
        let most = if self.evenly_spaced { LARGE_DERIVATIVE } else { LARGE_DERIVATIVE_UNEVEN };
        let apart = spectral / real - 1.0;
        let difference = match (real == 0.0, spectral == 0.0) {
            (true, true) => "the same".to_owned(),
            (true, false) => "none to compare with".to_owned(),
            (false, _) => format!("{:+.1} %", 100.0 * apart),
        };
        let remark = Remark::new(code).with("real", real).with("spectral", spectral);
        remark.with("difference", difference).passed_if(real == spectral || apart.abs() <= most)
    }
}

/// The remark on the root mean square slopes along and across the lines of a map.
fn slopes_of_map(along: f64, across: f64) -> Remark {
    let is_alike = along == across || (along / across).ln().abs() < SLOPES_DIFFER.ln();
    let code = if is_alike { RemarkCode::SlopesAlike } else { RemarkCode::SlopesDiffer };
    Remark::new(code).with("along", along).with("across", across).with("bound", SLOPES_DIFFER)
}

fn length_m(scan: &Scan) -> f64 {
    match scan {
        Scan::UniformLine(line) => line.length_m(),
        Scan::NonuniformLine(line) => line.length_m(),
        Scan::Map(map) => map.spacing_x_m() * map.columns() as f64,
        Scan::Lines(lines) => lines.length_m(),
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
            nonuniform_line_spectrum_to(line, preparation, 1).c1d_m3[0]
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

#[cfg(test)]
mod tests {
    use units::SceneKeys;

    use super::*;

    #[test]
    fn checks_are_worded_as_in_the_field() {
        let checks = Checks {
            parseval_share: 1.0,
            evenly_spaced: true,
            largest_gap: 1.0,
            real_slope: 0.0,
            slope_across: None,
            spectral_slope: Some(0.1),
            real_curvature_per_m: None,
            spectral_curvature_per_m: None,
            skewness: None,
            length_m: 1e-6,
            spike: None,
            line: None,
            fundamental: FundamentalMode::Kept { share: 0.85, used: false },
        };
        let worded = |checks: &Checks| -> Vec<String> {
            let remarks = checks.remarks().into_iter().map(|remark| remark.about(["a"]).words(&SceneKeys));
            remarks.collect()
        };
        assert_eq!(
            worded(&checks),
            [
                "a: Parseval: relative error below 1e-15",
                "a: rms slope 0 from neighbouring points, 0.1 from the spectrum (none to compare with)",
                "a: the mode of the full length keeps 85 % of its power; bin not used",
            ]
        );
        let close = Checks { parseval_share: 1.0 - 3e-13, ..checks };
        assert_eq!(worded(&close)[0], "a: Parseval: relative error below 1e-12");
    }
}
