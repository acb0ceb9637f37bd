//! The summary of a scene: the answer in words, then area, real pressure and the settling wavelength for every load.

use std::fmt::Write;

use stacked_contact::{Convergence, Level, StackedModel, largest_full_contact_pressure_pa};

use super::curve_counts::{beyond_fitted_range, statistical_notes};
use crate::curve_names::in_full;
use crate::question_words::sampled_scales;
use crate::yardstick_words::yardsticks;
use crate::{
    advice_words, answer_words, doubt_words, interface_words, scan_words, uncertainty_words, verdict_words,
};
use conclusions::{Conclusions, Evidence};
use findings::answer::LoadAnswer;
use findings::doubts::Doubt;
use findings::interface::InterfaceStates;
use questions::SampledScales;
use scene::Scene;
use study::material::Material;
use study::plan::{Curve, Results};
use uncertainty::Uncertainty;
use units::display::{length, pressure, three_digits};

/// All that is known about a scene, in words; it opens with the conclusions.
pub fn summary(evidence: &Evidence<'_>, conclusions: &Conclusions) -> String {
    let Evidence { scene, results, answer, judgement, uncertainty } = *evidence;
    // Names of curves are hyphenated and stay whole.
    let columns = textwrap::Options::new(100).word_splitter(textwrap::WordSplitter::NoHyphenation);
    let mut text = String::new();
    for first in verdict_words::opening(conclusions, evidence) {
        let _ = writeln!(text, "{}\n", textwrap::fill(&first, &columns));
    }
    let _ = write!(text, "{}\n{}\n", scene.title, sampling(results));
    for warning in scan_words::warnings(&scene.surface) {
        let _ = writeln!(text, "Warning: {warning}");
    }
    text.push('\n');
    let mut paragraphs =
        judgement.map_or_else(Vec::new, |judgement| verdict_words::sentences(judgement, scene));
    paragraphs.extend(answer_words::sentences(answer, scene, results));
    let shortcomings = answer_words::shortcomings(answer, scene, results);
    paragraphs.extend(shortcomings.iter().map(ToString::to_string));
    paragraphs.extend(answer_words::disagreements(answer, scene));
    for paragraph in paragraphs {
        let _ = writeln!(text, "{}\n", textwrap::fill(&paragraph, &columns));
    }
    if let Some(uncertainty) = uncertainty {
        let advice = advice_words::foremost_advice(evidence, conclusions).into_iter();
        let advice = advice.flat_map(|advice| advice_words::in_short(uncertainty, advice, scene));
        for line in uncertainty_words::sentences(uncertainty).into_iter().chain(advice) {
            let _ = writeln!(text, "{}", textwrap::fill(&line, &columns));
        }
        text.push('\n');
    }
    if let Some(states) = InterfaceStates::from_scene(scene, results) {
        for list in interface_words::quantity_lists(&states, scene, uncertainty) {
            let _ = writeln!(text, "{}", list.heading);
            let width = list.lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
            for (name, value) in &list.lines {
                let _ = writeln!(text, "  {name:<width$}  {value}");
            }
        }
        for note in interface_words::notes(&states, scene, uncertainty) {
            let _ = writeln!(text, "note: {note}");
        }
        text.push('\n');
    }
    let doubts = Doubt::of_scene(scene, answer);
    for doubt in &doubts {
        let _ = writeln!(text, "doubtful: {}", doubt_words::line(doubt));
    }
    if !doubts.is_empty() {
        text.push('\n');
    }
    let material = scene.material.as_ref().map(Material::properties).unwrap_or_default();
    if !material.is_empty() {
        let properties: Vec<String> =
            material.iter().map(|(name, value)| format!("{name} {value}")).collect();
        let _ = writeln!(text, "{}", textwrap::fill(&properties.join(", "), &columns));
    }
    for line in scene.bodies.describe(&scene.spreads) {
        let _ = writeln!(text, "{}", textwrap::fill(&line, &columns));
    }
    for choice in scene.model_choices() {
        let _ = writeln!(text, "{choice}");
    }
    for (curve, loads) in answer.curves.iter().enumerate() {
        text.push('\n');
        text.push_str(&curve_summary(scene, results, curve, loads, uncertainty));
    }
    text
}

