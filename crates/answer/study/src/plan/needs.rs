//! Requests for results from a spectrum.

use std::num::NonZeroU32;

use spectrum::{AmplitudeDefinition, Normalisation};

use super::{Cutoffs, Load, LoadRange, NominalPressure, Tolerance};
use crate::models::CurveModel;

/// The selection of scales of a spectrum.
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
    /// The cutoffs at which its area is needed.
    pub cutoffs: Cutoffs,
}

/// A curve against load, at some cutoff.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadSweep {
    /// Index of the curve.
    pub curve: usize,
    /// The cutoff, in multiples (at least 1) of the shortest wavelength that takes part.
    pub cutoff_multiple: f64,
    /// The nominal pressures > 0 \[Pa\].
    pub pressures_pa: Vec<f64>,
}

/// The results to be computed from a spectrum; none by default.
#[derive(Debug, Clone, Default)]
pub struct Needs {
    /// Spectral moments for every cutoff; statistical curves always need them.
    pub moments: Option<Normalisation>,
    /// McCool's asperity parameters from the moments at every cutoff. Statistical curves have them in any case if they
    /// need them.
    pub asperities: bool,
    /// Amplitudes; stacked curves always need them.
    pub amplitudes: Option<AmplitudeDefinition>,
    /// The self-affine fit, to the wavelengths \[m\] between these, the shorter first; 0 and infinity leave an end open.
    pub fit_band_m: Option<(f64, f64)>,
    /// Curves against cutoff, each under every load.
    pub curves: Vec<Curve>,
    /// The loads that have names.
    pub loads: Vec<Load>,
    /// The loads behind them, as ranges without names.
    pub load_ranges: Vec<LoadRange>,
    /// Separations \[m\], of either sign, for statistical curves, in addition to the loads.
    pub separations_m: Vec<f64>,
    /// Curves against load.
    pub sweeps: Vec<LoadSweep>,
    /// Relative tolerance of statistical states.
    pub tolerance: Tolerance,
    /// The largest number of cutoffs per decade at which a statistical curve is computed; every cutoff if absent.
    pub states_per_decade: Option<NonZeroU32>,
    /// True if curves are wanted for their areas alone: mean gap and stiffness of Persson's theory are left out.
    pub areas_alone: bool,
}

impl Needs {
    /// The pressures of all loads: of those with names, and of the ranges behind them.
    pub fn pressures(&self) -> impl Iterator<Item = NominalPressure> + Clone {
        let named = self.loads.iter().map(|load| load.nominal_pressure);
        named.chain(self.load_ranges.iter().flat_map(|range| range.pressures()))
    }

    /// Returns the number of loads.
    #[must_use]
    pub fn load_count(&self) -> usize {
        self.loads.len() + self.load_ranges.iter().map(|range| range.points()).sum::<usize>()
    }
}
