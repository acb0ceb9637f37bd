//! Ratios of every model to boundary elements: `docs/develop/trials/ratios.csv`.

use serde::{Deserialize, Serialize};

use crate::TrialError;
use crate::elements::{ElementsRow, digits};
use crate::models::areas;
use crate::spectra::{TrialLoad, WaveBand};

/// Model compared with boundary elements on the same spectrum under the same load.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct RatioRow {
    /// Hurst exponent.
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
    /// Name of the model.
    pub model: String,
    /// Area fraction of the model.
    pub area_fraction: f64,
    /// Area fraction of boundary elements.
    pub judged: f64,
    /// Ratio of the model's area to that of boundary elements.
    pub ratio: f64,
    /// Standard error of the ratio.
    pub standard_error: f64,
}

/// Computes a row for every spectrum, load and model.
///
/// # Errors
/// The error of running a model.
pub fn rows(elements: &[ElementsRow]) -> Result<Vec<RatioRow>, TrialError> {
    let mut bands: Vec<WaveBand> = Vec::new();
    for row in elements {
        if !bands.contains(&row.band()) {
            bands.push(row.band());
        }
    }
    let of_band = |band: &WaveBand| -> Result<Vec<RatioRow>, TrialError> {
        let judged: Vec<&ElementsRow> = elements.iter().filter(|row| row.band() == *band).collect();
        let loads: Vec<TrialLoad> = judged.iter().map(|row| row.load()).collect();
        let of_model = |found: crate::models::ModelArea| {
            let judged = judged[found.load];
            let ratio = found.area_fraction / judged.area_fraction;
            RatioRow {
                hurst_exponent: judged.hurst_exponent,
                first_wave: judged.first_wave,
                rolloff_wave: judged.rolloff_wave,
                last_wave: judged.last_wave,
                alpha: judged.alpha,
                pressure_over_gradient: judged.pressure_over_gradient,
                spread_over_hardness: judged.spread_over_hardness,
                model: found.model,
                area_fraction: digits(found.area_fraction),
                judged: judged.area_fraction,
                ratio: digits(ratio),
                standard_error: digits(ratio * judged.relative_error()),
            }
        };
        Ok(areas(&band.spectrum()?, &loads)?.into_iter().map(of_model).collect())
    };
    Ok(numerics::parallel::try_map(&bands, of_band)?.into_iter().flatten().collect())
}
