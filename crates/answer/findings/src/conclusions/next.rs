//! Measurements that would narrow the answer.

use serde::Serialize;
use spectrum::Hole;
use uncertainty::{Group, Settling, Step, StepKind};

use super::evidence::Evidence;
use super::load::LoadConclusion;

/// A step that narrows the interval by less than this share is not worth a measurement.
const WORTHWHILE: f64 = 0.95;

/// The most steps.
const MAX_STEPS: usize = 3;

/// A measurement that would narrow the answer.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "measure")]
#[non_exhaustive]
pub enum NextStep {
    /// The spectrum where it was not measured.
    CloseHole(Hole),
    /// The hardness at the depth of the small scales.
    HardnessAtSmallDepth,
    /// More places with one instrument.
    MoreScans {
        /// The instrument.
        instrument: String,
        /// The number of further scans.
        added: usize,
        /// The width of the interval afterwards, as a share of that now.
        width_ratio: f64,
    },
    /// The height scale of an instrument.
    HeightScale {
        /// The instrument.
        instrument: String,
        /// The width of the interval afterwards, as a share of that now.
        width_ratio: f64,
    },
    /// Properties of the bodies.
    Material {
        /// The properties.
        group: Group,
        /// The width of the interval afterwards, as a share of that now.
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

/// Lists up to [`MAX_STEPS`] steps, the most useful first: holes, then the hardness that decides, then what narrows the
/// interval of the load in the middle, and what would settle the area.
pub(crate) fn next_steps(evidence: &Evidence<'_>, loads: &[LoadConclusion]) -> Vec<NextStep> {
    let mut steps: Vec<NextStep> =
        evidence.scene.surface.holes().iter().copied().map(NextStep::CloseHole).collect();
    if super::cautions::hardness_decides(loads).is_some() {
        steps.push(NextStep::HardnessAtSmallDepth);
    }
    steps.extend(from_draws(evidence, loads));
    steps.truncate(MAX_STEPS);
    steps
}

fn from_draws(evidence: &Evidence<'_>, loads: &[LoadConclusion]) -> Vec<NextStep> {
    let Some(uncertainty) = evidence.uncertainty else { return Vec::new() };
    let Some(load) = loads.get(loads.len() / 2) else { return Vec::new() };
    // Without a verdict, the advice of any curve.
    let any = || uncertainty.advice.iter().find(|advice| advice.load == load.load);
    let advice = match load.nearest_curve() {
        Some(curve) => uncertainty.advice_for(curve, load.load),
        None => any(),
    };
    let Some(advice) = advice else { return Vec::new() };
    let settles = matches!(advice.settling, Settling::WillSettle { .. });
    let name = |at: usize| {
        uncertainty
            .instruments
            .get(at)
            .map_or_else(String::new, |instrument| instrument.name.text().to_owned())
    };
    let mut found: Vec<NextStep> = Vec::new();
    for step in &advice.steps {
        let Step { width_ratio, area_ratio, .. } = *step;
        let narrows = width_ratio < WORTHWHILE;
        let next = match &step.kind {
            StepKind::MoreScans { instrument, added } if narrows => {
                NextStep::MoreScans { instrument: name(*instrument), added: *added, width_ratio }
            }
            StepKind::Calibration { instrument } if narrows => {
                NextStep::HeightScale { instrument: name(*instrument), width_ratio }
            }
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
        if !found.iter().any(|other| std::mem::discriminant(other) == std::mem::discriminant(&next)) {
            found.push(next);
        }
    }
    found
}
