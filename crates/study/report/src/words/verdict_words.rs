//! The judgement in words: areas with their ranges, yielding, the verdict on every model, and what to measure.

use findings::answer::Answer;
use judge::{Basis, CurveVerdict, ERRORS_GIVEN, Extent, Headline, Judgement, MapVerdict, Reason, Verdict};
use scene::Scene;
use uncertainty::Uncertainty;
use units::display::{counted, length, pressure, three_digits};

use crate::assessment::Assessment;
use crate::curve_names::in_full;
use crate::listing::{at_loads, capital, listed, number_word, range, share, share_range};
use crate::uncertainty_words::{self, interval, level};

/// The most loads in words; the table holds all.
const LOADS_SHOWN: usize = 3;

/// The first sentences on a scene: the area that the judge supports, or else the curves with their intervals.
pub(crate) fn opening(scene: &Scene, answer: &Answer, assessment: Assessment<'_>) -> Vec<String> {
    // Such a spectrum has no area to report.
    if answer.too_few_scales.is_some() || answer.instruments_disagree.is_some() {
        return Vec::new();
    }
    if let Some(first) = first_line(assessment, scene) {
        return vec![first];
    }
    assessment.uncertainty.map_or_else(Vec::new, |found| uncertainty_words::of_curves(found, scene))
}

/// The area under each of the first loads, a sentence each, with its range and its coverage interval; `None` without a judge,
/// or if no curve has an area.
fn first_line(assessment: Assessment<'_>, scene: &Scene) -> Option<String> {
    let judgement = assessment.judgement?;
    let first: Vec<&Headline> = judgement.headlines.iter().take(LOADS_SHOWN).collect();
    let sentence =
        |headline: &&Headline| headline_sentence(headline, judgement, scene, assessment.uncertainty);
    let mut sentences: Vec<String> = first.iter().map(sentence).collect();
    if sentences.is_empty() {
        return None;
    }
    match judgement.headlines.len() - first.len() {
        0 => {}
        more => sentences.push(format!("{} more in report-models.", capital(&counted(more, "load")))),
    }
    Some(sentences.join(" "))
}

fn headline_sentence(
    headline: &Headline,
    judgement: &Judgement,
    scene: &Scene,
    uncertainty: Option<&Uncertainty>,
) -> String {
    let load = &scene.needs.loads[headline.load].label;
    let range = share_range(headline.low, headline.high);
    match headline.basis {
        Basis::Curve { curve, area_fraction, .. } => {
            let interval = uncertainty.and_then(|found| interval(found, curve, headline.load));
            let interval = interval.map_or_else(String::new, |interval| format!("; {interval}"));
            format!(
                "{} of the area touches at {load} (boundary elements allow {range}{interval}).",
                share(area_fraction)
            )
        }
        Basis::RangeOfModels { least, most, elements } => {
            let outer = uncertainty.and_then(|found| {
                let interval = |curve| found.interval(curve, headline.load);
                let (least, most) = (interval(least)?, interval(most)?);
                let range = share_range(least.low, most.high);
                Some(format!(", or {range} with their uncertain inputs ({} intervals)", level(found)))
            });
            let outer = outer.unwrap_or_default();
            let is_judged =
                |curve: &CurveVerdict| curve.load == headline.load && curve.verdict != Verdict::NotJudged;
            let found = match judgement.curves.iter().any(is_judged) {
                true => "is valid",
                false => "could be checked",
            };
            let models = match (scene.needs.curves.len(), found) {
                (1, "is valid") => format!("Your model is not valid here; it gives {range}{outer}."),
                (1, _) => format!("Your model could not be checked; it gives {range}{outer}."),
                (count, _) => {
                    format!(
                        "None of your {} models {found} here; they give {range}{outer}.",
                        number_word(count)
                    )
                }
            };
            match elements {
                Some(judged) => {
                    let given = ERRORS_GIVEN * judged.standard_error;
                    let range = share_range(judged.area_fraction - given, judged.area_fraction + given);
                    format!("{range} of the area touches at {load} (boundary elements). {models}")
                }
                None => format!("At {load}: {}{}", models[..1].to_lowercase(), &models[1..]),
            }
        }
    }
}

/// The judgement: the source of each area, yielding, the verdict on every model, and what to measure.
pub(crate) fn sentences(judgement: &Judgement, scene: &Scene, answer: &Answer) -> Vec<String> {
    let mut sentences = Vec::new();
    sentences.extend(rests(judgement, scene));
    sentences.extend(yields(judgement, scene));
    sentences.extend(standing(judgement, scene));
    sentences.extend(phases(judgement, scene));
    sentences.extend(steep(judgement));
    sentences.extend(settling(judgement, scene, answer));
    sentences.extend(judgement.extent.as_ref().map(pressed));
    sentences
}

