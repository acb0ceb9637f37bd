//! Whether instruments agree where both measure.

use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{Bin, BinMean, log_bins};
use spectrum::ProfilePsd;

/// The spectra of two measurements in the bins that both reach.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Overlap {
    /// Which measurement comes first in the list, counted from 0.
    pub first: usize,
    /// Which other one.
    pub second: usize,
    /// Longest wavelength in m of the bins both reach.
    pub longest_m: f64,
    /// Shortest.
    pub shortest_m: f64,
    /// How many bins both reach, at least 1.
    pub bins: usize,
    /// Geometric mean over these bins of the spectrum of the first over that of the second; 1 where they agree.
    pub ratio: f64,
}

/// Every pair of measurements that share a bin, in the order of the list.
///
/// Samples are averaged inside the bins arithmetically, as in [`composite`](crate::composite()).
pub fn overlaps(measurements: &[ProfilePsd], bins_per_decade: NonZeroU32) -> Vec<Overlap> {
    let binned: Vec<_> = measurements
        .iter()
        .map(|measurement| log_bins(measurement, bins_per_decade, BinMean::Arithmetic))
        .collect();
    let mut overlaps = Vec::new();
    for (first, bins) in binned.iter().enumerate() {
        for (second, others) in binned.iter().enumerate().skip(first + 1) {
            let shared = shared_bins(bins, others);
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

/// Two spectra in a bin that both reach.
#[derive(Clone, Copy)]
pub(crate) struct SharedBin {
    /// The wavelength of the first in m.
    pub(crate) wavelength_m: f64,
    /// The first over the second.
    pub(crate) ratio: f64,
}

/// The bins that both spectra reach, from long to short wavelengths.
pub(crate) fn shared_bins(bins: &[Bin], others: &[Bin]) -> Vec<SharedBin> {
    let shared = |bin: &Bin| {
        let at = others.binary_search_by_key(&bin.index, |other| other.index).ok()?;
        Some(SharedBin { wavelength_m: bin.wavelength_m, ratio: bin.c1d_m3 / others[at].c1d_m3 })
    };
    bins.iter().filter_map(shared).collect()
}

/// The geometric mean of their ratios, of one bin at least.
pub(crate) fn mean_ratio(shared: &[SharedBin]) -> f64 {
    let ratios: Vec<f64> = shared.iter().map(|bin| bin.ratio).collect();
    BinMean::Geometric.of(&ratios)
}
