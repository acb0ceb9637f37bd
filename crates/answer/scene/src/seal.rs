//! The seal of a scene: its joint, the fluid that leaks, and the unit of the leak rate.

use ::interface::gas::NamedGas;
use ::interface::leak::SealedJoint;
use ::interface::sealed_fluid::{LeakUnit, LeakingGas, SealedFluid};
use persson::sealing::PercolationThreshold;
use serde_spanned::Spanned;
use study::interface::Seal;
use study::material::Material;
use study::plan::NominalPressure;

use super::error::SceneError;
use super::loads::nominal_pressure;
use super::raw::{RawSeal, Typed, given};
use super::values::value_error;

/// Resolves the section on a seal.
pub(super) fn resolve_seal(raw: &Spanned<RawSeal>, material: Option<&Material>) -> Result<Seal, SceneError> {
    let seal = raw.get_ref();
    let threshold = seal.percolation_threshold.as_ref().map(|typed| {
        PercolationThreshold::new(*typed.get_ref()).map_err(|error| {
            value_error("seal.percolation_threshold", &typed.get_ref().to_string(), typed.span(), error)
        })
    });
    let drop = pressure("seal.pressure_drop", seal.pressure_drop.as_ref(), material)?;
    let fluid = resolve_fluid(raw, material)?;
    let joint = match (drop, fluid, given(&seal.breadth), given(&seal.length)) {
        (Some(drop), Some(fluid), Some(breadth), Some(length)) => Some(
            SealedJoint::new(breadth.m, length.m, drop.pa(), fluid)
                .map_err(|error| SceneError::at(raw.span(), format!("[seal]: {error}")))?,
        ),
        (None, None, None, None) => None,
        _ => {
            let message = "[seal]: a leak rate takes pressure_drop, breadth, length, and a viscosity or a gas; give all four, or \
                           none for the last channel alone";
            return Err(SceneError::at(raw.span(), message));
        }
    };
    let unit = seal.leak_unit.as_ref().map(|typed| leak_unit(typed, joint.as_ref())).transpose()?;
    Ok(Seal { threshold: threshold.transpose()?.unwrap_or_default(), joint, unit })
}

fn pressure(
    key: &str,
    typed: Option<&Typed<units::Pressure>>,
    material: Option<&Material>,
) -> Result<Option<NominalPressure>, SceneError> {
    typed.map(|typed| nominal_pressure(key, typed, material)).transpose()
}

/// Resolves the fluid, by its viscosity or as a gas; `None` if neither is given.
fn resolve_fluid(
    raw: &Spanned<RawSeal>,
    material: Option<&Material>,
) -> Result<Option<SealedFluid>, SceneError> {
    let seal = raw.get_ref();
    let of_gas = [
        ("gas_temperature", seal.gas_temperature.as_ref().map(Typed::span)),
        ("outlet_pressure", seal.outlet_pressure.as_ref().map(Typed::span)),
    ];
    match (&seal.viscosity, &seal.gas) {
        (Some(_), Some(gas)) => Err(SceneError::at(
            gas.span(),
            "key seal.gas: it and viscosity both name the fluid; leave one of them out",
        )),
        (viscosity, None) => match of_gas.into_iter().find_map(|(key, span)| Some((key, span?))) {
            Some((key, span)) => {
                let message =
                    format!("key seal.{key}: it needs a gas; give gas = \"air\", say, or leave it out");
                Err(SceneError::at(span, message))
            }
            None => Ok(viscosity
                .as_ref()
                .map(|typed| SealedFluid::Incompressible { viscosity_pa_s: typed.value.pa_s })),
        },
        (None, Some(gas)) => {
            let temperature_k = given(&seal.gas_temperature).map(|temperature| temperature.k);
            let outlet = pressure("seal.outlet_pressure", seal.outlet_pressure.as_ref(), material)?;
            let found = LeakingGas::new(
                gas.value,
                temperature_k.unwrap_or(NamedGas::REFERENCE_TEMPERATURE_K),
                outlet.map_or(NamedGas::REFERENCE_PRESSURE_PA, NominalPressure::pa),
            );
            let blamed = seal.gas_temperature.as_ref().map_or_else(|| gas.span(), Typed::span);
            found
                .map(|gas| Some(SealedFluid::Gas(gas)))
                .map_err(|error| SceneError::at(blamed, format!("key seal.gas_temperature: {error}")))
        }
    }
}

/// Resolves the unit of a leak rate, which needs a rate, and some a gas.
fn leak_unit(typed: &Typed<LeakUnit>, joint: Option<&SealedJoint>) -> Result<LeakUnit, SceneError> {
    let unit = typed.value;
    let problem = match joint {
        None => "it has no effect without a leak rate; give pressure_drop, breadth, length, and a viscosity or a gas".to_owned(),
        Some(joint) if unit.of(1.0, joint.fluid()).is_none() => {
            format!("{unit} is a unit of gases; give gas in place of viscosity, or leak_unit = \"ml/min\"")
        }
        Some(_) => return Ok(unit),
    };
    Err(SceneError::at(typed.span(), format!("key seal.leak_unit: {problem}")))
}
