//! The gas in the gaps of a scene.

use std::ops::Range;

use ::interface::gas::GapGas;
use serde_spanned::Spanned;
use study::interface::{GasError, GasInput};
use study::material::Material;
use units::{Length, Pressure, Temperature, ThermalConductivity};

use super::error::SceneError;
use super::loads::nominal_pressure;
use super::raw::RawInterface;
use super::values::{optional, parsed};

/// Resolves the gas of a section on the interface; `None` if no key of it names one.
pub(super) fn resolve_gas(
    raw: &RawInterface,
    material: Option<&Material>,
) -> Result<Option<GapGas>, SceneError> {
    let conductivity: Option<ThermalConductivity> =
        optional("interface.gas_conductivity", raw.gas_conductivity.as_ref())?;
    let parameter: Option<Length> = optional("interface.gas_parameter", raw.gas_parameter.as_ref())?;
    let temperature: Option<Temperature> =
        optional("interface.gas_temperature", raw.gas_temperature.as_ref())?;
    let pressure =
        raw.gas_pressure.as_ref().map(|typed| nominal_pressure("interface.gas_pressure", typed, material));
    let pressure = pressure.transpose()?;
    let given = GasInput {
        name: raw.gas.as_ref().map(|name| parsed("interface.gas", name)).transpose()?,
        temperature_k: temperature.map(|temperature| temperature.k),
        pressure: pressure.map(|pressure| Pressure::Pascals(pressure.pa())),
        conductivity_w_per_m_k: conductivity.map(|conductivity| conductivity.w_per_m_k),
        parameter_m: parameter.map(|parameter| parameter.m),
    };
    given.resolve(pressure).map_err(|error| {
        let (option, problem) = match error {
            GasError::Beside(option, other) => {
                (option, format!("it has no effect beside {}; leave one of them out", other))
            }
            GasError::Needs(option, other) => (option, format!("it needs {}; give both", other)),
            GasError::Value(option, error) => (option, error.to_string()),
        };
        let message = format!("key interface.{}: {problem}", option);
        SceneError { span: span(raw, option), ..SceneError::anywhere(message) }
    })
}

fn span(raw: &RawInterface, option: &str) -> Option<Range<usize>> {
    match option {
        "gas_temperature" => raw.gas_temperature.as_ref().map(Spanned::span),
        "gas_pressure" => raw.gas_pressure.as_ref().map(Spanned::span),
        "gas_conductivity" => raw.gas_conductivity.as_ref().map(Spanned::span),
        "gas_parameter" => raw.gas_parameter.as_ref().map(Spanned::span),
        _ => raw.gas.as_ref().map(Spanned::span),
    }
}
