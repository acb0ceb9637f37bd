//! The answer for one load.

use serde::Serialize;
use study::interface::InterfaceStates;

use super::area::AreaEstimate;
use super::asked::{AskedValue, Questions};
use super::cause::Cause;
use super::compared_models::{ModelCell, ReferenceGroup, Tally, groups, leading_reference};
use super::estimate::{Estimate, OtherHardness};
use super::evidence::Evidence;
use super::seal::SealUnderLoad;
use super::spots::SpotsUnderLoad;
use super::stickiness::stickiness;

/// The conclusion for a load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnswerUnderLoad {
    /// The load, by index.
    pub load: usize,
    /// The load as typed.
    pub label: String,
    /// The nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// The area that touches.
    pub area: AreaEstimate,
    /// The cause that the area hangs on.
    pub cause: Cause,
    /// The area if the hardness does not grow at small scales, if that lies outside the range.
    pub otherwise: Option<OtherHardness>,
    /// The closed form nearest to the elements, among those that agree with them; a cell of `references`.
    pub best_model: Option<ModelCell>,
    /// The models, by the elements that they are compared with; those of the estimate first.
    pub references: Vec<ReferenceGroup>,
    /// The number of models by verdict.
    pub tally: Tally,
    /// The seal under this load, if the scene has one.
    pub seal: Option<SealUnderLoad>,
    /// The quantities of the interface that the scene asks for.
    pub asked: Vec<AskedValue>,
    /// The spots that conduct on a measured map, if the scene asks for current.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spots: Option<SpotsUnderLoad>,
}

/// Returns the load that stands for all: the one in the middle of those whose area was compared with elements, or of all where none was.
#[must_use]
pub fn foremost(loads: &[AnswerUnderLoad]) -> Option<&AnswerUnderLoad> {
    let mut judged: Vec<&AnswerUnderLoad> =
        loads.iter().filter(|load| !load.area.source.is_of_models()).collect();
    if judged.is_empty() {
        judged = loads.iter().collect();
    }
    judged.get(judged.len() / 2).copied()
}

impl AnswerUnderLoad {
    /// Draws the conclusion for a load; `None` if no curve has an area under it.
    pub(crate) fn new(
        evidence: &Evidence<'_>,
        states: Option<&InterfaceStates<'_>>,
        load: usize,
    ) -> Option<Self> {
        let uncertainty = evidence.uncertainty;
        let given = &evidence.scene.needs.loads[load];
        let headline = evidence.judgement.and_then(|judgement| judgement.headline(load));
        let references = evidence.judgement.map_or_else(Vec::new, |judgement| groups(judgement, load));
        let cells = || references.iter().flat_map(|group| &group.models);
        let best_model = headline
            .and_then(|headline| headline.best_curve)
            .and_then(|best| cells().find(|cell| cell.curve == best).copied());
        let area = match headline {
            Some(headline) => AreaEstimate::from_headline(evidence, headline),
            None => AreaEstimate::from_models(evidence, load)?,
        };
        let estimate = Estimate {
            nominal_pressure_pa: given.nominal_pressure_pa(),
            area,
            otherwise: headline.and_then(|headline| OtherHardness::new(headline, &area)),
            best_model,
            references: &references,
        };
        Some(AnswerUnderLoad {
            load,
            label: given.label.clone(),
            nominal_pressure_pa: estimate.nominal_pressure_pa,
            area,
            cause: Cause::new(evidence, &estimate, states.and_then(stickiness).is_some()),
            otherwise: estimate.otherwise,
            best_model,
            tally: Tally::count(&references, leading_reference(headline)),
            seal: states.and_then(|states| SealUnderLoad::new(states, uncertainty, load)),
            asked: states.map_or_else(Vec::new, |states| {
                Questions { states, uncertainty, load, area: &area }.answers()
            }),
            spots: states.and_then(|states| SpotsUnderLoad::new(evidence, states, load)),
            references,
        })
    }

    /// Returns the factor between the areas with a constant hardness and with one that grows at small scales, if it decides.
    #[must_use]
    pub fn factor_of_hardness(&self) -> Option<f64> {
        self.estimate().factor_of_hardness()
    }

    /// Returns the curve whose area stands for the elements where these have none, as along the cutoff.
    #[must_use]
    pub fn nearest_curve(&self) -> Option<usize> {
        self.estimate().nearest_curve()
    }

    fn estimate(&self) -> Estimate<'_> {
        Estimate {
            nominal_pressure_pa: self.nominal_pressure_pa,
            area: self.area,
            otherwise: self.otherwise,
            best_model: self.best_model,
            references: &self.references,
        }
    }
}
