//! The spectrum of one scan in the bins of a composite.

use std::f64::consts::TAU;
use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{Bin, BinMean, bin_index, log_bins, wavevector_in_bin};
use crate::degrees_of_freedom::degrees_of_freedom;
use crate::kept_moments::{Holdings, split};
use crate::narrow_lines::Peak;
use crate::scan_spectrum::ScanSpectrum;

/// The spectrum of a scan in one bin.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanBin {
    /// Index j of the bin 10^(j/N) <= q < 10^((j + 1)/N) in rad/m.
    pub index: i64,
    /// Wavelength at which the bin stands \[m\]: the geometric mean of its samples; with a narrow line, where its variance
    /// would have the same slope. The first and the last bin stand at the ends of the band.
    pub wavelength_m: f64,
    /// Mean C1D of the samples \[m^3\]; for the first and the last bin continued to the end of the band.
    pub c1d_m3: f64,
    /// C1D \[m^3\] of a level spectrum that holds what the samples hold about this bin: the mean of the samples weighted
    /// down to the neighbouring bins. `None` where the samples are not those of a scan.
    pub held_m3: Option<f64>,
    /// Degrees of freedom of the mean; `None` if nothing is known of the lines.
    pub degrees_of_freedom: Option<f64>,
    /// Mean C1D of each part of the map \[m^3\]; empty for a line.
    pub parts_m3: Vec<f64>,
}

impl From<Bin> for ScanBin {
    /// Takes a bin without degrees of freedom and parts.
    fn from(bin: Bin) -> Self {
        ScanBin {
            index: bin.index,
            wavelength_m: bin.wavelength_m,
            c1d_m3: bin.c1d_m3,
            held_m3: None,
            degrees_of_freedom: None,
            parts_m3: Vec::new(),
        }
    }
}

impl ScanSpectrum {
    /// Averages the reliable part of the spectrum in bins.
    #[must_use]
    pub fn in_bins(&self, bins_per_decade: NonZeroU32) -> Vec<ScanBin> {
        let found = log_bins(&self.reliable, bins_per_decade, BinMean::Arithmetic);
        let mut bins: Vec<ScanBin> = found.iter().cloned().map(ScanBin::from).collect();
        let of_bins = self.samples_of(&bins, bins_per_decade);
        let masses = self.masses();
        for ((bin, found), samples) in bins.iter_mut().zip(&found).zip(of_bins) {
            let (count, spectrum) = (samples.len() as f64, &self.spectrum);
            let lines = samples.iter().map(|&n| spectrum.independent_lines(n)).sum::<f64>() / count;
            let freedom = degrees_of_freedom(samples.len(), lines, self.preparation.window);
            let noisy_share = self.noisy_share(&samples);
            bin.degrees_of_freedom = Some(freedom / noisy_share.powi(2));
            if noisy_share < 1.0 {
                bin.wavelength_m = TAU / place(bin.index, &masses[found.samples.clone()], bins_per_decade);
            }
            let mean = |c1d_m3: &Vec<f64>| samples.iter().map(|&n| c1d_m3[n - 1]).sum::<f64>() / count;
            bin.parts_m3 = spectrum.parts_m3.iter().map(mean).collect();
        }
        if bins.len() > 1 {
            let last = bins.len() - 1;
            let ends_m = [self.reliable.longest_wavelength_m(), self.reliable.shortest_wavelength_m()];
            for (at, neighbour, end_m) in [(0, 1, ends_m[0]), (last, last - 1, ends_m[1])] {
                let of_neighbour = (bins[neighbour].wavelength_m, bins[neighbour].c1d_m3);
                bins[at].continue_to(end_m, of_neighbour);
            }
            let wavelengths_m: Vec<f64> = bins.iter().map(|bin| bin.wavelength_m).collect();
            let wavevectors: Vec<f64> = wavelengths_m.iter().map(|wavelength_m| TAU / wavelength_m).collect();
            let held = split(masses.into_iter(), &wavevectors);
            let of_level = Holdings::of_level(&wavelengths_m);
            let held_m3 = held.iter().zip(&of_level).map(|(held, of_level)| held / of_level);
            bins.iter_mut().zip(held_m3).for_each(|(bin, held_m3)| bin.held_m3 = Some(held_m3));
        }
        bins
    }

