//! Uncertainty of areas: draws of scans, instruments and material through a scene's plan.

use numpy::ndarray::Array2;
use numpy::{PyArray2, ToPyArray};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};
use questions::{CurveQuestion, Note, NotePlace, PreparedCurve};
use report::{advice_words, uncertainty_words};
use scene::{Scene, UncertainProperty, UncertaintyChoices};
use study::bodies::Bodies;
use study::material_spreads::MaterialSpreads;
use study::models::{self, Choice, ModelEntry, ModelOptions};
use study::plan::{Curve, Needs, PlanError, Results, Tolerance};
use study::spread::Spread;
use uncertainty::{AreaInterval, Settings, Uncertainty, UncertaintyPlan, scattering_groups};
use units::Bound as NumberBound;

use crate::answer::{Told, columns, in_text, refused, words};
use crate::arguments::{Arguments, Given, number, without_unit};
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// A standard uncertainty: what its argument is called, what the property is given as, and the uncertainty.
type GivenSpread<'py> = (String, Given<'py>, Given<'py>);

/// Message if no input is uncertain, so that there is nothing to draw.
const NOTHING_SCATTERS: &str = "nothing of the surface or the material is known to scatter; give scans (composite) or a spectrum \
                                with standard errors (c1d_se), or say how well the material is known, such as \
                                youngs_modulus=\"5 %\"";

/// Intervals of the areas of some models under some loads: arrays of (loads, models), tables, and what there is to say.
#[pyfunction]
pub fn uncertainty_of<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    names: Vec<String>,
    of_material: Vec<GivenSpread<'py>>,
    arguments: Arguments<'py>,
    observer: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let sampling = arguments.sampling()?;
    sampling.check(&surface.surface).map_err(refused)?;
    let scene = Scene {
        text: String::new(),
        title: surface.surface.name.clone(),
        surface: surface.surface.clone(),
        material: Some(material.material),
        spreads: spreads(&of_material)?,
        bodies: Bodies::default(),
        sampling: sampling.sampling(),
        needs: needs(&names, material, &arguments)?,
        figures: Vec::new(),
        judge: None,
        uncertainty: Some(choices(&arguments)?),
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

/// The models, each once, with the choices that they have, and their loads.
fn needs(names: &[String], material: &PyMaterial, arguments: &Arguments<'_>) -> PyResult<Needs> {
    let of_all = models::MODELS;
    let entries = names.iter().map(|name| {
        of_all.iter().find(|entry| entry.name == name).ok_or_else(|| {
            let known: Vec<&str> = of_all.iter().map(|entry| entry.name).collect();
            of_argument("model", format!("'{name}' is none of {}", known.join(", ")))
        })
    });
    let entries: Vec<&'static ModelEntry> = entries.collect::<PyResult<_>>()?;
    if entries.is_empty() {
        return Err(of_argument("model", "it is empty; give at least one"));
    }
    let given = arguments.model_options()?;
    let pressures = arguments.pressures()?;
    let mut needs = Needs::default();
    for (at, entry) in entries.iter().enumerate() {
        if entries[..at].iter().any(|other| other.name == entry.name) {
            return Err(input(format!("model[{at}] is {}, which stands twice; keep one", entry.name)));
        }
        // A choice that only some models have goes to those; one that none has is refused by the first.
        let theirs = |choice| entry.has(choice) || !entries.iter().any(|entry| entry.has(choice));
        let options = ModelOptions {
            strain_gradient: given.strain_gradient && theirs(Choice::StrainGradient),
            hardness: given.hardness.filter(|_| theirs(Choice::Hardness)),
            interference_law: given.interference_law.filter(|_| theirs(Choice::Interference)),
            ..ModelOptions::default()
        };
        let question = CurveQuestion {
            model: Some(entry),
            name: Some(entry.name.to_owned()),
            material: material.input.used_with(&options),
            options,
            pressures: pressures.clone(),
            ..CurveQuestion::default()
        };
        let of_curve = question.needs().map_err(refused)?;
        needs.curves.extend(of_curve.curves);
        needs.loads = of_curve.loads;
    }
    let any = |needed: fn(&Curve) -> bool| needs.curves.iter().any(needed);
    let tolerance = arguments.required("tolerance", number)?;
    Ok(Needs {
        moments: arguments.named("normalisation")?.filter(|_| any(|curve| curve.model.needs_moments())),
        amplitudes: arguments.named("amplitude")?.filter(|_| any(|curve| curve.model.needs_amplitudes())),
        tolerance: Tolerance::new(tolerance).map_err(input)?,
        ..needs
    })
}

/// The numbers of draws.
fn choices(arguments: &Arguments<'_>) -> PyResult<UncertaintyChoices> {
    let whole = |argument: &str, bound: NumberBound| -> PyResult<Option<u64>> {
        let Some(value) = arguments.number(argument, Some(bound))? else { return Ok(None) };
        let whole = arguments.raw(argument)?.extract();
        whole.map(Some).map_err(|_| input(format!("{argument} is {value}; it must be a whole number")))
    };
    let count = |argument: &str, bound| Ok::<_, PyErr>(whole(argument, bound)?.map(|count| count as usize));
    Ok(UncertaintyChoices {
        level: arguments.number("level", Some(UncertaintyChoices::LEVEL))?,
        draws: count("draws", UncertaintyChoices::DRAWS)?,
        seed: whole("seed", NumberBound::AtLeast(0.0))?,
        shares_draws: count("shares_draws", UncertaintyChoices::SHARES_DRAWS)?,
        off: false,
    })
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
        refuse_bare_share(argument, uncertainty, unit)?;
        let (value, uncertainty) = (typed(argument, value, unit)?, typed(argument, uncertainty, unit)?);
        let uncertainty = without_sign(&uncertainty);
        let spread = property.spread(&value, uncertainty).map_err(|error| of_argument(argument, error))?;
        *into(&mut spreads) = if is_strength { spread.map(Spread::over_its_centre) } else { spread };
    }
    Ok(spreads)
}

