//! The spectrum of one scan in the bins of a composite.

use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{Bin, BinMean, bin_index, log_bins};
use crate::degrees_of_freedom::degrees_of_freedom;
use crate::scan_spectrum::ScanSpectrum;

/// The spectrum of a scan in one bin.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanBin {
    /// Index j of the bin 10^(j/N) <= q < 10^((j + 1)/N) in rad/m.
    pub index: i64,
    /// Geometric mean of the wavelengths of the samples in the bin \[m\].
    pub wavelength_m: f64,
    /// Mean C1D of the samples \[m^3\].
    pub c1d_m3: f64,
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
            degrees_of_freedom: None,
            parts_m3: Vec::new(),
        }
    }
}

impl ScanSpectrum {
    /// Averages the reliable part of the spectrum in bins.
    #[must_use]
    pub fn in_bins(&self, bins_per_decade: NonZeroU32) -> Vec<ScanBin> {
        let mut bins: Vec<ScanBin> = log_bins(&self.reliable, bins_per_decade, BinMean::Arithmetic)
            .into_iter()
            .map(ScanBin::from)
            .collect();
        let of_bins = self.samples_of(&bins, bins_per_decade);
        for (bin, samples) in bins.iter_mut().zip(of_bins) {
            let (count, spectrum) = (samples.len() as f64, &self.spectrum);
            let lines = samples.iter().map(|&n| spectrum.independent_lines(n)).sum::<f64>() / count;
            bin.degrees_of_freedom = Some(degrees_of_freedom(samples.len(), lines, self.preparation.window));
            let mean = |c1d_m3: &Vec<f64>| samples.iter().map(|&n| c1d_m3[n - 1]).sum::<f64>() / count;
            bin.parts_m3 = spectrum.parts_m3.iter().map(mean).collect();
        }
        bins
    }

    /// Lists for every bin the numbers n >= 1 of its reliable samples.
    pub(crate) fn samples_of(&self, bins: &[ScanBin], bins_per_decade: NonZeroU32) -> Vec<Vec<usize>> {
        let mut samples = vec![Vec::new(); bins.len()];
        let length_m = self.spectrum.length_m;
        for &wavelength_m in self.reliable.wavelengths_m() {
            let index = bin_index(std::f64::consts::TAU / wavelength_m, bins_per_decade);
            if let Ok(at) = bins.binary_search_by_key(&index, |bin| bin.index) {
                samples[at].push((length_m / wavelength_m).round().max(1.0) as usize);
            }
        }
        samples
    }
}
