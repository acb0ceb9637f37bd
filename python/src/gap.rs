//! Mean gap and stiffness under loads.

use findings::doubts::Doubt;
use parallel::Progress;
use persson::variance::Band;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use report::{doubt_words, elements_words, gap_words, material_words};
use spectrum::Normalisation;
use study::gap_law::{GapChoices, GapLaw};
use study::material::Material;
use study::models::{self, Choice, CurveModel, Framework, ModelEntry};
use study::persson_law::PerssonLaw;
use study::plan::{Needs, NominalPressure, Plan, Sampling, Tolerance};
use study::result_tables;

use crate::boundary_elements::{GivenRandom, pressed, pressing, random_surfaces, text, whole, word};
use crate::curves::model_options;
use crate::errors::{input, of_argument};
use crate::material::{PyMaterial, loads, told};
use crate::persson::energy_factor;
use crate::quantities::Given;
use crate::surface::{PySurface, notes, sampling};
use crate::tables::columns;
use crate::work::carry_out;

/// The argument that makes a law take the waves of the surface.
pub const BY_SURFACE: &str = "band=\"2d\"";

/// The name of boundary elements among models.
const ELEMENTS: &str = "bem";

/// Choices for the models of gaps.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct GivenChoices<'py> {
    gamma: Option<Bound<'py, PyAny>>,
    band: Option<Bound<'py, PyAny>>,
    strain_gradient: bool,
    hardness: Option<Bound<'py, PyAny>>,
    interference_law: Option<Bound<'py, PyAny>>,
    normalisation: Option<Bound<'py, PyAny>>,
    cutoff: Option<Bound<'py, PyAny>>,
    scales_per_decade: Option<Bound<'py, PyAny>>,
}

/// A model of gaps with what was chosen for it.
pub struct Chosen {
    pub entry: &'static ModelEntry,
    pub sampling: Sampling,
    model: CurveModel,
    normalisation: Normalisation,
    choices: GapChoices,
}

/// Mean gap, stiffness and area under each of the pressures, and what there is to say.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
pub fn gaps<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    pressure: &Given<'py>,
    model: &str,
    choices: GivenChoices<'py>,
    tolerance: f64,
    random: GivenRandom<'py>,
) -> PyResult<(Bound<'py, PyDict>, Vec<String>)> {
    let material = &material.material;
    let needs = Needs { loads: loads("pressure", pressure, material)?, ..Needs::default() };
    let pressures_pa: Vec<f64> = needs.pressures().map(NominalPressure::pa).collect();
    if model == ELEMENTS {
        choices.refuse_for_elements()?;
        return by_elements(py, surface, material, pressures_pa, &random);
    }
    let entry = entry(model, &[ELEMENTS])?;
    let chosen = Chosen::new(entry, &choices, tolerance, material, surface)?;
    if let Some(argument) = random.given() {
        return Err(input(format!("{argument} has no bearing on model {model}, only on bem; leave it out")));
    }
    let (law, states) = carry_out(py, None, |progress| {
        let law = chosen.law(surface, progress)?;
        let state = |&pressure_pa: &f64| match progress.is_cancelled() {
            true => Err(input("the work was ended")),
            false => law.at(pressure_pa).map_err(input),
        };
        let states = parallel::try_map(&pressures_pa, state)?;
        PyResult::Ok((law, states))
    })??;
    let mut said = of_given(surface, material, Some(chosen.entry));
    let least_pa = pressures_pa.iter().copied().fold(f64::INFINITY, f64::min);
    said.extend(gap_words::of_law(&law, least_pa, BY_SURFACE));
    let rms_height_m = law.light_loads().is_none().then(|| law.rms_height_m());
    said.extend(gap_words::of_states(&states, rms_height_m));
    Ok((columns(py, &result_tables::gaps(&states, law.light_loads().as_ref()))?, said))
}

/// The mean of random surfaces under elastic boundary elements.
fn by_elements<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &Material,
    pressures_pa: Vec<f64>,
    random: &GivenRandom<'_>,
) -> PyResult<(Bound<'py, PyDict>, Vec<String>)> {
    let pressing = pressing(material, pressures_pa, None, rough_bem::Pressing::TOLERANCE)?;
    let mut said = of_given(surface, material, None);
    let (random, words) = random_surfaces(surface, &random.choices()?, &pressing)?;
    said.extend(words);
    let rms_height_m = random.band.mean_square_height_m2().sqrt();
    let loads = pressed(py, &rough_bem::Surfaces::Random(random), &pressing, None, |_| ())?;
    said.extend(elements_words::of_results(&loads));
    let states = gap_words::states_of_elements(&loads);
    said.extend(gap_words::of_states(&states, Some(rms_height_m)));
    Ok((columns(py, &result_tables::gaps(&states, None))?, said))
}

