//! Test of the judge's assumption that the error of a contact law on a wide band lies within its errors on the
//! windows of that band (`docs/guide/judge.md`): `docs/guide/which-model/windows.csv`.

use serde::Serialize;

use crate::TrialError;
use crate::elements::{ElementsRow, digits};
use crate::models::areas;
use crate::programme::{HURST_EXPONENTS, one_and_a_half_decades, one_decade, two_decades, widest};
use crate::spectra::{BOX_M, RMS_GRADIENT, TrialLoad, WaveBand};
use crate::window_law::{WindowLaw, persson};

/// Model on a wide band and on its windows.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct WindowsRow {
    /// Hurst exponent.
    pub hurst_exponent: f64,
    /// Decades of the whole band.
    pub decades: f64,
    /// Load p/(E* h') on the whole band.
    pub pressure_over_gradient: f64,
    /// Name of the model; `last decade` is the area that the longer waves leave by Persson's theory times that of the
    /// last decade by elements, `last decade and a half` likewise.
    pub model: String,
    /// Area over that of elements on the whole band.
    pub whole: f64,
    /// Standard error of `whole`.
    pub standard_error: f64,
    /// Smallest ratio on windows of a decade, half a decade apart; empty for an estimate.
    pub least_on_windows: Option<f64>,
    /// Largest ratio on these windows.
    pub largest_on_windows: Option<f64>,
    /// Factor by which the whole lies beyond them, less two standard errors of both: 1 within, below 1 if the area is
    /// smaller than the windows allow.
    pub beyond: Option<f64>,
}

/// Wide bands whose windows are tested.
fn wide_bands() -> Vec<WaveBand> {
    HURST_EXPONENTS.iter().flat_map(|&hurst| [two_decades(hurst), widest(hurst)]).collect()
}

/// Computes a row for every wide band, load and elastic model.
///
/// # Errors
/// The error of running a model.
pub fn rows(elements: &[ElementsRow]) -> Result<Vec<WindowsRow>, TrialError> {
    let mut rows = Vec::new();
    for band in wide_bands() {
        let Some(law) = WindowLaw::from_elements(elements, &one_decade(band.hurst_exponent)) else {
            continue;
        };
        let whole: Vec<&ElementsRow> =
            elements.iter().filter(|row| row.band() == band && row.spread_over_hardness.is_none()).collect();
        let loads: Vec<TrialLoad> = whole.iter().map(|row| row.load()).collect();
        let on_whole = areas(&band.spectrum()?, &loads)?;
        for (load, judged) in whole.iter().enumerate() {
            let windows = windows(&band, judged.pressure_over_gradient)?;
            let on_windows = on_windows(&band, &windows)?;
            let row = |model: &str, area_fraction: f64| WindowsRow {
                hurst_exponent: band.hurst_exponent,
                decades: digits(band.decades()),
                pressure_over_gradient: judged.pressure_over_gradient,
                model: model.to_owned(),
                whole: digits(area_fraction / judged.area_fraction),
                standard_error: digits(area_fraction / judged.area_fraction * judged.relative_error()),
                least_on_windows: None,
                largest_on_windows: None,
                beyond: None,
            };
            for found in on_whole.iter().filter(|found| found.load == load) {
                let of_window = |(at, window): (usize, &Window)| {
                    let same =
                        |area: &&crate::models::ModelArea| area.model == found.model && area.load == at;
                    let model = on_windows.iter().find(same)?.area_fraction;
                    let (area, error) = (law.area_fraction(window.load), law.relative_error(window.load));
                    Some((model / area, error))
                };
                let ratios: Vec<(f64, f64)> = windows.iter().enumerate().filter_map(of_window).collect();
                rows.push(row(&found.model, found.area_fraction).beside(&ratios, judged.relative_error()));
            }
            for (name, window, law) in last_windows(&band, judged.pressure_over_gradient, elements)? {
                rows.push(row(name, window.area_left * law.area_fraction(window.load)));
            }
        }
    }
    Ok(rows)
}