/// Refuses a bare number that reads as a share of a property with a unit, such as 0.05 of a modulus.
fn refuse_bare_share(argument: &str, given: &Given<'_>, unit: &str) -> PyResult<()> {
    const SHARES: std::ops::RangeInclusive<f64> = 1e-3..=1.0;
    match given.extract::<f64>() {
        Ok(share) if !unit.is_empty() && SHARES.contains(&share) && !given.hasattr("units")? => {
            let percent = 100.0 * share;
            Err(of_argument(
                argument,
                format!("{share} may be a share or {unit}; type \"{percent} %\" or \"{share} {unit}\""),
            ))
        }
        _ => Ok(()),
    }
}

/// A quantity as it is typed in a scene.
fn typed(argument: &str, given: &Given<'_>, unit: &str) -> PyResult<String> {
    match given.cast::<PyString>() {
        Ok(text) => Ok(text.to_string()),
        Err(_) => {
            let bare = without_unit(argument, unit, given)?;
            Ok(format!("{} {unit}", number(argument, &bare)?).trim_end().to_owned())
        }
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
    let of_draws = uncertainty_words::sentences(found).into_iter();
    let mut said: Vec<Told> =
        of_draws.map(|text| in_text(text, "uncertainty", NotePlace::default())).collect();
    let mut notes: Vec<Note> = scene.surface.notes.iter().cloned().map(Note::Surface).collect();
    for (at, rows) in results.curves.iter().enumerate() {
        notes.extend(PreparedCurve::of_scene(scene, at).notes_on(rows));
    }
    for note in words(&notes) {
        if said.iter().all(|(text, ..)| *text != note.0) {
            said.push(note);
        }
    }
    told.set_item("notes", said)?;
    Ok(told)
}
