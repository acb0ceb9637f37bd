//! Findings on a scene besides its curves: the answer, and its sensitivity to modelling choices.

use scene::Scene;
use scene::file_names::REPORT_TABLES;
use study::Progress;
use study::plan::{Needs, PlanError, Results, Work};
use tables::Table;

use crate::answer::Answer;
use crate::sensitivity::{Sensitivity, sensitivities_with_work, table};

/// The answer of a scene and its sensitivity to modelling choices.
#[derive(Debug, Clone)]
pub struct SceneFindings {
    /// The answer.
    pub answer: Answer,
    /// The sensitivities of the areas to modelling choices.
    pub sensitivities: Vec<Sensitivity>,
    /// The work that the sensitivities took.
    pub work: Work,
}

impl SceneFindings {
    /// Extracts the answer from the results of a scene, and computes the sensitivities; `progress` may cancel them.
    ///
    /// # Errors
    /// [`PlanError`] if another modelling choice cannot be computed, or if the work is cancelled.
    pub fn from_results(
        scene: &Scene,
        results: &Results,
        progress: &dyn Progress,
    ) -> Result<Self, PlanError> {
        let answer = Answer::from_results(scene, results);
        let (sensitivities, work) = sensitivities_with_work(scene, results, progress)?;
        Ok(SceneFindings { answer, sensitivities, work })
    }

    /// Returns the tables of the report, by name.
    #[must_use]
    pub fn tables(&self, needs: &Needs) -> [(&'static str, Table); 3] {
        let [scales, decades, sensitivity] = REPORT_TABLES;
        [
            (scales, self.answer.scales_table(needs)),
            (decades, self.answer.decades_table(needs)),
            (sensitivity, table(&self.sensitivities, needs)),
        ]
    }
}
