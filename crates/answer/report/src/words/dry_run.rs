//! The steps that a run of a scene would take: what it needs, shares and skips.

use crate::listing::{aligned, listed};
use crate::uncertainty_words::describe_group;
use findings::sensitivity::wanted_areas;
use scene::Scene;
use study::choices_in_words;
use study::figure::Shows;
use study::models::Framework;
use study::plan::{Curve, Cutoffs, Needs, scales_per_decade};
use uncertainty::{UncertaintySettings, scattering_groups};
use units::display::{length, three_digits};

/// Returns the steps that a run of the scene would take, as a table.
#[must_use]
pub fn dry_run(scene: &Scene) -> String {
    let mut rows = vec![vec!["spectrum".to_owned(), spectrum(scene)]];
    let mut row = |state: &str, what: String| rows.push(vec![state.to_owned(), what]);
    let (needs, plan) = (&scene.needs, scene.plan());
    let if_needed = |needed: bool| if needed { "needed" } else { "skipped" };
    row(
        if_needed(scene.sampling.scales_per_decade.is_some()),
        match scene.sampling.scales_per_decade {
            Some(n) => format!("resampling to {n} scales per decade"),
            None => "resampling: options.scales_per_decade is not set".to_owned(),
        },
    );
    row(
        if_needed(needs.moments.is_some()),
        match needs.moments {
            Some(norm) => format!(
                "moments for every cutoff, {norm}: {} ({})",
                choices_in_words::normalisation(norm),
                users_of_moments(scene)
            ),
            None => "moments and asperity parameters: no curve and no figure uses them".to_owned(),
        },
    );
    row(
        if_needed(needs.amplitudes.is_some()),
        match needs.amplitudes {
            Some(definition) if !needs.curves.iter().any(|curve| curve.model.needs_amplitudes()) => {
                format!(
                    "amplitudes, {definition}: {} ({})",
                    choices_in_words::amplitude(definition),
                    figures(scene, &[Shows::Amplitude, Shows::AspectRatio])
                )
            }
            Some(definition) => {
                format!(
                    "amplitudes, {definition}: {} (the stacked curves)",
                    choices_in_words::amplitude(definition)
                )
            }
            None => "amplitudes: no curve and no figure uses them".to_owned(),
        },
    );
    for &framework in Framework::ALL {
        let is_its = |curve: &Curve| curve.model.entry.framework == framework;
        if !needs.curves.iter().any(is_its) {
            row("skipped", format!("{framework} model: no curve asks for it"));
        }
        for (at, curve) in needs.curves.iter().enumerate().filter(|(_, curve)| is_its(curve)) {
            let what = format!(
                "{framework} curve {} at {} loads{}",
                curve.name,
                needs.loads.len(),
                at_cutoffs(curve)
            );
            match needs.curves[..at].iter().find(|other| other.model == curve.model) {
                Some(other) => row("shared", format!("{what}: the model of {}", other.name)),
                None => row("needed", what),
            }
        }
    }
    for (load, other) in repeated_loads(needs) {
        row("shared", format!("load {load}: the pressure of {other}"));
    }
    if !needs.sweeps.is_empty() {
        let states: usize = needs.sweeps.iter().map(|sweep| sweep.pressures_pa.len()).sum();
        row(
            "needed",
            format!("{states} statistical states over loads ({})", figures(scene, &[Shows::AreaAgainstLoad])),
        );
    }
    let (levels, states) = (plan.stacked_levels(), plan.statistical_states());
    if levels > 0 {
        row("at most", format!("{levels} levels of stacks, each once"));
    }
    if states > 0 {
        row("at most", format!("{states} statistical states, each once"));
    }
    let areas = wanted_areas(scene);
    if areas > 0 {
        row(
            "needed",
            format!(
                "{areas} final areas with other modelling choices, for the report (not with --no-report)"
            ),
        );
    }
    if let Some((state, what)) = draws(scene) {
        row(state, what);
    }
    row("skipped", "self-affine fit: only `truearea fit` computes it".to_owned());
    for figure in &scene.figures {
        row("needed", format!("figure {}", figure.name));
    }
    format!("{}\n{}", scene.title, aligned(&rows))
}

/// The draws for the uncertainty of the areas, if any input of the scene is uncertain.
fn draws(scene: &Scene) -> Option<(&'static str, String)> {
    if scene.needs.curves.is_empty() {
        return None;
    }
    let groups = scattering_groups(scene);
    let of_scans = scene.surface.each().iter().any(|part| part.made_from.is_some());
    let of: Vec<&str> = groups.iter().map(|group| describe_group(*group, of_scans)).collect();
    let of = listed(&of);
    let choices = scene.uncertainty;
    if choices.is_some_and(|choices| choices.off) {
        return (!groups.is_empty()).then(|| ("skipped", format!("draws of {of}: uncertainty is off")));
    }
    let UncertaintySettings { draws, level, .. } = choices.unwrap_or_default();
    let without = if choices.is_some() { "" } else { " (not with --no-report)" };
    (!groups.is_empty()).then(|| {
        (
            "needed",
            format!("{draws} draws of {of}, for intervals of {} %{without}", three_digits(100.0 * level)),
        )
    })
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

/// The users of moments: figures, curves of Persson's theory, and asperities.
fn users_of_moments(scene: &Scene) -> String {
    let drawn = figures(scene, &[Shows::Moments]);
    let persson = scene.needs.curves.iter().any(|curve| curve.model.persson().is_some());
    let persson = persson.then(|| "the curves of Persson's theory".to_owned());
    let asperities = scene.plan().asperity_cutoffs_wanted().map(|cutoffs| match cutoffs {
        Cutoffs::Every => "asperities at each".to_owned(),
        Cutoffs::Shortest => "asperities at the shortest alone".to_owned(),
    });
    let users = [(!drawn.is_empty()).then_some(drawn), persson, asperities];
    users.into_iter().flatten().collect::<Vec<_>>().join("; ")
}

fn at_cutoffs(curve: &Curve) -> &'static str {
    match curve.cutoffs {
        Cutoffs::Every => "",
        Cutoffs::Shortest => ", the shortest cutoff alone",
    }
}

/// Loads with the pressure of an earlier load, and that load, both as typed.
fn repeated_loads(needs: &Needs) -> Vec<(&str, &str)> {
    let mut repeated = Vec::new();
    for (at, load) in needs.loads.iter().enumerate() {
        let before = &needs.loads[..at];
        let first = before.iter().find(|other| other.nominal_pressure_pa() == load.nominal_pressure_pa());
        repeated.extend(first.map(|first| (load.label.as_str(), first.label.as_str())));
    }
    repeated
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
