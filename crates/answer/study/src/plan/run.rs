//! The settings of a run of a plan, passed on as one value.

use numerics::parallel::Progress;

use super::{Plan, PlanError, Tolerance};

/// The observer of the work, which may cancel it, and the tolerance of statistical states.
#[derive(Clone, Copy)]
pub(super) struct Run<'r> {
    progress: &'r dyn Progress,
    /// The relative tolerance of statistical states.
    pub tolerance: Tolerance,
}

impl<'r> Run<'r> {
    pub fn of(plan: &Plan<'_>, progress: &'r dyn Progress) -> Self {
        Run { progress, tolerance: plan.needs.tolerance }
    }

    /// Returns an error if the observer has cancelled the work.
    pub fn go_on(self) -> Result<(), PlanError> {
        if self.progress.is_cancelled() { Err(PlanError::Cancelled) } else { Ok(()) }
    }

    /// One more statistical state is known.
    pub fn state_is_known(self) {
        self.progress.advance(1);
    }
}
