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
use crate::spectra::{BOX_M, CONTACT_MODULUS_PA, TrialLoad, WaveBand};

/// Spreads over hardness s/H of every spectrum.
const SPREADS: [f64; 5] = [1.4, 4.0, 12.0, 40.0, 80.0];
/// Loads p/H of every spectrum.
const LOADS: [f64; 3] = [0.003, 0.01, 0.03];
/// Strengths over E*, of one spectrum after the other.
const STRENGTHS: [f64; 3] = [0.001, 0.002, 0.004];
/// Contact radii over sphere radius from which force and area are held; in the first the force is not.
const HELD_FROM: [Option<f64>; 6] =
    [None, Some(1.0), Some(0.6), Some(Flattening::HELD_FROM), Some(0.3), Some(0.2)];
const POISSON_RATIO: f64 = 0.3;

/// Twenty-four spectra: those by which the radius was chosen, or those that were pressed afterwards.
#[must_use]
pub fn trials(set: Set) -> Vec<SpectrumTrial> {
    let (hurst_exponents, waves) = match set {
        Set::Calibration => (
            [0.2, 0.4, 0.6, 0.8],
            [
                [4.0, 4.0, 32.0],
                [4.0, 10.0, 32.0],
                [2.0, 2.0, 32.0],
                [2.0, 8.0, 32.0],
                [8.0, 8.0, 32.0],
                [3.0, 3.0, 24.0],
            ],
        ),
        Set::Report => (
            [0.3, 0.5, 0.7, 0.9],
            [
                [4.0, 4.0, 30.0],
                [4.0, 14.0, 32.0],
                [2.0, 2.0, 28.0],
                [2.0, 5.0, 32.0],
                [6.0, 6.0, 32.0],
                [3.0, 9.0, 32.0],
            ],
        ),
    };
    let loads: Vec<TrialLoad> = SPREADS
        .iter()
        .flat_map(|&spread| {
            LOADS.map(|load| TrialLoad {
                pressure_over_gradient: load / (2.0 * spread),
                spread_over_hardness: Some(spread),
            })
        })
        .collect();
    let bands = waves.into_iter().flat_map(|[first_wave, rolloff_wave, last_wave]| {
        hurst_exponents.map(|hurst_exponent| WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave })
    });
    bands.map(|band| SpectrumTrial { band, grid: 256, realisations: 2, loads: loads.clone() }).collect()
}

/// Spheres under a pressure over their hardness, at a strength over the modulus.
fn state(
    surface: &AreaSpectrum,
    strength: f64,
    pressure_over_hardness: f64,
    held_from: Option<f64>,
) -> Result<ContactState, TrialError> {
    let asperities = AsperityParameters::from_moments(&surface.moments())
        .ok_or_else(|| TrialError::Scene("the spectrum has no asperities".to_owned()))?;
    let population = Population::new(asperities.radius_m, asperities.density_per_m2, asperities.sigma_s_m)?;
    let modulus_pa = CONTACT_MODULUS_PA * (1.0 - POISSON_RATIO * POISSON_RATIO);
    let pair = MaterialPair::against_rigid(ElasticBody::new(modulus_pa, POISSON_RATIO)?);
    let strength_pa = strength * CONTACT_MODULUS_PA;
    let strength = NixGao::constant(strength_pa)?;
    let law = AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from };
    let contact = StatisticalContact::new(&pair, &population, &law);
    Ok(contact.at_pressure(3.0 * strength_pa * pressure_over_hardness, 1e-8, None)?)
}

/// Areas of spheres over those of elements at one s/H.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Ratios {
    /// Ratios of states, in rising order.
    pub ratios: Vec<f64>,
    /// Number of loads without a state.
    pub without_state: usize,
    /// Shares of flattened asperities of the states, in rising order.
    pub flattened: Vec<f64>,
}

impl Ratios {
    /// Returns the ratios for a held radius at an s/H, on a set of spectra that were pressed.
    ///
    /// # Errors
    /// The error of a spectrum.
    pub fn new(
        rows: &[ElementsRow],
        set: Set,
        held_from: Option<f64>,
        spread: f64,
    ) -> Result<Self, TrialError> {
        let mut found = Ratios::default();
        for (number, trial) in trials(set).iter().enumerate() {
            let strength = STRENGTHS[number % STRENGTHS.len()];
            let WaveBand { hurst_exponent, first_wave, rolloff_wave, last_wave } = trial.band;
            let surface = AreaSpectrum::self_affine(&SelfAffine {
                hurst_exponent,
                longest_m: BOX_M / first_wave,
                rolloff_m: BOX_M / rolloff_wave,
                shortest_m: BOX_M / last_wave,
                size: Size::RmsGradient(6.0 * spread * strength),
            })?;
            let of_spread =
                |row: &&ElementsRow| row.band() == trial.band && row.spread_over_hardness == Some(spread);
            for row in rows.iter().filter(of_spread) {
                let load = 2.0 * spread * row.pressure_over_gradient;
                let state = state(&surface, strength, load, held_from)?;
                if state.separation_m.is_some() {
                    found.ratios.push(state.area_fraction / row.area_fraction);
                    found.flattened.extend(state.flattened_share);
                } else {
                    found.without_state += 1;
                }
            }
        }
        found.ratios.sort_by(f64::total_cmp);
        found.flattened.sort_by(f64::total_cmp);
        Ok(found)
    }

