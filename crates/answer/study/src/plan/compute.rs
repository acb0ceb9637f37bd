//! Carrying a plan out.

use std::ops::Range;

use numerics::parallel::{Progress, Unobserved};
use stat_contact::Condition;

use super::distinct_inputs::DistinctInputs;
use super::prepared_spectrum::PreparedSpectrum;
use super::run::Run;
use super::work::counted;
use super::{CurveModel, CurveResult, Cutoffs, Needs, Plan, PlanError, Results, Work, sweeps};
use crate::models::Job;

impl Plan<'_> {
    /// Carries the plan out. Curves and loads run in parallel; the digits do not depend on the number of threads.
    ///
    /// # Errors
    /// [`PlanError`] where the cutoff leaves no scale, the resampled spectrum or the curves would be too large, a fit has
    /// too few samples, or a value lies outside its bounds.
    pub fn compute(&self) -> Result<Results, PlanError> {
        self.compute_observed(&Unobserved)
    }

    /// Computes the plan and reports to `progress`, one step per statistical state.
    ///
    /// # Errors
    /// Returns the errors of [`compute`](Self::compute), and [`PlanError::Cancelled`].
    pub fn compute_observed(&self, progress: &dyn Progress) -> Result<Results, PlanError> {
        self.check_size()?;
        self.compute_on(self.prepare(self.run(progress))?, progress)
    }

    /// Computes the plan from a spectrum that is already prepared, and reports to `progress`.
    ///
    /// # Errors
    /// Returns the errors of [`compute_observed`](Self::compute_observed).
    pub fn compute_on(
        &self,
        prepared: PreparedSpectrum,
        progress: &dyn Progress,
    ) -> Result<Results, PlanError> {
        let inputs = DistinctInputs::new(&self.needs);
        let models: Vec<(CurveModel, Cutoffs)> =
            inputs.models.items.iter().cloned().zip(inputs.cutoffs.iter().copied()).collect();
        let computed = numerics::parallel::try_map(&models, |(model, cutoffs)| {
            let places = 0..model.rows_per_block(&prepared, *cutoffs);
            self.blocks(model, *cutoffs, &prepared, progress, &inputs.conditions_of(model), places)
        })?;
        let (rows_of_models, work_of_curves) = counted(computed);
        let (sweeps, work_of_sweeps) = sweeps::results(self, &inputs, &rows_of_models, &prepared, progress)?;
        let [computed_levels, computed_states] = levels_and_states(&rows_of_models);
        let curves = inputs.handed_out(rows_of_models, &self.needs.curves);
        let [wanted_levels, wanted_states] = levels_and_states(&curves);

        let PreparedSpectrum { psd, moments, scales, fit, mut work, gradients, .. } = prepared;
        work += work_of_curves;
        work += work_of_sweeps;
        work += Work {
            shared_levels: wanted_levels - computed_levels,
            shared_states: wanted_states - computed_states,
            ..Work::default()
        };
        Ok(Results { psd, moments, scales, fit, curves, sweeps, work, gradients })
    }

    /// Computes some rows of a model, a block for each condition, and counts the work.
    pub(super) fn blocks(
        &self,
        model: &CurveModel,
        cutoffs: Cutoffs,
        prepared: &PreparedSpectrum,
        progress: &dyn Progress,
        conditions: &[Condition],
        places: Range<usize>,
    ) -> Result<(CurveResult, Work), PlanError> {
        let roughness = |band| self.roughness(prepared, band);
        let job = Job { prepared, cutoffs, run: self.run(progress), roughness: &roughness };
        model.blocks(&job, conditions, places)
    }

    /// Returns the settings of a run that an observer follows.
    pub(super) fn run<'r>(&self, progress: &'r dyn Progress) -> Run<'r> {
        let Needs { tolerance, states_per_decade, areas_alone, .. } = self.needs;
        Run { progress, tolerance, states_per_decade, areas_alone }
    }
}

/// Counts the levels of stacks and the statistical states.
fn levels_and_states(curves: &[CurveResult]) -> [usize; 2] {
    let of_curves = curves.iter().map(CurveResult::levels_and_states);
    of_curves.fold([0, 0], |[levels, states], [more, further]| [levels + more, states + further])
}
