//! Comparison of spectra in the bins that they share.

use std::collections::BTreeMap;
use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{Bin, BinMean, log_bins};
use spectrum::ProfilePsd;

/// Comparison of two measurements in their shared bins.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Overlap {
    /// Index of the earlier measurement.
    pub first: usize,
    /// Index of the later measurement.
    pub second: usize,
    /// Longest shared wavelength \[m\].
    pub longest_m: f64,
    /// Shortest shared wavelength \[m\].
    pub shortest_m: f64,
    /// Number of shared bins, at least 1.
    pub bins: usize,
    /// Geometric mean over the shared bins of the first spectrum over the second; 1 if they agree.
    pub ratio: f64,
}

/// Compares every pair of measurements that share a bin, in the order of the list. Of more than
/// 20 measurements, those that lie highest and lowest against the mean are compared, as differ most.
///
/// Samples are averaged inside the bins arithmetically, as in [`composite`](crate::composite()).
pub fn overlaps(measurements: &[ProfilePsd], bins_per_decade: NonZeroU32) -> Vec<Overlap> {
    let binned: Vec<_> = measurements
        .iter()
        .map(|measurement| log_bins(measurement, bins_per_decade, BinMean::Arithmetic))
        .collect();
    let compared = extremes(&binned);
    let mut overlaps = Vec::new();
    for (at, &first) in compared.iter().enumerate() {
        for &second in &compared[at + 1..] {
            let shared = shared_bins(&binned[first], &binned[second]);
            if let (Some(longest), Some(shortest)) = (shared.first(), shared.last()) {
                overlaps.push(Overlap {
                    first,
                    second,
                    longest_m: longest.wavelength_m,
                    shortest_m: shortest.wavelength_m,
                    bins: shared.len(),
                    ratio: mean_ratio(&shared),
                });
            }
        }
    }
    overlaps
}

/// Most measurements of which every pair is compared; the number of pairs grows with the square.
const MOST_COMPARED: usize = 20;

/// Indices of the measurements to compare, in the order of the list.
fn extremes(binned: &[Vec<Bin>]) -> Vec<usize> {
    let mut compared: Vec<usize> = (0..binned.len()).collect();
    if compared.len() > MOST_COMPARED {
        let mut sums: BTreeMap<i64, [f64; 2]> = BTreeMap::new();
        for bin in binned.iter().flatten() {
            let sum = sums.entry(bin.index).or_default();
            *sum = [sum[0] + bin.c1d_m3.ln(), sum[1] + 1.0];
        }
        let above = |bin: &Bin| bin.c1d_m3.ln() - sums[&bin.index][0] / sums[&bin.index][1];
        let mean = |bins: &Vec<Bin>| bins.iter().map(above).sum::<f64>() / bins.len().max(1) as f64;
        let heights: Vec<f64> = binned.iter().map(mean).collect();
        compared.sort_by(|a, b| heights[*a].total_cmp(&heights[*b]));
        compared.drain(MOST_COMPARED / 2..binned.len() - MOST_COMPARED / 2);
        compared.sort_unstable();
    }
    compared
}

/// Units of heights that people mix up, with the factor between them.
const MIXED_UNITS: [(&str, f64); 2] = [("nm and µm", 1e3), ("nm and mm", 1e6)];
/// Ratio of heights to such a factor, either way, below which the factor explains it.
const NEAR_A_FACTOR: f64 = 3.0;

/// Returns the units that explain two spectra of this ratio, which is that of heights squared, if they were mixed up.
pub(crate) fn mixed_units(ratio: f64) -> Option<&'static str> {
    let heights = ratio.ln().abs() / 2.0;
    let explains = |factor: f64| (heights - factor.ln()).abs() < NEAR_A_FACTOR.ln();
    MIXED_UNITS.into_iter().find(|(_, factor)| explains(*factor)).map(|(units, _)| units)
}

/// Ratio of two spectra in a shared bin.
#[derive(Clone, Copy)]
pub(crate) struct SharedBin {
    /// Wavelength of the first spectrum \[m\].
    pub(crate) wavelength_m: f64,
    /// Ratio of the first to the second spectrum.
    pub(crate) ratio: f64,
}

/// Lists the bins that both spectra reach, from long to short wavelengths.
pub(crate) fn shared_bins(bins: &[Bin], others: &[Bin]) -> Vec<SharedBin> {
    let shared = |bin: &Bin| {
        let at = others.binary_search_by_key(&bin.index, |other| other.index).ok()?;
        Some(SharedBin { wavelength_m: bin.wavelength_m, ratio: bin.c1d_m3 / others[at].c1d_m3 })
    };
    bins.iter().filter_map(shared).collect()
}

/// Computes the geometric mean of the ratios of at least one bin.
pub(crate) fn mean_ratio(shared: &[SharedBin]) -> f64 {
    let ratios: Vec<f64> = shared.iter().map(|bin| bin.ratio).collect();
    BinMean::Geometric.mean(&ratios)
}

/// Ratio of the spectra along x and y from which a surface is not isotropic.
pub(crate) const DIRECTIONS_DIFFER: f64 = 1.5;

/// Smallest number of shared bins that can show anisotropy; in fewer, the few waves of a map scatter as much.
const LEAST_DECADE_BINS: usize = 3;

/// The spectra of a map along y and x, compared in one decade of wavelengths.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DirectionRatio {
    /// Longest shared wavelength in the decade \[m\].
    pub longest_m: f64,
    /// Shortest shared wavelength in the decade \[m\].
    pub shortest_m: f64,
    /// Number of shared bins, at least 1.
    pub bins: usize,
    /// Geometric mean over the shared bins of the spectrum along y over that along x.
    pub ratio: f64,
}

impl DirectionRatio {
    /// Returns true if the decade shows an anisotropic surface, or lines offset against each other.
    #[must_use]
    pub fn is_anisotropic(&self) -> bool {
        self.bins >= LEAST_DECADE_BINS && self.ratio.ln().abs() >= DIRECTIONS_DIFFER.ln()
    }

    /// Compares the spectra decade by decade, from long to short wavelengths; empty without shared bins.
    pub(crate) fn per_decade(x: &ProfilePsd, y: &ProfilePsd, bins_per_decade: NonZeroU32) -> Vec<Self> {
        let binned = |psd| log_bins(psd, bins_per_decade, BinMean::Arithmetic);
        let decade = |wavelength_m: f64| wavelength_m.log10().floor();
        let shared = shared_bins(&binned(y), &binned(x));
        let decades = shared.chunk_by(|a, b| decade(a.wavelength_m) == decade(b.wavelength_m));
        let of_decade = |bins: &[SharedBin]| Self {
            longest_m: bins[0].wavelength_m,
            shortest_m: bins[bins.len() - 1].wavelength_m,
            bins: bins.len(),
            ratio: mean_ratio(bins),
        };
        decades.map(of_decade).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ratio_of_spectra_is_that_of_heights_squared() {
        for (ratio, units) in [
            (1e6, Some("nm and µm")),
            (4e-6, Some("nm and µm")),
            (1e12, Some("nm and mm")),
            (1e3, None),
            (1.0, None),
            (1e20, None),
        ] {
            assert_eq!(mixed_units(ratio), units, "{ratio}");
        }
    }
}
