//! The judgement in words: areas with their ranges, yielding, the verdict on every model, and what to measure.

use conclusions::{Conclusions, Evidence};
use judge::{CurveVerdict, Extent, Judgement, MapVerdict, Reason, Verdict};
use scene::Scene;
use units::display::{counted, length, pressure, three_digits};

use crate::conclusion_words;
use crate::curve_names::in_full;
use crate::listing::{at_loads, capital, range};
use crate::uncertainty_words;

/// The most loads in words; the table holds all.
const LOADS_SHOWN: usize = 3;

/// The first sentences on a scene: the area of each of the first loads, or else the curves with their intervals.
pub(crate) fn opening(conclusions: &Conclusions, evidence: &Evidence<'_>) -> Vec<String> {
    let Evidence { scene, answer, judgement, uncertainty, .. } = *evidence;
    // Such a spectrum has no area to report.
    if answer.too_few_scales.is_some() || answer.instruments_disagree.is_some() {
        return Vec::new();
    }
    if judgement.is_none() {
        return uncertainty.map_or_else(Vec::new, |found| uncertainty_words::of_curves(found, scene));
    }
    let mut sentences: Vec<String> =
        conclusions.loads.iter().take(LOADS_SHOWN).map(conclusion_words::area_sentence).collect();
    match conclusions.loads.len().saturating_sub(LOADS_SHOWN) {
        0 => {}
        more => sentences.push(format!("{} more in report-models.", capital(&counted(more, "load")))),
    }
    (!sentences.is_empty()).then(|| sentences.join(" ")).into_iter().collect()
}

/// The judgement: yielding, the verdict on every model, and the elements.
pub(crate) fn sentences(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let mut sentences = Vec::new();
    sentences.extend(yields(judgement, scene));
    sentences.extend(standing(judgement, scene));
    sentences.extend(extent(judgement, scene));
    sentences
}

/// The judgement without its verdicts: yielding, and the elements.
pub(crate) fn about_elements(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    yields(judgement, scene).into_iter().chain(extent(judgement, scene)).collect()
}

/// The notes below the verdicts: on maps, on steep slopes, and on the surfaces that were pressed.
fn extent(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let mut sentences = phases(judgement, scene);
    sentences.extend(steep(judgement));
    sentences.extend(judgement.extent.as_ref().map(pressed));
    sentences
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
    let ratios: Vec<f64> = verdicts.iter().filter_map(|of| of.ratio()).collect();
    let worst = match (ratios.is_empty(), verdicts[0].verdict.compares()) {
        (false, true) => {
            format!(" ({} times the area)", range(ratios.into_iter(), three_digits))
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
        format!(
            "The map {} at {} has {} ± {} times the contact area of Gaussian surfaces with its spectrum: {}.",
            of.map,
            scene.needs.loads[of.load].label,
            three_digits(of.ratio()),
            three_digits(of.ratio_error()),
            if of.differs() {
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

fn pressed(extent: &Extent) -> String {
    let left_out = match extent.left_out {
        0 => String::new(),
        some => format!(" ({} without roughness left out)", counted(some, "window")),
    };
    let windows = match extent.windows {
        1 => "the whole band".to_owned(),
        some => format!("{} half a decade apart", counted(some, "window")),
    };
    let (points, surfaces) = (extent.grid_of_last, extent.realisations_of_last);
    let last = match (points != extent.grid, surfaces != extent.realisations) {
        (false, false) => String::new(),
        (true, false) => format!(" ({points} x {points} on the last window)"),
        (false, true) => format!(" ({surfaces} on the last window)"),
        (true, true) => format!(" ({surfaces} of {points} x {points} on the last window)"),
    };
    format!(
        "Boundary elements pressed {windows}{left_out}: {}, {} each of {} x {} points{last}, seed {}; cost {} of a budget of {}.",
        counted(extent.solved, "pressure"),
        counted(extent.realisations, "surface"),
        extent.grid,
        extent.grid,
        extent.seed,
        three_digits(extent.spent),
        three_digits(extent.budget)
    )
}
