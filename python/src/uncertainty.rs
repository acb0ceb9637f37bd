//! Uncertainty of areas: draws of scans, instruments and material through a scene's plan.

use report::{advice_words, uncertainty_words};
use scene::{Scene, UncertainProperty, UncertaintyChoices};
use study::bodies::Bodies;
use study::material_spreads::MaterialSpreads;
use study::models::{self, Choice, ModelEntry};
use study::plan::{Curve, Cutoffs, Needs, PlanError, Results, Tolerance};
use study::spread::Spread;

use numpy::ndarray::Array2;
use numpy::{PyArray2, ToPyArray};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use uncertainty::{AreaInterval, Settings, Uncertainty, UncertaintyPlan, scattering_groups};
use units::Bound as NumberBound;

use crate::curves::{findings, model_options};
use crate::errors::{input, of_argument};
use crate::material::{PyMaterial, loads, told};
use crate::quantities::{Given, checked, number};
use crate::surface::{PySurface, named, notes, sampling};
use crate::tables::columns;
use crate::work::carry_out;

/// A standard uncertainty: what its argument is called, what the property is given as, and the uncertainty.
type GivenSpread<'py> = (String, Given<'py>, Given<'py>);

/// Message if no input is uncertain, so that there is nothing to draw.
const NOTHING_SCATTERS: &str = "nothing of the surface or the material is known to scatter; give scans (composite) or a spectrum \
                                with standard errors (c1d_se), or say how well the material is known, such as \
                                youngs_modulus=\"5 %\"";

/// The choices that models have.
struct ModelChoices<'c> {
    strain_gradient: bool,
    hardness: Option<&'c str>,
    interference_law: Option<&'c str>,
}

/// The numbers of draws, as given.
#[derive(FromPyObject)]
pub struct DrawChoices<'py> {
    #[pyo3(item)]
    draws: Given<'py>,
    #[pyo3(item)]
    seed: Given<'py>,
    #[pyo3(item)]
    level: Given<'py>,
    #[pyo3(item)]
    shares_draws: Option<Given<'py>>,
}

/// Intervals of the areas of some models under some loads: arrays of (loads, models), tables, and what there is to say.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the arguments of a call from Python, by name")]
pub fn uncertainty_of<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    names: Vec<String>,
    pressure: &Given<'py>,
    strain_gradient: bool,
    hardness: Option<&str>,
    interference_law: Option<&str>,
    normalisation: &str,
    amplitude: &str,
    tolerance: f64,
    of_draws: DrawChoices<'py>,
    of_material: Vec<GivenSpread<'py>>,
    cutoff: Option<&Given<'py>>,
    scales_per_decade: Option<i64>,
    observer: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let choices = of_draws.checked()?;
    let of_models = ModelChoices { strain_gradient, hardness, interference_law };
    let curves = curves(&names, material, &of_models)?;
    let (normalisation, amplitude) = (named("normalisation", normalisation)?, named("amplitude", amplitude)?);
    let any = |needed: fn(&Curve) -> bool| curves.iter().any(needed);
    let needs = Needs {
        moments: any(|curve| curve.model.needs_moments()).then_some(normalisation),
        amplitudes: any(|curve| curve.model.needs_amplitudes()).then_some(amplitude),
        loads: loads("pressure", pressure, &material.material)?,
        tolerance: Tolerance::new(tolerance).map_err(input)?,
        curves,
        ..Needs::default()
    };
    let scene = Scene {
        text: String::new(),
        title: surface.surface.name.clone(),
        surface: surface.surface.clone(),
        material: Some(material.material),
        spreads: spreads(&of_material)?,
        bodies: Bodies::default(),
        sampling: sampling(&surface.surface, cutoff, scales_per_decade)?,
        needs,
        figures: Vec::new(),
        judge: None,
        uncertainty: Some(choices),
        interface: None,
        notes: Vec::new(),
    };
    if scattering_groups(&scene).is_empty() {
        return Err(input(NOTHING_SCATTERS));
    }
    let settings = Settings::from_choices(scene.uncertainty.as_ref());
    let drawn = carry_out(py, observer, |progress| -> Result<_, PlanError> {
        let results = scene.plan().compute_observed(progress)?;
        let plan = UncertaintyPlan::new(&scene, &results, &settings);
        let found = plan.map(|plan| plan.run(progress)).transpose()?;
        Ok((results, found))
    })?;
    let (results, found) = drawn.map_err(input)?;
    let found = found.ok_or_else(|| {
        input("no model has an area at the shortest wavelength under any of the pressures, so that nothing can be drawn")
    })?;
    told_of(py, &scene, &results, &found)
}

