//! Measurements that would narrow the answer.

use std::mem::discriminant;

use serde::Serialize;
use spectrum::Hole;
use study::interface::InterfaceStates;
use uncertainty::{Advice, Group, Settling, StepKind};
use units::{Remark, RemarkCode};

use super::cause::Cause;
use super::evidence::Evidence;
use super::load_answer::{AnswerUnderLoad, foremost};

/// A step that narrows the range by less than this share is not worth a measurement.
const WORTHWHILE: f64 = 0.9;

/// The most steps.
const MAX_STEPS: usize = 3;

/// A measurement that would narrow the answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "measure")]
#[non_exhaustive]
pub enum NextStep {
    /// The surface itself, whose spectrum is made of roughness parameters.
    Surface {
        /// The body, or both.
        body: String,
    },
    /// Adhesion, which no area counts, by boundary elements that attract each other.
    Adhesion,
    /// More scales, since the spectrum has too few.
    MoreScales,
    /// The spectrum where it was not measured.
    CloseHole(Hole),
    /// The hardness that the area is in inverse proportion to.
    Hardness,
    /// The hardness at the depth of the small scales.
    HardnessAtSmallDepth,
    /// The radius of the tip of a scan.
    TipRadius {
        /// The scan.
        scan: String,
    },
    /// The hardness of a softer body that has none.
    HardnessOfSofter {
        /// The body.
        body: String,
    },
    /// A scan at a second place.
    SecondScan {
        /// The instrument.
        instrument: String,
    },
    /// Shorter waves, since the area still falls at the end of the spectrum.
    FinerScan {
        /// The shortest wavelength of the spectrum \[m\].
        from_m: f64,
    },
    /// The flatness of the nominal contact, since the spectrum says too little of the longest waves.
    Flatness {
        /// The longest wavelength of the spectrum \[m\].
        from_m: f64,
    },
    /// Longer waves, whose heights decide the gap and what follows from it.
    WiderScan {
        /// The longest wavelength of the spectrum \[m\].
        from_m: f64,
    },
    /// More places with one instrument.
    MoreScans {
        /// The instrument.
        instrument: String,
        /// The number of further scans.
        added: usize,
        /// The width of the range afterwards, as a share of that now.
        width_ratio: f64,
    },
    /// The height scale of an instrument.
    HeightScale {
        /// The instrument.
        instrument: String,
        /// The width of the range afterwards, as a share of that now.
        width_ratio: f64,
    },
    /// Properties of the bodies.
    Material {
        /// The properties.
        group: Group,
        /// The width of the range afterwards, as a share of that now.
        width_ratio: f64,
    },
    /// Waves beyond an end of the spectrum.
    Wavelengths {
        /// The wavelength to reach \[m\].
        to_m: f64,
        /// The area to be expected, as a share of that now.
        area_ratio: f64,
    },
}

/// A step, and by how much it narrows the answer: the width of its range afterwards, as a share of that now.
struct Ranked(f64, NextStep);

/// Lists up to [`MAX_STEPS`] steps: what an answer cannot do without, then what narrows it, the most useful first.
pub(crate) fn next_steps(
    evidence: &Evidence<'_>,
    loads: &[AnswerUnderLoad],
    cautions: &[Remark],
    states: Option<&InterfaceStates<'_>>,
) -> Vec<NextStep> {
    let Some(load) = foremost(loads) else { return Vec::new() };
    let warned = |codes: &[RemarkCode]| cautions.iter().find(|caution| codes.contains(&caution.code));
    let surface = &evidence.scene.surface;
    let mut steps = Vec::new();
    let hangs_on_hardness = matches!(load.cause, Cause::Hardness { .. });
    let made_up = warned(&[RemarkCode::MadeOfNumbers]).and_then(|caution| caution.text("body"));
    let made_up = made_up.map(|body| NextStep::Surface { body: body.to_owned() });
    steps.extend(made_up.clone().filter(|_| !hangs_on_hardness));
    let sticks = warned(&[RemarkCode::StickyByPastewka, RemarkCode::StickyByFuller]);
    steps.extend(sticks.map(|_| NextStep::Adhesion));
    steps.extend(warned(&[RemarkCode::TooFewScales]).map(|_| NextStep::MoreScales));
    let softer = warned(&[RemarkCode::SofterWithoutHardness]).and_then(|softer| softer.text("softer"));
    steps.extend(softer.map(|body| NextStep::HardnessOfSofter { body: body.to_owned() }));
    let tip = warned(&[RemarkCode::TipMayShow]).filter(|_| !hangs_on_hardness);
    let scan = tip.and_then(|tip| tip.place.files.first());
    steps.extend(scan.map(|scan| NextStep::TipRadius { scan: scan.clone() }));
    let from_m = surface.psd.longest_wavelength_m();
    let longer_waves =
        warned(&[RemarkCode::GapNotSettled, RemarkCode::TakenAsFlat]).and(states).map(|states| match states
            .request
            .flatness
        {
            Some(_) => NextStep::WiderScan { from_m },
            None => NextStep::Flatness { from_m },
        });
    // Every report names the gap; heat, current and leaks are asked for.
    let come_first = states.is_some_and(|states| states.request.conducts_or_seals());
    steps.extend(longer_waves.clone().filter(|_| come_first));
    let mut ranked = from_draws(evidence, load);
    let draws_strength = ranked
        .iter()
        .any(|Ranked(_, step)| matches!(step, NextStep::Material { group: Group::Strength, .. }));
    if hangs_on_hardness && !draws_strength {
        ranked.push(Ranked(0.0, NextStep::Hardness));
    }
    if !hangs_on_hardness && load.cause != Cause::FullContact {
        let width_ratio = width_without_holes(evidence, load).unwrap_or(0.0);
        let of_use = |_: &&Hole| width_ratio < WORTHWHILE;
        let holes = surface.holes.iter().filter(of_use);
        ranked.extend(holes.map(|hole| Ranked(width_ratio, NextStep::CloseHole(*hole))));
    }
    ranked
        .extend(load.factor_of_hardness().map(|factor| Ranked(1.0 / factor, NextStep::HardnessAtSmallDepth)));
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    steps.extend(ranked.into_iter().map(|Ranked(_, step)| step));
    steps.extend(made_up.filter(|_| hangs_on_hardness));
    let still_falls = warned(&[RemarkCode::UpperBound]).filter(|_| !hangs_on_hardness);
    let is_told = shorter_waves_are_told(evidence, load);
    let shortest_m = surface.psd.shortest_wavelength_m();
    steps.extend(still_falls.filter(|_| !is_told).map(|_| NextStep::FinerScan { from_m: shortest_m }));
    steps.extend(longer_waves.filter(|_| !come_first));
    let adds_scans = steps.iter().any(|step| matches!(step, NextStep::MoreScans { .. }));
    let few = warned(&[RemarkCode::FewScans]).filter(|_| !adds_scans && !hangs_on_hardness);
    let instrument = few.and_then(|few| few.text("instrument"));
    steps.extend(instrument.map(|instrument| NextStep::SecondScan { instrument: instrument.to_owned() }));
    steps.truncate(MAX_STEPS);
    steps
}

