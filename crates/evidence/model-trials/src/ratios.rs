//! Every model over boundary elements: `docs/guide/which-model/ratios.csv`.

use serde::Serialize;

use crate::TrialError;
use crate::elements::{ElementsRow, digits};
use crate::models::areas;
use crate::spectra::{TrialLoad, WaveBand};

/// A model beside boundary elements on the same spectrum under the same load.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RatioRow {
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
    /// The model.
    pub model: String,
    /// Its area over nominal area.
    pub area_fraction: f64,
    /// That of boundary elements.
    pub judged: f64,
    /// The one over the other.
    pub ratio: f64,
    /// Standard error of the ratio.
    pub standard_error: f64,
}

/// A row for every spectrum, load and model.
///
/// # Errors
/// Where a model cannot be asked.
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
    Ok(parallel::try_map(&bands, of_band)?.into_iter().flatten().collect())
}