    /// Returns the median ratio.
    #[must_use]
    pub fn median(&self) -> f64 {
        median(&self.ratios)
    }
}

fn median(sorted: &[f64]) -> f64 {
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Counts the loads of 100 ordinary scenes, and those that spheres of the default carry: metals with an rms height of 50
/// nm to 5 um, a roll-off at 20 to 500 um and a shortest wavelength of 0.3 to 10 um, under 1, 10 and 100 MPa.
///
/// # Errors
/// The error of a spectrum.
pub fn ordinary_loads() -> Result<[usize; 2], TrialError> {
    // Strength over E*: aluminium, mild and hardened steel, copper, titanium; and 3 E* times it is the hardness in Pa.
    const METALS: [[f64; 2]; 5] =
        [[275e6, 78e9], [350e6, 229e9], [1.8e9, 229e9], [200e6, 136e9], [880e6, 128e9]];
    // Roots of 2, 3, 5 and 7: multiples modulo 1 fill the unit cube evenly.
    const STEPS: [f64; 4] = [0.414_213_562_4, 0.732_050_807_6, 0.236_067_977_5, 0.645_751_311_1];
    let between = |share: f64, from: f64, to: f64| from * (to / from).powf(share);
    let mut carried = [0; 2];
    for scene in 1..=100 {
        let [height, hurst, rolloff, shortest] = STEPS.map(|step| (step * f64::from(scene)).fract());
        let rolloff_m = between(rolloff, 20e-6, 500e-6);
        let surface = AreaSpectrum::self_affine(&SelfAffine {
            hurst_exponent: 0.5 + 0.45 * hurst,
            longest_m: 4.0 * rolloff_m,
            rolloff_m,
            shortest_m: between(shortest, 0.3e-6, 10e-6),
            size: Size::RmsHeightM(between(height, 50e-9, 5e-6)),
        })?;
        let [strength_pa, modulus_pa] = METALS[scene as usize % METALS.len()];
        for pressure_pa in [1e6, 10e6, 100e6] {
            let load = pressure_pa / (3.0 * strength_pa);
            let state = state(&surface, strength_pa / modulus_pa, load, Flattening::default().held_from())?;
            carried[0] += 1;
            carried[1] += usize::from(state.separation_m.is_some());
        }
    }
    Ok(carried)
}

/// Returns the page with its table of flattening.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[ElementsRow]) -> Result<String, TrialError> {
    let mut lines = Vec::new();
    for set in [Set::Calibration, Set::Report] {
        for held_from in HELD_FROM {
            let mut line = vec![
                if set == Set::Report { "reported" } else { "chosen" }.to_owned(),
                held_from.map_or("area alone".to_owned(), |share| format!("both from {share} R")),
            ];
            for spread in SPREADS {
                let found = Ratios::new(rows, set, held_from, spread)?;
                let all = found.ratios.len() + found.without_state;
                line.push(format!("{} ({} of {all})", three_digits(found.median()), found.ratios.len()));
            }
            lines.push(line);
        }
    }
    let mut flattened = vec!["reported".to_owned(), "share of flattened asperities".to_owned()];
    for spread in SPREADS {
        let shares = Ratios::new(rows, Set::Report, Flattening::default().held_from(), spread)?.flattened;
        let highest = shares.last().copied().unwrap_or(f64::NAN);
        let percent = |share: f64| match share < 1e-4 {
            true => "0".to_owned(),
            false => three_digits(100.0 * share),
        };
        flattened.push(format!("{} %, at most {} %", percent(median(&shares)), percent(highest)));
    }
    lines.push(flattened);
    let headings = SPREADS.map(|spread| format!("s/H = {}", three_digits(spread)));
    let columns: Vec<&str> =
        ["spectra", "held"].into_iter().chain(headings.iter().map(String::as_str)).collect();
    let [all, carried] = ordinary_loads()?;
    let text = format!(
        "{}\nOf the {all} loads of 100 ordinary scenes, {carried} have a state.\n",
        table(&columns, &lines).trim_end()
    );
    with_section(page, "flattening", &text).map_err(TrialError::Page)
}