/// The curve of each area.
fn rests(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let mut groups: Vec<(usize, Vec<&Headline>)> = Vec::new();
    for headline in &judgement.headlines {
        let Basis::Curve { curve, .. } = headline.basis else { continue };
        match groups.iter_mut().find(|(other, _)| *other == curve) {
            Some((_, headlines)) => headlines.push(headline),
            None => groups.push((curve, vec![headline])),
        }
    }
    let sentence = |(curve, headlines): (usize, Vec<&Headline>)| {
        let loads: Vec<usize> = headlines.iter().map(|headline| headline.load).collect();
        let of_windows = headlines.iter().filter_map(|headline| match headline.basis {
            Basis::Curve { agreeing, windows, whole_band, .. } => Some((agreeing, windows, whole_band)),
            Basis::RangeOfModels { .. } => None,
        });
        let shares: Vec<String> =
            of_windows.clone().map(|(agreeing, windows, _)| format!("{agreeing} of {windows}")).collect();
        let mut distinct = shares.clone();
        distinct.dedup();
        let (checked, range) = if of_windows.clone().all(|(.., whole_band)| whole_band) {
            ("on the whole band of the spectrum".to_owned(), "")
        } else {
            let shares = listed(&distinct.iter().map(String::as_str).collect::<Vec<_>>());
            (
                format!("on {shares} windows of the spectrum"),
                " on the last window, with Persson's theory for the longer waves",
            )
        };
        format!(
            "{} the area is that of {}: its assumptions hold, and it agrees with boundary elements {checked}. Their range is that \
             of two standard errors{range}.",
            capital(&at_loads(scene, &loads)),
            in_full(&scene.needs.curves[curve])
        )
    };
    groups.into_iter().map(sentence).collect()
}

/// The yielding of the contact: the pressure of an elastic contact against the hardness.
fn yields(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let mut groups: Vec<(Option<String>, Vec<usize>)> = Vec::new();
    for yielding in judgement.yielding.iter().filter(|yielding| yielding.has_hardness) {
        let growing = match (yielding.hardness_grows, yielding.above_growing) {
            (false, _) => "",
            (true, None) => "; a hardness that grows at small scales as the material's does is not exceeded",
            (true, Some(_)) => {
                "; a hardness that grows as the material's does is exceeded as well, at some scale"
            }
        };
        let above = yielding.above_constant.map(|above| {
            format!(
                "roughness finer than {} would need more than the hardness, {}, to stay elastic{growing}",
                length(above.wavelength_m),
                pressure(above.hardness_pa)
            )
        });
        match groups.iter_mut().find(|(other, _)| *other == above) {
            Some((_, loads)) => loads.push(yielding.load),
            None => groups.push((above, vec![yielding.load])),
        }
    }
    let sentence = |(above, loads): (Option<String>, Vec<usize>)| match above {
        Some(above) => format!("The contact yields {}: {above}.", at_loads(scene, &loads)),
        None => format!(
            "Nothing yields: {} the mean pressure of an elastic contact stays below the hardness at every scale.",
            at_loads(scene, &loads)
        ),
    };
    groups.into_iter().map(sentence).collect()
}

/// The verdict on every curve, with the curves of one verdict together.
fn standing(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let verdicts = [
        (Verdict::Agrees, "Agrees with boundary elements"),
        (Verdict::TooLarge, "Too large"),
        (Verdict::TooSmall, "Too small"),
        (Verdict::OutOfRange, "Out of range"),
        (Verdict::NotJudged, "Not judged"),
    ];
    let of_verdict = |(verdict, words): (Verdict, &str)| {
        let curves: Vec<String> = (0..scene.needs.curves.len())
            .filter_map(|curve| {
                let verdicts: Vec<&CurveVerdict> =
                    judgement.curves.iter().filter(|of| of.curve == curve && of.verdict == verdict).collect();
                (!verdicts.is_empty()).then(|| of_curve(scene, curve, &verdicts))
            })
            .collect();
        (!curves.is_empty()).then(|| format!("{words}: {}.", curves.join("; ")))
    };
    verdicts.into_iter().filter_map(of_verdict).collect()
}

