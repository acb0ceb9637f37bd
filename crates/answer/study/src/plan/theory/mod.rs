//! Theories behind curves. Each module owns its rows: their computation, number, areas and table.

mod persson;
mod stacked;
pub(super) mod statistical;

use std::ops::Range;

use serde::Serialize;
use stacked_contact::Level;
use stat_contact::Condition;
use tables::Table;

pub use persson::PerssonCuts;
pub use persson::PerssonSurface;
pub use statistical::{CutoffState, STATE_DETAILS};

use super::gap::{GapChoices, GapError, LoadedSurface};
use super::run::Run;
use super::{Cutoffs, Plan, PlanError, PreparedSpectrum, Work};
use crate::models::{CurveModel, Theory};

/// A curve against cutoff: for every load its rows, from long to short wavelengths.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CurveResult {
    /// Levels of the stack; only the last one if only the shortest cutoff is needed.
    Stacked(Vec<Vec<Level>>),
    /// States of the population that each cutoff leaves; the separations follow the loads.
    Statistical(Vec<Vec<CutoffState>>),
    /// Cuts of Persson's theory.
    Persson(PerssonCuts),
}

/// Blocks of rows by one theory.
trait Rows {
    /// Returns the number of blocks.
    fn count(&self) -> usize;

    /// Returns a block as points of wavelength \[m\] and area fraction.
    fn area_fractions(&self, block: usize) -> Vec<(f64, f64)>;

    /// Returns the highest real pressure \[Pa\] in a block, or 0 for one without contact.
    fn highest_real_pressure_pa(&self, block: usize) -> f64;

    /// Returns the blocks as a table, with their nominal pressures \[Pa\] if they are `several`, and with `details` of how
    /// each row was found.
    fn table(&self, pressures_pa: &[f64], several: bool, details: bool) -> Table;

    /// Returns the number of levels of stacks.
    fn levels(&self) -> usize {
        0
    }

    /// Returns the number of statistical states.
    fn states(&self) -> usize {
        0
    }
}

impl CurveResult {
    fn rows(&self) -> &dyn Rows {
        match self {
            CurveResult::Stacked(blocks) => blocks,
            CurveResult::Statistical(blocks) => blocks,
            CurveResult::Persson(cuts) => cuts,
        }
    }

    /// Returns the levels of a stack, or nothing for another theory.
    #[must_use]
    pub fn stacked(&self) -> Option<&[Vec<Level>]> {
        match self {
            CurveResult::Stacked(blocks) => Some(blocks),
            _ => None,
        }
    }

    /// Returns the states of a statistical curve, or nothing for another theory.
    #[must_use]
    pub fn statistical(&self) -> Option<&[Vec<CutoffState>]> {
        match self {
            CurveResult::Statistical(blocks) => Some(blocks),
            _ => None,
        }
    }

    /// Returns the cuts of Persson's theory, or nothing for another theory.
    #[must_use]
    pub fn persson(&self) -> Option<&[Vec<::persson::Cut>]> {
        match self {
            CurveResult::Persson(cuts) => Some(&cuts.blocks),
            _ => None,
        }
    }

    /// Returns the number of blocks: one per load, and per separation.
    #[must_use]
    pub fn blocks(&self) -> usize {
        self.rows().count()
    }

    /// Returns a block as points of wavelength \[m\] and area fraction; cutoffs without asperities have none.
    ///
    /// # Panics
    /// Unless `block` is below [`blocks`](Self::blocks).
    #[must_use]
    pub fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        self.rows().area_fractions(block)
    }

    /// Returns the highest real pressure \[Pa\] in a block, or 0 for one without contact.
    ///
    /// # Panics
    /// Unless `block` is below [`blocks`](Self::blocks).
    #[must_use]
    pub fn highest_real_pressure_pa(&self, block: usize) -> f64 {
        self.rows().highest_real_pressure_pa(block)
    }

    /// Returns some blocks of a curve as a table, under these nominal pressures \[Pa\]. `several` is true if the whole
    /// curve has more loads than one; `details` appends how each row was found.
    #[must_use]
    pub fn table(&self, pressures_pa: &[f64], several: bool, details: bool) -> Table {
        self.rows().table(pressures_pa, several, details)
    }

    /// Returns the number of levels of stacks.
    pub(super) fn levels(&self) -> usize {
        self.rows().levels()
    }

    /// Returns the number of statistical states.
    pub(super) fn states(&self) -> usize {
        self.rows().states()
    }

    /// Returns for every condition the block at its index, or the last row of that block.
    pub(super) fn repeated(self, index_of: &[usize], cutoffs: Cutoffs) -> Self {
        match self {
            CurveResult::Stacked(blocks) => CurveResult::Stacked(repeated(blocks, index_of, cutoffs)),
            CurveResult::Statistical(blocks) => CurveResult::Statistical(repeated(blocks, index_of, cutoffs)),
            CurveResult::Persson(PerssonCuts { blocks, band }) => {
                CurveResult::Persson(PerssonCuts { blocks: repeated(blocks, index_of, cutoffs), band })
            }
        }
    }
}

