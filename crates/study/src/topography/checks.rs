//! How far a spectrum can be believed: checks that run by themselves.

use scans::Scan;
use topography::{
    Boundary, DerivativeOf, LineSpectrum, Preparation, fundamental_kept, real_space_derivatives,
};

use units::display::three_digits;

/// From here on a deviation is worth a sentence of warning.
const LARGE_PARSEVAL: f64 = 1e-9;
const LARGE_DERIVATIVE: f64 = 0.1;
const LARGE_DERIVATIVE_UNEVEN: f64 = 0.5;
/// Shares of the variance, and gaps over the median distance, beyond which a trace of uneven points is doubtful.
const LEAST_SHARE: f64 = 0.9;
const LARGE_GAP: f64 = 10.0;

/// What is known of a spectrum besides its values.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// The same from the spectrum, of the heights as prepared for it.
    pub spectral_slope: Option<f64>,
    /// Root mean square curvature \[1/m\] from neighbouring points.
    pub real_curvature_per_m: Option<f64>,
    /// The same from the spectrum.
    pub spectral_curvature_per_m: Option<f64>,
    /// The share of the mode of the whole length that detrending left; absent for one that was not there.
    pub fundamental_kept: Option<f64>,
    /// Whether the spectrum holds that mode.
    pub holds_fundamental: bool,
}

impl Checks {
    /// Checks the spectrum of a scan. Slopes are those of neighbouring points: of the detrended heights themselves, and of
    /// the spectrum, whose window weighs the middle of a line more.
    pub(super) fn of(
        scan: &Scan,
        spectrum: &LineSpectrum,
        preparation: Preparation,
        is_periodic: bool,
    ) -> Self {
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
            spectral_slope: spectral.map(|spectral| spectral.slope),
            real_curvature_per_m: real.curvature_per_m,
            spectral_curvature_per_m: spectral.and_then(|spectral| spectral.curvature_per_m),
            fundamental_kept: fundamental_kept(scan, preparation.detrend),
            holds_fundamental: spectrum.holds_fundamental(),
        }
    }

    /// The checks in a sentence each.
    pub fn sentences(&self) -> Vec<String> {
        let mut sentences = Vec::new();
        let deviation = (self.parseval_share - 1.0).abs();
        // A comparison with NaN is false and would pass any bound.
        let exact = deviation <= LARGE_PARSEVAL;
        sentences.push(match (self.evenly_spaced, !exact) {
            (true, false) => format!("the spectrum holds the variance of the heights to {deviation:.0e}"),
            (true, true) => {
                format!("WARNING: the spectrum holds {:.1} % of the variance of the heights", 100.0 * self.parseval_share)
            }
            (false, _) => format!(
                "{}the spectrum holds {:.1} % of the variance of the trace, the rest lies below the distance of its points",
                if self.parseval_share >= LEAST_SHARE { "" } else { "WARNING: " },
                100.0 * self.parseval_share
            ),
        });
        if self.largest_gap > LARGE_GAP {
            sentences.push(format!(
                "WARNING: a gap of {} times the usual distance of points is bridged by a straight line",
                three_digits(self.largest_gap)
            ));
        }
        let compare = |what: &str, unit: &str, real: f64, spectral: Option<f64>| {
            spectral.map(|spectral| {
                let off = spectral / real - 1.0;
                // The straight lines between uneven points have slopes beyond the last wavelength of the spectrum.
                let most = if self.evenly_spaced { LARGE_DERIVATIVE } else { LARGE_DERIVATIVE_UNEVEN };
                let warning = if off.abs() <= most { "" } else { "WARNING: " };
                format!(
                    "{warning}rms {what} {}{unit} from neighbouring points, {}{unit} from the spectrum ({:+.1} %)",
                    three_digits(real),
                    three_digits(spectral),
                    100.0 * off
                )
            })
        };
        sentences.extend(compare("slope", "", self.real_slope, self.spectral_slope));
        sentences.extend(
            self.real_curvature_per_m
                .and_then(|real| compare("curvature", " 1/m", real, self.spectral_curvature_per_m)),
        );
        sentences.push(match (self.holds_fundamental, self.fundamental_kept) {
            (false, _) => "the mode of the whole length is absent".to_owned(),
            (true, Some(kept)) => {
                format!("{} of the mode of the whole length is left after detrending", three_digits(kept))
            }
            (true, None) => "the mode of the whole length was made by the window alone".to_owned(),
        });
        sentences
    }
}

fn largest_gap(scan: &Scan) -> f64 {
    let Scan::NonuniformLine(line) = scan else { return 1.0 };
    let mut gaps: Vec<f64> = line.positions_m().windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_by(f64::total_cmp);
    gaps[gaps.len() - 1] / gaps[gaps.len() / 2]
}
