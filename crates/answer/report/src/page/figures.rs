//! The figures, with those of several scenes side by side.

use maud::{Markup, PreEscaped, html};

use super::{SceneReport, Section, sentence};
use crate::chart;
use study::figure::{BandKind, FigureData, Shows};
use units::display::counted;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let mut names: Vec<&str> = Vec::new();
    for figure in scenes.iter().flat_map(|scene| &scene.figures) {
        if !names.contains(&figure.name.as_str()) {
            names.push(&figure.name);
        }
    }
    let body = html! { div.figures { @for name in &names { (figure(scenes, name)) } } };
    let gist = counted(names.len(), "figure");
    (!names.is_empty()).then_some(Section { id: "figures", title: "Figures", gist, body })
}

/// The figure of this name, a panel for each scene that has it.
fn figure(scenes: &[SceneReport<'_>], name: &str) -> Markup {
    let own = |scene: &SceneReport<'_>| scene.figures.iter().position(|figure| figure.name == name);
    let panels: Vec<(&SceneReport<'_>, &FigureData)> =
        scenes.iter().filter_map(|scene| Some((scene, &scene.figures[own(scene)?]))).collect();
    let beside: Vec<&FigureData> = panels.iter().map(|(_, figure)| *figure).collect();
    let Some((_, first)) = panels.first() else { return html! {} };
    html! {
        figure {
            div.panels {
                @for (scene, figure) in &panels {
                    div {
                        @if scenes.len() > 1 { p.panel { (scene.label) } }
                        (PreEscaped(chart::element(figure, &beside, &words(scene, figure))))
                    }
                }
            }
            figcaption { strong { (numbered(name)) (sentence(&first.title)) } " " (caption(first.shows)) (intervals(first)) }
        }
    }
}

/// The text for readers who cannot see a panel.
fn words(scene: &SceneReport<'_>, figure: &FigureData) -> String {
    format!("{} ({}): {} against {}", figure.title, scene.label, figure.y_label, figure.x_label)
}

/// Returns `Figure 3a. ` for `figure-3a`. Other names add nothing to the title.
fn numbered(name: &str) -> String {
    name.strip_prefix("figure-").map_or_else(String::new, |number| format!("Figure {number}. "))
}

/// The explanation of interval bands, if the figure has some.
fn intervals(figure: &FigureData) -> &'static str {
    let has_intervals = figure.bands.iter().any(|band| band.kind == BandKind::Interval);
    if has_intervals { " Bands are coverage intervals, each in the colour of its line." } else { "" }
}

/// The caption of a figure.
fn caption(shows: Shows) -> &'static str {
    match shows {
        Shows::Psd => "The spectrum that everything else is computed from.",
        Shows::Moments => {
            "Variance of height (m0), slope (m2) and curvature (m4) of the wavelengths down to the abscissa, each over \
             its value for the whole spectrum."
        }
        Shows::Amplitude => "The height of the sinusoid that stands for each wavelength.",
        Shows::AspectRatio => {
            "Height over wavelength of each scale: the steepest scale takes the largest pressure to flatten."
        }
        Shows::Area => {
            "The contact area when only the wavelengths down to the abscissa take part: finer roughness comes in \
             towards the left, and a line that levels off is settled."
        }
        Shows::AreaAgainstLoad => {
            "The contact area under growing load, the spectrum cut off at some wavelengths."
        }
        Shows::Response => "",
    }
}
