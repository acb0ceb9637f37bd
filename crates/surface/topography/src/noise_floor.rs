//! The noise floor of an instrument: the level part of a spectrum at its short end.

use std::f64::consts::{PI, SQRT_2, TAU};
use std::num::NonZeroU32;

use crate::bins::{BinMean, log_binned};
use crate::line::LineSpectrum;
use spectrum::ProfilePsd;

/// A white floor under the spectrum of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoiseFloor {
    /// Level of the floor \[m^3\].
    pub c1d_m3: f64,
    /// Wavelength \[m\] at which surface and floor are equal and the spectrum is twice the floor.
    pub wavelength_m: f64,
}

/// Bins of the fit per decade.
const BINS_PER_DECADE: NonZeroU32 = NonZeroU32::new(20).expect("twenty is not zero");
/// Smallest number of values in each half of the last octave; fewer scatter too much.
const FEWEST_VALUES: usize = 16;
/// Smallest number of bins of the falling part.
const FEWEST_BINS: usize = 4;
/// Largest ratio of the halves of a level octave, apart from their scatter.
const LEVEL: f64 = 1.25;
/// Ratio to the floor above which a value belongs to the falling part.
const ABOVE_FLOOR: f64 = 2.5;
/// Ratio of wavevectors over which the falling part is fitted.
const REACH: f64 = 4.0;
/// Smallest ratio of the floor to the falling part, continued and folded at the Nyquist wavevector.
const ABOVE_FOLDED: f64 = 3.0;
/// Range of exponents of surfaces, from a Hurst exponent near 0 to a profile of sharp corners, with a margin. Spectra
/// that fall faster were smoothed or interpolated; the floor under them is the rounding of numbers.
const LEAST_EXPONENT: f64 = 0.8;
const LARGEST_EXPONENT: f64 = 5.0;
/// Number of iterations that separate falling part and floor.
const ROUNDS: usize = 4;

/// Finds the noise floor of a spectrum of evenly spaced points; `None` if there is none, or if aliasing explains it.
///
/// With a floor, the last octave before the Nyquist wavevector is level, longer waves fall as a power of the
/// wavevector, and this power law ends well below the level even with aliasing. A spectrum that is level everywhere may
/// be a roll-off or noise; one that falls to its end, as of interpolated heights, has no floor.
pub(crate) fn noise_floor(spectrum: &LineSpectrum) -> Option<NoiseFloor> {
    let nyquist_rad_per_m = PI / spectrum.spacing_m?;
    let q_and_c1d = || {
        let all = spectrum.wavevectors_rad_per_m().zip(spectrum.c1d_m3.iter().copied());
        all.skip(spectrum.flagged_bins)
    };
    let within = |from: f64, to: f64| -> Vec<f64> {
        let range = from * nyquist_rad_per_m..to * nyquist_rad_per_m;
        q_and_c1d().filter(|(q, _)| range.contains(q)).map(|(_, c1d_m3)| c1d_m3).collect()
    };
    // The Nyquist wavevector is left out: its amplitudes are real numbers and scatter more.
    let halves = [within(0.5, 0.5 * SQRT_2), within(0.5 * SQRT_2, 1.0 - 1e-9)];
    if !is_level(&halves, spectrum.lines) {
        return None;
    }
    let last_octave = within(0.5, 1.0 - 1e-9);
    let (wavelengths_m, values_m3): (Vec<_>, Vec<_>) =
        q_and_c1d().filter(|&(_, c1d_m3)| c1d_m3 > 0.0).map(|(q, c1d_m3)| (TAU / q, c1d_m3)).unzip();
    let psd = ProfilePsd::new(wavelengths_m, values_m3).ok()?;
    let binned = log_binned(&psd, BINS_PER_DECADE, BinMean::Arithmetic);

    let mean_m3 = mean(&last_octave);
    let mut floor_m3 = mean_m3;
    let mut fall = Fall::fit(&binned, floor_m3)?;
    for _ in 0..ROUNDS {
        // Subtract the falling part's mean over the last octave from the floor.
        let added_m3 = fall.mean_m3(0.5 * nyquist_rad_per_m, nyquist_rad_per_m);
        floor_m3 = (mean_m3 - added_m3).max(0.5 * mean_m3);
        fall = Fall::fit(&binned, floor_m3)?;
    }
    let onset_rad_per_m = fall.reaches(floor_m3);
    let is_surface = (LEAST_EXPONENT..=LARGEST_EXPONENT).contains(&fall.exponent);
    let is_above = floor_m3 >= ABOVE_FOLDED * 2.0 * fall.at_m3(nyquist_rad_per_m);
    let is_seen = onset_rad_per_m <= 0.5 * nyquist_rad_per_m && onset_rad_per_m > fall.first_rad_per_m;
    (is_surface && is_above && is_seen)
        .then(|| NoiseFloor { c1d_m3: floor_m3, wavelength_m: TAU / onset_rad_per_m })
}

