//! The curves of a scene.

use serde_spanned::Spanned;

use super::error::SceneError;
use super::raw::RawCurve;
use super::values::check_file_name;
use study::material::Material;
use study::models::ModelOptions;
use study::plan::Curve;

/// The curves; `options` are those of the whole scene, which curves may overrule.
pub(super) fn resolve_curves(
    raw: &[Spanned<RawCurve>],
    material: Option<&Material>,
    options: ModelOptions,
) -> Result<Vec<Curve>, SceneError> {
    let mut curves: Vec<Curve> = Vec::new();
    for spanned in raw {
        let curve = spanned.get_ref();
        let Some(material) = material else {
            return Err(SceneError::at(spanned.span(), "a curve needs a section [material]"));
        };
        let of_curve = ModelOptions {
            strain_gradient: curve.strain_gradient,
            interference: curve.interference_law.unwrap_or(options.interference),
            ..options
        };
        let model =
            curve.model.build(material, &of_curve).map_err(|error| SceneError::at(spanned.span(), error))?;
        let default_name = || curve.model.curve_name(curve.strain_gradient, curve.interference_law);
        let name = curve.name.as_ref().map_or_else(default_name, |name| name.get_ref().clone());
        let name_span = curve.name.as_ref().map_or_else(|| spanned.span(), Spanned::span);
        check_file_name(&name, name_span.clone())?;
        if curves.iter().any(|other| other.name == name) {
            let message = format!("two curves are called {name:?}; give one of them another name = \"...\"");
            return Err(SceneError::at(name_span, message));
        }
        curves.push(Curve { name, model, cutoffs: curve.cutoffs.unwrap_or_default() });
    }
    Ok(curves)
}
