//! Contact against cutoff, and gaps under loads.

use std::collections::BTreeMap;

use pyo3::prelude::*;
use questions::{CurveQuestion, GapModel, GapQuestion, TangentialQuestion};
use study::models::{self, Framework};
use units::SignedLength;

use crate::answer::{PyAnswer, refused};
use crate::arguments::{Arguments, choice, load, named, number, quantity, text, tolerance};
use crate::errors::of_argument;
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// Result of a curve: its columns block after block, the pressures of the blocks \[Pa\], absent for separations, and numbers by
/// their names: those of the law of light loads that Persson's theory has.
type Curve = (PyAnswer, Vec<Option<f64>>, BTreeMap<&'static str, f64>);

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
    let framework = named("framework", framework)?;
    let name = arguments.required("model", text)?;
    let options = arguments.model_options()?;
    let separations = arguments.several("separation", quantity::<SignedLength>)?.unwrap_or_default();
    let question = CurveQuestion {
        model: Some(models::named(framework, &name).map_err(|error| of_argument("model", error))?),
        material: material.input.used_with(&options),
        options,
        pressures: arguments.pressures()?,
        separations_m: separations.iter().map(|separation| separation.m).collect(),
        sampling: arguments.sampling()?,
        normalisation: arguments.get("normalisation", choice)?,
        amplitude: arguments.get("amplitude", choice)?,
        tolerance: arguments.get("tolerance", tolerance)?,
        details: true,
        ..CurveQuestion::default()
    };
    let answered = carry_out(py, None, |progress| {
        let prepared = question.on(&surface.surface)?;
        let stream = prepared.stream()?;
        let light = stream.light_loads().map(|light| (light.decay_length_m, light.reference_pressure_pa));
        let (u0_m, p00_pa) = light.unwrap_or((f64::NAN, f64::NAN));
        let numbers = match framework {
            Framework::Persson => BTreeMap::from([("u0_m", u0_m), ("p00_pa", p00_pa)]),
            _ => BTreeMap::new(),
        };
        let found = stream.whole(progress)?;
        Ok((found.table, [stream.notes(), found.notes].concat(), prepared.pressures_pa(), numbers))
    })?;
    let (table, notes, pressures_pa, numbers) = answered.map_err(refused)?;
    Ok((PyAnswer::new(py, &table, notes)?, pressures_pa, numbers))
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
            tolerance: arguments.get("tolerance", tolerance)?,
            ..gap_model(material, &arguments, &[ELEMENTS])?
        },
        pressures: arguments.pressures()?,
        random: arguments.random()?,
        ..GapQuestion::default()
    };
    PyAnswer::carry_out(py, None, |progress| question.answer(&surface.surface, progress))
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
        friction: arguments.get("friction", number)?,
        pressures: arguments.pressures()?,
        stresses: arguments.several("tangential_stress", load)?.unwrap_or_default(),
        random: arguments.random()?,
        ..TangentialQuestion::default()
    };
    PyAnswer::carry_out(py, None, |progress| question.answer(&surface.surface, progress))
}

/// A model that knows a distance between the surfaces; `others` are names that are taken besides.
pub fn gap_model(material: &PyMaterial, arguments: &Arguments<'_>, others: &[&str]) -> PyResult<GapModel> {
    let name = arguments.required("model", text)?;
    let model = models::with_gaps().find(|entry| entry.name == name);
    if model.is_none() && !others.contains(&name.as_str()) {
        let known = models::with_gaps().map(|entry| entry.name).chain(others.iter().copied());
        let known = known.collect::<Vec<_>>().join(", ");
        return Err(of_argument("model", format!("'{name}' is not one of those with gaps, {known}")));
    }
    let options = arguments.model_options()?;
    Ok(GapModel {
        model,
        material: material.input.used_with(&options),
        options,
        sampling: arguments.sampling()?,
        normalisation: arguments.get("normalisation", choice)?,
        tolerance: None,
    })
}