/// Last windows of a band under a load, each with its name and its law.
fn last_windows(
    band: &WaveBand,
    pressure_over_gradient: f64,
    elements: &[ElementsRow],
) -> Result<Vec<(&'static str, Window, WindowLaw)>, TrialError> {
    let bands = [
        ("last decade", one_decade(band.hurst_exponent)),
        ("last decade and a half", one_and_a_half_decades(band.hurst_exponent)),
    ];
    let mut found = Vec::new();
    for (name, form) in bands {
        let Some(law) = WindowLaw::from_elements(elements, &form) else { continue };
        let short_m = BOX_M / band.last_wave;
        let long_m = short_m * (form.last_wave / form.first_wave);
        found.push((name, window(band, pressure_over_gradient, long_m, short_m)?, law));
    }
    Ok(found)
}

/// Window of a band under a load.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Window {
    /// Area that the longer waves leave, by Persson's theory.
    area_left: f64,
    /// Load p/(E* h') of the window, with the mean real pressure on that area.
    load: f64,
}

/// Windows of a decade, half a decade apart, under the pressure that Persson's theory leaves at their long ends.
fn windows(band: &WaveBand, pressure_over_gradient: f64) -> Result<Vec<Window>, TrialError> {
    let first_m = BOX_M / band.first_wave;
    let count = (2.0 * (band.decades() - 1.0)).round() as i32 + 1;
    let numbered = |at: i32| {
        let long_m = first_m * 10f64.powf(-0.5 * f64::from(at));
        window(band, pressure_over_gradient, long_m, (0.1 * long_m).max(BOX_M / band.last_wave))
    };
    (0..count).map(numbered).collect()
}

/// Window from a longest to a shortest wavelength.
fn window(
    band: &WaveBand,
    pressure_over_gradient: f64,
    long_m: f64,
    short_m: f64,
) -> Result<Window, TrialError> {
    let spectrum = band.spectrum()?;
    let first_m = BOX_M / band.first_wave;
    let area_left = if long_m < first_m {
        let gradient = spectrum.cut(first_m, long_m)?.mean_square_gradient().sqrt();
        persson(pressure_over_gradient * (RMS_GRADIENT / gradient))
    } else {
        1.0
    };
    let gradient = spectrum.cut(long_m, short_m)?.mean_square_gradient().sqrt();
    Ok(Window { area_left, load: pressure_over_gradient / area_left * (RMS_GRADIENT / gradient) })
}

/// Every model on the windows. A self-affine decade without a roll-off has the same form wherever it lies, and an
/// elastic area depends on p/(E* h') and the form alone.
fn on_windows(band: &WaveBand, windows: &[Window]) -> Result<Vec<crate::models::ModelArea>, TrialError> {
    let loads: Vec<TrialLoad> = windows.iter().map(|window| TrialLoad::elastic(window.load)).collect();
    areas(&one_decade(band.hurst_exponent).spectrum()?, &loads)
}

impl WindowsRow {
    /// Adds the ratios on windows, each with its relative error.
    fn beside(mut self, ratios: &[(f64, f64)], error_of_whole: f64) -> Self {
        let least = ratios.iter().min_by(|a, b| a.0.total_cmp(&b.0));
        let largest = ratios.iter().max_by(|a, b| a.0.total_cmp(&b.0));
        if let (Some(&(least, of_least)), Some(&(largest, of_largest))) = (least, largest) {
            let low = least * (1.0 - 2.0 * of_least.hypot(error_of_whole));
            let high = largest * (1.0 + 2.0 * of_largest.hypot(error_of_whole));
            self.least_on_windows = Some(digits(least));
            self.largest_on_windows = Some(digits(largest));
            self.beyond = Some(digits(self.whole / self.whole.clamp(low, high)));
        }
        self
    }
}
