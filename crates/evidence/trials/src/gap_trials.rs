//! Trials of mean gap and stiffness: Persson's theory, with the waves of the surface and with those of profiles, against boundary
//! elements on spectra of every kind: a table of `docs/develop/trials.md`.

use std::ops::RangeInclusive;

use elements::{ElementsError, ImposedLoad, PressedLoad, Pressing, press};
use numerics::parallel::Unobserved;
use persson::Band;
use persson::EnergyFactor;
use persson::separation::LIGHT_CONTACT;
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{Normalisation, ProfilePsd};
use study::gap_law::{GapChoices, GapError, GapLaw, GapState};
use study::plan::{Needs, Plan, Sampling};
use tables::markdown::{table, with_section};
use units::display::three_digits;

use crate::TrialError;
use crate::elements::digits;
use crate::judge_spectra::{CONTACT_MODULUS_PA, JudgeTrial, Kind, RMS_GRADIENT, Set, trials as judge_trials};
use crate::statistics::mean_and_relative_error;

/// Light loads p/(E* h') of every trial: areas from 1e-4 to 0.012.
pub const LIGHT_LOADS: [f64; 5] = [5e-5, 2e-4, 7e-4, 2e-3, 5e-3];
/// Loads of the first three reported spectra of every kind: areas from 0.026 to 0.5.
const MODERATE_LOADS: [f64; 3] = [0.012, 0.06, 0.25];
/// Surfaces that are pressed together. More follow until gap and stiffness under moderate loads are known to [`TRUTH_ERROR`].
const SURFACES: usize = 6;
/// Most batches of surfaces of a spectrum.
const MAX_BATCHES: u64 = 4;
/// Relative standard error to which gap and stiffness of the elements are wanted.
const TRUTH_ERROR: f64 = 0.03;
/// Side of the box over the longest wavelength.
const LENGTHS_IN_BOX: f64 = 4.0;
/// Seed of the surfaces.
const SEED: u64 = 7000;
/// Area fractions of moderate loads, and of lighter ones, which stand in lines of their own.
const MODERATE: RangeInclusive<f64> = LIGHT_CONTACT..=0.5;
const LIGHT: [RangeInclusive<f64>; 3] = [0.01..=LIGHT_CONTACT, 1e-3..=0.01, 1e-4..=1e-3];

/// Gap and stiffness of a spectrum under a load, with the theory beside the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct GapRow {
    /// Form of the spectrum.
    pub kind: Kind,
    /// Number of the spectrum among those of the judge's trials.
    pub number: u32,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Area fraction of the elements.
    pub area_fraction: f64,
    /// Mean gap of the elements over the rms height of the spectrum.
    pub gap_over_rms_height: f64,
    /// Its relative standard error, from the scatter of the surfaces.
    pub gap_error: f64,
    /// Stiffness of the elements times the rms height over E*.
    pub relative_stiffness: f64,
    /// Its relative standard error.
    pub stiffness_error: f64,
    /// Gap of the theory with the waves of the surface over that of the elements.
    pub gap_2d: f64,
    /// Stiffness of the theory with the waves of the surface over that of the elements.
    pub stiffness_2d: f64,
    /// Area of the theory with the waves of the surface over that of the elements.
    pub area_2d: f64,
    /// Gap with the waves of profiles.
    pub gap_1d: f64,
    /// Stiffness with the waves of profiles.
    pub stiffness_1d: f64,
    /// Area with the waves of profiles.
    pub area_1d: f64,
    /// Gap with the waves of the surface and the fitted energy.
    pub gap_fitted: f64,
    /// Stiffness with the waves of the surface and the fitted energy.
    pub stiffness_fitted: f64,
}

/// Spectra on which the judge was tried, the first four of every kind in both sets: 24 on which the tail of the heights was chosen, and
/// 24 others.
#[must_use]
pub fn trials() -> Vec<JudgeTrial> {
    let of_set = |set: Set| {
        let all = judge_trials(set);
        let of_kind = |kind| all.iter().filter(move |of| of.kind == kind).take(4).copied();
        Kind::IN_BOTH_SETS.into_iter().flat_map(of_kind).collect::<Vec<_>>()
    };
    [Set::Calibration, Set::Report].map(of_set).concat()
}

impl GapRow {
    fn set(&self) -> Set {
        if self.number <= 30 { Set::Calibration } else { Set::Report }
    }
}

