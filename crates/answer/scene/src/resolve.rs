//! Conversion of the typed text of a scene to its resolved values.

use std::num::NonZeroU32;

use asperity::{ElasticBody, Hardness};
use spectrum::{AmplitudeDefinition, Normalisation};

use super::Scene;
use super::bodies::{UncertainCounterface, resolve_counterface, resolve_material};
use super::curves::{curves_that_apply, resolve_curves};
use super::error::SceneError;
use super::figures::resolve_figures;
use super::file_names;
use super::interface::{check_flatness, resolve_interface};
use super::judge::resolve_judge;
use super::loads::{nominal_area_m2, resolve_loads};
use super::raw::{RawScene, given};
use super::surfaces::resolve_surface;
use super::uncertainty::resolve_uncertainty;
use super::values::{count, tolerance};
use measurements::Files;
use study::bodies::Bodies;
use study::figure::Shows;
use study::material_spreads::MaterialSpreads;
use study::models::{Choice, CurveModel, ModelOptions};
use study::plan::{Curve, Needs, Sampling};
use study::surface::Surface;
use units::{Length, Pressure, Remark, RemarkCode};

/// Options given outside the scene, which count more than the scene's own.
#[derive(Debug, Clone, Default)]
pub struct Overrides {
    /// Surface in memory, whose files the scene names for its readers and which are not read.
    pub surface: Option<Surface>,
    /// Surface of the counterface in memory, likewise.
    pub counterface_surface: Option<Surface>,
    /// Normalisation of the moments.
    pub normalisation: Option<Normalisation>,
    /// Definition of the amplitude.
    pub amplitude: Option<AmplitudeDefinition>,
    /// Scales per decade to resample to.
    pub scales_per_decade: Option<NonZeroU32>,
    /// Form of the hardness of spheres.
    pub hardness: Option<Hardness>,
    /// Cap of a growing strength.
    pub strength_cap: Option<Pressure>,
    /// Shortest wavelength kept.
    pub cutoff: Option<Length>,
    /// Counterface.
    pub counterface: Option<ElasticBody>,
}

impl Overrides {
    /// Returns the name of the first override that a scene ignores, if any. Cutoff and counterface are not checked.
    #[must_use]
    pub fn first_unused(&self, scene: &Scene) -> Option<&'static str> {
        let unused = self.uses(scene).into_iter().find(|(_, is_given, is_used, _)| *is_given && !is_used);
        unused.map(|(name, ..)| name)
    }

    /// Options by name, whether they are given here and used in a scene, and the reason if they are not used.
    pub(super) fn uses(&self, scene: &Scene) -> [(&'static str, bool, bool, RemarkCode); 4] {
        use RemarkCode::{NoCurveUsesIt, NothingNeedsIt};
        let any = |has: fn(&CurveModel) -> bool| scene.needs.curves.iter().any(|curve| has(&curve.model));
        let yields = any(|model| model.entry.has(Choice::Hardness));
        [
            ("normalisation", self.normalisation.is_some(), scene.takes_normalisation(), NothingNeedsIt),
            ("amplitude", self.amplitude.is_some(), scene.needs.amplitudes.is_some(), NothingNeedsIt),
            ("hardness_formula", self.hardness.is_some(), yields, NoCurveUsesIt),
            ("strength_cap", self.strength_cap.is_some(), any(CurveModel::strength_grows), NoCurveUsesIt),
        ]
    }
}

