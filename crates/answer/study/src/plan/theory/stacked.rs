//! Archard's stack under loads.

use std::ops::Range;

use stacked_contact::{FinalLevels, Level, Scale, StackedModel, levels_under_loads};
use stat_contact::Condition;
use tables::Table;

use super::{CurveResult, CurveTheory, Job, Rows, pressures_pa, with_loads};
use crate::plan::{Cutoffs, PlanError, PreparedSpectrum, Work};

/// Loads computed together share the load-independent work of each level. More than 8 gain nothing (measured).
const LOADS_PER_BLOCK: usize = 8;

impl CurveTheory for StackedModel {
    fn most_levels(&self, scales: usize) -> usize {
        scales
    }

    fn rows_per_block(&self, prepared: &PreparedSpectrum, _: Cutoffs) -> usize {
        prepared.scales.len()
    }

    fn blocks(
        &self,
        job: &Job<'_>,
        conditions: &[Condition],
        _: Range<usize>,
    ) -> Result<(CurveResult, Work), PlanError> {
        let (pressures_pa, scales, run) = (pressures_pa(conditions), &job.prepared.scales[..], job.run);
        let (blocks, stacked_levels) = match job.cutoffs {
            Cutoffs::Every => {
                let together: Vec<&[f64]> = pressures_pa.chunks(LOADS_PER_BLOCK).collect();
                let blocks = numerics::parallel::try_map(&together, |pressures_pa| {
                    run.go_on().map(|()| levels_together(self, pressures_pa, scales))
                })?;
                (blocks.into_iter().flatten().collect(), pressures_pa.len() * scales.len())
            }
            Cutoffs::Shortest => {
                let stack = FinalLevels::new(self, scales);
                let ends = numerics::parallel::try_map(&pressures_pa, |&pressure_pa| {
                    run.go_on().map(|()| stack.under(pressure_pa))
                })?;
                let visited = ends.iter().flatten().map(|end| end.visited).sum();
                (ends.iter().map(|end| end.iter().map(|end| end.level).collect()).collect(), visited)
            }
        };
        Ok((CurveResult::Stacked(blocks), Work { stacked_levels, ..Work::default() }))
    }
}

fn levels_together(model: &StackedModel, pressures_pa: &[f64], scales: &[Scale]) -> Vec<Vec<Level>> {
    let mut blocks = vec![Vec::with_capacity(scales.len()); pressures_pa.len()];
    for (at, level) in levels_under_loads(model, pressures_pa, scales.iter().copied()).enumerate() {
        blocks[at % pressures_pa.len()].push(level);
    }
    blocks
}

impl Rows for Vec<Vec<Level>> {
    fn count(&self) -> usize {
        self.len()
    }

    fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        self[block].iter().map(|level| (level.wavelength_m, level.area_fraction)).collect()
    }

    fn highest_real_pressure_pa(&self, block: usize) -> f64 {
        self[block].iter().map(|level| level.real_pressure_pa).fold(0.0, f64::max)
    }

    fn table(&self, pressures_pa: &[f64], several: bool, details: bool) -> Table {
        let column = |of: fn(&Level) -> f64| self.iter().flatten().map(of);
        let mut table = with_loads(self, pressures_pa, several)
            .with_numbers("wavelength_m", column(|level| level.wavelength_m))
            .with_numbers("amplitude_m", column(|level| level.amplitude_m))
            .with_numbers("area_fraction", column(|level| level.area_fraction))
            .with_numbers("real_pressure_pa", column(|level| level.real_pressure_pa))
            .with_words("regime", self.iter().flatten().map(|level| level.regime.name()));
        if details {
            // An infinite strength, of a scale above which nothing was deformed, is an empty cell like an unneeded one.
            let strength =
                |level: &Level| level.yield_strength_pa.filter(|strength_pa| strength_pa.is_finite());
            table = table
                .with_numbers("pressure_in_pa", column(|level| level.pressure_in_pa))
                .with_numbers("yield_strength_pa", self.iter().flatten().map(strength));
        }
        table
    }

    fn levels(&self) -> usize {
        self.iter().map(Vec::len).sum()
    }
}
