//! The loads of a scene.

use serde_spanned::Spanned;

use super::error::{SceneError, SceneProblem};
use super::raw::{RawLoads, Typed, given};
use super::values::value_error;
use study::material::{Material, MaterialError, NeededFor};
use study::plan::{Load, NominalPressure};
use units::{Area, Force, Pressure};

pub(super) fn resolve_loads(
    raw: &Spanned<RawLoads>,
    material: Option<&Material>,
) -> Result<Vec<Load>, SceneError> {
    let loads = raw.get_ref();
    let resolved = match (&loads.pressures, &loads.force, &loads.nominal_area) {
        (Some(pressures), None, None) => {
            pressures.iter().map(|raw| pressure_load(raw, material)).collect::<Result<_, _>>()?
        }
        (None, Some(force), Some(area)) => vec![force_load(force, area)?],
        _ => {
            let message = "[loads] takes either pressures = [...], or force and nominal_area together";
            return Err(SceneError::at(raw.span(), message));
        }
    };
    if let Some(twice) = resolved.iter().enumerate().find(|(i, load)| resolved[..*i].contains(load)) {
        let message = format!("key loads.pressures: {} occurs twice; keep one", twice.1.label);
        return Err(SceneError::at(raw.span(), message));
    }
    if resolved.is_empty() {
        return Err(SceneError::at(raw.span(), "[loads] is empty; give at least one pressure"));
    }
    Ok(resolved)
}

fn pressure_load(raw: &Typed<Pressure>, material: Option<&Material>) -> Result<Load, SceneError> {
    Ok(Load {
        nominal_pressure: nominal_pressure("loads.pressures", raw, material)?,
        label: raw.text.clone(),
    })
}

/// The nominal pressure under a key, in Pa or in H.
pub(super) fn nominal_pressure(
    key: &str,
    raw: &Typed<Pressure>,
    material: Option<&Material>,
) -> Result<NominalPressure, SceneError> {
    let pressure_pa = raw.value.pascals(material.and_then(Material::hardness_pa)).ok_or_else(|| {
        let missing = MaterialError::Missing(NeededFor::PressureInHardnesses);
        value_error(key, &raw.text, raw.span(), SceneProblem::from(missing))
    })?;
    NominalPressure::new(pressure_pa)
        .map_err(|error| value_error(key, &raw.text, raw.span(), format!("{}: {error}", raw.text)))
}

/// The nominal area \[m^2\] that a force presses on; none where pressures are given.
pub(super) fn nominal_area_m2(raw: &Spanned<RawLoads>) -> Option<f64> {
    given(&raw.get_ref().nominal_area).map(|area| area.m2)
}

fn force_load(force: &Typed<Force>, area: &Typed<Area>) -> Result<Load, SceneError> {
    let label = format!("{} on {}", force.text, area.text);
    let nominal_pressure = NominalPressure::new(force.value.n / area.value.m2)
        .map_err(|error| value_error("loads.force", &label, force.span(), format!("{label}: {error}")))?;
    Ok(Load { nominal_pressure, label })
}
