//! The names of curves in print: their models in full, as the field calls them.

use stat_contact::{AsperityLaw, InterferenceLaw};

use study::figure::{FigureData, Shows};
use study::plan::{Curve, CurveModel};

/// The name of a curve in print: that of its model, behind its own where the user gave it one.
#[must_use]
pub fn in_full(curve: &Curve) -> String {
    let (key, full) = (key(&curve.model), model_in_full(&curve.model));
    if curve.name == key { full } else { format!("{}, {full}", curve.name) }
}

/// A figure of areas whose legend has the curves' names in full.
#[must_use]
pub fn with_full_names(figure: FigureData, curves: &[Curve]) -> FigureData {
    if !matches!(figure.shows, Shows::Area | Shows::AreaAgainstLoad) {
        return figure;
    }
    let mut figure = figure;
    for series in &mut figure.series {
        if let Some(curve) = curves.iter().find(|curve| curve.name == series.curve) {
            series.curve = in_full(curve);
        }
    }
    figure
}

/// The framework and the shape of its asperities, with whom the law is of.
fn model_in_full(model: &CurveModel) -> String {
    let name = match model {
        CurveModel::Statistical {
            law: AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem },
            ..
        } => "GW, elastic sinusoids (boundary elements)",
        _ => model.entry().full_name,
    };
    let suffix = if grows(model) { ", strain gradient" } else { "" };
    format!("{name}{suffix}")
}

/// The name that a scene gives a curve of this model where the user gives it none.
fn key(model: &CurveModel) -> String {
    let interference = match model {
        CurveModel::Statistical { law: AsperityLaw::ElasticSine { interference }, .. } => Some(*interference),
        _ => None,
    };
    model.entry().curve_name(grows(model), interference)
}

/// Whether the strength grows at small depths.
fn grows(model: &CurveModel) -> bool {
    model.strength().is_some_and(|strength| strength.strain_gradient_length_m().is_some())
}

#[cfg(test)]
mod tests {
    use super::*;
    use study::scene::{Scene, Template};

    #[test]
    fn a_curve_is_called_by_its_model_and_by_its_own_name_where_it_has_one() {
        let scene = Scene::builtin(Template::UncdMeasured).unwrap();
        let mut curves = scene.needs.curves.clone();
        let gradient = curves.iter().find(|curve| curve.name == "ep-sphere-strain-gradient").unwrap();
        assert_eq!(in_full(gradient), "GW, elastic-plastic spheres (Jackson-Green), strain gradient");
        let hertz = curves.iter_mut().find(|curve| curve.name == "hertz").unwrap();
        assert_eq!(in_full(hertz), "Greenwood-Williamson (Hertz)");
        hertz.name = "ring".to_owned();
        assert_eq!(in_full(hertz), "ring, Greenwood-Williamson (Hertz)");
    }

    #[test]
    fn no_two_curves_of_a_scene_share_a_name_in_print() {
        let scene = Scene::builtin(Template::UncdReconstructed).unwrap();
        let mut names: Vec<String> = scene.needs.curves.iter().map(in_full).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), scene.needs.curves.len());
    }
}
