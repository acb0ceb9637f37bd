//! Names that calls take: the materials of the table and the models, with what is known of each.

use asperity::Hardness;
use contact_law::{Dialect, UnitSystem};
use gaussian_surfaces::Phases;
use measurements::Conventions;
use persson::corrections::Correction;
use persson::variance::Band;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use questions::{BranchChoice, LawForm, LawQuantity, NoteLevel, PlasticCorrelation};
use roughness::FormRemoval;
use scene::Template;
use spectrum::{Abscissa, AmplitudeDefinition, Convention, Normalisation};
use stat_contact::InterferenceLaw;
use study::materials;
use study::models::{self, Choice, Framework, MODELS, ModelEntry};
use topography::{Average, Detrend, Direction, GapTreatment, Window};

/// Name of a column of text, and its value in a row.
type TextColumn<R> = (&'static str, fn(&R) -> String);

/// Columns of text of some rows, by their names.
fn text_columns<'py, R>(
    py: Python<'py>,
    rows: &[R],
    columns: &[TextColumn<R>],
) -> PyResult<Bound<'py, PyDict>> {
    let table = PyDict::new(py);
    for (name, of) in columns {
        table.set_item(name, rows.iter().map(of).collect::<Vec<_>>())?;
    }
    Ok(table)
}

/// The materials of the table: text, empty where the table has no value, and Poisson's ratios.
#[pyfunction]
pub fn materials_table(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let rows = materials::materials();
    let columns = text_columns(
        py,
        &rows,
        &[
            ("name", |row| row.name.clone()),
            ("aliases", |row| row.aliases.join(", ")),
            ("youngs_modulus", |row| row.youngs_modulus.clone()),
            ("poisson_ratio", |_| String::new()),
            ("yield_strength", |row| row.yield_strength.clone().unwrap_or_default()),
            ("indentation_hardness", |row| row.indentation_hardness.clone().unwrap_or_default()),
            ("thermal_conductivity", |row| row.thermal_conductivity.clone().unwrap_or_default()),
            ("resistivity", |row| row.resistivity.clone().unwrap_or_default()),
            ("sources", |row| row.sources.clone()),
        ],
    )?;
    columns.set_item("poisson_ratio", rows.iter().map(|row| row.poisson_ratio).collect::<Vec<_>>())?;
    Ok(columns)
}

/// The models, with the options that they take.
#[pyfunction]
pub fn models_table(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    text_columns(
        py,
        MODELS,
        &[
            ("model", |entry| entry.name.to_owned()),
            ("short_name", |entry| entry.short_name.to_owned()),
            ("full_name", |entry| entry.full_name.to_owned()),
            ("framework", |entry| entry.framework.to_string()),
            ("options", options),
            ("citation", |entry| entry.citation.to_owned()),
        ],
    )
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
        "Conventions": Conventions, "Template": Template, "Branch": BranchChoice, "NoteLevel": NoteLevel,
    );
    Ok(choices)
}
