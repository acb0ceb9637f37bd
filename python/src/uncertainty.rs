//! Uncertainty of areas: draws of scans, instruments and material.

use numpy::ToPyArray;
use numpy::ndarray::Array2;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};
use questions::{QuestionError, UncertainAreas, UncertaintyQuestion};
use report::{advice_words, uncertainty_words};
use scene::{UncertaintySettings, spread_of};
use study::body_properties::BodyProperty;
use study::material_spreads::MaterialSpreads;
use study::models::ModelEntry;
use study::spread::Spread;
use toml::Value;
use uncertainty::AreaInterval;
use units::{Bound as NumberBound, RemarkPlace};

use crate::answer::{Told, columns, in_text, refused, words};
use crate::arguments::{Arguments, Given, any_model, checked, choice, number, tolerance, wrong_type};
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::scene::value_of;
use crate::surface::PySurface;
use crate::work::{Observer, carry_out};

/// A standard uncertainty: its argument, the property as given, and the uncertainty.
type GivenSpread<'py> = (String, Given<'py>, Given<'py>);

/// Number of an interval.
type OfArea = fn(&AreaInterval) -> f64;

/// Message if no input is uncertain, so that there is nothing to draw.
const NOTHING_SCATTERS: &str = "nothing of the surface or the material is known to scatter; give scans (composite) or a spectrum \
                                with standard errors (c1d_se), or say how well the material is known, such as \
                                youngs_modulus=\"5 %\"";

/// Intervals of the areas of some models under some loads: arrays of (loads, models), tables, and notes.
#[pyfunction]
pub fn uncertainty_of<'py>(
    py: Python<'py>,
    surface: &PySurface,
    material: &PyMaterial,
    of_material: Vec<GivenSpread<'py>>,
    arguments: Arguments<'py>,
    observer: Option<&Observer<'py>>,
) -> PyResult<Bound<'py, PyDict>> {
    let question = UncertaintyQuestion {
        models: models(&arguments)?,
        options: arguments.model_options()?,
        material: material.input,
        spreads: spreads(&of_material)?,
        pressures: arguments.pressures()?,
        sampling: arguments.sampling()?,
        normalisation: arguments.get("normalisation", choice)?,
        amplitude: arguments.get("amplitude", choice)?,
        tolerance: arguments.get("tolerance", tolerance)?,
        choices: choices(&arguments)?,
    };
    let of_strength =
        of_material.iter().find(|(name, ..)| ["yield_strength", "indentation_hardness"].contains(&&**name));
    if let Some((name, ..)) = of_strength
        && question.material.counterface_yields().map_err(refused)?
    {
        return Err(of_argument(
            name,
            "it is that of the rough body, and the counterface, which is softer, flows; leave it out",
        ));
    }
    let areas = carry_out(py, observer, |watch| question.answer(&surface.surface, watch))?;
    let areas = areas.map_err(|error| match error {
        QuestionError::NothingScatters => input(NOTHING_SCATTERS),
        error => refused(error),
    })?;
    told_of(py, &areas)
}

/// The models, each once.
fn models(arguments: &Arguments<'_>) -> PyResult<Vec<&'static ModelEntry>> {
    let one = |argument: &str, given: &Given<'_>| {
        let name: String =
            given.extract().map_err(|_| wrong_type(argument, "the name of a model is needed", given))?;
        Ok((argument.to_owned(), any_model(&name)?))
    };
    let named = arguments.several("model", one)?.unwrap_or_default();
    if named.is_empty() {
        return Err(of_argument("model", "it is empty; give at least one"));
    }
    let models: Vec<_> = named.iter().map(|(_, entry)| *entry).collect();
    for (at, (argument, entry)) in named.iter().enumerate() {
        if models[..at].contains(entry) {
            return Err(input(format!("{argument} is {}, which is given twice; keep one", entry.name)));
        }
    }
    Ok(models)
}

/// The numbers of draws.
fn choices(arguments: &Arguments<'_>) -> PyResult<UncertaintySettings> {
    let within = |bound| move |name: &str, given: &Given<'_>| checked(name, bound, number(name, given)?);
    let whole = |argument: &str, bound: NumberBound| {
        arguments.get(argument, |name, given| {
            let value = within(bound)(name, given)?;
            given.extract().map_err(|_| input(format!("{name} is {value}; it must be a whole number")))
        })
    };
    let usual = UncertaintySettings::default();
    Ok(UncertaintySettings {
        level: arguments.get("level", within(UncertaintySettings::LEVEL))?.unwrap_or(usual.level),
        draws: whole("draws", UncertaintySettings::DRAWS)?.map_or(usual.draws, |draws: u64| draws as usize),
        seed: whole("seed", NumberBound::AtLeast(0.0))?.unwrap_or(usual.seed),
        shares_draws: whole("shares_draws", UncertaintySettings::SHARES_DRAWS)?.map(|draws| draws as usize),
        off: false,
    })
}