/// Persson's theory for a spectrum: by the waves of the surface, by those of profiles, and by those of the surface with the fitted
/// energy.
struct Theory {
    psd: ProfilePsd,
    surface: GapLaw,
    profile: GapLaw,
    fitted: GapLaw,
}

impl Theory {
    fn of(trial: &JudgeTrial) -> Result<Self, TrialError> {
        let scene = trial.scene(false)?;
        let needs = Needs { moments: Some(Normalisation::Parseval), ..Needs::default() };
        let psd = scene.plan().compute()?.psd;
        let plan = Plan { psd: &psd, sampling: Sampling::default(), needs };
        let results = plan.compute()?;
        // The scene of a trial lists Persson's theory alone.
        let [curve] = &scene.needs.curves[..] else { return Err(GapError::NoRoughness.into()) };
        let law = |band: Band, energy_factor: EnergyFactor| {
            let choices = GapChoices { energy_factor, band, tolerance: scene.needs.tolerance };
            GapLaw::of(&curve.model, &plan, &results, &choices)
        };
        let surface = law(Band::Surface, EnergyFactor::default())?;
        let profile = law(Band::Profile, EnergyFactor::default())?;
        let fitted = law(Band::Surface, EnergyFactor::FITTED)?;
        Ok(Theory { psd, surface, profile, fitted })
    }

    /// Puts the theory beside the elements of a row.
    fn beside(&self, elements: &GapRow) -> Result<GapRow, TrialError> {
        let rms_height_m = self.surface.rms_height_m;
        let gap_m = elements.gap_over_rms_height * rms_height_m;
        let stiffness_pa_per_m = elements.relative_stiffness * CONTACT_MODULUS_PA / rms_height_m;
        let nominal_pressure_pa = pressure_pa(elements.pressure_over_gradient);
        let over = |law: &GapLaw| -> Result<[f64; 3], TrialError> {
            let GapState { mean_gap_m, stiffness_pa_per_m: of_law, area_fraction: of_theory, .. } =
                law.at(nominal_pressure_pa)?;
            let (Some(of_gap_m), Some(of_law)) = (mean_gap_m, of_law) else {
                return Err(GapError::NoRoughness.into());
            };
            Ok([of_gap_m / gap_m, of_law / stiffness_pa_per_m, of_theory / elements.area_fraction]
                .map(digits))
        };
        let [gap_2d, stiffness_2d, area_2d] = over(&self.surface)?;
        let [gap_1d, stiffness_1d, area_1d] = over(&self.profile)?;
        let [gap_fitted, stiffness_fitted, _] = over(&self.fitted)?;
        Ok(GapRow {
            gap_2d,
            stiffness_2d,
            area_2d,
            gap_1d,
            stiffness_1d,
            area_1d,
            gap_fitted,
            stiffness_fitted,
            ..*elements
        })
    }
}

fn pressure_pa(pressure_over_gradient: f64) -> f64 {
    pressure_over_gradient * CONTACT_MODULUS_PA * RMS_GRADIENT
}

/// Puts the theory of today beside the elements of a spectrum, and presses its surfaces under the loads that these rows lack.
///
/// # Errors
/// The error of making or pressing a surface, and of computing the theory.
pub fn completed(trial: &JudgeTrial, known: Vec<GapRow>) -> Result<Vec<GapRow>, TrialError> {
    let theory = Theory::of(trial)?;
    let mut rows: Vec<GapRow> = known.iter().map(|row| theory.beside(row)).collect::<Result<_, _>>()?;
    let is_moderate = trial.set == Set::Report && (trial.number - 1) % 5 < 3;
    let moderate: &[f64] = if is_moderate { &MODERATE_LOADS } else { &[] };
    for loads in [&LIGHT_LOADS, moderate] {
        if !loads.is_empty() && !known.iter().any(|row| loads.contains(&row.pressure_over_gradient)) {
            rows.extend(rows_under(trial, loads)?);
        }
    }
    Ok(rows)
}

