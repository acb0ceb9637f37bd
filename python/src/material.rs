//! The bodies in contact.

use asperity::ElasticBody;
use pyo3::prelude::*;
use pyo3::types::PyString;
use study::hardness_and_strength::HardnessAndStrength;
use study::material::{GivenMaterial, Material, MaterialError, MaterialProperty};
use study::plan::Load;
use units::{Bound, IndentationHardness, Length, Modulus, Pressure};

use crate::errors::{input, of_argument};
use crate::quantities::{Given, checked, number, optional, quantity};

/// A material as the core has it.
#[pyclass(frozen, name = "Material", module = "truearea._native")]
pub struct PyMaterial {
    pub material: Material,
}

#[pymethods]
impl PyMaterial {
    #[new]
    #[pyo3(signature = (youngs_modulus, poisson_ratio, yield_strength, indentation_hardness, strain_gradient_length,
                        strength_cap, counterface))]
    fn new(
        youngs_modulus: &Given<'_>,
        poisson_ratio: &Given<'_>,
        yield_strength: Option<&Given<'_>>,
        indentation_hardness: Option<&Given<'_>>,
        strain_gradient_length: Option<&Given<'_>>,
        strength_cap: Option<&Given<'_>>,
        counterface: Option<(Given<'_>, Given<'_>)>,
    ) -> PyResult<Self> {
        let hardness: Option<IndentationHardness> = optional("indentation_hardness", indentation_hardness)?;
        let strength: Option<Pressure> = optional("yield_strength", yield_strength)?;
        let counterface = counterface
            .map(|(modulus, ratio)| {
                elastic_body("counterface.youngs_modulus", &modulus, "counterface.poisson_ratio", &ratio)
            })
            .transpose()?;
        let length: Option<Length> = optional("strain_gradient_length", strain_gradient_length)?;
        let given = GivenMaterial {
            body: elastic_body("youngs_modulus", youngs_modulus, "poisson_ratio", poisson_ratio)?,
            counterface,
            flows: study::bodies::Body::Rough,
            hardness_and_strength: HardnessAndStrength::new(hardness, strength)
                .map_err(|error| told(&error.into()))?,
            strength_cap: optional("strength_cap", strength_cap)?,
            strain_gradient_length_m: length.map(|length| length.m),
        };
        Ok(PyMaterial { material: Material::new(given) })
    }

    /// E* \[Pa\].
    #[getter]
    fn composite_modulus_pa(&self) -> f64 {
        self.material.pair.composite_modulus_pa()
    }

    /// H \[Pa\].
    #[getter]
    fn indentation_hardness_pa(&self) -> Option<f64> {
        self.material.hardness_pa()
    }

    /// S0 \[Pa\].
    #[getter]
    fn yield_strength_pa(&self) -> Option<f64> {
        self.material.yield_strength_pa()
    }

    /// A nominal pressure \[Pa\], perhaps in units of the hardness.
    fn pressure_pa(&self, argument: &str, pressure: &Given<'_>) -> PyResult<f64> {
        load(argument, pressure, &self.material).map(|load| load.nominal_pressure_pa())
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

/// A body of a modulus and a Poisson's ratio.
pub fn elastic_body(
    of_modulus: &str,
    modulus: &Given<'_>,
    of_ratio: &str,
    ratio: &Given<'_>,
) -> PyResult<ElasticBody> {
    let modulus: Modulus = quantity(of_modulus, modulus)?;
    let modulus_pa = checked(of_modulus, Bound::Magnitude, modulus.pa)?;
    let ratio = checked(of_ratio, ElasticBody::POISSON_RATIO, number(of_ratio, ratio)?)?;
    ElasticBody::new(modulus_pa, ratio).map_err(input)
}

/// Converts an error of a material, with the argument that mends it.
pub fn told(error: &MaterialError) -> PyErr {
    input(told_in_words(error))
}

/// Words an error of a material, with the argument that mends it.
pub fn told_in_words(error: &MaterialError) -> String {
    match error {
        MaterialError::Missing(needed_for) => {
            let arguments = match needed_for.property() {
                MaterialProperty::IndentationHardness => "indentation_hardness or yield_strength",
                MaterialProperty::YieldStrength => "yield_strength or indentation_hardness",
                MaterialProperty::StrainGradientLength => "strain_gradient_length",
            };
            format!("{error}: give the material {arguments}")
        }
        error => error.to_string(),
    }
}

/// A nominal pressure and how it was given.
fn load(argument: &str, given: &Given<'_>, material: &Material) -> PyResult<Load> {
    let pressure: Pressure = quantity(argument, given)?;
    let nominal_pressure = material.nominal_pressure(pressure).map_err(|error| match error {
        MaterialError::Bound(error) => {
            input(format!("{argument} is {}; it must be {}", error.value, error.bound))
        }
        error => told(&error),
    })?;
    let label = match given.cast::<PyString>() {
        Ok(text) => text.to_string(),
        Err(_) => nominal_pressure.label(),
    };
    Ok(Load { nominal_pressure, label })
}

/// The loads of an argument that is a pressure, or several of them.
pub fn loads(argument: &str, given: &Given<'_>, material: &Material) -> PyResult<Vec<Load>> {
    if !is_several(given) {
        return Ok(vec![load(argument, given, material)?]);
    }
    let one =
        |(at, given): (usize, PyResult<Given<'_>>)| load(&format!("{argument}[{at}]"), &given?, material);
    let loads: Vec<Load> = given.try_iter()?.enumerate().map(one).collect::<PyResult<_>>()?;
    if loads.is_empty() {
        return Err(of_argument(argument, "it is empty; give at least one pressure"));
    }
    Ok(loads)
}

/// Returns true for a list, an array of one axis, or anything else that one can go through; text is one thing.
pub fn is_several(given: &Given<'_>) -> bool {
    !given.is_instance_of::<PyString>() && given.len().is_ok()
}
