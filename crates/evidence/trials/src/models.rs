//! Areas of every model on the surfaces of the study.

use std::num::NonZeroU32;

use asperity::ElasticBody;
use persson::corrections::Correction;
use persson::elastic;
use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{AmplitudeDefinition, Normalisation, ProfilePsd};
use study::hardness_and_strength::HardnessAndStrength;
use study::material::{GivenMaterial, Material};
use study::models::{Choice, Framework, MODELS, ModelEntry, ModelOptions};
use study::plan::{Curve, Cutoffs, Load, Needs, NominalPressure, Plan, Sampling};
use units::IndentationHardness;

use crate::TrialError;
use crate::spectra::{CONTACT_MODULUS_PA, TrialLoad, spread_pa};

const POISSON_RATIO: f64 = 0.3;

/// Longest wavelength of sampled profiles, over that of the surface.
const LEVEL_PART: f64 = 100.0;
/// Scales of a stack per decade, as in the spectra that come with the program.
const SCALES_PER_DECADE: f64 = 10.0;
const PER_DECADE: NonZeroU32 = NonZeroU32::new(20).unwrap();

/// Area of a model under a load.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelArea {
    /// Name of the model; a corrected form of Persson's theory is `persson` with the name of the correction.
    pub model: String,
    /// Index of the load.
    pub load: usize,
    /// Area over nominal area.
    pub area_fraction: f64,
}

/// Returns true if a model yields, and is compared with saturated elements.
#[must_use]
pub fn yields(entry: &ModelEntry) -> bool {
    entry.has(Choice::Strength)
}

/// Areas of all elastic models under elastic loads, and of all that yield at a constant hardness under the others.
///
/// # Errors
/// The error of making a spectrum or a plan.
pub fn areas(surface: &AreaSpectrum, loads: &[TrialLoad]) -> Result<Vec<ModelArea>, TrialError> {
    let from_m = LEVEL_PART * surface.longest_m();
    let fine = surface.profile(&surface.profile_wavelengths_m(from_m, PER_DECADE))?;
    let scales = surface.profile(&scales_m(from_m, surface.shortest_m()))?;
    let mut hardnesses: Vec<Option<f64>> = loads.iter().map(|load| load.spread_over_hardness).collect();
    hardnesses.sort_by(|a, b| a.unwrap_or(0.0).total_cmp(&b.unwrap_or(0.0)));
    hardnesses.dedup();
    let mut found = Vec::new();
    for hardness in hardnesses {
        let numbered = loads.iter().enumerate().filter(|(_, load)| load.spread_over_hardness == hardness);
        let of_hardness: Vec<(usize, TrialLoad)> = numbered.map(|(at, &load)| (at, load)).collect();
        found.extend(planned(&scales, &of_hardness, |entry| entry.framework == Framework::Stacked)?);
        found.extend(planned(&fine, &of_hardness, |entry| entry.framework != Framework::Stacked)?);
        if hardness.is_none() {
            found.extend(corrected(surface, &of_hardness));
        }
    }
    Ok(found)
}

/// Wavelengths \[m\] of scales to be stacked, evenly spaced in their logarithms and above the shortest of the
/// surface, at which its profiles end.
fn scales_m(from_m: f64, shortest_m: f64) -> Vec<f64> {
    let scales = ((from_m / shortest_m).log10() * SCALES_PER_DECADE).round();
    (0..scales as u32).map(|at| from_m * (shortest_m / from_m).powf(f64::from(at) / scales)).collect()
}

/// Results of the program's own plan for some of the models under loads that share a hardness.
fn planned(
    psd: &ProfilePsd,
    loads: &[(usize, TrialLoad)],
    chosen: impl Fn(&ModelEntry) -> bool,
) -> Result<Vec<ModelArea>, TrialError> {
    let Some((_, first)) = loads.first() else { return Ok(Vec::new()) };
    let material = material(first)?;
    let wanted = |entry: &&ModelEntry| chosen(entry) && yields(entry) == first.spread_over_hardness.is_some();
    let entries: Vec<&ModelEntry> = MODELS.iter().filter(wanted).collect();
    let curve = |entry: &&'static ModelEntry| {
        let model = entry.build(&material, &ModelOptions::default())?;
        Ok(Curve { name: entry.name.to_owned(), model, cutoffs: Cutoffs::Shortest })
    };
    let curves = entries.iter().map(curve).collect::<Result<Vec<_>, TrialError>>()?;
    let load = |(_, load): &(usize, TrialLoad)| {
        let nominal_pressure = NominalPressure::new(load.nominal_pressure_pa())?;
        Ok(Load { nominal_pressure, label: nominal_pressure.label() })
    };
    let needs = Needs {
        moments: Some(Normalisation::default()),
        amplitudes: Some(AmplitudeDefinition::default()),
        curves,
        loads: loads.iter().map(load).collect::<Result<_, TrialError>>()?,
        ..Needs::default()
    };
    let results = Plan { psd, sampling: Sampling::default(), needs }.compute()?;
    let of_model = |(entry, curve): (&&ModelEntry, &study::plan::CurveResult)| -> Vec<ModelArea> {
        let of_load = |(block, (at, _)): (usize, &(usize, TrialLoad))| {
            let (_, area_fraction) = *curve.area_fractions(block).last()?;
            Some(ModelArea { model: entry.name.to_owned(), load: *at, area_fraction })
        };
        loads.iter().enumerate().filter_map(of_load).collect()
    };
    Ok(entries.iter().zip(&results.curves).flat_map(of_model).collect())
}

/// Corrected forms of Persson's elastic theory, which depend on h' and alpha alone.
fn corrected(surface: &AreaSpectrum, loads: &[(usize, TrialLoad)]) -> Vec<ModelArea> {
    let moments = surface.moments();
    let alpha = moments.m0_m2 * moments.m4_per_m2 / (moments.m2 * moments.m2);
    let variance_pa2 = spread_pa() * spread_pa();
    let area = |correction: Correction, load: &TrialLoad| {
        let pressure_pa = load.nominal_pressure_pa();
        let effective = correction.effective_variances_pa2(pressure_pa, &[variance_pa2], &[alpha]);
        elastic::area_fraction(pressure_pa, effective[0].sqrt())
    };
    let of_correction = |&correction: &Correction| {
        loads.iter().map(move |&(at, ref load)| ModelArea {
            model: format!("persson {correction}"),
            load: at,
            area_fraction: area(correction, load),
        })
    };
    Correction::ALL.iter().flat_map(of_correction).collect()
}

/// Metal of the contact modulus of the trials, with the hardness of a load.
fn material(load: &TrialLoad) -> Result<Material, TrialError> {
    let youngs_modulus_pa = CONTACT_MODULUS_PA * (1.0 - POISSON_RATIO * POISSON_RATIO);
    let hardness = load.hardness_pa().map(|pa| IndentationHardness { pa });
    let body =
        ElasticBody::new(youngs_modulus_pa, POISSON_RATIO).map_err(study::material::MaterialError::from)?;
    Ok(Material::new(GivenMaterial {
        hardness_and_strength: HardnessAndStrength::new(hardness, None)
            .map_err(study::material::MaterialError::from)?,
        ..GivenMaterial::new(body)
    }))
}