/// Returns the scene without its notes, and the options that the model of each curve ignores.
pub(super) fn resolve(
    text: &str,
    raw: &RawScene,
    files: &dyn Files,
    overrides: &Overrides,
) -> Result<(Scene, Vec<Vec<Remark>>), SceneError> {
    let options = &raw.options;
    let strength_cap = overrides.strength_cap.or_else(|| given(&options.strength_cap));
    let counterface = match (overrides.counterface, &raw.counterface) {
        (Some(body), _) => UncertainCounterface::exactly(body),
        (None, Some(raw)) => resolve_counterface(raw)?,
        (None, None) => UncertainCounterface::default(),
    };
    let (material, spreads, bodies) = match &raw.material {
        Some(material) => {
            let (material, spreads, bodies) = resolve_material(material, counterface, strength_cap)?;
            (Some(material), spreads, bodies)
        }
        None => (None, MaterialSpreads::default(), Bodies::default()),
    };
    let cutoff = given(&raw.cutoffs.shortest_wavelength);
    let per_decade =
        options.scales_per_decade.as_ref().map(|raw| count("options.scales_per_decade", raw)).transpose()?;
    let law_options = ModelOptions {
        hardness: overrides.hardness.or(options.hardness_formula),
        flattening: options.flattening,
        elastic_plastic_area: options.elastic_plastic_area,
        interference_law: options.interference_law,
        ..ModelOptions::default()
    };
    let (mut curves, ignored) = resolve_curves(&raw.curve, material.as_ref(), &law_options, files)?;
    let judges_all = raw.judge.as_ref().is_some_and(|judge| judge.all_models);
    let asks_for_areas =
        raw.figure.is_empty() || raw.figure.iter().any(|figure| figure.get_ref().shows.draws_areas());
    let runs_all = judges_all || (raw.curve.is_empty() && asks_for_areas && raw.loads.is_some());
    if let Some(material) = material.as_ref().filter(|_| runs_all) {
        let others = curves_that_apply(material, &law_options);
        let is_listed = |curve: &Curve| curves.iter().any(|listed| listed.name == curve.name);
        let others: Vec<Curve> = others.into_iter().filter(|curve| !is_listed(curve)).collect();
        curves.extend(others);
    }
    let loads = match &raw.loads {
        Some(loads) => resolve_loads(loads, material.as_ref())?,
        None if curves.is_empty() => Vec::new(),
        None => {
            return Err(SceneError::anywhere(
                "the scene has curves but no section [loads]; add pressures = [...]",
            ));
        }
    };
    let (figures, sweeps) = resolve_figures(raw, &curves, &loads, material.as_ref())?;
    file_names::check(raw, &curves, &figures)?;
    let any_with_moments = curves.iter().any(|curve| curve.model.needs_moments());
    let any_with_amplitudes = curves.iter().any(|curve| curve.model.needs_amplitudes());
    let shows = |needs: fn(Shows) -> bool| figures.iter().any(|figure| needs(figure.shows));
    let normalisation = overrides.normalisation.or(options.normalisation).unwrap_or_default();
    let amplitude = overrides.amplitude.or(options.amplitude).unwrap_or_default();
    let judge = raw.judge.as_ref().map(resolve_judge).transpose()?;
    let uncertainty = raw.uncertainty.as_ref().map(resolve_uncertainty).transpose()?;
    let area_m2 = raw.loads.as_ref().and_then(nominal_area_m2);
    let interface = resolve_interface(raw, material.as_ref(), &bodies, area_m2)?;
    if interface.is_some() && (material.is_none() || loads.is_empty()) {
        return Err(SceneError::anywhere(
            "[interface] and [seal] need a [material] and [loads]: gap and stiffness are those under a load",
        ));
    }
    if interface.is_some() && material.is_some_and(|material| material.pair.layer().is_some()) {
        return Err(SceneError::anywhere(
            "[interface] and [seal] compute half-spaces alone, and the material has a layer; leave out the section or material.layer",
        ));
    }
    if curves.is_empty() && figures.is_empty() && interface.is_none() {
        return Err(SceneError::anywhere(match raw.loads.is_some() && material.is_none() {
            true => "the scene has loads and no material; add [material] with name = \"...\"",
            false => "the scene asks for nothing; add a [[curve]] or a [[figure]], or [material] and [loads]",
        }));
    }
    let own = match &overrides.surface {
        Some(surface) => surface.clone(),
        None => resolve_surface("surface", &raw.surface, files)?,
    };
    let other = raw.counterface.as_ref().and_then(|raw| raw.get_ref().surface.as_ref());
    let surface = match (&overrides.counterface_surface, other) {
        (Some(other), Some(_)) => own.against(other.clone()),
        (None, Some(other)) => own.against(resolve_surface("counterface.surface", other, files)?),
        (_, None) => own,
    };
    check_flatness(raw, surface.psd.longest_wavelength_m())?;
    let scene = Scene {
        text: text.to_owned(),
        title: raw.title.clone().unwrap_or_else(|| surface.name.clone()),
        surface,
        material,
        spreads,
        bodies,
        sampling: Sampling {
            scales_per_decade: overrides.scales_per_decade.or(per_decade),
            cutoff_m: overrides.cutoff.or(cutoff).map(|cutoff| cutoff.m),
        },
        needs: Needs {
            moments: (any_with_moments || interface.is_some() || shows(Shows::needs_moments))
                .then_some(normalisation),
            amplitudes: (any_with_amplitudes || shows(Shows::needs_amplitudes)).then_some(amplitude),
            curves,
            loads,
            sweeps,
            tolerance: options.tolerance.as_ref().map(tolerance).transpose()?.unwrap_or_default(),
            ..Needs::default()
        },
        figures,
        judge,
        uncertainty,
        interface,
        notes: Vec::new(),
    };
    Ok((scene, ignored))
}
