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
    options: &ModelOptions,
) -> Result<Vec<Curve>, SceneError> {
    let mut curves: Vec<Curve> = Vec::new();
    for spanned in raw {
        let curve = spanned.get_ref();
        let Some(material) = material else {
            return Err(SceneError::at(spanned.span(), "a curve needs a section [material]"));
        };
        let own = ModelOptions {
            strain_gradient: curve.strain_gradient,
            interference_law: curve.interference_law,
            ..ModelOptions::default()
        };
        let of_curve = ModelOptions {
            hardness: options.hardness,
            interference_law: own.interference_law.or(options.interference_law),
            ..own.clone()
        };
        let model =
            curve.model.build(material, &of_curve).map_err(|error| SceneError::at(spanned.span(), error))?;
        let default_name = || curve.model.curve_name(&own);
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
