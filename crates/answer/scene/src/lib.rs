#![doc = include_str!("../README.md")]
//! A scene file is read in two stages: `raw` is what may be typed, [`Scene`] what it means, in SI units and checked.

mod bodies;
mod curves;
mod error;
mod figure_style;
mod figures;
mod file_content;
pub mod file_names;
mod gas;
mod interface;
mod judge;
mod layer;
mod loads;
mod mistyped;
mod named_material;
mod notes;
mod raw;
mod reader;
mod replace;
mod resolve;
mod roughness;
mod scene_text;
mod seal;
mod section;
mod spelling;
mod surfaces;
mod template;
mod uncertain;
mod uncertainty;
mod values;

pub use error::{SceneError, SceneProblem};
pub use figure_style::FigureChoice;
pub use file_content::FileContent;
pub use judge::JudgeSettings;
pub use replace::{ReplaceError, keys_by_section, si_unit, with_keys, with_si_unit};
pub use resolve::Overrides;
pub use scene_text::SceneText;
pub use template::Template;
pub use uncertain::spread_of;
pub use uncertainty::UncertaintySettings;

use measurements::{Files, InstrumentOfScan, NoFiles};
use persson::Band;
use study::bodies::{Bodies, FromTable, Softer};
use study::choices_in_words;
use study::figure::Figure;
use study::interface::{InterfaceInputs, InterfaceRequest, InterfaceStates};
use study::material::Material;
use study::material_spreads::MaterialSpreads;
use study::plan::{Curve, Needs, Plan, Results, Sampling};
use study::surface::Surface;
use units::{Remark, number};

/// A checked scene.
#[derive(Debug, Clone)]
pub struct Scene {
    /// The scene as typed.
    pub text: String,
    /// Title of the scene.
    pub title: String,
    /// The surface and its spectrum.
    pub surface: Surface,
    /// The material; absent where no curve needs one.
    pub material: Option<Material>,
    /// Uncertainties of the material.
    pub spreads: MaterialSpreads,
    /// Further properties of the two bodies.
    pub bodies: Bodies,
    /// Cutoff and resampling of the spectrum.
    pub sampling: Sampling,
    /// Quantities to compute for the curves and figures.
    pub needs: Needs,
    /// The figures to draw.
    pub figures: Vec<Figure>,
    /// Settings of the judge; absent if the scene has no `judge` section.
    pub judge: Option<JudgeSettings>,
    /// Settings of the uncertainty analysis; absent if the scene has no `uncertainty` section.
    pub uncertainty: Option<UncertaintySettings>,
    /// Results requested of the interface besides its area; absent if none are.
    pub interface: Option<InterfaceRequest>,
    /// Keys that have no effect.
    pub notes: Vec<Remark>,
}

impl Scene {
    /// Reads a scene, and the files that it names.
    ///
    /// # Errors
    /// [`SceneError`] with place, key, value and bound.
    pub fn parse(text: &str, files: &dyn Files, overrides: &Overrides) -> Result<Self, SceneError> {
        let raw =
            raw::RawScene::parse(text).map_err(|error| match FileContent::recognise(text.as_bytes()) {
                Some(content) => SceneError::anywhere(SceneProblem::NotAScene(content)),
                None => error,
            })?;
        let (scene, ignored) = resolve::resolve(text, &raw, files, overrides)?;
        Ok(Scene { notes: notes::notes(text, &raw, &scene, &ignored, overrides), ..scene })
    }

    /// Returns a scene that comes with the program.
    ///
    /// # Errors
    /// None, unless the program was built with a broken scene.
    pub fn builtin(template: Template) -> Result<Self, SceneError> {
        Self::parse(template.text(), &NoFiles, &Overrides::default())
    }

    /// Describes the choices that the numbers of the scene depend on, besides the spectrum.
    pub fn choices(&self) -> Vec<String> {
        let mut choices: Vec<String> = self.material.iter().map(Material::describe).collect();
        choices.extend(self.bodies.describe(self.softer(), &self.spreads));
        choices.extend(self.spreads.describe());
        choices.extend(self.model_choices());
        choices
    }

