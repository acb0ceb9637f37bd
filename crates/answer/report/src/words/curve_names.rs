//! The names of curves in print: one short name per model, after the user's own name where there is one.

use study::figure::FigureData;
use study::models::CurveModel;
use study::plan::Curve;

/// The name of a curve in print: the short name of its model, after its own name if the user gave one.
#[must_use]
pub fn in_full(curve: &Curve) -> String {
    let (key, model) = (key(&curve.model), model_in_short(&curve.model));
    if curve.name == key { model } else { format!("{} ({model})", curve.name) }
}

/// The shortest name of a curve in print: its own name if the user gave one, else that of its model.
#[must_use]
pub fn short_name(curve: &Curve) -> String {
    if curve.name == key(&curve.model) { model_in_short(&curve.model) } else { curve.name.clone() }
}

/// The model of a curve with its authors and its choices in words.
#[must_use]
pub fn model_in_words(model: &CurveModel) -> String {
    let settings = model.options().settings(|choice| model.entry.has(choice));
    let words = settings.iter().map(|setting| setting.words.as_str());
    std::iter::once(model.entry.full_name).chain(words).collect::<Vec<_>>().join(", ")
}

/// The full name of a model with its choices and its publication, for those who know the short one.
#[must_use]
pub fn in_words_with_publication(model: &CurveModel) -> String {
    format!("{}. {}", model_in_words(model), model.entry.citation)
}

/// The short name of a model, with the choices that differ from the plain one.
fn model_in_short(model: &CurveModel) -> String {
    let settings = model.options().settings(|choice| model.entry.has(choice));
    let choices = settings.iter().map(|setting| setting.short.as_str());
    std::iter::once(model.entry.short_name).chain(choices).collect::<Vec<_>>().join(", ")
}

/// A figure of areas whose legend has the curves' names in print.
#[must_use]
pub fn with_printed_names(figure: FigureData, curves: &[Curve]) -> FigureData {
    if !figure.shows.draws_areas() {
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

/// The default name of a curve with this model in a scene.
fn key(model: &CurveModel) -> String {
    model.entry.curve_name(&model.options())
}

#[cfg(test)]
mod tests {
    use super::*;
    use scene::{Scene, Template};

    #[test]
    fn a_curve_is_called_by_its_model_and_by_its_own_name_where_it_has_one() {
        let scene = Scene::builtin(Template::UncdMeasured).unwrap();
        let mut curves = scene.needs.curves.clone();
        let gradient = curves.iter().find(|curve| curve.name == "ep-sphere-strain-gradient").unwrap();
        assert_eq!(in_full(gradient), "GW spheres, elastic-plastic, hardening");
        let hertz = curves.iter_mut().find(|curve| curve.name == "hertz").unwrap();
        assert_eq!(in_full(hertz), "Greenwood & Williamson");
        assert_eq!(model_in_words(&hertz.model), "Greenwood-Williamson (Hertz)");
        let cited = in_words_with_publication(&hertz.model);
        assert_eq!(
            cited,
            "Greenwood-Williamson (Hertz). Greenwood & Williamson (1966), Proc. R. Soc. A 295:300"
        );
        hertz.name = "ring".to_owned();
        assert_eq!(in_full(hertz), "ring (Greenwood & Williamson)");
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
