//! Carrying a plan out.

use numerics::parallel::{Progress, Unobserved};

use super::distinct_inputs::DistinctInputs;
use super::prepared_spectrum::PreparedSpectrum;
use super::run::Run;
use super::theory::{Job, theory_of};
use super::work::counted;
use super::{CurveModel, CurveResult, Cutoffs, Plan, PlanError, Results, Work, sweeps};

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
        self.compute_on(self.prepare(Run::of(self, progress))?, progress)
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
        let run = Run::of(self, progress);
        let inputs = DistinctInputs::new(&self.needs);
        let models: Vec<(CurveModel, Cutoffs)> =
            inputs.models.items.iter().cloned().zip(inputs.cutoffs.iter().copied()).collect();
        let computed = numerics::parallel::try_map(&models, |(model, cutoffs)| {
            self.rows_of_model(model, *cutoffs, &inputs, &prepared, run)
        })?;
        let (rows_of_models, work_of_curves) = counted(computed);
        let (sweeps, work_of_sweeps) =
            sweeps::results(&self.needs, &inputs, &rows_of_models, &prepared, run)?;
        let [computed_levels, computed_states] = levels_and_states(&rows_of_models);
        let curves = inputs.handed_out(rows_of_models, &self.needs.curves);
        let [wanted_levels, wanted_states] = levels_and_states(&curves);

        let PreparedSpectrum { psd, moments, scales, fit, mut work, .. } = prepared;
        work += work_of_curves;
        work += work_of_sweeps;
        work += Work {
            shared_levels: wanted_levels - computed_levels,
            shared_states: wanted_states - computed_states,
            ..Work::default()
        };
        Ok(Results { psd, moments, scales, fit, curves, sweeps, work })
    }

    /// The rows of one model, a block for each differing load and separation.
    fn rows_of_model(
        &self,
        model: &CurveModel,
        cutoffs: Cutoffs,
        inputs: &DistinctInputs,
        prepared: &PreparedSpectrum,
        run: Run<'_>,
    ) -> Result<(CurveResult, Work), PlanError> {
        let theory = theory_of(model);
        let places = 0..theory.rows_per_block(prepared, cutoffs);
        theory.blocks(&Job { plan: self, prepared, cutoffs, run }, &inputs.conditions_of(model), places)
    }
}

/// Counts the levels of stacks and the statistical states.
fn levels_and_states(curves: &[CurveResult]) -> [usize; 2] {
    [curves.iter().map(CurveResult::levels).sum(), curves.iter().map(CurveResult::states).sum()]
}
