#![doc = include_str!("../README.md")]

mod cautions;
mod load;
mod next;
mod seal;
mod shear;

pub use cautions::{Caution, Stickiness};
pub use load::{AreaEstimate, LoadConclusion, ModelCell, OtherHardness, ReferenceGroup, Source, Tally};
pub use next::NextStep;
pub use seal::{SealClosing, SealConclusion};
pub use shear::ShearConclusion;

use findings::answer::Answer;
use findings::interface::InterfaceStates;
use judge::Judgement;
use scene::Scene;
use serde::Serialize;
use study::plan::Results;
use uncertainty::Uncertainty;

/// The inputs of conclusions: a scene and what was found about it.
#[derive(Clone, Copy)]
pub struct Evidence<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its results.
    pub results: &'a Results,
    /// Its answer.
    pub answer: &'a Answer,
    /// The verdicts of boundary elements; absent if nothing was judged.
    pub judgement: Option<&'a Judgement>,
    /// The uncertainty of the areas; absent if nothing was drawn.
    pub uncertainty: Option<&'a Uncertainty>,
}

/// The conclusions of a scene.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Conclusions {
    /// The title of the scene.
    pub title: String,
    /// The conclusion for every load that has an area, in the order of the scene.
    pub loads: Vec<LoadConclusion>,
    /// The limits of these numbers, the most serious first.
    pub cautions: Vec<Caution>,
    /// The trust that they leave.
    pub trust: Trust,
    /// The seal, if the scene has one.
    pub seal: Option<SealConclusion>,
    /// The response to the tangential load under every load; empty without one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub shear: Vec<ShearConclusion>,
    /// Measurements that would narrow the answer, the most useful first.
    pub next: Vec<NextStep>,
}

/// The trust in the conclusions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Trust {
    /// The numbers cannot be used.
    None,
    /// An order of magnitude.
    Poor,
    /// A number with a condition.
    Fair,
    /// A number with its range.
    Good,
}

impl Trust {
    /// Returns the name, for print and for scripts.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Trust::None => "none",
            Trust::Poor => "poor",
            Trust::Fair => "fair",
            Trust::Good => "good",
        }
    }
}

impl Conclusions {
    /// Draws the conclusions from the evidence.
    #[must_use]
    pub fn new(evidence: &Evidence<'_>) -> Self {
        let scene = evidence.scene;
        let states = InterfaceStates::from_scene(scene, evidence.results);
        let loads: Vec<LoadConclusion> =
            (0..scene.needs.loads.len()).filter_map(|load| LoadConclusion::new(evidence, load)).collect();
        let cautions = cautions::cautions(evidence, &loads, states.as_ref());
        Conclusions {
            title: scene.title.clone(),
            trust: cautions.iter().map(Caution::trust_left).min().unwrap_or(Trust::Good),
            seal: states.as_ref().and_then(|states| SealConclusion::new(scene, states)),
            shear: states.as_ref().map(ShearConclusion::of_loads).unwrap_or_default(),
            next: next::next_steps(evidence, &loads),
            loads,
            cautions,
        }
    }
}