/// Presses the surfaces of a spectrum under some loads p/(E* h').
///
/// # Errors
/// The error of making or pressing a surface, and of computing the theory.
pub fn rows_under(trial: &JudgeTrial, loads: &[f64]) -> Result<Vec<GapRow>, TrialError> {
    let theory = Theory::of(trial)?;
    let area = AreaSpectrum::from_profile(&theory.psd)?;
    let pressing = Pressing {
        loads: loads.iter().map(|load| ImposedLoad::PressurePa(pressure_pa(*load))).collect(),
        stiffness: true,
        ..Pressing::elastic(CONTACT_MODULUS_PA)
    };
    let mut pressed: Vec<PressedLoad> = Vec::new();
    for batch in 0..MAX_BATCHES {
        let seed = SEED + 1000 * batch + u64::from(trial.number);
        let surfaces = trial.surfaces(&area, LENGTHS_IN_BOX, SURFACES, seed)?;
        let more = press::<ElementsError>(&surfaces, &pressing, |_| Ok(()), &Unobserved)?;
        match pressed.is_empty() {
            true => pressed = more,
            false => pressed.iter_mut().zip(more).for_each(|(load, more)| load.states.extend(more.states)),
        }
        if pressed.iter().all(is_known) {
            break;
        }
    }
    let rms_height_m = theory.surface.rms_height_m;
    let row = |(pressure_over_gradient, load): (&f64, &PressedLoad)| {
        let (gap_m, gap_error) =
            mean_and_relative_error(load.states.iter().map(|state| state.numbers.mean_gap_m));
        let (stiffness_pa_per_m, stiffness_error) =
            mean_and_relative_error(load.states.iter().filter_map(|state| state.stiffness_pa_per_m));
        theory.beside(&GapRow {
            kind: trial.kind,
            number: trial.number,
            pressure_over_gradient: *pressure_over_gradient,
            area_fraction: digits(load.mean().best_area_fraction()),
            gap_over_rms_height: digits(gap_m / rms_height_m),
            gap_error: digits(gap_error),
            relative_stiffness: digits(stiffness_pa_per_m * rms_height_m / CONTACT_MODULUS_PA),
            stiffness_error: digits(stiffness_error),
            ..GapRow::default()
        })
    };
    loads.iter().zip(&pressed).map(row).collect()
}

/// Returns true if gap and stiffness under a load are known well enough, or if the load is too light to matter.
fn is_known(load: &PressedLoad) -> bool {
    let errors = [
        mean_and_relative_error(load.states.iter().map(|state| state.numbers.mean_gap_m)).1,
        mean_and_relative_error(load.states.iter().filter_map(|state| state.stiffness_pa_per_m)).1,
    ];
    !MODERATE.contains(&load.mean().best_area_fraction()) || errors.iter().all(|error| *error <= TRUTH_ERROR)
}

/// Returns the page with a new table; its text is written by hand.
///
/// # Errors
/// [`TrialError::Page`] if the page lacks the section.
pub fn written(page: &str, rows: &[GapRow]) -> Result<String, TrialError> {
    let mut lines = Vec::new();
    let reported = |row: &&GapRow| row.set() == Set::Report;
    let moderate = |row: &&GapRow| MODERATE.contains(&row.area_fraction) && reported(row);
    let mut add = |name: String, wanted: &dyn Fn(&&GapRow) -> bool| {
        let of_line: Vec<&GapRow> = rows.iter().filter(wanted).collect();
        let of = |value: fn(&GapRow) -> f64| range(of_line.iter().map(|row| value(row)).collect());
        lines.push(vec![
            name,
            of_line.len().to_string(),
            of(|row| row.stiffness_2d),
            of(|row| row.gap_2d),
            of(|row| row.stiffness_fitted),
            of(|row| row.gap_fitted),
            of(|row| row.area_2d),
            of(|row| row.stiffness_1d),
            of(|row| row.gap_1d),
            of(|row| row.area_1d),
        ]);
    };
    add("reported, A from 0.02 to 0.5".to_owned(), &moderate);
    for areas in &LIGHT {
        let name = format!("reported, A from {} to {}", areas.start(), areas.end());
        add(name, &|row| row.set() == Set::Report && areas.contains(&row.area_fraction));
    }
    let headings =
        ["spectra", "states", "K, 2d", "u, 2d", "K, fitted", "u, fitted", "A, 2d", "K, 1d", "u, 1d", "A, 1d"];
    with_section(page, "gap", &table(&headings, &lines)).map_err(TrialError::Page)
}

/// Least, middle and largest of some ratios: `0.81 to 1.05 (0.93)`.
fn range(mut ratios: Vec<f64>) -> String {
    ratios.sort_by(f64::total_cmp);
    match (ratios.first(), ratios.get(ratios.len() / 2), ratios.last()) {
        (Some(least), Some(middle), Some(largest)) => {
            format!("{} to {} ({})", three_digits(*least), three_digits(*largest), three_digits(*middle))
        }
        _ => String::new(),
    }
}
