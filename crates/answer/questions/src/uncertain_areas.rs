//! Coverage intervals of the areas of several models.

use numerics::parallel::Progress;
use scene::{Scene, UncertaintySettings};
use spectrum::{AmplitudeDefinition, Normalisation};
use study::bodies::Bodies;
use study::material_spreads::MaterialSpreads;
use study::models::{Choice, ModelEntry, ModelOptions};
use study::plan::{Curve, Needs, Results, Tolerance};
use study::surface::Surface;
use uncertainty::{Uncertainty, UncertaintyPlan, scattering_groups};
use units::{Remark, RemarkCode};

use crate::option::{first_given, not_of_model};
use crate::{CurveQuestion, LoadInput, MaterialInput, PreparedCurve, QuestionError, SamplingInput};

/// Areas of some models under some loads, with their coverage intervals from draws of scans, instruments and material.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct UncertaintyQuestion {
    /// The models, each once.
    pub models: Vec<&'static ModelEntry>,
    /// Choices that models leave open; each goes to the models that have it.
    pub options: ModelOptions,
    /// The bodies in contact.
    pub material: MaterialInput,
    /// Uncertainties of their properties.
    pub spreads: MaterialSpreads,
    /// Nominal pressures.
    pub pressures: Vec<LoadInput>,
    /// Scales that take part.
    pub sampling: SamplingInput,
    /// Normalisation of moments, for the models that take them.
    pub normalisation: Option<Normalisation>,
    /// Definition of amplitudes, for the models that take them.
    pub amplitude: Option<AmplitudeDefinition>,
    /// Relative tolerance of statistical states, for the models that have them.
    pub tolerance: Option<Tolerance>,
    /// Settings of the draws.
    pub choices: UncertaintySettings,
}

/// Areas with their coverage intervals.
pub struct UncertainAreas {
    /// The scene whose inputs were drawn.
    pub scene: Scene,
    /// The areas without uncertainty.
    pub results: Results,
    /// Intervals, their origin, and advice.
    pub uncertainty: Uncertainty,
}

impl UncertaintyQuestion {
    /// Computes the areas, and draws their inputs.
    ///
    /// # Errors
    /// [`QuestionError`]; also if nothing scatters, or no model has an area at the shortest wavelength.
    pub fn answer(
        &self,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<UncertainAreas, QuestionError> {
        let scene = self.scene(surface)?;
        let scattering = scattering_groups(&scene).len();
        if scattering == 0 {
            return Err(QuestionError::NothingScatters);
        }
        let has_design = self.choices.shares_draws.is_some();
        first_given(
            [("shares_draws", has_design && scattering == 1)],
            Remark::new(RemarkCode::OneInputScatters),
        )?;
        let results = scene.plan().compute_observed(progress)?;
        let plan = UncertaintyPlan::new(&scene, &results, &self.choices);
        let uncertainty = plan.ok_or(QuestionError::NothingToDraw)?.run(progress)?;
        Ok(UncertainAreas { scene, results, uncertainty })
    }

    /// Writes the scene that has the curves and the uncertainties.
    fn scene(&self, surface: &Surface) -> Result<Scene, QuestionError> {
        self.sampling.check(surface)?;
        Ok(Scene {
            text: String::new(),
            title: surface.name.clone(),
            surface: surface.clone(),
            material: Some(self.material.material()?),
            spreads: self.spreads.clone(),
            bodies: Bodies::default(),
            sampling: self.sampling.sampling(),
            needs: self.needs()?,
            figures: Vec::new(),
            judge: None,
            uncertainty: Some(self.choices),
            interface: None,
            notes: Vec::new(),
        })
    }

    fn needs(&self) -> Result<Needs, QuestionError> {
        let mut needs = Needs { tolerance: self.tolerance.unwrap_or_default(), ..Needs::default() };
        for entry in &self.models {
            // A choice that no model has is refused by the first.
            let has = |choice| entry.has(choice) || !self.models.iter().any(|entry| entry.has(choice));
            let options = ModelOptions {
                strain_gradient: self.options.strain_gradient && has(Choice::StrainGradient),
                hardness: self.options.hardness.filter(|_| has(Choice::Hardness)),
                flattening: self.options.flattening.filter(|_| has(Choice::Flattening)),
                elastic_plastic_area: self.options.elastic_plastic_area.filter(|_| has(Choice::YieldingArea)),
                interference_law: self.options.interference_law.filter(|_| has(Choice::Interference)),
                ..ModelOptions::default()
            };
            let question = CurveQuestion {
                model: Some(entry),
                name: Some(entry.name.to_owned()),
                material: self.material.used_with(&options),
                options,
                pressures: self.pressures.clone(),
                ..CurveQuestion::default()
            };
            let of_curve = question.needs()?;
            needs.curves.extend(of_curve.curves);
            needs.loads = of_curve.loads;
        }
        let any = |needed: fn(&Curve) -> bool| needs.curves.iter().any(needed);
        let (has_moments, has_amplitudes) =
            (any(|curve| curve.model.needs_moments()), any(|curve| curve.model.needs_amplitudes()));
        let takes_normalisation = self.models.iter().any(|entry| entry.framework.takes_normalisation());
        let ignored = [
            ("normalisation", self.normalisation.is_some() && !takes_normalisation),
            ("amplitude", self.amplitude.is_some() && !has_amplitudes),
            ("tolerance", self.tolerance.is_some() && !any(|curve| curve.model.takes_separations())),
        ];
        first_given(ignored, not_of_model(self.models[0].name))?;
        let moments = has_moments.then(|| self.normalisation.unwrap_or_default());
        let amplitudes = has_amplitudes.then(|| self.amplitude.unwrap_or_default());
        Ok(Needs { moments, amplitudes, ..needs })
    }
}

impl UncertainAreas {
    /// Lists the notes on the surface and on every curve.
    #[must_use]
    pub fn notes(&self) -> Vec<Remark> {
        let of_surface = self.scene.surface.notes.iter().cloned();
        let of_curves = self.results.curves.iter().enumerate();
        let of_curves =
            of_curves.flat_map(|(at, rows)| PreparedCurve::of_scene(&self.scene, at).notes_on(rows));
        of_surface.chain(of_curves).collect()
    }
}
