//! The material and the counterface of a scene.

use asperity::ElasticBody;
use serde_spanned::Spanned;

use super::diagnostic::SceneError;
use super::raw::{RawMaterial, RawQuantity};
use super::values::{optional, quantity};
use crate::material::{GivenMaterial, Material};
use crate::quantity::{Length, Modulus, Pressure};

pub(super) fn resolve_material(
    raw: &RawMaterial,
    counterface: Option<ElasticBody>,
    strength_cap: Option<Pressure>,
) -> Result<Material, SceneError> {
    let length: Option<Length> =
        optional("material.strain_gradient_length", raw.strain_gradient_length.as_ref())?;
    Ok(Material::new(GivenMaterial {
        body: elastic_body("material", &raw.youngs_modulus, &raw.poisson_ratio)?,
        counterface,
        yield_strength: optional("material.yield_strength", raw.yield_strength.as_ref())?,
        strength_cap,
        strain_gradient_length_m: length.map(|length| length.m),
    }))
}

pub(super) fn elastic_body(
    section: &str,
    youngs_modulus: &RawQuantity,
    poisson_ratio: &Spanned<f64>,
) -> Result<ElasticBody, SceneError> {
    let modulus: Modulus = quantity(&format!("{section}.youngs_modulus"), youngs_modulus)?;
    ElasticBody::new(modulus.pa, *poisson_ratio.get_ref()).map_err(|error| {
        SceneError::at(poisson_ratio.span(), format!("key {section}.poisson_ratio: {error}"))
    })
}
