//! Sensitivity to modelling choices: how much each open choice moves the areas that a scene ends in.

use std::num::NonZeroU32;

use asperity::{Hardness, NixGao};
use parallel::Unobserved;
use spectrum::{AmplitudeDefinition, Normalisation};
use stat_contact::InterferenceLaw;

use crate::choices_in_words;
use crate::plan::{Curve, CurveModel, CurveResult, Cutoffs, Ground, Needs, Plan, PlanError, Results, Work};
use crate::scene::Scene;
use tables::Table;
use units::display::pressure;

/// Densities of the spectrum that are tried, in scales per decade.
const SCALES_PER_DECADE: [u32; 3] = [5, 10, 20];

/// One choice made another way.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// The choice, e.g. `normalisation of moments`.
    pub choice: &'static str,
    /// The other way, e.g. `as-printed`.
    pub setting: String,
    /// The same for people, e.g. `1, as printed in Eq. (1) of Jackson & Jacobs`.
    pub setting_in_words: String,
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
/// Only final areas are computed, and none that the results hold.
///
/// # Errors
/// [`PlanError`], as of the scene's own plan.
pub fn sensitivities(scene: &Scene, results: &Results) -> Result<Vec<Sensitivity>, PlanError> {
    counted_sensitivities(scene, results).map(|(sensitivities, _)| sensitivities)
}

/// The same, and how much was computed for them.
///
/// # Errors
/// Those of [`sensitivities`].
pub fn counted_sensitivities(
    scene: &Scene,
    results: &Results,
) -> Result<(Vec<Sensitivity>, Work), PlanError> {
    let varied = Varied::all(scene);
    let mut work = Work::default();
    let own = FinalAreas::new(scene.needs.curves.iter().map(|curve| curve.model).collect(), &results.curves);
    // Laws made another way stand on the spectrum as it is: one plan has them all, and the scene some of them.
    let laws = varied.iter().filter(|varied| varied.variation.is_of_a_law()).flat_map(Varied::models);
    let laws: Vec<CurveModel> = laws.filter(|model| !own.models.contains(model)).collect();
    let of_laws = match laws[..] {
        [] => Vec::new(),
        _ => {
            let found = plan(scene, None, &laws).compute_on(Ground::of(results), &Unobserved)?;
            work += found.work;
            found.curves
        }
    };
    let of_laws = FinalAreas::new(laws, &of_laws);
    let mut sensitivities = Vec::new();
    for varied in &varied {
        let rows = if varied.variation.is_of_a_law() {
            varied.rows(scene, &own, |model, load| own.of(model, load).or_else(|| of_laws.of(model, load)))
        } else {
            let models: Vec<CurveModel> = varied.models().collect();
            let found = plan(scene, Some(varied.variation), &models).compute()?;
            work += found.work;
            let found = FinalAreas::new(models, &found.curves);
            varied.rows(scene, &own, |model, load| found.of(model, load))
        };
        let variation = varied.variation;
        let (choice, setting) = (variation.choice(), variation.setting());
        sensitivities.push(Sensitivity { choice, setting, setting_in_words: variation.in_words(), rows });
    }
    Ok((sensitivities, work))
}

/// How many final areas the sensitivities of a scene are about.
pub fn wanted_areas(scene: &Scene) -> usize {
    Varied::all(scene).iter().map(|varied| varied.curves.len() * scene.needs.loads.len()).sum()
}

/// A choice made another way, and the curves that depend on it.
struct Varied {
    variation: Variation,
    /// The curves of the scene, by index, and their models with the choice made that way.
    curves: Vec<(usize, CurveModel)>,
}

impl Varied {
    /// Every choice that a curve depends on, made every other way.
    fn all(scene: &Scene) -> Vec<Self> {
        let curves = |variation: &Variation| {
            let curves = scene.needs.curves.iter().enumerate();
            curves.filter_map(|(at, curve)| Some((at, variation.of(&curve.model)?))).collect()
        };
        let varied =
            variations(scene).into_iter().map(|variation| Varied { curves: curves(&variation), variation });
        varied.filter(|varied| !varied.curves.is_empty() && !scene.needs.loads.is_empty()).collect()
    }

    fn models(&self) -> impl Iterator<Item = CurveModel> {
        self.curves.iter().map(|(_, model)| *model)
    }

    fn rows(
        &self,
        scene: &Scene,
        own: &FinalAreas<'_>,
        area_fraction: impl Fn(&CurveModel, usize) -> Option<f64>,
    ) -> Vec<Moved> {
        let mut rows = Vec::new();
        for (curve, model) in &self.curves {
            for load in 0..scene.needs.loads.len() {
                let areas = area_fraction(model, load).zip(own.of_curve(*curve, load));
                rows.extend(areas.map(|(area_fraction, own)| Moved {
                    curve: *curve,
                    load,
                    area_fraction,
                    ratio: area_fraction / own,
                }));
            }
        }
        rows
    }
}

