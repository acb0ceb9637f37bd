//! Moves of the ends of intervals when the draws have another seed.

use study::Unobserved;
use uncertainty::{AreaInterval, Settings, UncertaintyPlan};

use crate::cells::Cell;
use crate::error::StudyError;

/// The largest move that the default number of draws is meant to allow, as a share of ln(high/low).
pub const LARGEST_MOVE: f64 = 0.05;

/// Moves of both ends of all intervals, as shares of ln(high/low).
#[derive(Debug, Clone, PartialEq)]
pub struct Moves(Vec<f64>);

impl Moves {
    /// Runs the same studies of a cell with `seeds` seeds each, and compares each seed with the next.
    ///
    /// # Errors
    /// The error of the first study that fails.
    pub fn of_cell(
        cell: &Cell,
        studies: u32,
        seeds: u64,
        seed: u64,
        settings: &Settings,
    ) -> Result<Self, StudyError> {
        let mut moves = Vec::new();
        for study in 0..studies {
            let scene = cell.study(u64::from(study), seed)?.scene()?;
            let results = scene.plan().compute()?;
            let of_seed = |seed: u64| -> Result<Vec<AreaInterval>, StudyError> {
                let settings = Settings { seed, ..*settings };
                let plan = UncertaintyPlan::new(&scene, &results, &settings).ok_or(StudyError::Certain)?;
                Ok(plan.intervals(&Unobserved)?)
            };
            let found = (1..=seeds).map(of_seed).collect::<Result<Vec<_>, _>>()?;
            for pair in found.windows(2) {
                moves.extend(pair[0].iter().zip(&pair[1]).flat_map(|(one, other)| moves_of(one, other)));
            }
        }
        moves.sort_by(f64::total_cmp);
        Ok(Moves(moves))
    }

    /// Joins the moves of several cells.
    #[must_use]
    pub fn joined(all: &[Moves]) -> Self {
        let mut moves: Vec<f64> = all.iter().flat_map(|moves| moves.0.iter().copied()).collect();
        moves.sort_by(f64::total_cmp);
        Moves(moves)
    }

    /// Number of ends compared.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The move that a share of the ends does not exceed.
    #[must_use]
    pub fn quantile(&self, share: f64) -> f64 {
        self.0[((share * self.0.len() as f64) as usize).min(self.0.len() - 1)]
    }

    /// The share of ends that move by more than [`LARGEST_MOVE`].
    #[must_use]
    pub fn share_beyond(&self) -> f64 {
        self.0.iter().filter(|moved| **moved > LARGEST_MOVE).count() as f64 / self.0.len() as f64
    }
}

/// The moves of both ends; none of an interval without a length.
fn moves_of(one: &AreaInterval, other: &AreaInterval) -> Vec<f64> {
    let width = 0.5 * ((one.high / one.low).ln() + (other.high / other.low).ln());
    let moved = |from: f64, to: f64| (to / from).ln().abs() / width;
    if width > 1e-9 { vec![moved(one.low, other.low), moved(one.high, other.high)] } else { Vec::new() }
}
