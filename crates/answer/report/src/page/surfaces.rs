//! The surfaces: each scan with its trusted band, or the spectrum.

use maud::{Markup, PreEscaped, html};
use measurements::{CompositeOfFiles, ScanSketch};
use study::surface::Surface;
use topography::ScanSpectrum;
use units::display::{counted, length, three_digits, typeset};

use super::{SceneReport, Section, gists, per_scene, sentence, table};
use crate::chart::maps::thumbnail;
use crate::scan_words::{self, sampling};

/// The most pictures of scans, and of height parameters below each: Sa and Sq, or Ra and Rq.
const PICTURES_SHOWN: usize = 6;
const PARAMETERS_SHOWN: usize = 2;

pub(super) fn section(scenes: &[SceneReport<'_>]) -> Option<Section> {
    let body = per_scene(scenes, |scene| Some(of(scene)))?;
    let gist = gists(scenes, |scene| Some(gist(scene)));
    Some(Section { id: "surfaces", title: "Surfaces", gist, body })
}

/// The surface, or both if each body has one.
fn surfaces(surface: &Surface) -> Vec<&Surface> {
    match &surface.parts {
        Some(parts) => parts.iter().collect(),
        None => vec![surface],
    }
}

fn gist(report: &SceneReport<'_>) -> String {
    let made_from =
        |surface: &Surface| surface.made_from.as_ref().map_or(0, |scans| scans.spectrum.scans.len());
    match surfaces(&report.scene.surface).into_iter().map(made_from).sum() {
        0 => sampling(report.results),
        scans => format!("{} · {}", counted(scans, "scan"), sampling(report.results)),
    }
}

fn of(report: &SceneReport<'_>) -> Markup {
    let surface = &report.scene.surface;
    html! {
        @for surface in surfaces(surface) {
            @match &surface.made_from {
                Some(scans) => {
                    (pictures(scans))
                    (scans_table(&scans.spectrum.scans, &scans.spectrum.series_names()))
                }
                None => p { code { (surface.name) } " is a spectrum: its heights are not known." },
            }
        }
        @for note in scan_words::foremost(surface) { p { (typeset(&sentence(&note))) } }
    }
}

/// The picture of each scan over its size and its first two height parameters.
fn pictures(scans: &CompositeOfFiles) -> Markup {
    html! {
        div.scans {
            @for (at, sketch) in scans.sketches.iter().enumerate() {
                @if let Some(thinned) = &sketch.thinned {
                    figure {
                        // The pictures of many scans would weigh more than the rest of the page.
                        @if at < PICTURES_SHOWN { (PreEscaped(thumbnail(thinned, &thinned.name).unwrap_or_default())) }
                        figcaption { strong { (thinned.name) } ", " (in_short(sketch)) }
                    }
                }
            }
        }
    }
}

/// `10 µm × 10 µm · Sa 3 nm · Sq 4 nm`.
fn in_short(sketch: &ScanSketch) -> String {
    let (x_m, y_m) = sketch.size_m;
    let mut parts = vec![match y_m {
        Some(y_m) => format!("{} × {}", length(x_m), length(y_m)),
        None => length(x_m),
    }];
    let parameters = sketch.parameters.map(|found| found.parameters()).unwrap_or_default();
    parts.extend(parameters.iter().take(PARAMETERS_SHOWN).map(ToString::to_string));
    parts.join(" · ")
}

fn scans_table(scans: &[ScanSpectrum], names: &[String]) -> Markup {
    let columns =
        ["scan", "format", "trusted from", "down to", "limit", "rms slope along", "across", "verdict"];
    let body = html! {
        tbody {
            @for (scan, name) in scans.iter().zip(names) {
                tr {
                    th scope="row" { (name) }
                    td { (scan.format) }
                    td { (length(scan.reliable.longest_wavelength_m())) }
                    td { (length(scan.reliable.shortest_wavelength_m())) }
                    td { (scan.band_end.to_string()) }
                    td { (three_digits(scan.checks.real_slope)) }
                    td { (scan.checks.slope_across.map_or("–".to_owned(), three_digits)) }
                    td { @if scan.is_doubtful() { "doubtful" } @else { "ok" } }
                }
            }
        }
    };
    table("Scans, and the wavelengths at which each is trusted.", &columns, &body)
}
