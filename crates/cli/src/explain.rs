//! What a scene needs and what is skipped, told before anything is computed.

use crate::display::{length, three_digits};
use crate::figure::Shows;
use crate::plan::{CurveModel, scales_per_decade};
use crate::scene::Scene;
use crate::summary::aligned;

type IsFramework = fn(&CurveModel) -> bool;

const FRAMEWORKS: [(&str, IsFramework); 2] = [("stacked", is_stacked), ("statistical", is_statistical)];

fn is_stacked(model: &CurveModel) -> bool {
    matches!(model, CurveModel::Stacked(_))
}

fn is_statistical(model: &CurveModel) -> bool {
    matches!(model, CurveModel::Statistical { .. })
}

/// The explanation of a scene.
pub fn explain(scene: &Scene) -> String {
    let mut rows = vec![vec!["spectrum".to_owned(), spectrum(scene)]];
    let mut row = |needed: bool, what: String| {
        rows.push(vec![if needed { "needed" } else { "skipped" }.to_owned(), what]);
    };
    let needs = &scene.needs;
    row(
        scene.sampling.scales_per_decade.is_some(),
        match scene.sampling.scales_per_decade {
            Some(n) => format!("resampling to {n} scales per decade"),
            None => "resampling: options.scales_per_decade is not set".to_owned(),
        },
    );
    row(
        needs.moments.is_some(),
        match needs.moments {
            Some(norm) => format!("moments for every cutoff, {norm} ({})", figures(scene, &[Shows::Moments])),
            None => "moments and asperity parameters: no curve and no figure uses them".to_owned(),
        },
    );
    row(
        needs.amplitudes.is_some(),
        match needs.amplitudes {
            Some(definition) if !needs.curves.iter().any(|curve| is_stacked(&curve.model)) => {
                format!(
                    "amplitudes, {definition} ({})",
                    figures(scene, &[Shows::Amplitude, Shows::AspectRatio])
                )
            }
            Some(definition) => format!("amplitudes, {definition} (the stacked curves)"),
            None => "amplitudes: no curve and no figure uses them".to_owned(),
        },
    );
    for (framework, is_its) in FRAMEWORKS {
        if !needs.curves.iter().any(|curve| is_its(&curve.model)) {
            row(false, format!("{framework} model: no curve asks for it"));
        }
        for curve in needs.curves.iter().filter(|curve| is_its(&curve.model)) {
            row(true, format!("{framework} curve {} at {} loads", curve.name, needs.loads.len()));
        }
    }
    if !needs.sweeps.is_empty() {
        let states: usize = needs.sweeps.iter().map(|sweep| sweep.pressures_pa.len()).sum();
        row(
            true,
            format!("{states} statistical states over loads ({})", figures(scene, &[Shows::AreaAgainstLoad])),
        );
    }
    row(false, "self-affine fit: only `truearea fit` computes it".to_owned());
    for figure in &scene.figures {
        row(true, format!("figure {}", figure.name));
    }
    format!("{}\n{}", scene.title, aligned(&rows))
}

fn spectrum(scene: &Scene) -> String {
    let psd = &scene.surface.psd;
    let density =
        scales_per_decade(psd).map_or(String::new(), |n| format!(", {} per decade", three_digits(n)));
    let cutoff = scene
        .sampling
        .cutoff_m
        .map_or(String::new(), |cutoff_m| format!(", cut off at {}", length(cutoff_m)));
    format!(
        "{}: {} wavelengths from {} to {}{density}{cutoff}",
        scene.surface.name,
        psd.len(),
        length(psd.longest_wavelength_m()),
        length(psd.shortest_wavelength_m())
    )
}

fn figures(scene: &Scene, shows: &[Shows]) -> String {
    let names: Vec<&str> = scene
        .figures
        .iter()
        .filter(|f| shows.contains(&f.shows))
        .map(|figure| figure.name.as_str())
        .collect();
    names.join(", ")
}
