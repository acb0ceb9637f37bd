//! Trials of elastic-plastic spheres that flatten against elements that flow: a table of `docs/develop/trials.md`.
//!
//! Areas of elements depend on s/H and p/H alone, those of spheres on the strength over the modulus as well: it says how
//! steep the surface is at the same s/H, and so how many asperities flatten.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use spectrum::AsperityParameters;
use spectrum::random_surfaces::{AreaSpectrum, SelfAffine, Size};
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
const HELD_FROM: [Option<f64>; 6] =
    [None, Some(1.0), Some(0.6), Some(Flattening::HELD_FROM), Some(0.3), Some(0.2)];

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
fn press(
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

/// Counts the loads of 100 ordinary scenes that spheres of the default carry, of 300: metals with an rms height of 50 nm
/// to 5 um, a roll-off at 20 to 500 um and a shortest wavelength of 0.3 to 10 um, under 1, 10 and 100 MPa.
///
/// # Errors
/// The error of a spectrum.
pub fn ordinary_loads_with_a_state() -> Result<usize, TrialError> {
    // Strength \[Pa\] and E* \[Pa\] of aluminium, mild and hardened steel, copper, and titanium.
    const METALS: [[f64; 2]; 5] =
        [[275e6, 78e9], [350e6, 229e9], [1.8e9, 229e9], [200e6, 136e9], [880e6, 128e9]];
    // Roots of 2, 3, 5 and 7, whose multiples modulo 1 fill the cube evenly.
    let share = |root: f64, scene: u32| (root.sqrt() * f64::from(scene)).fract();
    let between = |share: f64, from: f64, to: f64| from * (to / from).powf(share);
    let mut carried = 0;
    for scene in 1..=100 {
        let rolloff_m = between(share(2.0, scene), 20e-6, 500e-6);
        let surface = AreaSpectrum::self_affine(&SelfAffine {
            hurst_exponent: 0.5 + 0.45 * share(3.0, scene),
            longest_m: 4.0 * rolloff_m,
            rolloff_m,
            shortest_m: between(share(5.0, scene), 0.3e-6, 10e-6),
            size: Size::RmsHeightM(between(share(7.0, scene), 50e-9, 5e-6)),
        })?;
        let [strength_pa, modulus_pa] = METALS[scene as usize % METALS.len()];
        for pressure_pa in [1e6, 10e6, 100e6] {
            let (strength, load) = (strength_pa / modulus_pa, pressure_pa / (3.0 * strength_pa));
            let state = press(&surface, 1.0, strength, load, Flattening::default().held_from())?;
            carried += usize::from(state.separation_m.is_some());
        }
    }
    Ok(carried)
}

/// Returns the page with its table of flattening.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[ElementsRow]) -> Result<String, TrialError> {
    let line = |set, held_from: Option<f64>| -> Result<Vec<String>, TrialError> {
        let spectra = if set == Set::Report { "reported" } else { "chosen" };
        let held = held_from.map_or("area alone".to_owned(), |share| format!("both from {share} R"));
        let mut cells = vec![spectra.to_owned(), held];
        for spread in SPREADS {
            let [ratios, flattened] = ratios_and_flattened(rows, set, held_from, spread)?;
            let [least, median, most] =
                [0, 1, 2].map(|share| three_digits(ratios[(ratios.len() - 1) * share / 2]));
            let share = flattened.get(flattened.len() / 2);
            let share = share.map_or(String::new(), |share| format!(", {:.1} % flattened", 100.0 * share));
            cells.push(format!("{median} ({least} to {most}; {} loads){share}", ratios.len()));
        }
        Ok(cells)
    };
    let sets = [Set::Calibration, Set::Report];
    let lines = sets.iter().flat_map(|set| HELD_FROM.map(|held_from| line(*set, held_from)));
    let lines = lines.collect::<Result<Vec<_>, TrialError>>()?;
    let columns = ["spectra", "held", "s/H = 1.4", "s/H = 4", "s/H = 12", "s/H = 40", "s/H = 80"];
    let carried = ordinary_loads_with_a_state()?;
    let count = format!("Of the 300 loads of 100 ordinary scenes, {carried} have a state.");
    with_section(page, "flattening", &format!("{}\n\n{count}\n", table(&columns, &lines).trim_end()))
        .map_err(TrialError::Page)
}
