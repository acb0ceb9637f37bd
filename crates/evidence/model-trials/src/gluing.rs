//! Gluing of two decades from single ones, compared with both pressed at once: `docs/guide/which-model/gluing.csv`.
//!
//! A(p) = Int P_ab(sigma) A_bc(sigma) d sigma, with P_ab the pressures on the first decade and A_bc the area of the
//! second under a uniform pressure.

use serde::{Deserialize, Serialize};

use crate::TrialError;
use crate::elements::{ElementsRow, digits};
use crate::pressing::contact;
use crate::programme::{HURST_EXPONENTS, one_decade, two_decades};
use crate::spectra::{BOX_M, CONTACT_MODULUS_PA, RMS_GRADIENT, TrialLoad, WaveBand};
use crate::statistics::Mean;
use crate::window_law::WindowLaw;

/// Number of surfaces of the first decade.
const REALISATIONS: u64 = 6;
const GRIDS: [usize; 2] = [256, 128];

/// Result of gluing two decades.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GluingRow {
    /// Hurst exponent.
    pub hurst_exponent: f64,
    /// Load p/(E* h') of both decades.
    pub pressure_over_gradient: f64,
    /// Glued area.
    pub glued: f64,
    /// Standard error of the glued area.
    pub glued_standard_error: f64,
}

/// First of the two decades, with two of its longest waves along a side.
fn first_decade(hurst_exponent: f64) -> WaveBand {
    WaveBand::fractal(hurst_exponent, 2.0, 20.0)
}

/// Computes a row for every load on two decades.
///
/// # Errors
/// The error of making or pressing a surface.
pub fn rows(elements: &[ElementsRow]) -> Result<Vec<GluingRow>, TrialError> {
    let mut rows = Vec::new();
    for hurst_exponent in HURST_EXPONENTS {
        let band = two_decades(hurst_exponent);
        let Some(law) = WindowLaw::from_elements(elements, &one_decade(hurst_exponent)) else { continue };
        let seam_m = 0.1 * BOX_M / band.first_wave;
        let spectrum = band.spectrum()?;
        let long = spectrum.cut(BOX_M / band.first_wave, seam_m)?.mean_square_gradient().sqrt();
        let short = spectrum.cut(seam_m, BOX_M / band.last_wave)?.mean_square_gradient().sqrt();
        for row in elements.iter().filter(|row| row.band() == band && row.spread_over_hardness.is_none()) {
            let on_first = TrialLoad::elastic(row.pressure_over_gradient * (RMS_GRADIENT / long));
            // The first decade is pressed at the gradient of all trials; the second adds its own.
            let unit_pa = CONTACT_MODULUS_PA * RMS_GRADIENT * (short / long);
            let glued = |number: &u64| -> Result<f64, TrialError> {
                let on_grid = |grid: usize| -> Result<f64, TrialError> {
                    let pressures_pa =
                        contact(&first_decade(hurst_exponent), grid, *number, &on_first)?.pressures_pa;
                    let pressed = pressures_pa.iter().filter(|&&pressure_pa| pressure_pa > 0.0);
                    let sum: f64 = pressed.map(|pressure_pa| law.area_fraction(pressure_pa / unit_pa)).sum();
                    Ok(sum / pressures_pa.len() as f64)
                };
                // The error at the edges of contacts is of first order in the spacing.
                Ok(2.0 * on_grid(GRIDS[0])? - on_grid(GRIDS[1])?)
            };
            let numbers: Vec<u64> = (0..REALISATIONS).collect();
            let glued = Mean::new(numerics::parallel::try_map(&numbers, glued)?.into_iter());
            rows.push(GluingRow {
                hurst_exponent,
                pressure_over_gradient: row.pressure_over_gradient,
                glued: digits(glued.value),
                glued_standard_error: digits(glued.standard_error),
            });
        }
    }
    Ok(rows)
}

/// Relative error of the glued area against both pressed at once, and its standard error.
#[must_use]
pub fn error_of(row: &GluingRow, elements: &[ElementsRow]) -> Option<(f64, f64)> {
    let whole = elements.iter().find(|whole| {
        whole.band() == two_decades(row.hurst_exponent)
            && whole.load() == TrialLoad::elastic(row.pressure_over_gradient)
    })?;
    let error = whole.relative_error().hypot(row.glued_standard_error / row.glued);
    Some((row.glued / whole.area_fraction - 1.0, error))
}
