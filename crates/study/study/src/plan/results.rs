//! What a plan yields.

use persson::Cut;
use serde::Serialize;
use spectrum::{AsperityParameters, Moments, ProfilePsd, SelfAffineFit};
use stacked_contact::{Level, Scale};
use stat_contact::ContactState;

use super::Work;

/// What a plan yields; what was not needed is empty.
#[derive(Debug, Clone, Serialize)]
pub struct Results {
    /// The spectrum as sampled for the plan.
    pub psd: ProfilePsd,
    /// Moments, and asperity parameters where needed, from the second wavelength on.
    pub moments: Vec<(Moments, Option<AsperityParameters>)>,
    /// Amplitudes, from long to short wavelengths.
    pub scales: Vec<Scale>,
    /// The fit.
    pub fit: Option<SelfAffineFit>,
    /// The curves against cutoff.
    pub curves: Vec<CurveResult>,
    /// For every sweep, its cutoff and states.
    pub sweeps: Vec<SweepResult>,
    /// How much was computed.
    pub work: Work,
}

/// A curve against cutoff: for every load its rows, from long to short wavelengths.
#[derive(Debug, Clone, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CurveResult {
    /// Levels of the stack; the last alone where only the shortest cutoff is wanted.
    Stacked(Vec<Vec<Level>>),
    /// States of the population that each cutoff leaves; the separations follow the loads.
    Statistical(Vec<Vec<CutoffState>>),
    /// Cuts of Persson's theory.
    Persson(Vec<Vec<Cut>>),
}

/// The contact of the asperities that a spectrum has up to a cutoff.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CutoffState {
    /// The cutoff \[m\].
    pub wavelength_m: f64,
    /// The asperities and their contact; none at the longest wavelength, where there are no moments yet.
    pub contact: Option<(AsperityParameters, ContactState)>,
    /// Alpha of a spectrum narrower than that of any surface, where a model needs the summits of one: no contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub too_narrow_alpha: Option<f64>,
}

/// A curve against load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepResult {
    /// The cutoff \[m\] of the spectrum whose states these are.
    pub cutoff_m: f64,
    /// A state per pressure; none where the cutoff leaves no asperities.
    pub states: Vec<ContactState>,
}

impl CurveResult {
    /// Number of blocks: one per load, and per separation.
    #[must_use]
    pub fn blocks(&self) -> usize {
        match self {
            CurveResult::Stacked(blocks) => blocks.len(),
            CurveResult::Statistical(blocks) => blocks.len(),
            CurveResult::Persson(blocks) => blocks.len(),
        }
    }

    /// A block as points of wavelength \[m\] and area fraction; cutoffs without asperities have none.
    ///
    /// # Panics
    /// Unless `block` is below [`blocks`](Self::blocks).
    #[must_use]
    pub fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        match self {
            CurveResult::Stacked(blocks) => {
                blocks[block].iter().map(|level| (level.wavelength_m, level.area_fraction)).collect()
            }
            CurveResult::Statistical(blocks) => blocks[block]
                .iter()
                .filter_map(|row| row.contact.map(|(_, state)| (row.wavelength_m, state.area_fraction)))
                .collect(),
            CurveResult::Persson(blocks) => {
                blocks[block].iter().map(|cut| (cut.wavelength_m, cut.areas.contact())).collect()
            }
        }
    }

    /// How many levels a stacked curve has.
    pub(super) fn levels(&self) -> usize {
        match self {
            CurveResult::Stacked(blocks) => blocks.iter().map(Vec::len).sum(),
            CurveResult::Statistical(_) | CurveResult::Persson(_) => 0,
        }
    }

    /// How many states a statistical curve has.
    pub(super) fn states(&self) -> usize {
        match self {
            CurveResult::Stacked(_) | CurveResult::Persson(_) => 0,
            CurveResult::Statistical(blocks) => {
                blocks.iter().flatten().filter(|row| row.contact.is_some()).count()
            }
        }
    }
}
