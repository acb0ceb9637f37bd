//! Trials of elastic-plastic spheres that flatten against elements that flow: a table of `docs/develop/trials.md`.
//!
//! Areas of elements depend on s/H and p/H alone, those of spheres on the strength over the modulus as well: it says how
//! steep the surface is at the same s/H, and so how many asperities flatten.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use spectrum::AsperityParameters;
use spectrum::random_surfaces::AreaSpectrum;
use stat_contact::{AsperityLaw, ContactState, Flattening, Population, StatisticalContact};
use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::ElementsRow;
use crate::judge_spectra::Set;
use crate::programme::SpectrumTrial;
use crate::spectra::{CONTACT_MODULUS_PA, RMS_GRADIENT, TrialLoad, WaveBand};

/// Spreads over hardness s/H of every spectrum.
pub const SPREADS: [f64; 5] = [1.4, 4.0, 12.0, 40.0, 80.0];
/// Loads p/H of every spectrum.
const LOADS: [f64; 3] = [0.003, 0.01, 0.03];
/// Strengths over E*, of one spectrum after the other.
const STRENGTHS: [f64; 3] = [0.001, 0.002, 0.004];
/// Contact radii over sphere radius from which force and area are held; in the first the force is not.
const HELD_FROM: [Option<f64>; 2] = [None, Some(Flattening::HELD_FROM)];

/// Twenty-four spectra: those by which the radius was chosen, or those that were pressed afterwards.
#[must_use]
pub fn trials(set: Set) -> Vec<SpectrumTrial> {
    let (hurst_exponents, waves) = match set {
        Set::Calibration => {
            ([0.2, 0.4, 0.6, 0.8], [[4, 4, 32], [4, 10, 32], [2, 2, 32], [2, 8, 32], [8, 8, 32], [3, 3, 24]])
        }
        Set::Report => {
            ([0.3, 0.5, 0.7, 0.9], [[4, 4, 30], [4, 14, 32], [2, 2, 28], [2, 5, 32], [6, 6, 32], [3, 9, 32]])
        }
    };
    let of_spread = |spread: f64| {
        LOADS.map(|load| TrialLoad {
            pressure_over_gradient: load / (2.0 * spread),
            spread_over_hardness: Some(spread),
        })
    };
    let loads = SPREADS.map(of_spread).concat();
    let bands = waves.into_iter().flat_map(|waves| {
        let [first_wave, rolloff_wave, last_wave] = waves.map(f64::from);
        hurst_exponents.map(|hurst_exponent| WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave })
    });
    bands.map(|band| SpectrumTrial { band, grid: 256, realisations: 2, loads: loads.clone() }).collect()
}

/// Presses the spheres of a surface, made steeper by a factor, at a strength over E* under a pressure over the hardness.
///
/// # Errors
/// [`TrialError`] for a spectrum without asperities, and for numbers out of bounds.
pub fn press(
    surface: &AreaSpectrum,
    steeper: f64,
    strength: f64,
    load: f64,
    held_from: Option<f64>,
) -> Result<ContactState, TrialError> {
    let asperities = AsperityParameters::from_moments(&surface.moments())
        .ok_or_else(|| TrialError::Scene("the spectrum has no asperities".to_owned()))?;
    let AsperityParameters { radius_m, density_per_m2, sigma_s_m, .. } = asperities;
    let population = Population::new(radius_m / steeper, density_per_m2, sigma_s_m * steeper)?;
    let pair = MaterialPair::against_rigid(ElasticBody::new(0.91 * CONTACT_MODULUS_PA, 0.3)?);
    let strength_pa = strength * CONTACT_MODULUS_PA;
    let law = AsperityLaw::EpSphere {
        strength: NixGao::constant(strength_pa)?,
        hardness: Hardness::default(),
        held_from,
    };
    let contact = StatisticalContact::new(&pair, &population, &law);
    Ok(contact.at_pressure(3.0 * strength_pa * load, 1e-8, None)?)
}

/// Areas of spheres over those of elements, in rising order, and shares of flattened asperities, for all loads of an s/H
/// with a state.
///
/// # Errors
/// The error of a spectrum.
pub fn ratios_and_flattened(
    rows: &[ElementsRow],
    set: Set,
    held_from: Option<f64>,
    spread: f64,
) -> Result<[Vec<f64>; 2], TrialError> {
    let [mut ratios, mut flattened] = [Vec::new(), Vec::new()];
    for (trial, strength) in trials(set).iter().zip(STRENGTHS.into_iter().cycle()) {
        let (surface, steeper) = (trial.band.spectrum()?, 6.0 * spread * strength / RMS_GRADIENT);
        let of_trial = rows.iter().filter(|row| row.band() == trial.band);
        for row in of_trial.filter(|row| row.spread_over_hardness == Some(spread)) {
            let load = 2.0 * spread * row.pressure_over_gradient;
            let state = press(&surface, steeper, strength, load, held_from)?;
            if state.separation_m.is_some() {
                ratios.push(state.area_fraction / row.area_fraction);
                flattened.extend(state.flattened_share);
            }
        }
    }
    ratios.sort_by(f64::total_cmp);
    flattened.sort_by(f64::total_cmp);
    Ok([ratios, flattened])
}

/// Returns the page with its table of flattening.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[ElementsRow]) -> Result<String, TrialError> {
    let line = |held_from: Option<f64>| -> Result<Vec<String>, TrialError> {
        let held = held_from.map_or("area alone".to_owned(), |share| format!("both from {share} R"));
        let mut cells = vec![held];
        for spread in SPREADS {
            let [ratios, flattened] = ratios_and_flattened(rows, Set::Report, held_from, spread)?;
            let [least, median, most] =
                [0, 1, 2].map(|share| three_digits(ratios[(ratios.len() - 1) * share / 2]));
            let share = flattened.get(flattened.len() / 2);
            let share = share.map_or(String::new(), |share| format!(", {:.1} % flattened", 100.0 * share));
            cells.push(format!("{median} ({least} to {most}; {} loads){share}", ratios.len()));
        }
        Ok(cells)
    };
    let lines = HELD_FROM.into_iter().map(line).collect::<Result<Vec<_>, TrialError>>()?;
    let columns = ["held", "s/H = 1.4", "s/H = 4", "s/H = 12", "s/H = 40", "s/H = 80"];
    with_section(page, "flattening", &table(&columns, &lines)).map_err(TrialError::Page)
}
