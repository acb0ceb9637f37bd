//! Pressure against overclosure, and conductance against pressure, for finite elements.

use interface::finite_elements::{
    ConductanceTable, ContactLaw, Dialect, ExponentialLaw, Flow, Heading, UnitSystem,
};
use pyo3::prelude::*;
use questions::{
    GasInput, LawAnswer, LawForm, LawQuestion, LawTableQuestion, PlasticCorrelation, QuestionError,
    TransportInput,
};
use report::provenance::provenance;
use study::models::ModelEntry;
use tables::Table;
use units::{Remark, RemarkCode, Resistivity, ThermalConductivity};

use crate::answer::{Keywords, PyAnswer, refused};
use crate::arguments::{Arguments, checked, choice, length_m, named, number, quantity, text};
use crate::curves::gap_model;
use crate::errors::{input, of_argument};
use crate::material::PyMaterial;
use crate::surface::PySurface;
use crate::work::carry_out;

/// Pressure against overclosure, or conductance against pressure, as the core has it.
#[pyclass(frozen, name = "FoundLaw", module = "truearea._native")]
pub struct PyFoundLaw {
    found: Found,
    table: Table,
    provenance: Vec<String>,
    notes: Vec<Remark>,
    /// The nominal pressure \[Pa\] at the gap where a law is cut off.
    #[pyo3(get)]
    cut_pressure_pa: Option<f64>,
    /// The largest relative error that was met halfway between two points.
    #[pyo3(get)]
    interpolation_error: f64,
}

enum Found {
    /// With the exponential law of light loads, which Persson's theory has.
    Pressure {
        law: ContactLaw,
        exponential: Option<ExponentialLaw>,
        model: &'static ModelEntry,
    },
    Conductance(ConductanceTable),
}

#[pymethods]
impl PyFoundLaw {
    /// The law of a model or a correlation between two pressures.
    #[new]
    fn new(
        py: Python<'_>,
        surface: &PySurface,
        material: &PyMaterial,
        arguments: Arguments<'_>,
    ) -> PyResult<Self> {
        let (question, tolerance) = question(material, &arguments)?;
        let mut provenance = origin(&question, surface, material);
        let law = carry_out(py, None, |watch| match question.answer(&surface.surface, watch)? {
            LawAnswer::Pressure(found) => {
                let (law, model) = (found.sampled(tolerance, watch)?, found.model);
                provenance.extend(found.description(&Keywords));
                let exponential = found.exponential(tolerance).ok().map(|(law, _)| law);
                Ok(PyFoundLaw {
                    table: law_table(&law),
                    provenance,
                    notes: found.notes,
                    cut_pressure_pa: Some(law.cut().pressure_pa),
                    interpolation_error: law.interpolation_error,
                    found: Found::Pressure { law, exponential, model },
                })
            }
            LawAnswer::Conductance(found) => {
                let table = found.sampled(tolerance, watch)?;
                provenance.extend(found.description(&Keywords));
                Ok(PyFoundLaw {
                    table: conductance_table(&table),
                    provenance,
                    notes: found.notes,
                    cut_pressure_pa: None,
                    interpolation_error: table.interpolation_error,
                    found: Found::Conductance(table),
                })
            }
        })?;
        law.map_err(refused)
    }

    /// Points of the law; at the first it is cut off, or has no pressure.
    fn answer(&self, py: Python<'_>) -> PyResult<PyAnswer> {
        PyAnswer::new(py, &self.table, self.notes.clone())
    }

    /// The law in the words of a code; conductances have neither name nor form.
    fn to_text(
        &self,
        dialect: &str,
        units: &str,
        name: Option<&str>,
        form: Option<&str>,
    ) -> PyResult<String> {
        let (dialect, units): (Dialect, UnitSystem) = (named("dialect", dialect)?, named("units", units)?);
        let (law, exponential, model) = match &self.found {
            Found::Pressure { law, exponential, model } => (law, exponential, *model),
            Found::Conductance(table) => {
                if let Some((given, _)) =
                    [("name", name), ("form", form)].iter().find(|(_, given)| given.is_some())
                {
                    return Err(of_argument(given, "it is for a law of pressure; leave it out"));
                }
                return table.to_text(dialect, units, &self.provenance).map_err(input);
            }
        };
        if name.is_some() && dialect == Dialect::Csv {
            let unused = Remark::new(RemarkCode::OtherDialect).with("dialect", dialect.name()).on("name");
            return Err(refused(QuestionError::Unused(Box::new(unused))));
        }
        let name = Heading::checked_name(name.unwrap_or(Heading::NAME))
            .map_err(|error| of_argument("name", error))?;
        let heading = Heading { provenance: self.provenance.clone(), name: name.to_owned() };
        let text = match form.map(|form| named("form", form)).transpose()?.unwrap_or(LawForm::Table) {
            LawForm::Table => dialect.table(law, units, &heading, &[]),
            LawForm::Exponential => {
                let none = || refused(QuestionError::NoExponentialLaw(model));
                dialect.exponential(exponential.as_ref().ok_or_else(none)?, units, &heading)
            }
        };
        text.map_err(input)
    }
}

