//! Contact against cutoff, and gaps under loads.

use pyo3::prelude::*;
use questions::{CurveQuestion, GapModel, GapQuestion, TangentialQuestion};
use study::models::{self, Framework, ModelEntry};

use crate::answer::{PyAnswer, refused};
use crate::arguments::{Arguments, load, text};
use crate::errors::of_argument;
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// Result of a curve: its columns block after block, the pressures of the blocks \[Pa\], absent for separations, and u_0 \[m\]
/// and p_00 \[Pa\] of light loads.
type Curve = (PyAnswer, Vec<Option<f64>>, Option<(f64, f64)>);

/// The name of boundary elements among models.
const ELEMENTS: &str = "bem";

/// A curve of a model of a framework over the cutoffs of a spectrum, under each of the pressures, and behind them at each of the
/// separations.
#[pyfunction]
pub fn curve(
    py: Python<'_>,
    framework: &str,
    surface: &PySurface,
    material: &PyMaterial,
    arguments: Arguments<'_>,
) -> PyResult<Curve> {
    let framework = match framework {
        "stacked" => Framework::Stacked,
        "statistical" => Framework::Statistical,
        _ => Framework::Persson,
    };
    let model = arguments.required("model", text)?;
    let model = models::named(framework, &model).map_err(|error| of_argument("model", error))?;
    let options = arguments.model_options()?;
    let question = CurveQuestion {
        model: Some(model),
        material: material.input.used_with(&options),
        options,
        pressures: arguments.pressures()?,
        separations_m: arguments.separations_m()?,
        sampling: arguments.sampling()?,
        normalisation: arguments.named("normalisation")?,
        amplitude: arguments.named("amplitude")?,
        tolerance: arguments.number("tolerance", None)?,
        details: true,
        ..CurveQuestion::default()
    };
    let answered = carry_out(py, None, |progress| {
        let prepared = question.on(&surface.surface)?;
        let stream = prepared.stream()?;
        let light = stream.light_loads().map(|light| (light.decay_length_m, light.reference_pressure_pa));
        let found = stream.whole(progress)?;
        Ok((found.table, [stream.notes(), found.notes].concat(), prepared.pressures_pa(), light))
    })?;
    let (table, notes, pressures_pa, light) = answered.map_err(refused)?;
    Ok((PyAnswer::new(py, &table, notes)?, pressures_pa, light))
}

/// Mean gap, stiffness and area under each of the pressures.
#[pyfunction]
pub fn gaps(
    py: Python<'_>,
    surface: &PySurface,
    material: &PyMaterial,
    arguments: Arguments<'_>,
) -> PyResult<PyAnswer> {
    let question = GapQuestion {
        by: GapModel {
            tolerance: arguments.number("tolerance", None)?,
            ..gap_model(material, &arguments, &[ELEMENTS])?
        },
        pressures: arguments.pressures()?,
        random: arguments.random()?,
        ..GapQuestion::default()
    };
    let found = carry_out(py, None, |progress| question.answer(&surface.surface, progress))?;
    let found = found.map_err(refused)?;
    PyAnswer::new(py, &found.table, found.notes)
}

/// Displacement, stiffness, slip and loss of a surface that is sheared under each of the pressures.
#[pyfunction]
pub fn tangential(
    py: Python<'_>,
    surface: &PySurface,
    material: &PyMaterial,
    arguments: Arguments<'_>,
) -> PyResult<PyAnswer> {
    let question = TangentialQuestion {
        by: gap_model(material, &arguments, &[ELEMENTS])?,
        friction: arguments.number("friction", None)?,
        pressures: arguments.pressures()?,
        stresses: arguments.several("tangential_stress", load)?.unwrap_or_default(),
        random: arguments.random()?,
        ..TangentialQuestion::default()
    };
    let found = carry_out(py, None, |progress| question.answer(&surface.surface, progress))?;
    let found = found.map_err(refused)?;
    PyAnswer::new(py, &found.table, found.notes)
}

/// A model that knows a distance between the surfaces; `others` are names that are taken besides.
pub fn gap_model(material: &PyMaterial, arguments: &Arguments<'_>, others: &[&str]) -> PyResult<GapModel> {
    let name = arguments.required("model", text)?;
    let known: Vec<&'static ModelEntry> = models::with_gaps().collect();
    let model = known.iter().copied().find(|entry| entry.name == name);
    if model.is_none() && !others.contains(&name.as_str()) {
        let names: Vec<&str> = known.iter().map(|entry| entry.name).chain(others.iter().copied()).collect();
        return Err(of_argument(
            "model",
            format!("'{name}' is none of those with gaps, {}", names.join(", ")),
        ));
    }
    let options = arguments.model_options()?;
    Ok(GapModel {
        model,
        material: material.input.used_with(&options),
        options,
        sampling: arguments.sampling()?,
        normalisation: arguments.named("normalisation")?,
        tolerance: None,
    })
}
