//! The layer on the rough body of a scene.

use asperity::{ElasticBody, Layer};
use serde_spanned::Spanned;
use study::layer_base::LayerBase;

use super::error::{SceneError, SceneProblem};
use super::raw::RawLayer;

/// Resolves a layer on the rough body; `base` returns the latter, which a rigid base takes the place of.
pub(super) fn resolve_layer(
    raw: &Spanned<RawLayer>,
    base: impl FnOnce() -> Result<ElasticBody, SceneError>,
) -> Result<Layer, SceneError> {
    let RawLayer { thickness, youngs_modulus, poisson_ratio, .. } = raw.get_ref();
    let missing = |key: &str| {
        SceneError::at(raw.span(), SceneProblem::MissingKey { key: format!("material.layer.{key}") })
    };
    let at = |key: &str, span, error: asperity::AsperityError| {
        SceneError::at(span, format!("key material.layer.{key}: {error}"))
    };
    let thickness = thickness.as_ref().ok_or_else(|| missing("thickness"))?;
    let youngs_modulus = youngs_modulus.as_ref().ok_or_else(|| missing("youngs_modulus"))?;
    let ratio = poisson_ratio.as_ref().ok_or_else(|| missing("poisson_ratio"))?;
    Layer::POISSON_RATIO
        .check("Poisson's ratio of the layer", *ratio.get_ref())
        .map_err(|error| at("poisson_ratio", ratio.span(), error))?;
    let body = ElasticBody::new(youngs_modulus.value.pa, *ratio.get_ref())
        .map_err(|error| at("youngs_modulus", youngs_modulus.span(), error))?;
    let base = match raw.get_ref().base.unwrap_or_default() {
        LayerBase::Rigid => None,
        LayerBase::Material => Some(base()?),
    };
    Layer::new(body, thickness.value.m, base).map_err(|error| at("thickness", thickness.span(), error))
}
