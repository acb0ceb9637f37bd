//! Curves part by part, so that neither their rows nor their loads need be held.

use parallel::Progress;
use spectrum::ProfilePsd;

use super::asked::repeated;
use super::condition::{Condition, contact_of};
use super::distinct::Distinct;
use super::run::Run;
use super::states::Statistical;
use super::{
    Curve, CurveModel, CurveResult, Cutoffs, Ground, NominalPressure, Plan, PlanError, persson_cuts, stack,
};

/// The rows of a part, about: enough to keep every core busy, and few beside what a spectrum holds.
const PART: usize = 1 << 14;

/// The curves of a plan, to be computed part by part in the order of their rows.
pub struct Stream<'p> {
    plan: &'p Plan<'p>,
    ground: Ground,
}

/// Some rows of a curve: whole blocks, or a piece of one.
pub struct Part {
    /// The nominal pressures \[Pa\] of the blocks; those of separations have none.
    pub pressures_pa: Vec<f64>,
    /// The rows.
    pub rows: CurveResult,
}

impl Plan<'_> {
    /// Prepares the curves. What can be wrong with a plan is found out here, before there are rows.
    ///
    /// # Errors
    /// Those of [`compute`](Plan::compute).
    pub fn stream(&self) -> Result<Stream<'_>, PlanError> {
        let ground = self.ground()?;
        for curve in &self.needs.curves {
            let CurveModel::Statistical { pair, law } = curve.model else { continue };
            let cutoffs = ground.cutoffs(curve.cutoffs, 0..ground.cutoff_count(curve.cutoffs));
            for roughness in cutoffs.iter().filter_map(|cutoff| cutoff.roughness.as_ref()) {
                contact_of(&pair, &law, roughness)?;
            }
        }
        Ok(Stream { plan: self, ground })
    }
}

impl Stream<'_> {
    /// The spectrum as sampled.
    #[must_use]
    pub fn psd(&self) -> &ProfilePsd {
        &self.ground.psd
    }

    /// What the curves stand on.
    #[must_use]
    pub fn ground(&self) -> &Ground {
        &self.ground
    }

    /// How many rows a curve has, at most.
    #[must_use]
    pub fn rows(&self, curve: &Curve) -> usize {
        let needs = &self.plan.needs;
        match curve.model {
            CurveModel::Stacked(_) => self.ground.scales.len() * needs.load_count(),
            CurveModel::Persson { .. } => self.ground.psd.len() * needs.load_count(),
            CurveModel::Statistical { .. } => {
                self.ground.cutoff_count(curve.cutoffs) * needs.condition_count()
            }
        }
    }

    /// Computes a curve, and passes its parts on; a step of `progress` is a statistical state. Equal loads within a part are
    /// computed once.
    ///
    /// # Errors
    /// Those of `each`, and [`PlanError`].
    pub fn parts<E: From<PlanError>>(
        &self,
        curve: &Curve,
        progress: &dyn Progress,
        mut each: impl FnMut(Part) -> Result<(), E>,
    ) -> Result<(), E> {
        let run = Run::of(self.plan, progress);
        match &curve.model {
            CurveModel::Stacked(model) => {
                let scales = &self.ground.scales;
                let pressures = self.plan.needs.pressures().map(NominalPressure::pa);
                in_parts(pressures, scales.len(), |pressures_pa| {
                    let (blocks, _) = stack::blocks(model, &pressures_pa, scales, curve.cutoffs, run)?;
                    each(Part { pressures_pa, rows: CurveResult::Stacked(blocks) })
                })
            }
            CurveModel::Persson { pair, law } => {
                let pressures = self.plan.needs.pressures().map(NominalPressure::pa);
                in_parts(pressures, self.ground.psd.len(), |pressures_pa| {
                    let (plan, ground) = (self.plan, &self.ground);
                    let blocks =
                        persson_cuts::blocks(plan, pair, law, &pressures_pa, ground, curve.cutoffs, run)?;
                    each(Part { pressures_pa, rows: CurveResult::Persson(blocks) })
                })
            }
            &CurveModel::Statistical { pair, law } => {
                let model = Statistical { pair, law, run };
                let cutoffs = self.ground.cutoff_count(curve.cutoffs);
                in_parts(self.plan.needs.conditions(), cutoffs, |conditions| {
                    self.statistical_part(&model, curve.cutoffs, &conditions, &mut each)
                })
            }
        }
    }

    /// The rows under some conditions; where there are more cutoffs than a part has rows, and hence one condition, in pieces.
    fn statistical_part<E: From<PlanError>>(
        &self,
        model: &Statistical<'_>,
        wanted: Cutoffs,
        conditions: &[Condition],
        each: &mut impl FnMut(Part) -> Result<(), E>,
    ) -> Result<(), E> {
        let distinct = Distinct::of(conditions.iter().copied());
        let pressure = |condition: &Condition| match condition {
            Condition::Pressure(pressure_pa) => Some(pressure_pa.0),
            Condition::Separation(_) => None,
        };
        let pressures_pa: Vec<f64> = conditions.iter().filter_map(pressure).collect();
        let all = self.ground.cutoff_count(wanted);
        for first in (0..all).step_by(PART) {
            let cutoffs = self.ground.cutoffs(wanted, first..(first + PART).min(all));
            let (blocks, _) = model.over_cutoffs(&cutoffs, &distinct.items)?;
            let rows = CurveResult::Statistical(repeated(blocks, &distinct.index_of, Cutoffs::Every));
            each(Part { pressures_pa: pressures_pa.clone(), rows })?;
        }
        Ok(())
    }
}

/// Hands on as many blocks at a time as make a part of so many rows each, one block at least.
fn in_parts<T, E>(
    mut blocks: impl Iterator<Item = T>,
    rows: usize,
    mut each: impl FnMut(Vec<T>) -> Result<(), E>,
) -> Result<(), E> {
    let together = (PART / rows.max(1)).max(1);
    loop {
        let part: Vec<T> = blocks.by_ref().take(together).collect();
        if part.is_empty() {
            return Ok(());
        }
        each(part)?;
    }
}
