//! The reasons behind every number of a scene: its law, the scale that sets it, and the notes on it.

use std::fmt::Write;

use super::curve_counts::notes_of_block;
use crate::curve_names::in_full;
use findings::answer::{Answer, LoadAnswer};
use scene::Scene;
use study::plan::{CurveResult, Results};
use units::display::{length, percent, pressure, three_digits};

/// The reasons, curve by curve and load by load.
#[must_use]
pub fn reasons(scene: &Scene, results: &Results, answer: &Answer) -> String {
    let mut text = String::new();
    let of_curves = scene.needs.curves.iter().zip(&results.curves).zip(&answer.curves);
    for ((curve, result), answers) in of_curves {
        let full = in_full(curve);
        let name = if full.starts_with(&curve.name) { full } else { format!("{}: {full}", curve.name) };
        let _ = writeln!(text, "{name}");
        for (block, (load, answer)) in scene.needs.loads.iter().zip(answers).enumerate() {
            let reasons = match answer {
                None => vec!["no number: the cutoffs leave no asperities".to_owned()],
                Some(answer) => of_load(scene, results, result, block, answer),
            };
            let mut first = format!("  {}: ", load.label);
            for reason in reasons {
                let columns = textwrap::Options::new(100)
                    .initial_indent(&first)
                    .subsequent_indent("      ")
                    .word_splitter(textwrap::WordSplitter::NoHyphenation);
                let _ = writeln!(text, "{}", textwrap::fill(&reason, &columns));
                first = "    ".to_owned();
            }
        }
    }
    text
}

/// The reasons of a curve under one load: the area, what sets it, and the notes on it.
fn of_load(
    scene: &Scene,
    results: &Results,
    result: &CurveResult,
    block: usize,
    answer: &LoadAnswer,
) -> Vec<String> {
    let in_hardnesses = |pressure_pa: f64| {
        let hardnesses = scene.hardness_pa().map(|hardness_pa| three_digits(pressure_pa / hardness_pa));
        hardnesses.map_or(String::new(), |hardnesses| format!(" ({hardnesses} H)"))
    };
    let mut reasons = vec![format!(
        "area fraction {}, hence a real pressure of {}{}",
        three_digits(answer.area_fraction),
        pressure(answer.real_pressure_pa),
        in_hardnesses(answer.real_pressure_pa)
    )];
    reasons.extend(what_sets_it(result, block, answer, in_hardnesses));
    if let Some(decade) = answer.decisive_decade() {
        reasons.push(format!(
            "the wavelengths from {} to {} decide most, more than any other decade: {} of the logarithm of the area",
            length(decade.longest_m),
            length(decade.shortest_m),
            percent(decade.share)
        ));
    }
    if answer.followed && !answer.settled {
        reasons.push(format!(
            "note: not settled; this is the area at {}, where the spectrum ends",
            length(results.psd.shortest_wavelength_m())
        ));
    }
    if let Some(share) = answer.out_of_range_load_share.filter(|share| *share > 0.0) {
        reasons.push(format!(
            "note: {} of the load rests on asperities outside the fitted range of their law",
            percent(share)
        ));
    }
    reasons.extend(notes_of_block(result, block).into_iter().map(|note| format!("note: {note}")));
    reasons
}

/// The scale or the asperities that the real pressure comes from.
fn what_sets_it(
    result: &CurveResult,
    block: usize,
    answer: &LoadAnswer,
    in_hardnesses: impl Fn(f64) -> String,
) -> Option<String> {
    if answer.area_fraction == 1.0 {
        return Some("everything touches: the load alone sets the pressure".to_owned());
    }
    if let Some(scale) = answer.setting {
        return Some(format!(
            "the scale of {} sets it (aspect ratio {}): it takes {}{} to flatten, more than any other",
            length(scale.wavelength_m),
            three_digits(scale.aspect_ratio),
            pressure(scale.full_contact_pressure_pa),
            in_hardnesses(scale.full_contact_pressure_pa)
        ));
    }
    if let Some(blocks) = result.persson() {
        let cut = blocks[block].last()?;
        return Some(format!(
            "the rms gradient {} of all scales down to {} sets it; {} of the contact flows",
            three_digits(cut.rms_gradient),
            length(cut.wavelength_m),
            percent(cut.areas.plastic / cut.areas.contact())
        ));
    }
    let last = result.statistical()?[block].last()?;
    let (asperities, _) = last.contact?;
    Some(format!(
        "the asperities that the cutoff {} leaves set it: radius {}, rms height {}, {} per mm²",
        length(last.wavelength_m),
        length(asperities.radius_m),
        length(asperities.sigma_s_m),
        three_digits(asperities.density_per_m2 * 1e-6)
    ))
}
