//! The bodies in contact.

use asperity::ElasticBody;
use pyo3::prelude::*;
use questions::{BodyInput, LayerInput, MaterialInput};
use study::layer_base::LayerBase;
use study::material::Material;
use study::materials::{self, TabledMaterial};
use units::{Bound, IndentationHardness, Modulus};

use crate::answer::{of_material, refused};
use crate::arguments::{Arguments, Given, checked, load, number, quantity};
use crate::errors::{input, of_argument};

/// A material as the core has it.
#[pyclass(frozen, name = "Material", module = "truearea._native")]
pub struct PyMaterial {
    /// The material as given.
    pub input: MaterialInput,
    pub material: Material,
    /// Rows of the table of materials that the rough body and its counterface were named by.
    pub named: [Option<TabledMaterial>; 2],
    /// E of the rough body \[Pa\].
    #[pyo3(get)]
    youngs_modulus_pa: Option<f64>,
    /// Poisson's ratio of the rough body.
    #[pyo3(get)]
    poisson_ratio: Option<f64>,
    /// E* \[Pa\].
    #[pyo3(get)]
    composite_modulus_pa: f64,
    /// H \[Pa\].
    #[pyo3(get)]
    indentation_hardness_pa: Option<f64>,
    /// S0 \[Pa\].
    #[pyo3(get)]
    yield_strength_pa: Option<f64>,
    /// The material as it was given, in SI units: equal for equal materials.
    #[pyo3(get)]
    identity: String,
}

#[pymethods]
impl PyMaterial {
    #[new]
    fn new(arguments: Arguments<'_>) -> PyResult<Self> {
        let named = arguments.text("name")?.map(|name| materials::named(&name)).transpose();
        let named = named.map_err(|error| of_argument("name", error))?;
        let hardness: Option<IndentationHardness> = arguments.quantity("indentation_hardness")?;
        let layer = layer(&arguments)?;
        let may_lack = named.is_some() || layer.is_some_and(|layer| layer.base == LayerBase::Rigid);
        let input = MaterialInput {
            youngs_modulus_pa: youngs_modulus_pa(&arguments, may_lack)?,
            poisson_ratio: poisson_ratio(&arguments, may_lack)?,
            layer,
            yield_strength: arguments.quantity("yield_strength")?,
            indentation_hardness_pa: hardness.map(|hardness| hardness.pa),
            strain_gradient_length_m: arguments.length_m("strain_gradient_length")?,
            strength_cap: arguments.quantity("strength_cap")?,
            counterface: counterface(&arguments)?,
            ..MaterialInput::default()
        };
        let input = input.filled_from(named.as_ref(), None);
        let other = match arguments.get("counterface")? {
            Some(other) => other.cast::<PyMaterial>()?.get().named[0].clone(),
            None => None,
        };
        let material = input.material().map_err(refused)?;
        Ok(PyMaterial {
            youngs_modulus_pa: input.youngs_modulus_pa,
            poisson_ratio: input.poisson_ratio,
            composite_modulus_pa: material.pair.composite_modulus_pa(),
            indentation_hardness_pa: material.hardness_pa(),
            yield_strength_pa: material.yield_strength_pa(),
            identity: format!("{input:?}"),
            named: [named, other],
            input,
            material,
        })
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

    /// The material in a line.
    fn describe(&self) -> String {
        self.material.describe()
    }

    /// The known properties, each with its name, for people.
    fn properties(&self) -> Vec<(&'static str, String)> {
        self.material.properties()
    }
}

/// The elastic constants of the counterface, if there is one.
pub fn counterface(arguments: &Arguments<'_>) -> PyResult<Option<BodyInput>> {
    let Some(other) = arguments.get("counterface")? else { return Ok(None) };
    let other = other.cast::<PyMaterial>()?.get();
    if other.input.layer.is_some() {
        return Err(of_argument("counterface", "it has a layer, which only the rough body may have"));
    }
    Ok(other.input.body())
}

/// The layer on the rough body, if any part of it is given.
fn layer(arguments: &Arguments<'_>) -> PyResult<Option<LayerInput>> {
    let modulus: Option<Modulus> = arguments.quantity("layer_youngs_modulus")?;
    let layer = LayerInput {
        thickness_m: arguments.length_m("layer_thickness")?,
        youngs_modulus_pa: modulus.map(|modulus| modulus.pa),
        poisson_ratio: arguments.number("layer_poisson_ratio", None)?,
        base: arguments.named("layer_base")?.unwrap_or_default(),
    };
    Ok(layer.given())
}

/// Young's modulus of the rough body, which may be left out of a material of the table and of a rigid base.
fn youngs_modulus_pa(arguments: &Arguments<'_>, may_lack: bool) -> PyResult<Option<f64>> {
    if may_lack && arguments.get("youngs_modulus")?.is_none() {
        return Ok(None);
    }
    let modulus: Modulus = arguments.required("youngs_modulus", quantity)?;
    checked("youngs_modulus", Bound::Magnitude, modulus.pa).map(Some)
}

/// Poisson's ratio of the rough body, which may be left out of a material of the table and of a rigid base.
fn poisson_ratio(arguments: &Arguments<'_>, may_lack: bool) -> PyResult<Option<f64>> {
    if may_lack && arguments.get("poisson_ratio")?.is_none() {
        return Ok(None);
    }
    let ratio = arguments.required("poisson_ratio", number)?;
    checked("poisson_ratio", ElasticBody::POISSON_RATIO, ratio).map(Some)
}
