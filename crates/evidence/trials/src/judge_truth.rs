//! Truth of the judge's trials: areas of whole bands, solved at once on boxes that hold several of the longest waves.

use elements::half_space::Loading;
use elements::{RandomChoices, Relief, Surfaces};
use numerics::parallel::{Unobserved, map_indices};
use serde::{Deserialize, Serialize};
use spectrum::random_surfaces::{AreaSpectrum, Phases};

use crate::TrialError;
use crate::elements::digits;
use crate::judge_spectra::{CONTACT_MODULUS_PA, JudgeTrial, Kind, LOADS, RMS_GRADIENT, SHORTEST_M, Set};
use crate::statistics::Mean;

/// Relative standard error to which the truth is known; surfaces are added until it is.
pub(crate) const TRUTH_ERROR: f64 = 0.02;
/// Side of the box over the longest wavelength. In a box of two the load rests on a handful of summits, which touch more than
/// those of an infinite surface do.
const LENGTHS_IN_BOX: f64 = 4.0;
/// Surfaces that are pressed before the error is looked at again.
const BATCH: usize = 4;
/// The most batches of surfaces.
const MAX_BATCHES: u64 = 75;
/// The seed of the first batch. The judge's own seed is another.
const TRUTH_SEED: u64 = 3000;
/// Residual to which surfaces are pressed.
pub(crate) const TOLERANCE: f64 = 1e-4;

/// Area of a whole band solved at once.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct TruthRow {
    /// Set of the trial.
    pub set: Set,
    /// Form of its spectrum.
    pub kind: Kind,
    /// Number of the trial.
    pub number: u32,
    /// Nayak's alpha.
    pub alpha: f64,
    /// Load p/(E* h').
    pub pressure_over_gradient: f64,
    /// Mean area fraction.
    pub area_fraction: f64,
    /// Its relative standard error, from the scatter of the surfaces.
    pub relative_error: f64,
    /// Number of surfaces.
    pub surfaces: usize,
}

impl JudgeTrial {
    /// Presses surfaces with the whole band until the area under every load is known.
    ///
    /// # Errors
    /// The error of making or pressing a surface.
    pub fn truth(&self) -> Result<Vec<TruthRow>, TrialError> {
        let psd = self.scene(false)?.plan().compute()?.psd;
        let spectrum = AreaSpectrum::from_profile(&psd)?;
        let moments = spectrum.moments();
        let alpha = moments.m0_m2 * moments.m4_per_m2 / (moments.m2 * moments.m2);
        let row = |&pressure_over_gradient: &f64| {
            let loading = Loading {
                contact_modulus_pa: CONTACT_MODULUS_PA,
                nominal_pressure_pa: pressure_over_gradient * CONTACT_MODULUS_PA * RMS_GRADIENT,
                saturation_pa: None,
                tolerance: TOLERANCE,
            };
            let (area, surfaces) = self.known_area(&spectrum, LENGTHS_IN_BOX, MAX_BATCHES, |relief| {
                Ok(relief.press(&loading, &Unobserved)?.numbers.area_fraction_corrected)
            })?;
            Ok(TruthRow {
                set: self.set,
                kind: self.kind,
                number: self.number,
                alpha: digits(alpha),
                pressure_over_gradient,
                area_fraction: digits(area.value),
                relative_error: digits(area.standard_error / area.value),
                surfaces,
            })
        };
        LOADS.iter().map(row).collect()
    }

    /// Mean of the areas of surfaces in boxes of some longest waves a side, as `area` presses each, and the number of surfaces
    /// that it took.
    pub(crate) fn known_area(
        &self,
        spectrum: &AreaSpectrum,
        lengths_in_box: f64,
        most_batches: u64,
        area: impl Fn(&Relief) -> Result<f64, TrialError> + Sync,
    ) -> Result<(Mean, usize), TrialError> {
        let mut areas: Vec<f64> = Vec::new();
        for seed in TRUTH_SEED..TRUTH_SEED + most_batches {
            let surfaces = self.surfaces(spectrum, lengths_in_box, BATCH, seed)?;
            let area = |number: usize| area(&*surfaces.relief(number)?);
            let batch: Result<Vec<f64>, TrialError> = map_indices(BATCH, area).into_iter().collect();
            areas.extend(batch?);
            let mean = Mean::new(areas.iter().copied());
            if mean.standard_error <= TRUTH_ERROR * mean.value {
                break;
            }
        }
        Ok((Mean::new(areas.iter().copied()), areas.len()))
    }

    /// Surfaces with the whole band, in boxes that hold `lengths_in_box` of the longest waves along a side.
    pub(crate) fn surfaces(
        &self,
        spectrum: &AreaSpectrum,
        lengths_in_box: f64,
        realisations: usize,
        seed: u64,
    ) -> Result<Surfaces, TrialError> {
        let longest_m = self.width() * SHORTEST_M;
        let choices = RandomChoices {
            points: (self.points_per_shortest() * lengths_in_box * self.width()) as usize,
            realisations,
            seed,
            longest_m: Some(longest_m),
            shortest_m: Some(SHORTEST_M),
            side_m: Some(lengths_in_box * longest_m),
            phases: Phases::FixedModulus,
        };
        Ok(Surfaces::Random(choices.surfaces(spectrum)?.0))
    }
}
