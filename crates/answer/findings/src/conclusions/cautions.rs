//! Cautions: what to know before quoting a number.

use crate::doubts::Doubt;
use interface::adhesion::{FullerTabor, PastewkaRobbins};
use interface::conductance::MOST_PLASTIC_SHARE;
use judge::{AGREEMENT, Reference};
use serde::Serialize;
use spectrum::Hole;
use study::interface::InterfaceStates;
use study::interface::{Quantity, Slot};
use topography::InstrumentsDisagree;
use uncertainty::Guess;

use super::evidence::{Evidence, Trust};
use super::load::{LoadConclusion, Source};

/// A caution that changes what a reader should conclude.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "caution")]
#[non_exhaustive]
pub enum Caution {
    /// The spectrum has too few scales for any answer.
    TooFewScales {
        /// The number of scales.
        scales: usize,
    },
    /// Two instruments do not show the same surface.
    InstrumentsDisagree(InstrumentsDisagree),
    /// A value is physically implausible.
    Doubt(Doubt),
    /// Hardness at small scales decides the area.
    HardnessDecides {
        /// The largest factor between the areas with constant and with growing hardness.
        ratio: f64,
    },
    /// Nothing was compared with boundary elements.
    NotJudged,
    /// No model agrees with the elements.
    NoModelAgrees {
        /// The number of models that are compared with the elements of the estimate.
        models: usize,
    },
    /// The spectrum was not measured between two wavelengths.
    NotMeasured(Hole),
    /// The area still falls at the end of the spectrum.
    UpperBound {
        /// The shortest wavelength \[m\].
        shortest_m: f64,
    },
    /// Slopes are too steep for every method here.
    TooSteep {
        /// The wavelength \[m\] below which they are.
        from_m: f64,
    },
    /// One or two scans cannot show how much the surface varies.
    FewScans {
        /// The instrument.
        instrument: String,
        /// The number of its scans.
        scans: usize,
    },
    /// Gap, stiffness and what follows from them assume an elastic contact, but it yields.
    GapOfYieldingContact {
        /// The largest share of the contact that yields.
        share: f64,
    },
    /// Areas are those of curves that take a layer by its modulus at each wavelength, which is an approximation.
    ModulusOfLayer,
    /// The surfaces attract each other so much that an indicator finds them sticky; areas leave that out.
    Sticky(Stickiness),
    /// A measured map touches otherwise than Gaussian surfaces of its spectrum.
    NotGaussian {
        /// The map.
        map: String,
        /// Its area over that of the Gaussian surfaces.
        ratio: f64,
    },
}

/// An indicator of adhesion that finds a surface sticky.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "indicator")]
#[non_exhaustive]
pub enum Stickiness {
    /// The left side of Pastewka & Robbins' criterion, below its limit.
    PastewkaRobbins {
        /// The left side.
        left_side: f64,
    },
    /// Fuller & Tabor's parameter, not above the value from which surfaces did not stick; where no range of the attraction was
    /// given.
    FullerTabor {
        /// The parameter.
        theta: f64,
    },
}

impl Caution {
    /// Returns the trust that this caution leaves.
    #[must_use]
    pub fn trust_left(&self) -> Trust {
        match self {
            Caution::TooFewScales { .. } => Trust::None,
            Caution::InstrumentsDisagree(_)
            | Caution::Doubt(_)
            | Caution::HardnessDecides { .. }
            | Caution::NotJudged => Trust::Poor,
            Caution::NotMeasured(hole) if hole.longest_m > 10.0 * hole.shortest_m => Trust::Poor,
            Caution::NoModelAgrees { .. }
            | Caution::NotMeasured(_)
            | Caution::UpperBound { .. }
            | Caution::TooSteep { .. }
            | Caution::FewScans { .. }
            | Caution::GapOfYieldingContact { .. }
            | Caution::ModulusOfLayer
            | Caution::Sticky(_)
            | Caution::NotGaussian { .. } => Trust::Fair,
        }
    }
}

