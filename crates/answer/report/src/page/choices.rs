//! The material and the modelling choices.

use maud::{Markup, html};

use super::{SceneReport, Section, per_scene, sentence};
use crate::curve_names::{in_full, in_words_with_publication};
use study::material::Material;
use study::plan::Sampling;
use units::display::length;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, of)?;
    Some(Section { id: "choices", title: "Material and choices", gist: String::new(), body })
}

fn of(report: &SceneReport<'_>) -> Option<Markup> {
    let scene = report.scene;
    let properties = scene.material.as_ref().map(Material::properties).unwrap_or_default();
    let choices = scene.model_choices();
    let sampling = scene.sampling;
    let curves = &scene.needs.curves;
    if properties.is_empty() && choices.is_empty() && curves.is_empty() && sampling == Sampling::default() {
        return None;
    }
    Some(html! {
        @if !properties.is_empty() {
            dl.pairs { @for (name, value) in &properties { div { dt { (name) } dd { (value) } } } }
        }
        @for line in scene.bodies.describe(scene.softer(), &scene.spreads) { p { (sentence(&line)) } }
        @if !choices.is_empty() { ul { @for choice in &choices { li { (choice) } } } }
        @if !curves.is_empty() {
            ul {
                @for curve in curves {
                    li { (in_full(curve)) " (" code { (curve.name) } "): " (in_words_with_publication(&curve.model)) }
                }
            }
        }
        @if let Some(density) = sampling.scales_per_decade {
            p { "The spectrum is resampled to " (density) " scales per decade." }
        }
        @if let Some(cutoff_m) = sampling.cutoff_m { p { "Scales below " (length(cutoff_m)) " are left out." } }
    })
}
