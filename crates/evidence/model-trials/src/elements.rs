//! The table of what boundary elements gave, kept in the repository: `docs/guide/which-model/elements.csv`.

use std::io::{Read, Write};

use serde::{Deserialize, Serialize};

use crate::TrialError;
use crate::pressing::{Pressed, pressed};
use crate::programme::Trial;
use crate::spectra::{TrialLoad, WaveBand};

/// A row of the table: a spectrum, a load, and what boundary elements gave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ElementsRow {
    /// Hurst exponent.
    pub hurst_exponent: f64,
    /// The longest wavelength, as waves per box.
    pub first_wave: f64,
    /// The roll-off, as waves per box.
    pub rolloff_wave: f64,
    /// The shortest wavelength, as waves per box.
    pub last_wave: f64,
    /// Nayak's alpha = m0 m4/m2^2.
    pub alpha: f64,
    /// p/(E* h').
    pub pressure_over_gradient: f64,
    /// s/H; empty where elastic.
    pub spread_over_hardness: Option<f64>,
    /// Area over nominal area, extrapolated from two grids where the coarser resolves the shortest wavelength.
    pub area_fraction: f64,
    /// The same on the finer grid, corrected by its perimeter.
    pub area_fraction_corrected: f64,
    /// Plastic area over nominal area.
    pub plastic_area_fraction: f64,
    /// Standard error of `area_fraction` from the scatter of the surfaces, widened as Student's distribution is.
    pub standard_error: f64,
    /// That of `plastic_area_fraction`.
    pub plastic_standard_error: f64,
    /// Surfaces pressed.
    pub realisations: u64,
    /// Points along a side of the finer grid.
    pub grid: usize,
}

impl ElementsRow {
    /// Its spectrum.
    #[must_use]
    pub fn band(&self) -> WaveBand {
        let Self { hurst_exponent, first_wave, rolloff_wave, last_wave, .. } = *self;
        WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave }
    }

    /// Its load.
    #[must_use]
    pub fn load(&self) -> TrialLoad {
        TrialLoad {
            pressure_over_gradient: self.pressure_over_gradient,
            spread_over_hardness: self.spread_over_hardness,
        }
    }

    /// Standard error over the area, with what the grid leaves in quadrature: 0.7 % (`docs/guide/judge.md`), or half of
    /// what the step to finer grids changes where that is more, as it is where contacts are a few points wide.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        let step = (self.area_fraction_corrected / self.area_fraction - 1.0).abs();
        (self.standard_error / self.area_fraction).hypot(GRID_REST.max(0.5 * step))
    }
}

/// What is left of an area's error on the grid, relative.
const GRID_REST: f64 = 0.007;

/// Presses a trial.
///
/// # Errors
/// What kept a surface from being made or pressed.
pub fn rows_of(trial: &Trial) -> Result<Vec<ElementsRow>, TrialError> {
    let alpha = trial.band.alpha()?;
    let WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave } = trial.band;
    let row = |pressed: &Pressed| ElementsRow {
        hurst_exponent,
        first_wave,
        rolloff_wave,
        last_wave,
        alpha: digits(alpha),
        pressure_over_gradient: pressed.load.pressure_over_gradient,
        spread_over_hardness: pressed.load.spread_over_hardness,
        area_fraction: digits(pressed.area.value),
        area_fraction_corrected: digits(pressed.corrected.value),
        plastic_area_fraction: digits(pressed.plastic.value),
        standard_error: digits(pressed.area.standard_error),
        plastic_standard_error: digits(pressed.plastic.standard_error),
        realisations: trial.realisations,
        grid: trial.grid,
    };
    Ok(pressed(trial)?.iter().map(row).collect())
}

/// The rows of a trial in a table, where it has all of them as the trial would make them.
#[must_use]
pub fn known<'r>(table: &'r [ElementsRow], trial: &Trial) -> Option<Vec<&'r ElementsRow>> {
    let same = |row: &&ElementsRow| {
        row.band() == trial.band && row.grid == trial.grid && row.realisations == trial.realisations
    };
    trial.loads.iter().map(|load| table.iter().filter(same).find(|row| row.load() == *load)).collect()
}

/// Reads a table, a row per record.
///
/// # Errors
/// Where it is not one.
pub fn read<R: serde::de::DeserializeOwned>(from: impl Read) -> Result<Vec<R>, TrialError> {
    Ok(csv::Reader::from_reader(from).deserialize().collect::<Result<_, _>>()?)
}

/// Writes a table, a row per record.
///
/// # Errors
/// What stopped the writing.
pub fn write<R: Serialize>(rows: &[R], to: impl Write) -> Result<(), TrialError> {
    let mut writer = csv::Writer::from_writer(to);
    for row in rows {
        writer.serialize(row)?;
    }
    Ok(writer.flush().map_err(csv::Error::from)?)
}

/// Five digits: more than any of the errors leaves.
#[must_use]
pub fn digits(value: f64) -> f64 {
    format!("{value:.4e}").parse().unwrap_or(value)
}