fn of_curve(scene: &Scene, curve: usize, verdicts: &[&CurveVerdict]) -> String {
    let name = in_full(&scene.needs.curves[curve]);
    let loads: Vec<usize> = verdicts.iter().map(|of| of.load).collect();
    let ratios: Vec<f64> = verdicts.iter().filter_map(|of| of.ratio).collect();
    let worst = match (ratios.is_empty(), verdicts[0].verdict.compares()) {
        (false, true) => {
            format!(" ({} times the area on the worst window)", range(ratios.into_iter(), three_digits))
        }
        _ => format!(" ({})", range_of_reasons(verdicts)),
    };
    if loads.len() == scene.needs.loads.len() {
        format!("{name}{worst}")
    } else {
        format!("{name} {}{worst}", at_loads(scene, &loads))
    }
}

/// The reason that all loads share, with the range of wavelengths at which it begins.
fn range_of_reasons(verdicts: &[&CurveVerdict]) -> String {
    let begins: Vec<f64> = verdicts.iter().filter_map(|of| Some(of.broken?.wavelength_m())).collect();
    match verdicts[0].reason {
        Reason::Broken(judge::BrokenAssumption::Yields(_)) => format!(
            "it assumes that nothing yields, but its pressure exceeds the hardness from {} on",
            range(begins.into_iter(), length)
        ),
        Reason::Broken(judge::BrokenAssumption::Unfitted { .. }) => format!(
            "too much of the load rests outside the fitted range of its law, from {} on",
            range(begins.into_iter(), length)
        ),
        reason => reason.to_string(),
    }
}

/// The effect on measured maps of what their spectrum leaves out.
fn phases(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let of_map = |of: &MapVerdict| {
        let error = 2.0 * of.twins.relative_error() * of.ratio();
        format!(
            "The map {} at {} has {} ± {} times the contact area of Gaussian surfaces with its spectrum: {}.",
            of.map,
            scene.needs.loads[of.load].label,
            three_digits(of.ratio()),
            three_digits(error),
            if (of.ratio() - 1.0).abs() > error.max(0.05) {
                "its heights are not Gaussian, which no spectrum shows"
            } else {
                "the spectrum is enough"
            }
        )
    };
    judgement.maps.iter().map(of_map).collect()
}

/// The wavelength at which slopes become too steep for every method.
fn steep(judgement: &Judgement) -> Option<String> {
    let from_m = judgement.steep_from_m?;
    Some(format!(
        "Below {} slopes are too steep for every method used here, boundary elements included: the rms pressure of full contact \
         exceeds E*/10 (rms gradient {} over the whole band).",
        length(from_m),
        three_digits(judgement.rms_gradient)
    ))
}

/// Measurements that would settle open questions.
fn settling(judgement: &Judgement, scene: &Scene, answer: &Answer) -> Vec<String> {
    let mut sentences = Vec::new();
    let open: Vec<usize> = judgement
        .headlines
        .iter()
        .filter_map(|headline| match headline.basis {
            Basis::Curve { curve, .. } => {
                let settled = answer.curves[curve][headline.load].as_ref()?.settled;
                (!settled).then_some(headline.load)
            }
            Basis::RangeOfModels { .. } => None,
        })
        .collect();
    if !open.is_empty() {
        sentences.push(format!(
            "To settle the area {}, measure shorter wavelengths: finer roughness can only lower it.",
            at_loads(scene, &open)
        ));
    }
    let torn: Vec<usize> = judgement
        .yielding
        .iter()
        .filter(|yielding| yielding.hardness_grows)
        .filter(|yielding| yielding.above_constant.is_some() && yielding.above_growing.is_none())
        .map(|yielding| yielding.load)
        .collect();
    if !torn.is_empty() {
        sentences.push(
            "To settle whether the contact yields, measure the hardness at the depth of the small scales by indentation."
                .to_owned(),
        );
    }
    sentences
}

fn pressed(extent: &Extent) -> String {
    let left_out = match extent.left_out {
        0 => String::new(),
        some => format!(" ({} without roughness left out)", counted(some, "window")),
    };
    let windows = match extent.windows {
        1 => "the whole band".to_owned(),
        some => format!("{} half a decade apart", counted(some, "window")),
    };
    format!(
        "Boundary elements pressed {windows}{left_out}: {}, {} each of {} x {} points, seed {}; cost {} of a budget of {}.",
        counted(extent.solved, "pressure"),
        counted(extent.realisations, "surface"),
        extent.grid,
        extent.grid,
        extent.seed,
        three_digits(extent.spent),
        three_digits(extent.budget)
    )
}
