//! Table of boundary-element results, kept in the repository: `docs/develop/trials/elements.csv`.

use std::io::{Read, Write};

use serde::{Deserialize, Serialize};

use crate::TrialError;
use crate::programme::SpectrumTrial;
use crate::spectra::{TrialLoad, WaveBand};

/// Row of the table: a spectrum, a load, and the result of boundary elements.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ElementsRow {
    /// Hurst exponent H.
    pub hurst_exponent: f64,
    /// Longest wavelength, in waves per box.
    pub first_wave: f64,
    /// Roll-off, in waves per box.
    pub rolloff_wave: f64,
    /// Shortest wavelength, in waves per box.
    pub last_wave: f64,
    /// Nayak's alpha = m0 m4/m2^2.
    pub alpha: f64,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Spread over hardness s/H; empty for elastic contact.
    pub spread_over_hardness: Option<f64>,
    /// Area over nominal area, extrapolated from two grids if the coarser resolves the shortest wavelength.
    pub area_fraction: f64,
    /// Area fraction on the finer grid, corrected by its perimeter.
    pub area_fraction_corrected: f64,
    /// Plastic area over nominal area.
    pub plastic_area_fraction: f64,
    /// Standard error of `area_fraction` from the scatter of the surfaces, widened by Student's distribution.
    pub standard_error: f64,
    /// Standard error of `plastic_area_fraction`.
    pub plastic_standard_error: f64,
    /// Number of surfaces.
    pub realisations: u64,
    /// Number of points along a side of the finer grid.
    pub grid: usize,
}

impl ElementsRow {
    /// Spectrum of the row.
    #[must_use]
    pub fn band(&self) -> WaveBand {
        let Self { hurst_exponent, first_wave, rolloff_wave, last_wave, .. } = *self;
        WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave }
    }

    /// Load of the row.
    #[must_use]
    pub fn load(&self) -> TrialLoad {
        TrialLoad {
            pressure_over_gradient: self.pressure_over_gradient,
            spread_over_hardness: self.spread_over_hardness,
        }
    }

    /// Relative standard error of the area, with the error of the grid added in quadrature: 0.7 % (`docs/guide/judge.md`),
    /// or half of the step to finer grids if that is more, as it is for contacts a few points wide.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        let step = (self.area_fraction_corrected / self.area_fraction - 1.0).abs();
        (self.standard_error / self.area_fraction).hypot(GRID_REST.max(0.5 * step))
    }
}

/// Relative error of an area left by the grid.
const GRID_REST: f64 = 0.007;

/// Rows of a trial in a table; `None` unless the table has all of them as the trial would make them.
#[must_use]
pub fn known<'r>(table: &'r [ElementsRow], trial: &SpectrumTrial) -> Option<Vec<&'r ElementsRow>> {
    let same = |row: &&ElementsRow| {
        row.band() == trial.band && row.grid == trial.grid && row.realisations == trial.realisations
    };
    trial.loads.iter().map(|load| table.iter().filter(same).find(|row| row.load() == *load)).collect()
}

/// Reads a table, a row per record.
///
/// # Errors
/// The error of reading.
pub fn read<R: serde::de::DeserializeOwned>(from: impl Read) -> Result<Vec<R>, TrialError> {
    Ok(csv::Reader::from_reader(from).deserialize().collect::<Result<_, _>>()?)
}

/// Writes a table, a row per record.
///
/// # Errors
/// The error of writing.
pub fn write<R: Serialize>(rows: &[R], to: impl Write) -> Result<(), TrialError> {
    let mut writer = csv::Writer::from_writer(to);
    for row in rows {
        writer.serialize(row)?;
    }
    Ok(writer.flush().map_err(csv::Error::from)?)
}

/// Rounds to five digits: more than the errors justify.
#[must_use]
pub fn digits(value: f64) -> f64 {
    format!("{value:.4e}").parse().unwrap_or(value)
}