fn law_table(law: &ContactLaw) -> Table {
    let (pressures_pa, overclosures_m): (Vec<f64>, Vec<f64>) = law.rows(UnitSystem::Si).unzip();
    Table::default()
        .with_numbers("pressure_pa", pressures_pa)
        .with_numbers("overclosure_m", overclosures_m)
        .with_numbers("mean_gap_m", law.points.iter().map(|point| point.mean_gap_m))
        .with_numbers("area_fraction", law.points.iter().map(|point| point.area_fraction))
}

fn conductance_table(found: &ConductanceTable) -> Table {
    let points = &found.points;
    let total = points.iter().map(|point| point.total_si());
    let table = Table::default().with_numbers("pressure_pa", points.iter().map(|point| point.pressure_pa));
    match found.flow {
        Flow::Heat => table
            .with_numbers("conductance_w_per_m2_k", total)
            .with_numbers("contact_w_per_m2_k", points.iter().map(|point| point.contact_si))
            .with_numbers("gas_w_per_m2_k", points.iter().map(|point| point.gas_si)),
        Flow::Current => table.with_numbers("conductance_s_per_m2", total),
    }
}

/// The question of a call, and the tolerance of the lines between its rows.
fn question(material: &PyMaterial, arguments: &Arguments<'_>) -> PyResult<(LawTableQuestion, f64)> {
    let [from, to] = <[_; 2]>::try_from(arguments.pressures()?).map_err(|given| {
        let count = given.len();
        of_argument(
            "pressure",
            format!("a law goes from one pressure to another, and this is {count} of them; give two"),
        )
    })?;
    let correlations: Vec<&str> = PlasticCorrelation::ALL.iter().map(|one| one.name()).collect();
    let by = gap_model(material, arguments, &correlations)?;
    let w_per_m_k = |name: &str| -> PyResult<Option<f64>> {
        Ok(arguments.get(name, quantity)?.map(|ThermalConductivity { w_per_m_k }| w_per_m_k))
    };
    let ohm_m = |name: &str| -> PyResult<Option<f64>> {
        Ok(arguments.get(name, quantity)?.map(|Resistivity { ohm_m }| ohm_m))
    };
    let question = LawTableQuestion {
        law: LawQuestion { by, from: from.pressure, to: to.pressure },
        quantity: arguments.get("quantity", choice)?.unwrap_or_default(),
        correlation: arguments.required("model", text)?.parse().ok(),
        transport: TransportInput {
            thermal_conductivity_w_per_m_k: w_per_m_k("thermal_conductivity")?,
            counterface_thermal_conductivity_w_per_m_k: w_per_m_k("counterface_thermal_conductivity")?,
            resistivity_ohm_m: ohm_m("resistivity")?,
            counterface_resistivity_ohm_m: ohm_m("counterface_resistivity")?,
        },
        gas: GasInput {
            name: arguments.get("gas", choice)?,
            temperature_k: arguments.get("gas_temperature", number)?,
            pressure: arguments.get("gas_pressure", quantity)?,
            conductivity_w_per_m_k: w_per_m_k("gas_conductivity")?,
            parameter_m: arguments.get("gas_parameter", length_m)?,
        },
        ..LawTableQuestion::default()
    };
    let tolerance = arguments.required("tolerance", number)?;
    let tolerance = checked("tolerance", ContactLaw::TOLERANCES, tolerance)?;
    let [rough, counterface] = &material.named;
    Ok((question.filled_from(rough.as_ref(), counterface.as_ref()), tolerance))
}

/// Lines on where a law comes from.
fn origin(question: &LawTableQuestion, surface: &PySurface, material: &PyMaterial) -> Vec<String> {
    let by = &question.law.by;
    let model = by.model.map(|entry| entry.name).or(question.correlation.map(PlasticCorrelation::name));
    let asked =
        format!("truearea.law, model {}, {}", model.unwrap_or_default(), material.material.describe());
    provenance(&asked, &surface.surface, by.sampling.sampling())
}