/// The sampling of the spectrum, on which the stacked area depends.
pub fn sampling(results: &Results) -> String {
    sampled_scales(&SampledScales::of(&results.psd))
}

/// The position of intervals among the columns of a curve.
const AFTER_THE_AREA: usize = 2;

fn curve_summary(
    scene: &Scene,
    results: &Results,
    at: usize,
    loads: &[Option<LoadAnswer>],
    uncertainty: Option<&Uncertainty>,
) -> String {
    let (curve, result) = (&scene.needs.curves[at], &results.curves[at]);
    let hardness_pa = scene.hardness_pa();
    let mut rows = vec![
        [
            "nominal pressure",
            "area fraction",
            "real pressure",
            "settled within 1 % at",
            "settled within 0.1 % at",
        ]
        .map(str::to_owned)
        .to_vec(),
    ];
    if let Some(uncertainty) = uncertainty {
        rows[0].insert(AFTER_THE_AREA, uncertainty_words::level(uncertainty));
    }
    for ((index, load), answer) in scene.needs.loads.iter().enumerate().zip(loads) {
        let Some(answer) = answer else { continue };
        let real_pressure = match hardness_pa {
            Some(hardness_pa) => format!("{} H", three_digits(answer.real_pressure_pa / hardness_pa)),
            None => pressure(answer.real_pressure_pa),
        };
        let mut row = vec![
            load.label.clone(),
            three_digits(answer.area_fraction),
            real_pressure,
            settled(answer, answer.within_1_percent),
            settled(answer, answer.within_01_percent),
        ];
        if let Some(uncertainty) = uncertainty {
            let interval = uncertainty.interval(at, index).map(uncertainty_words::ends);
            row.insert(AFTER_THE_AREA, interval.unwrap_or_else(|| "-".to_owned()));
        }
        rows.push(row);
    }
    let mut text = format!("{}\n{}", heading(curve), aligned(&rows));
    text.extend(yardsticks(scene, results, curve).map(|sentence| format!("  {sentence}\n")));
    match curve.model.stacked().zip(result.stacked()) {
        Some((model, levels)) => text.push_str(&stacked_remarks(model, results, levels, hardness_pa)),
        None => text.extend(statistical_notes(result).into_iter().map(|note| format!("  {note}\n"))),
    }
    text
}

/// The name of the table of a curve, and its model.
fn heading(curve: &Curve) -> String {
    let full = in_full(curve);
    if full.starts_with(&curve.name) { full } else { format!("{}: {full}", curve.name) }
}

fn stacked_remarks(
    model: &StackedModel,
    results: &Results,
    levels: &[Vec<Level>],
    hardness_pa: Option<f64>,
) -> String {
    let mut text = beyond_fitted_range(levels).map_or(String::new(), |beyond| format!("  {beyond}\n"));
    if let Some(limit_pa) = largest_full_contact_pressure_pa(model, results.scales.iter().copied()) {
        let in_hardnesses = hardness_pa
            .map_or(String::new(), |hardness_pa| format!(" ({} H)", three_digits(limit_pa / hardness_pa)));
        let _ = writeln!(
            text,
            "  for dense sampling the real pressure tends to {}{in_hardnesses}, or to the nominal one where that is higher",
            pressure(limit_pa)
        );
    }
    text
}

fn settled(answer: &LoadAnswer, found: Convergence) -> String {
    match (answer.followed, answer.settled_at_m(found)) {
        (false, _) => "unknown".to_owned(),
        (true, Some(wavelength_m)) => length(wavelength_m),
        (true, None) => "not settled".to_owned(),
    }
}

/// Rows as indented columns of equal width.
pub fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|at| rows.iter().filter_map(|row| row.get(at)).map(|c| c.chars().count()).max().unwrap_or(0))
        .collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::from(" ");
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(line, " {cell:<width$} ");
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}
