//! What is needed, computed once: every table, figure and reported number comes from one plan.
//!
//! Here is what can be asked for and what comes out. `ground` makes what curves stand on of the spectrum, `states` and
//! `stack` compute rows, and `compute` finds out which of the curves, loads and sweeps are the same, so that nothing is
//! computed twice.

mod compute;
mod distinct;
mod ground;
mod stack;
mod states;
mod stream;

pub use crate::models::CurveModel;
pub use ground::Ground;
pub use stream::{Part, Stream};

use std::num::NonZeroU32;
use std::ops::AddAssign;

use asperity::{AsperityError, Bound};
use serde::{Deserialize, Serialize};
use spectrum::{
    AmplitudeDefinition, AsperityParameters, FitError, Moments, Normalisation, ProfilePsd, SelfAffineFit,
};
use stacked_contact::{Level, Scale};
use stat_contact::ContactState;
use units::display::{length, three_digits};

/// More scales than any spectrum resolves, and what still fits into memory under a handful of loads.
const MOST_SCALES: usize = 2_000_000;

/// Which scales of the spectrum take part.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sampling {
    /// Resample to this many scales per decade; as sampled where absent.
    pub scales_per_decade: Option<NonZeroU32>,
    /// Keep the scales at or above this wavelength \[m\].
    pub cutoff_m: Option<f64>,
}

/// A model under a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The name of its table and of its entry in a legend.
    pub name: String,
    /// The model.
    pub model: CurveModel,
    /// Where its area is wanted.
    pub cutoffs: Cutoffs,
}

/// At which cutoffs a curve is wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cutoffs {
    /// At every wavelength.
    #[default]
    Every,
    /// At the shortest one: a statistical model skips the others, a stack yields its last level alone.
    Shortest,
}

/// A nominal pressure and how it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Nominal pressure > 0 \[Pa\].
    pub nominal_pressure_pa: f64,
    /// As typed, e.g. `1e-3 H`.
    pub label: String,
}

/// A statistical curve against load, at some cutoffs.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadSweep {
    /// Which of the curves, by index.
    pub curve: usize,
    /// The cutoff, in multiples (at least 1) of the shortest wavelength that takes part.
    pub cutoff_multiple: f64,
    /// The nominal pressures > 0 \[Pa\].
    pub pressures_pa: Vec<f64>,
}

/// What is to be computed of a spectrum. Nothing is by default.
#[derive(Debug, Clone, Default)]
pub struct Needs {
    /// Spectral moments for every cutoff; statistical curves always need them.
    pub moments: Option<Normalisation>,
    /// McCool's asperity parameters from the moments at every cutoff; statistical curves have them where they need them.
    pub asperities: bool,
    /// Amplitudes; stacked curves always need them.
    pub amplitudes: Option<AmplitudeDefinition>,
    /// The self-affine fit, to the wavelengths \[m\] between these, the shorter first; 0 and infinity leave an end open.
    pub fit_band_m: Option<(f64, f64)>,
    /// Curves against cutoff, each under every load.
    pub curves: Vec<Curve>,
    /// The loads.
    pub loads: Vec<Load>,
    /// Separations \[m\], of either sign, at which statistical curves are wanted besides the loads.
    pub separations_m: Vec<f64>,
    /// Statistical curves against load.
    pub sweeps: Vec<LoadSweep>,
    /// Relative tolerance of statistical states.
    pub tolerance: Tolerance,
}

/// The relative error allowed of a statistical state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance(f64);

impl Tolerance {
    const BOUND: Bound = Bound::LeftOpen { above: 0.0, at_most: 0.01 };

    /// A tolerance in (0, 0.01].
    ///
    /// # Errors
    /// [`AsperityError`] outside it.
    pub fn new(tolerance: f64) -> Result<Self, AsperityError> {
        Self::BOUND.check("tolerance", tolerance).map(Tolerance)
    }

    /// As a number, in (0, 0.01\].
    pub fn value(self) -> f64 {
        self.0
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Tolerance(1e-12)
    }
}

/// A spectrum, and what is to be computed of it.
pub struct Plan<'p> {
    /// The spectrum as read.
    pub psd: &'p ProfilePsd,
    /// Which of its scales take part.
    pub sampling: Sampling,
    /// What is to be computed.
    pub needs: Needs,
}

