//! What rests on what: how much each open choice moves the areas that a scene ends in.

use std::num::NonZeroU32;

use asperity::{Hardness, NixGao};
use spectrum::{AmplitudeDefinition, Normalisation};
use stacked_contact::StackedModel;
use stat_contact::{AsperityLaw, InterferenceLaw};

use crate::display::pressure;
use crate::plan::{Curve, CurveModel, CurveResult, Cutoffs, Needs, Plan, PlanError, Results};
use crate::scene::Scene;
use crate::table::Table;

/// Densities of the spectrum that are tried, in scales per decade.
const SCALES_PER_DECADE: [u32; 3] = [5, 10, 20];

/// One choice made another way.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// The choice, e.g. `normalisation of moments`.
    pub choice: &'static str,
    /// The other way, e.g. `as-printed`.
    pub setting: String,
    /// The areas that depend on it.
    pub rows: Vec<Moved>,
}

/// An area that a choice moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moved {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The final area fraction with the choice made the other way.
    pub area_fraction: f64,
    /// The same over the one with the scene's own choice.
    pub ratio: f64,
}

/// A row per choice, setting, curve and load: `choice, setting, curve, nominal_pressure_pa, area_fraction, ratio` to the
/// scene's own.
pub fn table(sensitivities: &[Sensitivity], needs: &Needs) -> Table {
    let rows = || sensitivities.iter().flat_map(|varied| varied.rows.iter().map(move |row| (varied, row)));
    Table::default()
        .with_text("choice", rows().map(|(varied, _)| varied.choice.to_owned()))
        .with_text("setting", rows().map(|(varied, _)| varied.setting.clone()))
        .with_text("curve", rows().map(|(_, row)| needs.curves[row.curve].name.clone()))
        .with_numbers("nominal_pressure_pa", rows().map(|(_, row)| needs.loads[row.load].nominal_pressure_pa))
        .with_numbers("area_fraction", rows().map(|(_, row)| row.area_fraction))
        .with_numbers("ratio", rows().map(|(_, row)| row.ratio))
}

/// An option of the models, set another way than the scene has it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Variation {
    Normalisation(Normalisation),
    Amplitude(AmplitudeDefinition),
    ScalesPerDecade(NonZeroU32),
    Hardness(Hardness),
    Interference(InterferenceLaw),
    StrengthCap(Option<f64>),
}

/// Every open choice made another way, where curves of the scene depend on it; `results` are those of its own choices.
/// Only final areas are computed.
///
/// # Errors
/// [`PlanError`], as of the scene's own plan.
pub fn sensitivities(scene: &Scene, results: &Results) -> Result<Vec<Sensitivity>, PlanError> {
    let moved = |variation: &Variation| variation.sensitivity(scene, results).transpose();
    variations(scene).iter().filter_map(moved).collect()
}

fn variations(scene: &Scene) -> Vec<Variation> {
    let needs = &scene.needs;
    let mut variations = Vec::new();
    let other = |normalisation| needs.moments.is_some_and(|own| own != normalisation);
    variations.extend(
        Normalisation::ALL.iter().filter(|way| other(**way)).map(|way| Variation::Normalisation(*way)),
    );
    let other = |definition| needs.amplitudes.is_some_and(|own| own != definition);
    variations.extend(
        AmplitudeDefinition::ALL.iter().filter(|way| other(**way)).map(|way| Variation::Amplitude(*way)),
    );
    let densities = SCALES_PER_DECADE.into_iter().filter_map(NonZeroU32::new);
    variations.extend(
        densities
            .filter(|density| scene.sampling.scales_per_decade != Some(*density))
            .map(Variation::ScalesPerDecade),
    );
    variations.extend(Hardness::ALL.map(Variation::Hardness));
    variations.extend(InterferenceLaw::ALL.map(Variation::Interference));
    let usual_cap_pa = scene.material.map(|material| material.pair.body().youngs_modulus_pa() / 10.0);
    variations.extend([Variation::StrengthCap(None), Variation::StrengthCap(usual_cap_pa)]);
    variations
}

