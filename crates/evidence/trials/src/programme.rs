//! Programme of the study: spectra, grids, numbers of surfaces, and loads.

use crate::spectra::{TrialLoad, WaveBand};

/// Hurst exponents.
pub const HURST_EXPONENTS: [f64; 3] = [0.3, 0.5, 0.8];

/// Loads p/(E* h') of all spectra.
pub const PRESSURES: [f64; 6] = [0.003, 0.01, 0.04, 0.15, 0.4, 0.9];

/// Loads p/(E* h') of the widest bands; at lighter ones a few surfaces with a single longest wave scatter too much.
pub const WIDEST_PRESSURES: [f64; 4] = [0.01, 0.04, 0.15, 0.4];

/// Loads p/(E* h') of one decade.
pub const DECADE_PRESSURES: [f64; 14] =
    [0.001, 0.003, 0.006, 0.01, 0.02, 0.04, 0.07, 0.11, 0.15, 0.25, 0.4, 0.6, 0.9, 1.4];

/// Ratios s/H with a hardness.
pub const SPREADS_OVER_HARDNESS: [f64; 3] = [0.5, 1.0, 1.7];
/// Loads p/(E* h') with a hardness, below all of those hardnesses.
pub const HARD_PRESSURES: [f64; 3] = [0.01, 0.04, 0.15];

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

/// One decade without a roll-off.
#[must_use]
pub fn one_decade(hurst_exponent: f64) -> WaveBand {
    WaveBand::fractal(hurst_exponent, 4.0, 40.0)
}

/// One and a half decades without a roll-off.
#[must_use]
pub fn one_and_a_half_decades(hurst_exponent: f64) -> WaveBand {
    WaveBand::fractal(hurst_exponent, 2.0, 64.0)
}

/// Two decades without a roll-off.
#[must_use]
pub fn two_decades(hurst_exponent: f64) -> WaveBand {
    WaveBand::fractal(hurst_exponent, 1.0, 100.0)
}

/// Widest bands.
#[must_use]
pub fn widest(hurst_exponent: f64) -> WaveBand {
    WaveBand::fractal(hurst_exponent, 1.0, 316.0)
}

/// All trials, the quick ones first.
#[must_use]
pub fn programme() -> Vec<SpectrumTrial> {
    let mut trials = vec![trial(WaveBand::fractal(0.8, 12.0, 16.0), 256, 12)];
    let mut of_each = |first: f64, rolloff: f64, last: f64, grid: usize, realisations: u64| {
        trials.extend(HURST_EXPONENTS.map(|hurst_exponent| {
            let band = WaveBand { hurst_exponent, first_wave: first, rolloff_wave: rolloff, last_wave: last };
            trial(band, grid, realisations)
        }));
    };
    of_each(8.0, 8.0, 32.0, 256, 8);
    of_each(4.0, 4.0, 40.0, 256, 12);
    of_each(3.0, 10.0, 30.0, 256, 8);
    of_each(2.0, 2.0, 64.0, 512, 6);
    of_each(2.0, 6.0, 64.0, 512, 6);
    of_each(1.0, 1.0, 100.0, 256, 12);
    of_each(1.0, 4.0, 100.0, 256, 8);
    of_each(1.0, 1.0, 316.0, 800, 4);
    trials
}

fn trial(band: WaveBand, grid: usize, realisations: u64) -> SpectrumTrial {
    let elastic = if band == one_decade(band.hurst_exponent) {
        &DECADE_PRESSURES[..]
    } else if band == widest(band.hurst_exponent) {
        &WIDEST_PRESSURES[..]
    } else {
        &PRESSURES[..]
    };
    let mut loads: Vec<TrialLoad> = elastic.iter().copied().map(TrialLoad::elastic).collect();
    if hardens(&band) {
        loads.extend(HARD_PRESSURES.iter().flat_map(|&pressure_over_gradient| {
            SPREADS_OVER_HARDNESS
                .map(|ratio| TrialLoad { pressure_over_gradient, spread_over_hardness: Some(ratio) })
        }));
    }
    SpectrumTrial { band, grid, realisations, loads }
}

/// Returns true if a spectrum is pressed with hardnesses too: one and a half decades of each exponent, and one and
/// two decades of 0.8.
fn hardens(band: &WaveBand) -> bool {
    *band == one_and_a_half_decades(band.hurst_exponent)
        || *band == one_decade(0.8)
        || *band == two_decades(0.8)
}
