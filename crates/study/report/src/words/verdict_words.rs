//! What the judge found, in plain words: a number with its bracket, what yields, which models stand, what would settle it.

use findings::answer::Answer;
use judge::{ERRORS_GIVEN, Extent, Headline, Judgement, OfCurve, OfMap, Reason, RestsOn, Verdict};
use scene::Scene;
use uncertainty::Uncertainty;
use units::display::{counted, length, pressure, three_digits};

use crate::curve_names::in_full;
use crate::listing::{at_loads, capital, listed, range};
use crate::trust::Trust;
use crate::uncertainty_words::{self, interval, level};

/// More loads than this are left to the table.
const LOADS_TOLD: usize = 3;

/// The number that a judge stands for; where none was asked, or no curve is left to him, the curves with their intervals.
pub(crate) fn opening(scene: &Scene, answer: &Answer, trust: Trust<'_>) -> Vec<String> {
    // A spectrum that tells nothing has no number.
    if answer.too_few_scales.is_some() || answer.instruments_disagree.is_some() {
        return Vec::new();
    }
    if let Some(first) = first_line(trust, scene) {
        return vec![first];
    }
    trust.uncertainty.map_or_else(Vec::new, |found| uncertainty_words::of_curves(found, scene))
}

/// The number of each of the first loads, with its bracket and its coverage interval; none where no curve has an area, or
/// nobody judged them.
fn first_line(trust: Trust<'_>, scene: &Scene) -> Option<String> {
    let judgement = trust.judgement?;
    let told: Vec<&Headline> = judgement.headlines.iter().take(LOADS_TOLD).collect();
    let numbers: Vec<String> =
        told.iter().map(|headline| number(headline, scene, trust.uncertainty)).collect();
    if numbers.is_empty() {
        return None;
    }
    let rest = match judgement.headlines.len() - told.len() {
        0 => String::new(),
        more => format!("; {} more in report-models", counted(more, "load")),
    };
    Some(format!("How much touches: {}{rest}.", numbers.join("; ")))
}

fn number(headline: &Headline, scene: &Scene, uncertainty: Option<&Uncertainty>) -> String {
    let load = &scene.needs.loads[headline.load].label;
    let (low, high) = (three_digits(headline.low), three_digits(headline.high));
    match headline.rests_on {
        RestsOn::Curve { curve, area_fraction, .. } => {
            let interval = uncertainty.and_then(|found| interval(found, curve, headline.load));
            let interval = interval.map_or_else(String::new, |interval| format!("; {interval}"));
            format!(
                "{} of the nominal area at {load} (between {low} and {high}{interval})",
                three_digits(area_fraction)
            )
        }
        RestsOn::RangeOfModels { least, most, elements } => {
            let models = if low == high { low } else { format!("between {low} and {high}") };
            let elements = elements.map_or_else(String::new, |judged| {
                let [low, high] = [-1.0, 1.0].map(|sign| {
                    three_digits(judged.area_fraction + sign * ERRORS_GIVEN * judged.standard_error)
                });
                format!("; boundary elements put it between {low} and {high}")
            });
            let outer = uncertainty.and_then(|found| {
                let of = |curve| found.interval(curve, headline.load);
                let (least, most) = (of(least)?, of(most)?);
                Some(format!(
                    "; with what is uncertain {} to {} ({} of the outermost models)",
                    three_digits(least.low),
                    three_digits(most.high),
                    level(found)
                ))
            });
            format!(
                "{models} of the nominal area at {load}, what models give of which none stands{}{elements}",
                outer.unwrap_or_default()
            )
        }
    }
}

/// The verdict: what the numbers rest on, what yields, which models stand and how far off they are, what would settle it.
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

/// Which curve each number is of.
fn rests(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let mut told: Vec<(usize, Vec<&Headline>)> = Vec::new();
    for headline in &judgement.headlines {
        let RestsOn::Curve { curve, .. } = headline.rests_on else { continue };
        match told.iter_mut().find(|(other, _)| *other == curve) {
            Some((_, headlines)) => headlines.push(headline),
            None => told.push((curve, vec![headline])),
        }
    }
    let sentence = |(curve, headlines): (usize, Vec<&Headline>)| {
        let loads: Vec<usize> = headlines.iter().map(|headline| headline.load).collect();
        let of_windows = headlines.iter().filter_map(|headline| match headline.rests_on {
            RestsOn::Curve { agreeing, windows, whole_band, .. } => Some((agreeing, windows, whole_band)),
            RestsOn::RangeOfModels { .. } => None,
        });
        let shares: Vec<String> =
            of_windows.clone().map(|(agreeing, windows, _)| format!("{agreeing} of {windows}")).collect();
        let mut distinct = shares.clone();
        distinct.dedup();
        let (held, bracket) = if of_windows.clone().all(|(.., whole_band)| whole_band) {
            ("on the whole band of the spectrum".to_owned(), "theirs")
        } else {
            let shares = listed(&distinct.iter().map(String::as_str).collect::<Vec<_>>());
            (
                format!("on {shares} windows of the spectrum"),
                "theirs on the last window, pressed by what the longer waves leave",
            )
        };
        format!(
            "{} the number is that of {}, whose assumptions hold and which agrees with boundary elements {held}; the bracket is \
             {bracket}.",
            capital(&at_loads(scene, &loads)),
            in_full(&scene.needs.curves[curve])
        )
    };
    told.into_iter().map(sentence).collect()
}

