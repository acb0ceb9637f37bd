//! The material and the counterface of a scene.

use asperity::ElasticBody;
use serde_spanned::Spanned;

use super::error::SceneError;
use super::raw::{RawCounterface, RawMaterial, RawQuantity};
use super::values::{optional, quantity};
use crate::hardness_and_strength::HardnessAndStrength;
use crate::material::{GivenMaterial, Material, MaterialError};
use units::{Length, Modulus, Pressure};

pub(super) fn resolve_material(
    raw: &RawMaterial,
    counterface: Option<ElasticBody>,
    strength_cap: Option<Pressure>,
) -> Result<Material, SceneError> {
    let length: Option<Length> =
        optional("material.strain_gradient_length", raw.strain_gradient_length.as_ref())?;
    let hardness = optional("material.indentation_hardness", raw.indentation_hardness.as_ref())?;
    let strength = optional("material.yield_strength", raw.yield_strength.as_ref())?;
    let hardness_and_strength = HardnessAndStrength::new(hardness, strength).map_err(|error| {
        let span = raw.indentation_hardness.as_ref().map(RawQuantity::span);
        SceneError { problem: MaterialError::from(error).into(), span }
    })?;
    Ok(Material::new(GivenMaterial {
        body: elastic_body("material", &raw.youngs_modulus, &raw.poisson_ratio)?,
        counterface,
        hardness_and_strength,
        strength_cap,
        strain_gradient_length_m: length.map(|length| length.m),
    }))
}

/// The body of the counterface; rigid where only its surface is given.
pub(super) fn resolve_counterface(raw: &Spanned<RawCounterface>) -> Result<Option<ElasticBody>, SceneError> {
    let counterface = raw.get_ref();
    match (&counterface.youngs_modulus, &counterface.poisson_ratio) {
        (Some(modulus), Some(ratio)) => elastic_body("counterface", modulus, ratio).map(Some),
        (None, None) if counterface.surface.is_some() => Ok(None),
        _ => {
            let message = "[counterface] needs both youngs_modulus and poisson_ratio; with neither of them, only a surface, it \
                           is rigid";
            Err(SceneError::at(raw.span(), message))
        }
    }
}

fn elastic_body(
    section: &str,
    youngs_modulus: &RawQuantity,
    poisson_ratio: &Spanned<f64>,
) -> Result<ElasticBody, SceneError> {
    let modulus: Modulus = quantity(&format!("{section}.youngs_modulus"), youngs_modulus)?;
    ElasticBody::new(modulus.pa, *poisson_ratio.get_ref()).map_err(|error| {
        SceneError::at(poisson_ratio.span(), format!("key {section}.poisson_ratio: {error}"))
    })
}
