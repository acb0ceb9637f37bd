//! Sensitivity of the final areas of a scene to each open modelling choice.

use std::borrow::Cow;

use numerics::parallel::Progress;
use serde::Serialize;
use tables::Table;

use scene::Scene;
use study::plan::{
    Curve, CurveModel, CurveResult, Cutoffs, Needs, Plan, PlanError, PreparedSpectrum, Results, Work,
};

use super::variation::{Variation, variations};

/// A modelling choice made differently.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sensitivity {
    /// The choice, e.g. `normalisation of moments`.
    pub choice: &'static str,
    /// The other setting, e.g. `as-printed`.
    pub setting: String,
    /// The other setting in words, e.g. `1, as printed in Eq. (1) of Jackson & Jacobs`.
    pub setting_in_words: String,
    /// The areas that depend on the choice.
    pub rows: Vec<MovedArea>,
}

/// An area that a choice changes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MovedArea {
    /// The curve, by index.
    pub curve: usize,
    /// The load, by index.
    pub load: usize,
    /// The final area fraction with the other setting.
    pub area_fraction: f64,
    /// The final area fraction over that with the scene's own setting.
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
        .with_numbers(
            "nominal_pressure_pa",
            rows().map(|(_, row)| needs.loads[row.load].nominal_pressure_pa()),
        )
        .with_numbers("area_fraction", rows().map(|(_, row)| row.area_fraction))
        .with_numbers("ratio", rows().map(|(_, row)| row.ratio))
}

/// Computes the sensitivities to every open choice that curves of the scene depend on; `results` are those with its own
/// choices. Only final areas are computed, and none that the results hold. `progress` advances once per statistical
/// state.
///
/// # Errors
/// [`PlanError`], as of the scene's own plan.
pub fn sensitivities(
    scene: &Scene,
    results: &Results,
    progress: &dyn Progress,
) -> Result<Vec<Sensitivity>, PlanError> {
    sensitivities_with_work(scene, results, progress).map(|(sensitivities, _)| sensitivities)
}

/// Computes the sensitivities and counts the work.
///
/// # Errors
/// The errors of [`sensitivities`].
pub fn sensitivities_with_work(
    scene: &Scene,
    results: &Results,
    progress: &dyn Progress,
) -> Result<(Vec<Sensitivity>, Work), PlanError> {
    let varied = Varied::all(scene);
    let own_models = scene.needs.curves.iter().map(|curve| curve.model.clone()).collect();
    let own = FinalAreas { models: own_models, curves: Cow::Borrowed(&results.curves[..]) };
    let (of_laws, mut work) = areas_of_other_laws(scene, results, &varied, &own, progress)?;
    let mut sensitivities = Vec::new();
    for varied in &varied {
        let variation = varied.variation;
        let rows = if variation.is_of_a_law() {
            varied.rows(scene, &own, |model, load| own.of(model, load).or_else(|| of_laws.of(model, load)))
        } else {
            let models: Vec<CurveModel> = varied.models().collect();
            let found = plan(scene, Some(variation), &models).compute_observed(progress)?;
            work += found.work;
            let found = FinalAreas { models, curves: Cow::Owned(found.curves) };
            varied.rows(scene, &own, |model, load| found.of(model, load))
        };
        let (choice, setting) = (variation.choice(), variation.setting());
        sensitivities.push(Sensitivity { choice, setting, setting_in_words: variation.in_words(), rows });
    }
    Ok((sensitivities, work))
}

/// Computes the areas with other laws, which need the same spectrum: one plan holds all that the results of the scene
/// lack.
fn areas_of_other_laws(
    scene: &Scene,
    results: &Results,
    varied: &[Varied],
    own: &FinalAreas<'_>,
    progress: &dyn Progress,
) -> Result<(FinalAreas<'static>, Work), PlanError> {
    let laws = varied.iter().filter(|varied| varied.variation.is_of_a_law()).flat_map(Varied::models);
    let models: Vec<CurveModel> = laws.filter(|model| !own.models.contains(model)).collect();
    if models.is_empty() {
        return Ok((FinalAreas { models, curves: Cow::Owned(Vec::new()) }, Work::default()));
    }
    let found = plan(scene, None, &models).compute_on(PreparedSpectrum::from_results(results), progress)?;
    Ok((FinalAreas { models, curves: Cow::Owned(found.curves) }, found.work))
}

/// The number of final areas in the sensitivities of a scene.
pub fn wanted_areas(scene: &Scene) -> usize {
    Varied::all(scene).iter().map(|varied| varied.curves.len() * scene.needs.loads.len()).sum()
}

/// A choice made differently, and the curves that depend on it.
struct Varied {
    variation: Variation,
    /// The curves of the scene, by index, and their models with the choice made that way.
    curves: Vec<(usize, CurveModel)>,
}

impl Varied {
    /// Every choice that a curve depends on, in every other setting.
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
        self.curves.iter().map(|(_, model)| model.clone())
    }

    fn rows(
        &self,
        scene: &Scene,
        own: &FinalAreas<'_>,
        area_fraction: impl Fn(&CurveModel, usize) -> Option<f64>,
    ) -> Vec<MovedArea> {
        let mut rows = Vec::new();
        for (curve, model) in &self.curves {
            for load in 0..scene.needs.loads.len() {
                let areas = area_fraction(model, load).zip(own.of_curve(*curve, load));
                rows.extend(areas.map(|(area_fraction, own)| MovedArea {
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

/// The final areas of models.
struct FinalAreas<'r> {
    models: Vec<CurveModel>,
    /// The curve of each model.
    curves: Cow<'r, [CurveResult]>,
}

impl FinalAreas<'_> {
    fn of(&self, model: &CurveModel, load: usize) -> Option<f64> {
        let curve = self.models.iter().position(|other| other == model)?;
        self.of_curve(curve, load)
    }

    fn of_curve(&self, curve: usize, load: usize) -> Option<f64> {
        self.curves[curve].area_fractions(load).last().map(|(_, area_fraction)| *area_fraction)
    }
}

/// The plan for the final areas of these models under the loads of the scene, with at most one choice made differently.
fn plan<'s>(scene: &'s Scene, variation: Option<Variation>, models: &[CurveModel]) -> Plan<'s> {
    let mut sampling = scene.sampling;
    let (mut normalisation, mut amplitude) = (scene.needs.moments, scene.needs.amplitudes);
    match variation {
        Some(Variation::Normalisation(other)) => normalisation = Some(other),
        Some(Variation::Amplitude(other)) => amplitude = Some(other),
        Some(Variation::ScalesPerDecade(density)) => sampling.scales_per_decade = Some(density),
        _ => {}
    }
    let any_with_moments = models.iter().any(CurveModel::needs_moments);
    let any_with_amplitudes = models.iter().any(CurveModel::needs_amplitudes);
    let curve =
        |model: &CurveModel| Curve { name: String::new(), model: model.clone(), cutoffs: Cutoffs::Shortest };
    let needs = Needs {
        moments: normalisation.filter(|_| any_with_moments),
        amplitudes: amplitude.filter(|_| any_with_amplitudes),
        curves: models.iter().map(curve).collect(),
        loads: scene.needs.loads.clone(),
        tolerance: scene.needs.tolerance,
        areas_alone: true,
        ..Needs::default()
    };
    Plan { psd: &scene.surface.psd, sampling, needs }
}
