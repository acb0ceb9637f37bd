//! The bodies in contact.

use asperity::ElasticBody;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use questions::{LayerInput, MaterialInput};
use study::layer_base::LayerBase;
use study::material::Material;
use study::materials::{self, TabledMaterial};
use units::{IndentationHardness, Modulus};

use crate::answer::{of_material, refused};
use crate::arguments::{Arguments, Given, checked, choice, length_m, load, number, quantity, text};
use crate::errors::{input, of_argument};

/// A material as the core has it.
#[pyclass(frozen, name = "Material", module = "truearea._native")]
pub struct PyMaterial {
    /// The material as given.
    pub input: MaterialInput,
    pub material: Material,
    /// Rows of the table of materials that the rough body and its counterface were named by.
    pub named: [Option<TabledMaterial>; 2],
}

#[pymethods]
impl PyMaterial {
    #[new]
    fn new(arguments: Arguments<'_>) -> PyResult<Self> {
        let named = arguments.get("name", |name, given| {
            materials::named(&text(name, given)?).map_err(|error| of_argument(name, error))
        })?;
        let layer = LayerInput {
            thickness_m: arguments.get("layer_thickness", length_m)?,
            youngs_modulus_pa: arguments.get("layer_youngs_modulus", quantity)?.map(|Modulus { pa }| pa),
            poisson_ratio: arguments.get("layer_poisson_ratio", number)?,
            base: arguments.get("layer_base", choice)?.unwrap_or_default(),
        };
        let modulus_pa = |name: &str, given: &Given<'_>| {
            checked(name, units::Bound::Magnitude, quantity::<Modulus>(name, given)?.pa)
        };
        let ratio =
            |name: &str, given: &Given<'_>| checked(name, ElasticBody::POISSON_RATIO, number(name, given)?);
        // A material of the table has both, and a rigid base neither.
        let elastic = match named.is_some() || layer.base == LayerBase::Rigid {
            true => (arguments.get("youngs_modulus", modulus_pa)?, arguments.get("poisson_ratio", ratio)?),
            false => {
                let modulus_pa = arguments.required("youngs_modulus", modulus_pa)?;
                (Some(modulus_pa), Some(arguments.required("poisson_ratio", ratio)?))
            }
        };
        let other = counterface(&arguments)?;
        let other = other.as_ref().map(Bound::get);
        let input = MaterialInput {
            youngs_modulus_pa: elastic.0,
            poisson_ratio: elastic.1,
            layer: layer.given(),
            yield_strength: arguments.get("yield_strength", quantity)?,
            indentation_hardness_pa: arguments
                .get("indentation_hardness", quantity)?
                .map(|IndentationHardness { pa }| pa),
            strain_gradient_length_m: arguments.get("strain_gradient_length", length_m)?,
            strength_cap: arguments.get("strength_cap", quantity)?,
            counterface: other.and_then(|other| other.input.body()),
            counterface_yield_strength: other.and_then(|other| other.input.yield_strength),
            counterface_indentation_hardness_pa: other.and_then(|other| other.input.indentation_hardness_pa),
        };
        let input = input.filled_from(named.as_ref(), None);
        let material = input.material().map_err(refused)?;
        let named = [named, other.and_then(|other| other.named[0].clone())];
        Ok(PyMaterial { named, input, material })
    }

    /// Facts by their names, in SI units: an identity that is equal for equal materials, the known properties for people, and a
    /// line of description among them.
    #[getter]
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let facts = PyDict::new(py);
        facts.set_item("youngs_modulus", self.input.youngs_modulus_pa)?;
        facts.set_item("youngs_modulus_pa", self.input.youngs_modulus_pa)?;
        facts.set_item("poisson_ratio", self.input.poisson_ratio)?;
        facts.set_item("composite_modulus_pa", self.material.pair.composite_modulus_pa())?;
        facts.set_item("indentation_hardness_pa", self.material.hardness_pa())?;
        facts.set_item("yield_strength_pa", self.material.yield_strength_pa())?;
        facts.set_item("identity", format!("{:?}", self.input))?;
        facts.set_item("description", self.material.describe())?;
        facts.set_item("properties", self.material.properties())?;
        Ok(facts)
    }

    /// True for text that is a name rather than a modulus.
    #[staticmethod]
    fn is_name(text: &str) -> bool {
        let is_number = text.trim_start().starts_with(|first: char| "0123456789.+-".contains(first));
        match materials::named(text) {
            Ok(_) => true,
            // A mistyped name resembles one, as `100Cr7`, where a modulus with a mistyped unit does not.
            Err(unknown) => {
                let resembles = unknown.known.len() < materials::materials().len();
                !is_number || (resembles && text.parse::<Modulus>().is_err())
            }
        }
    }

    /// A nominal pressure \[Pa\], perhaps in units of the hardness.
    fn pressure_pa(&self, argument: &str, pressure: &Given<'_>) -> PyResult<f64> {
        let pressure = self.material.nominal_pressure(load(argument, pressure)?.pressure);
        pressure.map(|pressure| pressure.pa()).map_err(|error| input(of_material(&error)))
    }
}

/// The counterface, if there is one.
pub fn counterface<'py>(arguments: &Arguments<'py>) -> PyResult<Option<Bound<'py, PyMaterial>>> {
    arguments.get("counterface", |name, other| {
        let other = other.cast::<PyMaterial>()?;
        let MaterialInput { layer, counterface, strain_gradient_length_m, strength_cap, .. } =
            other.get().input;
        let of_rough_body = [
            ("layer", layer.is_some()),
            ("counterface", counterface.is_some()),
            ("strain_gradient_length", strain_gradient_length_m.is_some()),
            ("strength_cap", strength_cap.is_some()),
        ];
        match of_rough_body.into_iter().find(|(_, is_given)| *is_given) {
            None => Ok(other.clone()),
            Some((given, _)) => Err(of_argument(
                name,
                format!("it has a {given}, which only the rough body may have; leave it out"),
            )),
        }
    })
}
