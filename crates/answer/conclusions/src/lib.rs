//! The one answer of each load of a scene, as data: the area that touches with its range, what the area hangs on, the models, the seal,
//! what was asked besides, cautions and trust, and what to measure next.
//!
//! Findings, verdicts and intervals each see a part of the results. [`Conclusions::new`] joins them once from the [`Evidence`], so that
//! the summary on a terminal, the report and `answer.json` cannot contradict each other.

mod area;
mod asked;
mod cause;
mod cautions;
mod compared_models;
mod estimate;
mod evidence;
mod load_answer;
mod next;
mod publications;
mod seal;
mod shear;
mod spots;
mod stickiness;

pub use area::{AreaEstimate, OfInputs, Source};
pub use asked::{AskedValue, PeakState, flatness_within};
pub use cause::Cause;
pub use cautions::trust_left;
pub use compared_models::{ModelCell, ReferenceGroup, Tally};
pub use estimate::OtherHardness;
pub use evidence::{Evidence, Trust};
pub use load_answer::{AnswerUnderLoad, foremost};
pub use next::NextStep;
pub use publications::Publication;
pub use seal::{LeakInUnit, SealClosing, SealConclusion, SealUnderLoad, SealVerdict};
pub use shear::ShearConclusion;
pub use spots::SpotsUnderLoad;

use serde::Serialize;
use units::Remark;

/// The conclusions of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Conclusions {
    /// The title of the scene.
    pub title: String,
    /// The conclusion for every load that has an area, in the order of the scene.
    pub loads: Vec<AnswerUnderLoad>,
    /// The limits of these numbers, the most serious first.
    #[serde(serialize_with = "cautions::serialize")]
    pub cautions: Vec<Remark>,
    /// The trust that they leave.
    pub trust: Trust,
    /// The seal, if the scene has one; each load has its verdict.
    pub seal: Option<SealConclusion>,
    /// The response to the tangential load under every load; empty without one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub shear: Vec<ShearConclusion>,
    /// Measurements that would narrow the answer, the most useful first.
    pub next: Vec<NextStep>,
    /// Publications to cite with the answer.
    pub publications: Vec<Publication>,
}

impl Conclusions {
    /// Draws the conclusions from the evidence.
    #[must_use]
    pub fn new(evidence: &Evidence<'_>) -> Self {
        let scene = evidence.scene;
        let states = scene.interface_states(evidence.results);
        let loads: Vec<AnswerUnderLoad> = (0..scene.needs.loads.len())
            .filter_map(|load| AnswerUnderLoad::new(evidence, states.as_ref(), load))
            .collect();
        let cautions = cautions::cautions(evidence, &loads, states.as_ref());
        Conclusions {
            title: scene.title.clone(),
            trust: cautions.iter().map(trust_left).min().unwrap_or(Trust::Good),
            seal: states.as_ref().and_then(|states| SealConclusion::new(states, evidence.uncertainty)),
            shear: states
                .as_ref()
                .map(|states| ShearConclusion::of_loads(states, &loads))
                .unwrap_or_default(),
            next: next::next_steps(evidence, &loads, &cautions, states.as_ref()),
            publications: publications::publications(evidence, &loads, states.as_ref()),
            loads,
            cautions,
        }
    }
}
