//! Programme of the study: spectra, grids, numbers of surfaces, and loads.

use crate::spectra::{TrialLoad, WaveBand};

/// Hurst exponents.
const HURST_EXPONENTS: [f64; 3] = [0.3, 0.5, 0.8];

/// Loads p/(E* h') of all spectra.
const PRESSURES: [f64; 6] = [0.003, 0.01, 0.04, 0.15, 0.4, 0.9];

/// Loads p/(E* h') of the widest bands; at lighter ones a few surfaces with a single longest wave scatter too much.
const WIDEST_PRESSURES: [f64; 4] = [0.01, 0.04, 0.15, 0.4];

/// Loads p/(E* h') of one decade.
const DECADE_PRESSURES: [f64; 14] =
    [0.001, 0.003, 0.006, 0.01, 0.02, 0.04, 0.07, 0.11, 0.15, 0.25, 0.4, 0.6, 0.9, 1.4];

/// Ratios s/H with a hardness.
pub const SPREADS_OVER_HARDNESS: [f64; 3] = [0.5, 1.0, 1.7];
/// Loads p/(E* h') with a hardness, below all of those hardnesses.
const HARD_PRESSURES: [f64; 3] = [0.01, 0.04, 0.15];

/// Spectrum with its grid and its loads.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectrumTrial {
    /// Spectrum of the surfaces.
    pub band: WaveBand,
    /// Number of points along a side of the finer grid.
    pub grid: usize,
    /// Number of surfaces.
    pub realisations: u64,
    /// Loads on the surfaces.
    pub loads: Vec<TrialLoad>,
}

/// All trials, the quick ones first.
#[must_use]
pub fn programme() -> Vec<SpectrumTrial> {
    let mut trials = Vec::new();
    let mut add = |hurst_exponents: &[f64], waves: [f64; 3], grid: usize, realisations: u64, loads: Loads| {
        let [first_wave, rolloff_wave, last_wave] = waves;
        trials.extend(hurst_exponents.iter().map(|&hurst_exponent| {
            let band = WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave };
            let mut all: Vec<TrialLoad> = loads.pressures.iter().copied().map(TrialLoad::elastic).collect();
            if loads.hard.contains(&hurst_exponent) {
                all.extend(HARD_PRESSURES.iter().flat_map(|&pressure_over_gradient| {
                    SPREADS_OVER_HARDNESS
                        .map(|ratio| TrialLoad { pressure_over_gradient, spread_over_hardness: Some(ratio) })
                }));
            }
            SpectrumTrial { band, grid, realisations, loads: all }
        }));
    };
    let elastic = Loads { pressures: &PRESSURES, hard: &[] };
    add(&[0.8], [12.0, 12.0, 16.0], 256, 12, elastic);
    add(&HURST_EXPONENTS, [8.0, 8.0, 32.0], 256, 8, elastic);
    let decade = Loads { pressures: &DECADE_PRESSURES, hard: &[0.8] };
    add(&HURST_EXPONENTS, [4.0, 4.0, 40.0], 256, 12, decade);
    add(&HURST_EXPONENTS, [3.0, 10.0, 30.0], 256, 8, elastic);
    add(&HURST_EXPONENTS, [2.0, 2.0, 64.0], 512, 6, Loads { hard: &HURST_EXPONENTS, ..elastic });
    add(&HURST_EXPONENTS, [2.0, 6.0, 64.0], 512, 6, elastic);
    add(&HURST_EXPONENTS, [1.0, 1.0, 100.0], 256, 12, Loads { hard: &[0.8], ..elastic });
    add(&HURST_EXPONENTS, [1.0, 4.0, 100.0], 256, 8, elastic);
    add(&HURST_EXPONENTS, [1.0, 1.0, 316.0], 800, 4, Loads { pressures: &WIDEST_PRESSURES, ..elastic });
    trials
}

/// Loads of a spectrum: p/(E* h') if it is elastic, and the Hurst exponents that are pressed with hardnesses too.
#[derive(Clone, Copy)]
struct Loads<'l> {
    pressures: &'l [f64],
    hard: &'l [f64],
}