/// How much was computed: the proof that nothing else was. What is the same as something computed is not computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Work {
    /// Cutoffs for which moments were computed.
    pub moment_cutoffs: usize,
    /// Cutoffs for which asperity parameters were computed.
    pub asperity_cutoffs: usize,
    /// Scales whose amplitude was computed.
    pub amplitude_scales: usize,
    /// Levels of stacked curves.
    pub stacked_levels: usize,
    /// States of statistical curves.
    pub statistical_states: usize,
    /// Evaluations of the law of one asperity that these states took.
    pub law_evaluations: usize,
    /// Samples that took part in a fit.
    pub fitted_samples: usize,
    /// Levels that were wanted and found among those of an equal stack under an equal load.
    pub shared_levels: usize,
    /// States that were wanted and found among the others: of an equal model and population, at an equal load.
    pub shared_states: usize,
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        let Work {
            moment_cutoffs,
            asperity_cutoffs,
            amplitude_scales,
            stacked_levels,
            statistical_states,
            law_evaluations,
            fitted_samples,
            shared_levels,
            shared_states,
        } = other;
        self.moment_cutoffs += moment_cutoffs;
        self.asperity_cutoffs += asperity_cutoffs;
        self.amplitude_scales += amplitude_scales;
        self.stacked_levels += stacked_levels;
        self.statistical_states += statistical_states;
        self.law_evaluations += law_evaluations;
        self.fitted_samples += fitted_samples;
        self.shared_levels += shared_levels;
        self.shared_states += shared_states;
    }
}

/// What a plan yields; what was not needed is empty.
#[derive(Debug, Clone)]
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
    /// For every sweep, a state per pressure; none where the cutoff leaves no asperities.
    pub sweeps: Vec<Vec<ContactState>>,
    /// How much was computed.
    pub work: Work,
}

/// A curve against cutoff: for every load its rows, from long to short wavelengths.
#[derive(Debug, Clone)]
pub enum CurveResult {
    /// Levels of the stack; the last alone where only the shortest cutoff is wanted.
    Stacked(Vec<Vec<Level>>),
    /// States of the population that each cutoff leaves; the separations follow the loads.
    Statistical(Vec<Vec<CutoffState>>),
}

/// The contact of the asperities that a spectrum has up to a cutoff.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutoffState {
    /// The cutoff \[m\].
    pub wavelength_m: f64,
    /// The asperities and their contact; none at the longest wavelength, where there are no moments yet.
    pub contact: Option<(AsperityParameters, ContactState)>,
}

/// Why a plan cannot be carried out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// The cutoff leaves nothing.
    #[error(
        "the cutoff {} leaves no scale: the longest wavelength is {}; choose a shorter one",
        length(*.cutoff_m), length(*.longest_m)
    )]
    NothingLeft {
        /// The cutoff.
        cutoff_m: f64,
        /// The longest wavelength.
        longest_m: f64,
    },
    /// The resampled spectrum would be too large.
    #[error(
        "{scales_per_decade} scales per decade make {} scales; at most {MOST_SCALES} are computed, choose fewer",
        three_digits(*.scales)
    )]
    TooManyScales {
        /// The density asked for.
        scales_per_decade: NonZeroU32,
        /// The scales it makes.
        scales: f64,
    },
    /// Whoever watches the plan has ended it.
    #[error("ended before all was computed")]
    Cancelled,
    /// The fit has too little to go by.
    #[error(transparent)]
    Fit(#[from] FitError),
    /// A value that no model takes.
    #[error(transparent)]
    Value(#[from] AsperityError),
}

impl CurveResult {
    /// Number of blocks: one per load, and per separation.
    pub fn blocks(&self) -> usize {
        match self {
            CurveResult::Stacked(blocks) => blocks.len(),
            CurveResult::Statistical(blocks) => blocks.len(),
        }
    }

    /// A block as points of wavelength \[m\] and area fraction; cutoffs without asperities have none.
    ///
    /// # Panics
    /// Unless `block` is below [`blocks`](Self::blocks).
    pub fn area_fractions(&self, block: usize) -> Vec<(f64, f64)> {
        match self {
            CurveResult::Stacked(blocks) => {
                blocks[block].iter().map(|level| (level.wavelength_m, level.area_fraction)).collect()
            }
            CurveResult::Statistical(blocks) => blocks[block]
                .iter()
                .filter_map(|row| row.contact.map(|(_, state)| (row.wavelength_m, state.area_fraction)))
                .collect(),
        }
    }

    /// Levels of a stacked curve.
    fn levels(&self) -> usize {
        match self {
            CurveResult::Stacked(blocks) => blocks.iter().map(Vec::len).sum(),
            CurveResult::Statistical(_) => 0,
        }
    }

    /// States of a statistical curve.
    fn states(&self) -> impl Iterator<Item = &ContactState> {
        let blocks = match self {
            CurveResult::Stacked(_) => &[][..],
            CurveResult::Statistical(blocks) => blocks,
        };
        blocks.iter().flatten().filter_map(|row| row.contact.as_ref().map(|(_, state)| state))
    }
}

/// Scales per decade of a spectrum, on average; absent for a single scale.
pub fn scales_per_decade(psd: &ProfilePsd) -> Option<f64> {
    let decades = (psd.longest_wavelength_m() / psd.shortest_wavelength_m()).log10();
    (decades > 0.0).then(|| (psd.len() - 1) as f64 / decades)
}
