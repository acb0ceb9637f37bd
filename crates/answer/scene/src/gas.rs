//! The gas in the gaps of a scene.

use std::ops::Range;

use ::interface::gas::GapGas;
use study::interface::{GasError, GasInput};
use study::material::Material;

use super::error::SceneError;
use super::loads::nominal_pressure;
use super::raw::{RawInterface, Typed, given};

/// Resolves the gas of a section on the interface; `None` if no key of it names one.
pub(super) fn resolve_gas(
    raw: &RawInterface,
    material: Option<&Material>,
) -> Result<Option<GapGas>, SceneError> {
    let pressure = raw.gas_pressure.as_ref();
    let pressure = pressure.map(|typed| nominal_pressure("interface.gas_pressure", typed, material));
    let gas = GasInput {
        name: given(&raw.gas),
        temperature_k: given(&raw.gas_temperature).map(|temperature| temperature.k),
        pressure: given(&raw.gas_pressure),
        conductivity_w_per_m_k: given(&raw.gas_conductivity).map(|conductivity| conductivity.w_per_m_k),
        parameter_m: given(&raw.gas_parameter).map(|parameter| parameter.m),
    };
    gas.resolve(pressure.transpose()?).map_err(|error| {
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
        "gas_temperature" => raw.gas_temperature.as_ref().map(Typed::span),
        "gas_pressure" => raw.gas_pressure.as_ref().map(Typed::span),
        "gas_conductivity" => raw.gas_conductivity.as_ref().map(Typed::span),
        "gas_parameter" => raw.gas_parameter.as_ref().map(Typed::span),
        _ => raw.gas.as_ref().map(Typed::span),
    }
}
