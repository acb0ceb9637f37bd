//! The gas in the gaps of a scene: its conductivity, and the gas parameter or the properties that it follows from.

use std::ops::Range;

use ::interface::gas::{GapGas, RarefiedGas};
use serde_spanned::Spanned;
use study::material::Material;
use units::{Length, Temperature, ThermalConductivity};

use super::error::SceneError;
use super::loads::nominal_pressure;
use super::raw::RawInterface;
use super::values::optional;

/// Resolves the gas of a section on the interface; `None` if no key of it names one.
pub(super) fn resolve_gas(
    raw: &RawInterface,
    material: Option<&Material>,
) -> Result<Option<GapGas>, SceneError> {
    let conductivity: Option<ThermalConductivity> =
        optional("interface.gas_conductivity", raw.gas_conductivity.as_ref())?;
    let parameter: Option<Length> = optional("interface.gas_parameter", raw.gas_parameter.as_ref())?;
    let first_kinetic = kinetic(raw).into_iter().find_map(|(key, span)| Some((key, span?)));
    let (Some(conductivity), Some(typed)) = (conductivity, &raw.gas_conductivity) else {
        let given = raw.gas_parameter.as_ref().map(|typed| ("gas_parameter", typed.span()));
        return match given.or(first_kinetic) {
            Some((key, span)) => {
                let message =
                    format!("key interface.{key}: it says nothing without a gas_conductivity; give both");
                Err(SceneError::at(span, message))
            }
            None => Ok(None),
        };
    };
    let parameter_m = match (parameter, first_kinetic) {
        (Some(_), Some((key, span))) => {
            let message =
                format!("key interface.{key}: gas_parameter takes its place; leave one of them out");
            return Err(SceneError::at(span, message));
        }
        (Some(parameter), None) => parameter.m,
        (None, _) => parameter_of_gas_m(raw, material, typed.span())?,
    };
    GapGas::new(conductivity.w_per_m_k, parameter_m)
        .map(Some)
        .map_err(|error| SceneError::at(typed.span(), format!("key interface.gas_conductivity: {error}")))
}

/// The keys that the gas parameter follows from, each with its place if it is given.
fn kinetic(raw: &RawInterface) -> [(&'static str, Option<Range<usize>>); 7] {
    [
        ("accommodation", raw.accommodation.as_ref().map(Spanned::span)),
        ("counterface_accommodation", raw.counterface_accommodation.as_ref().map(Spanned::span)),
        ("heat_capacity_ratio", raw.heat_capacity_ratio.as_ref().map(Spanned::span)),
        ("prandtl_number", raw.prandtl_number.as_ref().map(Spanned::span)),
        ("mean_free_path", raw.mean_free_path.as_ref().map(Spanned::span)),
        ("gas_temperature", raw.gas_temperature.as_ref().map(Spanned::span)),
        ("gas_pressure", raw.gas_pressure.as_ref().map(Spanned::span)),
    ]
}

/// The gas parameter \[m\] of a gas of the conductivity at `span`.
fn parameter_of_gas_m(
    raw: &RawInterface,
    material: Option<&Material>,
    span: Range<usize>,
) -> Result<f64, SceneError> {
    let number = |value: &Option<Spanned<f64>>| value.as_ref().map(|value| *value.get_ref());
    let path: Option<Length> = optional("interface.mean_free_path", raw.mean_free_path.as_ref())?;
    let (Some(own), Some(other), Some(heat_capacity_ratio), Some(prandtl_number), Some(path)) = (
        number(&raw.accommodation),
        number(&raw.counterface_accommodation),
        number(&raw.heat_capacity_ratio),
        number(&raw.prandtl_number),
        path,
    ) else {
        let message = "key interface.gas_conductivity: a gas takes gas_parameter, or accommodation, counterface_accommodation, \
                       heat_capacity_ratio, prandtl_number and mean_free_path; give one or all of the others";
        return Err(SceneError::at(span, message));
    };
    let temperature: Option<Temperature> =
        optional("interface.gas_temperature", raw.gas_temperature.as_ref())?;
    let pressure = raw
        .gas_pressure
        .as_ref()
        .map(|typed| nominal_pressure("interface.gas_pressure", typed, material))
        .transpose()?;
    let refused =
        |error: units::OutOfBounds| SceneError::at(span.clone(), format!("gas in [interface]: {error}"));
    let mean_free_path_m = RarefiedGas::mean_free_path_m(
        path.m,
        temperature.map_or(RarefiedGas::REFERENCE_TEMPERATURE_K, |temperature| temperature.k),
        pressure.map_or(RarefiedGas::REFERENCE_PRESSURE_PA, |pressure| pressure.pa()),
    )
    .map_err(refused)?;
    RarefiedGas { accommodation: [own, other], heat_capacity_ratio, prandtl_number, mean_free_path_m }
        .parameter_m()
        .map_err(refused)
}
