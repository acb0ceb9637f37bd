//! Curves part by part, so that neither their rows nor their loads need be held.

use numerics::parallel::{Progress, Unobserved};
use spectrum::ProfilePsd;
use stat_contact::Condition;

use super::condition::distinct;
use super::{Curve, CurveResult, Cutoffs, Plan, PlanError, PreparedSpectrum};

/// The approximate number of rows of a part: enough to keep every core busy, and few compared with a spectrum.
const PART: usize = 1 << 14;

/// The curves of a plan, to be computed part by part in the order of their rows.
pub struct Stream<'p> {
    plan: &'p Plan<'p>,
    /// The prepared spectrum that the curves use.
    pub prepared: PreparedSpectrum,
}

/// Some rows of a curve: whole blocks, or a piece of one.
pub struct Part {
    /// The nominal pressures \[Pa\] of the blocks; blocks at separations have no entry.
    pub pressures_pa: Vec<f64>,
    /// The rows.
    pub rows: CurveResult,
}

impl Plan<'_> {
    /// Prepares the curves. Errors of the plan are found here, before there are rows.
    ///
    /// # Errors
    /// Returns the errors of [`compute`](Plan::compute).
    pub fn stream(&self) -> Result<Stream<'_>, PlanError> {
        let prepared = self.prepare(self.run(&Unobserved))?;
        for curve in &self.needs.curves {
            curve.model.check(&prepared, curve.cutoffs)?;
        }
        Ok(Stream { plan: self, prepared })
    }
}

impl Stream<'_> {
    /// The spectrum as sampled.
    #[must_use]
    pub fn psd(&self) -> &ProfilePsd {
        &self.prepared.psd
    }

    /// Returns an upper bound of the number of rows of a curve.
    #[must_use]
    pub fn rows(&self, curve: &Curve) -> usize {
        let rows = curve.model.rows_per_block(&self.prepared, curve.cutoffs);
        rows * self.conditions(curve).count()
    }

    fn conditions(&self, curve: &Curve) -> impl Iterator<Item = Condition> {
        let takes_separations = curve.model.takes_separations();
        let conditions = self.plan.needs.conditions();
        conditions.filter(move |condition| takes_separations || condition.pressure_pa().is_some())
    }

    /// Computes a curve, and passes its parts on; a step of `progress` is a statistical state. Equal loads within a part are
    /// computed once.
    ///
    /// # Errors
    /// Returns the errors of `each`, and [`PlanError`].
    pub fn parts<E: From<PlanError>>(
        &self,
        curve: &Curve,
        progress: &dyn Progress,
        mut each: impl FnMut(Part) -> Result<(), E>,
    ) -> Result<(), E> {
        let (plan, prepared, cutoffs) = (self.plan, &self.prepared, curve.cutoffs);
        let rows = curve.model.rows_per_block(prepared, cutoffs);
        // Where a block has more rows than a part, and a part hence one condition, it comes in pieces if it can.
        let piece = if curve.model.statistical().is_some() { PART } else { rows.max(1) };
        in_parts(self.conditions(curve), rows, |conditions| {
            let distinct = distinct(conditions.iter().copied());
            let pressures_pa: Vec<f64> = conditions.iter().filter_map(|at| at.pressure_pa()).collect();
            for first in (0..rows.max(1)).step_by(piece) {
                let places = first..(first + piece).min(rows);
                let (blocks, _) =
                    plan.blocks(&curve.model, cutoffs, prepared, progress, &distinct.items, places)?;
                let rows = blocks.repeated(&distinct.index_of, Cutoffs::Every);
                each(Part { pressures_pa: pressures_pa.clone(), rows })?;
            }
            Ok(())
        })
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
