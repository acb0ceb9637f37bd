//! The basis of curves: the scales of the spectrum that take part, their moments and asperities, their amplitudes.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{AsperityParameters, Moments, ProfilePsd, SelfAffineFit};
use stacked_contact::Scale;

use super::work::Work;

/// Everything that a plan computes from a spectrum before the curves. A plan with the same spectrum, sampling,
/// normalisation and amplitude can reuse it.
#[derive(Debug, Clone)]
pub struct PreparedSpectrum {
    /// The spectrum as sampled.
    pub psd: ProfilePsd,
    /// Moments, and asperity parameters where needed, from the second wavelength on.
    pub moments: Vec<(Moments, Option<AsperityParameters>)>,
    /// Amplitudes, from long to short wavelengths.
    pub scales: Vec<Scale>,
    pub(crate) fit: Option<SelfAffineFit>,
    /// The cutoff of each sweep.
    pub(crate) sweep_cutoffs: Vec<Cutoff>,
    pub(crate) work: Work,
    /// The result of [`PreparedSpectrum::gradients_of_surface`], computed once for all copies.
    pub(crate) gradients: Arc<OnceLock<Vec<f64>>>,
}

impl PreparedSpectrum {
    /// The mean square gradient of the waves of the surface down to each wavelength, computed at the first call.
    pub(crate) fn gradients_of_surface(&self) -> &[f64] {
        let wavelengths_m = self.psd.wavelengths_m();
        let gradients = |surface: AreaSpectrum| surface.mean_square_gradients(wavelengths_m);
        // A single sample has no waves.
        let compute = || {
            AreaSpectrum::from_profile(&self.psd).map_or_else(|_| vec![0.0; wavelengths_m.len()], gradients)
        };
        self.gradients.get_or_init(compute)
    }
}

/// The cutoffs at which a curve is needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cutoffs {
    /// At every wavelength.
    #[default]
    Every,
    /// At the shortest one: a statistical model skips the others, a stack yields its last level alone.
    Shortest,
}

/// A cutoff, and the roughness that it leaves; none at the longest wavelength.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cutoff {
    pub wavelength_m: f64,
    pub roughness: Option<Roughness>,
}

/// Moments, and the asperities that they make.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Roughness {
    pub moments: Moments,
    pub asperities: AsperityParameters,
}

impl Roughness {
    pub(super) fn of((moments, asperities): &(Moments, Option<AsperityParameters>)) -> Option<Self> {
        asperities.map(|asperities| Roughness { moments: *moments, asperities })
    }
}

impl PreparedSpectrum {
    /// Returns the number of cutoffs at which a statistical curve is needed.
    pub(crate) fn cutoff_count(&self, wanted: Cutoffs) -> usize {
        match wanted {
            Cutoffs::Every => self.moments.len() + 1,
            Cutoffs::Shortest => 1,
        }
    }

    /// Some of these cutoffs, counted from long to short wavelengths.
    pub(crate) fn cutoffs(&self, wanted: Cutoffs, places: Range<usize>) -> Vec<Cutoff> {
        let cutoff = |place: usize| match place.checked_sub(1).map(|at| &self.moments[at]) {
            None => Cutoff { wavelength_m: self.psd.longest_wavelength_m(), roughness: None },
            Some(row) => Cutoff { wavelength_m: row.0.wavelength_m, roughness: Roughness::of(row) },
        };
        match wanted {
            Cutoffs::Every => places.map(cutoff).collect(),
            Cutoffs::Shortest => places.map(|_| cutoff(self.moments.len())).collect(),
        }
    }
}