/// Lists the cautions, the most serious first.
pub(crate) fn cautions(
    evidence: &Evidence<'_>,
    loads: &[LoadConclusion],
    states: Option<&InterfaceStates<'_>>,
) -> Vec<Caution> {
    let Evidence { scene, answer, judgement, uncertainty, .. } = *evidence;
    let mut cautions = Vec::new();
    cautions.extend(answer.too_few_scales.map(|scales| Caution::TooFewScales { scales }));
    cautions.extend(answer.instruments_disagree.clone().map(Caution::InstrumentsDisagree));
    let of_inputs = Doubt::of_scene(scene, answer).into_iter().filter(Doubt::is_about_inputs);
    cautions.extend(of_inputs.map(Caution::Doubt));
    cautions.extend(hardness_decides(evidence, loads));
    if !loads.is_empty() && loads.iter().all(|load| is_of_models(load.area.source)) {
        cautions.push(Caution::NotJudged);
    }
    let has_layer = scene.material.as_ref().is_some_and(|material| material.pair.layer().is_some());
    let from_curves = loads.is_empty() || loads.iter().any(|load| is_of_models(load.area.source));
    cautions.extend((has_layer && from_curves).then_some(Caution::ModulusOfLayer));
    cautions.extend(scene.surface.holes().iter().copied().map(Caution::NotMeasured));
    cautions.extend(upper_bound(evidence, loads));
    cautions.extend(
        judgement.and_then(|judgement| judgement.steep_from_m).map(|from_m| Caution::TooSteep { from_m }),
    );
    let none_agrees =
        |load: &LoadConclusion| load.tally.agree == 0 && load.tally.off + load.tally.not_valid > 0;
    if !loads.is_empty() && loads.iter().all(none_agrees) {
        // Models of other bodies than those of the estimate may agree with their own elements.
        let others = loads.iter().map(|load| load.tally.of_other_elements).min().unwrap_or(0);
        cautions.push(Caution::NoModelAgrees { models: scene.needs.curves.len() - others });
    }
    for guess in uncertainty.into_iter().flat_map(|found| &found.guesses) {
        let Guess::FewScans { instrument, scans } = guess else { continue };
        let name = uncertainty.and_then(|found| found.instruments.get(*instrument));
        cautions.extend(
            name.map(|input| Caution::FewScans { instrument: input.name.text().to_owned(), scans: *scans }),
        );
    }
    let may_yield = loads.iter().filter(|load| load.area.source != Source::Elements(Reference::Elastic));
    let shares = may_yield.filter_map(|load| states?.plastic_share(load.load));
    let yielded = shares.filter(|share| *share > MOST_PLASTIC_SHARE);
    cautions.extend(yielded.reduce(f64::max).map(|share| Caution::GapOfYieldingContact { share }));
    cautions.extend(states.and_then(stickiness).map(Caution::Sticky));
    let maps = judgement.into_iter().flat_map(|judgement| &judgement.maps);
    let not_gaussian =
        maps.filter(|map| map.differs()).max_by(|a, b| a.ratio().ln().abs().total_cmp(&b.ratio().ln().abs()));
    cautions
        .extend(not_gaussian.map(|map| Caution::NotGaussian { map: map.map.clone(), ratio: map.ratio() }));
    cautions
}

/// The indicator that finds the surface sticky: Pastewka & Robbins' criterion, or without a range of the attraction Fuller &
/// Tabor's parameter.
fn stickiness(states: &InterfaceStates<'_>) -> Option<Stickiness> {
    let value = |quantity| states.value(Slot { quantity, load: None, curve: None }).ok().flatten();
    if let Some(left_side) = value(Quantity::PastewkaRobbins) {
        return (left_side < PastewkaRobbins::LIMIT).then_some(Stickiness::PastewkaRobbins { left_side });
    }
    let theta = value(Quantity::FullerTabor)?;
    (theta <= FullerTabor::NOT_STICKY_ABOVE).then_some(Stickiness::FullerTabor { theta })
}

fn is_of_models(source: Source) -> bool {
    matches!(source, Source::Model { .. } | Source::Models)
}

/// The caution on hardness at small scales: if it moves the area beyond its range, or if elements with the constant hardness have
/// an area beyond what counts as agreement with those whose hardness grows.
pub(crate) fn hardness_decides(evidence: &Evidence<'_>, loads: &[LoadConclusion]) -> Option<Caution> {
    let apart = |load: &LoadConclusion| match load.otherwise {
        Some(other) => Some(other.ratio),
        None if load.area.source == Source::Elements(Reference::Growing) => {
            let areas = evidence.judgement?.references.iter().filter(|area| area.load == load.load);
            let constant = areas.filter(|area| matches!(area.reference, Reference::Yielding { .. }));
            let constant = constant.filter_map(|area| area.elements).next()?;
            let ratio = constant.area_fraction / load.area.area_fraction?;
            (ratio > AGREEMENT).then_some(ratio)
        }
        None => None,
    };
    let ratio = loads.iter().filter_map(apart).reduce(f64::max)?;
    Some(Caution::HardnessDecides { ratio })
}

/// The caution that the area is still falling at the end of the spectrum, for any load.
fn upper_bound(evidence: &Evidence<'_>, loads: &[LoadConclusion]) -> Option<Caution> {
    let falls = |load: &LoadConclusion| {
        let followed =
            |curve: usize| evidence.answer.curves[curve][load.load].as_ref().filter(|answer| answer.followed);
        let nearest = load.nearest_curve().and_then(followed);
        let any = || (0..evidence.answer.curves.len()).find_map(followed);
        nearest.or_else(any).is_some_and(|answer| !answer.settled)
    };
    let shortest_m = evidence.results.psd.shortest_wavelength_m();
    loads.iter().any(falls).then_some(Caution::UpperBound { shortest_m })
}