/// The models, each once, with the choices that they have.
fn curves(names: &[String], material: &PyMaterial, choices: &ModelChoices<'_>) -> PyResult<Vec<Curve>> {
    let of_all = models::MODELS;
    let entries = names.iter().map(|name| {
        of_all.iter().find(|entry| entry.name == name).ok_or_else(|| {
            let known: Vec<&str> = of_all.iter().map(|entry| entry.name).collect();
            of_argument("model", format!("'{name}' is none of {}", known.join(", ")))
        })
    });
    let entries: Vec<&ModelEntry> = entries.collect::<PyResult<_>>()?;
    if entries.is_empty() {
        return Err(of_argument("model", "it is empty; give at least one"));
    }
    if let Some((at, entry)) = entries
        .iter()
        .enumerate()
        .find(|(at, entry)| entries[..*at].iter().any(|other| other.name == entry.name))
    {
        return Err(input(format!("model[{at}] is {}, which stands twice; keep one", entry.name)));
    }
    let curve = |entry: &&'static ModelEntry| {
        // A choice that only some models have goes to those; one that none has is refused by the first.
        let theirs = |choice| entry.has(choice) || !entries.iter().any(|entry| entry.has(choice));
        let options = model_options(
            entry,
            choices.strain_gradient && theirs(Choice::StrainGradient),
            choices.hardness.filter(|_| theirs(Choice::Hardness)),
            choices.interference_law.filter(|_| theirs(Choice::Interference)),
        )?;
        Ok(Curve {
            name: entry.name.to_owned(),
            model: entry.build(&material.material, &options).map_err(|error| told(&error))?,
            cutoffs: Cutoffs::Every,
        })
    };
    entries.iter().map(curve).collect()
}

impl DrawChoices<'_> {
    fn checked(&self) -> PyResult<UncertaintyChoices> {
        let count =
            |argument: &str, given: &Given<'_>, bound| whole(argument, given, bound).map(|n| n as usize);
        let level = number("level", &self.level)?;
        Ok(UncertaintyChoices {
            level: Some(checked("level", UncertaintyChoices::LEVEL, level)?),
            draws: Some(count("draws", &self.draws, UncertaintyChoices::DRAWS)?),
            seed: Some(whole("seed", &self.seed, NumberBound::AtLeast(0.0))?),
            shares_draws: self
                .shares_draws
                .as_ref()
                .map(|given| count("shares_draws", given, UncertaintyChoices::SHARES_DRAWS))
                .transpose()?,
            off: false,
        })
    }
}

/// A whole number within its bound.
fn whole(argument: &str, given: &Given<'_>, bound: NumberBound) -> PyResult<u64> {
    let value = number(argument, given)?;
    checked(argument, bound, value)?;
    given.extract().map_err(|_| input(format!("{argument} is {value}; it must be a whole number")))
}

