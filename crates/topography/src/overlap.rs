//! Whether instruments agree where both measure.

use std::num::NonZeroU32;

use serde::Serialize;

use crate::bins::{BinMean, log_bins};
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
            let shared: Vec<_> = bins
                .iter()
                .filter_map(|bin| {
                    let at = others.binary_search_by_key(&bin.index, |other| other.index).ok()?;
                    Some((bin.wavelength_m, bin.c1d_m3 / others[at].c1d_m3))
                })
                .collect();
            if let (Some(longest), Some(shortest)) = (shared.first(), shared.last()) {
                let ratios: Vec<f64> = shared.iter().map(|&(_, ratio)| ratio).collect();
                overlaps.push(Overlap {
                    first,
                    second,
                    longest_m: longest.0,
                    shortest_m: shortest.0,
                    bins: shared.len(),
                    ratio: BinMean::Geometric.of(&ratios),
                });
            }
        }
    }
    overlaps
}
