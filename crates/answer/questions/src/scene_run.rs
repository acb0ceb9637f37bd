//! Runs a scene from its plan to all of its results, in the same order for every front end.

use conclusions::{Conclusions, Evidence};
use findings::answer::SceneAnswer;
use findings::sensitivity::{Sensitivity, sensitivities};
use judge::{JudgeError, JudgePlan, Judgement};
use scene::Scene;
use study::plan::{PlanError, Results};
use study::{Progress, Unobserved};
use uncertainty::{Uncertainty, UncertaintyPlan, scattering_groups};

/// Results of a scene to compute besides its curves and figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RunOptions {
    /// True to write a report, which also compares other choices.
    pub report: bool,
    /// True if boundary elements judge the curves; if absent, the scene and `report` decide.
    pub judge: Option<bool>,
    /// True if the uncertainty analysis runs; if absent, the scene and `report` decide.
    pub uncertainty: Option<bool>,
}

impl RunOptions {
    /// Returns true if boundary elements judge the curves. By default they do for a report and for a scene with a
    /// `judge` section, unless that section turns them off.
    #[must_use]
    pub fn is_judged(&self, scene: &Scene) -> bool {
        let off = scene.judge.as_ref().is_some_and(|choices| choices.off);
        self.judge.unwrap_or(!off && (self.report || scene.judge.is_some()))
    }

    /// Returns true if the uncertainty analysis runs. By default it does for a report, and for a scene that states an uncertainty or
    /// has an `uncertainty` section, unless that section turns it off. It never runs if nothing in the scene scatters.
    #[must_use]
    pub fn is_drawn(&self, scene: &Scene) -> bool {
        let off = scene.uncertainty.as_ref().is_some_and(|choices| choices.off);
        let by_scene = scene.uncertainty.is_some() || scene.states_uncertainty();
        let is_wanted = self.uncertainty.unwrap_or(!off && (self.report || by_scene));
        is_wanted && !scattering_groups(scene).is_empty()
    }
}

/// Phase of a run. Its progress is counted in steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The scene's plan, in statistical states.
    Computing,
    /// Comparison with other choices, in states whose number is not known beforehand.
    Comparing,
    /// Boundary elements, in surfaces pressed.
    Judging,
    /// Draws of the uncertain inputs.
    Drawing,
}

impl Phase {
    /// Returns the name of the steps of the phase.
    #[must_use]
    pub fn steps(self) -> &'static str {
        match self {
            Phase::Computing | Phase::Comparing => "states",
            Phase::Judging => "surfaces pressed",
            Phase::Drawing => "draws",
        }
    }
}

/// Observer of a run.
pub trait Watch {
    /// Begins a phase of `steps` steps. The returned [`Progress`] advances once per step and may cancel the phase.
    /// Cancelled draws still give a result from the draws made by then.
    fn begin(&self, phase: Phase, steps: usize) -> Box<dyn Progress + '_>;

    /// Ends a phase. Phases that are not requested end at once, except draws, which do not end.
    fn end(&self, _phase: Phase) {}
}

/// Observer that does nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn begin(&self, _: Phase, _: usize) -> Box<dyn Progress + '_> {
        Box::new(Unobserved)
    }
}

/// All results of a scene.
pub struct SceneOutcome {
    /// Curves and figures of the scene.
    pub results: Results,
    /// The areas and the scales that decide them.
    pub answer: SceneAnswer,
    /// The sensitivities of the areas to modelling choices; absent if no report was requested.
    pub sensitivities: Option<Vec<Sensitivity>>,
    /// Judgement by boundary elements; absent if it was not requested.
    pub judgement: Option<Judgement>,
    /// Result of the uncertainty analysis; absent if no draws were made.
    pub uncertainty: Option<Uncertainty>,
    /// The conclusions from all of these.
    pub conclusions: Conclusions,
}

impl SceneOutcome {
    /// Returns the evidence that the conclusions rest on.
    #[must_use]
    pub fn evidence<'a>(&'a self, scene: &'a Scene) -> Evidence<'a> {
        Evidence {
            scene,
            results: &self.results,
            answer: &self.answer,
            judgement: self.judgement.as_ref(),
            uncertainty: self.uncertainty.as_ref(),
        }
    }
}

/// Error of a run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// The run was cancelled.
    #[error("ended before the result was there")]
    Cancelled,
    /// The plan cannot be computed.
    #[error(transparent)]
    Plan(PlanError),
    /// There is no judgement.
    #[error(transparent)]
    Judge(JudgeError),
}

impl From<PlanError> for RunError {
    fn from(error: PlanError) -> Self {
        match error {
            PlanError::Cancelled => RunError::Cancelled,
            error => RunError::Plan(error),
        }
    }
}

impl From<JudgeError> for RunError {
    fn from(error: JudgeError) -> Self {
        match error {
            JudgeError::Plan(PlanError::Cancelled) => RunError::Cancelled,
            error => RunError::Judge(error),
        }
    }
}

/// Runs a scene.
///
/// # Errors
/// [`RunError`], of the first phase that fails or is ended.
pub fn run_scene(scene: &Scene, options: RunOptions, watch: &dyn Watch) -> Result<SceneOutcome, RunError> {
    let plan = scene.plan();
    let results = plan.compute_observed(&*watch.begin(Phase::Computing, plan.statistical_states()))?;
    watch.end(Phase::Computing);
    let answer = SceneAnswer::from_results(scene, &results);
    let sensitivities = match options.report {
        true => Some(sensitivities(scene, &results, &*watch.begin(Phase::Comparing, 0))?),
        false => None,
    };
    watch.end(Phase::Comparing);
    let judgement = judgement(scene, &results, options, watch)?;
    watch.end(Phase::Judging);
    let uncertainty = uncertainty(scene, &results, options, watch)?;
    if uncertainty.is_some() {
        watch.end(Phase::Drawing);
    }
    let conclusions = Conclusions::new(&Evidence {
        scene,
        results: &results,
        answer: &answer,
        judgement: judgement.as_ref(),
        uncertainty: uncertainty.as_ref(),
    });
    Ok(SceneOutcome { results, answer, sensitivities, judgement, uncertainty, conclusions })
}

fn judgement(
    scene: &Scene,
    results: &Results,
    options: RunOptions,
    watch: &dyn Watch,
) -> Result<Option<Judgement>, RunError> {
    if !options.is_judged(scene) {
        return Ok(None);
    }
    let settings = scene.judge.unwrap_or_default();
    let plan = JudgePlan::new(scene, results, &settings);
    let progress = watch.begin(Phase::Judging, plan.solutions());
    let judgement = plan.run(&*progress)?;
    // A cancelled judgement lacks surfaces, and would pass for a complete one.
    if progress.is_cancelled() { Err(RunError::Cancelled) } else { Ok(Some(judgement)) }
}

fn uncertainty(
    scene: &Scene,
    results: &Results,
    options: RunOptions,
    watch: &dyn Watch,
) -> Result<Option<Uncertainty>, RunError> {
    if !options.is_drawn(scene) {
        return Ok(None);
    }
    let settings = scene.uncertainty.unwrap_or_default();
    let Some(plan) = UncertaintyPlan::new(scene, results, &settings) else { return Ok(None) };
    let progress = watch.begin(Phase::Drawing, plan.steps());
    Ok(Some(plan.run(&*progress)?))
}
