//! The settings of a run of a plan, passed on as one value.

use std::num::NonZeroU32;

use numerics::parallel::Progress;

use super::error::PlanError;
use super::tolerance::Tolerance;

/// The observer of the work, which may cancel it, and what holds for all curves.
#[derive(Clone, Copy)]
pub(crate) struct Run<'r> {
    pub progress: &'r dyn Progress,
    /// The relative tolerance of statistical states.
    pub tolerance: Tolerance,
    /// The largest number of cutoffs per decade of a statistical curve.
    pub states_per_decade: Option<NonZeroU32>,
    /// True leaves out the separations of Persson's theory.
    pub areas_alone: bool,
}

impl Run<'_> {
    /// Returns an error if the observer has cancelled the work.
    pub fn go_on(self) -> Result<(), PlanError> {
        if self.progress.is_cancelled() { Err(PlanError::Cancelled) } else { Ok(()) }
    }

    /// One more statistical state is known.
    pub fn state_is_known(self) {
        self.progress.advance(1);
    }
}
