//! Stacks under loads.

use rayon::prelude::*;
use stacked_contact::{Level, Scale, StackedModel, levels};

use super::{Cutoffs, Work};

/// A block of levels for every nominal pressure \[Pa\].
pub(super) fn blocks(
    model: &StackedModel,
    pressures_pa: &[f64],
    scales: &[Scale],
    cutoffs: Cutoffs,
) -> (Vec<Vec<Level>>, Work) {
    let block = |&pressure_pa: &f64| -> Vec<Level> {
        let levels = levels(model, pressure_pa, scales.iter().copied());
        match cutoffs {
            Cutoffs::Every => levels.collect(),
            Cutoffs::Shortest => levels.last().into_iter().collect(),
        }
    };
    let work = Work { stacked_levels: pressures_pa.len() * scales.len(), ..Work::default() };
    (pressures_pa.par_iter().map(block).collect(), work)
}
