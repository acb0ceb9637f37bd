//! Carrying a plan out: equal models under equal loads share their rows, and sweeps take what the curves have.

use std::collections::HashMap;

use parallel::{Progress, Unobserved};
use spectrum::AsperityParameters;
use stat_contact::ContactState;

use super::distinct::Distinct;
use super::ground::Ground;
use super::states::{Given, Statistical, population};
use super::{
    CurveModel, CurveResult, CutoffState, Cutoffs, Load, LoadSweep, Plan, PlanError, Results, Work, stack,
};

impl Plan<'_> {
    /// Carries the plan out. Curves and loads run in parallel; the digits do not depend on the number of threads.
    ///
    /// # Errors
    /// [`PlanError`] where the cutoff leaves no scale, the resampled spectrum would be too large, a fit has too few
    /// samples, or a value lies outside its bounds.
    pub fn compute(&self) -> Result<Results, PlanError> {
        self.compute_observed(&Unobserved)
    }

    /// The same, watched: a step is a statistical state.
    ///
    /// # Errors
    /// Those of [`compute`](Self::compute), and [`PlanError::Cancelled`].
    pub fn compute_observed(&self, progress: &dyn Progress) -> Result<Results, PlanError> {
        self.compute_on(self.ground()?, progress)
    }

    /// The same, going on from what is known already of the spectrum that the plan is about.
    ///
    /// # Errors
    /// Those of [`compute`](Self::compute).
    pub fn compute_on(&self, ground: Ground, progress: &dyn Progress) -> Result<Results, PlanError> {
        let kinds = self.kinds();
        let of_kind = |kind: usize| self.curve(kind, &kinds, &ground, progress);
        let kinds_of_models: Vec<usize> = (0..kinds.models.firsts.len()).collect();
        let computed = parallel::try_map(&kinds_of_models, |&kind| of_kind(kind))?;
        let mut work = ground.work;
        let mut by_kind = Vec::with_capacity(computed.len());
        for (result, of_kind) in computed {
            work += of_kind;
            by_kind.push(result);
        }
        let (sweeps, of_sweeps) = self.sweeps(&kinds, &by_kind, &ground, progress)?;
        work += of_sweeps;
        let (computed_levels, computed_states) = rows(&by_kind);
        let curves = self.distributed(&kinds, by_kind);
        let (wanted_levels, wanted_states) = rows(&curves);
        work.shared_levels += wanted_levels - computed_levels;
        work.shared_states += wanted_states - computed_states;
        let Ground { psd, moments, scales, fit, .. } = ground;
        Ok(Results { psd, moments, scales, fit, curves, sweeps, work })
    }

    /// How many statistical states the plan takes, at most.
    pub fn statistical_states(&self) -> usize {
        let kinds = self.kinds();
        let of_kind = |(kind, cutoffs): (usize, &Cutoffs)| match (kinds.model(self, kind), cutoffs) {
            (CurveModel::Stacked(_), _) => 0,
            (CurveModel::Statistical { .. }, Cutoffs::Every) => {
                self.most_scales() * kinds.givens.firsts.len()
            }
            (CurveModel::Statistical { .. }, Cutoffs::Shortest) => kinds.givens.firsts.len(),
        };
        let over_cutoffs: usize = kinds.cutoffs.iter().enumerate().map(of_kind).sum();
        let asked = self.needs.sweeps.iter().flat_map(|sweep| {
            let place = (kinds.models.kinds[sweep.curve], sweep.cutoff_multiple.to_bits());
            sweep.pressures_pa.iter().map(move |pressure_pa| (place, pressure_pa.to_bits()))
        });
        over_cutoffs + Distinct::by(asked).firsts.len()
    }

    /// How many levels of stacks the plan takes, at most.
    pub fn stacked_levels(&self) -> usize {
        let kinds = self.kinds();
        let stacks = (0..kinds.cutoffs.len())
            .filter(|&kind| matches!(kinds.model(self, kind), CurveModel::Stacked(_)))
            .count();
        stacks * kinds.distinct_loads(self).count() * self.most_scales()
    }

    fn kinds(&self) -> Kinds {
        let curves = &self.needs.curves;
        let first_equal = |model| curves.iter().position(|other| other.model == model);
        let models = Distinct::by(curves.iter().map(|curve| first_equal(curve.model)));
        let wanted = |kind: usize| {
            let mut of_kind = curves.iter().zip(&models.kinds).filter(|(_, of_curve)| **of_curve == kind);
            let every = of_kind.any(|(curve, _)| curve.cutoffs == Cutoffs::Every);
            if every { Cutoffs::Every } else { Cutoffs::Shortest }
        };
        let cutoffs = (0..models.firsts.len()).map(wanted).collect();
        let givens = Distinct::by(self.givens().map(Given::key));
        Kinds { models, cutoffs, givens }
    }

    /// The loads, and the separations behind them.
    pub(super) fn givens(&self) -> impl Iterator<Item = Given> {
        let pressures = self.needs.loads.iter().map(|load| Given::Pressure(load.nominal_pressure_pa));
        pressures.chain(self.needs.separations_m.iter().map(|&separation_m| Given::Separation(separation_m)))
    }

    /// The curve of one kind, a block for each distinct load and separation.
    fn curve(
        &self,
        kind: usize,
        kinds: &Kinds,
        ground: &Ground,
        progress: &dyn Progress,
    ) -> Result<(CurveResult, Work), PlanError> {
        match *kinds.model(self, kind) {
            CurveModel::Stacked(model) => {
                let pressures_pa: Vec<f64> = kinds
                    .distinct_loads(self)
                    .map(|load| self.needs.loads[load].nominal_pressure_pa)
                    .collect();
                let (blocks, work) =
                    stack::blocks(&model, &pressures_pa, &ground.scales, kinds.cutoffs[kind]);
                Ok((CurveResult::Stacked(blocks), work))
            }
            CurveModel::Statistical { pair, law } => {
                let all: Vec<Given> = self.givens().collect();
                let givens: Vec<Given> = kinds.givens.firsts.iter().map(|&first| all[first]).collect();
                let statistical = Statistical { pair, law, tolerance: self.needs.tolerance, progress };
                let wanted = kinds.cutoffs[kind];
                let cutoffs = ground.cutoffs(wanted, 0..ground.cutoff_count(wanted));
                let (blocks, work) = statistical.over_cutoffs(&cutoffs, &givens)?;
                Ok((CurveResult::Statistical(blocks), work))
            }
        }
    }

    /// For every sweep its states. Sweeps of one model over one population share them, among each other and with the
    /// curves.
    fn sweeps(
        &self,
        kinds: &Kinds,
        by_kind: &[CurveResult],
        ground: &Ground,
        progress: &dyn Progress,
    ) -> Result<(Vec<Vec<ContactState>>, Work), PlanError> {
        let sweeps = &self.needs.sweeps;
        let asked = |(sweep, asperities): (&LoadSweep, &Option<AsperityParameters>)| {
            let population = asperities.as_ref().map(|asperities| population(asperities).map(f64::to_bits));
            (kinds.models.kinds[sweep.curve], population)
        };
        let groups = Distinct::by(sweeps.iter().zip(&ground.sweep_asperities).map(asked));
        let of_group = |&(group, first): &(usize, usize)| -> Result<_, PlanError> {
            let kind = kinds.models.kinds[sweeps[first].curve];
            let (CurveModel::Statistical { pair, law }, Some(asperities)) =
                (*kinds.model(self, kind), ground.sweep_asperities[first])
            else {
                return Ok((HashMap::new(), Work::default()));
            };
            let mut states = self.states_of_curve(&asperities, &kinds.givens, &by_kind[kind]);
            let members = sweeps.iter().zip(&groups.kinds).filter(|(_, of_sweep)| **of_sweep == group);
            let pressures_pa: Vec<f64> =
                members.flat_map(|(sweep, _)| sweep.pressures_pa.iter().copied()).collect();
            let distinct = Distinct::by(pressures_pa.iter().map(|pressure_pa| pressure_pa.to_bits()));
            let missing: Vec<f64> = distinct
                .firsts
                .iter()
                .map(|&first| pressures_pa[first])
                .filter(|pressure_pa| !states.contains_key(&pressure_pa.to_bits()))
                .collect();
            let statistical = Statistical { pair, law, tolerance: self.needs.tolerance, progress };
            let (found, mut work) = statistical.over_loads(&asperities, &missing)?;
            states.extend(missing.iter().map(|pressure_pa| pressure_pa.to_bits()).zip(found));
            work.shared_states += pressures_pa.len() - missing.len();
            Ok((states, work))
        };
        let numbered: Vec<(usize, usize)> = groups.firsts.iter().copied().enumerate().collect();
        let computed: Vec<(HashMap<u64, ContactState>, Work)> = parallel::try_map(&numbered, of_group)?;
        let mut work = Work::default();
        for (_, of_group) in &computed {
            work += *of_group;
        }
        let states = |(sweep, &group): (&LoadSweep, &usize)| {
            let states = &computed[group].0;
            sweep
                .pressures_pa
                .iter()
                .filter_map(|pressure_pa| states.get(&pressure_pa.to_bits()).copied())
                .collect()
        };
        Ok((sweeps.iter().zip(&groups.kinds).map(states).collect(), work))
    }

    /// The states that a curve has of a population, by the bits of their pressures.
    fn states_of_curve(
        &self,
        asperities: &AsperityParameters,
        givens: &Distinct,
        curve: &CurveResult,
    ) -> HashMap<u64, ContactState> {
        let CurveResult::Statistical(blocks) = curve else { return HashMap::new() };
        let of_population = |row: &CutoffState| {
            row.contact
                .filter(|(found, _)| population(found) == population(asperities))
                .map(|(_, state)| state)
        };
        let known = |(load, &block): (&Load, &usize)| {
            // The populations of sweeps are those of the shortest cutoffs, if of any.
            let state = blocks[block].iter().rev().find_map(of_population)?;
            Some((load.nominal_pressure_pa.to_bits(), state))
        };
        self.needs.loads.iter().zip(&givens.kinds).filter_map(known).collect()
    }

    /// The rows of each curve out of those of its kind.
    fn distributed(&self, kinds: &Kinds, by_kind: Vec<CurveResult>) -> Vec<CurveResult> {
        let mut by_kind: Vec<Option<CurveResult>> = by_kind.into_iter().map(Some).collect();
        let mut curves: Vec<CurveResult> = Vec::with_capacity(self.needs.curves.len());
        for (at, (curve, &kind)) in self.needs.curves.iter().zip(&kinds.models.kinds).enumerate() {
            let is_last = !kinds.models.kinds[at + 1..].contains(&kind);
            let rows = if is_last { by_kind[kind].take() } else { by_kind[kind].clone() };
            let Some(rows) = rows else { unreachable!("the rows of a kind leave with its last curve") };
            let blocks = &kinds.givens;
            let shortest_alone = curve.cutoffs == Cutoffs::Shortest;
            curves.push(match rows {
                CurveResult::Stacked(rows) => CurveResult::Stacked(of_blocks(
                    rows,
                    &blocks.kinds[..self.needs.loads.len()],
                    shortest_alone,
                )),
                CurveResult::Statistical(rows) => {
                    CurveResult::Statistical(of_blocks(rows, &blocks.kinds, shortest_alone))
                }
            });
        }
        curves
    }
}

