//! Pressure against overclosure for finite elements.

use contact_law::{ContactLaw, Dialect, ExponentialLaw, Heading, UnitSystem};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use report::gap_words;
use report::provenance::provenance;

use crate::errors::input;
use crate::gap::{BY_SURFACE, Chosen, GivenChoices, entry, of_given};
use crate::material::{PyMaterial, loads};
use crate::quantities::{Given, checked};
use crate::surface::{PySurface, named};
use crate::work::{carry_out, light};

/// A law as the core has it.
#[pyclass(frozen, name = "ContactLaw", module = "truearea._native")]
pub struct PyContactLaw {
    law: ContactLaw,
    /// The exponential law of light loads, which Persson's theory has.
    exponential: Option<ExponentialLaw>,
    model: &'static str,
    provenance: Vec<String>,
    notes: Vec<String>,
}

#[pymethods]
impl PyContactLaw {
    /// The law of a model between two pressures.
    #[new]
    fn new(
        py: Python<'_>,
        surface: &PySurface,
        material: &PyMaterial,
        pressure: &Given<'_>,
        model: &str,
        choices: GivenChoices<'_>,
        tolerance: f64,
    ) -> PyResult<Self> {
        let material = &material.material;
        let range: Vec<f64> =
            loads("pressure", pressure, material)?.iter().map(|load| load.nominal_pressure_pa()).collect();
        let range_pa: [f64; 2] = range.try_into().map_err(|given: Vec<f64>| {
            let count = given.len();
            input(format!(
                "pressure: a law goes from one pressure to another, and this is {count} of them; give two"
            ))
        })?;
        let tolerance = checked("tolerance", ContactLaw::TOLERANCES, tolerance)?;
        let entry = entry(model, &[])?;
        let chosen =
            Chosen::new(entry, &choices, study::plan::Tolerance::default().value(), material, surface)?;
        let (source, law) = carry_out(py, None, |progress| {
            let source = chosen.law(surface, progress)?;
            let law = source.sampled(range_pa, tolerance).map_err(input)?;
            PyResult::Ok((source, law))
        })??;
        let mut notes = of_given(surface, material, Some(chosen.entry));
        notes.extend(light(py, || gap_words::of_law(&source, range_pa[0], BY_SURFACE)));
        let asked = format!("truearea.law, model {model}, {}", material.describe());
        let mut origin = provenance(&asked, &surface.surface, chosen.sampling);
        origin.push(format!("{}: {}", chosen.entry.full_name, chosen.entry.citation));
        let exponential = source.exponential(gap_words::LIGHT_LOADS_SHARE);
        Ok(PyContactLaw { law, exponential, model: chosen.entry.name, provenance: origin, notes })
    }

    /// Points of the law; the first is where the law is cut off.
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let points = self.law.points();
        let columns = PyDict::new(py);
        let rows = self.law.rows(UnitSystem::Si);
        let (pressures_pa, overclosures_m): (Vec<f64>, Vec<f64>) = rows.unzip();
        columns.set_item("pressure_pa", PyArray1::from_vec(py, pressures_pa))?;
        columns.set_item("overclosure_m", PyArray1::from_vec(py, overclosures_m))?;
        let gaps_m = points.iter().map(|point| point.mean_gap_m);
        columns.set_item("mean_gap_m", PyArray1::from_iter(py, gaps_m))?;
        let areas = points.iter().map(|point| point.area_fraction);
        columns.set_item("area_fraction", PyArray1::from_iter(py, areas))?;
        Ok(columns)
    }

    /// The nominal pressure \[Pa\] at the gap where it is cut off.
    #[getter]
    fn cut_pressure_pa(&self) -> f64 {
        self.law.cut().pressure_pa
    }

    /// The largest relative error of the pressure that was met halfway between two points.
    #[getter]
    fn interpolation_error(&self) -> f64 {
        self.law.interpolation_error()
    }

    /// Notes on the law.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// The law in the words of a code.
    fn to_text(&self, dialect: &str, units: &str, name: &str, form: &str) -> PyResult<String> {
        let dialect: Dialect = named("dialect", dialect)?;
        let units: UnitSystem = named("units", units)?;
        let name = Heading::checked_name(name).map_err(|error| input(format!("name: {error}")))?;
        let heading = Heading { provenance: self.provenance.clone(), name: name.to_owned() };
        match form {
            "table" => dialect.table(&self.law, units, &heading, &[]).map_err(input),
            "exponential" => {
                let exponential = self.exponential.as_ref().ok_or_else(|| {
                    input(format!(
                        "form exponential is the law of light loads of Persson's theory, and model {} has none; take the \
                         table",
                        self.model
                    ))
                })?;
                dialect.exponential(exponential, units, &heading).map_err(input)
            }
            other => Err(input(format!("form: '{other}' is none of table, exponential"))),
        }
    }
}
