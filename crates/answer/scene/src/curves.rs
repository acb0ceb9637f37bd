//! The curves of a scene.

use std::io::Cursor;

use measurements::Files;
use persson::corrections::Correction;
use serde_spanned::Spanned;
use tables::TableSource;
use units::Remark;

use super::error::SceneError;
use super::raw::{RawCurve, given};
use super::values::{check_file_name, value_error};
use study::growth_law::GrowthLaw;
use study::material::Material;
use study::models::{Choice, Framework, MODELS, ModelOptions};
use study::plan::{Curve, Cutoffs};

/// Returns the curves, and for each of them the options that its model ignores. `options` are those of the whole scene,
/// which curves may override.
pub(super) fn resolve_curves(
    raw: &[Spanned<RawCurve>],
    material: Option<&Material>,
    options: &ModelOptions,
    files: &dyn Files,
) -> Result<(Vec<Curve>, Vec<Vec<Remark>>), SceneError> {
    let mut curves: Vec<Curve> = Vec::new();
    let mut ignored = Vec::new();
    for spanned in raw {
        let curve = spanned.get_ref();
        let Some((material, entry)) = material.zip(curve.model) else {
            return Err(SceneError::at(spanned.span(), "a curve needs a section [material]"));
        };
        let own = own_options(curve, files)?;
        // A growth that is turned off is ignored as one that is on; notes are made on keys that are typed.
        ignored.push(ModelOptions { strain_gradient: true, ..own.clone() }.ignored_by(entry));
        let with_those_of_the_scene = ModelOptions {
            hardness: options.hardness,
            flattening: options.flattening,
            elastic_plastic_area: options.elastic_plastic_area,
            interference_law: own.interference_law.or(options.interference_law),
            ..own.clone()
        };
        let model = entry.build(material, &with_those_of_the_scene);
        let model = model.map_err(|error| SceneError::at(spanned.span(), error))?;
        let default_name = || entry.curve_name(&own);
        let name = curve.name.as_ref().map_or_else(default_name, |name| name.get_ref().clone());
        let name_span = curve.name.as_ref().map_or_else(|| spanned.span(), Spanned::span);
        check_file_name(&name, name_span.clone())?;
        if curves.iter().any(|other| other.name == name) {
            let message = format!("two curves are called {name:?}; give one of them another name = \"...\"");
            return Err(SceneError::at(name_span, message));
        }
        curves.push(Curve { name, model, cutoffs: curve.cutoffs.unwrap_or_default() });
    }
    Ok((curves, ignored))
}

/// Returns a curve for every model that applies to a material: models that need a property which the material lacks are
/// left out. Models with a strength that may grow, and with a correction that is nearer to boundary elements, come in both
/// forms.
pub(super) fn curves_that_apply(material: &Material, options: &ModelOptions) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for entry in MODELS.iter() {
        let mut forms = vec![options.clone()];
        // Persson's theory with a hardness that grows takes longer than all other models together.
        if entry.has(Choice::StrainGradient) && entry.framework != Framework::Persson {
            forms.push(ModelOptions { strain_gradient: true, ..forms[0].clone() });
        }
        if entry.has(Choice::Correction) {
            forms.push(ModelOptions { correction: Some(Correction::AlgebraicNayak), ..options.clone() });
        }
        for form in forms {
            let Ok(model) = entry.build(material, &form) else { continue };
            let ModelOptions { strain_gradient, correction, .. } = form;
            let own = ModelOptions { strain_gradient, correction, ..ModelOptions::default() };
            curves.push(Curve { name: entry.curve_name(&own), model, cutoffs: Cutoffs::default() });
        }
    }
    curves
}

/// Returns the options that a curve gives itself.
fn own_options(curve: &RawCurve, files: &dyn Files) -> Result<ModelOptions, SceneError> {
    Ok(ModelOptions {
        gamma: given(&curve.gamma),
        hardness_law: curve.hardness_law.as_ref().map(|text| growth_law(text, files)).transpose()?,
        ..curve.options.clone()
    })
}

/// Reads the growth of a hardness: `power:N`, `nix-gao`, or `table:FILE` with the columns `contact_size_m` and
/// `hardness_pa`.
fn growth_law(text: &Spanned<String>, files: &dyn Files) -> Result<GrowthLaw, SceneError> {
    let typed = text.get_ref();
    let refused = |problem: String| value_error("curve.hardness_law", typed, text.span(), problem);
    if let Some(name) = typed.strip_prefix("table:").filter(|name| !name.is_empty()) {
        return table_of_hardnesses(name, files).map_err(refused);
    }
    let law = GrowthLaw::named(typed).map_err(refused)?;
    law.ok_or_else(|| refused("expected power:N, nix-gao or table:FILE".to_owned()))
}

fn table_of_hardnesses(name: &str, files: &dyn Files) -> Result<GrowthLaw, String> {
    let bytes = files.read(name).map_err(|error| format!("{name}: {error}"))?;
    let table = TableSource::new(name, Cursor::new(bytes)).and_then(TableSource::whole);
    GrowthLaw::from_table(&table.map_err(|error| error.to_string())?)
        .map_err(|error| format!("{name}: {error}"))
}