/// What of a plan is the same.
struct Kinds {
    /// The models of its curves.
    models: Distinct,
    /// At which cutoffs each kind of model is wanted.
    cutoffs: Vec<Cutoffs>,
    /// Its loads, and its separations behind them.
    givens: Distinct,
}

impl Kinds {
    fn model<'p>(&self, plan: &'p Plan<'_>, kind: usize) -> &'p CurveModel {
        &plan.needs.curves[self.models.firsts[kind]].model
    }

    /// The distinct loads, by index.
    fn distinct_loads(&self, plan: &Plan<'_>) -> impl Iterator<Item = usize> {
        let loads = plan.needs.loads.len();
        self.givens.firsts.iter().copied().filter(move |&first| first < loads)
    }
}

/// The block of each kind, or its last row.
pub(super) fn of_blocks<T: Clone>(blocks: Vec<Vec<T>>, kinds: &[usize], last_row_alone: bool) -> Vec<Vec<T>> {
    let as_they_are = kinds.len() == blocks.len() && kinds.iter().enumerate().all(|(at, kind)| at == *kind);
    match (as_they_are, last_row_alone) {
        (true, false) => blocks,
        (_, false) => kinds.iter().map(|&kind| blocks[kind].clone()).collect(),
        (_, true) => kinds.iter().map(|&kind| blocks[kind].last().cloned().into_iter().collect()).collect(),
    }
}

/// How many levels and states there are.
fn rows(curves: &[CurveResult]) -> (usize, usize) {
    let levels = curves.iter().map(CurveResult::levels).sum();
    (levels, curves.iter().flat_map(CurveResult::states).count())
}
