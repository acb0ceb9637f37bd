//! The curves of a scene.

use asperity::Hardness;
use serde_spanned::Spanned;
use stat_contact::InterferenceLaw;

use super::error::SceneError;
use super::raw::RawCurve;
use super::values::check_file_name;
use crate::material::{Framework, Material, MaterialError, ModelName};
use crate::plan::{Curve, CurveModel};

/// What the laws of statistical curves leave to choose.
#[derive(Clone, Copy)]
pub(super) struct LawOptions {
    pub hardness: Hardness,
    pub interference: InterferenceLaw,
}

pub(super) fn resolve_curves(
    raw: &[Spanned<RawCurve>],
    material: Option<&Material>,
    options: LawOptions,
) -> Result<Vec<Curve>, SceneError> {
    let mut curves: Vec<Curve> = Vec::new();
    for spanned in raw {
        let curve = spanned.get_ref();
        let Some(material) = material else {
            return Err(SceneError::at(spanned.span(), "a curve needs a section [material]"));
        };
        let model = model(curve, material, options).map_err(|error| SceneError::at(spanned.span(), error))?;
        let name = curve.name.as_ref().map_or_else(|| default_name(curve), |name| name.get_ref().clone());
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

fn model(curve: &RawCurve, material: &Material, options: LawOptions) -> Result<CurveModel, MaterialError> {
    Ok(match curve.model.framework() {
        Framework::Stacked(name) => CurveModel::Stacked(material.stacked(name, curve.strain_gradient)?),
        Framework::Statistical(name) => {
            let interference = curve.interference_law.unwrap_or(options.interference);
            let law = material.statistical(name, curve.strain_gradient, options.hardness, interference)?;
            CurveModel::Statistical { pair: material.pair, law }
        }
    })
}

/// The model's own name, and what sets the curve apart from the plain one.
fn default_name(curve: &RawCurve) -> String {
    let (name, yields) = match curve.model {
        ModelName::Elastic => ("elastic", false),
        ModelName::ElasticPlastic => ("elastic-plastic", true),
        ModelName::Hertz => ("hertz", false),
        ModelName::EpSphere => ("ep-sphere", true),
        ModelName::ElasticSine => ("elastic-sine", false),
        ModelName::EpSine => ("ep-sine", true),
    };
    let bem = curve.interference_law == Some(InterferenceLaw::Bem) && curve.model == ModelName::ElasticSine;
    match (curve.strain_gradient && yields, bem) {
        (true, _) => format!("{name}-strain-gradient"),
        (_, true) => format!("{name}-bem"),
        _ => name.to_owned(),
    }
}