/// The areas that models end in.
struct FinalAreas<'r> {
    models: Vec<CurveModel>,
    curves: &'r [CurveResult],
}

impl<'r> FinalAreas<'r> {
    fn new(models: Vec<CurveModel>, curves: &'r [CurveResult]) -> Self {
        FinalAreas { models, curves }
    }

    fn of(&self, model: &CurveModel, load: usize) -> Option<f64> {
        let curve = self.models.iter().position(|other| other == model)?;
        self.of_curve(curve, load)
    }

    fn of_curve(&self, curve: usize, load: usize) -> Option<f64> {
        self.curves[curve].area_fractions(load).last().map(|(_, area_fraction)| *area_fraction)
    }
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
    variations.extend(InterferenceLaw::ALL.iter().copied().map(Variation::Interference));
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

    fn in_words(&self) -> String {
        match self {
            Variation::Normalisation(choice) => choices_in_words::normalisation(*choice).to_owned(),
            Variation::Amplitude(choice) => choices_in_words::amplitude(*choice).to_owned(),
            Variation::Hardness(choice) => choices_in_words::hardness(*choice).to_owned(),
            Variation::Interference(choice) => choices_in_words::interference(*choice).to_owned(),
            Variation::ScalesPerDecade(_) | Variation::StrengthCap(_) => self.setting(),
        }
    }

    /// The model with the choice made this way; `None` where that is its own way, or no choice of its.
    fn of(&self, model: &CurveModel) -> Option<CurveModel> {
        let statistical = matches!(model, CurveModel::Statistical { .. });
        let varied = match (*self, *model) {
            (Variation::Normalisation(_), _) if statistical => return Some(*model),
            (Variation::Amplitude(_), _) if !statistical => return Some(*model),
            (Variation::ScalesPerDecade(_), _) => return Some(*model),
            (Variation::Hardness(hardness), model) => model.with_hardness(hardness)?,
            (Variation::Interference(interference), model) => model.with_interference(interference)?,
            (Variation::StrengthCap(cap_pa), model) => with_cap(model, cap_pa)?,
            _ => return None,
        };
        (varied != *model).then_some(varied)
    }

    /// Whether the spectrum, its moments and amplitudes stay as they are.
    fn is_of_a_law(&self) -> bool {
        match self {
            Variation::Hardness(_) | Variation::Interference(_) | Variation::StrengthCap(_) => true,
            Variation::Normalisation(_) | Variation::Amplitude(_) | Variation::ScalesPerDecade(_) => false,
        }
    }
}

/// What yields the final areas of these models under the loads of the scene, with a choice made another way or as they
/// are.
fn plan<'s>(scene: &'s Scene, variation: Option<Variation>, models: &[CurveModel]) -> Plan<'s> {
    let mut sampling = scene.sampling;
    let (mut normalisation, mut amplitude) = (scene.needs.moments, scene.needs.amplitudes);
    match variation {
        Some(Variation::Normalisation(other)) => normalisation = Some(other),
        Some(Variation::Amplitude(other)) => amplitude = Some(other),
        Some(Variation::ScalesPerDecade(density)) => sampling.scales_per_decade = Some(density),
        _ => {}
    }
    let statistical = |model: &CurveModel| matches!(model, CurveModel::Statistical { .. });
    let (any_statistical, any_stacked) = (models.iter().any(statistical), !models.iter().all(statistical));
    let curve = |model: &CurveModel| Curve { name: String::new(), model: *model, cutoffs: Cutoffs::Shortest };
    let needs = Needs {
        moments: normalisation.filter(|_| any_statistical),
        amplitudes: amplitude.filter(|_| any_stacked),
        curves: models.iter().map(curve).collect(),
        loads: scene.needs.loads.clone(),
        tolerance: scene.needs.tolerance,
        ..Needs::default()
    };
    Plan { psd: &scene.surface.psd, sampling, needs }
}

/// The model with its strength capped, or not; `None` where its strength does not grow.
fn with_cap(model: CurveModel, cap_pa: Option<f64>) -> Option<CurveModel> {
    let strength = model.strength()?;
    let length_m = strength.strain_gradient_length_m()?;
    let plain =
        NixGao::constant(strength.macroscopic_strength_pa()).and_then(|s| s.with_strain_gradient(length_m));
    // A cap below the strength itself is none of this body's.
    let capped = cap_pa.map_or(plain, |cap_pa| plain.and_then(|plain| plain.with_cap(cap_pa))).ok()?;
    model.with_strength(capped)
}
