//! Names that calls take: the materials of the table and the models, with what is known of each.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use study::body_properties::BodyProperty;
use study::materials::{self, TabledMaterial};
use study::models::{Choice, MODELS, ModelEntry};
use tables::Table;

use crate::answer::columns;

/// The materials of the table: text, empty where the table has no value, and Poisson's ratios.
#[pyfunction]
pub fn materials_table(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let rows = materials::materials();
    let text = |property: BodyProperty| -> Vec<String> {
        let value = |row: &TabledMaterial| row.value(property)?.as_str().map(str::to_owned);
        rows.iter().map(|row| value(row).unwrap_or_default()).collect()
    };
    let table = Table::default()
        .with_text("name", rows.iter().map(|row| row.name.clone()))
        .with_text("aliases", rows.iter().map(|row| row.aliases.join(", ")))
        .with_text("youngs_modulus", text(BodyProperty::YoungsModulus))
        .with_numbers("poisson_ratio", rows.iter().map(TabledMaterial::poisson_ratio))
        .with_text("yield_strength", text(BodyProperty::YieldStrength))
        .with_text("indentation_hardness", text(BodyProperty::IndentationHardness))
        .with_text("thermal_conductivity", text(BodyProperty::ThermalConductivity))
        .with_text("resistivity", text(BodyProperty::Resistivity))
        .with_text("sources", rows.iter().map(|row| row.sources.clone()));
    columns(py, &table)
}

/// Returns what to do in place of an argument that no call has.
#[pyfunction]
pub fn way_out(name: &str) -> Option<&'static str> {
    study::way_out(name)
}

/// The models, with the options that they take.
#[pyfunction]
pub fn models_table(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let table = Table::default()
        .with_text("model", MODELS.iter().map(|entry| entry.name.to_owned()))
        .with_text("short_name", MODELS.iter().map(|entry| entry.short_name.to_owned()))
        .with_text("full_name", MODELS.iter().map(|entry| entry.full_name.to_owned()))
        .with_text("framework", MODELS.iter().map(|entry| entry.framework.to_string()))
        .with_text("options", MODELS.iter().map(options))
        .with_text("citation", MODELS.iter().map(|entry| entry.citation.to_owned()));
    columns(py, &table)
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