/// Reads the uncertainties of the material.
fn spreads(given: &[GivenSpread<'_>]) -> PyResult<MaterialSpreads> {
    let mut spreads = MaterialSpreads::default();
    let mut of_strength: Option<&str> = None;
    for (argument, value, uncertainty) in given {
        let (property, unit, into): (_, _, fn(&mut MaterialSpreads) -> &mut Option<Spread>) = match argument
            .as_str()
        {
            "youngs_modulus" => (UncertainProperty::YoungsModulus, "Pa", |to| &mut to.youngs_modulus),
            "poisson_ratio" => (UncertainProperty::PoissonRatio, "", |to| &mut to.poisson_ratio),
            "counterface_youngs_modulus" => {
                (UncertainProperty::YoungsModulus, "Pa", |to| &mut to.counterface_youngs_modulus)
            }
            "counterface_poisson_ratio" => {
                (UncertainProperty::PoissonRatio, "", |to| &mut to.counterface_poisson_ratio)
            }
            "yield_strength" => (UncertainProperty::YieldStrength, "Pa", |to| &mut to.strength),
            "indentation_hardness" => (UncertainProperty::IndentationHardness, "Pa", |to| &mut to.strength),
            _ => (UncertainProperty::StrainGradientLength, "m", |to| &mut to.strain_gradient_length),
        };
        let is_strength =
            matches!(property, UncertainProperty::YieldStrength | UncertainProperty::IndentationHardness);
        if let (true, Some(other)) = (is_strength, of_strength) {
            return Err(input(format!(
                "{other} and {argument} both have a standard uncertainty, and the hardness is three times the strength; keep \
                 one of the two"
            )));
        }
        if is_strength {
            of_strength = Some(argument);
        }
        if value.is_none() {
            return Err(input(format!(
                "{argument} has a standard uncertainty and no value; give the material one"
            )));
        }
        let (value, uncertainty) = (typed(argument, value, unit)?, typed(argument, uncertainty, unit)?);
        let uncertainty = without_sign(&uncertainty);
        let spread = property.spread(&value, uncertainty).map_err(|error| of_argument(argument, error))?;
        *into(&mut spreads) = if is_strength { spread.map(Spread::over_its_centre) } else { spread };
    }
    Ok(spreads)
}

/// A quantity as it is typed in a scene.
fn typed(argument: &str, given: &Given<'_>, unit: &str) -> PyResult<String> {
    match given.cast::<PyString>() {
        Ok(text) => Ok(text.to_string()),
        Err(_) => Ok(format!("{} {unit}", number(argument, given)?).trim_end().to_owned()),
    }
}

/// An uncertainty without the sign that a scene has before it.
fn without_sign(text: &str) -> &str {
    let text = text.trim();
    let signs = ["+-", "+/-", "±"];
    signs.into_iter().find_map(|sign| text.strip_prefix(sign)).unwrap_or(text).trim_start()
}

/// Converts the results to arrays of (loads, models) and tables.
fn told_of<'py>(
    py: Python<'py>,
    scene: &Scene,
    results: &Results,
    found: &Uncertainty,
) -> PyResult<Bound<'py, PyDict>> {
    let needs = &scene.needs;
    let array = |of: fn(&AreaInterval) -> f64| -> Bound<'py, PyArray2<f64>> {
        let at = |(load, curve): (usize, usize)| found.interval(curve, load).map_or(f64::NAN, of);
        Array2::from_shape_fn((needs.loads.len(), needs.curves.len()), at).to_pyarray(py)
    };
    let told = PyDict::new(py);
    let pressures_pa: Vec<f64> = needs.loads.iter().map(|load| load.nominal_pressure_pa()).collect();
    told.set_item("nominal_pressure_pa", pressures_pa)?;
    told.set_item("model", needs.curves.iter().map(|curve| curve.name.as_str()).collect::<Vec<_>>())?;
    let arrays = PyDict::new(py);
    arrays.set_item("area_fraction", array(|area| area.area_fraction))?;
    arrays.set_item("median", array(|area| area.median))?;
    arrays.set_item("low", array(|area| area.low))?;
    arrays.set_item("high", array(|area| area.high))?;
    arrays.set_item("low_68", array(|area| area.within_68[0]))?;
    arrays.set_item("high_68", array(|area| area.within_68[1]))?;
    arrays.set_item("ln_area_sd", array(|area| area.ln_area_sd))?;
    arrays.set_item("monte_carlo_error", array(|area| area.monte_carlo_error))?;
    told.set_item("arrays", arrays)?;
    told.set_item("shares", columns(py, &found.indices_table(needs))?)?;
    let steps = found.advice.iter().flat_map(|advice| &advice.steps);
    let in_words = steps.map(|step| advice_words::in_a_line(found, step));
    told.set_item("advice", columns(py, &found.advice_table(needs).with_text("in_words", in_words))?)?;
    told.set_item("bands", columns(py, &found.bands_table(needs))?)?;
    told.set_item("draws", found.draws)?;
    let mut said = uncertainty_words::sentences(found);
    said.extend(notes(&scene.surface));
    let plan = scene.plan();
    if let Some(material) = &scene.material {
        let of_curves = needs.curves.iter().zip(&results.curves);
        let of_curves = of_curves.flat_map(|(curve, rows)| findings(curve, rows, &plan, material));
        for note in of_curves {
            if !said.contains(&note) {
                said.push(note);
            }
        }
    }
    told.set_item("notes", said)?;
    Ok(told)
}
