//! Carrying a plan out.

use std::num::NonZeroU32;

use parallel::{Progress, Unobserved};

use super::asked::Asked;
use super::condition::Condition;
use super::ground::{Cutoff, Ground};
use super::run::Run;
use super::states::Statistical;
use super::work::counted;
use super::{CurveModel, CurveResult, Cutoffs, Plan, PlanError, Results, Work, persson_cuts, stack, sweeps};

impl Plan<'_> {
    /// Carries the plan out. Curves and loads run in parallel; the digits do not depend on the number of threads.
    ///
    /// # Errors
    /// [`PlanError`] where the cutoff leaves no scale, the resampled spectrum or the curves would be too large, a fit has
    /// too few samples, or a value lies outside its bounds.
    pub fn compute(&self) -> Result<Results, PlanError> {
        self.compute_observed(&Unobserved)
    }

    /// The same, watched: a step is a statistical state.
    ///
    /// # Errors
    /// Those of [`compute`](Self::compute), and [`PlanError::Cancelled`].
    pub fn compute_observed(&self, progress: &dyn Progress) -> Result<Results, PlanError> {
        self.check_size()?;
        self.compute_on(self.ground()?, progress)
    }

    /// The same, going on from what is known already of the spectrum that the plan is about.
    ///
    /// # Errors
    /// Those of [`compute_observed`](Self::compute_observed).
    pub fn compute_on(&self, ground: Ground, progress: &dyn Progress) -> Result<Results, PlanError> {
        let run = Run::of(self, progress);
        let asked = Asked::by(&self.needs);
        let models: Vec<(CurveModel, Cutoffs)> =
            asked.models.items.iter().cloned().zip(asked.cutoffs.iter().copied()).collect();
        let computed = parallel::try_map(&models, |(model, cutoffs)| {
            self.rows_of_model(model, *cutoffs, &asked, &ground, run)
        })?;
        let (rows_of_models, work_of_curves) = counted(computed);
        let (sweeps, work_of_sweeps) = sweeps::results(&self.needs, &asked, &rows_of_models, &ground, run)?;
        let [computed_levels, computed_states] = levels_and_states(&rows_of_models);
        let curves = asked.handed_out(rows_of_models, &self.needs.curves);
        let [wanted_levels, wanted_states] = levels_and_states(&curves);

        let Ground { psd, moments, scales, fit, mut work, .. } = ground;
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
        asked: &Asked,
        ground: &Ground,
        run: Run<'_>,
    ) -> Result<(CurveResult, Work), PlanError> {
        match model {
            CurveModel::Stacked(model) => {
                let (blocks, work) =
                    stack::blocks(model, &asked.pressures_pa(), &ground.scales, cutoffs, run)?;
                Ok((CurveResult::Stacked(blocks), work))
            }
            &CurveModel::Statistical { pair, law } => {
                let conditions: &[Condition] = &asked.conditions.items;
                let cutoffs = ground.cutoffs(cutoffs, 0..ground.cutoff_count(cutoffs));
                let cutoffs = match self.needs.states_per_decade {
                    Some(per_decade) => thinned(cutoffs, per_decade),
                    None => cutoffs,
                };
                let (blocks, work) = Statistical { pair, law, run }.over_cutoffs(&cutoffs, conditions)?;
                Ok((CurveResult::Statistical(blocks), work))
            }
            CurveModel::Persson { pair, law } => {
                let pressures_pa = asked.pressures_pa();
                let blocks = persson_cuts::blocks(self, pair, law, &pressures_pa, ground, cutoffs, run)?;
                Ok((CurveResult::Persson(blocks), Work::default()))
            }
        }
    }
}

/// Of neighbouring cutoffs, from long to short, at most so many per decade, the last of each part of a decade: the shortest is
/// always there.
fn thinned(cutoffs: Vec<Cutoff>, per_decade: NonZeroU32) -> Vec<Cutoff> {
    let part = |cutoff: &Cutoff| (cutoff.wavelength_m.log10() * f64::from(per_decade.get())).ceil();
    cutoffs.chunk_by(|a, b| part(a) == part(b)).filter_map(|part| part.last().copied()).collect()
}

/// How many levels of stacks and how many statistical states there are.
fn levels_and_states(curves: &[CurveResult]) -> [usize; 2] {
    [curves.iter().map(CurveResult::levels).sum(), curves.iter().map(CurveResult::states).sum()]
}
