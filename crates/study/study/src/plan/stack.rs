//! Stacks under loads.

use stacked_contact::{FinalLevels, Level, Scale, StackedModel, levels_under_loads};

use super::run::Run;
use super::{Cutoffs, PlanError, Work};

/// Loads that go down a stack together share what does not depend on them; more of them share no more.
const TOGETHER: usize = 8;

/// A block of levels for every nominal pressure \[Pa\].
pub(super) fn blocks(
    model: &StackedModel,
    pressures_pa: &[f64],
    scales: &[Scale],
    cutoffs: Cutoffs,
    run: Run<'_>,
) -> Result<(Vec<Vec<Level>>, Work), PlanError> {
    let (blocks, stacked_levels) = match cutoffs {
        Cutoffs::Every => {
            let together: Vec<&[f64]> = pressures_pa.chunks(TOGETHER).collect();
            let blocks = parallel::try_map(&together, |pressures_pa| {
                run.go_on().map(|()| blocks_together(model, pressures_pa, scales))
            })?;
            (blocks.into_iter().flatten().collect(), pressures_pa.len() * scales.len())
        }
        Cutoffs::Shortest => {
            let stack = FinalLevels::new(model, scales);
            let ends = parallel::try_map(pressures_pa, |&pressure_pa| {
                run.go_on().map(|()| stack.under(pressure_pa))
            })?;
            let visited = ends.iter().flatten().map(|end| end.visited).sum();
            (ends.iter().map(|end| end.iter().map(|end| end.level).collect()).collect(), visited)
        }
    };
    Ok((blocks, Work { stacked_levels, ..Work::default() }))
}

fn blocks_together(model: &StackedModel, pressures_pa: &[f64], scales: &[Scale]) -> Vec<Vec<Level>> {
    let mut blocks = vec![Vec::with_capacity(scales.len()); pressures_pa.len()];
    for (at, level) in levels_under_loads(model, pressures_pa, scales.iter().copied()).enumerate() {
        blocks[at % pressures_pa.len()].push(level);
    }
    blocks
}
