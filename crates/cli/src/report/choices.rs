//! The material, and the choices that the models leave open.

use maud::{Markup, html};

use super::{SceneReport, Section, per_scene};
use crate::display::length;
use crate::material::Material;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Section {
    let body = per_scene(scenes, |report| Some(of(report))).unwrap_or_default();
    Section { id: "choices", title: "Material and choices", body }
}

fn of(report: &SceneReport<'_>) -> Markup {
    let scene = report.scene;
    let properties = scene.material.as_ref().map(Material::properties).unwrap_or_default();
    let choices = scene.model_choices();
    html! {
        @if !properties.is_empty() {
            dl.pairs { @for (name, value) in &properties { div { dt { (name) } dd { (value) } } } }
        }
        @if !choices.is_empty() { ul { @for choice in &choices { li { (choice) } } } }
        @if let Some(density) = scene.sampling.scales_per_decade {
            p { "The spectrum is resampled to " (density) " scales per decade." }
        }
        @if let Some(cutoff_m) = scene.sampling.cutoff_m { p { "Scales below " (length(cutoff_m)) " are left out." } }
    }
}
