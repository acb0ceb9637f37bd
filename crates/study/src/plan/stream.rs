//! Curves part by part, so that they need not be held.

use parallel::Progress;
use spectrum::ProfilePsd;
use stat_contact::Population;

use super::compute::of_blocks;
use super::distinct::Distinct;
use super::states::{Given, Statistical, population};
use super::{Curve, CurveModel, CurveResult, Ground, Plan, PlanError, stack};

/// The rows of a part, about: enough to keep every core busy, and few beside what a spectrum holds.
const PART: usize = 1 << 14;

/// The curves of a plan, to be computed part by part in the order of their rows.
pub struct Stream<'p> {
    plan: &'p Plan<'p>,
    ground: Ground,
}

/// Some rows of a curve.
pub struct Part {
    /// The load that the first block belongs to, by index; the separations follow the loads.
    pub first_block: usize,
    /// Whole blocks, or a piece of one.
    pub rows: CurveResult,
}

impl Plan<'_> {
    /// Prepares the curves. What can be wrong with a plan is found out here, before there are rows.
    ///
    /// # Errors
    /// Those of [`compute`](Plan::compute).
    pub fn stream(&self) -> Result<Stream<'_>, PlanError> {
        let ground = self.ground()?;
        for (_, asperities) in &ground.moments {
            let Some([radius_m, density_per_m2, sigma_s_m]) = asperities.as_ref().map(population) else {
                continue;
            };
            Population::new(radius_m, density_per_m2, sigma_s_m)?;
        }
        Ok(Stream { plan: self, ground })
    }
}

impl Stream<'_> {
    /// The spectrum as sampled.
    pub fn psd(&self) -> &ProfilePsd {
        &self.ground.psd
    }

    /// How many rows a curve has, at most.
    pub fn rows(&self, curve: &Curve) -> usize {
        match curve.model {
            CurveModel::Stacked(_) => self.ground.scales.len() * self.plan.needs.loads.len(),
            CurveModel::Statistical { .. } => {
                self.ground.cutoff_count(curve.cutoffs) * self.plan.givens().count()
            }
        }
    }

    /// Computes a curve, and passes its parts on; a step of `progress` is a
    /// statistical state.
    /// Equal loads within a part are computed once.
    ///
    /// # Errors
    /// Those of `each`, and [`PlanError`].
    pub fn parts<E: From<PlanError>>(
        &self,
        curve: &Curve,
        progress: &dyn Progress,
        mut each: impl FnMut(Part) -> Result<(), E>,
    ) -> Result<(), E> {
        match curve.model {
            CurveModel::Stacked(model) => {
                let pressures_pa: Vec<f64> =
                    self.plan.needs.loads.iter().map(|load| load.nominal_pressure_pa).collect();
                let scales = &self.ground.scales;
                for (at, pressures_pa) in in_parts(&pressures_pa, scales.len()) {
                    let (blocks, _) = stack::blocks(&model, pressures_pa, scales, curve.cutoffs);
                    each(Part { first_block: at, rows: CurveResult::Stacked(blocks) })?;
                }
            }
            CurveModel::Statistical { pair, law } => {
                let statistical = Statistical { pair, law, tolerance: self.plan.needs.tolerance, progress };
                let cutoffs = self.ground.cutoff_count(curve.cutoffs);
                let givens: Vec<Given> = self.plan.givens().collect();
                for (at, givens) in in_parts(&givens, cutoffs) {
                    let distinct = Distinct::by(givens.iter().map(|given| given.key()));
                    let differing: Vec<Given> = distinct.firsts.iter().map(|&first| givens[first]).collect();
                    // Where there are more cutoffs than a part has rows, one block is given at a time.
                    for first in (0..cutoffs).step_by(PART) {
                        let places = first..(first + PART).min(cutoffs);
                        let cutoffs = self.ground.cutoffs(curve.cutoffs, places);
                        let (blocks, _) = statistical.over_cutoffs(&cutoffs, &differing)?;
                        let rows = CurveResult::Statistical(of_blocks(blocks, &distinct.kinds, false));
                        each(Part { first_block: at, rows })?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// As many blocks of so many rows as make a part, one at least, and the place of the first.
fn in_parts<T>(blocks: &[T], rows: usize) -> impl Iterator<Item = (usize, &[T])> {
    let together = (PART / rows.max(1)).max(1);
    blocks.chunks(together).enumerate().map(move |(at, blocks)| (at * together, blocks))
}
