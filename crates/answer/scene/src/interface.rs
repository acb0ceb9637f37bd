//! The interface results that a scene requests: typed values, checked against their bounds.

use ::interface::conductance::{Conductivities, Resistivities};
use units::Bound;
use units::display::length;

use super::error::SceneError;
use super::gas::resolve_gas;
use super::loads::nominal_pressure;
use super::raw::{RawInterface, RawScene, given};
use super::seal::resolve_seal;
use super::values::number;
use study::bodies::{Bodies, Transport};
use study::body_properties::BodyProperty;
use study::interface::{AdhesionRequest, Asks, InterfaceRequest, Shear, ShearLoad};
use study::material::Material;
use study::plan::NominalPressure;

/// Resolves the results requested of the interface, with the conductivities and resistivities of both bodies. Returns
/// `None` if the scene has no section on the interface or seal and no pair of conductivities or resistivities.
pub(super) fn resolve_interface(
    raw: &RawScene,
    material: Option<&Material>,
    bodies: &Bodies,
    nominal_area_m2: Option<f64>,
) -> Result<Option<InterfaceRequest>, SceneError> {
    let conductivities = of_both(bodies, |transport| transport.thermal_conductivity_w_per_m_k);
    let conductivities = conductivities.map(|[own, other]| Conductivities::new(own, other));
    let resistivities = of_both(bodies, |transport| transport.resistivity_ohm_m);
    let resistivities = resistivities.map(|[own, other]| Resistivities::new(own, other));
    let anywhere = |error: units::OutOfBounds| SceneError::anywhere(error.to_string());
    let conductivities = conductivities.transpose().map_err(anywhere)?;
    let resistivities = resistivities.transpose().map_err(anywhere)?;
    let is_asked =
        raw.interface.is_some() || raw.seal.is_some() || conductivities.is_some() || resistivities.is_some();
    if !is_asked {
        return Ok(None);
    }
    let nothing = RawInterface::default();
    let own = raw.interface.as_ref().unwrap_or(&nothing);
    let shear_strength = own
        .shear_strength
        .as_ref()
        .map(|typed| nominal_pressure("interface.shear_strength", typed, material))
        .transpose()?;
    Ok(Some(InterfaceRequest {
        energy_factor: given(&own.gamma).unwrap_or_default(),
        band: given(&own.band).unwrap_or_default(),
        conductivities,
        resistivities,
        gas: resolve_gas(own, material)?,
        flatness: given(&own.flatness),
        nominal_area_m2,
        seal: raw.seal.as_ref().map(|seal| resolve_seal(seal, material)).transpose()?,
        shear_strength_pa: shear_strength.map(NominalPressure::pa),
        adhesion: resolve_adhesion(own)?,
        shear: resolve_shear(own, material)?,
        asks: asks(raw, nominal_area_m2.is_some()),
    }))
}

/// Tells what a scene asks for: heat and current by conductivities and resistivities that it types itself, by a gas, or by a nominal
/// area without any other question; gap and stiffness by a section on the interface without a question of its own.
fn asks(raw: &RawScene, has_nominal_area: bool) -> Asks {
    let types = |property: BodyProperty| {
        let by_rough = raw.material.as_ref().is_some_and(|body| body.get_ref().types(property));
        by_rough || raw.counterface.as_ref().is_some_and(|body| body.get_ref().types(property))
    };
    let names_gas = |own: &RawInterface| own.gas.is_some() || own.gas_conductivity.is_some();
    let is_open = raw.interface.as_ref().is_some_and(RawInterface::has_no_question);
    let asks_else = raw.interface.as_ref().is_some_and(|own| !own.has_no_question()) || raw.seal.is_some();
    let of_area = has_nominal_area && !asks_else;
    Asks {
        gap: is_open,
        heat: of_area
            || types(BodyProperty::ThermalConductivity)
            || raw.interface.as_ref().is_some_and(names_gas),
        current: of_area || types(BodyProperty::Resistivity),
    }
}

/// Refuses a flatness over less than the waves of the spectrum, which has it already.
pub(super) fn check_flatness(raw: &RawScene, longest_m: f64) -> Result<(), SceneError> {
    let Some(typed) = raw.interface.as_ref().and_then(|own| own.flatness.as_ref()) else { return Ok(()) };
    // Scans show waves up to half of their length, once their trend is removed.
    if typed.value.span_m() > longest_m {
        return Ok(());
    }
    let message = format!(
        "a flatness of {} is over less than the longest wave of the spectrum, {}, which shows it already; give the flatness of the \
         nominal contact, over its length, or leave it out",
        typed.text,
        length(longest_m)
    );
    Err(SceneError::at(typed.span(), message))
}

/// Resolves a tangential load: a coefficient of friction, with either a stress or its share of friction times pressure.
fn resolve_shear(raw: &RawInterface, material: Option<&Material>) -> Result<Option<Shear>, SceneError> {
    let load = match (&raw.tangential_stress, &raw.share_of_sliding) {
        (Some(_), Some(share)) => {
            let message = "key interface.share_of_sliding: it and tangential_stress both give the tangential load; \
                           leave one out";
            return Err(SceneError::at(share.span(), message));
        }
        (Some(typed), None) => {
            let stress = nominal_pressure("interface.tangential_stress", typed, material)?;
            Some((typed.span(), "tangential_stress", ShearLoad::StressPa(stress.pa())))
        }
        (None, Some(typed)) => {
            let key = "interface.share_of_sliding";
            let below_one = Bound::Between { above: 0.0, below: 1.0 };
            let share = number(key, "share of sliding", typed, below_one)?;
            Some((typed.span(), "share_of_sliding", ShearLoad::ShareOfSliding(share)))
        }
        (None, None) => None,
    };
    match (&raw.friction, load) {
        (Some(typed), Some((_, _, load))) => {
            let friction = number("interface.friction", "coefficient of friction", typed, Bound::Magnitude)?;
            Ok(Some(Shear { friction, load }))
        }
        (Some(typed), None) => Err(SceneError::at(
            typed.span(),
            "key interface.friction: it needs a tangential load; give tangential_stress or share_of_sliding",
        )),
        (None, Some((span, key, _))) => Err(SceneError::at(
            span,
            format!(
                "key interface.{key}: a tangential load needs a coefficient of friction; give friction = 0.3, say"
            ),
        )),
        (None, None) => Ok(None),
    }
}

/// Returns a transport property of both bodies, if both have it.
fn of_both(bodies: &Bodies, of: fn(&Transport) -> Option<f64>) -> Option<[f64; 2]> {
    Some([of(&bodies.transport)?, of(&bodies.counterface_transport)?])
}

fn resolve_adhesion(raw: &RawInterface) -> Result<Option<AdhesionRequest>, SceneError> {
    match (given(&raw.work_of_adhesion), &raw.range_of_attraction) {
        (None, Some(typed)) => Err(SceneError::at(
            typed.span(),
            "key interface.range_of_attraction: it needs a work_of_adhesion; give both",
        )),
        (work, range) => Ok(work.map(|work| AdhesionRequest {
            work_j_per_m2: work.j_per_m2,
            range_m: range.as_ref().map(|range| range.value.m),
        })),
    }
}
