//! Pressure against overclosure for finite elements.

use contact_law::{ContactLaw, Dialect, ExponentialLaw, Heading, UnitSystem};
use pyo3::prelude::*;
use questions::{LawForm, LawQuestion, Note, QuestionError};
use report::provenance::provenance;
use study::models::ModelEntry;
use tables::Table;

use crate::answer::{PyAnswer, refused};
use crate::arguments::{Arguments, checked, named, number};
use crate::curves::gap_model;
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// A law as the core has it.
#[pyclass(frozen, name = "ContactLaw", module = "truearea._native")]
pub struct PyContactLaw {
    law: ContactLaw,
    /// The exponential law of light loads, which Persson's theory has.
    exponential: Option<ExponentialLaw>,
    model: &'static ModelEntry,
    provenance: Vec<String>,
    notes: Vec<Note>,
}

#[pymethods]
impl PyContactLaw {
    /// The law of a model between two pressures.
    #[new]
    fn new(
        py: Python<'_>,
        surface: &PySurface,
        material: &PyMaterial,
        arguments: Arguments<'_>,
    ) -> PyResult<Self> {
        let [from, to] = <[_; 2]>::try_from(arguments.pressures()?).map_err(|given| {
            let count = given.len();
            let told =
                format!("a law goes from one pressure to another, and this is {count} of them; give two");
            of_argument("pressure", told)
        })?;
        let by = gap_model(material, &arguments, &[])?;
        let question = LawQuestion { by, from: from.pressure, to: to.pressure };
        let tolerance = arguments.required("tolerance", number)?;
        let tolerance = checked("tolerance", ContactLaw::TOLERANCES, tolerance)?;
        let found = carry_out(py, None, |progress| {
            let found = question.answer(&surface.surface, progress)?;
            let law = found.sampled(tolerance, progress)?;
            Ok((law, found.exponential().ok(), found.model, found.notes))
        })?;
        let (law, exponential, model, notes) = found.map_err(refused)?;
        let asked = format!("truearea.law, model {model}, {}", material.material.describe());
        let mut provenance = provenance(&asked, &surface.surface, question.by.sampling.sampling());
        provenance.push(format!("{}: {}", model.full_name, model.citation));
        Ok(PyContactLaw { law, exponential, model, provenance, notes })
    }

    /// Points of the law; the first is where the law is cut off.
    fn answer(&self, py: Python<'_>) -> PyResult<PyAnswer> {
        let points = self.law.points();
        let (pressures_pa, overclosures_m): (Vec<f64>, Vec<f64>) = self.law.rows(UnitSystem::Si).unzip();
        let table = Table::default()
            .with_numbers("pressure_pa", pressures_pa)
            .with_numbers("overclosure_m", overclosures_m)
            .with_numbers("mean_gap_m", points.iter().map(|point| point.mean_gap_m))
            .with_numbers("area_fraction", points.iter().map(|point| point.area_fraction));
        PyAnswer::new(py, &table, self.notes.clone())
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

    /// The law in the words of a code.
    fn to_text(&self, dialect: &str, units: &str, name: &str, form: &str) -> PyResult<String> {
        let dialect: Dialect = named("dialect", dialect)?;
        let units: UnitSystem = named("units", units)?;
        let name = Heading::checked_name(name).map_err(|error| of_argument("name", error))?;
        let heading = Heading { provenance: self.provenance.clone(), name: name.to_owned() };
        let text = match named::<LawForm>("form", form)? {
            LawForm::Table => dialect.table(&self.law, units, &heading, &[]),
            LawForm::Exponential => {
                let none = || refused(QuestionError::NoExponentialLaw(self.model));
                dialect.exponential(self.exponential.as_ref().ok_or_else(none)?, units, &heading)
            }
        };
        text.map_err(input)
    }
}
