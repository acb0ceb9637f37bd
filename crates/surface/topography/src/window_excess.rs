//! The excess of the spectrum of a scan over that of its surface, which window and trend leave at its longest waves.

use std::f64::consts::{PI, TAU};

use crate::Recipe;
use crate::detrend::Detrend;
use crate::preparation::Window;
use crate::scan_bins::ScanBin;
use crate::scan_spectrum::ScanSpectrum;

/// Fourier bins beyond this one have no excess: below 0.2 % for any self-affine surface.
const LAST_BIN: usize = 30;

/// Waves per length of the scan between two that are summed.
const STEP: f64 = 1.0 / 16.0;

/// Distance in Fourier bins beyond which waves leave nothing in a bin.
const REACH: f64 = 12.0;

impl ScanSpectrum {
    /// Computes ln of the expected spectrum over that of the surface in bins of this scan, whose surface has a spectrum
    /// `c1d_m3` at every wavevector in rad/m.
    ///
    /// The Hann window spreads every wave over its neighbouring Fourier bins, and a trend does not take all of the waves
    /// longer than the scan with it. A spectrum that rises towards them as q^-2.6 is 1.6 times too high in its second bin,
    /// by 11 % in the fourth and by 2 % in the tenth. 0 without a window.
    pub fn window_excess(&self, bins: &[ScanBin], recipe: &Recipe, c1d_m3: impl Fn(f64) -> f64) -> Vec<f64> {
        if self.preparation.window == Window::None {
            return vec![0.0; bins.len()];
        }
        let length_m = self.spectrum.length_m;
        let seen = SeenWaves::new(self, |waves| c1d_m3(TAU * waves / length_m));
        let of_bin = |samples: Vec<usize>| {
            if samples.iter().all(|&n| n > LAST_BIN) {
                return 0.0;
            }
            let known: f64 = samples.iter().map(|&n| c1d_m3(TAU * n as f64 / length_m)).sum();
            let seen: f64 = samples.iter().map(|&n| seen.in_fourier_bin(n)).sum();
            (seen / known).ln()
        };
        self.samples_of(bins, recipe.bins_per_decade).into_iter().map(of_bin).collect()
    }
}

/// Waves of a surface on both sides of wavevector 0, in waves per length of the scan.
struct SeenWaves {
    waves: Vec<Wave>,
}

struct Wave {
    number: f64,
    c1d_m3: f64,
    /// Slope of the trend of a wave of amplitude 1 \[amplitude per length\], times -i.
    slope: f64,
    /// Share of its power that has the same trend in all lines of the map; 1 for a line.
    shared: f64,
}

impl SeenWaves {
    fn new(scan: &ScanSpectrum, c1d_m3: impl Fn(f64) -> f64) -> Self {
        let count = ((LAST_BIN as f64 + REACH) / STEP) as i32;
        let exponent = (c1d_m3(1.0) / c1d_m3(2.0)).log2();
        let aspect = scan
            .spectrum
            .spacing_m
            .map_or(0.0, |spacing_m| (scan.spectrum.lines - 1) as f64 * spacing_m / scan.spectrum.length_m);
        let wave = |at: i32| {
            let number = (f64::from(at) + 0.5) * STEP;
            let shared = match scan.preparation.detrend {
                Detrend::Mean => 0.0,
                Detrend::Line => 1.0,
                Detrend::Plane => shared_across(number.abs() * aspect, exponent),
            };
            Wave {
                number,
                c1d_m3: c1d_m3(number.abs()),
                slope: -12.0 * sinc_derivative(TAU * number),
                shared,
            }
        };
        SeenWaves { waves: (-count..count).map(wave).collect() }
    }

    /// Computes the expected C1D of the Fourier bin n, the sum over the waves of their power times that of the bin's
    /// transform of a wave.
    fn in_fourier_bin(&self, n: usize) -> f64 {
        let n = n as f64;
        // The transform of the coordinate, divided by i.
        let of_slope = hann_derivative(TAU * n);
        let of_wave = |wave: &Wave| {
            let whole = hann(TAU * (wave.number - n));
            // i D times i X: both are imaginary.
            let detrended = whole + wave.slope * of_slope;
            wave.c1d_m3 * ((1.0 - wave.shared) * whole * whole + wave.shared * detrended * detrended)
        };
        let near = |wave: &&Wave| wave.number.abs() < n + REACH;
        STEP * self.waves.iter().filter(near).map(of_wave).sum::<f64>()
    }
}

/// Mean of sinc^2 of the wavevector across the lines over the waves of an isotropic surface with this wavevector along
/// them, in waves per width of the map; C1D is q^-exponent.
fn shared_across(waves: f64, exponent: f64) -> f64 {
    const RATIO_PER_STEP: f64 = 1.1;
    // From waves across the lines of a hundredth of those along them, and all below, up to a hundred times as many.
    let (mut across, last) = (0.01 * waves, 100.0 * waves);
    let (mut shared, mut all) = (across / RATIO_PER_STEP.ln(), across / RATIO_PER_STEP.ln());
    while across < last {
        let weight = across * (1.0 + (across / waves).powi(2)).powf(-0.5 * (exponent.max(0.0) + 1.0));
        shared += weight * sinc(TAU * across).powi(2);
        all += weight;
        across *= RATIO_PER_STEP;
    }
    if all > 0.0 { shared / all } else { 1.0 }
}

/// sin(s/2)/(s/2), the transform of a scan of length 1 about its middle.
fn sinc(s: f64) -> f64 {
    let half = 0.5 * s;
    if half.abs() < 1e-4 { 1.0 - half * half / 6.0 } else { half.sin() / half }
}

fn sinc_derivative(s: f64) -> f64 {
    let half = 0.5 * s;
    if half.abs() < 1e-3 { -s / 12.0 } else { 0.5 * (half.cos() * half - half.sin()) / (half * half) }
}

/// Amplitude of the Hann window in three harmonics, with mean square 1.
fn harmonics(s: f64, of: fn(f64) -> f64) -> f64 {
    (2.0 / 3.0f64).sqrt() * (of(s) + 0.5 * (of(s - 2.0 * PI) + of(s + 2.0 * PI)))
}

fn hann(s: f64) -> f64 {
    harmonics(s, sinc)
}

fn hann_derivative(s: f64) -> f64 {
    harmonics(s, sinc_derivative)
}