fn repeated<T: Clone>(blocks: Vec<Vec<T>>, index_of: &[usize], cutoffs: Cutoffs) -> Vec<Vec<T>> {
    let no_repetitions = index_of.len() == blocks.len() && index_of.iter().copied().eq(0..blocks.len());
    match cutoffs {
        Cutoffs::Every if no_repetitions => blocks,
        Cutoffs::Every => index_of.iter().map(|&index| blocks[index].clone()).collect(),
        Cutoffs::Shortest => {
            index_of.iter().map(|&index| blocks[index].last().cloned().into_iter().collect()).collect()
        }
    }
}

/// A curve to be computed: the cutoffs of its model on a prepared spectrum.
pub(super) struct Job<'j> {
    pub plan: &'j Plan<'j>,
    pub prepared: &'j PreparedSpectrum,
    pub cutoffs: Cutoffs,
    pub run: Run<'j>,
}

/// The computation of curves by one theory.
pub(super) trait CurveTheory {
    /// Returns the most levels of a stack that a load takes over so many scales.
    fn most_levels(&self, _scales: usize) -> usize {
        0
    }

    /// Returns the most statistical states that a condition takes over so many cutoffs.
    fn most_states(&self, _cutoffs: usize) -> usize {
        0
    }

    /// Returns the most rows of a block.
    fn rows_per_block(&self, prepared: &PreparedSpectrum, cutoffs: Cutoffs) -> usize;

    /// Returns true if the rows of a block can be computed piece by piece.
    fn splits_blocks(&self) -> bool {
        false
    }

    /// Checks that every cutoff can be computed.
    ///
    /// # Errors
    /// [`PlanError`] for a spectrum that the theory cannot take.
    fn check(&self, _ground: &PreparedSpectrum, _cutoffs: Cutoffs) -> Result<(), PlanError> {
        Ok(())
    }

    /// Computes a block of rows for every condition, and counts the work. `places` are the needed rows of a block, for
    /// a theory that splits them.
    ///
    /// # Errors
    /// [`PlanError`] for values out of the theory's bounds, and if the work was cancelled.
    fn blocks(
        &self,
        job: &Job<'_>,
        conditions: &[Condition],
        places: Range<usize>,
    ) -> Result<(CurveResult, Work), PlanError>;

    /// Returns the surface with its whole spectrum, which a plan has prepared, or nothing for a theory without distances.
    ///
    /// # Errors
    /// [`GapError`] for a spectrum that has no gap.
    fn surface(
        &self,
        _plan: &Plan<'_>,
        _prepared: &PreparedSpectrum,
        _choices: &GapChoices,
    ) -> Result<Option<Box<dyn LoadedSurface>>, GapError> {
        Ok(None)
    }
}

impl Plan<'_> {
    /// Returns the surface of a model with its whole spectrum, or nothing for a theory without
    /// distances.
    pub(crate) fn surface(
        &self,
        model: &CurveModel,
        prepared: &PreparedSpectrum,
        choices: &GapChoices,
    ) -> Result<Option<Box<dyn LoadedSurface>>, GapError> {
        theory_of(model).surface(self, prepared, choices)
    }
}

/// Returns the theory behind a model.
pub(super) fn theory_of(model: &CurveModel) -> &dyn CurveTheory {
    match model.theory() {
        Theory::Stacked(model) => model,
        Theory::Statistical(model) => model,
        Theory::Persson(model) => model,
    }
}

/// Returns the nominal pressures \[Pa\] of conditions.
fn pressures_pa(conditions: &[Condition]) -> Vec<f64> {
    conditions.iter().filter_map(|condition| condition.pressure_pa()).collect()
}

/// Returns a table with the nominal pressure of each row, if there are several.
fn with_loads<T>(blocks: &[Vec<T>], pressures_pa: &[f64], several: bool) -> Table {
    let of_block = |(rows, &pressure_pa): (&Vec<T>, &f64)| std::iter::repeat_n(pressure_pa, rows.len());
    let table = Table::default();
    if !several {
        return table;
    }
    table.with_numbers("nominal_pressure_pa", blocks.iter().zip(pressures_pa).flat_map(of_block))
}