/// Returns the notes on the inputs: the spectrum, the material, and the assumptions that a model makes of it.
pub fn of_given(surface: &PySurface, material: &Material, entry: Option<&ModelEntry>) -> Vec<String> {
    let mut said = notes(&surface.surface);
    let doubt = Doubt::of_material(material);
    said.extend(doubt.map(|doubt| format!("doubtful: {}", doubt_words::line(&doubt))));
    said.extend(entry.and_then(|entry| material_words::assumed_strength(material, entry)));
    said
}

impl Chosen {
    /// A model with the choices that it has; others are refused.
    pub fn new(
        entry: &'static ModelEntry,
        given: &GivenChoices<'_>,
        tolerance: f64,
        material: &Material,
        surface: &PySurface,
    ) -> PyResult<Self> {
        let is_persson = entry.framework == Framework::Persson;
        given.refuse_idle(entry)?;
        let hardness = text("hardness", given.hardness.as_ref())?;
        let law = text("interference_law", given.interference_law.as_ref())?;
        let options = model_options(entry, given.strain_gradient, hardness.as_deref(), law.as_deref())?;
        let energy_factor = given.gamma.as_ref().map(energy_factor).transpose()?;
        let scales_per_decade = given.scales_per_decade.as_ref();
        let counts = 1..=u64::from(u32::MAX);
        let scales_per_decade =
            scales_per_decade.map(|count| whole("scales_per_decade", count, counts)).transpose()?;
        let band: Option<Band> = word("band", given.band.as_ref())?;
        let normalisation: Option<Normalisation> = word("normalisation", given.normalisation.as_ref())?;
        Ok(Chosen {
            entry,
            sampling: sampling(
                &surface.surface,
                given.cutoff.as_ref(),
                scales_per_decade.map(|count| count as i64),
            )?,
            model: entry.build(material, &options).map_err(|error| told(&error))?,
            normalisation: match is_persson {
                true => Normalisation::Parseval,
                false => normalisation.unwrap_or_default(),
            },
            choices: GapChoices {
                energy_factor: energy_factor.unwrap_or(PerssonLaw::ENERGY_FACTOR),
                band: band.unwrap_or_default(),
                tolerance: Tolerance::new(tolerance).map_err(input)?,
            },
        })
    }

    /// The law of the model with the whole spectrum.
    pub fn law(&self, surface: &PySurface, progress: &dyn Progress) -> PyResult<GapLaw> {
        let needs = Needs {
            moments: Some(self.normalisation),
            amplitudes: self.model.needs_amplitudes().then(Default::default),
            ..Needs::default()
        };
        let plan = Plan { psd: &surface.surface.psd, sampling: self.sampling, needs };
        let results = plan.compute_observed(progress).map_err(input)?;
        GapLaw::of(&self.model, &plan, &results, &self.choices).map_err(input)
    }
}

/// A model that knows a distance between the surfaces; `others` are names that are taken besides.
pub fn entry(model: &str, others: &[&str]) -> PyResult<&'static ModelEntry> {
    models::with_gaps().find(|entry| entry.name == model).ok_or_else(|| {
        let names: Vec<&str> =
            models::with_gaps().map(|entry| entry.name).chain(others.iter().copied()).collect();
        of_argument("model", format!("'{model}' is none of those with gaps, {}", names.join(", ")))
    })
}

impl GivenChoices<'_> {
    /// Refuses what the model has no use for.
    fn refuse_idle(&self, entry: &ModelEntry) -> PyResult<()> {
        let is_persson = entry.framework == Framework::Persson;
        self.refuse(
            |choice| match choice {
                "gamma" | "band" => !is_persson,
                "normalisation" => is_persson,
                "hardness" => !entry.has(Choice::Hardness),
                "interference_law" => !entry.has(Choice::Interference),
                "strain_gradient" => !entry.has(Choice::StrainGradient),
                _ => false,
            },
            &format!("model {entry}"),
        )
    }

    /// Refuses what boundary elements have no use for.
    fn refuse_for_elements(&self) -> PyResult<()> {
        let elements = "model bem, which is elastic and takes its waves by longest and shortest";
        self.refuse(|_| true, elements)
    }

    fn refuse(&self, is_idle: impl Fn(&str) -> bool, model: &str) -> PyResult<()> {
        let given = [
            ("gamma", self.gamma.is_some()),
            ("band", self.band.is_some()),
            ("normalisation", self.normalisation.is_some()),
            ("hardness", self.hardness.is_some()),
            ("interference_law", self.interference_law.is_some()),
            ("strain_gradient", self.strain_gradient),
            ("cutoff", self.cutoff.is_some()),
            ("scales_per_decade", self.scales_per_decade.is_some()),
        ];
        match given.into_iter().find(|(argument, is_given)| *is_given && is_idle(argument)) {
            None => Ok(()),
            Some((argument, _)) => Err(input(format!("{argument} has no bearing on {model}; leave it out"))),
        }
    }
}