    /// The choices that the models leave open.
    pub fn model_choices(&self) -> Vec<String> {
        let mut choices = Vec::new();
        let named = |choice: &str, key: &str, words: &str| format!("{choice}: {key} ({words})");
        choices.extend(self.needs.amplitudes.map(|definition| {
            named("amplitude", definition.name(), choices_in_words::amplitude(definition))
        }));
        choices.extend(self.needs.moments.map(|normalisation| {
            named(
                "normalisation of moments",
                normalisation.name(),
                choices_in_words::normalisation(normalisation),
            )
        }));
        let mut of_laws: Vec<String> = Vec::new();
        for curve in &self.needs.curves {
            of_laws.extend(curve.model.hardness().map(|hardness| {
                named("hardness of spheres", hardness.name(), choices_in_words::hardness(hardness))
            }));
            let options = curve.model.options();
            of_laws.extend(
                options.flattening.map(|held| {
                    named("flattening of spheres", held.name(), choices_in_words::flattening(held))
                }),
            );
            of_laws.extend(options.elastic_plastic_area.map(|law| {
                named("area of yielding scales", law.name(), choices_in_words::yielding_area(law))
            }));
            of_laws.extend(curve.model.interference().map(|law| {
                named("interference law of sinusoids", law.name(), choices_in_words::interference(law))
            }));
        }
        for law in self.needs.curves.iter().filter_map(|curve| curve.model.persson()) {
            let (correction, band) = (law.correction, law.band);
            of_laws.extend(correction.map(|correction| {
                named(
                    "correction of Persson's theory",
                    correction.name(),
                    choices_in_words::correction(correction),
                )
            }));
            if band != Band::default() {
                of_laws.push(named("spectrum that a cutoff ends", band.name(), choices_in_words::band(band)));
            }
        }
        of_laws.sort();
        of_laws.dedup();
        choices.extend(of_laws);
        if self.needs.curves.iter().any(|curve| curve.model.statistical().is_some()) {
            choices
                .push(format!("tolerance of statistical states: {}", number(self.needs.tolerance.value())));
        }
        choices
    }

    /// Returns the hardness H = 3 S0 \[Pa\] of the material, if it has a strength.
    pub fn hardness_pa(&self) -> Option<f64> {
        self.material?.hardness_pa()
    }

    /// The body that flows of two with a strength.
    pub fn softer(&self) -> Option<Softer> {
        self.material?.softer()
    }

    /// Returns true if anything in the scene scatters: scans, a spectrum with standard errors or holes, or the material.
    pub fn scatters(&self) -> bool {
        let parts = self.surface.each();
        parts.iter().any(|part| part.made_from.is_some() || part.scatters_by_errors())
            || !self.surface.holes.is_empty()
            || !self.spreads.is_empty()
    }

    /// Returns true if the scene itself says how an input scatters: an instrument or a calibration of a scan, or `+-` behind a property.
    pub fn states_uncertainty(&self) -> bool {
        let parts = self.surface.each();
        let mut scans =
            parts.iter().filter_map(|part| part.made_from.as_ref()).flat_map(|scans| &scans.sources);
        let says = |instrument: &InstrumentOfScan| {
            !instrument.is_guessed || instrument.z_calibration.or(instrument.slope_uncertainty).is_some()
        };
        let mut tables = [&self.bodies.from_table, &self.bodies.counterface_from_table].into_iter().flatten();
        let is_tabled = tables.any(FromTable::gives_strength);
        scans.any(|scan| says(&scan.instrument))
            || !self.spreads.elastic_are_exact()
            || self.spreads.strain_gradient_length.is_some()
            || self.spreads.strength.is_some() && !is_tabled
    }

    /// Returns true if a result depends on the normalisation of moments that the scene chooses.
    pub(crate) fn takes_normalisation(&self) -> bool {
        let takes_it = |curve: &Curve| curve.model.entry.framework.takes_normalisation();
        self.needs.curves.iter().any(takes_it)
            || self.figures.iter().any(|figure| figure.shows.needs_moments())
    }

    /// Returns the plan that computes the scene.
    pub fn plan(&self) -> Plan<'_> {
        Plan { psd: &self.surface.psd, sampling: self.sampling, needs: self.needs.clone() }
    }

    /// Returns the quantities that the scene requests of its interface, from its results; `None` if it requests none.
    pub fn interface_states<'a>(&'a self, results: &'a Results) -> Option<InterfaceStates<'a>> {
        let request = self.interface.as_ref()?;
        let material = self.material.as_ref()?;
        let inputs = InterfaceInputs {
            results,
            normalisation: self.needs.moments?,
            pair: material.pair,
            hardness_pa: material.hardness_pa(),
            hardness_grows: material.strain_gradient_length_m().is_some(),
            pressures: self.needs.loads.iter().map(|load| load.nominal_pressure).collect(),
        };
        InterfaceStates::new(request, inputs)
    }
}
