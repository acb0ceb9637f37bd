//! Names that calls take: the materials of the table and the models, with what is known of each.

use drawings::model_style::ModelStyle;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use study::figure::{CurveLook, Variant};
use study::materials;
use study::models::{Choice, MODELS, ModelEntry};

use crate::errors::of_argument;

/// Columns of text: the materials of the table, empty where the table has no value.
#[pyfunction]
pub fn materials_table(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let table = materials::materials();
    let column = |of: fn(&materials::TabledMaterial) -> String| table.iter().map(of).collect::<Vec<_>>();
    let columns = PyDict::new(py);
    columns.set_item("name", column(|row| row.name.clone()))?;
    columns.set_item("aliases", column(|row| row.aliases.join(", ")))?;
    columns.set_item("youngs_modulus", column(|row| row.youngs_modulus.clone()))?;
    columns.set_item("poisson_ratio", table.iter().map(|row| row.poisson_ratio).collect::<Vec<_>>())?;
    columns.set_item("yield_strength", column(|row| row.yield_strength.clone().unwrap_or_default()))?;
    columns.set_item(
        "indentation_hardness",
        column(|row| row.indentation_hardness.clone().unwrap_or_default()),
    )?;
    columns.set_item(
        "thermal_conductivity",
        column(|row| row.thermal_conductivity.clone().unwrap_or_default()),
    )?;
    columns.set_item("resistivity", column(|row| row.resistivity.clone().unwrap_or_default()))?;
    columns.set_item("sources", column(|row| row.sources.clone()))?;
    Ok(columns)
}

/// Columns of text: every model, with the options that it takes.
#[pyfunction]
pub fn models_table(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let column = |of: fn(&ModelEntry) -> String| MODELS.iter().map(of).collect::<Vec<_>>();
    let columns = PyDict::new(py);
    columns.set_item("model", column(|entry| entry.name.to_owned()))?;
    columns.set_item("short_name", column(|entry| entry.short_name.to_owned()))?;
    columns.set_item("full_name", column(|entry| entry.full_name.to_owned()))?;
    columns.set_item("framework", column(|entry| entry.framework.to_string()))?;
    columns.set_item("options", column(options))?;
    columns.set_item("citation", column(|entry| entry.citation.to_owned()))?;
    Ok(columns)
}

fn options(entry: &ModelEntry) -> String {
    let choices = [&Choice::OF_CURVES[..], &[Choice::Hardness]].concat();
    let taken = choices.into_iter().filter(|choice| entry.has(*choice)).map(Choice::key);
    taken.collect::<Vec<_>>().join(", ")
}

/// A pressure as figures and sentences have it: `5 MPa`.
#[pyfunction]
pub fn pressure_in_words(pressure_pa: f64) -> String {
    units::display::pressure(pressure_pa)
}

/// Short name, colour and SVG dash of a model in figures.
#[pyfunction]
pub fn model_style(name: &str) -> PyResult<(&'static str, &'static str, String)> {
    let Some(entry) = MODELS.iter().find(|entry| entry.name == name) else {
        let names = MODELS.iter().map(|entry| entry.name).collect::<Vec<_>>().join(", ");
        return Err(of_argument("model", format!("'{name}' is none of {names}")));
    };
    let style = ModelStyle::new(CurveLook { model: entry.name, variant: Variant::Plain, repeat: 0 });
    Ok((entry.short_name, style.colour, style.dash))
}
