//! A scene from its plan to everything that is told of it, in one order for whoever runs it.

use judge::{JudgeError, JudgePlan, Judgement};
use scene::Scene;
use study::Progress;
use study::plan::{PlanError, Results};
use uncertainty::{Uncertainty, UncertaintyPlan, scattering_groups};

use crate::assessment::Assessment;
use crate::products::{Findings, Parts};

/// What of a scene is carried out besides its curves and figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Asked {
    /// A report, for which choices are made another way.
    pub report: bool,
    /// Whether boundary elements judge the curves; where that is left open, the scene and its report tell.
    pub judge: Option<bool>,
    /// Whether draws tell how sure the areas are; where that is left open, the scene and its report tell.
    pub uncertainty: Option<bool>,
}

impl Asked {
    /// Whether boundary elements are asked: a report has their verdict, and so has a scene that has a section for it.
    #[must_use]
    pub fn is_judged(&self, scene: &Scene) -> bool {
        let off = scene.judge.as_ref().is_some_and(|choices| choices.off);
        self.judge.unwrap_or(!off && (self.report || scene.judge.is_some()))
    }

    /// Whether draws are made: a report has intervals where something of the scene scatters, and so has a scene that has a
    /// section for them. Where nothing scatters there is nothing to draw.
    #[must_use]
    pub fn is_drawn(&self, scene: &Scene) -> bool {
        let off = scene.uncertainty.as_ref().is_some_and(|choices| choices.off);
        let is_wanted = self.uncertainty.unwrap_or(!off && (self.report || scene.uncertainty.is_some()));
        is_wanted && !scattering_groups(scene).is_empty()
    }

    /// What will be made of the scene.
    #[must_use]
    pub fn parts(&self, scene: &Scene) -> Parts {
        Parts { report: self.report, judgement: self.is_judged(scene), uncertainty: self.is_drawn(scene) }
    }
}

/// A part of the work; its steps are what it is measured in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The scene's plan, in statistical states.
    Computing,
    /// Choices made another way, in states whose number is not known beforehand.
    Comparing,
    /// Boundary elements, in surfaces pressed.
    Judging,
    /// Draws of what scatters.
    Drawing,
}

impl Phase {
    /// What its steps are called.
    #[must_use]
    pub fn steps(self) -> &'static str {
        match self {
            Phase::Computing | Phase::Comparing => "states",
            Phase::Judging => "surfaces pressed",
            Phase::Drawing => "draws",
        }
    }
}

/// Whoever watches a run.
pub trait Watch {
    /// A phase of so many steps begins; what is yielded is told of them, and may end it. Draws that are ended tell what they
    /// know by then.
    fn begin(&self, phase: Phase, steps: usize) -> Box<dyn Progress + '_>;

    /// A phase is over. Phases that are not asked for are over at once, but for draws.
    fn end(&self, _phase: Phase) {}
}

/// Everything that is told of a scene.
pub struct Carried {
    /// Its curves and figures.
    pub results: Results,
    /// What a report says besides, where one was asked for.
    pub findings: Option<Findings>,
    /// What boundary elements say, where they were asked.
    pub judgement: Option<Judgement>,
    /// What draws say, where some were made.
    pub uncertainty: Option<Uncertainty>,
}

impl Carried {
    /// How far the results can be trusted.
    #[must_use]
    pub fn assessment(&self) -> Assessment<'_> {
        Assessment { judgement: self.judgement.as_ref(), uncertainty: self.uncertainty.as_ref() }
    }
}

/// Why a scene is not carried out.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RunError {
    /// Somebody ended the work.
    #[error("ended before the result was there")]
    Cancelled,
    /// The plan cannot be carried out.
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

/// Carries a scene out.
///
/// # Errors
/// [`RunError`], of the first phase that fails or is ended.
pub fn carry_out(scene: &Scene, asked: Asked, watch: &dyn Watch) -> Result<Carried, RunError> {
    let plan = scene.plan();
    let results = plan.compute_observed(&*watch.begin(Phase::Computing, plan.statistical_states()))?;
    watch.end(Phase::Computing);
    let findings = match asked.report {
        true => Some(Findings::from_results_observed(scene, &results, &*watch.begin(Phase::Comparing, 0))?),
        false => None,
    };
    watch.end(Phase::Comparing);
    let judgement = judgement(scene, &results, asked, watch)?;
    watch.end(Phase::Judging);
    let uncertainty = uncertainty(scene, &results, asked, watch)?;
    if uncertainty.is_some() {
        watch.end(Phase::Drawing);
    }
    Ok(Carried { results, findings, judgement, uncertainty })
}

fn judgement(
    scene: &Scene,
    results: &Results,
    asked: Asked,
    watch: &dyn Watch,
) -> Result<Option<Judgement>, RunError> {
    if !asked.is_judged(scene) {
        return Ok(None);
    }
    let settings = judge::Settings::from_choices(scene.judge.as_ref());
    let plan = JudgePlan::new(scene, results, &settings);
    let progress = watch.begin(Phase::Judging, plan.solutions());
    let judgement = plan.run(&*progress)?;
    // What was not pressed by the end is not judged, and half a judgement would pass for a whole one.
    if progress.is_cancelled() { Err(RunError::Cancelled) } else { Ok(Some(judgement)) }
}

fn uncertainty(
    scene: &Scene,
    results: &Results,
    asked: Asked,
    watch: &dyn Watch,
) -> Result<Option<Uncertainty>, RunError> {
    if !asked.is_drawn(scene) {
        return Ok(None);
    }
    let settings = uncertainty::Settings::from_choices(scene.uncertainty.as_ref());
    let Some(plan) = UncertaintyPlan::new(scene, results, &settings) else { return Ok(None) };
    let progress = watch.begin(Phase::Drawing, plan.steps());
    Ok(Some(plan.run(&*progress)?))
}