/// Returns true if both halves of the last octave are equal up to the scatter of periodograms averaged over lines.
fn is_level(halves: &[Vec<f64>; 2], lines: usize) -> bool {
    if halves.iter().any(|half| half.len() < FEWEST_VALUES) {
        return false;
    }
    let [first, second] = halves.each_ref().map(|half| mean(half));
    if first <= 0.0 || second <= 0.0 {
        return false;
    }
    let scatter = halves.iter().map(|half| 1.0 / (half.len() * lines) as f64).sum::<f64>().sqrt();
    (first / second).ln().abs() <= LEVEL.ln() + 2.0 * scatter
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Power law a q^-p of the falling part of a spectrum minus its floor, fitted in logarithms.
struct Fall {
    /// Start of the fit \[rad/m\].
    first_rad_per_m: f64,
    exponent: f64,
    /// Point on the law: the weighted mean of the logarithms.
    centre_rad_per_m: f64,
    centre_m3: f64,
}

impl Fall {
    /// Fits from the last bin well above the floor towards longer waves.
    fn fit(binned: &ProfilePsd, floor_m3: f64) -> Option<Self> {
        let samples = || binned.wavelengths_m().iter().map(|l| TAU / l).zip(binned.c1d_m3().iter().copied());
        let is_above = |&(_, c1d_m3): &(f64, f64)| c1d_m3 > ABOVE_FLOOR * floor_m3;
        let (last_rad_per_m, _) = samples().rfind(is_above)?;
        let part: Vec<(f64, f64)> = samples()
            .filter(|&(q, _)| q <= last_rad_per_m && q * REACH >= last_rad_per_m)
            .filter(is_above)
            .map(|(q, c1d_m3)| (q.ln(), (c1d_m3 - floor_m3).ln()))
            .collect();
        if part.len() < FEWEST_BINS {
            return None;
        }
        // Bins of shorter waves hold more values and scatter less.
        let weight: f64 = part.iter().map(|(x, _)| x.exp()).sum();
        let weighted = || part.iter().map(|&(x, y)| (x.exp() / weight, x, y));
        let (x, y) =
            weighted().fold((0.0, 0.0), |(x, y), point| (x + point.0 * point.1, y + point.0 * point.2));
        let (square, product) = weighted().fold((0.0, 0.0), |(square, product), point| {
            (square + point.0 * (point.1 - x).powi(2), product + point.0 * (point.1 - x) * (point.2 - y))
        });
        Some(Self {
            first_rad_per_m: part[0].0.exp(),
            exponent: -product / square,
            centre_rad_per_m: x.exp(),
            centre_m3: y.exp(),
        })
    }

    fn at_m3(&self, q_rad_per_m: f64) -> f64 {
        self.centre_m3 * (q_rad_per_m / self.centre_rad_per_m).powf(-self.exponent)
    }

    /// Wavevector \[rad/m\] at which the law reaches a level.
    fn reaches(&self, level_m3: f64) -> f64 {
        self.centre_rad_per_m * (self.centre_m3 / level_m3).powf(1.0 / self.exponent)
    }

    /// Mean between two wavevectors, by Simpson's rule.
    fn mean_m3(&self, from: f64, to: f64) -> f64 {
        (self.at_m3(from) + 4.0 * self.at_m3(0.5 * (from + to)) + self.at_m3(to)) / 6.0
    }
}
