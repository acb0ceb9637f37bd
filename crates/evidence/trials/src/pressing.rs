//! Boundary elements under surfaces of a spectrum.

use elements::half_space::{Contact, Elements, Grid, Loading, extrapolated_area};
use numerics::parallel::Unobserved;
use spectrum::random_surfaces::{AreaSpectrum, Phases, RandomSurface, Synthesis};

use crate::TrialError;
use crate::elements::{ElementsRow, digits};
use crate::programme::SpectrumTrial;
use crate::spectra::{BOX_M, CONTACT_MODULUS_PA, RMS_GRADIENT, TrialLoad, WaveBand};
use crate::statistics::Mean;

/// Seed of all surfaces.
const SEED: u64 = 1;

/// Residual to which surfaces are pressed.
const TOLERANCE: f64 = 1e-6;

/// Points on the shortest wavelength below which a grid does not show how areas change with the grid.
const FEWEST_POINTS_PER_WAVE: f64 = 2.5;

/// Presses every surface of a trial under every load, with the surfaces in parallel. The area is extrapolated from two grids if
/// both resolve the shortest wavelength.
///
/// # Errors
/// The error of making or pressing a surface.
pub fn rows_of(trial: &SpectrumTrial) -> Result<Vec<ElementsRow>, TrialError> {
    let numbers: Vec<u64> = (0..trial.realisations).collect();
    let of_surfaces = numerics::parallel::try_map(&numbers, |&number| one_surface(trial, number))?;
    let alpha = digits(trial.band.alpha()?);
    let WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave } = trial.band;
    let of_load = |(at, load): (usize, &TrialLoad)| {
        let mean = |of: fn(&Areas) -> f64| Mean::new(of_surfaces.iter().map(|areas| of(&areas[at])));
        let [area, corrected, plastic] =
            [mean(|areas| areas.extrapolated), mean(|areas| areas.corrected), mean(|areas| areas.plastic)];
        ElementsRow {
            hurst_exponent,
            first_wave,
            rolloff_wave,
            last_wave,
            alpha,
            pressure_over_gradient: load.pressure_over_gradient,
            spread_over_hardness: load.spread_over_hardness,
            area_fraction: digits(area.value),
            area_fraction_corrected: digits(corrected.value),
            plastic_area_fraction: digits(plastic.value),
            standard_error: digits(area.standard_error),
            plastic_standard_error: digits(plastic.standard_error),
            realisations: trial.realisations,
            grid: trial.grid,
        }
    };
    Ok(trial.loads.iter().enumerate().map(of_load).collect())
}

/// Areas of one surface under one load.
struct Areas {
    extrapolated: f64,
    corrected: f64,
    plastic: f64,
}

fn one_surface(trial: &SpectrumTrial, number: u64) -> Result<Vec<Areas>, TrialError> {
    let fine = surface(&trial.band.spectrum()?, trial.grid, number)?;
    let resolved = 0.5 * trial.grid as f64 / trial.band.last_wave >= FEWEST_POINTS_PER_WAVE;
    let coarse = if resolved { fine.every_second_point() } else { None };
    let mut coarse = coarse.as_ref().map(elements).transpose()?;
    let mut fine = elements(&fine)?;
    let of_load = |load: &TrialLoad| {
        let contact = press_elements(&mut fine, load)?;
        let corrected = contact.numbers.area_fraction_corrected;
        let extrapolated = match &mut coarse {
            Some(coarse) => {
                extrapolated_area(corrected, press_elements(coarse, load)?.numbers.area_fraction_corrected)
            }
            None => corrected,
        };
        Ok(Areas { extrapolated, corrected, plastic: contact.numbers.plastic_area_fraction_corrected })
    };
    trial.loads.iter().map(of_load).collect()
}

/// RandomSurface scaled to the rms gradient of its spectrum: the area depends mostly on the gradient, and most of the
/// scatter from surface to surface comes from it.
fn surface(spectrum: &AreaSpectrum, grid: usize, number: u64) -> Result<RandomSurface, TrialError> {
    let surface = spectrum.surface(&Synthesis::square(grid, BOX_M, SEED, Phases::FixedModulus), number)?;
    let own = surface.mean_square_gradient().sqrt();
    Ok(surface.scaled(RMS_GRADIENT / own))
}

fn elements(surface: &RandomSurface) -> Result<Elements, TrialError> {
    let grid = Grid::new(surface.points_y, surface.points_x, surface.length_x_m, surface.length_y_m)?;
    Ok(Elements::periodic(grid, &surface.heights_m)?)
}

fn press_elements(elements: &mut Elements, load: &TrialLoad) -> Result<Contact, TrialError> {
    let loading = Loading {
        contact_modulus_pa: CONTACT_MODULUS_PA,
        nominal_pressure_pa: load.nominal_pressure_pa(),
        saturation_pa: load.hardness_pa(),
        tolerance: TOLERANCE,
    };
    Ok(elements.press(&loading, &Unobserved)?)
}
