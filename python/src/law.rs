//! Pressure against overclosure, and conductance against pressure, for finite elements.

use contact_law::{ConductanceTable, ContactLaw, Dialect, ExponentialLaw, Flow, Heading, UnitSystem};
use parallel::Progress;
use pyo3::prelude::*;
use questions::{
    GasInput, LawAnswer, LawForm, LawQuestion, LawTableQuestion, Note, PlasticCorrelation, QuestionError,
    TransportInput,
};
use report::provenance::provenance;
use study::models::ModelEntry;
use tables::Table;
use units::{Resistivity, ThermalConductivity};

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
        let (question, tolerance) = question(material, &arguments)?;
        let found = carry_out(py, None, |progress: &dyn Progress| {
            let LawAnswer::Pressure(found) = question.answer(&surface.surface, progress)? else {
                return Ok(None);
            };
            let law = found.sampled(tolerance, progress)?;
            Ok::<_, QuestionError>(Some((law, found.exponential().ok(), found.model, found.notes)))
        })?;
        let (law, exponential, model, notes) = found.map_err(refused)?.ok_or_else(of_another_class)?;
        let mut provenance = origin(&question, surface, material);
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

/// Conductance against pressure as the core has it.
#[pyclass(frozen, name = "ConductanceTable", module = "truearea._native")]
pub struct PyConductanceTable {
    table: ConductanceTable,
    provenance: Vec<String>,
    notes: Vec<Note>,
}

#[pymethods]
impl PyConductanceTable {
    /// The conductance of a model or a correlation between two pressures.
    #[new]
    fn new(
        py: Python<'_>,
        surface: &PySurface,
        material: &PyMaterial,
        arguments: Arguments<'_>,
    ) -> PyResult<Self> {
        let (question, tolerance) = question(material, &arguments)?;
        let found = carry_out(py, None, |progress: &dyn Progress| {
            let LawAnswer::Conductance(found) = question.answer(&surface.surface, progress)? else {
                return Ok(None);
            };
            let table = found.sampled(tolerance, progress)?;
            Ok::<_, QuestionError>(Some((table, found.description(), found.notes)))
        })?;
        let (table, description, notes) = found.map_err(refused)?.ok_or_else(of_another_class)?;
        let mut provenance = origin(&question, surface, material);
        provenance.extend(description);
        Ok(PyConductanceTable { table, provenance, notes })
    }

    /// Points of the table; the first has no pressure.
    fn answer(&self, py: Python<'_>) -> PyResult<PyAnswer> {
        let points = self.table.points();
        let total = points.iter().map(|point| point.total_si());
        let table =
            Table::default().with_numbers("pressure_pa", points.iter().map(|point| point.pressure_pa));
        let table = match self.table.flow() {
            Flow::Heat => table
                .with_numbers("conductance_w_per_m2_k", total)
                .with_numbers("contact_w_per_m2_k", points.iter().map(|point| point.contact_si))
                .with_numbers("gas_w_per_m2_k", points.iter().map(|point| point.gas_si)),
            Flow::Current => table.with_numbers("conductance_s_per_m2", total),
        };
        PyAnswer::new(py, &table, self.notes.clone())
    }

    /// The largest relative error of the conductance that was met halfway between two points.
    #[getter]
    fn interpolation_error(&self) -> f64 {
        self.table.interpolation_error()
    }

    /// The table in the words of a code.
    fn to_text(&self, dialect: &str, units: &str) -> PyResult<String> {
        let (dialect, units) = (named("dialect", dialect)?, named("units", units)?);
        self.table.to_text(dialect, units, &self.provenance).map_err(input)
    }
}

/// The question of a call, and the tolerance of the lines between its rows.
fn question(material: &PyMaterial, arguments: &Arguments<'_>) -> PyResult<(LawTableQuestion, f64)> {
    let [from, to] = <[_; 2]>::try_from(arguments.pressures()?).map_err(|given| {
        let count = given.len();
        let told = format!("a law goes from one pressure to another, and this is {count} of them; give two");
        of_argument("pressure", told)
    })?;
    let correlations: Vec<&str> =
        PlasticCorrelation::ALL.iter().map(|correlation| correlation.name()).collect();
    let by = gap_model(material, arguments, &correlations)?;
    let correlation = arguments.text("model")?.and_then(|name| name.parse().ok());
    let question = LawTableQuestion {
        law: LawQuestion { by, from: from.pressure, to: to.pressure },
        quantity: arguments.named("quantity")?.unwrap_or_default(),
        correlation,
        transport: transport(arguments)?,
        gas: gas(arguments)?,
        ..LawTableQuestion::default()
    };
    let tolerance = arguments.required("tolerance", number)?;
    let tolerance = checked("tolerance", ContactLaw::TOLERANCES, tolerance)?;
    let [rough, counterface] = &material.named;
    Ok((question.filled_from(rough.as_ref(), counterface.as_ref()), tolerance))
}

fn transport(arguments: &Arguments<'_>) -> PyResult<TransportInput> {
    let w_per_m_k = |name: &str| -> PyResult<Option<f64>> {
        Ok(arguments.quantity::<ThermalConductivity>(name)?.map(|given| given.w_per_m_k))
    };
    let ohm_m = |name: &str| -> PyResult<Option<f64>> {
        Ok(arguments.quantity::<Resistivity>(name)?.map(|given| given.ohm_m))
    };
    Ok(TransportInput {
        thermal_conductivity_w_per_m_k: w_per_m_k("thermal_conductivity")?,
        counterface_thermal_conductivity_w_per_m_k: w_per_m_k("counterface_thermal_conductivity")?,
        resistivity_ohm_m: ohm_m("resistivity")?,
        counterface_resistivity_ohm_m: ohm_m("counterface_resistivity")?,
    })
}

fn gas(arguments: &Arguments<'_>) -> PyResult<GasInput> {
    let number = |name: &str| arguments.number(name, None);
    let conductivity: Option<ThermalConductivity> = arguments.quantity("gas_conductivity")?;
    Ok(GasInput {
        conductivity_w_per_m_k: conductivity.map(|given| given.w_per_m_k),
        parameter_m: arguments.length_m("gas_parameter")?,
        accommodation: number("accommodation")?,
        counterface_accommodation: number("counterface_accommodation")?,
        heat_capacity_ratio: number("heat_capacity_ratio")?,
        prandtl_number: number("prandtl_number")?,
        mean_free_path_m: arguments.length_m("mean_free_path")?,
        temperature_k: number("gas_temperature")?,
        pressure: arguments.quantity("gas_pressure")?,
    })
}

/// Lines on where a law comes from.
fn origin(question: &LawTableQuestion, surface: &PySurface, material: &PyMaterial) -> Vec<String> {
    let by = &question.law.by;
    let model = by.model.map(|entry| entry.name).or(question.correlation.map(PlasticCorrelation::name));
    let asked =
        format!("truearea.law, model {}, {}", model.unwrap_or_default(), material.material.describe());
    provenance(&asked, &surface.surface, by.sampling.sampling())
}

/// The error of a class that holds another quantity.
fn of_another_class() -> PyErr {
    of_argument("quantity", "another class holds tables of this quantity; call truearea.law")
}