impl Variation {
    fn choice(&self) -> &'static str {
        match self {
            Variation::Normalisation(_) => "normalisation of moments",
            Variation::Amplitude(_) => "amplitude of a scale",
            Variation::ScalesPerDecade(_) => "scales per decade",
            Variation::Hardness(_) => "hardness of spheres",
            Variation::Interference(_) => "interference law of sinusoids",
            Variation::StrengthCap(_) => "cap of the strength",
        }
    }

    fn setting(&self) -> String {
        match self {
            Variation::Normalisation(normalisation) => normalisation.to_string(),
            Variation::Amplitude(definition) => definition.to_string(),
            Variation::ScalesPerDecade(density) => density.to_string(),
            Variation::Hardness(hardness) => hardness.name().to_owned(),
            Variation::Interference(interference) => interference.to_string(),
            Variation::StrengthCap(None) => "none".to_owned(),
            Variation::StrengthCap(Some(cap_pa)) => format!("E/10 = {}", pressure(*cap_pa)),
        }
    }

    /// The model with the choice made this way; `None` where that is its own way, or no choice of its.
    fn of(&self, model: &CurveModel) -> Option<CurveModel> {
        let statistical = matches!(model, CurveModel::Statistical { .. });
        let varied = match (*self, *model) {
            (Variation::Normalisation(_), _) if statistical => return Some(*model),
            (Variation::Amplitude(_), _) if !statistical => return Some(*model),
            (Variation::ScalesPerDecade(_), _) => return Some(*model),
            (
                Variation::Hardness(hardness),
                CurveModel::Statistical { pair, law: AsperityLaw::EpSphere { strength, .. } },
            ) => CurveModel::Statistical { pair, law: AsperityLaw::EpSphere { strength, hardness } },
            (
                Variation::Interference(interference),
                CurveModel::Statistical { pair, law: AsperityLaw::ElasticSine { .. } },
            ) => CurveModel::Statistical { pair, law: AsperityLaw::ElasticSine { interference } },
            (Variation::StrengthCap(cap_pa), model) => with_cap(model, cap_pa)?,
            _ => return None,
        };
        (varied != *model).then_some(varied)
    }

    fn sensitivity(&self, scene: &Scene, results: &Results) -> Result<Option<Sensitivity>, PlanError> {
        let varied: Vec<(usize, CurveModel)> = scene
            .needs
            .curves
            .iter()
            .enumerate()
            .filter_map(|(index, curve)| Some((index, self.of(&curve.model)?)))
            .collect();
        if varied.is_empty() || scene.needs.loads.is_empty() {
            return Ok(None);
        }
        let models: Vec<CurveModel> = varied.iter().map(|(_, model)| *model).collect();
        let moved = self.plan(scene, &models).compute()?;
        let final_area =
            |result: &CurveResult, load| result.area_fractions(load).last().map(|(_, area)| *area);
        let mut rows = Vec::new();
        for (&(curve, _), result) in varied.iter().zip(&moved.curves) {
            for load in 0..scene.needs.loads.len() {
                let areas = final_area(result, load).zip(final_area(&results.curves[curve], load));
                rows.extend(areas.map(|(area_fraction, own)| Moved {
                    curve,
                    load,
                    area_fraction,
                    ratio: area_fraction / own,
                }));
            }
        }
        Ok(Some(Sensitivity { choice: self.choice(), setting: self.setting(), rows }))
    }

    /// What yields the final areas of these models under the loads of the scene: of a stack all its levels, of a
    /// statistical model the one state at the shortest cutoff.
    fn plan<'s>(&self, scene: &'s Scene, models: &[CurveModel]) -> Plan<'s> {
        let mut sampling = scene.sampling;
        if let Variation::ScalesPerDecade(density) = self {
            sampling.scales_per_decade = Some(*density);
        }
        let statistical = |model: &CurveModel| matches!(model, CurveModel::Statistical { .. });
        let (any_statistical, any_stacked) =
            (models.iter().any(statistical), !models.iter().all(statistical));
        let normalisation = match self {
            Variation::Normalisation(normalisation) => Some(*normalisation),
            _ => scene.needs.moments,
        };
        let amplitude = match self {
            Variation::Amplitude(definition) => Some(*definition),
            _ => scene.needs.amplitudes,
        };
        let curve =
            |model: &CurveModel| Curve { name: String::new(), model: *model, cutoffs: Cutoffs::Shortest };
        let needs = Needs {
            moments: normalisation.filter(|_| any_statistical),
            asperities: any_statistical,
            amplitudes: amplitude.filter(|_| any_stacked),
            curves: models.iter().map(curve).collect(),
            loads: scene.needs.loads.clone(),
            tolerance: scene.needs.tolerance,
            ..Needs::default()
        };
        Plan { psd: &scene.surface.psd, sampling, needs }
    }
}

/// The model with its strength capped, or not; `None` where its strength does not grow.
fn with_cap(model: CurveModel, cap_pa: Option<f64>) -> Option<CurveModel> {
    let capped = |strength: NixGao| -> Option<NixGao> {
        let length_m = strength.strain_gradient_length_m()?;
        let plain = NixGao::constant(strength.macroscopic_strength_pa())
            .and_then(|s| s.with_strain_gradient(length_m));
        // A cap below the strength itself is none of this body's.
        cap_pa.map_or(plain, |cap_pa| plain.and_then(|plain| plain.with_cap(cap_pa))).ok()
    };
    Some(match model {
        CurveModel::Stacked(StackedModel::ElasticPlastic { pair, strength }) => {
            CurveModel::Stacked(StackedModel::ElasticPlastic { pair, strength: capped(strength)? })
        }
        CurveModel::Statistical { pair, law: AsperityLaw::EpSphere { strength, hardness } } => {
            CurveModel::Statistical {
                pair,
                law: AsperityLaw::EpSphere { strength: capped(strength)?, hardness },
            }
        }
        CurveModel::Statistical { pair, law: AsperityLaw::EpSine { strength } } => {
            CurveModel::Statistical { pair, law: AsperityLaw::EpSine { strength: capped(strength)? } }
        }
        _ => return None,
    })
}
