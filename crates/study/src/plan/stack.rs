//! Stacks under loads.

use stacked_contact::{FinalLevels, Level, Scale, StackedModel, levels_under_loads};

use super::{Cutoffs, Work};

/// Loads that go down a stack together share what does not depend on them; more of them share no more.
const TOGETHER: usize = 8;

/// A block of levels for every nominal pressure \[Pa\].
pub(super) fn blocks(
    model: &StackedModel,
    pressures_pa: &[f64],
    scales: &[Scale],
    cutoffs: Cutoffs,
) -> (Vec<Vec<Level>>, Work) {
    let (blocks, stacked_levels) = match cutoffs {
        Cutoffs::Every => {
            let together: Vec<&[f64]> = pressures_pa.chunks(TOGETHER).collect();
            let blocks =
                parallel::map(&together, |pressures_pa| blocks_together(model, pressures_pa, scales));
            (blocks.into_iter().flatten().collect(), pressures_pa.len() * scales.len())
        }
        Cutoffs::Shortest => {
            let stack = FinalLevels::new(model, scales);
            let ends = parallel::map(pressures_pa, |&pressure_pa| stack.under(pressure_pa));
            let visited = ends.iter().flatten().map(|end| end.visited).sum();
            (ends.iter().map(|end| end.iter().map(|end| end.level).collect()).collect(), visited)
        }
    };
    (blocks, Work { stacked_levels, ..Work::default() })
}

fn blocks_together(model: &StackedModel, pressures_pa: &[f64], scales: &[Scale]) -> Vec<Vec<Level>> {
    let mut blocks = vec![Vec::with_capacity(scales.len()); pressures_pa.len()];
    for (at, level) in levels_under_loads(model, pressures_pa, scales.iter().copied()).enumerate() {
        blocks[at % pressures_pa.len()].push(level);
    }
    blocks
}
