//! Settings of the judgement by boundary elements: typed values, checked against their bounds.

use units::Bound;

use super::error::SceneError;
use super::raw::RawJudge;
use super::values::{number, whole_number};

/// Points per side of a judge's surface: below, no scale has room beside another; above, one does not fit in memory with its
/// transforms.
const GRID: Bound = Bound::Within { at_least: 32.0, at_most: 8192.0 };

/// The number of surfaces that the judge may press. One surface has no scatter; the standard error of 10,000 is far
/// below the error of their grid.
const REALISATIONS: Bound = Bound::Within { at_least: 2.0, at_most: 10_000.0 };

/// Settings of the judge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JudgeSettings {
    /// Points per side of a surface, from 32 to 8192; the most that the budget allows if absent.
    pub grid: Option<usize>,
    /// Surfaces in each window, from 2 to 10,000; chosen within the budget if absent.
    pub realisations: Option<usize>,
    /// Seed of the random phases of the surfaces.
    pub seed: u64,
    /// Total cost: operator applications of the solver times grid points of a surface, > 0.
    pub budget: f64,
    /// True if the scene turns the judgement off.
    pub off: bool,
}

impl Default for JudgeSettings {
    /// Returns the settings with a budget of one to two seconds on two processors.
    fn default() -> Self {
        JudgeSettings { grid: None, realisations: None, seed: 1, budget: 6e7, off: false }
    }
}

pub(super) fn resolve_judge(raw: &RawJudge) -> Result<JudgeSettings, SceneError> {
    let grid = whole_number("judge.grid", "the number of points per side", &raw.grid, GRID)?;
    let realisations =
        whole_number("judge.realisations", "the number of surfaces", &raw.realisations, REALISATIONS)?;
    let seed = whole_number("judge.seed", "the seed", &raw.seed, Bound::AtLeast(0.0))?;
    let operators = "the number of operators times points";
    let budget = raw.budget.as_ref();
    let budget = budget.map(|budget| number("judge.budget", operators, budget, Bound::Positive));
    let usual = JudgeSettings::default();
    Ok(JudgeSettings {
        grid: grid.map(|points| points as usize),
        realisations: realisations.map(|surfaces| surfaces as usize),
        seed: seed.unwrap_or(usual.seed),
        budget: budget.transpose()?.unwrap_or(usual.budget),
        off: raw.off,
    })
}
