//! Names that calls take: the materials of the table and the models, with what is known of each.

use asperity::Hardness;
use contact_law::{Dialect, UnitSystem};
use gaussian_surfaces::Phases;
use measurements::Conventions;
use persson::corrections::Correction;
use persson::variance::Band;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use questions::{LawForm, LawQuantity, PlasticCorrelation};
use roughness::FormRemoval;
use scene::Template;
use spectrum::{Abscissa, AmplitudeDefinition, Convention, Normalisation};
use stat_contact::InterferenceLaw;
use study::materials;
use study::models::{self, Choice, Framework, MODELS, ModelEntry};
use topography::{Average, Detrend, Direction, GapTreatment, Window};

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

/// The names that each kind of choice has.
#[pyfunction]
pub fn choices(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let choices = PyDict::new(py);
    let of_framework = |framework| MODELS.iter().filter(move |entry| entry.framework == framework);
    let named =
        |entries: &mut dyn Iterator<Item = &ModelEntry>| entries.map(|entry| entry.name).collect::<Vec<_>>();
    choices.set_item("StackedModel", named(&mut of_framework(Framework::Stacked)))?;
    choices.set_item("StatisticalModel", named(&mut of_framework(Framework::Statistical)))?;
    choices.set_item("PerssonModel", named(&mut of_framework(Framework::Persson)))?;
    choices.set_item("CurveModel", named(&mut MODELS.iter()))?;
    choices.set_item("LawModel", named(&mut models::with_gaps()))?;
    choices.set_item("HardnessFormula", Hardness::ALL.map(Hardness::name))?;
    macro_rules! add {
        ($($key:literal: $choice:ty),+ $(,)?) => {
            $(choices.set_item($key, <$choice>::ALL.iter().map(|one| one.name()).collect::<Vec<_>>())?;)+
        };
    }
    add!(
        "Band": Band, "Correction": Correction, "InterferenceLaw": InterferenceLaw, "Normalisation": Normalisation,
        "AmplitudeDefinition": AmplitudeDefinition, "Convention": Convention, "Abscissa": Abscissa,
        "Detrend": Detrend, "Window": Window, "Average": Average, "Gaps": GapTreatment, "Direction": Direction,
        "Phases": Phases, "Dialect": Dialect, "UnitSystem": UnitSystem, "LawForm": LawForm, "LawQuantity": LawQuantity,
        "ConductanceCorrelation": PlasticCorrelation, "Form": FormRemoval,
        "Conventions": Conventions, "Template": Template,
    );
    Ok(choices)
}