/// Reads the uncertainties of the material.
fn spreads(given: &[GivenSpread<'_>]) -> PyResult<MaterialSpreads> {
    let mut spreads = MaterialSpreads::default();
    let mut of_strength: Option<&str> = None;
    for (argument, value, uncertainty) in given {
        let key = argument.trim_start_matches("counterface_");
        let property =
            BodyProperty::of_key(key).ok_or_else(|| of_argument(argument, "it has no uncertainty"))?;
        let is_strength = matches!(property, BodyProperty::YieldStrength | BodyProperty::IndentationHardness);
        let into = match argument.as_str() {
            "youngs_modulus" => &mut spreads.youngs_modulus,
            "poisson_ratio" => &mut spreads.poisson_ratio,
            "counterface_youngs_modulus" => &mut spreads.counterface_youngs_modulus,
            "counterface_poisson_ratio" => &mut spreads.counterface_poisson_ratio,
            _ if is_strength => &mut spreads.strength,
            _ => &mut spreads.strain_gradient_length,
        };
        if let Some(other) = of_strength.filter(|_| is_strength) {
            return Err(input(format!(
                "{other} and {argument} both have a standard uncertainty, and the hardness is three times the strength; keep \
                 one of the two"
            )));
        }
        if value.is_none() {
            return Err(input(format!(
                "{argument} has a standard uncertainty and no value; give the material one"
            )));
        }
        refuse_bare_share(argument, uncertainty, property.unit().unwrap_or_default())?;
        let place = format!("material.{key}");
        let (value, uncertainty) = (typed(&place, value)?, typed(&place, uncertainty)?);
        let spread = spread_of(property, &value, without_sign(&uncertainty));
        *into = spread.map_err(|error| of_argument(argument, error))?;
        if is_strength {
            of_strength = Some(argument);
            *into = into.take().map(Spread::over_its_centre);
        }
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
fn typed(place: &str, given: &Given<'_>) -> PyResult<String> {
    Ok(match value_of(place, given)? {
        Value::String(text) => text,
        value => value.to_string(),
    })
}

/// An uncertainty without the sign that a scene has before it.
fn without_sign(text: &str) -> &str {
    let text = text.trim();
    let signs = ["+-", "+/-", "±"];
    signs.into_iter().find_map(|sign| text.strip_prefix(sign)).unwrap_or(text).trim_start()
}

/// Converts the results to arrays of (loads, models) and tables.
fn told_of<'py>(py: Python<'py>, areas: &UncertainAreas) -> PyResult<Bound<'py, PyDict>> {
    let (needs, found) = (&areas.scene.needs, &areas.uncertainty);
    let arrays: [(&str, OfArea); 8] = [
        ("area_fraction", |area| area.area_fraction),
        ("median", |area| area.median),
        ("low", |area| area.low),
        ("high", |area| area.high),
        ("low_68", |area| area.within_68[0]),
        ("high_68", |area| area.within_68[1]),
        ("ln_area_sd", |area| area.ln_area_sd),
        ("monte_carlo_error", |area| area.monte_carlo_error),
    ];
    let arrays = arrays.map(|(name, of)| {
        let at = |(load, curve)| found.interval(curve, load).map_or(f64::NAN, of);
        (name, Array2::from_shape_fn((needs.loads.len(), needs.curves.len()), at).to_pyarray(py))
    });
    let steps = found.advice.iter().flat_map(|advice| &advice.steps);
    let in_words = steps.map(|step| advice_words::in_a_line(found, step));
    let of_draws = uncertainty_words::sentences(found).into_iter();
    let mut said: Vec<Told> =
        of_draws.map(|(text, code, level)| in_text(text, code, level, RemarkPlace::default())).collect();
    for note in words(&areas.notes()) {
        if said.iter().all(|(text, ..)| *text != note.0) {
            said.push(note);
        }
    }
    let result = PyDict::new(py);
    let pressures_pa: Vec<f64> = needs.loads.iter().map(|load| load.nominal_pressure_pa()).collect();
    result.set_item("nominal_pressure_pa", pressures_pa)?;
    result.set_item("model", needs.curves.iter().map(|curve| curve.name.as_str()).collect::<Vec<_>>())?;
    result.set_item("arrays", arrays.into_py_dict(py)?)?;
    result.set_item("shares", columns(py, &found.indices_table(needs))?)?;
    result.set_item("advice", columns(py, &found.advice_table(needs).with_text("in_words", in_words))?)?;
    result.set_item("bands", columns(py, &found.bands_table(needs))?)?;
    result.set_item("draws", found.draws)?;
    result.set_item("notes", said)?;
    Ok(result)
}