/// Tells whether the draws say where the area settles: it is a step of theirs already, or not worth one.
fn shorter_waves_are_told(evidence: &Evidence<'_>, load: &AnswerUnderLoad) -> bool {
    let will_settle = |advice: &&Advice| matches!(advice.settling, Settling::WillSettle { .. });
    let steps = advice(evidence, load).filter(will_settle).map(|advice| &advice.steps);
    steps.into_iter().flatten().any(|step| matches!(step.kind, StepKind::ShorterWavelengths { .. }))
}

/// The width of the range without the error of holes, as a share of that now; `None` without draws of them.
fn width_without_holes(evidence: &Evidence<'_>, load: &AnswerUnderLoad) -> Option<f64> {
    let steps = &advice(evidence, load)?.steps;
    let closed = StepKind::KnownExactly { group: Group::Holes };
    steps.iter().find(|step| step.kind == closed).map(|step| load.area.width_ratio(step.width_ratio))
}

/// The advice for the curve whose interval is in the range.
fn advice<'a>(evidence: &Evidence<'a>, load: &AnswerUnderLoad) -> Option<&'a Advice> {
    evidence.uncertainty?.advice_for(load.area.of_inputs?.curve?, load.load)
}

/// The steps that the draws advise, each kind once.
fn from_draws(evidence: &Evidence<'_>, load: &AnswerUnderLoad) -> Vec<Ranked> {
    let Some((uncertainty, advice)) = evidence.uncertainty.zip(advice(evidence, load)) else {
        return Vec::new();
    };
    let settles = matches!(advice.settling, Settling::WillSettle { .. });
    let name = |at: usize| {
        let instrument = uncertainty.instruments.get(at);
        instrument.map_or_else(String::new, |instrument| instrument.name.text().to_owned())
    };
    let mut found: Vec<Ranked> = Vec::new();
    for step in &advice.steps {
        let (width_ratio, area_ratio) = (load.area.width_ratio(step.width_ratio), step.area_ratio);
        let narrows = width_ratio < WORTHWHILE;
        let next = match &step.kind {
            StepKind::MoreScans { instrument, added } if narrows && load.area.maps.is_none() => {
                NextStep::MoreScans { instrument: name(*instrument), added: *added, width_ratio }
            }
            StepKind::Calibration { instrument } if narrows => {
                NextStep::HeightScale { instrument: name(*instrument), width_ratio }
            }
            // Holes are named one by one.
            StepKind::KnownExactly { group: Group::Holes } => continue,
            StepKind::KnownExactly { group } if narrows => NextStep::Material { group: *group, width_ratio },
            StepKind::ShorterWavelengths { to_m } if settles && area_ratio < WORTHWHILE => {
                NextStep::Wavelengths { to_m: *to_m, area_ratio }
            }
            StepKind::LongerWavelengths { to_m } if narrows => {
                NextStep::Wavelengths { to_m: *to_m, area_ratio }
            }
            _ => continue,
        };
        // Of one kind only the strongest step is of use.
        let is_same = |other: &Ranked| discriminant(&other.1) == discriminant(&next);
        if !found.iter().any(is_same) {
            found.push(Ranked(width_ratio.min(area_ratio), next));
        }
    }
    found
}
