//! The table and the notes behind a summary.

use conclusions::{AnswerUnderLoad, Conclusions, Evidence};
use findings::answer::LoadAnswer;
use findings::doubts;
use scene::Scene;
use study::material::Material;
use units::display::{length, pressure, three_digits};

use crate::listing::{aligned, capital};
use crate::scan_words::sampling;
use crate::words::curve_counts::{beyond_fitted_range, statistical_notes};
use crate::{conclusion_words, interface_words, uncertainty_words, verdict_words};

/// Returns the area of each model under each load as a table, then all cautions and notes.
#[must_use]
pub fn details(evidence: &Evidence<'_>, conclusions: &Conclusions) -> String {
    let Evidence { scene, results, answer, judgement, uncertainty } = *evidence;
    let mut notes: Vec<String> = conclusions.cautions.iter().map(conclusion_words::caution_words).collect();
    let doubts = [doubts::of_scene(scene, answer), doubts::of_surface(&scene.surface.psd)].concat();
    let doubts = doubts.iter().map(conclusion_words::caution_words);
    notes.extend(doubts.filter(|doubt| !notes.contains(doubt)).collect::<Vec<_>>());
    for (curve, result) in scene.needs.curves.iter().zip(&results.curves) {
        let beyond = result.stacked().and_then(beyond_fitted_range);
        let of_rows = statistical_notes(result).into_iter().chain(beyond);
        notes.extend(of_rows.map(|note| format!("{}: {note}.", curve.name)));
    }
    notes.extend(judgement.into_iter().flat_map(|judgement| verdict_words::about_elements(judgement, scene)));
    let of_draws = uncertainty.into_iter().flat_map(uncertainty_words::sentences);
    notes.extend(of_draws.map(|(text, ..)| text));
    if let Some(states) = scene.interface_states(results) {
        let of_interface = interface_words::notes(&states, scene, uncertainty);
        notes.extend(of_interface.iter().map(|note| format!("{}.", capital(note))));
    }
    notes.push(format!("{}.", sampling(results)));
    let properties = scene.material.as_ref().map(Material::properties).unwrap_or_default();
    let properties: Vec<String> = properties.iter().map(|(name, value)| format!("{name} {value}")).collect();
    let inputs =
        std::iter::once(properties.join(", ")).chain(scene.bodies.describe(scene.softer(), &scene.spreads));
    let inputs = inputs.chain(scene.model_choices()).filter(|line| !line.is_empty());
    notes.extend(inputs.map(|line| format!("{}.", capital(&line))));
    // Names of curves are hyphenated and stay whole.
    let columns = textwrap::Options::new(100)
        .subsequent_indent("  ")
        .word_splitter(textwrap::WordSplitter::NoHyphenation);
    let mut text = areas(evidence, conclusions);
    for note in notes {
        text += &format!("{}\n", textwrap::fill(&note, &columns));
    }
    text
}

/// A row for each curve and load with an area; empty without any.
fn areas(evidence: &Evidence<'_>, conclusions: &Conclusions) -> String {
    let Evidence { scene, answer, uncertainty, .. } = *evidence;
    let mut rows = Vec::new();
    for (at, (curve, answers)) in scene.needs.curves.iter().zip(&answer.curves).enumerate() {
        for load in &conclusions.loads {
            let Some(answer) = &answers[load.load] else { continue };
            let mut row = vec![curve.name.clone(), load.label.clone(), three_digits(answer.area_fraction)];
            row.extend(uncertainty.map(|found| {
                found.interval(at, load.load).map_or_else(|| "-".to_owned(), uncertainty_words::ends)
            }));
            row.extend([real_pressure(scene, answer), settled(answer), verdict(load, at)]);
            rows.push(row);
        }
    }
    if rows.is_empty() {
        return String::new();
    }
    let mut head = ["model", "pressure", "area fraction"].map(str::to_owned).to_vec();
    head.extend(uncertainty.map(uncertainty_words::level));
    head.extend(["real pressure", "settled within 1 % at", "boundary elements"].map(str::to_owned));
    rows.insert(0, head);
    format!("{}\n", aligned(&rows))
}

fn real_pressure(scene: &Scene, answer: &LoadAnswer) -> String {
    match scene.hardness_pa() {
        Some(hardness_pa) => format!("{} H", three_digits(answer.real_pressure_pa / hardness_pa)),
        None => pressure(answer.real_pressure_pa),
    }
}

fn settled(answer: &LoadAnswer) -> String {
    match (answer.followed, answer.settled_at_m(answer.within_1_percent)) {
        (false, _) => "unknown".to_owned(),
        (true, Some(wavelength_m)) => length(wavelength_m),
        (true, None) => "not settled".to_owned(),
    }
}

/// The verdict on a curve, with its area over that of the elements.
fn verdict(load: &AnswerUnderLoad, curve: usize) -> String {
    let mut cells = load.references.iter().flat_map(|group| &group.models);
    cells.find(|cell| cell.curve == curve).map_or_else(String::new, |cell| {
        let ratio = cell.ratio.map_or_else(String::new, |ratio| format!(" (×{})", three_digits(ratio)));
        format!("{}{ratio}", cell.verdict.name().replace('-', " "))
    })
}