/// An elastic contact's pressure against the hardness.
fn yields(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let mut told: Vec<(String, Vec<usize>)> = Vec::new();
    for yielding in judgement.yielding.iter().filter(|yielding| yielding.has_hardness) {
        let constant = yielding.above_constant.map(|above| {
            format!(
                "exceeds the hardness of {} from {} on",
                pressure(above.hardness_pa),
                length(above.wavelength_m)
            )
        });
        let growing = match (yielding.hardness_grows, yielding.above_growing) {
            (false, _) => "",
            (true, None) => ", but not a hardness that grows at small scales as the material's does",
            (true, Some(_)) => {
                ", and at some scale that of a hardness which grows at small scales as the material's does"
            }
        };
        let text = match constant {
            None => "stays below the hardness at every scale: nothing yields on the whole".to_owned(),
            Some(constant) => format!("{constant}{growing}"),
        };
        match told.iter_mut().find(|(other, _)| *other == text) {
            Some((_, loads)) => loads.push(yielding.load),
            None => told.push((text, vec![yielding.load])),
        }
    }
    let sentence = |(text, loads): (String, Vec<usize>)| {
        format!("What yields {}: the mean pressure of an elastic contact {text}.", at_loads(scene, &loads))
    };
    told.into_iter().map(sentence).collect()
}

/// What is said of every curve: those of one verdict together.
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
                let told: Vec<&OfCurve> =
                    judgement.curves.iter().filter(|of| of.curve == curve && of.verdict == verdict).collect();
                (!told.is_empty()).then(|| of_curve(scene, curve, &told))
            })
            .collect();
        (!curves.is_empty()).then(|| format!("{words}: {}.", curves.join("; ")))
    };
    verdicts.into_iter().filter_map(of_verdict).collect()
}

fn of_curve(scene: &Scene, curve: usize, told: &[&OfCurve]) -> String {
    let name = in_full(&scene.needs.curves[curve]);
    let loads: Vec<usize> = told.iter().map(|of| of.load).collect();
    let ratios: Vec<f64> = told.iter().filter_map(|of| of.ratio).collect();
    let worst = match (ratios.is_empty(), told[0].verdict.compares()) {
        (false, true) => {
            format!(" ({} times the area on the worst window)", range(ratios.into_iter(), three_digits))
        }
        _ => format!(" ({})", range_of_reasons(told)),
    };
    if loads.len() == scene.needs.loads.len() {
        format!("{name}{worst}")
    } else {
        format!("{name} {}{worst}", at_loads(scene, &loads))
    }
}

/// The reason that curves share, with the wavelengths at which it begins under the loads.
fn range_of_reasons(told: &[&OfCurve]) -> String {
    let begins: Vec<f64> = told.iter().filter_map(|of| Some(of.broken?.wavelength_m())).collect();
    match told[0].reason {
        Reason::Broken(judge::Broken::Yields(_)) => format!(
            "it takes no yielding into account, and its pressure exceeds the hardness from {} on",
            range(begins.into_iter(), length)
        ),
        Reason::Broken(judge::Broken::Unfitted { .. }) => format!(
            "too much of the load stands outside the range that its law was fitted in, from {} on",
            range(begins.into_iter(), length)
        ),
        reason => reason.to_string(),
    }
}

/// What the spectrum leaves out of the measured maps.
fn phases(judgement: &Judgement, scene: &Scene) -> Vec<String> {
    let of_map = |of: &OfMap| {
        let error = 2.0 * of.twins.relative_error() * of.ratio();
        format!(
            "The map {} under {} has {} (give or take {}) times the area of Gaussian surfaces of its own waves: {}.",
            of.map,
            scene.needs.loads[of.load].label,
            three_digits(of.ratio()),
            three_digits(error),
            if (of.ratio() - 1.0).abs() > error.max(0.05) {
                "its heights are not Gaussian, and the spectrum leaves that out"
            } else {
                "the spectrum tells all that matters"
            }
        )
    };
    judgement.maps.iter().map(of_map).collect()
}

/// Where slopes are too large for all of them.
fn steep(judgement: &Judgement) -> Option<String> {
    let from_m = judgement.steep_from_m?;
    Some(format!(
        "Small slopes, which every model here and the elements take for granted, end at {}: from there on the rms pressure of full \
         contact exceeds E*/10 (rms gradient {} in all). Verdicts compare models of a half-space with one another.",
        length(from_m),
        three_digits(judgement.rms_gradient)
    ))
}

/// What would settle it.
fn settling(judgement: &Judgement, scene: &Scene, answer: &Answer) -> Vec<String> {
    let mut sentences = Vec::new();
    let open: Vec<usize> = judgement
        .headlines
        .iter()
        .filter_map(|headline| match headline.rests_on {
            RestsOn::Curve { curve, .. } => {
                let settled = answer.curves[curve][headline.load].as_ref()?.settled;
                (!settled).then_some(headline.load)
            }
            RestsOn::RangeOfModels { .. } => None,
        })
        .collect();
    if !open.is_empty() {
        sentences.push(format!(
            "What would settle it {}: a spectrum to shorter wavelengths. Finer roughness can only lower the area.",
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
            "What would settle whether it yields: the hardness at the depth of the small scales, by indentation; it decides \
             between elastic and plastic contact."
                .to_owned(),
        );
    }
    sentences
}

fn pressed(extent: &Extent) -> String {
    let times = if extent.windows == 1 { "the whole band" } else { "windows half a decade apart" };
    let left_out = match extent.left_out {
        0 => String::new(),
        some => format!(" ({} without roughness left out)", counted(some, "window")),
    };
    format!(
        "Pressed for this: {}{left_out} under {} on {times}, {} x {} points, {} each, seed {}; {} operators times points of a budget of {}.",
        counted(extent.windows, "window"),
        counted(extent.solved, "pressure"),
        extent.grid,
        extent.grid,
        counted(extent.realisations, "surface"),
        extent.seed,
        three_digits(extent.spent),
        three_digits(extent.budget)
    )
}
