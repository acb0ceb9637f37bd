//! Results of a plan.

use std::sync::{Arc, OnceLock};

use serde::Serialize;
use spectrum::{AsperityParameters, Moments, ProfilePsd, SelfAffineFit};
use stacked_contact::Scale;
use stat_contact::ContactState;

use super::{CurveResult, PreparedSpectrum, Work};

/// Results of a plan; those that were not needed are empty.
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
    /// Counters of the work done.
    pub work: Work,
    /// The mean square gradients of the waves of the surface, as the prepared spectrum has them.
    #[serde(skip)]
    pub(crate) gradients: Arc<OnceLock<Vec<f64>>>,
}

/// A curve against load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepResult {
    /// The cutoff \[m\] of the spectrum whose states these are.
    pub cutoff_m: f64,
    /// An area per pressure; none where the cutoff leaves no asperities of a statistical curve.
    pub area_fractions: Vec<f64>,
    /// The states behind them, of a statistical curve.
    pub states: Vec<ContactState>,
}

impl PreparedSpectrum {
    /// Returns the spectrum that a plan has prepared, for plans of it without sweeps and fits.
    #[must_use]
    pub fn from_results(results: &Results) -> Self {
        PreparedSpectrum {
            psd: results.psd.clone(),
            moments: results.moments.clone(),
            scales: results.scales.clone(),
            fit: None,
            sweep_cutoffs: Vec::new(),
            work: Work::default(),
            gradients: Arc::clone(&results.gradients),
        }
    }
}