    /// Wavevector \[rad/m\] and C1D dq \[m^2\] of each reliable sample. The first and the last count half: the other half of
    /// their Fourier step lies beyond the band.
    pub(crate) fn masses(&self) -> Vec<(f64, f64)> {
        let step = TAU / self.spectrum.length_m;
        let wavevectors: Vec<f64> = self.reliable.wavelengths_m().iter().map(|m| TAU / m).collect();
        let half = |pair: Option<&[f64]>| pair.map_or(0.0, |pair| 0.5 * (pair[1] - pair[0]).min(step));
        let mass = |(at, c1d_m3): (usize, &f64)| {
            let before = half(at.checked_sub(1).map(|before| &wavevectors[before..=at]));
            (wavevectors[at], c1d_m3 * (before + half(wavevectors.get(at..at + 2))))
        };
        self.reliable.c1d_m3().iter().enumerate().map(mass).collect()
    }

    /// Share of the power of samples that scatters. Lines do not, up to a part in a thousand.
    fn noisy_share(&self, samples: &[usize]) -> f64 {
        let all_m3: f64 = samples.iter().map(|&n| self.spectrum.c1d_m3[n - 1]).sum();
        let of_line = |peak: &Peak| -> f64 {
            let is_here = |n: &usize| samples.binary_search(n).is_ok();
            let numbered = (peak.first..).zip(&peak.powers_m3);
            numbered.filter(|(n, _)| is_here(n)).map(|(_, power_m3)| power_m3).sum()
        };
        let of_lines_m3: f64 = self.peaks.iter().map(of_line).sum();
        (1.0 - of_lines_m3 / all_m3).max(1e-3)
    }

    /// Lists for every bin the numbers n >= 1 of its reliable samples.
    pub(crate) fn samples_of(&self, bins: &[ScanBin], bins_per_decade: NonZeroU32) -> Vec<Vec<usize>> {
        let mut samples = vec![Vec::new(); bins.len()];
        let length_m = self.spectrum.length_m;
        for &wavelength_m in self.reliable.wavelengths_m() {
            let index = bin_index(TAU / wavelength_m, bins_per_decade);
            if let Ok(at) = bins.binary_search_by_key(&index, |bin| bin.index) {
                samples[at].push((length_m / wavelength_m).round().max(1.0) as usize);
            }
        }
        samples
    }
}

/// Share of a bin at either edge in which none stands: two bins that hold one line between them stay apart.
const EDGE: f64 = 0.25;

/// Returns the wavevector \[rad/m\] at which samples of a bin stand, from their wavevectors and masses: that of their mean
/// square slope.
fn place(index: i64, masses: &[(f64, f64)], bins_per_decade: NonZeroU32) -> f64 {
    let [first, last] = [masses[0].0, masses[masses.len() - 1].0];
    let all: f64 = masses.iter().map(|(_, mass)| mass).sum();
    let mean_square = masses.iter().map(|(q, mass)| (q / last).powi(2) * (mass / all)).sum::<f64>();
    let edges = [EDGE, 1.0 - EDGE].map(|share| wavevector_in_bin(index, share, bins_per_decade));
    let middle = (last * mean_square.sqrt()).max(edges[0]).min(edges[1]);
    middle.clamp(first, last)
}

impl ScanBin {
    /// Moves the bin to the end of the band along the power law through its neighbour (wavelength \[m\], C1D \[m^3\]).
    fn continue_to(&mut self, end_m: f64, (neighbour_m, of_neighbour_m3): (f64, f64)) {
        /// Exponents of q of spectra of surfaces; lines have others.
        const EXPONENTS: [f64; 2] = [-4.0, 2.0];
        let exponent = (self.c1d_m3 / of_neighbour_m3).ln() / (neighbour_m / self.wavelength_m).ln();
        let exponent = exponent.clamp(EXPONENTS[0], EXPONENTS[1]);
        let factor = (self.wavelength_m / end_m).powf(exponent);
        self.wavelength_m = end_m;
        self.c1d_m3 *= factor;
        self.parts_m3.iter_mut().for_each(|part_m3| *part_m3 *= factor);
    }
}
